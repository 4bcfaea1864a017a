// The shape of a mode: phasors of its eigenvector, and how much each state takes part.
#pragma once

#include "tiltrotor/analysis/linear/linear_model.hpp"
#include "tiltrotor/math/algebra/eigen.hpp"

namespace tiltrotor {

template <class R>
struct Phasor {
  R magnitude;      // over that of the state of reference, each in the unit of the model
  R angle;          // ahead of it, rad, within -pi..pi
  R participation;  // of the state in the mode, all together 1; without units
};

// The state after which eigenvector k is normalised: the largest among those for which `counts(i)` holds, in the units of
// the model; the largest of all where those stand still.
template <class R, int N, class Counts>
int largest_state(const Eigensystem<R, N>& system, int k, Counts&& counts) {
  const auto size = [&](int i) {
    const ComplexEntry<R> v = right_entry(system, i, k);
    return v.real * v.real + v.imag * v.imag;
  };
  int best = -1, any = 0;
  for (int i = 0; i < system.values.size; ++i) {
    if (size(i) > size(any)) any = i;
    if (counts(i) && size(i) > R(0) && (best < 0 || size(i) > size(best))) best = i;
  }
  return best >= 0 ? best : any;
}

// phasor[system.values.size] of eigenvalue k, that of state `reference` one at angle zero. Not finite where the reference
// stands still. The participations of a defective root are equal parts. Cost: n.
template <class R, int N>
void mode_shape(const Eigensystem<R, N>& system, int k, int reference, Phasor<R>* phasor) {
  const int n = system.values.size;
  const ComplexEntry<R> one = right_entry(system, reference, k);
  const R square = one.real * one.real + one.imag * one.imag;
  R total = R(0);
  for (int i = 0; i < n; ++i) total += participation(system, i, k);
  const bool usable = is_finite(total);
  for (int i = 0; i < n; ++i) {
    const ComplexEntry<R> v = right_entry(system, i, k);
    const R real = (v.real * one.real + v.imag * one.imag) / square;
    const R imag = i == reference ? R(0) : (v.imag * one.real - v.real * one.imag) / square;
    phasor[i] = {tiltrotor::sqrt(real * real + imag * imag), std::atan2(imag, real),
                 usable ? participation(system, i, k) / total : R(1) / static_cast<R>(n)};
  }
}

}  // namespace tiltrotor

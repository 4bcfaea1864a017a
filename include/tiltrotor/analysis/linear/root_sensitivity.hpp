// How the roots of a linear model move with its matrix: d lambda = w^H dA v / (w^H v), v and w right and left eigenvector.
#pragma once

#include "tiltrotor/analysis/linear/modes.hpp"

namespace tiltrotor {

// Per unit of the parameter.
template <class R>
struct RootMotion {
  R real, imag;     // of the root, 1/s
  R frequency;      // of |root|, rad/s
  R damping_ratio;  // of a real root, where it is 1 or -1, zero
};

// Of eigenvalue k of `system` with da = dA/dp in the coordinates of the system. Huge at a defective root, where a root
// has no derivative: compare Eigensystem::condition. Frequency and damping ratio of a root at zero are not finite.
// Cost: n^2.
template <class R, int N>
RootMotion<R> root_motion(const Eigensystem<R, N>& system, int k, const Matrix<R, N, N>& da) {
  const int n = system.values.size;
  ComplexEntry<R> top = {R(0), R(0)}, below = {R(0), R(0)};
  // to += conj(w) v
  const auto add = [](const ComplexEntry<R>& w, const ComplexEntry<R>& v, ComplexEntry<R>& to) {
    to.real += w.real * v.real + w.imag * v.imag;
    to.imag += w.real * v.imag - w.imag * v.real;
  };
  for (int i = 0; i < n; ++i) {
    const ComplexEntry<R> w = left_entry(system, i, k);
    ComplexEntry<R> moved = {R(0), R(0)};
    for (int j = 0; j < n; ++j) {
      const ComplexEntry<R> v = right_entry(system, j, k);
      moved.real += da(i, j) * v.real;
      moved.imag += da(i, j) * v.imag;
    }
    add(w, moved, top);
    add(w, right_entry(system, i, k), below);
  }
  const R size = below.real * below.real + below.imag * below.imag;
  RootMotion<R> out;
  out.real = (top.real * below.real + top.imag * below.imag) / size;
  out.imag = (top.imag * below.real - top.real * below.imag) / size;
  const R real = system.values.real[k], imag = system.values.imag[k];
  const R frequency = length_of(real, imag);
  out.frequency = (real * out.real + imag * out.imag) / frequency;
  // zeta = -real/frequency: its slope is imag (real imag' - imag real') / frequency^3.
  out.damping_ratio = (imag / frequency) * ((real * out.imag - imag * out.real) / frequency) / frequency;
  return out;
}

template <class R>
struct RootMotionWorkspace {
  LinearModel<R> moved;
  SplitModel<R> split;
};

// root[i] of every mode of a set, from dA/dp in the states of the model that the set was found from.
template <class R>
void root_motions(const LinearPoint<R>& model, const Matrix<R, kMaxLinearStates, kMaxLinearStates>& da,
                  const ModeSet<R>& set, RootMotionWorkspace<R>& work, RootMotion<R>* root) {
  clear(work.moved);
  static_cast<LinearPoint<R>&>(work.moved) = model;
  work.moved.controls = 0;
  work.moved.a = da;
  split(work.moved, work.split);
  for (int i = 0; i < set.count; ++i) root[i] = root_motion(set.system, set.mode[i].eigenvalue, work.split.a);
}

}  // namespace tiltrotor

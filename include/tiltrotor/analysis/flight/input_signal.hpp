// Test inputs: step, pulse and doublet on one control.
#pragma once

#include "tiltrotor/math/algebra/matrix.hpp"
#include "tiltrotor/model/variables/controls.hpp"

namespace tiltrotor {

enum class InputShape : unsigned char { step, pulse, doublet };

template <class R>
struct InputSignal {
  InputShape shape;
  int control;  // place in kControlVariables
  R amplitude;  // rad, in or m/s, added to the control
  R start;      // s
  R duration;   // s, of a pulse and of each half of a doublet; a step lasts
};

template <class R>
bool is_valid(const InputSignal<R>& s) {
  return s.control >= 0 && s.control < control_count && is_finite(s.amplitude) && is_finite(s.start) &&
         (s.shape == InputShape::step || (is_finite(s.duration) && s.duration > R(0)));
}

template <class R>
R value_at(const InputSignal<R>& s, R time) {
  const R since = time - s.start;
  if (since < R(0)) return R(0);
  if (s.shape == InputShape::step) return s.amplitude;
  if (since < s.duration) return s.amplitude;
  return s.shape == InputShape::doublet && since < R(2) * s.duration ? -s.amplitude : R(0);
}

// Times at which the value jumps, in order. Returns how many.
inline constexpr int kMaxEdges = 3;
template <class R>
int edges(const InputSignal<R>& s, R (&times)[kMaxEdges]) {
  times[0] = s.start;
  times[1] = s.start + s.duration;
  times[2] = s.start + R(2) * s.duration;
  return s.shape == InputShape::step ? 1 : s.shape == InputShape::pulse ? 2 : 3;
}

}  // namespace tiltrotor

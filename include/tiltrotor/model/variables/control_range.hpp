// Ranges of the controls: what a program may command, and what a stored flight may hold.
#pragma once

#include "tiltrotor/model/variables/controls.hpp"

namespace tiltrotor {

template <class R>
struct ControlRange {
  R low, high;  // rad, in from neutral, m/s
};

// Of a command. `control`: place in kControlVariables.
template <class R>
constexpr ControlRange<R> control_range(int control) {
  if (control == kControlIndex.collective) return {R(-0.35), R(1.4)};
  switch (kControlVariables[control].kind) {
    case VariableKind::stick:
      return {R(-4.8), R(4.8)};
    case VariableKind::pedal:
      return {R(-2.5), R(2.5)};
    case VariableKind::gust:
      return {R(-50), R(50)};
    case VariableKind::blade_pitch:
    case VariableKind::surface:
      return {R(-0.5), R(0.5)};  // increments
    default:
      return {R(0), R(0)};
  }
}

constexpr bool every_control_has_a_range() {
  for (int j = 0; j < control_count; ++j)
    if (!(control_range<double>(j).low < control_range<double>(j).high)) return false;
  return true;
}
static_assert(every_control_has_a_range(), "a new kind of input has its range");

// Of a stored state: trims beyond the stops included.
template <class R>
inline constexpr R kLargestControl = R(100);

}  // namespace tiltrotor

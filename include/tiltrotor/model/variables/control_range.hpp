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
    default:
      return {R(-0.5), R(0.5)};  // increments on blades and surfaces
  }
}

// Of a stored state: trims beyond the stops included.
template <class R>
inline constexpr R kLargestControl = R(100);

}  // namespace tiltrotor

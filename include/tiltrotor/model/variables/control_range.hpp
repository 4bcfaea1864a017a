// Ranges of the controls, which are the aircraft's: what a program may command, and what a stored flight may hold.
#pragma once

#include "tiltrotor/model/aircraft/aircraft.hpp"
#include "tiltrotor/model/variables/controls.hpp"

namespace tiltrotor {

// Of a command: rad, in from neutral, m/s. `control`: place in kControlVariables.
template <class R>
Bounds<R> control_range(const Aircraft<R>& aircraft, int control) {
  const ControlTables<R>& t = aircraft.controls;
  const LimitTables<R>& limits = aircraft.limits;
  const auto around_zero = [](R size) { return Bounds<R>{-size, size}; };
  if (control == kControlIndex.collective) return limits.collective;
  switch (kControlVariables[control].kind) {
    case VariableKind::stick:
      return around_zero(control == kControlIndex.lat_stick ? t.lat_travel : t.long_travel);
    case VariableKind::pedal:
      return around_zero(t.pedal_travel);
    case VariableKind::gust:
      return around_zero(limits.gust);
    case VariableKind::blade_pitch:
    case VariableKind::surface:
      return around_zero(limits.increment);
    default:
      return around_zero(R(0));
  }
}

// A kind of input that has a case above.
constexpr bool has_control_range(VariableKind kind) {
  return kind == VariableKind::stick || kind == VariableKind::pedal || kind == VariableKind::gust ||
         kind == VariableKind::blade_pitch || kind == VariableKind::surface;
}
constexpr bool every_control_has_a_range() {
  for (int j = 0; j < control_count; ++j)
    if (!has_control_range(kControlVariables[j].kind)) return false;
  return true;
}
static_assert(every_control_has_a_range(), "a new kind of input has its range");

// Of a stored state: trims beyond the stops included.
template <class R>
inline constexpr R kLargestControl = R(100);

}  // namespace tiltrotor

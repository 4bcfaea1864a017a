// Ranges of the controls, which are the aircraft's: what a program may command, and what a stored flight may hold.
#pragma once

#include "tiltrotor/model/aircraft.hpp"
#include "tiltrotor/model/variables/controls.hpp"

namespace tiltrotor {

// Of a command: rad, in from neutral, m/s. `control`: place in kControlVariables.
template <class R>
Bounds<R> control_range(const Aircraft<R>& aircraft, int control) {
  const ControlTables<R>& t = aircraft.controls;
  const LimitTables<R>& limits = aircraft.limits;
  const auto around_zero = [](R size) { return Bounds<R>{-size, size}; };
  if (control == kControlIndex.collective) return limits.collective;
  if (control == kControlIndex.long_stick) return around_zero(t.long_travel);
  if (control == kControlIndex.lat_stick) return around_zero(t.lat_travel);
  if (control == kControlIndex.pedal) return around_zero(t.pedal_travel);
  return around_zero(kControlVariables[control].kind == VariableKind::gust ? limits.gust : limits.increment);
}

// Of a stored state: trims beyond the stops included.
template <class R>
inline constexpr R kLargestControl = R(100);

}  // namespace tiltrotor

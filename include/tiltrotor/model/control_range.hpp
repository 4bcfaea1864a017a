// Ranges of the controls: what a program may command, and what a stored flight may hold.
#pragma once

#include "tiltrotor/model/controls.hpp"

namespace tiltrotor {

template <class R>
struct ControlRange {
  R low, high;  // rad, in from neutral, m/s
};

// Of a command. `control` is a ControlIndex.
template <class R>
constexpr ControlRange<R> control_range(int control) {
  if (control == iu_collective) return {R(-0.35), R(1.4)};
  if (control <= iu_lat_stick) return {R(-4.8), R(4.8)};
  if (control == iu_pedal) return {R(-2.5), R(2.5)};
  if (control < iu_gust) return {R(-0.5), R(0.5)};
  return {R(-50), R(50)};
}

// Of a stored state: trims beyond the stops included.
template <class R>
inline constexpr R kLargestControl = R(100);

}  // namespace tiltrotor

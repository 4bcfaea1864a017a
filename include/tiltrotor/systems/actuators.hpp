// Hydraulic actuators of blades and surfaces: a first-order lag with a largest rate, between stops.
//
// They follow what the gearing asks for. The rigging of the longitudinal cyclic lies between actuator and blade.
#pragma once

#include "tiltrotor/model/control_mixing.hpp"
#include "tiltrotor/systems/limited.hpp"
#include "tiltrotor/systems/system_state.hpp"

namespace tiltrotor {

template <class R>
struct Actuator {
  R low, high;  // stops, rad
  R rate;       // largest, rad/s
};

// clip(bandwidth (clip(command) - angle)): an actuator never passes its stop.
template <class T>
T actuator_rate(const SystemTables<Real<T>>& t, const Actuator<Real<T>>& actuator, const T& command,
                const T& angle) {
  const T reachable = limited(command, actuator.low, actuator.high, t.smooth.actuator_angle);
  return limited(T(t.actuator.bandwidth * (reachable - angle)), -actuator.rate, actuator.rate,
                 t.smooth.actuator_rate);
}

// `wanted`: of mix_controls(), its longitudinal cyclic less the rigging.
template <class T>
void actuator_rates(const Aircraft<Real<T>>& aircraft, const BladeControls<T>& wanted,
                    const SystemState<T>& s, SystemState<T>& rates) {
  using R = Real<T>;
  const SystemTables<R>& t = aircraft.systems;
  const ControlTables<R>& c = aircraft.controls;
  const Actuator<R> collective = {aircraft.limits.collective.low, aircraft.limits.collective.high,
                                  t.actuator.collective_rate};
  const Actuator<R> cyclic = {-t.actuator.cyclic_limit, t.actuator.cyclic_limit, t.actuator.cyclic_rate};
  const auto surface = [&t](R limit) { return Actuator<R>{-limit, limit, t.actuator.surface_rate}; };
  for (const Side side : {right, left}) {
    rates.collective[side] = actuator_rate(t, collective, wanted.collective[side], s.collective[side]);
    rates.long_cyclic[side] = actuator_rate(t, cyclic, wanted.long_cyclic[side], s.long_cyclic[side]);
  }
  rates.elevator = actuator_rate(t, surface(c.elevator_limit), wanted.elevator, s.elevator);
  rates.aileron = actuator_rate(t, surface(c.aileron_limit), wanted.aileron, s.aileron);
  rates.rudder = actuator_rate(t, surface(c.rudder_limit), wanted.rudder, s.rudder);
}

// Actuators that have arrived.
template <class T>
void put_actuators(const BladeControls<T>& at, SystemState<T>& s) {
  for (const Side side : {right, left}) {
    s.collective[side] = at.collective[side];
    s.long_cyclic[side] = at.long_cyclic[side];
  }
  s.elevator = at.elevator;
  s.aileron = at.aileron;
  s.rudder = at.rudder;
}

// Controls that set blades and surfaces to what the actuators are at: increments, with the inceptors at neutral.
template <class T>
Controls<T> actuated_controls(const SystemState<T>& s, const Controls<T>& u) {
  using R = Real<T>;
  const R half = R(0.5);
  Controls<T> at{};
  at.collective = half * (s.collective[right] + s.collective[left]);
  at.diff_collective = half * (s.collective[right] - s.collective[left]);
  at.long_cyclic = half * (s.long_cyclic[right] + s.long_cyclic[left]);
  at.diff_long_cyclic = half * (s.long_cyclic[right] - s.long_cyclic[left]);
  at.elevator = s.elevator;
  at.aileron = s.aileron;
  at.rudder = s.rudder;
  at.lateral_cyclic = u.lateral_cyclic;
  at.gust = u.gust;
  return at;
}

}  // namespace tiltrotor

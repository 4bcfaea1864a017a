// Loads of the components, and angles of attack of wing and horizontal tail, from what one evaluation found; on dual numbers
// with their derivatives.
#pragma once

#include "tiltrotor/model/derivative.hpp"

namespace tiltrotor {

template <class T>
struct ComponentReadings {
  LoadRecord<T> loads;  // force on the aircraft, N, and moment about the CG, N m, body axes
  AirframeWorkspace<T> work;
  AirframeResponse<T> airframe;  // with the angle of attack of the wing where no wake covers it, rad
};

// The airframe once more; `c`: as the evaluation had it. Cost: a third of a derivative.
template <class T>
void read_components(const Configuration<T>& c, const DerivativeSteps<T>& steps,
                     ComponentReadings<T>& found) {
  found.loads = {};
  for (const Side side : {right, left})
    found.loads[side == right ? Component::rotor_right : Component::rotor_left] = steps.hub_loads[side];
  airframe_response(c, steps.airframe_input, found.work, found.airframe,
                    [&](Component component, const Loads<T>& l) { found.loads[component] = l; });
  if (!c.setup.options.engine_jets) return;
  T power = T(Real<T>(0));
  for (const Side side : {right, left})
    power = power + (steps.rotor[side].loads.torque + c.rotor[side].spin_up) * c.rotor[side].speed;
  found.loads[Component::engine_jets] =
      engine_jet_loads(c, power, total_speed(steps.velocity_b, c.aircraft->smooth.airspeed));
}

// With incidence, wash and downwash, rad; `found`: of read_components().
template <class T>
T htail_angle_of_attack(const Configuration<T>& c, const DerivativeSteps<T>& steps,
                        const ComponentReadings<T>& found) {
  const Vec3<T> v = horizontal_tail_velocity(c, steps.airframe_input, found.work.tail.wash_ratio);
  return angle_of_attack(v, c.aircraft->smooth) + c.aircraft->htail.surface.incidence - found.work.downwash;
}

}  // namespace tiltrotor

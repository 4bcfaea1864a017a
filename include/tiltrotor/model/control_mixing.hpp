// Gearing from inceptors to blades and surfaces, phased with mast angle (NASA CR-166536 tables 8a-I to
// 8a-VIII, pp. B-88 to B-95).
#pragma once

#include "tiltrotor/model/airframe/airflow.hpp"
#include "tiltrotor/model/variables/controls.hpp"

namespace tiltrotor {

// `velocity`: CG relative to the air, body axes; the pedal's cyclic and the lateral cyclic schedule depend on
// speed; `pedal_mast`: place of the mast in the table of the former. Forward stick: disks forward, elevator down. Right
// stick: left rotor up, right aileron up. Right pedal: left disk forward, right disk aft, rudder for nose right.
template <class T, class C>
BladeControls<T> mix_controls(const Aircraft<Real<T>>& aircraft, const Options& options, const Gearing<C>& g,
                              const GridPoint<C> (&pedal_mast)[1], const Controls<T>& u,
                              const Vec3<T>& velocity) {
  using R = Real<T>;
  const ControlTables<R>& t = aircraft.controls;
  const Interpolation mode = options.tables;
  const T speed_kt[1] = {total_speed(velocity, aircraft.smooth.airspeed) * (R(1) / kKnot<R>)};
  const T pedal_cyclic = lookup(t.pedal_cyclic, mode, pedal_mast, speed_kt);  // 8a-II

  const T half_collective = u.diff_collective - g.lateral_collective * u.lat_stick;  // 8a-III
  const T cyclic = g.long_cyclic * u.long_stick + g.rigging + u.long_cyclic;         // 8a-I
  const T half_cyclic = u.diff_long_cyclic - pedal_cyclic * u.pedal;
  T lateral = u.lateral_cyclic;
  if (options.lateral_cyclic) {
    // A1 = - schedule, tables 8a-VII and 8a-VIII: disks tilt outboard above 40 kt.
    lateral =
        lateral - g.lateral_cyclic_gain * lookup(t.lateral_cyclic, mode, T(velocity.x * (R(1) / kKnot<R>)));
  }
  BladeControls<T> b;
  b.collective[right] = u.collective + half_collective;
  b.collective[left] = u.collective - half_collective;
  b.long_cyclic[right] = cyclic + half_cyclic;
  b.long_cyclic[left] = cyclic - half_cyclic;
  b.lateral_cyclic[right] = lateral;
  b.lateral_cyclic[left] = lateral;
  b.elevator = g.elevator * u.long_stick + u.elevator;
  b.aileron = g.aileron * u.lat_stick + u.aileron;
  b.rudder = g.rudder * u.pedal + u.rudder;
  return b;
}
template <class T, class C>
BladeControls<T> mix_controls(const Configuration<C>& c, const Controls<T>& u, const Vec3<T>& velocity) {
  return mix_controls(*c.aircraft, c.setup.options, c.gearing, c.pedal_mast, u, velocity);
}

}  // namespace tiltrotor

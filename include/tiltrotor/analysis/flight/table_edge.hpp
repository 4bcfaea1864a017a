// Whether a flight is beyond the data: the end value of a table is held where the source says nothing.
#pragma once

#include "tiltrotor/analysis/trim/trim_limits.hpp"

namespace tiltrotor {

namespace table_edge_detail {

template <class R>
bool is_beyond(const Axis<R>& axis, R x) {
  return axis.count > 1 && !is_within(x, axis.knot[0], axis.knot[axis.count - 1]);
}

// Mach number of the advancing tip of a rotor on its helix.
template <class R>
R tip_mach(const Configuration<R>& c, int side, const Vec3<R>& hub_velocity_a) {
  const R advancing = c.rotor[side].tip_speed + length(Vec3<R>{hub_velocity_a.x, hub_velocity_a.y, R(0)});
  return length(Vec3<R>{advancing, hub_velocity_a.z, R(0)}) / c.air.speed_of_sound;
}

}  // namespace table_edge_detail

// Angles count where a unit of lift coefficient carries more than kWingLoadShare of the weight. Not asked are
// tables that go all around, as those of the angles of wing and fuselage; the angles of blade sections, which
// have a flat plate beyond their table; and tables that are meant to end, as those of gearing along speed.
// `velocity`: relative to the air, m/s.
template <class R>
bool is_beyond_tables(const Configuration<R>& c, const State<R>& x, const Vec3<R>& velocity,
                      const BladeControls<R>& blades) {
  using namespace table_edge_detail;
  const Aircraft<R>& aircraft = *c.aircraft;
  const Vec3<R> at_wing = velocity - c.around.wing_gust_b;
  const R speed = length(at_wing);
  const R mach = speed / c.air.speed_of_sound;
  if (is_beyond(aircraft.wing.drag_90[0].smooth[1], mach) || is_beyond(aircraft.htail.drag.smooth[1], mach) ||
      is_beyond(aircraft.fin.drag.smooth[1], mach))
    return true;
  for (const Side side : {right, left}) {
    RotorInput<R> in;
    rotor_input(c, x, velocity, blades, side, in);
    if (is_beyond(aircraft.rotor.section_lift[kSectionRegions - 1].smooth[1],
                  tip_mach(c, side, in.velocity_a)))
      return true;
  }
  const R pressure_lift = R(0.5) * c.air.density * square(speed) * aircraft.wing.area;
  if (pressure_lift < kWingLoadShare<R> * c.mass.mass * kGravity<R>) return false;
  const FreeStream<R> stream = free_stream(c, at_wing);
  return is_beyond(aircraft.fin.sidewash.smooth[0], stream.alpha_deg) ||
         is_beyond(aircraft.fin.sidewash.smooth[1], stream.abs_beta_deg) ||
         is_beyond(aircraft.htail.lift_elevator.smooth[1], blades.elevator * kDegPerRad<R>) ||
         is_beyond(aircraft.fin.side_rudder.smooth[1], blades.rudder * kDegPerRad<R>);
}

}  // namespace tiltrotor

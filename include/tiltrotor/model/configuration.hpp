// Configuration: everything about a flight that stays fixed while the state changes, computed once before it.
//
// Mast angle, flaps, rotor speed, altitude, mass and the model's switches; from them frames, arms, inertia,
// air, gearing, blade stations, and the places on the tables' mast and flap axes. Plain numbers only.
#pragma once

#include "tiltrotor/math/arithmetic.hpp"
#include "tiltrotor/math/status.hpp"
#include "tiltrotor/model/atmosphere.hpp"
#include "tiltrotor/model/frames.hpp"
#include "tiltrotor/model/mass_properties.hpp"
#include "tiltrotor/model/rotor/blade_grid.hpp"
#include "tiltrotor/model/setup_range.hpp"

namespace tiltrotor {

// What the user chooses. Defaults by mast angle: flight_setup(); ranges: setup_range().
template <class R>
struct FlightSetup {
  R mast_deg;      // 0 helicopter .. 90 airplane
  R mast_rate;     // rad/s, + towards airplane
  R flap_deg;      // flaperons follow the flap settings of the tables
  R rotor_speed;   // rad/s
  R altitude;      // m
  R mass;          // kg
  R sl_cg, wl_cg;  // CG at mast 0, m
  Options options;
};

// Gearing at one mast angle, rad/in.
template <class R>
struct Gearing {
  R long_cyclic;
  R lateral_collective;
  R lever;             // collective per inch of lever; 0 at mast 90
  R collective_floor;  // rad
  R lateral_cyclic_gain;
  R elevator, aileron, rudder;
};

// Wing-pylon coefficients that depend on mast and flap alone.
template <class R>
struct WingConstants {
  R moment;  // Cm
  R roll_beta, roll_beta_per_lift;
  R zero_lift_drag;
  R aileron_roll, aileron_yaw_0, aileron_yaw, aileron_lift_loss;
  R rotor_wash;        // X_RW
  R wake_load_factor;  // K_FW
  R aspect_ratio;
  int flap_below, flap_above;  // settings around the flap angle
  R flap_fraction;             // weight of the setting above
};

template <class R>
struct Configuration {
  const Aircraft<R>* aircraft;
  FlightSetup<R> setup;
  R mast;  // rad
  Air<R> air;
  MassProperties<R> mass;
  Vec3<R> nacelle_axis;  // (sin, 0, -cos) of the mast angle: thrust direction without cant
  Vec3<R> pivot_arm;     // CG to conversion axis at the centre line, B, m
  HubFrame<R> hub[2];
  R tip_speed;             // m/s
  R coning;                // rad, when it is no state
  R pitch_flap;            // tan(delta3): pitch per gimbal tilt, negative up
  R hub_spring;            // N m/rad
  R induced_power_factor;  // kappa_i
  R apparent_mass_0;
  BladeStations<R> blade;
  AzimuthStations<R> azimuth;  // Averaged mode
  WingConstants<R> wing;
  Gearing<R> gearing;
  GridPoint<R> pedal_mast[1];  // places on the mast and flap axes of the tables
  GridPoint<R> downwash_mast_flap[2];
  GridPoint<R> tail_wash_mast[1];
  GridPoint<R> tail_wash_beta_mast[1];
  GridPoint<R> tail_pressure_mast[1];
  GridPoint<R> sidewash_mast_flap[2];
};

// Default setup at a mast angle: gross weight, sea level; flaps as the aircraft's defaults say, airplane rotor
// speed at mast 90 and that of helicopter mode below.
template <class R>
FlightSetup<R> flight_setup(const Aircraft<R>& aircraft, R mast_deg) {
  FlightSetup<R> s{};
  s.mast_deg = mast_deg;
  s.flap_deg = mast_deg <= R(0)   ? aircraft.defaults.flap_helicopter
               : mast_deg < R(90) ? aircraft.defaults.flap_conversion
                                  : aircraft.defaults.flap_airplane;
  s.rotor_speed = mast_deg < R(90) ? aircraft.rotor.speed_helicopter : aircraft.rotor.speed_airplane;
  s.mass = aircraft.mass.gross;
  s.sl_cg = aircraft.mass.sl_cg;
  s.wl_cg = aircraft.mass.wl_cg;
  return s;
}

namespace configuration_detail {

template <class R>
WingConstants<R> wing_constants(const Aircraft<R>& aircraft, const FlightSetup<R>& s) {
  const WingTables<R>& w = aircraft.wing;
  const auto at = [&](const Table<R, 1, 1>& table) {
    const GridPoint<R> flap[1] = {grid_point(table.linear[0], s.flap_deg)};
    const R mast[1] = {s.mast_deg};
    return lookup(table, Interpolation::linear, flap, mast);
  };
  WingConstants<R> c;
  c.moment = at(w.moment);
  c.roll_beta = at(w.roll_beta);
  c.roll_beta_per_lift = at(w.roll_beta_per_lift);
  c.zero_lift_drag = at(w.zero_lift_drag);
  c.aileron_roll = at(w.aileron_roll);
  c.aileron_yaw_0 = at(w.aileron_yaw_0);
  c.aileron_yaw = at(w.aileron_yaw);
  c.aileron_lift_loss = lookup(w.aileron_lift_loss, Interpolation::linear, s.flap_deg);
  c.rotor_wash = w.rotor_wash_0 + s.mast_deg * (w.rotor_wash_1 + s.mast_deg * w.rotor_wash_2);
  c.wake_load_factor =
      s.options.wake_load == WakeLoadFactor::calibrated
          ? aircraft.wake.load_factor.at(s.mast_deg)
          : aircraft.wake.gtrs_load_factor_0 + aircraft.wake.gtrs_load_factor_flap * s.flap_deg;
  c.aspect_ratio = w.span * w.span / w.area;
  const Axis<R> settings{w.flap_settings, w.flap_deg, nullptr, 0, R(0)};
  const GridPoint<R> flap = grid_point(settings, s.flap_deg);
  c.flap_below = flap.interval;
  c.flap_above = flap.interval + 1;
  c.flap_fraction = flap.fraction;
  return c;
}

template <class R>
Gearing<R> gearing(const Aircraft<R>& aircraft, const FlightSetup<R>& s) {
  const ControlTables<R>& t = aircraft.controls;
  const auto at = [&](const Table<R, 1>& table) { return lookup(table, Interpolation::linear, s.mast_deg); };
  Gearing<R> g;
  g.long_cyclic = at(t.long_cyclic);
  g.lateral_collective = at(t.lateral_collective);
  g.lever = at(t.lever);
  g.collective_floor = at(t.collective_floor);
  g.lateral_cyclic_gain = s.options.lateral_cyclic ? at(t.lateral_cyclic_gain) : R(0);
  g.elevator = s.options.elevator_gearing == ElevatorGearing::aircraft ? t.elevator : t.elevator_replay;
  g.aileron = t.aileron;
  g.rudder = t.rudder;
  return g;
}

}  // namespace configuration_detail

// Arm from the CG to a point given by its stations (m), body axes.
template <class R>
Vec3<R> station_arm(const MassProperties<R>& mass, R sl, R bl, R wl) {
  return {mass.sl_cg - sl, bl, mass.wl_cg - wl};
}

// Prepare a configuration. Status out_of_range (and `c` unusable) when a setting lies outside its range, which
// first_out_of_range() names; bad_arithmetic when this code or the processor does not round as arithmetic.hpp says.
// Cost: about one derivative.
template <class R>
Status prepare(const Aircraft<R>& aircraft, const FlightSetup<R>& setup, Configuration<R>& c) {
  c = Configuration<R>{};
  if (!rounds_once_to_nearest<R>()) return Status::bad_arithmetic;
  if (first_out_of_range(aircraft, setup).field != SetupField::none) return Status::out_of_range;
  const Options& o = setup.options;
  c.aircraft = &aircraft;
  c.setup = setup;
  c.mast = setup.mast_deg * kRadPerDeg<R>;
  c.air = standard_air(setup.altitude);
  c.mass = mass_properties(aircraft, setup.mast_deg, setup.mass, setup.sl_cg, setup.wl_cg, o.inertia);

  const MastTables<R>& mast = aircraft.mast;
  c.nacelle_axis = {sin(c.mast), R(0), -cos(c.mast)};
  c.pivot_arm = station_arm(c.mass, mast.sl_pivot, R(0), mast.wl_pivot);
  const R cant = o.mast_cant ? mast.cant * cos(c.mast) : R(0);
  for (int side = 0; side < 2; ++side) {
    const Vec3<R> pivot =
        station_arm(c.mass, mast.sl_pivot, side_sign<R>(side) * mast.bl_pivot, mast.wl_pivot);
    c.hub[side] = hub_frame(c.mast, cant, side, pivot, mast.length);
  }

  c.tip_speed = setup.rotor_speed * aircraft.rotor.radius;
  c.coning = aircraft.rotor.coning.at(setup.mast_deg);
  c.pitch_flap = tan(aircraft.rotor.delta3);
  c.hub_spring = aircraft.rotor.hub_spring * static_cast<R>(o.hub_spring_factor);
  c.induced_power_factor =
      o.induced_power_factor > 0 ? static_cast<R>(o.induced_power_factor) : aircraft.inflow.induced_power;
  c.apparent_mass_0 = o.apparent_mass == ApparentMass::impermeable ? aircraft.inflow.apparent_mass_uniform
                                                                   : aircraft.inflow.apparent_mass_loaded;
  c.blade = blade_stations(aircraft.rotor, o);
  c.azimuth = averaged_azimuth<R>(aircraft.rotor.blades, azimuth_count(o));

  c.wing = configuration_detail::wing_constants(aircraft, setup);
  c.gearing = configuration_detail::gearing(aircraft, setup);

  const R m = setup.mast_deg;
  const R f = setup.flap_deg;
  c.pedal_mast[0] = grid_point(aircraft.controls.pedal_cyclic.linear[0], m);
  c.downwash_mast_flap[0] = grid_point(aircraft.wing.downwash.linear[0], m);
  c.downwash_mast_flap[1] = grid_point(aircraft.wing.downwash.linear[1], f);
  c.tail_wash_mast[0] = grid_point(aircraft.htail.rotor_wash.linear[0], m);
  c.tail_wash_beta_mast[0] = grid_point(aircraft.htail.rotor_wash_beta.linear[0], m);
  c.tail_pressure_mast[0] = grid_point(aircraft.htail.pressure_ratio.linear[0], m);
  c.sidewash_mast_flap[0] = grid_point(aircraft.fin.sidewash.linear[0], m);
  c.sidewash_mast_flap[1] = grid_point(aircraft.fin.sidewash.linear[1], f);
  return Status::ok;
}

}  // namespace tiltrotor

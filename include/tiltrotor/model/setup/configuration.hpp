// Configuration: mast angle, flaps, rotor speed, air and loading, and all that follows from them and from the
// switches of the model, computed once and not at every evaluation.
//
// Two parts, by how fast they change. FixedSetup holds for a flight: aircraft, stations of blade and azimuth.
// ConfigurationSetting may move while it lasts; reconfigure() remakes what follows from it for a small part
// of a derivative. C, the scalar of what moves: a plain number, or one with partials, when derivatives with
// respect to mast angle, rotor speed, altitude .. are wanted
// (analysis/linear/configuration_sensitivity.hpp). Components take a Configuration<C> and what they see of
// the state in T: C is plain or T, results are T.
#pragma once

#include "tiltrotor/math/status.hpp"
#include "tiltrotor/model/setup/atmosphere.hpp"
#include "tiltrotor/model/setup/blade_grid.hpp"
#include "tiltrotor/model/setup/gearing.hpp"
#include "tiltrotor/model/setup/mass_properties.hpp"
#include "tiltrotor/model/setup/nacelle_motion.hpp"
#include "tiltrotor/model/setup/setup_range.hpp"
#include "tiltrotor/model/setup/wing_constants.hpp"
#include "tiltrotor/model/variables/frames.hpp"
#include "tiltrotor/model/variables/surroundings.hpp"

namespace tiltrotor {

// What may change in flight. Ranges: setup_range().
template <class C>
struct ConfigurationSetting {
  C mast_deg;            // 0 helicopter .. 90 airplane
  C mast_rate;           // rad/s, + towards airplane
  C mast_acceleration;   // rad/s^2
  C flap_deg;            // flaperons follow the flap settings of the tables
  C rotor_speed;         // mean of the two, rad/s
  C rotor_difference;    // right rotor's speed less the left one's, rad/s
  C rotor_acceleration;  // rad/s^2
  C altitude;            // m
  C mass;                // kg
  C sl_cg, wl_cg;        // CG at mast 0, m
};

// The same in the scalar T.
template <class T>
ConfigurationSetting<T> in_scalar(const ConfigurationSetting<Real<T>>& s) {
  return {T(s.mast_deg),
          T(s.mast_rate),
          T(s.mast_acceleration),
          T(s.flap_deg),
          T(s.rotor_speed),
          T(s.rotor_difference),
          T(s.rotor_acceleration),
          T(s.altitude),
          T(s.mass),
          T(s.sl_cg),
          T(s.wl_cg)};
}

// What the user chooses. Defaults by mast angle: flight_setup().
template <class C>
struct FlightSetup : ConfigurationSetting<C> {
  Options options;
};

// What follows from aircraft and options alone.
template <class R>
struct FixedSetup {
  const Aircraft<R>* aircraft;
  R pitch_flap;            // tan(delta3): pitch per gimbal tilt, negative up
  R induced_power_factor;  // kappa_i
  R apparent_mass_0;
  BladeStations<R> blade;
  AzimuthStations<R> azimuth;  // Averaged mode
};

// Of one rotor. The two turn alike but for the twist of the shaft between them: systems/drive.hpp.
template <class C>
struct RotorSetting {
  C speed;        // Omega, rad/s
  C tip_speed;    // m/s
  C spin_up;      // what a change of its speed takes of it, N m
  C ground_wash;  // what the ground leaves of the mean inflow that its blades feel: systems/ground_effect.hpp
};

// A rotor with the air around it: all that moves in flight of what it sees of the configuration, but for its acceleration.
template <class C>
struct RotorConditions : RotorSetting<C> {
  C density;         // kg/m^3
  C speed_of_sound;  // m/s
};

template <class C>
struct Configuration : FixedSetup<Real<C>> {
  FlightSetup<C> setup;  // as it is now
  Surroundings<Real<C>> around;
  C mast;  // rad
  Air<C> air;
  MassProperties<C> mass;
  Vec3<C> nacelle_axis_b;  // (sin, 0, -cos) of the mast angle: thrust direction without cant
  Vec3<C> pivot_arm_b;     // CG to conversion axis at the centre line, m
  HubFrame<C> hub[2];
  Loads<C> outside;  // those around, about the CG
  C tip_speed;       // mean of the rotors, m/s
  C coning;          // rad, when it is no state
  C hub_spring;      // N m/rad
  WingConstants<C> wing;
  Gearing<C> gearing;
  // What the ground leaves of the inflow of each rotor, and of the loads of the wing in the wakes, is 1 without ground: so
  // prepare() sets them, and configure() leaves them alone.
  RotorSetting<C> rotor[2];
  C download;
  GridPoint<C> pedal_mast[1];  // places on the mast and flap axes of the tables
  GridPoint<C> downwash_mast_flap[2];
  GridPoint<C> tail_wash_mast[1];
  GridPoint<C> tail_wash_beta_mast[1];
  GridPoint<C> tail_pressure_mast[1];
  GridPoint<C> sidewash_mast_flap[2];
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

// Arm from the CG to a point given by its stations (m), body axes.
template <class C>
Vec3<C> station_arm(const MassProperties<C>& mass, Real<C> sl, Real<C> bl, Real<C> wl) {
  return {mass.sl_cg - sl, C(bl), mass.wl_cg - wl};
}

// The loads around, about the CG.
template <class C>
void set_outside(Configuration<C>& c) {
  using R = Real<C>;
  const Loads<R>& outside = c.around.outside;
  const Vec3<C> pull = {C(outside.force.x), C(outside.force.y), C(outside.force.z)};
  c.outside = force_at(station_arm(c.mass, R(0), R(0), R(0)), pull);
  c.outside.moment = plus_fixed(c.outside.moment, outside.moment);
}

// What follows from `c.setup` and `c.around`, its fixed part being prepared.
template <class C>
void configure(Configuration<C>& c) {
  using R = Real<C>;
  const Aircraft<R>& aircraft = *c.aircraft;
  const FlightSetup<C>& setup = c.setup;
  const Options& o = setup.options;
  const C& mast_deg = setup.mast_deg;
  const C& flap_deg = setup.flap_deg;
  c.mast = mast_deg * kRadPerDeg<R>;
  c.air = surrounding_air(setup.altitude, c.around.warmer, c.around.pressure_above);
  const SineCosine<C> tilt = sine_and_cosine(c.mast);
  c.mass = mass_properties(aircraft, mast_deg, tilt, setup.mass, setup.sl_cg, setup.wl_cg, o);

  const MastTables<R>& mast = aircraft.mast;
  c.nacelle_axis_b = {tilt.sine, C(R(0)), -tilt.cosine};
  set_outside(c);
  c.pivot_arm_b = station_arm(c.mass, mast.sl_pivot, R(0), mast.wl_pivot);
  c.mass.nacelles =
      nacelle_motion(aircraft, o, setup.mass, tilt, c.pivot_arm_b, setup.mast_rate, setup.mast_acceleration);
  const SineCosine<C> cant = sine_and_cosine(o.mast_cant ? C(mast.cant * tilt.cosine) : C(R(0)));
  for (int side = 0; side < 2; ++side) {
    const Vec3<C> pivot =
        station_arm(c.mass, mast.sl_pivot, side_sign<R>(side) * mast.bl_pivot, mast.wl_pivot);
    c.hub[side] = hub_frame(tilt, cant, side, pivot, mast.length);
  }

  c.tip_speed = setup.rotor_speed * aircraft.rotor.radius;
  const C spin_up =
      static_cast<R>(aircraft.rotor.blades) * aircraft.rotor.flap_inertia * setup.rotor_acceleration;
  for (int side = 0; side < 2; ++side) {
    RotorSetting<C>& rotor = c.rotor[side];
    rotor.speed = setup.rotor_speed + (R(0.5) * side_sign<R>(side)) * setup.rotor_difference;
    rotor.tip_speed = rotor.speed * aircraft.rotor.radius;
    rotor.spin_up = spin_up;
  }
  c.coning = aircraft.rotor.coning.at(mast_deg);
  c.hub_spring = aircraft.rotor.hub_spring * static_cast<R>(o.hub_spring_factor);
  c.wing = wing_constants(aircraft, o, mast_deg, flap_deg);
  c.gearing = gearing(aircraft, o, mast_deg, tilt.cosine);

  c.pedal_mast[0] = grid_point(aircraft.controls.pedal_cyclic.linear[0], mast_deg);
  c.downwash_mast_flap[0] = grid_point(aircraft.wing.downwash.linear[0], mast_deg);
  c.downwash_mast_flap[1] = grid_point(aircraft.wing.downwash.linear[1], flap_deg);
  c.tail_wash_mast[0] = grid_point(aircraft.htail.rotor_wash.linear[0], mast_deg);
  c.tail_wash_beta_mast[0] = grid_point(aircraft.htail.rotor_wash_beta.linear[0], mast_deg);
  c.tail_pressure_mast[0] = grid_point(aircraft.htail.pressure_ratio.linear[0], mast_deg);
  c.sidewash_mast_flap[0] = grid_point(aircraft.fin.sidewash.linear[0], mast_deg);
  c.sidewash_mast_flap[1] = grid_point(aircraft.fin.sidewash.linear[1], flap_deg);
}

template <class C>
RotorConditions<C> rotor_conditions(const Configuration<C>& c, int side) {
  return {c.rotor[side], c.air.density, c.air.speed_of_sound};
}

// Another setting in the same flight: `c` becomes what prepare() makes of it with the same aircraft and options,
// bit for bit. Status out_of_range: `setting` lies outside the ranges given there, `c` is as it was;
// bad_argument: `c` is not prepared. Cost: a twentieth of a derivative on the real-time grid.
template <class R>
Status reconfigure(const ConfigurationSetting<R>& setting, Configuration<R>& c) {
  if (c.aircraft == nullptr) return Status::bad_argument;
  FlightSetup<R> setup = c.setup;
  static_cast<ConfigurationSetting<R>&>(setup) = setting;
  if (first_out_of_range(*c.aircraft, setup).field != SetupField::none) return Status::out_of_range;
  c.setup = setup;
  configure(c);
  return Status::ok;
}

}  // namespace tiltrotor

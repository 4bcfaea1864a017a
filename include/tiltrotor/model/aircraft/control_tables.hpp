// Controls, engines and limits of the aircraft, its default setup and the first guess of its trim.
#pragma once

#include "tiltrotor/math/tables/table.hpp"

namespace tiltrotor {

template <class R>
struct ControlTables {
  Table<R, 1> long_cyclic;                  // 8a-I: rad/in against mast (deg)
  Table<R, 1, 1> pedal_cyclic;              // 8a-II: rad/in against airspeed (kt); linear axis mast (deg)
  Table<R, 1> lateral_collective;           // 8a-III: rad/in against mast (deg)
  Table<R, 1> lateral_cyclic_gain;          // 8a-VII: gain against mast (deg)
  Table<R, 1> lateral_cyclic;               // 8a-VIII: rad against airspeed (kt)
  R cyclic_rigging;                         // cyclic_rigging, longitudinal, + disks forward, rad
  R elevator;                               // elevator_gearing, rad/in
  R elevator_replay;                        // choices: elevator_gearing_replay (4.735 deg/in), rad/in
  R aileron;                                // aileron_gearing_mean, rad/in
  R rudder;                                 // rudder_gearing, rad/in
  R long_travel, lat_travel, pedal_travel;  // half travel, in
  R elevator_limit, rudder_limit, aileron_limit;  // rad (aileron: mean of flaperon roll limits)
  R flap_limit;                                   // rotor_flap_limit: gimbal tilt, rad
  R power_limit;                                  // transmission_limit_helicopter, one rotor, W
  R engine_power, engine_power_continuous;        // engine_power_takeoff, ..., one engine at sea level, W
  int engines;                                    // engine_count
  R transmission_efficiency;                      // rotors' over engines' power
  R engine_lapse;                                 // choices: engine_lapse, 0 none or 1
  R mast_torque;                                  // mast_torque_steady: largest steady torque of a mast, N m
};

template <class R>
struct Bounds {
  R low, high;
};

// What the model takes; all from choices.csv but the flap angles, which are those of the flap settings.
template <class R>
struct LimitTables {
  Bounds<R> mast_deg;            // mast_min, mast_max
  Bounds<R> mast_rate;           // mast_rate_min, mast_rate_max, rad/s
  Bounds<R> mast_acceleration;   // mast_acceleration_min, mast_acceleration_max, rad/s^2
  Bounds<R> flap_deg;            // first and last flap setting
  Bounds<R> rotor_speed;         // rotor_speed_min, rotor_speed_max, rad/s
  Bounds<R> rotor_acceleration;  // rotor_acceleration_min, rotor_acceleration_max, rad/s^2
  Bounds<R> altitude;            // altitude_min, altitude_max, m
  Bounds<R> mass;                // mass_min, mass_max, kg
  Bounds<R> sl_cg;               // cg_station_min, cg_station_max, at mast 0, m
  Bounds<R> wl_cg;               // cg_waterline_min, cg_waterline_max, at mast 0, m
  R speed;  // speed_max: of a steady flight, and along and across the shaft of a rotor alone, m/s
  Bounds<R> collective;  // collective_min, collective_max: of a command, rad
  R increment;           // increment_max: of a command on a blade or surface, rad
  R gust;                // gust_max: of a command, m/s
  R wind;                // wind_max: of the air over the ground, each component, m/s
  R gust_rate;           // gust_rate_max, rad/s
  R warmer;              // warmer_max: than the standard atmosphere, either way, K
  R pressure_above;      // pressure_above_max: of it, either way
  R outside_force,
      outside_moment;  // outside_force_max, N, outside_moment_max about the stations' origin, N m
};

// Setup where nothing else is asked for; its mass and CG are those of MassTables.
template <class R>
struct DefaultTables {
  R flap_helicopter;  // choices: default_flap_helicopter, at mast 0, deg
  R flap_conversion;  // choices: default_flap_conversion, between, deg
  R flap_airplane;    // choices: default_flap_airplane, at mast 90, deg
};

// First guess of a trim, from choices.csv: where the search begins, no part of its result.
template <class R>
struct TrimGuessTables {
  R wing_speed;            // guess_wing_speed: from here on the wing carries all it will, m/s
  R hover_load;            // guess_hover_load: thrust over weight, for the download
  R wing_load;             // guess_wing_load: weight that the wing takes at mast 90
  R hover_inflow;          // guess_hover_inflow: mean inflow over tip speed
  R pitch_helicopter_deg;  // guess_pitch_helicopter, below WingTables::borne_mast_deg
  R pitch_airplane_deg;    // guess_pitch_airplane, above
  R blade_angle_deg;       // guess_blade_angle: pitch at the reference radius above the inflow angle, mast 90
  R blade_angle_hover_deg;  // guess_blade_angle_hover: more of it at mast 0
  R stick_step;             // guess_stick_step: largest step of the search, in
};

}  // namespace tiltrotor

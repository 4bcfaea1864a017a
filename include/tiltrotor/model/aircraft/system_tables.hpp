// Systems of the aircraft: conversion, drive, engines, governor, actuators and augmentation. Substitutes, where no
// number of the aircraft is published: choices.csv says which and why.
#pragma once

#include "tiltrotor/math/tables/table.hpp"

namespace tiltrotor {

template <class R>
struct ConversionTables {
  R rate;           // conversion_rate, of the masts, rad/s
  R acceleration;   // conversion_acceleration, largest of the masts, rad/s^2
  R position_gain;  // choices: conversion_position_gain, 1/s
  R rate_gain;      // choices: conversion_rate_gain, 1/s
  R flap_rate;      // choices: flap_rate, rad/s
  R flap_gain;      // choices: flap_gain, 1/s
};

// Referred to the masts.
template <class R>
struct DriveTables {
  R turbine_inertia;         // choices: turbine_inertia, of the power turbine of one engine, kg m^2
  R interconnect_stiffness;  // choices: interconnect_stiffness, torque per angle between the masts, N m/rad
  R power_lag;               // choices: engine_lag, s
  R power_rate;              // choices: engine_rate, of one engine, W/s
  R contingency;             // engine_power_contingency, of one engine at sea level, W
  R fuel_per_energy;         // engine_fuel_takeoff, kg/J
  R fuel;                    // fuel_usable, kg
};

template <class R>
struct GovernorTables {
  R frequency;               // choices: governor_frequency, of the rotor speed with its governor, rad/s
  R damping;                 // choices: governor_damping, ratio
  R rate;                    // choices: governor_rate, largest of the collective, rad/s
  R authority;               // choices: governor_authority, either way, rad
  R stop;                    // choices: governor_stop, return from beyond it, 1/s
  Table<R, 1> proportional;  // rad for rotor speed wrong by the whole of it, against mast (deg)
  Table<R, 1> integral;      // rad/s likewise
};

template <class R>
struct ActuatorTables {
  R bandwidth;                                   // choices: actuator_bandwidth, rad/s
  R collective_rate, cyclic_rate, surface_rate;  // choices, rad/s
  R cyclic_limit;                                // choices: cyclic_stop, of the longitudinal cyclic, rad
};

template <class R>
struct AugmentationTables {
  Table<R, 1> pitch, roll, yaw;  // gains, in s/rad, against mast (deg)
  R pitch_authority, roll_authority,
      yaw_authority;                  // scas_authority_pitch .., of the half travel of stick and pedal
  R servo;                            // choices: scas_servo, rad/s
  R washout;                          // choices: scas_washout, s
  R attitude;                         // choices: scas_attitude_gain, 1/s
  R dead_band;                        // choices: scas_dead_band, in
  R hold_rate;                        // choices: scas_hold_rate: holds from below it, rad/s
  R turn_from, turn_full;             // choices: scas_turn_from, scas_turn_full, m/s
  R pitch_time, roll_time, yaw_time;  // scas_time_pitch .., of a rate's answer, s: gains are made for them
};

template <class R>
struct SystemWidths {
  R mast_rate;          // smooth_mast_rate, rad/s
  R mast_acceleration;  // smooth_mast_acceleration, rad/s^2
  R actuator_rate;      // smooth_actuator_rate, rad/s
  R actuator_angle;     // smooth_actuator_angle, rad
  R stick;              // smooth_stick, in
  R power;              // smooth_shaft_power, W
  R power_rate;         // smooth_power_rate, W/s
};

template <class R>
struct SystemTables {
  ConversionTables<R> conversion;
  DriveTables<R> drive;
  GovernorTables<R> governor;
  ActuatorTables<R> actuator;
  AugmentationTables<R> augmentation;
  SystemWidths<R> smooth;
};

}  // namespace tiltrotor

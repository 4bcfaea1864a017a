/* tiltrotor: the systems around the airframe: conversion drive and flaps, engines, drive train and governor, hydraulic
 * actuators, stability augmentation; gear and ground; turbulence and wind shear. Part of tiltrotor.h, which includes it; the same rules hold. Laws and numbers,
 * and which of them are substitutes: include/tiltrotor/systems/README.md. */
#ifndef TILTROTOR_SYSTEMS_H
#define TILTROTOR_SYSTEMS_H

#include "tiltrotor/tiltrotor.h"

#ifdef __cplusplus
extern "C" {
#endif
#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif

typedef enum tr_governor {
  TR_GOVERNOR_OFF = 0, /* rotor speed and collective are as set; the power is what they take */
  TR_GOVERNOR_IDEAL =
      1,             /* rotor speed as set; the collective takes the power of the engines, at every moment */
  TR_GOVERNOR_PI = 2 /* rotor speed is a state; the governor adds collective to hold rotor_command_radps */
} tr_governor;

typedef enum tr_wind_shear {
  TR_SHEAR_NONE = 0, /* the same wind at every height */
  TR_SHEAR_TERMINAL =
      1,             /* growing with height over the ground as MIL-F-8785C has it in terminal flight phases */
  TR_SHEAR_OTHER = 2 /* and in all others: a rougher ground */
} tr_wind_shear;

/* Switches, and commands that may change at any time. With every switch off the aircraft flies as without systems, bit
 * for bit. */
typedef struct tr_systems {
  int32_t governor;   /* tr_governor */
  int32_t conversion; /* 1: masts and flaps follow their commands at the rates of their drives; 0: as set */
  int32_t engines;    /* 1: power follows the throttles with lag and rate limit and burns fuel; 0: at once */
  int32_t actuators;  /* 1: blades and surfaces follow with lag, rate limit and stops; 0: at once */
  int32_t scas;       /* 1: rate damping and attitude hold, limited authority; switched off it fades */
  int32_t gear;       /* 1: wheels on the ground of tr_environment, and the drag of a gear that is down */
  int32_t ground_effect; /* 1: of the ground of tr_environment on rotors and download */
  int32_t turbulence;    /* 1: Dryden turbulence at rotors, wing and tail, a function of seed and steps */
  int32_t interconnect;  /* 1: with TR_GOVERNOR_PI the shaft between the rotors twists, each has its speed */
  int32_t
      wind_shear; /* tr_wind_shear: wind_mps of tr_environment, its level part, is that 20 ft above the ground
                            there; 3 to 1000 ft, constant beyond; without a ground none */
  tr_real mast_command_deg;    /* 0..90 */
  tr_real flap_command_deg;    /* 0..75 */
  tr_real rotor_command_radps; /* of the governor, 20..80 */
  tr_real throttle[2]; /* power of an engine, right and left, over its take-off power here, 0..1.2; held at
                                  the contingency power, 1.16 */
  int32_t
      gear_down; /* 1: down. It is on its way for some seconds (TR_GEAR), and carries when it is locked down; raised on
                          the wheels (TR_ON_GROUND) it unlocks at once and leaves nothing to stand on */
  int32_t engine_failed[2]; /* 1: it gives no power, and its turbine is off the shaft */
  uint64_t turbulence_seed;
  tr_real
      turbulence_w20_mps; /* wind 20 ft above the ground, which says how strong it is, 0..50: 7.7 light, 15.4
                                  moderate, 23.1 severe */
  tr_real brake[2];       /* of the main wheels, right and left, 0..1 */
} tr_systems;

/* Places of their states in tr_state.x; all 0 while their system is off, and not read by tr_set_state then. */
enum {
  TR_MAST_RATE = TR_MAST + 1, /* rad, rad/s */
  TR_FLAP,                    /* rad */
  TR_ROTOR_SPEED,             /* mean of the two, rad/s */
  TR_SHAFT_TWIST,             /* right rotor ahead of the left one, rad */
  TR_TWIST_RATE,              /* rad/s */
  TR_POWER_RIGHT,
  TR_POWER_LEFT, /* of the engines at their shafts, W */
  TR_GOVERNOR,   /* collective it adds, rad */
  TR_FUEL, /* burnt, kg: the mass of tr_configuration falls with it, within its range; below 0 more is on board */
  TR_ACTUATORS, /* collective right, left; long. cyclic right, left; elevator, aileron, rudder; rad */
  TR_SERIES_ACTUATORS = TR_ACTUATORS + 7, /* of the augmentation: longitudinal, lateral, yaw, in */
  TR_WASHOUT = TR_SERIES_ACTUATORS + 3,   /* yaw rate it has become used to, rad/s */
  TR_HELD_PITCH,
  TR_HELD_ROLL, /* rad */
  TR_HOLDS_PITCH,
  TR_HOLDS_ROLL, /* 1: the attitude is held */
  TR_REST_LONG,
  TR_REST_LAT, /* where the stick rests, in */
  TR_GEAR, /* extension, 0 retracted .. 1 locked down, where wheels carry. Steps move it, not tr_derivative: for an
                     integrator of your own place it by tr_set_state */
  TR_GUST_FILTERS /* 16 of the turbulence */
};

/* Everything off, engines sound; commands of helicopter mode. TR_BAD_ARGUMENT. */
tr_status tr_default_systems(tr_systems* systems);

/* As they are; after tr_init off, with commands that are the setup's. TR_BAD_ARGUMENT. Cost: a copy. */
tr_status tr_get_systems(const tr_sim* sim, tr_systems* systems);

/* In force from the next step. A system that is switched on begins where the aircraft is: masts, flaps and rotor speed
 * as set, actuators at what is asked of them, engines at the power that is demanded, augmentation at neutral with the
 * sticks where they are. While the conversion drive is on, rates of tr_configuration are its own; while the rotor speed
 * is a state, its acceleration is. A governor that takes over from another goes on from the collective that it had added;
 * one that is switched off leaves it to the caller, who adds TR_GOVERNOR of tr_state to its own. tr_trim sets states, commands of masts, flaps and rotor speed, and throttles so that
 * all stand still where the flight does, in a wind that does not grow with height; engines share the power. Drag of the gear and ground effect belong to a trim,
 * wheels on the ground do not.
 * When wind_shear changes the aircraft keeps its velocity over the ground, as with tr_set_environment. A gear that is
 * switched on is where it is told to be.
 * TR_NOT_FINITE, TR_OUT_OF_RANGE (also of that velocity), TR_BAD_ARGUMENT (an unknown choice): nothing is changed. Cost: 1 derivative.
 *
 * With systems on: a step takes 3 or 4 derivatives a part as before and a twentieth of one more for each, with an ideal
 * governor some five times as many. tr_linearize covers their states, takes 2 Jacobians where masts, rotor speed, air or
 * ground move (3 with TR_ALL_INPUTS), and holds the turbulence, whose scale follows the height.
 * tr_trim takes up to 6 of its trims where gear or ground count. tr_directional
 * takes a Jacobian and a quarter, tr_linearize_outputs as much and for every 15 of its columns one and a half derivatives (without vectors for
 * every 7 one); with an ideal governor
 * these three take some 10 derivatives more. The last two know every state of
 * tr_state then, fuel, position and attitude that is held included, and hold the turbulence alone. Where an
 * ideal governor finds no collective all of these are TR_NOT_CONVERGED. Modes of systems are named after the state that
 * takes part most; on a microcontroller tr_work is too small for them: tr_modes is TR_BAD_ARGUMENT
 * there, tr_eigenvalues has the roots. */
tr_status tr_set_systems(tr_sim* sim, const tr_systems* systems);

/* Which field tr_set_systems would refuse, in one line: "throttle[1] 1.5 lies outside 0..1.2", "throttle[1] is no finite
 * number, which lies in 0..1.2"; its status, the velocity apart. `text` and `length` as with tr_check_setup.
 * TR_WRONG_VERSION, TR_BAD_ARGUMENT (also of an unknown choice, which the line names), TR_NOT_FINITE, TR_OUT_OF_RANGE.
 * Cost: a few comparisons. */
tr_status tr_check_systems(const tr_systems* systems, uint32_t version, char* text, size_t length);

/* tr_directional with the commands of tr_systems as well: `du` holds TR_INPUTS numbers, controls and then commands as
 * tr_linearize counts them with TR_ALL_INPUTS, mast and flap in rad. Commands of systems that are off change nothing. */
tr_status tr_directional_inputs(const tr_sim* sim, tr_work* work, const tr_real* dx, const tr_real* du,
                                tr_real* dxdot, tr_outputs* doutputs);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif

#endif

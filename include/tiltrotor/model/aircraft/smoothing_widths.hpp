// Widths of the smoothing primitives.
#pragma once

#include "tiltrotor/math/arithmetic.hpp"

namespace tiltrotor {

// Widths of the smoothing primitives (smooth.hpp); every one in choices.csv with its reason.
template <class R>
struct SmoothingWidths {
  R section_speed;        // m/s: blade section speed
  R inflow_speed;         // over tip speed: V_T of the inflow law
  R through_flow;         // over tip speed: positive part of the through-flow
  R advance_ratio;        // over tip speed: |mu|
  R forward_speed;        // m/s added to U under alpha = atan2(W, U + e)
  R lateral_plane_speed;  // m/s: sqrt(U^2 + W^2 + e^2) under sideslip
  R airspeed;             // m/s: total speed
  R rate_speed;           // m/s: reference speed of the rate derivatives
  R mach_limit, mach;     // M held below mach_limit with width mach
  R angle;                // rad: |beta|, |delta| and their thresholds
  R advance_floor;        // width of the floor under mu
  R wake_axis;            // m/s
  R wake_plane;           // - : length of the wake direction in the x-z plane
  R wake_distance;        // /R: distance downstream in K(s)
  R wake_radius;          // m/s: flow ratio of the contraction law
  R wake_cut;             // /R: half chord of the wake circle, and clips at fuselage and tip
  R wake_start;           // /R: distance over which the wing enters the wake
  R engine_power;         // W: power of engines that the rotors drive
  R crossflow;            // rad: norm in the cross-flow law
  R crossflow_clip;       // deg: clip of alpha in the cross-flow law
  R drag_speed;           // m/s: length of the velocity along which spinner and pylon drag act
  R spinner_sine;         // - : sin^2 under its square root
  R side_plate_speed;     // m/s: |v| of the side plate angle
  R side_plate_axial;     // m/s: axial speed of the side plate angle
  R stall_delay_lift;     // - : smooth positive part of the lift lost by stall
  R stall_delay_start;    // deg above zero lift over which stall delay fades in
  R stall_delay_fade;     // deg: angle of attack from which it fades out
  R stall_delay_end;      // deg: over which it fades out
  R rear_flow_start;      // rad: |alpha| from which laws without a rear side go over to their mean there
  R gear_contact;         // m: compression over which a wheel begins to carry
  R gear_stop;            // m: stroke over which an oleo meets its stop
  R gear_force;           // N: force below which a strut that rebounds lets go
  R gear_cosine;          // - : limit of the tilt of a strut
  R ground_height;        // /R: floor under the height of a hub
  R ground_wash;          // m/s: induced speed under the advance ratio in ground effect
};

}  // namespace tiltrotor

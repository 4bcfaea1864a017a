// Landing gear, and what the ground does to the rotors.
#pragma once

#include "tiltrotor/math/arithmetic.hpp"

namespace tiltrotor {

template <class R>
struct StrutTables {
  R sl, bl;          // gear_*_SL, gear_*_BL: of the wheels, m; bl of the right one
  R stroke;          // gear_*_stroke, m
  R oleo_stiffness;  // choices: gear_*_oleo_stiffness, N/m
  R oleo_damping;    // choices: gear_*_oleo_damping, N s/m
  R tyre_stiffness;  // choices: gear_*_tyre_stiffness, of all tyres of the strut, N/m
};

template <class R>
struct GearTables {
  StrutTables<R> nose, main;
  R ground_wl;                        // ground_WL_static: of the ground under the aircraft at rest, m
  R static_stroke;                    // choices: gear_static_stroke: part of the stroke used there
  R rolling, braking, side_friction;  // choices: gear_friction_*: friction over normal force
  R slip_speed;                       // choices: gear_slip_speed: over which friction saturates, m/s
  R least_cosine;        // choices: gear_least_cosine: of the angle between strut and the ground's normal
  R drag_area, drag_wl;  // choices: gear_drag_area, m^2, gear_drag_WL, m
  R transit;             // choices: gear_transit: from one end to the other, s
};

template <class R>
struct GroundTables {
  R hub_height_on_gear;    // m: mast 0
  R least_height;          // choices: ground_least_height, over radius: a hub acts as if not lower
  R fade_start, fade_end;  // choices: ground_fade_*, over radius: between them the ground's effect ends
  R download_on_gear;      // choices: ground_download_on_gear: part of the download left there
  R download_end;  // choices: ground_download_end, over radius: height of the hub from which all is left
};

}  // namespace tiltrotor

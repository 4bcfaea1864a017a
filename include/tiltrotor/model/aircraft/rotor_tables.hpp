// Rotors, inflow and wake of the aircraft.
#pragma once

#include "tiltrotor/math/tables/table.hpp"
#include "tiltrotor/model/aircraft/mast_range.hpp"

namespace tiltrotor {

inline constexpr int kSectionRegions = 4;  // spanwise regions of the blade section tables

template <class R>
struct RotorTables {
  int blades;                          // rotor_blades
  R radius;                            // rotor_radius, m
  R flap_inertia;                      // rotor_blade_flap_inertia, one blade about the gimbal, kg m^2
  R speed_helicopter;                  // rotor_rpm_helicopter, rad/s
  R speed_airplane;                    // rotor_rpm_airplane, rad/s
  R delta3;                            // rotor_delta3, rad
  R precone;                           // rotor_precone, rad
  R root_cutout;                       // rotor_root_cutout, r/R
  R hub_spring;                        // choices: hub_spring, N m/rad per rotor
  R hub_damping;                       // choices: hub_damping, N m s/rad
  R coning_frequency;                  // choices: coning_frequency, per rev
  MastRange<R> coning;                 // choices: coning_mast0, coning_mast90, rad
  R tip_loss;                          // choices: tip_loss, r/R beyond which lift is lost
  R taper_end;                         // choices: blade_taper_end, r/R: last kink of the chord
  R lift_slope;                        // choices: section_lift_slope, 1/rad, only for first-order flapping
  R region_edge[kSectionRegions - 1];  // choices: section_region_edge_1..3, r/R
  R twist_reference;                   // choices: twist_reference, r/R where collective is measured (0.75)
  Table<R, 1> twist;                   // blade_twist.csv: rad against r/R
  Table<R, 1> chord_cutout;            // blade_chord.csv chord_cutout_in: m against r/R
  Table<R, 1> chord_text;              //   chord_text_in
  Table<R, 1> chord_camrad;            //   chord_camrad_in
  R twist_linear;                      // rotor_twist_linear_A: root to tip, rad
  Table<R, 2> section_lift[kSectionRegions];  // c81_regionN_*_cl: cl against alpha (deg), Mach
  Table<R, 2> section_drag[kSectionRegions];  // c81_regionN_*_cd
  R stall_blend;                 // choices: section_stall_blend, width of the blend to a flat plate, deg
  R plate_lift;                  // choices: plate_lift: cl = plate_lift sin 2 alpha
  R plate_drag_min, plate_drag;  // choices: cd = plate_drag_min + plate_drag sin^2 alpha
  Table<R, 1> side_by_side;      // t1-III: X_SS against advance ratio
  Table<R, 1> sideward;          // t1-II lower part: X_SF against sideward speed over tip speed
};

template <class R>
struct InflowTables {
  R apparent_mass_uniform;  // choices: 8/(3 pi)
  R apparent_mass_loaded;   // choices: 128/(75 pi), the alternative
  R apparent_mass_cyclic;   // choices: 16/(45 pi)
  R induced_power;          // choices: induced_power_factor (kappa_i)
  R shape_thrust;           // choices: inflow_shape_thrust, C_T of the hover that gives the radial shape
  R shape_tip_mach;         // choices: inflow_shape_tip_mach, of the same hover
  R shape_descent;          // choices: inflow_shape_descent, over lambda_0, from which the shape fades
  R windmill_descent;       // choices: over v_h, where the windmill's momentum theory begins
  R ring_in_plane;          // choices: in-plane speed over induced velocity where vortex ring has faded
};

// Rotor wake on the wing and the immersed part of the wing.
template <class R>
struct WakeTables {
  R axis_speed_factor;               // choices: wake_axis_speed_factor (kd 1.5)
  R fuselage_side;                   // choices: wake_fuselage_side (yF), m
  R fade_start, fade_end;            // choices: wake_fade_start, wake_fade_end, m/s
  R fade_mast_start, fade_mast_end;  // choices: wake_fade_mast_start, wake_fade_mast_end, deg
  R wash_factor;                     // induced_wing_factor_K0 (K_w)
  MastRange<R> load_factor;          // choices: wake_load_factor_mast0, wake_load_factor_mast90 (K_FW)
  R gtrs_load_factor_0;              // K_FW0
  R gtrs_load_factor_flap;           // K_FW_dF, 1/deg
  R gtrs_area;                       // slipstream_area_max, one side, m^2
  R gtrs_end_speed;                  // slipstream_end_speed, m/s
  R gtrs_angle_a, gtrs_angle_b;      // slipstream_angle_a, slipstream_angle_b
};

}  // namespace tiltrotor

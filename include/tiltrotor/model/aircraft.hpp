// The aircraft as plain numbers, SI units and radians, filled from tables/<aircraft>/ by the table generator.
//
// Table ordinates are SI; table abscissae keep the unit of the source (degrees, knots, Mach number), so that
// they can be compared with it. Stations: SL aft, BL right, WL up, here in metres. Mast angle 0 is
// helicopter, 90 deg airplane. Every field names the entry of aircraft.csv or choices.csv (or the table) it
// comes from.
#pragma once

#include "tiltrotor/math/tables/table.hpp"

namespace tiltrotor {

inline constexpr int kFlapSettings = 4;    // FL1..FL4 = 0/0, 20/12.5, 40/25, 75/47 deg flap/flaperon
inline constexpr int kSectionRegions = 4;  // spanwise regions of the blade section tables

// Values at mast angle 0 and 90 deg that change linearly between.
template <class R>
struct MastRange {
  R at_0;
  R at_90;
  template <class C>
  C at(const C& mast_deg) const {
    return at_0 + (at_90 - at_0) * (mast_deg / R(90));
  }
};

template <class R>
struct Inertia {  // moments and product of inertia about the CG, kg m^2; xz = integral of x z dm
  R xx, yy, zz, xz;
};

template <class R>
struct MassTables {
  R gross;                   // weight_gross, kg
  R nacelles;                // weight_pylons_both, kg: the part that tilts
  R sl_cg, wl_cg;            // SL_CG_aft_helicopter, WL_CG_helicopter: CG at mast 0, m
  R sl_nacelle, wl_nacelle;  // SL_pylon_CG, WL_pylon_CG: CG of the tilting part at mast 0, m
  Inertia<R> inertia;        // Ixx_0 .. Ixz_0 at mast 0, for the gross weight
  Inertia<R> inertia_slope;  // dIxx_dbm .. dIxz_dbm, kg m^2 per degree of mast angle
  Inertia<R> design_0;       // I.._helicopter_1975: 1975 design estimate (xz of the set above)
  Inertia<R> design_90;      // I.._airplane_1975
};

template <class R>
struct MastTables {
  R sl_pivot, bl_pivot, wl_pivot;  // conversion axis, m
  R length;                        // mast_length, pivot to hub, m
  R cant;                          // mast_outboard_tilt_phi_m, outboard tilt at mast 0, rad
};

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

template <class R>
struct WingTables {
  R area;                              // wing_area, m^2
  R span;                              // wing_span, m
  R chord;                             // wing_chord, m
  R sweep;                             // wing_sweep, rad
  R sl, bl, wl;                        // SL_wing_pylon_ref, BL_wing_ref, WL_wing_ref, m
  R flap_deg[kFlapSettings];           // flap angle of FL1..FL4, deg (choices: flap_setting_1..4)
  Table<R, 1> lift_0[kFlapSettings];   // CL at mast 0 against alpha (deg): 4-I/4-II with the extension
  Table<R, 2> lift_90[kFlapSettings];  // CL at mast 90 against alpha, Mach (Mach only at FL1)
  Table<R, 1> drag_0[kFlapSettings];   // CD likewise: 4-III/4-IV
  Table<R, 2> drag_90[kFlapSettings];
  Table<R, 1, 2> downwash;            // 4-V: rad against alpha (deg); linear axes mast (deg), flap (deg)
  Table<R, 1, 1> moment;              // 4-VIII: Cm against mast (deg); linear axis flap (deg)
  Table<R, 1, 1> roll_beta;           // 4-VI: Cl_beta at zero lift, 1/rad
  Table<R, 1, 1> roll_beta_per_lift;  // 4-VII: Cl_beta / CL, 1/rad
  Table<R, 1, 1> zero_lift_drag;      // 4-X part 1: CD0
  Table<R, 1, 1> aileron_roll;        // 4-XI: K_l
  Table<R, 1, 1> aileron_yaw_0;       // 4-XIII: K_n0, 1/rad
  Table<R, 1, 1> aileron_yaw;         // 4-XIV: K_n
  Table<R, 1> aileron_lift_loss;      // 4-XII: CL_delta_a, 1/rad, against flap (deg)
  R aileron_roll_slope;               // Cl_delta_a, 1/rad
  R roll_rate;                        // Cl_p_wing
  R roll_yaw_rate_per_lift;           // Cl_r_over_CL
  R roll_yaw_rate_flap;               // dCl_r_flap, 1/deg
  R flap_alpha;                       // dalpha_dflap
  R yaw_beta_0;                       // Cn_beta_0
  R yaw_beta_per_lift2;               // Cn_beta_over_CL2
  R yaw_rate_per_lift2;               // Cn_r_over_CL2
  R yaw_rate_per_drag;                // Cn_r_over_CD0
  R yaw_roll_rate_per_lift;           // Cn_p_over_CL
  R rotor_wash_0, rotor_wash_1, rotor_wash_2;  // X_RW0 (-), X_RW1 (1/deg), X_RW2 (1/deg^2)
  R rotor_wash_angle;                          // K_XRW
  R rotor_wash_lift;                           // K_RW
  R advance_floor;                             // choices: advance_floor (0.15)
  R aileron_full_alpha, aileron_zero_alpha;    // choices: 8 deg, 25 deg
  R crossflow_alpha_limit;                     // choices: crossflow_alpha_limit, deg (25)
  R downwash_arm;                              // choices: downwash_arm (l_t), m
  R downwash_speed_floor;                      // choices: downwash_speed_floor, m/s
};

template <class R>
struct PylonTables {
  Table<R, 1> interference;  // 4-XV: drag area against mast angle (deg), m^2
  Table<R, 1> side_plate;    // 4-XVI: K_PLAT against mast incidence (deg)
  R side_area;               // pylon_area_S_PYL, m^2
  R spinner_base;            // spinner_drag_area_base, m^2, each
  R spinner_cross;           // spinner_drag_area_cross, m^2, each
};

template <class R>
struct FuselageTables {
  R sl, wl;                             // SL_fuselage_ref, WL_fuselage_ref, m
  Table<R, 1> lift_alpha, drag_alpha;   // 3-I, 3-III: m^2 against alpha (deg)
  Table<R, 1> moment_alpha;             // 3-V: m^3
  Table<R, 1> lift_beta, drag_beta;     // 3-II, 3-IV: m^2 against |beta| (deg)
  Table<R, 1> moment_beta;              // 3-VI: m^3 against |beta| (deg)
  Table<R, 1> side_beta;                // 3-VII: m^2 against beta (deg), odd half written out
  Table<R, 1> roll_beta, yaw_beta;      // 3-VIII, 3-IX: m^3 against beta (deg), odd half written out
  R lift_zero, drag_zero, moment_zero;  // fuselage_L0, D0 (m^2), M0 (m^3): counted twice in the sums
  R extra_drag;                         // choices: fuselage_extra_drag, m^2
};

// What both tail surfaces have in common.
template <class R>
struct TailSurface {
  R area;          // m^2, one panel
  R sl, bl, wl;    // m; bl of the right fin, 0 for the horizontal tail
  R incidence;     // rad
  R control_tau;   // tau_e, tau_r
  R control_loss;  // D_Ke, D_Kr
};

template <class R>
struct HorizontalTailTables {
  TailSurface<R> surface;
  R lift_beta;                     // htail_CL_beta, 1/rad
  MastRange<R> pressure;           // choices: htail_pressure_mast0 (1), htail_K_HNU at mast 90
  R beta_limit;                    // choices: htail_beta_limit, deg (15)
  Table<R, 2, 1> rotor_wash;       // 2-I: K_WH against alpha (deg), speed (kt); linear axis mast (deg)
  Table<R, 1, 1> rotor_wash_beta;  // 2-II: factor against |beta| (deg); linear axis mast
  R wash_fit[5];                   // choices: htail_wash_fit_0..4 (closed-form alternative of 2-I)
  R wash_fit_speed;                // choices: htail_wash_fit_speed, ft/s
  Table<R, 2> lift_elevator;       // 5-I: CL against alpha (deg), elevator (deg)
  Table<R, 2> lift_mach;           // 5-II with elevator 0 of 5-I below M 0.2: CL against alpha, Mach
  Table<R, 2> drag;                // 5-III: CD against alpha, Mach
  Table<R, 2, 1> pressure_ratio;   // 5-V: q ratio against alpha (deg), speed (kt); linear axis mast
};

template <class R>
struct FinTables {
  TailSurface<R> surface;
  R area_other;                   // vtail_area_panel (20.25 ft^2), the conflicting source
  R pressure;                     // vtail_K_VNU
  R pressure_ratio;               // choices: fin_pressure_ratio (eta_V)
  R lift_slope;                   // vtail_lift_slope, 1/rad
  R sidewash_roll, sidewash_yaw;  // vtail_dsigma_dphat, vtail_dsigma_drhat
  R speed_floor;                  // choices: fin_speed_floor (35 ft/s), m/s
  Table<R, 2> side_rudder;        // 6-I: CY against beta (deg), rudder (deg)
  Table<R, 2> side_mach;          // 6-II with rudder 0 of 6-I below M 0.2: CY against beta, Mach
  Table<R, 2> drag;               // 6-III: CD against beta, Mach
  Table<R, 2, 2>
      sidewash;  // 6-IV..VII: 1 - dsigma/dbeta against alpha, |beta| (deg); linear mast, flap (deg)
  Table<R, 2> rotor_sidewash;  // 6-VIII: K_betaR against speed (kt), |beta| (deg)
};

template <class R>
struct TailSharedTables {
  Table<R, 1> control_mach;            // 5-IV: X_Ke = X_Kr against Mach
  Table<R, 1> sideslip_loss;           // 5-VI: K_beta against |beta| (deg)
  R control_loss_start;                // choices: control_loss_start, deg (15)
  R mach_blend_start, mach_blend_end;  // choices: tail_mach_blend_start, tail_mach_blend_end
};

template <class R>
struct ControlTables {
  Table<R, 1> long_cyclic;                  // 8a-I: rad/in against mast (deg)
  Table<R, 1, 1> pedal_cyclic;              // 8a-II: rad/in against airspeed (kt); linear axis mast (deg)
  Table<R, 1> lateral_collective;           // 8a-III: rad/in against mast (deg)
  Table<R, 1> lever;                        // 8a-IV: rad/in
  Table<R, 1> collective_floor;             // 8a-IV: lower limit of the pitch at 0.75 R, rad
  Table<R, 1> lateral_cyclic_gain;          // 8a-VII: gain against mast (deg)
  Table<R, 1> lateral_cyclic;               // 8a-VIII: rad against airspeed (kt)
  R elevator;                               // elevator_gearing, rad/in
  R elevator_replay;                        // choices: elevator_gearing_replay (4.735 deg/in), rad/in
  R aileron;                                // aileron_gearing_mean, rad/in
  R rudder;                                 // rudder_gearing, rad/in
  R long_travel, lat_travel, pedal_travel;  // half travel, in
  R lever_travel;                           // collective_travel, in
  R elevator_limit, rudder_limit, aileron_limit;  // rad (aileron: mean of flaperon roll limits)
  R flap_limit;                                   // rotor_flap_limit: gimbal tilt, rad
  R power_limit;                                  // transmission_limit_helicopter, one rotor, W
  R engine_power, engine_power_continuous;        // engine_power_takeoff, ..., one engine at sea level, W
  R transmission_efficiency;                      // rotors' over engines' power
  R engine_lapse;                                 // choices: engine_lapse, 0 none or 1
  R mast_torque;                                  // mast_torque_steady: largest steady torque of a mast, N m
};

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
  R crossflow;            // rad: norm in the cross-flow law
  R crossflow_clip;       // deg: clip of alpha in the cross-flow law
  R drag_speed;           // m/s: length of the velocity along which spinner and pylon drag act
  R spinner_sine;         // - : sin^2 under its square root
  R side_plate_speed;     // m/s: |v| of the side plate angle
  R side_plate_axial;     // m/s: axial speed of the side plate angle
  R rear_flow_start;      // rad: |alpha| from which laws without a rear side go over to their mean there
};

template <class R>
struct Aircraft {
  MassTables<R> mass;
  MastTables<R> mast;
  RotorTables<R> rotor;
  InflowTables<R> inflow;
  WakeTables<R> wake;
  WingTables<R> wing;
  PylonTables<R> pylon;
  FuselageTables<R> fuselage;
  HorizontalTailTables<R> htail;
  FinTables<R> fin;
  TailSharedTables<R> tail;
  ControlTables<R> controls;
  SmoothingWidths<R> smooth;
};

}  // namespace tiltrotor

// Wing, pylons, fuselage and tail surfaces of the aircraft.
#pragma once

#include "tiltrotor/math/tables/table.hpp"
#include "tiltrotor/model/aircraft/mast_range.hpp"

namespace tiltrotor {

inline constexpr int kMostFlapSettings = 6;

// Three quarters of the numbers of a table of two smooth axes are slopes. Built with TILTROTOR_SINGLE_SLOPES
// (`make SLOPES=single`, as the firmware is) they are stored in single precision.
#ifdef TILTROTOR_SINGLE_SLOPES
template <class R, int Smooth, int Linear = 0>
using AirframeTable = Table<R, Smooth, Linear, SplitNodes<R, Smooth>>;
#else
template <class R, int Smooth, int Linear = 0>
using AirframeTable = Table<R, Smooth, Linear>;
#endif

template <class R>
struct WingTables {
  R area;                         // wing_area, m^2
  R span;                         // wing_span, m
  R chord;                        // wing_chord, m
  R sweep;                        // wing_sweep, rad
  R sl, bl, wl;                   // SL_wing_pylon_ref, BL_wing_ref, WL_wing_ref, m
  int flap_settings;              // how many of the following are filled
  R flap_deg[kMostFlapSettings];  // choices: flap_setting_1, .._2, ..: flap angle of FL1, FL2, .., deg
  Table<R, 1> lift_0[kMostFlapSettings];  // CL at mast 0 against alpha (deg): 4-I/4-II with the extension
  AirframeTable<R, 2> lift_90[kMostFlapSettings];  // CL at mast 90 against alpha, Mach (Mach only at FL1)
  Table<R, 1> drag_0[kMostFlapSettings];           // CD likewise: 4-III/4-IV
  AirframeTable<R, 2> drag_90[kMostFlapSettings];
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
  R rotor_wash_0, rotor_wash_1, rotor_wash_2;    // X_RW0 (-), X_RW1 (1/deg), X_RW2 (1/deg^2)
  R rotor_wash_angle;                            // K_XRW
  R rotor_wash_lift;                             // K_RW
  R rotor_lift_flap_none, rotor_lift_flap_full;  // choices: flap with none and with all of that lift, deg
  R advance_floor;                               // choices: advance_floor (0.15)
  R aileron_full_alpha, aileron_zero_alpha;      // choices: 8 deg, 25 deg
  R crossflow_alpha_limit;                       // choices: crossflow_alpha_limit, deg (25)
  R stall_deg;             // choices: wing_stall, angle of attack beyond which it stalls
  R borne_mast_deg;        // choices: wingborne_mast, mast angle from which it carries
  R downwash_arm;          // choices: downwash_arm (l_t), m
  R downwash_speed_floor;  // choices: downwash_speed_floor, m/s
};

template <class R>
struct PylonTables {
  Table<R, 1> interference;  // 4-XV: drag area against mast angle (deg), m^2
  Table<R, 1> side_plate;    // 4-XVI: K_PLAT against mast incidence (deg)
  R side_area;               // pylon_area_S_PYL, m^2
  R spinner_base;            // spinner_drag_area_base, m^2, each
  R spinner_cross;           // spinner_drag_area_cross, m^2, each
};

// Jets of all engines at sea level: gross thrust and airflow, each linear in the shaft power of the rotors.
template <class R>
struct EngineJetTables {
  R thrust;             // choices: engine_jet_thrust, N
  R thrust_per_power;   // choices: engine_jet_thrust_per_power, N/W
  R airflow;            // choices: engine_jet_airflow, kg/s
  R airflow_per_power;  // choices: engine_jet_airflow_per_power, kg/J
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
  R lift_beta;                            // htail_CL_beta, 1/rad
  MastRange<R> pressure;                  // choices: htail_pressure_mast0 (1), htail_K_HNU at mast 90
  R beta_limit;                           // choices: htail_beta_limit, deg (15)
  AirframeTable<R, 2, 1> rotor_wash;      // 2-I: K_WH against alpha (deg), speed (kt); linear axis mast (deg)
  Table<R, 1, 1> rotor_wash_beta;         // 2-II: factor against |beta| (deg); linear axis mast
  R wash_fit[5];                          // choices: htail_wash_fit_0..4 (closed-form alternative of 2-I)
  R wash_fit_speed;                       // choices: htail_wash_fit_speed, ft/s
  AirframeTable<R, 2> lift_elevator;      // 5-I: CL against alpha (deg), elevator (deg)
  AirframeTable<R, 2> lift_mach;          // 5-II with elevator 0 of 5-I below M 0.2: CL against alpha, Mach
  AirframeTable<R, 2> drag;               // 5-III: CD against alpha, Mach
  AirframeTable<R, 2, 1> pressure_ratio;  // 5-V: q ratio against alpha (deg), speed (kt); linear axis mast
};

template <class R>
struct FinTables {
  TailSurface<R> surface;
  R area_report;                    // vtail_area_panel_report, the conflicting source
  R pressure;                       // vtail_K_VNU
  R pressure_ratio;                 // choices: fin_pressure_ratio (eta_V)
  R lift_slope;                     // vtail_lift_slope, 1/rad
  R sidewash_roll, sidewash_yaw;    // vtail_dsigma_dphat, vtail_dsigma_drhat
  R speed_floor;                    // choices: fin_speed_floor (35 ft/s), m/s
  AirframeTable<R, 2> side_rudder;  // 6-I: CY against beta (deg), rudder (deg)
  AirframeTable<R, 2> side_mach;    // 6-II with rudder 0 of 6-I below M 0.2: CY against beta, Mach
  AirframeTable<R, 2> drag;         // 6-III: CD against beta, Mach
  // 6-IV..VII: 1 - dsigma/dbeta against alpha, |beta| (deg); linear axes mast, flap (deg)
  AirframeTable<R, 2, 2> sidewash;
  AirframeTable<R, 2> rotor_sidewash;  // 6-VIII: K_betaR against speed (kt), |beta| (deg)
};

template <class R>
struct TailSharedTables {
  Table<R, 1> control_mach;            // 5-IV: X_Ke = X_Kr against Mach
  Table<R, 1> sideslip_loss;           // 5-VI: K_beta against |beta| (deg)
  R control_loss_start;                // choices: control_loss_start, deg (15)
  R mach_blend_start, mach_blend_end;  // choices: tail_mach_blend_start, tail_mach_blend_end
};

}  // namespace tiltrotor

#include "tablegen/aircraft_fields.hpp"

namespace tablegen {

const std::vector<Field> kFields = {
    {"mass.gross", "weight_gross", "kg"},
    {"mass.nacelles", "weight_pylons_printed_cg", "kg"},
    {"mass.nacelles_quoted", "weight_pylons_both", "kg"},
    {"mass.sl_cg", "SL_CG_aft_helicopter", "m"},
    {"mass.wl_cg", "WL_CG_helicopter", "m"},
    {"mass.sl_nacelle", "SL_pylon_CG", "m"},
    {"mass.wl_nacelle", "WL_pylon_CG", "m"},
    {"mass.inertia.xx", "Ixx_0", "kg m2"},
    {"mass.inertia.yy", "Iyy_0", "kg m2"},
    {"mass.inertia.zz", "Izz_0", "kg m2"},
    {"mass.inertia.xz", "Ixz_0", "kg m2"},
    {"mass.inertia_slope.xx", "dIxx_dbm", "kg m2/deg"},
    {"mass.inertia_slope.yy", "dIyy_dbm", "kg m2/deg"},
    {"mass.inertia_slope.zz", "dIzz_dbm", "kg m2/deg"},
    {"mass.inertia_slope.xz", "dIxz_dbm", "kg m2/deg"},
    {"mass.flown_pitch", "flown_inertia_pitch", "ND"},
    {"mass.flown_yaw", "flown_inertia_yaw", "ND"},
    {"mass.design_0.xx", "Ixx_helicopter_1975", "kg m2"},
    {"mass.design_0.yy", "Iyy_helicopter_1975", "kg m2"},
    {"mass.design_0.zz", "Izz_helicopter_1975", "kg m2"},
    {"mass.design_90.xx", "Ixx_airplane_1975", "kg m2"},
    {"mass.design_90.yy", "Iyy_airplane_1975", "kg m2"},
    {"mass.design_90.zz", "Izz_airplane_1975", "kg m2"},

    {"mast.sl_pivot", "SL_pivot", "m"},
    {"mast.bl_pivot", "BL_pivot", "m"},
    {"mast.wl_pivot", "WL_pivot", "m"},
    {"mast.length", "mast_length", "m"},
    {"mast.cant", "mast_outboard_tilt_phi_m", "rad"},

    {"rotor.blades", "rotor_blades", "count"},
    {"rotor.radius", "rotor_radius", "m"},
    {"rotor.flap_inertia", "rotor_blade_flap_inertia", "kg m2"},
    {"rotor.speed_helicopter", "rotor_rpm_helicopter", "rad/s"},
    {"rotor.speed_airplane", "rotor_rpm_airplane", "rad/s"},
    {"rotor.delta3", "rotor_delta3", "rad"},
    {"rotor.precone", "rotor_precone", "rad"},
    {"rotor.root_cutout", "rotor_root_cutout", "ND"},
    {"rotor.hub_spring", "hub_spring", "N m/rad"},
    {"rotor.hub_damping", "hub_damping", "N m s/rad"},
    {"rotor.coning_frequency", "coning_frequency", "ND"},
    {"rotor.coning.at_0", "coning_mast0", "rad"},
    {"rotor.coning.at_90", "coning_mast90", "rad"},
    {"rotor.tip_loss", "tip_loss", "ND"},
    {"rotor.taper_end", "blade_taper_end", "ND"},
    {"rotor.lift_slope", "section_lift_slope", "1/rad"},
    {"rotor.region_edge[0]", "section_region_edge_1", "ND"},
    {"rotor.region_edge[1]", "section_region_edge_2", "ND"},
    {"rotor.region_edge[2]", "section_region_edge_3", "ND"},
    {"rotor.twist_reference", "twist_reference", "ND"},
    {"rotor.twist_linear", "rotor_twist_linear_A", "rad"},
    {"rotor.stall_blend", "section_stall_blend", "deg"},
    {"controls.engine_lapse", "engine_lapse", "ND"},
    {"rotor.plate_lift", "plate_lift", "ND"},
    {"rotor.plate_drag_min", "plate_drag_min", "ND"},
    {"rotor.plate_drag", "plate_drag", "ND"},

    {"inflow.apparent_mass_uniform", "apparent_mass_uniform", "ND"},
    {"inflow.apparent_mass_loaded", "apparent_mass_loaded", "ND"},
    {"inflow.apparent_mass_cyclic", "apparent_mass_cyclic", "ND"},
    {"inflow.induced_power", "induced_power_factor", "ND"},
    {"inflow.shape_thrust", "inflow_shape_thrust", "ND"},
    {"inflow.shape_tip_mach", "inflow_shape_tip_mach", "ND"},
    {"inflow.shape_descent", "inflow_shape_descent", "ND"},
    {"inflow.windmill_descent", "windmill_descent", "ND"},
    {"inflow.ring_in_plane", "ring_in_plane", "ND"},

    {"wake.axis_speed_factor", "wake_axis_speed_factor", "ND"},
    {"wake.fuselage_side", "wake_fuselage_side", "m"},
    {"wake.fade_start", "wake_fade_start", "m/s"},
    {"wake.fade_end", "wake_fade_end", "m/s"},
    {"wake.fade_mast_start", "wake_fade_mast_start", "deg"},
    {"wake.fade_mast_end", "wake_fade_mast_end", "deg"},
    {"wake.wash_factor", "induced_wing_factor_K0", "ND"},
    {"wake.load_factor.at_0", "wake_load_factor_mast0", "ND"},
    {"wake.load_factor.at_90", "wake_load_factor_mast90", "ND"},
    {"wake.gtrs_load_factor_0", "K_FW0", "ND"},
    {"wake.gtrs_load_factor_flap", "K_FW_dF", "1/deg"},
    {"wake.gtrs_area", "slipstream_area_max", "m2"},
    {"wake.gtrs_end_speed", "slipstream_end_speed", "m/s"},
    {"wake.gtrs_angle_a", "slipstream_angle_a", "ND"},
    {"wake.gtrs_angle_b", "slipstream_angle_b", "ND"},

    {"wing.area", "wing_area", "m2"},
    {"wing.span", "wing_span", "m"},
    {"wing.chord", "wing_chord", "m"},
    {"wing.sweep", "wing_sweep", "rad"},
    {"wing.sl", "SL_wing_pylon_ref", "m"},
    {"wing.bl", "BL_wing_ref", "m"},
    {"wing.wl", "WL_wing_ref", "m"},
    {"wing.aileron_roll_slope", "Cl_delta_a", "1/rad"},
    {"wing.roll_rate", "Cl_p_wing", "1/rad"},
    {"wing.roll_yaw_rate_per_lift", "Cl_r_over_CL", "1/rad"},
    {"wing.roll_yaw_rate_flap", "dCl_r_flap", "1/deg"},
    {"wing.flap_alpha", "dalpha_dflap", "ND"},
    {"wing.yaw_beta_0", "Cn_beta_0", "1/rad"},
    {"wing.yaw_beta_per_lift2", "Cn_beta_over_CL2", "1/rad"},
    {"wing.yaw_rate_per_lift2", "Cn_r_over_CL2", "1/rad"},
    {"wing.yaw_rate_per_drag", "Cn_r_over_CD0", "1/rad"},
    {"wing.yaw_roll_rate_per_lift", "Cn_p_over_CL", "1/rad"},
    {"wing.rotor_wash_0", "X_RW0", "ND"},
    {"wing.rotor_wash_1", "X_RW1", "1/deg"},
    {"wing.rotor_wash_2", "X_RW2", "1/deg2"},
    {"wing.rotor_wash_angle", "K_XRW", "ND"},
    {"wing.rotor_wash_lift", "K_RW", "ND"},
    {"wing.advance_floor", "advance_floor", "ND"},
    {"wing.aileron_full_alpha", "aileron_full_alpha", "deg"},
    {"wing.aileron_zero_alpha", "aileron_zero_alpha", "deg"},
    {"wing.crossflow_alpha_limit", "crossflow_alpha_limit", "deg"},
    {"wing.stall_deg", "wing_stall", "deg"},
    {"wing.borne_mast_deg", "wingborne_mast", "deg"},
    {"wing.downwash_arm", "downwash_arm", "m"},
    {"wing.downwash_speed_floor", "downwash_speed_floor", "m/s"},

    {"pylon.side_area", "pylon_area_S_PYL", "m2"},
    {"pylon.spinner_base", "spinner_drag_area_base", "m2"},
    {"pylon.spinner_cross", "spinner_drag_area_cross", "m2"},

    {"fuselage.sl", "SL_fuselage_ref", "m"},
    {"fuselage.wl", "WL_fuselage_ref", "m"},
    {"fuselage.lift_zero", "fuselage_L0", "m2"},
    {"fuselage.drag_zero", "fuselage_D0", "m2"},
    {"fuselage.moment_zero", "fuselage_M0", "m3"},
    {"fuselage.extra_drag", "fuselage_extra_drag", "m2"},

    {"htail.surface.area", "htail_area", "m2"},
    {"htail.surface.sl", "SL_htail", "m"},
    {"htail.surface.wl", "WL_htail", "m"},
    {"htail.surface.incidence", "htail_incidence", "rad"},
    {"htail.surface.control_tau", "htail_tau_e", "ND"},
    {"htail.surface.control_loss", "htail_D_Ke", "ND"},
    {"htail.lift_beta", "htail_CL_beta", "1/rad"},
    {"htail.pressure.at_0", "htail_pressure_mast0", "ND"},
    {"htail.pressure.at_90", "htail_K_HNU", "ND"},
    {"htail.beta_limit", "htail_beta_limit", "deg"},
    {"htail.wash_fit[0]", "htail_wash_fit_0", "ND"},
    {"htail.wash_fit[1]", "htail_wash_fit_1", "1/deg"},
    {"htail.wash_fit[2]", "htail_wash_fit_2", "ND"},
    {"htail.wash_fit[3]", "htail_wash_fit_3", "1/deg"},
    {"htail.wash_fit[4]", "htail_wash_fit_4", "ft/s/deg"},
    {"htail.wash_fit_speed", "htail_wash_fit_speed", "ft/s"},

    {"fin.surface.area", "vtail_area_panel_drawings", "m2"},
    {"fin.surface.sl", "SL_vtail", "m"},
    {"fin.surface.bl", "BL_vtail", "m"},
    {"fin.surface.wl", "WL_vtail", "m"},
    {"fin.surface.incidence", "vtail_incidence", "rad"},
    {"fin.surface.control_tau", "vtail_tau_r", "ND"},
    {"fin.surface.control_loss", "vtail_D_Kr", "ND"},
    {"fin.area_report", "vtail_area_panel_report", "m2"},
    {"fin.pressure", "vtail_K_VNU", "ND"},
    {"fin.pressure_ratio", "fin_pressure_ratio", "ND"},
    {"fin.lift_slope", "vtail_lift_slope", "1/rad"},
    {"fin.sidewash_roll", "vtail_dsigma_dphat", "ND"},
    {"fin.sidewash_yaw", "vtail_dsigma_drhat", "ND"},
    {"fin.speed_floor", "fin_speed_floor", "m/s"},

    {"tail.control_loss_start", "control_loss_start", "deg"},
    {"tail.mach_blend_start", "tail_mach_blend_start", "ND"},
    {"tail.mach_blend_end", "tail_mach_blend_end", "ND"},

    {"controls.cyclic_rigging", "cyclic_rigging", "rad"},
    {"controls.elevator", "elevator_gearing", "rad/in"},
    {"controls.elevator_replay", "elevator_gearing_replay", "rad/in"},
    {"controls.aileron", "aileron_gearing_mean", "rad/in"},
    {"controls.rudder", "rudder_gearing", "rad/in"},
    {"controls.long_travel", "stick_long_travel_half", "in"},
    {"controls.lat_travel", "stick_lat_travel_half", "in"},
    {"controls.pedal_travel", "pedal_travel_half", "in"},
    {"controls.elevator_limit", "elevator_limit", "rad"},
    {"controls.rudder_limit", "rudder_limit", "rad"},
    {"controls.flap_limit", "rotor_flap_limit", "rad"},
    {"controls.power_limit", "transmission_limit_helicopter", "W"},
    {"controls.engine_power", "engine_power_takeoff", "W"},
    {"controls.engine_power_continuous", "engine_power_continuous", "W"},
    {"controls.engines", "engine_count", "count"},
    {"controls.transmission_efficiency", "transmission_efficiency", "ND"},
    {"controls.mast_torque", "mast_torque_steady", "N m"},

    {"limits.mast_deg.low", "mast_min", "deg"},
    {"limits.mast_deg.high", "mast_max", "deg"},
    {"limits.mast_rate.low", "mast_rate_min", "rad/s"},
    {"limits.mast_rate.high", "mast_rate_max", "rad/s"},
    {"limits.rotor_speed.low", "rotor_speed_min", "rad/s"},
    {"limits.rotor_speed.high", "rotor_speed_max", "rad/s"},
    {"limits.altitude.low", "altitude_min", "m"},
    {"limits.altitude.high", "altitude_max", "m"},
    {"limits.mass.low", "mass_min", "kg"},
    {"limits.mass.high", "mass_max", "kg"},
    {"limits.sl_cg.low", "cg_station_min", "m"},
    {"limits.sl_cg.high", "cg_station_max", "m"},
    {"limits.wl_cg.low", "cg_waterline_min", "m"},
    {"limits.wl_cg.high", "cg_waterline_max", "m"},
    {"limits.collective.low", "collective_min", "rad"},
    {"limits.collective.high", "collective_max", "rad"},
    {"limits.speed", "speed_max", "m/s"},
    {"limits.increment", "increment_max", "rad"},
    {"limits.gust", "gust_max", "m/s"},

    {"defaults.flap_helicopter", "default_flap_helicopter", "deg"},
    {"defaults.flap_conversion", "default_flap_conversion", "deg"},
    {"defaults.flap_airplane", "default_flap_airplane", "deg"},

    {"guess.wing_speed", "guess_wing_speed", "m/s"},
    {"guess.hover_load", "guess_hover_load", "ND"},
    {"guess.wing_load", "guess_wing_load", "ND"},
    {"guess.hover_inflow", "guess_hover_inflow", "ND"},
    {"guess.pitch_helicopter_deg", "guess_pitch_helicopter", "deg"},
    {"guess.pitch_airplane_deg", "guess_pitch_airplane", "deg"},
    {"guess.blade_angle_deg", "guess_blade_angle", "deg"},
    {"guess.blade_angle_hover_deg", "guess_blade_angle_hover", "deg"},
    {"guess.stick_step", "guess_stick_step", "in"},

    {"smooth.section_speed", "smooth_section_speed", "m/s"},
    {"smooth.inflow_speed", "smooth_inflow_speed", "ND"},
    {"smooth.through_flow", "smooth_through_flow", "ND"},
    {"smooth.advance_ratio", "smooth_advance_ratio", "ND"},
    {"smooth.forward_speed", "smooth_forward_speed", "m/s"},
    {"smooth.lateral_plane_speed", "smooth_lateral_plane_speed", "m/s"},
    {"smooth.airspeed", "smooth_airspeed", "m/s"},
    {"smooth.rate_speed", "smooth_rate_speed", "m/s"},
    {"smooth.mach_limit", "smooth_mach_limit", "ND"},
    {"smooth.mach", "smooth_mach", "ND"},
    {"smooth.angle", "smooth_angle", "rad"},
    {"smooth.advance_floor", "smooth_advance_floor", "ND"},
    {"smooth.wake_axis", "smooth_wake_axis", "m/s"},
    {"smooth.wake_plane", "smooth_wake_plane", "ND"},
    {"smooth.wake_distance", "smooth_wake_distance", "ND"},
    {"smooth.wake_radius", "smooth_wake_radius", "m/s"},
    {"smooth.wake_cut", "smooth_wake_cut", "ND"},
    {"smooth.wake_start", "smooth_wake_start", "ND"},
    {"smooth.crossflow", "smooth_crossflow", "rad"},
    {"smooth.crossflow_clip", "smooth_crossflow_clip", "deg"},
    {"smooth.drag_speed", "smooth_drag_speed", "m/s"},
    {"smooth.spinner_sine", "smooth_spinner_sine", "ND"},
    {"smooth.side_plate_speed", "smooth_side_plate_speed", "m/s"},
    {"smooth.side_plate_axial", "smooth_side_plate_axial", "m/s"},
    {"smooth.stall_delay_lift", "stall_delay_lift", "ND"},
    {"smooth.stall_delay_start", "stall_delay_start", "deg"},
    {"smooth.stall_delay_fade", "stall_delay_fade", "deg"},
    {"smooth.stall_delay_end", "stall_delay_end", "deg"},
    {"smooth.rear_flow_start", "smooth_rear_flow_start", "rad"},
};

namespace {

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

struct Inside {
  const char *entry, *low, *high, *unit;
};
constexpr Inside kInside[] = {{"weight_gross", "mass_min", "mass_max", "kg"},
                              {"SL_CG_aft_helicopter", "cg_station_min", "cg_station_max", "m"},
                              {"WL_CG_helicopter", "cg_waterline_min", "cg_waterline_max", "m"},
                              {"rotor_rpm_helicopter", "rotor_speed_min", "rotor_speed_max", "rad/s"},
                              {"rotor_rpm_airplane", "rotor_speed_min", "rotor_speed_max", "rad/s"}};

}  // namespace

void check_fields(const Entries& entries) {
  for (std::size_t i = 0; i + 1 < kFields.size(); ++i) {
    if (!ends_with(kFields[i].field, ".low")) continue;
    const Field& low = kFields[i];
    const Field& high = kFields[i + 1];
    if (!(entries.in(low.entry, low.unit) < entries.in(high.entry, high.unit)))
      entries.refuse(high.entry, std::string("'") + high.entry + "' is not above '" + low.entry + "'");
  }
  for (const Inside& one : kInside) {
    const double value = entries.in(one.entry, one.unit);
    if (!(value >= entries.in(one.low, one.unit) && value <= entries.in(one.high, one.unit)))
      entries.refuse(one.entry, std::string("'") + one.entry + "' lies outside '" + one.low + "' and '" +
                                    one.high + "'");
  }
  const double blades = entries.in("rotor_blades", "count");
  constexpr double fewest = 3;  // two have no cyclic harmonics of their own
  constexpr double most = 12;
  if (!(blades >= fewest && blades <= most) || blades != static_cast<int>(blades))
    entries.refuse("rotor_blades", "a gimballed rotor has 3 to 12 blades");
}

}  // namespace tablegen

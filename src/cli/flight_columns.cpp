#include "cli/flight_columns.hpp"

#include "cli/flight_options.hpp"

namespace tiltrotor::cli {

namespace {

constexpr double kDegree = kRadPerDeg<double>;
constexpr double kKilo = 1e3;

using Now = const FlightMoment&;
struct Column {
  const char* name;
  double (*value)(Now);
};

const Column columns[] = {
    {"time_s", [](Now m) { return m.time; }},
    {"north_m", [](Now m) { return m.state.position.x; }},
    {"east_m", [](Now m) { return m.state.position.y; }},
    {"height_m", [](Now m) { return m.height; }},
    {"airspeed_mps", [](Now m) { return m.airspeed; }},
    {"north_speed_mps", [](Now m) { return m.velocity_n.x; }},
    {"east_speed_mps", [](Now m) { return m.velocity_n.y; }},
    {"climb_rate_mps", [](Now m) { return -m.velocity_n.z; }},
    {"u_mps", [](Now m) { return m.state.velocity.x; }},
    {"v_mps", [](Now m) { return m.state.velocity.y; }},
    {"w_mps", [](Now m) { return m.state.velocity.z; }},
    {"p_degps", [](Now m) { return m.state.rates.x / kDegree; }},
    {"q_degps", [](Now m) { return m.state.rates.y / kDegree; }},
    {"r_degps", [](Now m) { return m.state.rates.z / kDegree; }},
    {"roll_deg", [](Now m) { return m.state.roll / kDegree; }},
    {"pitch_deg", [](Now m) { return m.state.pitch / kDegree; }},
    {"yaw_deg", [](Now m) { return m.state.yaw / kDegree; }},
    {"load_factor", [](Now m) { return m.load_factor; }},
    {"mast_deg", [](Now m) { return m.mast_deg; }},
    {"mast_rate_degps", [](Now m) { return m.systems.mast_rate / kDegree; }},
    {"flap_deg", [](Now m) { return m.flap_deg; }},
    {"rotor_rpm", [](Now m) { return m.rotor_speed / kRpm; }},
    {"shaft_twist_deg", [](Now m) { return m.systems.shaft_twist / kDegree; }},
    {"rotor_command_rpm", [](Now m) { return m.commands.rotor_speed / kRpm; }},
    {"throttle_1", [](Now m) { return m.commands.throttle[right]; }},
    {"throttle_2", [](Now m) { return m.commands.throttle[left]; }},
    {"power_1_kw", [](Now m) { return m.power[right] / kKilo; }},
    {"power_2_kw", [](Now m) { return m.power[left] / kKilo; }},
    {"rotor_power_kw", [](Now m) { return m.rotor_power / kKilo; }},
    {"takeoff_power_kw", [](Now m) { return m.power_allowed / kKilo; }},
    {"fuel_burnt_kg", [](Now m) { return m.systems.fuel; }},
    {"collective75_deg", [](Now m) { return m.controls.collective / kDegree; }},
    {"governor_deg", [](Now m) { return m.systems.governor / kDegree; }},
    {"long_stick_from_neutral_in", [](Now m) { return m.controls.long_stick; }},
    {"lat_stick_in", [](Now m) { return m.controls.lat_stick; }},
    {"pedal_in", [](Now m) { return m.controls.pedal; }},
    {"scas_pitch_in", [](Now m) { return m.systems.series[0]; }},
    {"scas_roll_in", [](Now m) { return m.systems.series[1]; }},
    {"scas_yaw_in", [](Now m) { return m.systems.series[2]; }},
    {"elevator_deg", [](Now m) { return m.systems.elevator / kDegree; }},
    {"aileron_deg", [](Now m) { return m.systems.aileron / kDegree; }},
    {"rudder_deg", [](Now m) { return m.systems.rudder / kDegree; }},
    {"b1c_right_deg", [](Now m) { return m.state.rotor[right].b1c / kDegree; }},
    {"b1s_right_deg", [](Now m) { return m.state.rotor[right].b1s / kDegree; }},
    {"n0_right", [](Now m) { return m.state.rotor[right].lambda_0; }},
    {"b1c_left_deg", [](Now m) { return m.state.rotor[left].b1c / kDegree; }},
    {"b1s_left_deg", [](Now m) { return m.state.rotor[left].b1s / kDegree; }},
    {"n0_left", [](Now m) { return m.state.rotor[left].lambda_0; }},
    {"downwash_deg", [](Now m) { return m.state.downwash / kDegree; }},
    {"gear", [](Now m) { return m.systems.gear; }},
    {"weight_on_wheels", [](Now m) { return m.weight_on_wheels; }},
    {"wanted_height_m", [](Now m) { return m.wanted_height; }},
};

}  // namespace

const std::vector<std::string>& flight_columns() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Column& column : columns) all.emplace_back(column.name);
    return all;
  }();
  return names;
}

text::Row flight_row(const FlightMoment& moment) {
  text::Row row;
  for (const Column& column : columns) row.emplace_back(column.value(moment));
  return row;
}

}  // namespace tiltrotor::cli

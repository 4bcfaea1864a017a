#include "cli/response_columns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cli/derived_columns.hpp"
#include "cli/flight_range.hpp"
#include "cli/model_options.hpp"
#include "cli/state_columns.hpp"
#include "text/rounding.hpp"

namespace tiltrotor::cli {

namespace {

constexpr double radian = kRadPerDeg<double>;

// Of the body and the downwash, and of rotor speed and governor where they are states.
int shown_modes(const Options& options) {
  return kRigidStates + 1 + (options.governor == Governor::pi ? 2 : 0);
}

struct Moment {
  const Simulation<double>& simulation;
  const State<double>& x;
  Controls<double> u;  // collective: with what the governor adds
};
using Now = const Moment&;

struct Column {
  const char* name;
  double (*value)(Now);
};

// What a rate or velocity that is printed as 0 adds up to.
double without_drift(double value, Now m) {
  return without_rounding(value, kUsualTerms * std::max(1.0, current_time(m.simulation)));
}

const Column columns[] = {
    {"time_s", [](Now m) { return current_time(m.simulation); }},
    {"u_mps", [](Now m) { return m.x.velocity.x; }},
    {"v_mps", [](Now m) { return m.x.velocity.y; }},
    {"w_mps", [](Now m) { return m.x.velocity.z; }},
    {"p_degps", [](Now m) { return m.x.rates.x / radian; }},
    {"q_degps", [](Now m) { return m.x.rates.y / radian; }},
    {"r_degps", [](Now m) { return m.x.rates.z / radian; }},
    {"roll_deg", [](Now m) { return without_drift(m.x.roll / radian, m); }},
    {"pitch_deg", [](Now m) { return m.x.pitch / radian; }},
    {"yaw_deg", [](Now m) { return without_drift(m.x.yaw / radian, m); }},
    {"speed_mps", [](Now m) { return airspeed(m.x, m.u); }},
    {"forward_speed_mps", [](Now m) { return forward_speed(m.x); }},
    {"climb_rate_mps", [](Now m) { return climb_rate(m.x); }},
    {"collective75_deg", [](Now m) { return m.u.collective / radian; }},
    // Inches from neutral.
    {"long_stick_from_neutral_in", [](Now m) { return m.u.long_stick; }},
    {"lat_stick_in", [](Now m) { return m.u.lat_stick; }},
    {"pedal_in", [](Now m) { return m.u.pedal; }},
    {"b1c_right_deg", [](Now m) { return m.x.rotor[right].b1c / radian; }},
    {"b1s_right_deg", [](Now m) { return m.x.rotor[right].b1s / radian; }},
    {"n0_right", [](Now m) { return m.x.rotor[right].lambda_0; }},
    {"b1c_left_deg", [](Now m) { return m.x.rotor[left].b1c / radian; }},
    {"b1s_left_deg", [](Now m) { return m.x.rotor[left].b1s / radian; }},
    {"n0_left", [](Now m) { return m.x.rotor[left].lambda_0; }},
    {"downwash_deg", [](Now m) { return m.x.downwash / radian; }},
};

std::vector<std::string> own_columns() {
  std::vector<std::string> names;
  for (const Column& column : columns) names.emplace_back(column.name);
  return names;
}

}  // namespace

std::vector<std::string> response_columns(bool with_modes, const Options& options) {
  std::vector<std::string> names = own_columns();
  for (const std::string& name : completing_columns(own_columns(), options, true)) names.push_back(name);
  if (options.governor != Governor::off) names.emplace_back("governor_deg");
  names.insert(names.end(), {"limits", kModelColumn});
  for (int i = 1; with_modes && i <= shown_modes(options); ++i) {
    const std::string name = "mode" + std::to_string(i);
    names.insert(names.end(), {name, name + "_real", name + "_imag", name + "_branch"});
  }
  return names;
}

Row response_row(const TrimmedFlight& flight, const Configuration<double>& now,
                 const Simulation<double>& simulation, const Controls<double>& acting, double governed) {
  Moment moment{simulation, simulation.state, acting};
  moment.u.collective += governed;
  Row row;
  for (const Column& column : columns) row.emplace_back(column.value(moment));
  const Options& options = flight.configuration.setup.options;
  for (const std::string& name : completing_columns(own_columns(), options, true)) {
    if (is_setting(name)) {
      const double value = setting_value(name, now.setup);
      const bool moved = value != setting_value(name, flight.configuration.setup);
      row.emplace_back(as_given(moved ? value : flight.setting(name)));
      continue;
    }
    const double value = completing_value(name, moment.x, moment.u);
    const bool is_position = name == "north_m" || name == "east_m" || name == "down_m";
    row.emplace_back(is_position ? without_drift(value, moment) : value);
  }
  if (options.governor != Governor::off) row.emplace_back(governed / radian);
  row.emplace_back(words_of(controls_beyond_stops(acting)));
  row.emplace_back(flight.setup->model());
  return row;
}

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

void fill_modes(Row& row, int shown, const Options& options) {
  for (; shown < shown_modes(options); ++shown) row.insert(row.end(), {"", nothing, nothing, nothing});
}

}  // namespace

void append_modes(Row& row, const ModeSet<double>* set) {
  const Options ungoverned{};
  int shown = 0;
  for (int i = 0; set != nullptr && i < set->count && shown < shown_modes(ungoverned); ++i) {
    const Mode<double>& mode = set->mode[i];
    if (mode.axis == ModeAxis::rotor) continue;
    row.insert(row.end(), {mode.name, mode.real, mode.imag, static_cast<double>(mode.branch)});
    ++shown;
  }
  fill_modes(row, shown, ungoverned);
}

void append_modes(Row& row, const VehicleModes<double>* set, const Options& options) {
  int shown = 0;
  for (int i = 0; set != nullptr && i < set->count && shown < shown_modes(options); ++i) {
    const VehicleMode<double>& mode = set->mode[i];
    if (mode.axis == ModeAxis::rotor && !mode.is_system) continue;
    row.insert(row.end(), {mode.name, mode.real, mode.imag, nothing});
    ++shown;
  }
  fill_modes(row, shown, options);
}

}  // namespace tiltrotor::cli

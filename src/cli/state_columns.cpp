#include "cli/state_columns.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "cli/flight_options.hpp"
#include "cli/flight_records.hpp"
#include "cli/model_options.hpp"
#include "cli/named_outputs.hpp"
#include "cli/output_names.hpp"
#include "cli/response_columns.hpp"
#include "cli/trim_columns.hpp"
#include "cli/units.hpp"
#include "text/number.hpp"
#include "tiltrotor/math/differentiation/preaccumulate.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

namespace tiltrotor::cli {

namespace {

struct PrintedName {
  const char* state;  // its name in models
  const char* name;
  const char* unit;
};
// In the order of kStateVariables.
constexpr PrintedName printed_states[] = {
    {"u", "u_mps", "m/s"},
    {"v", "v_mps", "m/s"},
    {"w", "w_mps", "m/s"},
    {"p", "p_degps", "deg/s"},
    {"q", "q_degps", "deg/s"},
    {"r", "r_degps", "deg/s"},
    {"phi", "roll_deg", "deg"},
    {"theta", "pitch_deg", "deg"},
    {"psi", "yaw_deg", "deg"},
    {"b1c_R", "b1c_right_deg", "deg"},
    {"b1s_R", "b1s_right_deg", "deg"},
    {"db1c_R", "b1c_rate_right_degps", "deg/s"},
    {"db1s_R", "b1s_rate_right_degps", "deg/s"},
    {"n0_R", "n0_right", "-"},
    {"nc_R", "nc_right", "-"},
    {"ns_R", "ns_right", "-"},
    {"b1c_L", "b1c_left_deg", "deg"},
    {"b1s_L", "b1s_left_deg", "deg"},
    {"db1c_L", "b1c_rate_left_degps", "deg/s"},
    {"db1s_L", "b1s_rate_left_degps", "deg/s"},
    {"n0_L", "n0_left", "-"},
    {"nc_L", "nc_left", "-"},
    {"ns_L", "ns_left", "-"},
    {"eps", "downwash_deg", "deg"},
    {"b0_R", "coning_right_deg", "deg"},
    {"db0_R", "coning_rate_right_degps", "deg/s"},
    {"b0_L", "coning_left_deg", "deg"},
    {"db0_L", "coning_rate_left_degps", "deg/s"},
    {"north", "north_m", "m"},
    {"east", "east_m", "m"},
    {"down", "down_m", "m"},
};

// In degrees where the model has radians.
constexpr bool printed_unit_fits(int state) {
  const std::string_view model = kStateVariables[state].unit();
  const std::string_view printed = printed_states[state].unit;
  return model.substr(0, 3) == "rad" ? printed.substr(0, 3) == "deg" && printed.substr(3) == model.substr(3)
                                     : printed == model;
}
constexpr bool every_state_is_printed() {
  if (std::size(printed_states) != state_count) return false;
  for (int i = 0; i < state_count; ++i)
    if (std::string_view(printed_states[i].state) != kStateVariables[i].name || !printed_unit_fits(i))
      return false;
  return true;
}
static_assert(every_state_is_printed(), "a row of printed_states per state, in order");

// Names of the reference files and of the program for the four inceptors.
struct InceptorColumn {
  const char* name;
  int control;
  const char* unit;
  bool from_rear_stop = false;
};
constexpr InceptorColumn inceptor_columns[] = {
    {"th75_rad", kControlIndex.collective, "rad"},
    {"collective75_deg", kControlIndex.collective, "deg"},
    {"lon_in", kControlIndex.long_stick, "in"},
    {"long_stick_from_neutral_in", kControlIndex.long_stick, "in"},
    {"long_stick_in", kControlIndex.long_stick, "in", true},
    {"lat_in", kControlIndex.lat_stick, "in"},
    {"lat_stick_in", kControlIndex.lat_stick, "in"},
    {"ped_in", kControlIndex.pedal, "in"},
    {"pedal_in", kControlIndex.pedal, "in"},
};

struct SettingColumn {
  const char* name;
  Target target;
  double (*value)(const FlightSetup<double>&);
};
constexpr SettingColumn setting_columns[] = {
    {"mast_deg",
     {Target::Kind::mast, 0, 1, 0, "deg"},
     [](const FlightSetup<double>& s) { return s.mast_deg; }},
    {"altitude_m",
     {Target::Kind::altitude, 0, 1, 0, "m"},
     [](const FlightSetup<double>& s) { return s.altitude; }},
    {"flap_deg",
     {Target::Kind::flap, 0, 1, 0, "deg"},
     [](const FlightSetup<double>& s) { return s.flap_deg; }},
    {"rotor_rpm",
     {Target::Kind::rotor_speed, 0, kPi<double> / 30, 0, "rpm"},
     [](const FlightSetup<double>& s) { return s.rotor_speed; }},
    {"mass_kg", {Target::Kind::mass, 0, 1, 0, "kg"}, [](const FlightSetup<double>& s) { return s.mass; }},
    {"cg_sl_in",
     {Target::Kind::sl_cg, 0, kInch, 0, "in"},
     [](const FlightSetup<double>& s) { return s.sl_cg; }},
};

const SettingColumn* find_setting(const std::string& column) {
  for (const SettingColumn& setting : setting_columns)
    if (column == setting.name) return &setting;
  return nullptr;
}

double unit_size(const std::string& unit) { return unit.compare(0, 3, "deg") == 0 ? kRadPerDeg<double> : 1; }

std::string increment_column(int control) {
  const std::string unit = kControlVariables[control].unit();
  return std::string(kControlVariables[control].name) + "_" + (unit == "m/s" ? "mps" : unit);
}
// As printed, in degrees; gusts have the name above.
std::string printed_increment(int control) {
  return std::string(kControlVariables[control].name) + "_increment_deg";
}

std::optional<Target> find_control(const std::string& column) {
  for (const InceptorColumn& inceptor : inceptor_columns) {
    if (column != inceptor.name) continue;
    const double zero = inceptor.from_rear_stop ? aircraft_data<double>().controls.long_travel : 0;
    return Target{Target::Kind::control, inceptor.control, unit_size(inceptor.unit), zero, inceptor.unit};
  }
  for (int i = kControlIndex.pedal + 1; i < control_count; ++i) {
    if (column == increment_column(i))
      return Target{Target::Kind::control, i, 1, 0, kControlVariables[i].unit()};
    if (i < kControlIndex.gust.x && column == printed_increment(i))
      return Target{Target::Kind::control, i, kRadPerDeg<double>, 0, "deg"};
  }
  return std::nullopt;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

const std::vector<std::string>& derived_columns() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all = trim_columns();
    Options governed;
    governed.governor = Governor::pi;
    for (const std::string& name : response_columns(true, governed)) all.push_back(name);
    for (const OutputName& output : kOutputNames) all.emplace_back(output.name);
    for (const std::string& name : swept_names()) all.push_back(name);
    all.emplace_back("ny");  // swept by --hold
    return all;
  }();
  return names;
}

// Under the names of the model and those that the program prints without --units.
std::optional<Target> find_own_target(const std::string& column) {
  if (column.compare(0, 2, "d_") == 0) return Target{Target::Kind::rate};
  if (column == "case") return Target{Target::Kind::name};
  if (column == kModelColumn) return Target{Target::Kind::model};
  if (const SettingColumn* const setting = find_setting(column)) return setting->target;
  for (int i = 0; i < state_count; ++i) {
    if (column == kStateVariables[i].name)
      return Target{Target::Kind::state, i, 1, 0, kStateVariables[i].unit()};
    const PrintedName& printed = printed_states[i];
    if (column == printed.name)
      return Target{Target::Kind::state, i, unit_size(printed.unit), 0, printed.unit};
  }
  if (const std::optional<Target> control = find_control(column)) return control;
  if (contains(derived_columns(), column) || output_named(column, "column " + column))
    return Target{Target::Kind::derived};
  return std::nullopt;
}

}  // namespace

std::optional<Target> find_target(const std::string& column) {
  std::optional<Target> target = find_own_target(column);
  const InUnit in = in_own_unit(column);
  if (target || in.size == 1) return target;
  target = find_own_target(in.name);
  if (!target || target->kind == Target::Kind::rate) return std::nullopt;
  target->unit *= in.size;
  target->zero /= in.size;
  target->size = in.size;
  target->unit_name = in.sign;
  return target;
}

std::vector<std::string> known_columns() {
  std::vector<std::string> names = {"case", kModelColumn};
  for (const SettingColumn& setting : setting_columns) names.emplace_back(setting.name);
  for (int i = 0; i < state_count; ++i)
    for (const std::string& name : state_columns(i)) names.push_back(name);
  for (int i = 0; i < control_count; ++i)
    for (const std::string& name : control_columns(i)) names.push_back(name);
  return names;
}

std::vector<std::string> state_columns(int state) {
  return {kStateVariables[state].name, printed_states[state].name};
}

std::vector<std::string> control_columns(int control) {
  std::vector<std::string> names;
  for (const InceptorColumn& inceptor : inceptor_columns)
    if (inceptor.control == control) names.emplace_back(inceptor.name);
  if (control > kControlIndex.pedal) names.push_back(increment_column(control));
  if (control > kControlIndex.pedal && control < kControlIndex.gust.x)
    names.push_back(printed_increment(control));
  return names;
}

std::vector<int> needed_states(const Options& options) {
  const ActiveStates active = active_states(options, true);
  std::vector<int> states;
  for (int i = 0; i < state_count; ++i) {
    const bool alive = std::find(active.index, active.index + active.count, i) != active.index + active.count;
    if (i < kStateIndex.coning[right].angle || alive) states.push_back(i);
  }
  return states;
}

std::vector<std::string> completing_columns(const std::vector<std::string>& columns, const Options& options,
                                            bool with_increments) {
  std::vector<std::string> missing;
  const auto complete = [&](const std::vector<std::string>& names) {
    const bool there =
        std::any_of(names.begin(), names.end(), [&](const std::string& n) { return contains(columns, n); });
    if (!there) missing.push_back(names.back());
  };
  for (const int i : needed_states(options)) complete(state_columns(i));
  for (int j = kControlIndex.pedal + 1; with_increments && j < control_count; ++j)
    complete(control_columns(j));
  for (const SettingColumn& setting : setting_columns) complete({setting.name});
  return missing;
}

double completing_value(const std::string& column, const State<double>& x, const Controls<double>& u) {
  const Target target = *find_target(column);
  double states[state_count], controls[control_count];
  flatten(x, states);
  flatten(u, controls);
  if (target.kind == Target::Kind::state) return target.shown(states[target.index]);
  return target.shown(controls[target.index]);
}

bool is_setting(const std::string& column) { return find_setting(column) != nullptr; }

double setting_value(const std::string& column, const FlightSetup<double>& setup) {
  const SettingColumn& setting = *find_setting(column);
  return given_as(setting.value(setup), setting.target.unit);
}

}  // namespace tiltrotor::cli

#include "cli/model_options.hpp"

#include <algorithm>
#include <functional>
#include <vector>

#include "cli/arguments.hpp"
#include "cli/errors.hpp"
#include "text/nearest.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/model/aircraft/c2_aircraft.hpp"
#include "tiltrotor/model/setup/blade_grid.hpp"
#include "tiltrotor/model/variables/presets.hpp"

namespace tiltrotor::cli {

namespace {

struct Switch {
  std::string name;
  std::string values;  // as shown in the help
  const char* help;
  std::function<void(ModelChoice&, const std::string& value, const std::string& where)> set;
  std::function<std::string(const ModelChoice&)> value;  // none: a name for several others
};

// Words in the order of the enumerators.
template <class Enum>
Switch words(const char* name, Enum Options::*member, const std::vector<std::string>& choices,
             const char* help) {
  std::string values;
  for (const std::string& choice : choices) values += (values.empty() ? "" : "|") + choice;
  return {name, values, help,
          [=](ModelChoice& options, const std::string& value, const std::string& where) {
            options.*member = static_cast<Enum>(place_of(value, choices, where));
          },
          [=](const ModelChoice& options) { return choices[static_cast<std::size_t>(options.*member)]; }};
}

Switch on_off(const char* name, bool Options::*member, const char* help) {
  const bool is_on = Options().*member;
  return {name, is_on ? "on|off" : "off|on", help,
          [=](ModelChoice& options, const std::string& value, const std::string& where) {
            options.*member = place_of(value, {"off", "on"}, where) == 1;
          },
          [=](const ModelChoice& options) { return options.*member ? "on" : "off"; }};
}

Switch number(const char* name, double Options::*member, double low, double high, const char* help) {
  const Range range{low, high, ""};
  return {name, range_text(range), help,
          [=](ModelChoice& options, const std::string& value, const std::string& where) {
            options.*member = parse_number(value, where, range);
          },
          [=](const ModelChoice& options) { return number_text(options.*member); }};
}

Switch whole(const char* name, int Options::*member, long low, long high, const char* help) {
  return {name, std::to_string(low) + ".." + std::to_string(high), help,
          [=](ModelChoice& options, const std::string& value, const std::string& where) {
            options.*member = static_cast<int>(parse_integer(value, where, low, high));
          },
          [=](const ModelChoice& options) { return std::to_string(options.*member); }};
}

// Two stations or fewer cannot carry the first harmonics.
Switch azimuth_stations() {
  constexpr long fewest = 3;
  Switch s = whole("azimuth_stations", &Options::azimuth_stations, fewest, kMaxAzimuthStations,
                   "0: the grid's own number");
  const std::string stated = "0 or " + s.values;
  s.values = "0|" + s.values;
  s.set = [=](ModelChoice& options, const std::string& value, const std::string& where) {
    const long stations = parse_integer(value, where, 0, kMaxAzimuthStations, stated);
    if (stations != 0 && stations < fewest) refuse_integer(value, where, stated);
    options.azimuth_stations = static_cast<int>(stations);
  };
  return s;
}

// A set of the switches above it in the help.
Switch data_set() {
  const std::vector<std::string> sets = {"as_simulated", "as_flown"};
  return {"data_set", sets[0] + "|" + sets[1], "inertia and tail_pressure of that aircraft",
          [sets](ModelChoice& options, const std::string& value, const std::string& where) {
            choose(static_cast<DataSet>(place_of(value, sets, where)), options);
          },
          nullptr};
}

Switch tables() {
  const std::vector<std::string> kinds = {"c1", "linear", "c2"};
  Switch s =
      words("tables", &Options::tables, kinds, "interpolation of the tables; c2: as smooth as print allows");
  s.set = [=](ModelChoice& options, const std::string& value, const std::string& where) {
    const std::size_t kind = place_of(value, kinds, where);
    options.c2_tables = kinds[kind] == "c2";
    options.tables = kinds[kind] == "linear" ? Interpolation::linear : Interpolation::c1;
  };
  s.value = [=](const ModelChoice& options) {
    return options.c2_tables ? kinds[2] : kinds[static_cast<std::size_t>(options.tables)];
  };
  return s;
}

std::vector<Switch> all_switches() {
  using O = Options;
  return {
      tables(),
      words("grid", &O::grid, {"specification", "realtime"}, "blade stations"),
      whole("grid_refinement", &O::grid_refinement, 1, 4, "times the radial stations of the grid"),
      azimuth_stations(),
      words("azimuth", &O::azimuth, {"averaged", "individual"}, "rotor average or each blade"),
      words("flapping", &O::flapping, {"second", "first"}, "order of the gimbal equations"),
      on_off("flap_angular_acceleration", &O::flap_angular_acceleration,
             "hub angular acceleration in flapping"),
      on_off("coning_states", &O::coning_states, "coning as two states a rotor"),
      on_off("mast_cant", &O::mast_cant, "outboard cant of the masts"),
      number("hub_spring_factor", &O::hub_spring_factor, 0, 10, "times the gimbal spring"),
      words("inflow", &O::inflow, {"pitt_peters", "uniform"}, "three inflow states or the mean alone"),
      words("inflow_gradient", &O::inflow_gradient, {"pitt_peters", "coleman", "white_blake"},
            "fore-aft gradient of the inflow"),
      words("radial_inflow", &O::radial_inflow, {"annular", "constant"}, "mean inflow along the blade"),
      words("descent_inflow", &O::descent_inflow, {"vortex_ring", "momentum"},
            "mean inflow in the rotor's own wake"),
      words("apparent_mass", &O::apparent_mass, {"impermeable", "loaded"}, "8/(3 pi) or 128/(75 pi)"),
      on_off("disk_plane_inflow", &O::disk_plane_inflow, "through-flow normal to the tilted disk"),
      number("induced_power_factor", &O::induced_power_factor, 0, 2, "0: the aircraft's own"),
      on_off("side_by_side", &O::side_by_side, "side-by-side rotor interference"),
      on_off("sideward_flight", &O::sideward_flight, "thrust correction in sideward flight"),
      words("wake", &O::wake, {"geometric", "gtrs_empirical"}, "immersed area of the wing"),
      on_off("wake_fade", &O::wake_fade, "speed fade of the geometric wake"),
      on_off("wake_fade_airplane", &O::wake_fade_airplane, "the fade holds in airplane mode too"),
      words("wash", &O::wash, {"constant", "vortex_cylinder"}, "wash speed on the immersed wing"),
      words("wake_load", &O::wake_load, {"calibrated", "gtrs"}, "load factor of the immersed wing"),
      words("mast_drag", &O::mast_drag, {"cosine", "cross_flow", "linear"},
            "wing-pylon drag between mast 0 and 90"),
      on_off("rotor_lift_on_wing", &O::rotor_lift_on_wing, "rotor-induced lift of the free wing"),
      words("rotor_lift_flaps", &O::rotor_lift_flaps, {"full", "any"}, "flaps that this lift needs"),
      on_off("engine_jets", &O::engine_jets, "net thrust of the engines' jets"),
      on_off("wing_rate_velocity", &O::wing_rate_velocity, "body rates in the flow at the free wing"),
      on_off("downwash_lag", &O::downwash_lag, "wing downwash reaches the tail with a lag"),
      words("tail_wash", &O::tail_wash, {"tables", "closed_form"}, "rotor wash at the horizontal tail"),
      words("tail_pressure", &O::tail_pressure, {"none", "by_mast", "constant"},
            "K_HNU at the horizontal tail"),
      on_off("tail_sideslip_loss", &O::tail_sideslip_loss, "loss of the tail loads with sideslip"),
      words("nacelle_mass", &O::nacelle_mass, {"printed_cg", "quoted"}, "3985 lb, or 4200 lb as quoted"),
      words("inertia", &O::inertia, {"simulation", "design_1975", "flown"}, "source of the inertia"),
      words("fin_area", &O::fin_area, {"drawings", "report"}, "25.25 or 20.25 ft^2 a panel"),
      words("chord", &O::chord, {"cutout", "text", "camrad"}, "source of the blade chord"),
      words("twist", &O::twist, {"table", "linear"}, "source of the blade twist"),
      on_off("cyclic_rigging", &O::cyclic_rigging, "cyclic bias that grows with mast angle"),
      on_off("stall_delay", &O::stall_delay, "lift that rotation keeps beyond stall"),
      on_off("lateral_cyclic", &O::lateral_cyclic, "lateral cyclic scheduled with airspeed"),
      words("elevator_gearing", &O::elevator_gearing, {"aircraft", "printed_runs"}, "4.167 or 4.735 deg/in"),
      words("governor", &O::governor, {"off", "ideal", "pi"},
            "of the rotor speed, in linear models and flights"),
      words("interconnect", &O::interconnect, {"rigid", "twists"},
            "shaft between the rotors, with governor=pi"),
      data_set(),
      on_off("position_states", &O::position_states, "earth position among the states"),
  };
}

const std::vector<Switch>& switches() {
  static const std::vector<Switch> all = all_switches();
  return all;
}

}  // namespace

ModelChoice choice_of(const Configuration<double>& c) {
  return {c.setup.options, has_c2_tables(*c.aircraft)};
}

std::string model_options_help() {
  constexpr std::size_t help_column = 50;
  std::string text;
  for (const Switch& s : switches()) {
    std::string line = "  " + s.name + "=" + s.values;
    line.resize(std::max(help_column, line.size() + 1), ' ');
    text += line + s.help + "\n";
  }
  return text;
}

std::vector<std::pair<std::string, std::string>> model_option_values() {
  std::vector<std::pair<std::string, std::string>> all;
  for (const Switch& s : switches()) all.emplace_back(s.name, s.values);
  return all;
}

std::string model_text(const ModelChoice& options) {
  const ModelChoice standard;
  std::string text = aircraft_identity().name;
  for (const Switch& s : switches())
    if (s.value && s.value(options) != s.value(standard)) text += " " + s.name + "=" + s.value(options);
  return text;
}

std::vector<std::pair<std::string, std::string>> model_switches(const ModelChoice& options) {
  std::vector<std::pair<std::string, std::string>> all;
  for (const Switch& s : switches())
    if (s.value) all.emplace_back(s.name, s.value(options));
  return all;
}

void set_model_option(ModelChoice& options, const std::string& name, const std::string& value,
                      const std::string& where) {
  const auto place =
      std::find_if(switches().begin(), switches().end(), [&](const Switch& s) { return s.name == name; });
  if (place == switches().end()) {
    std::vector<std::string> names;
    for (const Switch& s : switches()) names.push_back(s.name);
    throw UsageError(where + ": no switch " + quoted(name) + did_you_mean(name, names) + "; choose " +
                     one_of(names));
  }
  place->set(options, value, where);
}

}  // namespace tiltrotor::cli

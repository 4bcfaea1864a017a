#include "cli/named_outputs.hpp"

#include <algorithm>

#include "cli/errors.hpp"
#include "cli/flight_options.hpp"
#include "cli/output_names.hpp"
#include "text/csv_line.hpp"
#include "text/nearest.hpp"
#include "text/split.hpp"

namespace tiltrotor::cli {

namespace {

using Kind = AirframeOutput::Kind;

constexpr const char* kAll = "total_aero";
constexpr const char* kAxes = "xyz";
constexpr Range kStations{-10000, 10000, "in"};  // of the airframe, and far around it

// "htail_moment_y" of component k.
std::string load_name(int component, Kind kind, int axis) {
  const std::string of = component == component_count ? kAll : kComponentNames[component];
  return of + (kind == Kind::force ? "_force_" : "_moment_") + kAxes[axis];
}

std::optional<NamedOutput> load_named(const std::string& name) {
  for (int component = 0; component <= component_count; ++component)
    for (const Kind kind : {Kind::force, Kind::moment})
      for (int axis = 0; axis < 3; ++axis)
        if (name == load_name(component, kind, axis))
          return NamedOutput{name, kind == Kind::force ? "N" : "N m", -1, {kind, axis, component, {}}};
  return std::nullopt;
}

struct Angle {
  const char* name;
  Kind kind;
};
constexpr Angle kAngles[] = {{"flight_path_angle", Kind::flight_path_angle},
                             {"wing_angle_of_attack", Kind::wing_angle_of_attack},
                             {"htail_angle_of_attack", Kind::htail_angle_of_attack}};
constexpr const char* kLoadFactorsAtCg[] = {"nx", "ny", "nz"};

// "htail_angle_of_attack", "nz" at the CG, "b1c_R" and every other state of a linear model of the airframe.
std::optional<NamedOutput> motion_named(const std::string& name) {
  for (const Angle& angle : kAngles)
    if (name == angle.name) return NamedOutput{name, "rad", -1, {angle.kind, 0, 0, {}}};
  for (int axis = 0; axis < 3; ++axis)
    if (name == kLoadFactorsAtCg[axis])
      return NamedOutput{name, "-", -1, {Kind::load_factor_at_cg, axis, 0, {}}};
  for (int i = 0; i < state_count; ++i)
    if (name == kStateVariables[i].name && !kStateVariables[i].facts().ignorable)
      return NamedOutput{name, kStateVariables[i].facts().unit, -1, {Kind::state, 0, i, {}}};
  return std::nullopt;
}

// "nz@230/0/75"
std::optional<NamedOutput> load_factor_named(const std::string& name, const std::string& where) {
  constexpr std::size_t letters = 3;
  if (name.size() < letters || name[0] != 'n' || name[2] != '@') return std::nullopt;
  const char* const axis = std::find(kAxes, kAxes + 3, name[1]);
  if (axis == kAxes + 3) return std::nullopt;
  const std::vector<std::string> station = split(name.substr(letters), '/');
  if (station.size() != 3)
    throw UsageError(where + ": " + quoted(name) + ": a station is SL/BL/WL in inches: n" + *axis +
                     "@230/0/75");
  NamedOutput output{name, "-", -1, {Kind::load_factor, static_cast<int>(axis - kAxes), 0, {}}};
  for (int k = 0; k < 3; ++k)
    output.output.station[k] =
        parse_number(station[static_cast<std::size_t>(k)], where + ": " + name, kStations) * kInch;
  return output;
}

}  // namespace

std::optional<NamedOutput> output_named(const std::string& name, const std::string& where) {
  for (int k = 0; k < Instruments<double>::kCount; ++k)
    if (name == kOutputNames[k].name) return NamedOutput{name, kOutputNames[k].unit, k, {}};
  if (const auto load = load_named(name)) return load;
  if (const auto motion = motion_named(name)) return motion;
  return load_factor_named(name, where);
}

std::vector<std::string> short_output_names() {
  std::vector<std::string> names;
  for (const OutputName& output : kOutputNames) names.emplace_back(output.name);
  for (const Angle& angle : kAngles) names.emplace_back(angle.name);
  for (const char* const name : kLoadFactorsAtCg) names.emplace_back(name);
  return names;
}

std::vector<std::string> output_names() {
  std::vector<std::string> names = short_output_names();
  for (const Variable& state : kStateVariables.row)
    if (!state.facts().ignorable) names.emplace_back(state.name);
  for (int component = 0; component <= component_count; ++component)
    for (const Kind kind : {Kind::force, Kind::moment})
      for (int axis = 0; axis < 3; ++axis) names.push_back(load_name(component, kind, axis));
  return names;
}

OptionList outputs_option() {
  return {{"--outputs", "A,B,..",
           "rows of C and D, in this order, in CSV too: names of instruments\n"
           "(airspeed, power_right; all of them where JSON and MATLAB choose),\n"
           "nx, ny, nz at the CG, nx@SL/BL/WL, .. at a station in inches,\n"
           "flight_path_angle, wing_angle_of_attack, htail_angle_of_attack,\n"
           "states (b1c_R), and of a component of `loads` htail_force_z,\n"
           "htail_moment_y, .."}};
}

std::vector<NamedOutput> chosen_outputs(const Arguments& arguments) {
  std::vector<NamedOutput> chosen;
  if (!arguments.given("--outputs")) return chosen;
  const std::string where = arguments.where("--outputs");
  for (const std::string& text : split(arguments.text("--outputs", ""), ',')) {
    const std::string name(csv::trimmed(text));
    const std::optional<NamedOutput> output = output_named(name, where);
    if (!output)
      throw UsageError(where + ": no output " + quoted(name) + did_you_mean(name, output_names()) +
                       "; choose " + one_of(short_output_names()) + "; or " + kOtherOutputs);
    for (const NamedOutput& before : chosen)
      if (before.name == name) throw UsageError(where + ": " + name + " stands there twice");
    chosen.push_back(*output);
  }
  return chosen;
}

}  // namespace tiltrotor::cli

#include "cli/trim_targets.hpp"

#include <algorithm>

#include "cli/errors.hpp"
#include "cli/flight_options.hpp"
#include "cli/named_outputs.hpp"
#include "cli/targeted_trim.hpp"

namespace tiltrotor::cli {

namespace {

constexpr Range bank_range{-80, 80, "deg"};
constexpr Range load_range{0, 5, "g"};

std::vector<std::string> freed_names() {
  std::vector<std::string> names;
  for (const FreedQuantity& quantity : freed_quantities()) names.emplace_back(quantity.column);
  return names;
}

// The values of one option: a set of targets for each.
using Choices = std::vector<TrimTarget>;

Choices choices_of(const Arguments& arguments, const char* option, const char* held, const char* freed,
                   const Range& range) {
  Choices choices;
  for (const double value : arguments.sweep(option, "", range))
    choices.push_back({held, value, freed, option});
  return choices;
}

// power_hp as power_kw, where that is among the names.
InUnit own_name(const std::string& text, const std::vector<std::string>& names) {
  const InUnit in = in_own_unit(text);
  return std::find(names.begin(), names.end(), in.name) == names.end() ? InUnit{text} : in;
}

// "power_kw=0,500"
Choices held_values(const Arguments& arguments, const std::string& text, const std::string& freed) {
  const std::string where = arguments.where("--hold") + " " + text;
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) throw UsageError(where + ": not NAME=VALUE, for example power_kw=0");
  const std::vector<std::string> names = held_quantities();
  const InUnit in = own_name(text.substr(0, equals), names);
  const bool is_load = output_named(in.name, where).has_value();
  const std::string held = is_load ? in.name : names[place_of(in.name, names, where)];
  constexpr Range any{-1e9, 1e9, "in the unit of the name"};
  Choices choices;
  for (const double value : parse_sweep(text.substr(equals + 1), where, any))
    choices.push_back({held, value * in.size, freed, "--hold " + held});
  return choices;
}

void require_one_use(const Arguments& arguments, const std::vector<Choices>& all) {
  std::vector<std::string> freed, held;
  for (const Choices& choices : all) {
    const TrimTarget& one = choices.front();
    const std::string where = arguments.command() + ": " + one.option;
    if (std::count(freed.begin(), freed.end(), one.freed) > 0)
      throw UsageError(where + ": lets " + one.freed + " go, which another option does already");
    if (std::count(held.begin(), held.end(), one.held) > 0)
      throw UsageError(where + ": holds " + one.held + ", which another option does already");
    freed.push_back(one.freed);
    held.push_back(one.held);
    const FreedQuantity& quantity = freed_quantity(one.freed);
    const std::string option = quantity.option;
    if (!arguments.given(option)) continue;
    if (one.option.rfind("--hold", 0) != 0)
      throw UsageError(where + ": lets " + one.freed + " go: leave " + option + " out");
    if (arguments.sweep(option, "", quantity.range).size() > 1)
      throw UsageError(arguments.where(option) + ": --free " + one.freed +
                       " begins its search there: one value, not several");
  }
  const auto frees = [&](const char* name) { return std::count(freed.begin(), freed.end(), name) > 0; };
  if (arguments.given("--azimuth") && frees("sideslip_deg"))
    throw UsageError(arguments.where("--azimuth") + ": sets the sideslip, which another option lets go");
}

}  // namespace

const std::vector<FreedQuantity>& freed_quantities() {
  static const std::vector<FreedQuantity> all = {
      {"speed_mps", "--speed", kSpeedRange, 4},
      {"climb_deg", "--climb", kClimbRange, 2},
      {"sideslip_deg", "--sideslip", kAngleRange, 2},
      {"turn_rate_degps", "--turn-rate", kTurnRateRange, 2},
      {"rotor_rpm", "--rotor-rpm", kRotorSpeedRange, 20},
      {"altitude_m", "--altitude", kAltitudeRange, 500},
      {"mass_kg", "--mass", kMassRange, 200},
      {"cg_sl_in", "--cg-sl", kCgRange, 1},
      {"flap_deg", "--flap", kFlapRange, 5},
  };
  return all;
}

const FreedQuantity& freed_quantity(const std::string& column) {
  const auto& all = freed_quantities();
  return *std::find_if(all.begin(), all.end(), [&](const FreedQuantity& q) { return column == q.column; });
}

OptionList target_list() {
  return {
      {"--bank", "DEG", "roll angle, -80..80; the turn rate follows"},
      {"--load-factor", "N", "0..5, by a turn to the right; the turn rate follows"},
      {"--ball", "STATE", "centred: no side force (ny = 0); the sideslip follows"},
      {"--hold", "NAME=VALUE",
       "a result of trim in its unit (power_kw, collective75_deg, ny, ...) or an\noutput as --columns knows it (power_right, nz@230/0/75), each with its\n--free; repeatable",
       true},
      {"--free", "NAME",
       "what follows instead: speed_mps, climb_deg, sideslip_deg,\nturn_rate_degps, rotor_rpm, altitude_m, "
       "mass_kg, cg_sl_in or\nflap_deg; the search begins at the value given; repeatable",
       true},
  };
}

std::vector<TrimTargets> target_sets(const Arguments& arguments) {
  const std::vector<std::string> holds = arguments.texts("--hold"), frees = arguments.texts("--free");
  if (holds.size() != frees.size())
    throw UsageError(arguments.where(holds.size() > frees.size() ? "--hold" : "--free") + ": " +
                     std::to_string(holds.size()) + " --hold and " + std::to_string(frees.size()) +
                     " --free; each --hold lets one --free go");
  std::vector<Choices> all;
  for (std::size_t k = 0; k < holds.size(); ++k) {
    const std::vector<std::string> names = freed_names();
    all.push_back(
        held_values(arguments, holds[k],
                    names[place_of(own_name(frees[k], names).name, names, arguments.where("--free"))]));
  }
  if (arguments.given("--bank"))
    all.push_back(choices_of(arguments, "--bank", "roll_deg", "turn_rate_degps", bank_range));
  if (arguments.given("--load-factor"))
    all.push_back(choices_of(arguments, "--load-factor", "load_factor", "turn_rate_degps", load_range));
  if (arguments.given("--ball")) {
    (void)arguments.choice("--ball", "", {"centred"});
    all.push_back({{"ny", 0, "sideslip_deg", "--ball"}});
  }
  constexpr std::size_t most = 3;
  if (all.size() > most)
    throw UsageError(arguments.command() + ": at most 3 quantities can be held at once, not " +
                     std::to_string(all.size()));
  std::vector<std::size_t> sizes;
  for (const Choices& choices : all) sizes.push_back(choices.size());
  require_few(arguments.command(), sizes);
  require_one_use(arguments, all);
  std::vector<TrimTargets> sets(1);
  for (const Choices& choices : all) {
    std::vector<TrimTargets> longer;
    for (const TrimTargets& set : sets) {
      for (const TrimTarget& target : choices) {
        longer.push_back(set);
        longer.back().push_back(target);
      }
    }
    sets = longer;
  }
  return sets;
}

}  // namespace tiltrotor::cli

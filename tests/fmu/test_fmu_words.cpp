// What the FMU says: which variable, its value, its range, what is missing. Expected: names of the description, the words.
#include "tiltrotor/tiltrotor.h"

#ifndef TR_SINGLE_PRECISION
#include <algorithm>
#include <cstdio>
#include <limits>

#include "fmu/master.hpp"

using namespace fmu;
using namespace tiltrotor_fmu;

namespace {

constexpr int kMastCommand = TR_CONTROLS, kFlapCommand = kMastCommand + 1, kRotorCommand = kMastCommand + 2,
              kThrottleRight = kMastCommand + 3, kThrottleLeft = kMastCommand + 4;

// The line of a variable in the description.
std::string line_of(Reference at) {
  static const std::string text = description();
  const std::size_t begin =
      text.find("valueReference=\"" + std::to_string(at) + "\"", text.find("<ModelVariables>"));
  const std::size_t start = text.rfind('<', begin);
  return text.substr(start, text.find("/>", start) - start);
}
bool is_of(Reference at, const char* type) { return line_of(at).find(std::string("<") + type + " ") == 0; }

// Whatever its type is.
fmi3Status set_any(const Master& m, Reference at, double value) {
  const bool on = value != 0;
  const auto whole = static_cast<std::int64_t>(value);
  const auto natural = static_cast<std::uint32_t>(whole);
  return is_of(at, "Boolean")       ? FMI(fmi3SetBoolean)(m.instance, &at, 1, &on, 1)
         : is_of(at, "Enumeration") ? FMI(fmi3SetInt64)(m.instance, &at, 1, &whole, 1)
         : is_of(at, "UInt32")      ? FMI(fmi3SetUInt32)(m.instance, &at, 1, &natural, 1)
                                    : m.set(at, value);
}

fmi3Status initialize(const Master& m) {
  CHECK_EQ(FMI(fmi3EnterInitializationMode)(m.instance, false, 0, 0, false, 0), fmi3OK);
  return FMI(fmi3ExitInitializationMode)(m.instance);
}

bool says(const std::string& line, const std::string& words) { return line.find(words) != std::string::npos; }

// The last line has all of the words.
void check_last(const Master& m, std::initializer_list<std::string> words) {
  if (!CHECK(!m.log.empty())) return;
  for (const std::string& each : words)
    if (!CHECK(says(m.log.back(), each))) NOTE(m.log.back() << " does not say " << each);
}

// What each needs, with switches that make it act, and those that make it idle where none is on.
struct Need {
  Reference what;
  double value;
  const char *name, *needed;
  std::vector<std::pair<int, double>> with, without = {};
};
const std::vector<Need>& needs() {
  const std::vector<std::pair<int, double>> air = {{kEnvironment, 1}},
                                            gear = {{kEnvironment, 1}, {kGear, 1}, {kGroundDown, 900}},
                                            pi = {{kGovernor, 2}}, engines = {{kEngines, 1}};
  static const std::vector<Need> all = {
      {input(TR_COLLECTIVE), 0.2, "input.collective", "parameter.governor = 0, off", {}, {{kGovernor, 1}}},
      {input(kMastCommand), 0.3, "input.mast_command", "parameter.conversion = true", {{kConversion, 1}}},
      {input(kFlapCommand), 0.3, "input.flap_command", "parameter.conversion = true", {{kConversion, 1}}},
      {input(kRotorCommand), 50, "input.rotor_command", "parameter.governor = 2", pi},
      {input(kThrottleRight), 0.9, "input.throttle_R", "parameter.governor or parameter.engines", engines},
      {input(kThrottleLeft), 0.9, "input.throttle_L", "parameter.governor or parameter.engines", pi},
      {setting(kEngineFailedRight), 1, "input.engine_failed_R", "parameter.governor or ", engines},
      {setting(kEngineFailedLeft), 1, "input.engine_failed_L", "parameter.governor or ", engines},
      {setting(kBrakeRight), 1, "input.brake_R", "parameter.gear = true", gear},
      {setting(kBrakeLeft), 1, "input.brake_L", "parameter.gear = true", gear},
      {setting(kGearDown), 0, "input.gear_down", "parameter.gear = true", gear},
      {setting(kWindNorth), 3, "input.wind_north", "parameter.environment = true", air},
      {setting(kWindEast), 3, "input.wind_east", "parameter.environment = true", air},
      {setting(kWindDown), 1, "input.wind_down", "parameter.environment = true", air},
      {setting(kTemperatureOffset), 9, "parameter.temperature_offset", "parameter.environment = true", air},
      {setting(kPressureRatio), 0.9, "parameter.pressure_ratio", "parameter.environment = true", air},
      {setting(kGroundDown), 99, "parameter.ground_down", "parameter.environment = true", gear},
      {setting(kTurbulenceSeed), 4, "parameter.turbulence_seed", "parameter.turbulence", {{kTurbulence, 1}}},
      {setting(kTurbulenceW20), 5, "parameter.turbulence_w20", "parameter.turbulence", {{kTurbulence, 1}}},
      {setting(kTrimSpeed), 5, "parameter.speed", "parameter.trim = true", {}, {{kTrim, 0}}},
      {setting(kInterconnect), 1, "parameter.interconnect", "parameter.governor = 2", pi},
      {state(TR_MAST), 0.2, "state.mast", "parameter.conversion = true", {{kConversion, 1}}},
      {state(TR_ROTOR_SPEED), 50, "state.rotor_speed", "parameter.governor = 2", pi},
      {state(TR_GOVERNOR), 0.01, "state.governor", "parameter.governor", pi},
      {state(TR_FUEL), 10, "state.fuel", "parameter.engines = true", engines},
      {state(TR_TWIST_RATE),
       0.1,
       "state.twist_rate",
       "parameter.interconnect",
       {{kGovernor, 2}, {kInterconnect, 1}}},
      {state(TR_ACTUATORS + 6), 0.1, "state.rudder_angle", "parameter.actuators", {{kActuators, 1}}},
      {state(TR_CONING_LEFT), 0.1, "state.b0_L", "parameter.coning = true", {{kConing, 1}}},
  };
  return all;
}

}  // namespace

// At the end of initialization an error: it was asked for. With what it needs it is none, and the value acts.
TEST(fmu_what_changes_nothing_is_an_error_that_names_what_it_needs) {
  for (const Need& need : needs()) {
    Master m(Master::co_simulation);
    for (const auto& [setting_of, value] : need.without)
      CHECK_EQ(set_any(m, setting(setting_of), value), fmi3OK);
    CHECK_EQ(set_any(m, need.what, need.value), fmi3OK);
    m.log.clear();
    if (!CHECK_EQ(initialize(m), fmi3Error)) NOTE(need.name);
    CHECK_EQ(m.log.size(), 1u);
    check_last(m, {need.name, need.needed});
    Master with(Master::co_simulation);
    for (const auto& [setting_of, value] : need.with)
      CHECK_EQ(set_any(with, setting(setting_of), value), fmi3OK);
    CHECK_EQ(set_any(with, need.what, need.value), fmi3OK);
    if (!CHECK_LE(initialize(with), fmi3Warning)) NOTE(need.name << ": " << with.log.back());
  }
}

// An importer steps in Model Exchange.
TEST(fmu_longest_step_is_of_co_simulation) {
  Master m(Master::model_exchange);
  CHECK_EQ(m.set(setting(kLongestStep), 0.005), fmi3OK);
  CHECK_EQ(initialize(m), fmi3Error);
  check_last(m, {"parameter.longest_step is set and changes nothing", "Co-Simulation"});
  CHECK(says(line_of(setting(kLongestStep)), "in Co-Simulation"));
  Master steps(Master::co_simulation);
  CHECK_EQ(steps.set(setting(kLongestStep), 0.005), fmi3OK);
  CHECK_EQ(initialize(steps), fmi3OK);
}

// In flight a warning, the first time, and the flight is the same; no warning where it acts.
TEST(fmu_idle_inputs_are_told_once_in_flight) {
  const auto fly = [](Master& m) {
    for (int step = 0; step < 5; ++step) CHECK_EQ(m.step(step * 0.01, 0.01), fmi3OK);
    std::vector<double> x;
    for (int k = 0; k < TR_STATES; ++k) x.push_back(m.get(state(k)));
    return x;
  };
  for (const Need& need : needs()) {
    if (attribute(line_of(need.what), "causality") != "input") continue;
    Master untouched(Master::co_simulation), m(Master::co_simulation);
    for (Master* const each : {&untouched, &m}) {
      for (const auto& [setting_of, value] : need.without)
        CHECK_EQ(set_any(*each, setting(setting_of), value), fmi3OK);
      CHECK_LE(each->start(0, 40), fmi3Warning);
    }
    m.log.clear();
    if (!CHECK_EQ(set_any(m, need.what, need.value), fmi3Warning)) NOTE(need.name);
    check_last(m, {need.name, need.needed});
    const auto warnings = [&m, &need] {
      return std::count_if(m.log.begin(), m.log.end(), [&](const std::string& line) {
        return says(line, need.name) && says(line, "needs");
      });
    };
    const double again = is_of(need.what, "Boolean") ? 1 - need.value : 0.9 * need.value;
    CHECK_EQ(set_any(m, need.what, again), fmi3OK);
    CHECK_EQ(warnings(), 1);
    // An ideal governor begins its search where the lever is, and counts from there what it adds.
    const std::vector<double> expected = fly(untouched), found = fly(m);
    for (std::size_t k = 0; k < found.size(); ++k)
      if (need.without.empty() || k != TR_GOVERNOR)
        CHECK_NEAR(found[k], expected[k], need.without.empty() ? 0 : 1e-6);
    Master with(Master::co_simulation);
    for (const auto& [setting_of, value] : need.with)
      CHECK_EQ(set_any(with, setting(setting_of), value), fmi3OK);
    CHECK_LE(with.start(0, 40), fmi3Warning);
    if (!CHECK_EQ(set_any(with, need.what, need.value), fmi3OK)) NOTE(need.name << ": " << with.log.back());
  }
}

// Whether what it belongs to is on or not, before the flight and in it.
TEST(fmu_numbers_out_of_range_are_told_with_value_and_range) {
  const struct {
    Reference what;
    double value;
    const char* name;
    bool in_flight;
  } numbers[] = {{input(TR_PEDAL), 9, "input.pedal = 9 ", true},
                 {input(TR_GUST_V), -77, "input.gust_v = -77 ", true},
                 {input(kMastCommand), 9, "input.mast_command = 9 ", true},
                 {input(kRotorCommand), 900, "input.rotor_command = 900 ", true},
                 {input(kThrottleRight), 9, "input.throttle_R = 9 ", true},
                 {setting(kBrakeLeft), 2, "input.brake_L = 2 ", true},
                 {setting(kWindNorth), 200, "input.wind_north = 200 ", true},
                 {setting(kTrimSpeed), -1, "parameter.speed = -1 ", false},
                 {setting(kMass), 1, "parameter.mass = 1 ", false},
                 {setting(kAltitude), 5e4, "parameter.altitude = 50000 ", false},
                 {setting(kMast), 2, "parameter.mast = 2 ", false},
                 {state(TR_U), 1e9, "state.u = 1000000000 ", false},
                 {state(TR_PITCH), 2, "state.theta = 2 ", false}};
  for (const auto& number : numbers) {
    Master m(Master::co_simulation);
    const std::string line = line_of(number.what);
    char ends[80];
    std::snprintf(ends, sizeof ends, "lies outside %.10g..%.10g", std::stod(attribute(line, "min")),
                  std::stod(attribute(line, "max")));
    const auto refused = [&] {
      const double before = m.get(number.what);
      CHECK_EQ(m.set(number.what, number.value), fmi3Error);
      check_last(m, {number.name, ends, attribute(line, "unit")});
      CHECK_EQ(m.get(number.what), before);
    };
    refused();
    CHECK_EQ(initialize(m), fmi3OK);
    if (number.in_flight) refused();
  }
}

TEST(fmu_refused_states_are_named) {
  Master m(Master::model_exchange);
  CHECK_EQ(m.set_switch(kEnvironment, true), fmi3OK);
  CHECK_EQ(m.start(0, 40), fmi3OK);
  std::vector<double> x = m.states();
  const auto refused = [&](std::size_t k, double value, fmi3Status status,
                           std::initializer_list<std::string> words) {
    std::vector<double> y = x;
    y[k] = value;
    CHECK_EQ(FMI(fmi3SetContinuousStates)(m.instance, y.data(), y.size()), status);
    check_last(m, words);
  };
  refused(TR_Q, 1000, fmi3Discard, {"continuous states", "state.q = 1000 ", "-20..20 rad/s"});
  refused(TR_DOWN, -20000, fmi3Discard,
          {"continuous states", "state.down = -20000 m", "altitude of 20000 m"});
  refused(TR_R, std::numeric_limits<double>::quiet_NaN(), fmi3Error, {"state.r ", "no finite number"});
  Master high(Master::model_exchange);
  CHECK_EQ(high.set_switch(kEnvironment, true), fmi3OK);
  CHECK_EQ(high.set(state(TR_DOWN), -20000), fmi3OK);
  CHECK_EQ(initialize(high), fmi3Error);
  check_last(high, {"start states", "state.down = -20000 m", "altitude of 20000 m"});
}

TEST(fmu_refusals_name_the_variable_and_the_mode) {
  Master m(Master::model_exchange);
  CHECK_EQ(m.set(rate(TR_U), 1), fmi3Error);
  check_last(m, {"der(state.u) ", "after instantiation", "computed"});
  CHECK_EQ(m.start(0, 40), fmi3OK);
  const struct {
    Reference what;
    const char *name, *words;
  } refused[] = {{rate(TR_U), "der(state.u) ", "computed"},
                 {output(0), "output.airspeed ", "computed"},
                 {reference_of(Role::indicator, 1), "wheel_height.right ", "computed"},
                 {state(TR_U), "state.u ", "fmi3SetContinuousStates"},
                 {setting(kMast), "parameter.mast ", "fixed"},
                 {setting(kWindNorth), "input.wind_north ", "in event mode"}};
  for (const auto& each : refused) {
    CHECK_EQ(m.set(each.what, 1), fmi3Error);
    check_last(m, {each.name, "in continuous-time mode", each.words});
  }
  CHECK_EQ(m.set(input(0), std::numeric_limits<double>::infinity()), fmi3Error);
  check_last(m, {"input.collective ", "no finite number", ".."});
  bool flag = false;
  double number = 0;
  CHECK_EQ(FMI(fmi3UpdateDiscreteStates)(m.instance, &flag, &flag, &flag, &flag, &flag, &number), fmi3Error);
  check_last(m, {"fmi3UpdateDiscreteStates", "not allowed in continuous-time mode"});
}

namespace {
struct Line {
  fmi3Status status;
  std::string category, text;
};
void keep_line(fmi3InstanceEnvironment log, fmi3Status status, fmi3String category, fmi3String message) {
  static_cast<std::vector<Line>*>(log)->push_back({status, category, message});
}

// Into the ground, with the gear on: warnings and events on the way, then a step that cannot be made.
std::vector<Line> lines_of_a_crash(bool logging) {
  std::vector<Line> log;
  const std::string token = attribute(description(), "instantiationToken");
  const fmi3Instance one = FMI(fmi3InstantiateCoSimulation)("one", token.c_str(), "", false, logging, false,
                                                            false, nullptr, 0, &log, keep_line, nullptr);
  const Reference switches[] = {setting(kEnvironment), setting(kGear)}, ground = setting(kGroundDown);
  const bool on[] = {true, true};
  const double above = -50;
  CHECK_EQ(FMI(fmi3SetBoolean)(one, switches, 2, on, 2), fmi3OK);
  CHECK_EQ(FMI(fmi3SetFloat64)(one, &ground, 1, &above, 1), fmi3OK);
  CHECK_EQ(FMI(fmi3EnterInitializationMode)(one, false, 0, 0, false, 0), fmi3OK);
  CHECK_LE(FMI(fmi3ExitInitializationMode)(one), fmi3Warning);
  const Reference idle = input(kMastCommand);
  const double command = 0.2;
  CHECK_EQ(FMI(fmi3SetFloat64)(one, &idle, 1, &command, 1), fmi3Warning);
  fmi3Status status = fmi3OK;
  for (int step = 0; step < 300 && status == fmi3OK; ++step) {
    bool event = true, terminate = true, early = true;
    double reached = 0;
    status = FMI(fmi3DoStep)(one, step * 0.01, 0.01, true, &event, &terminate, &early, &reached);
  }
  CHECK_EQ(status, fmi3Discard);
  CHECK_EQ(FMI(fmi3Terminate)(one), fmi3OK);
  FMI(fmi3FreeInstance)(one);
  return log;
}
}  // namespace

// Without a log that is asked for: what went wrong. With it: events, too.
TEST(fmu_log_has_warnings_and_discards_and_where_asked_for_events) {
  const auto count = [](const std::vector<Line>& log, fmi3Status status, const std::string& category) {
    return std::count_if(log.begin(), log.end(), [&](const Line& line) {
      return line.status == status && line.category == category;
    });
  };
  for (const bool logging : {false, true}) {
    const std::vector<Line> log = lines_of_a_crash(logging);
    CHECK_EQ(count(log, fmi3Discard, "logStatusDiscard"), 1);
    CHECK_LE(1, count(log, fmi3Warning, "logStatusWarning"));
    CHECK_EQ(count(log, fmi3OK, "logEvents"), logging ? 2 : 0);  // it begins and ends
    for (const Line& line : log)
      if (line.status == fmi3Discard && !CHECK(says(line.text, "state.") && says(line.text, "..")))
        NOTE(line.text);
  }
}
#endif

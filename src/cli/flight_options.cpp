#include "cli/flight_options.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/errors.hpp"
#include "cli/model_options.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/model/preparation.hpp"
#include "tiltrotor/model/setup/setup_explanation.hpp"
#include "tiltrotor/model/variables/presets.hpp"

namespace tiltrotor::cli {

namespace {

constexpr double radian = kRadPerDeg<double>;

constexpr Range climb_range{-90, 90, "deg"};
constexpr Range turn_rate_range{-60, 60, "deg/s"};

std::optional<double> optional_number(const Arguments& arguments, const char* name, const Range& range) {
  if (!arguments.given(name)) return std::nullopt;
  return arguments.number(name, 0, range);
}

// Nothing, as the only value, where the option is not given.
std::vector<std::optional<double>> optional_numbers(const Arguments& arguments, const char* name,
                                                    const Range& range) {
  if (!arguments.given(name)) return {std::nullopt};
  std::vector<std::optional<double>> values;
  for (const double value : arguments.sweep(name, "", range)) values.emplace_back(value);
  return values;
}

// "3000..10000"
std::string limits_text(const Range& range) {
  return number_text(range.low) + ".." + number_text(range.high);
}

Option altitude_option() {
  static const std::string help = limits_text(kAltitudeRange) + ", standard atmosphere (0)";
  return {"--altitude", "M", help.c_str()};
}

double inward(double x, double size, bool up) {
  constexpr double digits = 3;
  constexpr double rounding = 1e-9;
  if (x == 0) return 0;
  const double place = std::pow(10, std::ceil(std::log10(std::abs(x / size))) - digits);
  const double steps = x / size / place;
  return (up ? std::ceil(steps - rounding) : std::floor(steps + rounding)) * place;
}

const OptionList switch_options = {
    {"--tables", "KIND", "interpolation: c1 or linear (c1)"},
    {"--grid", "KIND", "blade stations: specification or realtime (specification)"},
    {"--preset", "NAME", "reference: the model of the independent implementation, for comparison"},
    {"--option", "NAME=VALUE", "any other switch of the model, repeatable; listed below", true},
};

}  // namespace

Configuration<double> prepared(const FlightSetup<double>& setup, const std::string& where) {
  Configuration<double> configuration;
  const Status status = prepare(aircraft_data<double>(), setup, configuration);
  if (status == Status::ok) return configuration;
  constexpr int longest = 120;
  char fault[longest];
  const bool explained = explain(first_out_of_range(aircraft_data<double>(), setup), fault, longest) > 0;
  throw UsageError(
      where + "mast " + number_text(setup.mast_deg) +
      " deg: this configuration cannot be prepared: " + (explained ? fault : status_text(status)));
}

Range shown_range(SetupField field, double unit, const char* unit_name) {
  const Bounds<double> range = setup_range(aircraft_data<double>(), field);
  return {inward(range.low, unit, true), inward(range.high, unit, false), unit_name};
}

Range speed_range() { return {0, inward(aircraft_data<double>().limits.speed, 1, false), "m/s"}; }

OptionList SetupOptions::list() {
  const Aircraft<double>& a = aircraft_data<double>();
  constexpr int digits = 5;
  static const std::string flap = limits_text(kFlapRange) +
                                  " (mast 0: " + number_text(a.defaults.flap_helicopter) +
                                  "; mast 90: " + number_text(a.defaults.flap_airplane) +
                                  "; between: " + number_text(a.defaults.flap_conversion) + ")";
  static const std::string rotor = limits_text(kRotorSpeedRange) +
                                   " (mast 90: " + number_text(a.rotor.speed_airplane / kRpm, digits) +
                                   "; else " + number_text(a.rotor.speed_helicopter / kRpm, digits) + ")";
  static const std::string mass = limits_text(kMassRange) + " (" + number_text(a.mass.gross, digits) + ")";
  static const std::string station = "station of the CG at mast 0, " + limits_text(kCgRange) + " (" +
                                     number_text(a.mass.sl_cg / kInch, digits) + ")";
  const OptionList aircraft = {
      altitude_option(),
      {"--flap", "DEG", flap.c_str()},
      {"--rotor-rpm", "RPM", rotor.c_str()},
      {"--mass", "KG", mass.c_str()},
      {"--cg-sl", "IN", station.c_str()},
  };
  return aircraft + switch_options;
}

OptionList SetupOptions::rotor_list() { return OptionList{altitude_option()} + switch_options; }

SetupOptions::SetupOptions(const Arguments& arguments) : SetupOptions(arguments, Common{}) {
  altitude_ = optional_number(arguments, "--altitude", kAltitudeRange);
  mass_ = optional_number(arguments, "--mass", kMassRange);
  cg_sl_in_ = optional_number(arguments, "--cg-sl", kCgRange);
  flap_deg_ = optional_number(arguments, "--flap", kFlapRange);
}

std::vector<SetupOptions> SetupOptions::every_combination(const Arguments& arguments) {
  const auto altitudes = optional_numbers(arguments, "--altitude", kAltitudeRange);
  const auto masses = optional_numbers(arguments, "--mass", kMassRange);
  const auto stations = optional_numbers(arguments, "--cg-sl", kCgRange);
  const auto flaps = optional_numbers(arguments, "--flap", kFlapRange);
  require_few(arguments.command(), {altitudes.size(), masses.size(), stations.size(), flaps.size()});
  std::vector<SetupOptions> all;
  SetupOptions one(arguments, Common{});
  for (const auto& altitude : altitudes) {
    for (const auto& mass : masses) {
      for (const auto& station : stations) {
        for (const auto& flap : flaps) {
          one.altitude_ = altitude;
          one.mass_ = mass;
          one.cg_sl_in_ = station;
          one.flap_deg_ = flap;
          all.push_back(one);
        }
      }
    }
  }
  return all;
}

SetupOptions::SetupOptions(const Arguments& arguments, Common)
    : rotor_rpm_(optional_number(arguments, "--rotor-rpm", kRotorSpeedRange)) {
  std::vector<std::string> assigned;
  if (arguments.given("--preset")) {
    place_of(arguments.text("--preset", ""), {"reference"}, arguments.where("--preset"));
    choose_reference(switches_);
  }
  for (const std::string& assignment : arguments.texts("--option")) {
    const std::string where = arguments.where("--option") + " " + assignment;
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos) throw UsageError(where + ": not NAME=VALUE, for example grid=realtime");
    const std::string name = assignment.substr(0, equals);
    set_model_option(switches_, name, assignment.substr(equals + 1), where);
    const bool twice = std::find(assigned.begin(), assigned.end(), name) != assigned.end();
    if (twice || arguments.given("--" + name)) {
      throw UsageError(where + ": " + name + " is given more than once" +
                       (twice ? "" : "; --" + name + " stands there too"));
    }
    assigned.push_back(name);
  }
  for (const char* name : {"tables", "grid"}) {
    const std::string option = std::string("--") + name;
    if (arguments.given(option)) {
      set_model_option(switches_, name, arguments.text(option, ""), arguments.where(option));
    }
  }
}

FlightSetup<double> SetupOptions::flight_setup(double mast_deg) const {
  FlightSetup<double> setup = tiltrotor::flight_setup(aircraft_data<double>(), mast_deg);
  setup.altitude = altitude_.value_or(0);
  setup.flap_deg = flap_deg_.value_or(setup.flap_deg);
  if (rotor_rpm_) setup.rotor_speed = *rotor_rpm_ * kRpm;
  setup.mass = mass_.value_or(setup.mass);
  if (cg_sl_in_) setup.sl_cg = *cg_sl_in_ * kInch;
  setup.options = switches_;
  return setup;
}

std::string SetupOptions::text() const {
  constexpr int digits = 6;
  std::string given;
  if (altitude_) given += ", " + number_text(*altitude_, digits) + " m";
  if (mass_) given += ", " + number_text(*mass_, digits) + " kg";
  if (cg_sl_in_) given += ", CG at " + number_text(*cg_sl_in_, digits) + " in";
  if (flap_deg_) given += ", flaps " + number_text(*flap_deg_, digits) + " deg";
  return given;
}

std::optional<double> SetupOptions::given(const std::string& column) const {
  const std::pair<const char*, std::optional<double>> settings[] = {{"altitude_m", altitude_},
                                                                    {"flap_deg", flap_deg_},
                                                                    {"rotor_rpm", rotor_rpm_},
                                                                    {"mass_kg", mass_},
                                                                    {"cg_sl_in", cg_sl_in_}};
  for (const auto& [name, value] : settings)
    if (column == name) return value;
  return std::nullopt;
}

Configuration<double> SetupOptions::configuration(double mast_deg) const {
  return prepared(flight_setup(mast_deg));
}

Configuration<double> SetupOptions::configuration(double mast_deg, double rotor_speed) const {
  FlightSetup<double> setup = flight_setup(mast_deg);
  setup.rotor_speed = rotor_speed;
  return prepared(setup);
}

OptionList mast_option() { return {{"--mast", "DEG", "mast angle: 0 helicopter .. 90 airplane (0)"}}; }

OptionList flight_list() {
  static const std::string speed = "true airspeed, " + limits_text(kSpeedRange) + " (0)";
  return {
      {"--mast", "DEG", "mast angle: 0 helicopter .. 90 airplane (0)"},
      {"--speed", "MPS", speed.c_str()},
      {"--climb", "DEG", "angle of the flight path, -90..90, at speed 0, below 1e-15, it\nmust be 0 (0)"},
      {"--sideslip", "DEG", "wind from the right, -60..60, at speed 0 and climb +-90 it must\nbe 0 (0)"},
      {"--turn-rate", "DEGPS", "of the heading, + right, -60..60 (0)"},
  };
}

std::vector<FlightCase> flight_cases(const Arguments& arguments, std::size_t setups) {
  SteadyFlight<double> flight{};
  const double climb = arguments.number("--climb", 0, climb_range);
  const double sideslip = arguments.number("--sideslip", 0, kAngleRange);
  const double turn_rate = arguments.number("--turn-rate", 0, turn_rate_range);
  flight.climb = climb * radian;
  flight.sideslip = sideslip * radian;
  flight.turn_rate = turn_rate * radian;
  std::vector<FlightCase> cases;
  const std::vector<double> speeds = arguments.sweep("--speed", "0", kSpeedRange);
  const std::vector<double> masts = arguments.sweep("--mast", "0", kMastRange);
  require_few(arguments.command(), {setups, masts.size(), speeds.size()});
  for (std::size_t setup = 0; setup < setups; ++setup) {
    for (const double mast_deg : masts) {
      for (const double speed : speeds) {
        flight.speed = speed;
        cases.push_back({setup, mast_deg, flight, climb, sideslip, turn_rate});
      }
    }
  }
  return cases;
}

}  // namespace tiltrotor::cli

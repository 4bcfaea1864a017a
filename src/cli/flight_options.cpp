#include "cli/flight_options.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "cli/errors.hpp"
#include "cli/impossible_flight.hpp"
#include "cli/model_options.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/model/aircraft/c2_aircraft.hpp"
#include "tiltrotor/model/preparation.hpp"
#include "tiltrotor/model/setup/setup_explanation.hpp"
#include "tiltrotor/model/variables/presets.hpp"

namespace tiltrotor::cli {

namespace {

constexpr double radian = kRadPerDeg<double>;

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

// An aircraft on so many of its engines; it lives as long as the program.
const Aircraft<double>& with_engines(const Aircraft<double>& aircraft, int engines) {
  static std::map<std::pair<bool, int>, Aircraft<double>> all;
  const auto place = all.emplace(std::pair(has_c2_tables(aircraft), engines), aircraft).first;
  place->second.controls.engines = engines;
  return place->second;
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
    {"--tables", "KIND", "interpolation: c1, linear or c2 (c1)"},
    {"--grid", "KIND", "blade stations: specification or realtime (specification)"},
    {"--preset", "NAME", "reference: the model of the independent implementation, for comparison"},
    {"--option", "NAME=VALUE", "any other switch of the model, repeatable; listed below", true},
};

}  // namespace

Configuration<double> prepared(const Aircraft<double>& aircraft, const FlightSetup<double>& setup,
                               const std::string& where) {
  Configuration<double> configuration;
  const Status status = prepare(aircraft, setup, configuration);
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

Range isa_offset_range() {
  const double most = aircraft_data<double>().limits.warmer;
  return {-most, most, "K"};
}

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
  static const std::string offset =
      "warmer than the standard atmosphere, " + limits_text(isa_offset_range()) + " (0)";
  static const std::string engines =
      "that run, 1.." + std::to_string(a.controls.engines) + " (all): power_limit is what they give";
  const OptionList aircraft = {
      altitude_option(),
      {"--flap", "DEG", flap.c_str()},
      {"--rotor-rpm", "RPM", rotor.c_str()},
      {"--mass", "KG", mass.c_str()},
      {"--cg-sl", "IN", station.c_str()},
      {"--isa-offset", "K", offset.c_str()},
      {"--engines", "N", engines.c_str()},
  };
  return aircraft + switch_options;
}

OptionList SetupOptions::rotor_list() { return OptionList{altitude_option()} + switch_options; }

SetupOptions::SetupOptions(const Arguments& arguments) : SetupOptions(arguments, Common{}) {
  altitude_ = optional_number(arguments, "--altitude", kAltitudeRange);
  mass_ = optional_number(arguments, "--mass", kMassRange);
  cg_sl_in_ = optional_number(arguments, "--cg-sl", kCgRange);
  flap_deg_ = optional_number(arguments, "--flap", kFlapRange);
  rotor_rpm_ = optional_number(arguments, "--rotor-rpm", kRotorSpeedRange);
  isa_offset_ = optional_number(arguments, "--isa-offset", isa_offset_range());
}

std::vector<SetupOptions> SetupOptions::every_combination(const Arguments& arguments) {
  const auto altitudes = optional_numbers(arguments, "--altitude", kAltitudeRange);
  const auto masses = optional_numbers(arguments, "--mass", kMassRange);
  const auto stations = optional_numbers(arguments, "--cg-sl", kCgRange);
  const auto flaps = optional_numbers(arguments, "--flap", kFlapRange);
  const auto rotor_speeds = optional_numbers(arguments, "--rotor-rpm", kRotorSpeedRange);
  const auto offsets = optional_numbers(arguments, "--isa-offset", isa_offset_range());
  require_few(arguments.command(), {altitudes.size(), masses.size(), stations.size(), flaps.size(),
                                    rotor_speeds.size(), offsets.size()});
  std::vector<SetupOptions> all;
  SetupOptions one(arguments, Common{});
  for (const auto& altitude : altitudes) {
    for (const auto& mass : masses) {
      for (const auto& station : stations) {
        for (const auto& flap : flaps) {
          for (const auto& rotor_speed : rotor_speeds) {
            for (const auto& offset : offsets) {
              one.altitude_ = altitude;
              one.mass_ = mass;
              one.cg_sl_in_ = station;
              one.flap_deg_ = flap;
              one.rotor_rpm_ = rotor_speed;
              one.isa_offset_ = offset;
              all.push_back(one);
            }
          }
        }
      }
    }
  }
  return all;
}

SetupOptions::SetupOptions(const Arguments& arguments, Common) {
  if (arguments.given("--engines"))
    engines_ = static_cast<int>(parse_integer(arguments.text("--engines", ""), arguments.where("--engines"),
                                              1, aircraft_data<double>().controls.engines));
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
  const bool flies = arguments.command() == "fly";
  if (flies && std::find(assigned.begin(), assigned.end(), "governor") != assigned.end())
    throw UsageError(arguments.where("--option") +
                     " governor: a script says it, in a line as '0 governor ideal'; it begins with pi");
  if (switches_.interconnect == Interconnect::twists && switches_.governor != Governor::pi && !flies)
    throw UsageError(arguments.where("--option") + " interconnect=twists: goes with governor=pi alone");
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

const Aircraft<double>& SetupOptions::aircraft() const {
  return switches_.c2_tables ? c2_aircraft_data() : aircraft_data<double>();
}

std::string SetupOptions::text() const {
  constexpr int digits = 6;
  std::string given;
  if (altitude_) given += ", " + number_text(*altitude_, digits) + " m";
  if (mass_) given += ", " + number_text(*mass_, digits) + " kg";
  if (cg_sl_in_) given += ", CG at " + number_text(*cg_sl_in_, digits) + " in";
  if (flap_deg_) given += ", flaps " + number_text(*flap_deg_, digits) + " deg";
  if (rotor_rpm_) given += ", " + number_text(*rotor_rpm_, digits) + " rpm";
  if (isa_offset_) given += ", air warmer by " + number_text(*isa_offset_, digits) + " K";
  return given;
}

std::string SetupOptions::model() const {
  std::string text = model_text(switches_);
  if (isa_offset_.value_or(0) != 0)
    text += std::string(" ") + kIsaOffsetWord + "=" + number_text(*isa_offset_);
  if (some_engines_stand()) text += std::string(" ") + kEnginesWord + "=" + std::to_string(engines_);
  return text;
}

int SetupOptions::engines() const {
  return engines_ == 0 ? aircraft_data<double>().controls.engines : engines_;
}

bool SetupOptions::some_engines_stand() const {
  return engines() != aircraft_data<double>().controls.engines;
}

SetupOptions SetupOptions::on_day(double isa_offset, int engines) const {
  SetupOptions other = *this;
  other.isa_offset_ = isa_offset;
  other.engines_ = engines;
  return other;
}

void SetupOptions::surround(Configuration<double>& c) const {
  if (some_engines_stand()) c.aircraft = &with_engines(*c.aircraft, engines_);
  if (!isa_offset_) return;
  c.around.warmer = *isa_offset_;
  configure(c);
}

std::optional<double> SetupOptions::given(const std::string& column) const {
  const std::pair<const char*, std::optional<double>> settings[] = {
      {"altitude_m", altitude_}, {"flap_deg", flap_deg_}, {"rotor_rpm", rotor_rpm_},
      {"mass_kg", mass_},        {"cg_sl_in", cg_sl_in_}, {kWarmerColumn, isa_offset_}};
  for (const auto& [name, value] : settings)
    if (column == name) return value;
  return std::nullopt;
}

Configuration<double> SetupOptions::configuration(double mast_deg) const {
  Configuration<double> c = prepared(aircraft(), flight_setup(mast_deg));
  surround(c);
  return c;
}

Configuration<double> SetupOptions::configuration(double mast_deg, double rotor_speed) const {
  FlightSetup<double> setup = flight_setup(mast_deg);
  setup.rotor_speed = rotor_speed;
  Configuration<double> c = prepared(aircraft(), setup);
  surround(c);
  return c;
}

OptionList mast_option() { return {{"--mast", "DEG", "mast angle: 0 helicopter .. 90 airplane (0)"}}; }

OptionList flight_list() {
  static const std::string speed = "true airspeed, " + limits_text(kSpeedRange) + " (0)";
  const OptionList flight = {
      {"--mast", "DEG", "mast angle: 0 helicopter .. 90 airplane (0)"},
      {"--speed", "MPS", speed.c_str()},
      {"--climb", "DEG", "angle of the flight path, -90..90, at speed 0, below 1e-15, it\nmust be 0 (0)"},
      {"--sideslip", "DEG", "wind from the right, -60..60, at speed 0 and climb +-90 it must\nbe 0 (0)"},
      {"--azimuth", "DEG",
       "instead: where the wind comes from, -180..360, level with the\nground: 0 ahead, 90 right, 180 behind; not at climb +-90"},
      {"--turn-rate", "DEGPS", "of the heading, + right, -60..60 (0)"},
  };
  return flight + target_list();
}

std::vector<FlightCase> flight_cases(const Arguments& arguments, std::size_t setups) {
  const bool by_azimuth = arguments.given("--azimuth");
  if (by_azimuth && arguments.given("--sideslip"))
    throw UsageError(arguments.where("--azimuth") + ": sets the sideslip: leave --sideslip out");
  const std::vector<double> speeds = arguments.sweep("--speed", "0", kSpeedRange);
  const std::vector<double> masts = arguments.sweep("--mast", "0", kMastRange);
  const std::vector<double> climbs = arguments.sweep("--climb", "0", kClimbRange);
  const std::vector<double> sides = by_azimuth ? arguments.sweep("--azimuth", "", kAzimuthRange)
                                               : arguments.sweep("--sideslip", "0", kAngleRange);
  const std::vector<double> turn_rates = arguments.sweep("--turn-rate", "0", kTurnRateRange);
  const std::vector<TrimTargets> targets = target_sets(arguments);
  require_few(arguments.command(), {setups, climbs.size(), sides.size(), turn_rates.size(), targets.size(),
                                    masts.size(), speeds.size()});
  std::vector<FlightCase> cases;
  FlightCase one{};
  const auto add_speeds = [&] {
    for (const double mast_deg : masts) {
      for (const double speed : speeds) {
        one.mast_deg = mast_deg;
        one.flight.speed = speed;
        cases.push_back(one);
      }
    }
  };
  for (one.setup = 0; one.setup < setups; ++one.setup) {
    for (const double climb : climbs) {
      for (const double side : sides) {
        for (const double turn_rate : turn_rates) {
          one.climb_deg = climb;
          if (by_azimuth) one.azimuth_deg = side;
          one.sideslip_deg = by_azimuth ? 0 : side;
          one.turn_rate_degps = turn_rate;
          one.flight = {0, climb * radian, turn_rate * radian, one.sideslip_deg * radian};
          for (const TrimTargets& set : targets) {
            one.targets = set;
            add_speeds();
          }
        }
      }
    }
  }
  if (cases.size() == 1) require_possible(arguments, cases.front());
  return cases;
}

}  // namespace tiltrotor::cli

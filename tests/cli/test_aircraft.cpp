// The aircraft that is compiled in: version, help and results name it, and ranges in help and messages are its own.
#include <string>

#include "check.hpp"
#include "run_program.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

using check::run_tiltrotor;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

const std::string name = tiltrotor::aircraft_identity().name;

}  // namespace

TEST(cli_version_names_the_aircraft) {
  CHECK(contains(run_tiltrotor("version").out, ", aircraft " + name));
  CHECK(contains(run_tiltrotor("version").out, tiltrotor::aircraft_identity().description));
}

TEST(cli_help_names_the_aircraft) { CHECK(contains(run_tiltrotor("--help").out, "Aircraft " + name + ": ")); }

TEST(cli_json_names_the_aircraft) {
  CHECK(contains(run_tiltrotor("trim --speed 20 --format json").out, "\"aircraft\": \"" + name + "\""));
}

// From the numbers of the aircraft, with the factors of inch and rpm: help, message and the value at the end agree.
TEST(cli_bad_loading_is_told_the_aircrafts_range) {
  const tiltrotor::Aircraft<double>& a = tiltrotor::aircraft_data<double>();
  struct Case {
    const char* option;
    double low, high, unit;
  };
  for (const Case& one :
       {Case{"--mass", a.limits.mass.low, a.limits.mass.high, 1},
        Case{"--cg-sl", a.limits.sl_cg.low, a.limits.sl_cg.high, 0.0254},
        Case{"--rotor-rpm", a.limits.rotor_speed.low, a.limits.rotor_speed.high, 0.10471975511965977},
        Case{"--altitude", a.limits.altitude.low, a.limits.altitude.high, 1},
        Case{"--speed", 0, a.limits.speed, 1}}) {
    const std::string message = run_tiltrotor(std::string("trim ") + one.option + " 1e7").err;
    const std::size_t at = message.find("outside ");
    if (!CHECK(at != std::string::npos)) continue;
    const std::size_t dots = message.find("..", at);
    if (!CHECK(dots != std::string::npos)) continue;
    const double low = std::stod(message.substr(at + 8, dots - at - 8));
    const double high = std::stod(message.substr(dots + 2));
    // Rounded inward, by less than one in a hundred.
    CHECK(low * one.unit >= one.low - 1e-9 * std::fabs(one.low) && high * one.unit <= one.high * (1 + 1e-9));
    CHECK(low * one.unit <= one.low + 0.01 * std::fabs(one.low) && high * one.unit >= 0.99 * one.high);
    CHECK(contains(run_tiltrotor("trim --help").out,
                   message.substr(at + 8, message.find(' ', at + 8) - at - 8)));
  }
}

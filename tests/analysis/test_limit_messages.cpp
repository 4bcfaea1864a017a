// Sentences about a limit: a value reads differently from the bound it is beyond, however near, and stated ranges
// are those in force.
// Expected: the numbers in the sentence, read back.
#include <cmath>
#include <cstdlib>
#include <string>

#include "analysis_case.hpp"
#include "tiltrotor/model/setup/setup_explanation.hpp"

using namespace analysis_case;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string sentence_of(const LimitCheck<double>& check) {
  TrimResult<double> r{};
  r.status = check.status;
  r.limits = check;
  char text[256];
  explain(r, text, sizeof text);
  return text;
}

std::string fault_of(const FlightSetup<double>& setup) {
  char text[120];
  explain(first_out_of_range(aircraft_data<double>(), setup), text, sizeof text);
  return text;
}

}  // namespace

TEST(trim_message_tells_a_value_from_its_limit) {
  const struct {
    TrimLimit limit;
    double bound;
    const char* name;
  } limits[] = {{TrimLimit::elevator, -20 * kDeg, "elevator "},
                {TrimLimit::rudder, 20 * kDeg, "rudder "},
                {TrimLimit::wing_angle, 16 * kDeg, "wing angle of attack "},
                {TrimLimit::lat_stick, 4.8, "lateral stick "},
                {TrimLimit::pedal, -2.5, "pedal "},
                {TrimLimit::gimbal_left, 12 * kDeg, "left gimbal tilt "},
                {TrimLimit::power, 2149853.5, "power "},
                {TrimLimit::torque_left, 22000, "left mast torque "},
                {TrimLimit::descent_left, 0.7, "left rotor descent "}};
  for (const auto& one : limits) {
    for (const double excess : {1e-3, 1e-5, 1e-7, 1e-9}) {
      LimitCheck<double> check;
      check.add(TrimStatus::control_limit, one.limit, one.bound * (1 + excess), one.bound);
      const std::string text = sentence_of(check);
      const std::size_t value = text.find(one.name);
      const std::size_t bound = text.find_first_of("-0123456789", text.find(" is beyond "));
      if (!CHECK(value != std::string::npos && bound != std::string::npos)) continue;
      const double shown = std::strtod(text.c_str() + value + std::string(one.name).size(), nullptr);
      const double limit = std::strtod(text.c_str() + bound, nullptr);
      if (!CHECK_LT(std::fabs(limit), std::fabs(shown))) NOTE(text);
    }
  }
  LimitCheck<double> plain;
  plain.add(TrimStatus::control_limit, TrimLimit::elevator, -25 * kDeg, -20 * kDeg);
  CHECK(contains(sentence_of(plain), "elevator -25.00 deg is beyond -20.00 deg"));
}

TEST(options_message_tells_a_value_from_its_range) {
  FlightSetup<double> setup = flight_setup(aircraft_data<double>(), 0.0);
  const double flap = aircraft_data<double>().limits.flap_deg.high;
  for (const double excess : {1.0, 1e-3, 1e-6, 1e-9}) {
    setup.flap_deg = flap + excess;
    const std::string text = fault_of(setup);
    const double shown = std::strtod(text.c_str() + text.find_first_of("0123456789"), nullptr);
    if (!CHECK_LT(flap, shown)) NOTE(text);
  }
  setup = flight_setup(aircraft_data<double>(), 0.0);
  setup.options.azimuth_stations = 2;
  CHECK(contains(fault_of(setup), "2 lies outside 0 or 3..72"));
  // The bound itself is written with all its digits: 7.2898 m is not 7.29.
  setup = flight_setup(aircraft_data<double>(), 0.0);
  setup.sl_cg = 100;
  const std::string text = fault_of(setup);
  const Bounds<double> range = aircraft_data<double>().limits.sl_cg;
  const std::size_t at = text.find("outside ") + 8;
  CHECK_REL(std::strtod(text.c_str() + at, nullptr), range.low, 2e-7);
  CHECK_REL(std::strtod(text.c_str() + text.find("..", at) + 2, nullptr), range.high, 2e-7);
}

// One range of gusts: of inputs, of a trim and of what the message says.
TEST(trim_gust_has_the_range_of_the_controls) {
  const double most = aircraft_data<double>().limits.gust;
  const Configuration<double> c = configuration(30);
  SteadyFlight<double> flight{40, 0, 0, 0};
  flight.gust.y = most;
  CHECK(is_trimmed(trimmed(c, flight).status));
  flight.gust.y = std::nextafter(most, 100.0);
  const TrimResult<double> refused = trimmed(c, flight);
  CHECK(refused.status == TrimStatus::out_of_range);
  char text[160];
  explain(refused, text, sizeof text);
  CHECK(contains(text, "gust must be within " + std::to_string(static_cast<int>(most)) + " m/s"));
}

// Normal to the motion through the air by its definition, with its sign, and all of the force at rest.
TEST(trim_load_factor_is_the_force_normal_to_the_path) {
  const double g = 9.80665;
  CHECK_NEAR(load_factor<double>({0, 0, -2 * g}, {50, 0, 0}), 2, 1e-12);
  CHECK_NEAR(load_factor<double>({0, 0, g / 2}, {50, 0, 0}), -0.5, 1e-12);
  CHECK_NEAR(load_factor<double>({3 * g, 0, -g}, {50, 0, 0}), 1, 1e-12);
  CHECK_NEAR(load_factor<double>({0, 0, -g}, {0, 0, -5}), 0, 1e-12);
  CHECK_NEAR(load_factor<double>({0.6 * g, 0, -0.8 * g}, {0, 0, 0}), 1, 1e-12);
  CHECK_NEAR(load_factor<double>({0.6 * g, 0, -0.8 * g}, {1e-170, 0, 0}), 1, 1e-12);
}

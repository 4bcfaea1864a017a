#include "cli/flight_summary.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "text/number.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

namespace tiltrotor::cli {

namespace {

constexpr double kClear = 0.3;  // m; from this height on the wheels have left the ground

std::string decimals(double value, int count) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", count, value);
  return text;
}

// What the rotors take, of each engine that runs, at its shaft, W.
double engine_power_needed(const FlightMoment& m) {
  const double efficiency = aircraft_data<double>().controls.transmission_efficiency;
  return m.rotor_power / efficiency / std::max(1, m.engines_running);
}

}  // namespace

void FlightSummary::add(const FlightMoment& m) {
  if (is_beyond_) beyond_ += m.time - duration_;
  duration_ = m.time;
  if (m.height_settles) keep_most(std::fabs(m.height - m.wanted_height), m.time, height_error_);
  const auto keep_power = [&](double power) {
    if (power / m.power_allowed > power_part_.value) power_ = power;
    keep_most(power / m.power_allowed, m.time, power_part_);
  };
  if (m.is_governed)
    for (const double power : m.power) keep_power(power);
  const double needed = engine_power_needed(m);
  if (!m.is_governed) keep_power(needed);
  is_beyond_ = !m.is_governed && needed > m.power_allowed;
  const bool touches = m.weight_on_wheels > 0;
  if (flies_ && touches) {
    ++touched_;
    keep_most(-last_climb_, m.time, touch_down_);
    flies_ = false;
  }
  flies_ = flies_ || (!touches && m.height > kClear);
  if (flies_) {
    keep_most(m.load_factor, m.time, most_load_);
    keep_most(-m.load_factor, m.time, least_load_);
    keep_most(std::fabs(m.state.roll) / kRadPerDeg<double>, m.time, bank_);
  }
  last_climb_ = -m.velocity_n.z;
  fuel_ = m.systems.fuel;
  least_mast_ = std::min(least_mast_, m.mast_deg);
  most_mast_ = std::max(most_mast_, m.mast_deg);
}

std::string FlightSummary::text() const {
  const auto at = [](const Extreme& e) { return " at " + decimals(e.time, 1) + " s\n"; };
  std::string all = "duration: " + decimals(duration_, 2) + " s\n";
  all += "height held: within " + decimals(height_error_.value, 2) + " m," + at(height_error_);
  all += "highest power: " + decimals(power_ / 1e3, 0) + " kW of an engine, " +
         decimals(100 * power_part_.value, 1) + " % of take-off power," + at(power_part_);
  if (beyond_ > 0)
    all += "governor off: for " + decimals(beyond_, 2) +
           " s the rotors took more than take-off power, and kept their speed all the same\n";
  if (most_load_.value > -1e9) {
    all += "load factor: " + decimals(-least_load_.value, 3) + at(least_load_);
    all += "load factor: " + decimals(most_load_.value, 3) + at(most_load_);
    all += "largest bank: " + decimals(bank_.value, 1) + " deg" + at(bank_);
  }
  if (touched_ > 0) all += "touch-down: " + decimals(touch_down_.value, 2) + " m/s" + at(touch_down_);
  all += "fuel burnt: " + decimals(fuel_, 1) + " kg\n";
  all += "masts: " + decimals(least_mast_, 1) + " to " + decimals(most_mast_, 1) + " deg\n";
  return all + remarks_;
}

}  // namespace tiltrotor::cli

#include "study/flights.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <stdexcept>

namespace tiltrotor::study {

namespace {

// Large: one for the whole program, made at first use.
TrimWorkspace<double>& work() {
  static const auto area = std::make_unique<TrimWorkspace<double>>();
  return *area;
}

SteadyFlight<double> level(double speed_mps) {
  SteadyFlight<double> flight{};
  flight.speed = speed_mps;
  return flight;
}

constexpr int kFewIterations = 16;  // enough wherever there is a trim

}  // namespace

Setup default_setup(double mast_deg) { return flight_setup(aircraft_data<double>(), mast_deg); }

Configured configured(const Setup& setup) { return configured(setup, aircraft_data<double>()); }

Configured configured(const Setup& setup, const Aircraft<double>& aircraft) {
  Configured c;
  const Status status = prepare(aircraft, setup, c);
  if (status != Status::ok) throw std::runtime_error(std::string("flight setup: ") + status_text(status));
  return c;
}

Configured configured(double mast_deg) { return configured(default_setup(mast_deg)); }

Trimmed trimmed(const Configured& c, double speed_mps) {
  Trimmed result;
  TrimOptions options;
  options.continuation = false;
  options.max_iterations = kFewIterations;
  (void)trim(c, level(speed_mps), work(), result, options);
  return result;
}

Trimmed trimmed_persistently(const Configured& c, double speed_mps, double climb_rad) {
  Trimmed result;
  SteadyFlight<double> flight = level(speed_mps);
  flight.climb = climb_rad;
  (void)trim(c, flight, work(), result);
  return result;
}

Trimmed trimmed_near(const Configured& c, double speed_mps, const Trimmed& neighbour) {
  Trimmed result = neighbour;
  TrimOptions options;
  options.max_iterations = kFewIterations;
  (void)trim_from(c, level(speed_mps), work(), result, options);
  return result;
}

Evaluation<double> evaluated(const Configured& c, const State<double>& x, const Controls<double>& u) {
  Evaluation<double> e;
  evaluate_aircraft(c, x, u, e);
  return e;
}

Analyses& analyses() {
  // Large: one for the whole program, made at first use.
  static void* const memory = ::operator new(analyses_size(), std::align_val_t(analyses_alignment()));
  static Analyses* const areas = place_analyses(memory);
  return *areas;
}

double shaft_thrust(const Configured& c, const Trimmed& t) {
  return evaluated(c, t.state, t.controls).rotor[right].loads.force_a.z;
}

double transmission_power(const Configured& c) {
  const Aircraft<double>& aircraft = *c.aircraft;
  return 2 * aircraft.controls.power_limit *
         std::min(1.0, c.setup.rotor_speed / aircraft.rotor.speed_helicopter);
}

double middle_speed(double mast_deg) {
  constexpr double helicopter = 30;
  constexpr double airplane = 95;
  return helicopter + (airplane - helicopter) * mast_deg / 90;
}

SpeedSweep speed_sweep(double mast_deg, double step_mps, double highest_mps) {
  return speed_sweep(default_setup(mast_deg), step_mps, highest_mps);
}

SpeedSweep speed_sweep(const Setup& setup, double step_mps, double highest_mps) {
  SpeedSweep sweep{setup.mast_deg, configured(setup), {}};
  const int first = static_cast<int>(middle_speed(setup.mast_deg) / step_mps);
  const int last = static_cast<int>(std::lround(highest_mps / step_mps));
  std::vector<LevelFlight>& flights = sweep.flights;
  const auto add = [&](int k) {
    const double speed = k * step_mps;
    Trimmed trim = trimmed(sweep.c, speed);
    if (!is_trimmed(trim.status) && !flights.empty())
      trim = trimmed_near(sweep.c, speed, flights.back().trim);
    const bool has_power = total_power_kw(trim) <= kWatt * 2 * sweep.c.aircraft->controls.power_limit;
    if (trim.status != TrimStatus::ok || !has_power) return false;
    flights.push_back({speed, trim});
    return true;
  };
  for (int k = first; k >= 0 && add(k); --k) {
  }
  std::reverse(flights.begin(), flights.end());
  for (int k = first + 1; k <= last && add(k); ++k) {
  }
  return sweep;
}

}  // namespace tiltrotor::study

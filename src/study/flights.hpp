// The flights of the study: configurations and trims. The heavy templates are compiled in flights.cpp, once.
#pragma once

#include <vector>

#include "library/analyses.hpp"
#include "tiltrotor/analysis/trim/trim.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

namespace tiltrotor::study {

inline double degrees(double radians) { return radians * tiltrotor::kDegPerRad<double>; }
inline constexpr double kStickNeutral = 4.8;  // in, where the pilot's scale 0..9.6 has its middle
inline constexpr double kStickTravel = 9.6;   // in
inline constexpr double kWatt = 1e-3;         // kW

using Setup = FlightSetup<double>;
using Configured = Configuration<double>;
using Trimmed = TrimResult<double>;

// The default setup at a mast angle, prepared; `change` may edit it first. Throws when it is out of range.
Configured configured(double mast_deg);
Configured configured(const Setup& setup);
Configured configured(const Setup& setup, const Aircraft<double>& aircraft);  // which must outlive the result

Setup default_setup(double mast_deg);

// Level flight from a cold start, without continuation: a point without trim costs little.
Trimmed trimmed(const Configured& c, double speed_mps);
// The same with everything tried.
Trimmed trimmed_persistently(const Configured& c, double speed_mps, double climb_rad = 0);
// From a neighbouring solution.
Trimmed trimmed_near(const Configured& c, double speed_mps, const Trimmed& neighbour);

// Loads, rotors and rates at a state.
Evaluation<double> evaluated(const Configured& c, const State<double>& x, const Controls<double>& u);

// Force of the right rotor along its shaft, N; Trimmed::thrust is its whole force.
double shaft_thrust(const Configured& c, const Trimmed& t);

// Power both rotors may take, W: the transmission's limit of power at helicopter rotor speed. At a lower
// rotor speed its limit of torque comes first.
double transmission_power(const Configured& c);

// The analyses of the whole vehicle, of which the program has one for both ways of differentiation.
Analyses& analyses();

struct LevelFlight {
  double speed_mps;
  Trimmed trim;
};

// Level flights at one mast angle in steps of speed: all that have a trim inside every limit, the
// transmission's power included, without a gap around the middle of the conversion corridor.
struct SpeedSweep {
  double mast_deg;
  Configured c;
  std::vector<LevelFlight> flights;
};
SpeedSweep speed_sweep(double mast_deg, double step_mps, double highest_mps);
SpeedSweep speed_sweep(const Setup& setup, double step_mps, double highest_mps);
// A speed well inside the corridor at any mast angle, m/s.
double middle_speed(double mast_deg);

inline double total_power_kw(const Trimmed& t) { return kWatt * (t.power[right] + t.power[left]); }

// Stick position on the pilot's scale, in.
inline double stick_position(const Trimmed& t) { return kStickNeutral + t.controls.long_stick; }

}  // namespace tiltrotor::study

// Trim of every flight a command line asks for.
#pragma once

#include <functional>

#include "cli/analyses_workspace.hpp"
#include "cli/flight_options.hpp"
#include "cli/shard.hpp"

namespace tiltrotor::cli {

struct TrimmedFlight {
  std::size_t number;   // among all flights of the command line, from 0
  bool is_preliminary;  // belongs to the shard before and is visited for the sake of its successor only
  bool connects;        // continues the flight visited before
  std::string where;    // beginning of a message: "trim: mast 30 deg, 10 m/s, 3000 m"
  double mast_deg;
  SteadyFlight<double> flight;
  double climb_deg, sideslip_deg, turn_rate_degps;  // of the flight, as given or as found for a target
  std::optional<double> azimuth_deg;                // of the wind
  const SetupOptions* setup;
  Configuration<double> configuration;
  TrimResult<double> trim;
  TrimTargets targets;  // that it was trimmed to

  // A setting as it was given, or that of the aircraft or found for a target; the name of its column.
  double setting(const std::string& column) const;
};

// Whether a flight continues another, so that something is carried from one to the next. A shard then begins
// early enough to carry the same.
using Connected = std::function<bool(const FlightCase&, const FlightCase&)>;

// Calls `visit` for every flight of this shard, with each of the setups, in order, trimmed or not; a flight
// without a valid trim is explained on stderr. Returns exit_case_failed when there was one or `visit`
// returned it.
int for_each_trim(const Arguments& arguments, const std::vector<SetupOptions>& setups, const Shard& shard,
                  Analyses& work, const std::function<int(const TrimmedFlight&)>& visit,
                  const Connected& connected = nullptr);

// One trim of the flight as it stands: straight ahead with its sideslip, or with the wind from its azimuth.
void trim_flight(TrimmedFlight& flight, Analyses& work);
std::string trim_explanation(const TrimResult<double>& trim);

// Specific force to the right at the CG over g, of a steady flight: at rest in axes that turn with it,
// v' = f/m + g - omega x v = 0.
template <class T>
T side_force(const State<T>& x) {
  const T turning = x.rates.z * x.velocity.x - x.rates.x * x.velocity.z;
  return turning / kGravity<Real<T>> - sin(x.roll) * cos(x.pitch);
}

// Beginning of a message: "trim: mast 30 deg, 10 m/s"
std::string flight_text(const std::string& command, double mast_deg, double speed);

}  // namespace tiltrotor::cli

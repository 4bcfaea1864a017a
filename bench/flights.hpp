// The flights that are measured.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <vector>

#include "tiltrotor/analysis/instances.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

namespace bench {

using namespace tiltrotor;

// A contract of the benchmark itself: ends the program with a message.
inline void require(bool fulfilled, const char* what) {
  if (fulfilled) return;
  std::fprintf(stderr, "benchmark: %s\n", what);
  std::exit(1);
}

struct Grid {
  const char* name;  // as in the names of results
  const char* suffix;
  BladeGrid grid;
};
inline constexpr Grid kGrids[] = {{"specification", "", BladeGrid::specification},
                                  {"realtime", "_realtime_grid", BladeGrid::realtime}};

inline Options with_grid(BladeGrid grid) {
  Options options;
  options.grid = grid;
  return options;
}

inline Configuration<double> configuration(double mast_deg, const Options& options = {}) {
  FlightSetup<double> setup = flight_setup(aircraft_data<double>(), mast_deg);
  setup.options = options;
  Configuration<double> c;
  require(prepare(aircraft_data<double>(), setup, c) == Status::ok, "flight setup out of range");
  return c;
}

inline int elements(const Configuration<double>& c) { return 2 * c.blade.count * c.azimuth.count; }

inline SteadyFlight<double> level(double speed_mps) { return {speed_mps, 0, 0, 0}; }

inline TrimResult<double> trimmed(const Configuration<double>& c, double speed_mps) {
  static TrimWorkspace<double, AutoDiff> work;
  TrimResult<double> result;
  require(is_trimmed(trim(c, level(speed_mps), work, result)), "no trim");
  return result;
}

// Where single evaluations are measured: a conversion, everything at work.
inline constexpr double kMiddleMast = 30, kMiddleSpeed = 50;

// The trim set of the reference paper: four mast angles over the speeds at which each flies.
struct SpeedRange {
  double mast_deg, from_mps, to_mps, step_mps;
};
inline constexpr SpeedRange kPaperSet[] = {
    {0, 0, 50, 5}, {30, 25, 70, 5}, {60, 50, 85, 5}, {90, 60, 140, 10}};

struct FlightPoint {
  Configuration<double> c;
  double speed_mps;
  TrimResult<double> trim;
};

inline std::vector<FlightPoint> paper_set(const Options& options = {}) {
  std::vector<FlightPoint> points;
  for (const SpeedRange& range : kPaperSet) {
    const Configuration<double> c = configuration(range.mast_deg, options);
    for (double v = range.from_mps; v <= range.to_mps; v += range.step_mps)
      points.push_back({c, v, trimmed(c, v)});
  }
  return points;
}

}  // namespace bench

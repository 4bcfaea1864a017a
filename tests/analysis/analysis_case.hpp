// What the tests of the analyses share: prepared configurations, trims, reference points, and work areas.
#pragma once

#include <cmath>
#include <cstring>
#include <string>

#include "check.hpp"
#include "csv_file.hpp"
#include "this_aircraft.hpp"
#include "tiltrotor/analysis/instances.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/model/variables/presets.hpp"

namespace analysis_case {

using namespace tiltrotor;

inline constexpr double kDeg = kRadPerDeg<double>;

inline Configuration<double> configuration(double mast_deg, const Options& options = Options{},
                                           double altitude = 0) {
  FlightSetup<double> setup = flight_setup(aircraft_data<double>(), mast_deg);
  setup.options = options;
  setup.altitude = altitude;
  Configuration<double> c;
  CHECK(prepare(aircraft_data<double>(), setup, c) == Status::ok);
  return c;
}

// The model of the independent implementation, where its numbers are the expected ones.
inline Configuration<double> reference_configuration(double mast_deg) {
  return configuration(mast_deg, reference_options());
}

inline SteadyFlight<double> level(double speed) { return {speed, 0, 0, 0}; }

// The flight of the XV-15 at sea level as this aircraft flies it (this_aircraft.hpp), `altitude` higher than there.
inline Configuration<double> flown_configuration(double mast_deg, double altitude = 0,
                                                 const Options& options = Options{}) {
  return configuration(mast_deg, options, this_aircraft::altitude() + altitude);
}
inline SteadyFlight<double> flown(SteadyFlight<double> flight) {
  const double speed = this_aircraft::speed();
  return {speed * flight.speed,
          flight.climb,
          flight.turn_rate / speed,
          flight.sideslip,
          {speed * flight.gust.x, speed * flight.gust.y, speed * flight.gust.z}};
}

inline TrimResult<double> trimmed(const Configuration<double>& c, const SteadyFlight<double>& flight,
                                  const TrimOptions& options = {}) {
  static TrimWorkspace<double> work;
  TrimResult<double> result;
  const TrimStatus status = trim(c, flight, work, result, options);
  CHECK(status == result.status);
  return result;
}

struct Vector {
  double x, y, z;
};
// Earth axes from body axes for 3-2-1 Euler angles with zero heading, as the product of two plane rotations.
inline Vector to_earth(const Vec3<double>& b, double roll, double pitch) {
  const double y = b.y * std::cos(roll) - b.z * std::sin(roll);
  const double z = b.y * std::sin(roll) + b.z * std::cos(roll);
  return {b.x * std::cos(pitch) + z * std::sin(pitch), y, -b.x * std::sin(pitch) + z * std::cos(pitch)};
}

// The sentence on how a trim ended.
inline std::string explanation(const TrimResult<double>& r) {
  char text[200];
  const int length = explain(r, text, 200);
  CHECK_EQ(static_cast<std::size_t>(length), std::strlen(text));
  return text;
}
inline bool contains(const std::string& text, const char* part) {
  return text.find(part) != std::string::npos;
}

inline void linear_model(const Configuration<double>& c, const State<double>& x, const Controls<double>& u,
                         const ControlSet& columns, LinearModel<double>& model) {
  static LinearizationWorkspace<double> work;
  CHECK(linearize(c, x, u, columns, work, model) == Status::ok);
}

inline void modes_of(const Configuration<double>& c, const State<double>& x, const Controls<double>& u,
                     ModeSet<double>& set) {
  static LinearModel<double> model;
  static ModesWorkspace<double> work;
  linear_model(c, x, u, kInceptors, model);
  CHECK(modes(model, work, set) == Status::ok);
}

// The mode of that name, or one of NaN.
inline Mode<double> mode_named(const ModeSet<double>& set, const std::string& name) {
  for (int i = 0; i < set.count; ++i)
    if (set.mode[i].name == name) return set.mode[i];
  Mode<double> none{};
  none.real = none.imag = std::nan("");
  return none;
}

struct Point {
  State<double> x;
  Controls<double> u;
};

inline constexpr const char* kReferencePoints[] = {"mast00_v000", "mast30_v050", "mast90_v100"};
inline constexpr double kReferenceMasts[] = {0, 30, 90};

// Names of the controls in the reference files, in the order of kInceptors.
inline constexpr const char* kReferenceControls[] = {"th75_rad", "lon_in", "lat_in", "ped_in"};

// Trim point of the second implementation (tests/reference/README.md).
inline Point reference_point(const std::string& name) {
  const check::CsvFile file("tests/reference/x0_" + name + ".csv");
  double x[state_count] = {};
  double u[control_count] = {};
  for (int i = 0; i <= kStateIndex.downwash; ++i) x[i] = file.number(0, kStateVariables[i].name);
  for (int j = 0; j < 4; ++j) u[kInceptors.index[j]] = file.number(0, kReferenceControls[j]);
  Point p;
  unflatten(x, p.x);
  unflatten(u, p.u);
  return p;
}

// Not trimmed, not symmetric.
inline Point slanted_point() {
  const check::CsvFile file("tests/reference/state_derivatives_c1.csv");
  const int row = 1;  // mast 30
  double x[state_count] = {};
  double u[control_count] = {};
  for (int i = 0; i <= kStateIndex.downwash; ++i) x[i] = file.number(row, kStateVariables[i].name);
  for (int j = 0; j < 4; ++j) u[kInceptors.index[j]] = file.number(row, kReferenceControls[j]);
  Point p;
  unflatten(x, p.x);
  unflatten(u, p.u);
  return p;
}

}  // namespace analysis_case

#include "cli/airframe_outputs.hpp"

#include <memory>

#include "library/component_readings.hpp"
#include "tiltrotor/analysis/flight/station_motion.hpp"

namespace tiltrotor::cli {

namespace {

using Kind = AirframeOutput::Kind;

template <class T>
T part(const Vec3<T>& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

// rates.velocity is the derivative of u, v, w: the specific force leaves out the turning of the axes and gravity.
template <class T>
T load_factor_at(const Configuration<T>& c, const State<T>& x, const Loads<T>& total, const State<T>& rates,
                 const AirframeOutput& output) {
  const double* const s = output.station;
  const Vec3<T> of_cg = T(1 / c.mass.mass) * total.force;
  const Vec3<T> felt = output.kind == Kind::load_factor_at_cg
                           ? of_cg
                           : specific_force_at(of_cg, c.mass.nacelles, x.rates, rates.rates,
                                               station_arm(c.mass, s[0], s[1], s[2]));
  const double sign = output.axis == 2 ? -1 : 1;
  return part(felt, output.axis) * (sign / kGravity<double>);
}

// Of the path through the undisturbed air. Straight up or down, and at rest, it has no slopes.
template <class T>
T flight_path_angle(const State<T>& x) {
  const Vec3<T> way = earth_to_body(EulerAngles<T>{x.roll, x.pitch, x.yaw}).apply_inverse(x.velocity);
  if (value(length(way)) < kLeastSpeed<double>) return T(0.0);
  const T level = length(Vec3<T>{way.x, way.y, T(0.0)});
  if (value(level) < kLeastSpeed<double>) return T(value(way.z) < 0 ? kPi<double> / 2 : -kPi<double> / 2);
  return atan2(-way.z, level);
}

template <class T>
T reading(const Configuration<T>& c, const State<T>& x, const DerivativeSteps<T>& steps,
          const State<T>& rates, const ComponentReadings<T>& found, const AirframeOutput& output) {
  switch (output.kind) {
    case Kind::load_factor:
    case Kind::load_factor_at_cg:
      return load_factor_at(c, x, steps.total, rates, output);
    case Kind::flight_path_angle:
      return flight_path_angle(x);
    case Kind::wing_angle_of_attack:
      return found.airframe.wing_alpha;
    case Kind::htail_angle_of_attack:
      return htail_angle_of_attack(c, steps, found);
    case Kind::state: {
      T flat[state_count];
      flatten(x, flat);
      return flat[output.component];
    }
    case Kind::force:
    case Kind::moment:
      break;
  }
  Loads<T> of{};
  for (int k = 0; k < component_count; ++k)
    if (output.component == k || output.component == component_count) of = of + found.loads.component[k];
  return part(output.kind == Kind::force ? of.force : of.moment, output.axis);
}

template <class T>
void read(const Configuration<T>& c, const State<T>& x, const DerivativeSteps<T>& steps,
          const State<T>& rates, const std::vector<AirframeOutput>& outputs, ComponentReadings<T>& found,
          T* y) {
  read_components(c, steps, found);
  for (const AirframeOutput& output : outputs) *y++ = reading(c, x, steps, rates, found, output);
}

template <class T>
std::vector<T> readings(const Configuration<T>& c, const State<T>& x, const DerivativeSteps<T>& steps,
                        const State<T>& rates, const std::vector<AirframeOutput>& outputs) {
  std::vector<T> y(outputs.size());
  if (outputs.empty()) return y;
  ComponentReadings<T> work;
  read(c, x, steps, rates, outputs, work, y.data());
  return y;
}

}  // namespace

std::vector<Along> airframe_readings(const Configuration<Along>& c, const State<Along>& x,
                                     const DerivativeSteps<Along>& steps, const State<Along>& rates,
                                     const std::vector<AirframeOutput>& outputs) {
  return readings(c, x, steps, rates, outputs);
}

std::vector<double> airframe_readings(const Configuration<double>& c, const State<double>& x,
                                      const DerivativeSteps<double>& steps, const State<double>& rates,
                                      const std::vector<AirframeOutput>& outputs) {
  return readings(c, x, steps, rates, outputs);
}

Status linearize_airframe_outputs(const SystemFlight<double>& flight, const Configuration<double>& c,
                                  const State<double>& x, const Controls<double>& u,
                                  const VehicleShape& shape, const std::vector<AirframeOutput>& outputs,
                                  VehicleRows& found) {
  using T = VehicleDirectionWorkspace<double>::T;
  VehicleMoment now;
  read_vehicle_moment(flight, c, x, u, 0, now);
  found.y = airframe_readings(now.put, x, now.found.steps, now.found.answer.rates, outputs);
  const auto work = std::make_unique<ComponentReadings<T>>();
  return linearize_vehicle_rows(
      flight, c, x, u, shape, static_cast<int>(outputs.size()),
      [&](const VehicleDirectionWorkspace<double>& at, T* y) {
        read(at.configuration, at.x, at.steps, at.answer.rates, outputs, *work, y);
      },
      found);
}

}  // namespace tiltrotor::cli

#include "cli/model_slope.hpp"

#include <cstring>
#include <optional>

#include "cli/held_slope.hpp"
#include "library/governed_flight.hpp"
#include "tiltrotor/analysis/linear/linear_model.hpp"
#include "tiltrotor/model/preparation.hpp"

namespace tiltrotor::cli {

namespace {

// The same numbers, without slope or with that of another.
template <template <class> class Shape>
Shape<Along> in_along(const Shape<double>& value, const Shape<double>& slope) {
  constexpr std::size_t count = sizeof value / sizeof(double);
  static_assert(sizeof(Shape<Along>) == count * sizeof(Along));
  double v[count], d[count];
  std::memcpy(v, &value, sizeof v);
  std::memcpy(d, &slope, sizeof d);
  Along both[count];
  for (std::size_t i = 0; i < count; ++i) both[i] = {v[i], d[i]};
  Shape<Along> to;
  std::memcpy(static_cast<void*>(&to), both, sizeof to);
  return to;
}
template <template <class> class Shape>
Shape<Along> in_along(const Shape<double>& value) {
  return in_along(value, Shape<double>{});
}

}  // namespace

struct ModelSlope::Memory {
  std::optional<AlongAircraft> aircraft;
  Configuration<Along> configuration, put;
  LinearizationWorkspace<Along, AutoDiff> linear;
  LinearModel<Along> model;
  DerivativeSteps<Along> steps;
  VehicleModelWorkspace<Along, AutoDiff> vehicle;
  State<Along> rates;
  SystemState<Along> system_rates;
};

ModelSlope::ModelSlope() : memory_(std::make_unique<Memory>()) {}
ModelSlope::~ModelSlope() = default;

Status ModelSlope::begin(const Configuration<double>& c, const std::function<void(Moved)>& move) {
  Memory& m = *memory_;
  m.aircraft.emplace(*c.aircraft);
  const ConfigurationSetting<double>& base = c.setup;
  ConfigurationSetting<Along> setting = in_along(base);
  Surroundings<Along> around = in_along(c.around);
  move({*m.aircraft, setting, around});
  FlightSetup<Along> setup;
  static_cast<ConfigurationSetting<Along>&>(setup) = setting;
  setup.options = c.setup.options;
  const Status status = prepare(m.aircraft->aircraft, setup, m.configuration);
  if (status != Status::ok) return status;
  m.configuration.around = around;
  configure(m.configuration);
  return Status::ok;
}

Status ModelSlope::rates(const State<double>& x, const Controls<double>& u, double (&slope)[state_count]) {
  Memory& m = *memory_;
  derivative(m.configuration, in_along(x), in_along(u), m.steps, m.rates, Along(0));
  Along rates[state_count];
  flatten(m.rates, rates);
  bool finite = true;
  for (int i = 0; i < state_count; ++i) {
    slope[i] = rates[i].d;
    finite &= std::isfinite(slope[i]);
  }
  return finite ? Status::ok : Status::not_finite;
}

Status ModelSlope::airframe(const State<double>& x, const Controls<double>& u,
                            const TrimMotion<double>& motion, Airframe& slope) {
  Memory& m = *memory_;
  slope = {};
  const State<Along> at = in_along(x, motion.x);
  const Controls<Along> held = in_along(u, motion.u);
  const Status status = linearize(m.configuration, at, held, ControlSet{}, m.linear, m.model);
  if (status != Status::ok) return status;
  const LinearModel<Along>& found = m.model;
  bool finite = true;
  for (int i = 0; i < found.states; ++i)
    for (int j = 0; j < found.states; ++j) {
      slope.a[found.state[i]][found.state[j]] = found.a(i, j).d;
      finite &= std::isfinite(found.a(i, j).d);
    }
  derivative(m.configuration, at, held, m.steps, m.rates, Along(0));
  const Along torque = m.steps.rotor[right].loads.torque + m.steps.rotor[left].loads.torque;
  slope.power = (m.configuration.setup.rotor_speed * torque).d;
  return finite ? Status::ok : Status::not_finite;
}

double ModelSlope::held(const TrimTarget& target, const TrimmedFlight& flight,
                        const TrimMotion<double>& motion) const {
  return held_slope(target, flight, memory_->configuration, in_along(flight.trim.state, motion.x),
                    in_along(flight.trim.controls, motion.u));
}

Status ModelSlope::closed_loop(const State<double>& x, const Controls<double>& u,
                               const TrimMotion<double>& motion, bool scas, Square& slope) {
  Memory& m = *memory_;
  const State<Along> at = in_along(x, motion.x);
  Controls<Along> held = in_along(u, motion.u);
  const SystemFlight<Along> flight = governed_flight(m.configuration, at, held, scas);
  VehicleShape shape;
  vehicle_states(flight.vehicle, m.configuration.setup.options, shape);
  shape.inputs = 0;
  m.put = m.configuration;
  m.put.around = with_turbulence(m.configuration, at, held, flight.vehicle, flight.state);
  set_zero(slope);
  bool finite = true;
  const auto put_a = [&](int i, int j, int count, const Along* entry) {
    for (int k = 0; k < count; ++k) {
      slope(i, j + k) = entry[k].d;
      finite &= std::isfinite(entry[k].d);
    }
  };
  const Status status = linearize_vehicle(flight.vehicle, m.put, at, flight.state, held, shape, m.vehicle,
                                          m.rates, m.system_rates, put_a, [](int, int, int, const Along*) {});
  return status == Status::ok && !finite ? Status::not_finite : status;
}

}  // namespace tiltrotor::cli

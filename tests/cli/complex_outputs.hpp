// Outputs of the airframe at a state that is moved in the imaginary direction: the whole model with its systems in complex
// numbers, loads by component from evaluate_aircraft(), load factors by the motion of the station, angles by their sine and tangent.
#pragma once

#include <cmath>
#include <complex>
#include <memory>
#include <vector>

#include "cli/airframe_outputs.hpp"
#include "tiltrotor/math/differentiation/complex_step.hpp"

namespace complex_model {

using namespace tiltrotor;
using cli::AirframeOutput;
using Complex = std::complex<double>;

// From what the body does: v' + w x v less gravity, and the arm's part.
template <class T>
T load_factor_by_motion(const Configuration<T>& c, const State<T>& x, const State<T>& rates,
                        const double (&station)[3], int axis) {
  const T arm[3] = {c.mass.sl_cg - station[0], T(station[1]), c.mass.wl_cg - station[2]};
  const T v[3] = {x.velocity.x, x.velocity.y, x.velocity.z};
  const T w[3] = {x.rates.x, x.rates.y, x.rates.z};
  const T dv[3] = {rates.velocity.x, rates.velocity.y, rates.velocity.z};
  const T dw[3] = {rates.rates.x, rates.rates.y, rates.rates.z};
  const T down[3] = {-sin(x.pitch), cos(x.pitch) * sin(x.roll), cos(x.pitch) * cos(x.roll)};
  const auto turned = [](const T(&a)[3], const auto& b, int k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    return a[i] * b[j] - a[j] * b[i];
  };
  T spin[3];
  for (int k = 0; k < 3; ++k) spin[k] = turned(w, arm, k);
  const T felt = dv[axis] + turned(w, v, axis) + turned(dw, arm, axis) + turned(w, spin, axis);
  return (axis == 2 ? -1.0 : 1.0) * (felt / kGravity<double> - down[axis]);
}

inline Complex load_factor_at_cg(const State<Complex>& x, const State<Complex>& rates, int axis) {
  const Vec3<Complex> v = rates.velocity + cross(x.rates, x.velocity);
  const Complex down[3] = {-sin(x.pitch), cos(x.pitch) * sin(x.roll), cos(x.pitch) * cos(x.roll)};
  return (axis == 2 ? -1.0 : 1.0) * ((axis == 0   ? v.x
                                      : axis == 1 ? v.y
                                                  : v.z) /
                                         kGravity<double> -
                                     down[axis]);
}

// The path by its sine, u sin(pitch) - .. over the speed; angles of the flow by the velocities that make them up.
inline Complex angle_or_state(const Configuration<Complex>& c, const State<Complex>& x,
                              const DerivativeSteps<Complex>& steps, const State<Complex>& rates,
                              const AirframeOutput& o) {
  using Kind = AirframeOutput::Kind;
  const Vec3<Complex>& v = x.velocity;
  if (o.kind == Kind::flight_path_angle)
    return std::asin((v.x * sin(x.pitch) - cos(x.pitch) * (v.y * sin(x.roll) + v.z * cos(x.roll))) /
                     std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z));
  if (o.kind == Kind::state) {
    Complex flat[state_count];
    flatten(x, flat);
    return flat[o.component];
  }
  const auto work = std::make_unique<AirframeWorkspace<Complex>>();
  AirframeResponse<Complex> airframe;
  airframe_response(c, steps.airframe_input, *work, airframe, [](Component, const Loads<Complex>&) {});
  if (o.kind == Kind::wing_angle_of_attack) return airframe.wing_alpha;
  // Of the tail: its velocity, the rotors' wash along the nacelles, incidence less the lagged downwash.
  const auto& s = c.aircraft->htail.surface;
  const AirframeInput<Complex>& in = steps.airframe_input;
  const Complex back = c.mass.sl_cg - s.sl, below = c.mass.wl_cg - s.wl;
  const Complex wash = work->tail.wash_ratio * 0.5 * (in.mean_wash[right] + in.mean_wash[left]);
  const Complex ahead =
      in.velocity_b.x + in.rates_b.y * below + wash * c.nacelle_axis_b.x + c.aircraft->smooth.forward_speed;
  const Complex down = in.velocity_b.z - in.rates_b.y * back + wash * c.nacelle_axis_b.z;
  (void)rates;
  return std::atan(down / ahead) + s.incidence - x.downwash;
}

// The aircraft with its governor at states and inputs of the shape's columns, changed by `step` in one of them.
inline std::vector<Complex> outputs_of(const SystemFlight<double>& flight, const Configuration<double>& base,
                                       const State<double>& x, const Controls<double>& u,
                                       const VehicleShape& shape, int column, double step,
                                       const std::vector<AirframeOutput>& outputs) {
  double flat[vehicle_state_count + vehicle_input_count];
  Complex moved[vehicle_state_count + vehicle_input_count];
  flatten(x, flat);
  flatten(flight.state, flat + state_count);
  flatten(u, flat + vehicle_state_count);
  flatten(flight.vehicle.commands, flat + vehicle_state_count + control_count);
  for (int i = 0; i < vehicle_state_count + vehicle_input_count; ++i) moved[i] = flat[i];
  moved[column < shape.states ? shape.state[column]
                              : vehicle_state_count + shape.input[column - shape.states]] += Complex(0, step);
  struct Work {
    State<Complex> x;
    SystemState<Complex> s, rates;
    Controls<Complex> u;
    Commands<Complex> commands;
    Configuration<Complex> c;
    DerivativeSteps<Complex> steps;
    AirframeDemand<Complex> demand;
    AirframeAnswer<Complex> answer;
    VehicleFlows<Complex> flows;
    Evaluation<Complex> now;
  };
  const auto w = std::make_unique<Work>();
  unflatten(moved, w->x);
  unflatten(moved + state_count, w->s);
  unflatten(moved + vehicle_state_count, w->u);
  unflatten(moved + vehicle_state_count + control_count, w->commands);
  moved_configuration<Complex>(base, nullptr, nullptr, 0, w->c);
  vehicle_rates<Complex>(flight.vehicle, base, base.setup, w->c, w->x, w->s, w->commands, w->u,
                         VehicleAirframe<Complex>{w->c, w->x, w->steps, 0.0}, w->demand, w->answer, w->flows,
                         w->rates);
  evaluate_aircraft(w->c, w->x, w->demand.controls, w->now);
  std::vector<Complex> y;
  using Kind = AirframeOutput::Kind;
  for (const AirframeOutput& o : outputs) {
    if (o.kind == Kind::load_factor) {
      y.push_back(load_factor_by_motion(w->c, w->x, w->answer.rates, o.station, o.axis));
      continue;
    }
    if (o.kind == Kind::load_factor_at_cg) {
      y.push_back(load_factor_at_cg(w->x, w->answer.rates, o.axis));
      continue;
    }
    if (o.kind >= Kind::flight_path_angle) {
      y.push_back(angle_or_state(w->c, w->x, w->steps, w->answer.rates, o));
      continue;
    }
    Loads<Complex> sum{};
    for (int k = 0; k < component_count; ++k)
      if (o.component == k || o.component == component_count) sum = sum + w->now.loads.component[k];
    const Vec3<Complex>& v = o.kind == AirframeOutput::Kind::force ? sum.force : sum.moment;
    y.push_back(o.axis == 0 ? v.x : o.axis == 1 ? v.y : v.z);
  }
  return y;
}

}  // namespace complex_model

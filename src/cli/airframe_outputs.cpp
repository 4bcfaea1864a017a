#include <memory>

#include "cli/airframe_outputs.hpp"
#include "tiltrotor/analysis/flight/station_motion.hpp"

namespace tiltrotor::cli {

namespace {

template <class T>
T part(const Vec3<T>& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

// rates.velocity is the derivative of u, v, w: the specific force leaves out the turning of the axes and gravity.
template <class T>
T load_factor_at(const Configuration<double>& c, const State<T>& x, const Loads<T>& total,
                 const State<T>& rates, const AirframeOutput& output) {
  const double* const s = output.station;
  const Vec3<double> from_cg = station_arm(c.mass, s[0], s[1], s[2]);
  const Vec3<T> arm = {T(from_cg.x), T(from_cg.y), T(from_cg.z)};
  const NacelleMotion<double>& n = c.mass.nacelles;
  NacelleMotion<T> nacelles{};
  nacelles.cg_rate_x = T(n.cg_rate_x);
  nacelles.cg_rate_z = T(n.cg_rate_z);
  nacelles.cg_acceleration_x = T(n.cg_acceleration_x);
  nacelles.cg_acceleration_z = T(n.cg_acceleration_z);
  const Vec3<T> of_cg = (1 / c.mass.mass) * total.force;
  const Vec3<T> felt = specific_force_at(of_cg, nacelles, x.rates, rates.rates, arm);
  const double sign = output.axis == 2 ? -1 : 1;
  return part(felt, output.axis) * (sign / kGravity<double>);
}

template <class T>
T read(const Configuration<double>& c, const State<T>& x, const Loads<T>& total, const State<T>& rates,
       const LoadRecord<T>& loads, const AirframeOutput& output) {
  if (output.kind == AirframeOutput::Kind::load_factor) return load_factor_at(c, x, total, rates, output);
  Loads<T> of{};
  for (int k = 0; k < component_count; ++k)
    if (output.component == k || output.component == component_count) of = of + loads.component[k];
  return part(output.kind == AirframeOutput::Kind::force ? of.force : of.moment, output.axis);
}

}  // namespace

std::vector<double> airframe_readings(const Configuration<double>& c, const State<double>& x,
                                      const DerivativeSteps<double>& steps, const State<double>& rates,
                                      const std::vector<AirframeOutput>& outputs) {
  std::vector<double> y;
  if (outputs.empty()) return y;
  LoadRecord<double> loads{};
  loads[Component::rotor_right] = steps.hub_loads[right];
  loads[Component::rotor_left] = steps.hub_loads[left];
  AirframeWorkspace<double> work;
  AirframeResponse<double> airframe;
  airframe_response(c, steps.airframe_input, work, airframe,
                    [&](Component component, const Loads<double>& l) { loads[component] = l; });
  if (c.setup.options.engine_jets) {
    double power = 0;
    for (const Side side : {right, left})
      power += (steps.rotor[side].loads.torque + c.rotor[side].spin_up) * c.rotor[side].speed;
    loads[Component::engine_jets] =
        engine_jet_loads(c, power, total_speed(steps.velocity_b, c.aircraft->smooth.airspeed));
  }
  for (const AirframeOutput& output : outputs) y.push_back(read(c, x, steps.total, rates, loads, output));
  return y;
}

Status linearize_airframe_output(const Configuration<double>& c, const State<double>& x,
                                 const Controls<double>& u, const ControlSet& columns,
                                 const AirframeOutput& output, OutputMatrices& found) {
  constexpr int directions = 8;  // few enough that every component sees the aircraft's own
  using T = Dual<double, directions>;
  struct Workspace {
    LinearizationWorkspace<double, NumDiff> point;
    DerivativeSteps<T> steps;
    Evaluation<T> evaluation;
  };
  const auto work = std::make_unique<Workspace>();
  LinearPoint<double>& point = found.point;
  const Status possible = set_point(c, x, u, columns, work->point, point);
  if (possible != Status::ok) return possible;
  const int n = point.states;
  const int inputs = n + point.controls;
  set_zero(found.c);
  set_zero(found.d);
  for (double& y : found.y) y = 0;
  for (int first = 0; first < inputs; first += directions) {
    T flat_x[state_count], flat_u[control_count];
    for (int i = 0; i < state_count; ++i) flat_x[i] = T(work->point.base_x[i]);
    for (int j = 0; j < control_count; ++j) flat_u[j] = T(work->point.base_u[j]);
    for (int k = 0; k < directions && first + k < inputs; ++k) {
      const int j = first + k;
      T& seeded = j < n ? flat_x[point.state[j]] : flat_u[point.control[j - n]];
      seeded.d.set(k, 1.0);
    }
    State<T> state;
    Controls<T> controls;
    unflatten(flat_x, state);
    unflatten(flat_u, controls);
    evaluate_aircraft(c, state, controls, work->steps, work->evaluation);
    const T y = read(c, state, work->steps.total, work->evaluation.rates, work->evaluation.loads, output);
    found.y[0] = y.v;
    for (int k = 0; k < directions && first + k < inputs; ++k) {
      const int j = first + k;
      (j < n ? found.c(0, j) : found.d(0, j - n)) = y.d.get(k);
    }
  }
  bool finite = is_finite(found.y[0]);
  for (int j = 0; j < n; ++j) finite = finite && is_finite(found.c(0, j));
  for (int j = 0; j < point.controls; ++j) finite = finite && is_finite(found.d(0, j));
  return finite ? Status::ok : Status::not_finite;
}

}  // namespace tiltrotor::cli

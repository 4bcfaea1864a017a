#include "cli/sensitivity.hpp"

#include "cli/governed.hpp"
#include "cli/wind_trim.hpp"
#include "tiltrotor/analysis/linear/model_motion.hpp"

namespace tiltrotor::cli {

namespace {

using Numbers = std::vector<double>;

constexpr double kStep =
    0.002;  // of a usual change: few elements change their place among the knots of a table

template <int N>
void append(const Matrix<double, N, N>& a, int n, Numbers& to) {
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) to.push_back(a(i, j));
}

// State and controls of a trim on its way.
std::pair<State<double>, Controls<double>> moved(const TrimResult<double>& trim,
                                                 const TrimMotion<double>& motion, double by) {
  double x[state_count], u[control_count], along_x[state_count], along_u[control_count];
  flatten(trim.state, x);
  flatten(trim.controls, u);
  flatten(motion.x, along_x);
  flatten(motion.u, along_u);
  for (int i = 0; i < state_count; ++i) x[i] += by * along_x[i];
  for (int j = 0; j < control_count; ++j) u[j] += by * along_u[j];
  std::pair<State<double>, Controls<double>> at;
  unflatten(x, at.first);
  unflatten(u, at.second);
  return at;
}

// Air of another density or speed of sound at the same altitude, as its temperature and pressure make it: systems that make
// the configuration anew keep these.
void move_air(Configuration<double>& c, ConfigurationParameter parameter, double by) {
  double density = c.air.density;
  double sound = c.air.speed_of_sound;
  (parameter == ConfigurationParameter::air_density ? density : sound) += by;
  const Air<double> standard = standard_air(c.setup.altitude);
  const double ratio = (sound / standard.speed_of_sound) * (sound / standard.speed_of_sound);
  c.around.warmer = standard.temperature * (ratio - 1);
  c.around.pressure_above = density / standard.density * ratio - 1;
  configure(c);
}

bool is_of_air(const SensitivityParameter& p) {
  return p.parameter == ConfigurationParameter::air_density ||
         p.parameter == ConfigurationParameter::speed_of_sound;
}

// Along mast angle and flap tables are linear between their knots: the side to look to, as partials do; 0: both.
int table_side(const SensitivityParameter& p, const Configuration<double>& c) {
  const LimitTables<double>& limits = c.aircraft->limits;
  if (p.parameter == ConfigurationParameter::mast) return c.setup.mast_deg < limits.mast_deg.high ? 1 : -1;
  if (p.parameter == ConfigurationParameter::flap) return c.setup.flap_deg < limits.flap_deg.high ? 1 : -1;
  return 0;
}

// Third order.
template <class At>
Numbers one_sided_slopes(At&& at, double h) {
  const Numbers zero = at(0), one = at(h), two = at(2 * h), three = at(3 * h);
  Numbers out(zero.size());
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = (18 * one[i] - 11 * zero[i] - 9 * two[i] + 2 * three[i]) / (6 * h);
  return out;
}

// The wind of a flight from its azimuth, at the speed, climb and turn of another.
study::Track track_of(const TrimmedFlight& flight, const SteadyFlight<double>& other) {
  return track_in_wind(other, *flight.azimuth_deg * kRadPerDeg<double>);
}

// A group of numbers times a factor.
template <class Shape>
void scale(double by, Shape& s) {
  Shape::each(s, [by](double& x) { x *= by; });
}

}  // namespace

struct Sensitivity::Memory {
  LinearModel<double> model, changed;
  ModesWorkspace<double> modes;
  ModeSet<double> set;
  VehicleMatrices matrices;
  VehicleModes<double> vehicle_modes;
  Eigensystem<double, kMaxVehicleStates> vehicle_system;
  Matrix<double, kMaxVehicleStates, kMaxVehicleStates> closed_loop;  // its slope
  SensitivityWorkspace<double> columns;
  ConfigurationSensitivity<double> column;
  TrimMotionWorkspace<double> trims;
  ModelMotionWorkspace<double> motions;
  ModelMotion<double> motion;
  RootMotionWorkspace<double> roots;
  RootMotion<double> root[kMaxLinearStates];
  DerivativeSteps<double> steps;
  State<double> rates;
  Configuration<double> moved;
};

Sensitivity::Sensitivity(const SensitivitySystems& systems)
    : systems_(systems), memory_(std::make_unique<Memory>()) {}
Sensitivity::~Sensitivity() = default;

// In systems the aircraft is changed where it can be: they make what follows from a setting anew.
bool Sensitivity::changes_aircraft(const SensitivityParameter& p) const {
  return p.change != nullptr && (p.parameter == ConfigurationParameter::count || systems_.any());
}

Status Sensitivity::begin(const TrimmedFlight& flight, Analyses& work) {
  Memory& m = *memory_;
  flight_ = &flight;
  work_ = &work;
  const Configuration<double>& c = flight.configuration;
  const State<double>& x = flight.trim.state;
  const Controls<double>& u = flight.trim.controls;
  Status status = linearize(c, x, u, kInceptors, work, m.model);
  if (status == Status::ok)
    status = flight.azimuth_deg
                 ? prepare_motion(c, study::TrackMotion{track_of(flight, flight.flight)}, x, m.model, m.trims)
                 : prepare_trim_motion(c, flight.flight, x, m.model, m.trims);
  if (status == Status::ok && !systems_.any()) status = modes(m.model, m.modes, m.set);
  if (status == Status::ok && systems_.any()) {
    status = linearize_governed(c, x, u, ControlSet{}, work, m.matrices, systems_.scas);
    if (status == Status::ok) status = vehicle_modes(m.matrices, work, m.vehicle_modes);
    m.vehicle_system = vehicle_eigensystem(work);
  }
  if (status == Status::ok) name_roots();
  return status;
}

void Sensitivity::name_roots() {
  const Memory& m = *memory_;
  roots_.clear();
  const auto add = [this](const auto& root, const char* axis) {
    roots_.push_back({axis, root.name, root.real, root.imag, root.frequency, root.damping_ratio});
  };
  for (int i = 0; i < m.set.count && !systems_.any(); ++i) add(m.set.mode[i], axis_word(m.set.mode[i].axis));
  for (int i = 0; i < m.vehicle_modes.count && systems_.any(); ++i) {
    const VehicleMode<double>& root = m.vehicle_modes.mode[i];
    add(root, root.is_system ? "system" : axis_word(root.axis));
  }
}

Numbers Sensitivity::airframe_numbers(const Configuration<double>& c, const TrimMotion<double>& motion,
                                      double by, Status& status) {
  Memory& m = *memory_;
  const auto [x, u] = moved(flight_->trim, motion, by);
  const Status found = linearize(c, x, u, ControlSet{}, *work_, m.changed);
  if (found != Status::ok) status = found;
  Numbers all(m.changed.xdot, m.changed.xdot + state_count);
  derivative(c, x, u, m.steps, m.rates, 0.0);
  all.push_back(c.setup.rotor_speed * (m.steps.rotor[right].loads.torque + m.steps.rotor[left].loads.torque));
  append(m.changed.a, m.model.states, all);
  return all;
}

Numbers Sensitivity::closed_loop_numbers(const Configuration<double>& c, const TrimMotion<double>& motion,
                                         double by, Status& status) {
  Memory& m = *memory_;
  const auto [x, u] = moved(flight_->trim, motion, by);
  const Status found = linearize_governed(c, x, u, ControlSet{}, *work_, m.matrices, systems_.scas);
  if (found != Status::ok) status = found;
  Numbers all;
  append(m.matrices.a, m.matrices.shape.states, all);
  return all;
}

// Central differences over h and h/2, extrapolated.
Numbers Sensitivity::slopes(const SensitivityParameter& p, const TrimMotion<double>& motion, double h,
                            NumbersOf numbers_of, Status& status) {
  const auto at = [&](double by) {
    if (p.held != nullptr) return (this->*numbers_of)(flight_->configuration, motion, by, status);
    if (is_of_air(p)) {
      memory_->moved = flight_->configuration;
      move_air(memory_->moved, p.parameter, by);
      return (this->*numbers_of)(memory_->moved, motion, by, status);
    }
    if (!changes_aircraft(p)) {
      moved_configuration(flight_->configuration, &p.parameter, &by, 1, memory_->moved);
      return (this->*numbers_of)(memory_->moved, motion, by, status);
    }
    const ChangedAircraft changed(flight_->configuration, [&](ChangedAircraft& a) { p.change(a, by); });
    return (this->*numbers_of)(changed.configuration(), motion, by, status);
  };
  const int side = table_side(p, flight_->configuration);
  if (side != 0) return one_sided_slopes(at, side * h);
  const Numbers above = at(h), below = at(-h), near_above = at(0.5 * h), near_below = at(-0.5 * h);
  Numbers out(above.size());
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = (8 * (near_above[i] - near_below[i]) - (above[i] - below[i])) / (6 * h);
  return out;
}

// At the attitude of the trim velocity is proportional to speed, and body rates to the turn rate.
State<double> Sensitivity::set_by_flight(const SensitivityParameter& p) const {
  const State<double>& x = flight_->trim.state;
  SteadyFlight<double> unit = flight_->flight;
  unit.*p.held = 1;
  State<double> direct{};
  if (p.held == &SteadyFlight<double>::speed)
    direct.velocity = flight_->azimuth_deg
                          ? study::TrackMotion{track_of(*flight_, unit)}.velocity(x.roll, x.pitch)
                          : steady_velocity(unit, x.roll, x.pitch);
  if (p.held == &SteadyFlight<double>::turn_rate) direct.rates = steady_rates(unit, x.roll, x.pitch);
  return direct;
}

Numbers Sensitivity::rates_along(const State<double>& direct) const {
  const LinearModel<double>& model = memory_->model;
  double x[state_count];
  flatten(direct, x);
  Numbers rates(state_count);
  for (int i = 0; i < model.states; ++i)
    for (int j = 0; j < model.states; ++j)
      rates[static_cast<std::size_t>(model.state[i])] += model.a(i, j) * x[model.state[j]];
  return rates;
}

Status Sensitivity::move(const SensitivityParameter& p, FlightMotion& out) {
  Memory& m = *memory_;
  const Configuration<double>& c = flight_->configuration;
  const State<double>& x = flight_->trim.state;
  const Controls<double>& u = flight_->trim.controls;
  const bool by_aircraft = changes_aircraft(p);
  const double change = by_aircraft ? p.amount : p.amount * p.in_si(c);
  const double step = kStep * change;
  out.exact = !by_aircraft && !systems_.any();
  Status status = Status::ok;

  // With state and controls held.
  Numbers held;
  State<double> direct{};  // what the flight sets itself
  if (p.held != nullptr) {
    direct = set_by_flight(p);
    held = rates_along(direct);
  } else if (by_aircraft) {
    held = slopes(p, {}, step, &Sensitivity::airframe_numbers, status);
  } else {
    status = configuration_sensitivity(c, x, u, {1, {p.parameter}}, m.columns, m.column);
    for (int i = 0; i < state_count; ++i) held.push_back(m.column.rates(i, 0));
  }
  if (status == Status::ok) status = trim_motion(held.data(), m.trims, out.trim);
  if (status != Status::ok) return status;
  out.trim.x.velocity = out.trim.x.velocity + direct.velocity;
  out.trim.x.rates = out.trim.x.rates + direct.rates;

  // And with the trim, of the airframe,
  const int n = m.model.states;
  const ConfigurationParameter parameter = by_aircraft ? ConfigurationParameter::count : p.parameter;
  status = model_motion(c, x, u, m.model, parameter, out.trim, m.motions, m.motion);
  if (status != Status::ok) return status;
  out.power = m.motion.power[right] + m.motion.power[left];
  if (by_aircraft) {
    out.power += held[state_count];
    const double* own = held.data() + state_count + 1;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) m.motion.a(i, j) += *own++;
  }
  // or of the closed loop.
  if (systems_.any()) {
    const Numbers slope = slopes(p, out.trim, step, &Sensitivity::closed_loop_numbers, status);
    const std::size_t states = static_cast<std::size_t>(m.matrices.shape.states);
    for (std::size_t i = 0; i < slope.size(); ++i)
      m.closed_loop(static_cast<int>(i / states), static_cast<int>(i % states)) = slope[i];
  }
  find_roots(out.root);

  scale(change, out.trim.x);
  scale(change, out.trim.u);
  out.power *= change;
  for (RootMotion<double>& root : out.root)
    root = {change * root.real, change * root.imag, change * root.frequency, change * root.damping_ratio};
  return status;
}

void Sensitivity::find_roots(std::vector<RootMotion<double>>& roots) {
  Memory& m = *memory_;
  roots.clear();
  if (!systems_.any()) {
    root_motions(m.model, m.motion.a, m.set, m.roots, m.root);
    roots.assign(m.root, m.root + m.set.count);
    return;
  }
  Symmetry symmetry[kMaxVehicleStates];
  split_rotors(m.matrices.shape, m.closed_loop, symmetry);
  for (int i = 0; i < m.vehicle_modes.count; ++i)
    roots.push_back(root_motion(m.vehicle_system, m.vehicle_modes.mode[i].eigenvalue, m.closed_loop));
}

}  // namespace tiltrotor::cli

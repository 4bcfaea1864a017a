#include "cli/sensitivity.hpp"

#include <algorithm>
#include <cmath>

#include "cli/governed.hpp"
#include "cli/model_slope.hpp"
#include "cli/wind_trim.hpp"
#include "tiltrotor/analysis/linear/model_motion.hpp"

namespace tiltrotor::cli {

namespace {

// Air of another density or speed of sound at the same altitude, as its temperature and pressure make it.
void move_air(const Configuration<double>& c, ConfigurationParameter parameter, Along by,
              Surroundings<Along>& around) {
  Along density = c.air.density;
  Along sound = c.air.speed_of_sound;
  (parameter == ConfigurationParameter::air_density ? density : sound) += by;
  const Air<Along> standard = standard_air(Along(c.setup.altitude));
  const Along ratio = square(sound / standard.speed_of_sound);
  around.warmer = standard.temperature * (ratio - Along(1));
  around.pressure_above = density / standard.density * ratio - Along(1);
}

bool is_of_air(const SensitivityParameter& p) {
  return p.parameter == ConfigurationParameter::air_density ||
         p.parameter == ConfigurationParameter::speed_of_sound;
}

// The wind of a flight from its azimuth, at the speed, climb and turn of another.
study::Track track_of(const TrimmedFlight& flight, const SteadyFlight<double>& other) {
  return track_in_wind(other, *flight.azimuth_deg * kRadPerDeg<double>);
}

// How velocity follows climb or sideslip at an attitude, m/s per rad: with the track k of steady_velocity(), where
// sin(k + d) = C/D, D cos(k + d) k' = C'. Of vertical flight with level wings: it leans to the nose or the tail.
Vec3<double> by_path(const SteadyFlight<double>& flight, const State<double>& x, bool by_climb) {
  const auto level_to_body = earth_to_body(EulerAngles<double>{x.roll, x.pitch, 0});
  const double sine = std::sin(flight.climb), cosine = std::cos(flight.climb);
  if (is_vertical(flight))
    return level_to_body.apply(Vec3<double>{by_climb ? -flight.speed * sine : 0, 0, 0});
  SteadyFlight<double> unit = flight;  // so that nothing is divided by the speed
  unit.speed = 1;
  const Vec3<double> level = level_to_body.apply_inverse(steady_velocity(unit, x.roll, x.pitch));
  const double ck = level.x / cosine, sk = level.y / cosine;
  const double c_slope =
      by_climb ? (std::sin(x.roll) * std::cos(x.pitch) + std::sin(flight.sideslip) * sine) / (cosine * cosine)
               : std::cos(flight.sideslip) / cosine;
  const double k_slope = c_slope / (std::cos(x.roll) * ck - std::sin(x.roll) * std::sin(x.pitch) * sk);
  const Vec3<double> turned = {-level.y * k_slope, level.x * k_slope, 0};
  const Vec3<double> tilted = {-sine * ck, -sine * sk, -cosine};
  return flight.speed * level_to_body.apply(by_climb ? turned + tilted : turned);
}

constexpr int kMostTargets = 3;
using Targets = Matrix<double, kMostTargets, kMostTargets>;

// Searches leave 1e-10 of what is held, which where it is largest or least is a place wrong by about 1e-5 steps: a
// slope less than this, of its size over a step, may be that of the wrong place alone.
constexpr double kLeastSlope = 1e-5;
// What is held stays when this is all that it moves by, of its size.
constexpr double kStays = 1e-9;
// Sine of the bank of level wings.
constexpr double kLevel = 1e-9;

// What the flight does not let move: at rest there is no path, and straight up or down sideslip follows from the
// attitude.
bool is_fixed(const TrimTarget& target, const SteadyFlight<double>& flight) {
  const bool at_rest = flight.speed < kLeastSpeed<double>;
  if (target.freed == "climb_deg") return at_rest;
  return target.freed == "sideslip_deg" && (at_rest || is_vertical(flight));
}

double size_of(const TrimTarget& target) { return std::max(std::fabs(target.value), 1.0); }

std::string with_and(const TrimTargets& targets, std::string TrimTarget::*name) {
  std::string text;
  for (const TrimTarget& target : targets) text += (text.empty() ? "" : " and ") + target.*name;
  return text;
}

// Whose row or column holds nothing, or that no single one does; the slopes are scaled.
std::string unmoved(const Targets& slope, const TrimTargets& targets) {
  const auto part = [&](std::string TrimTarget::*name, auto&& entry) {
    for (std::size_t i = 0; i < targets.size(); ++i) {
      double most = 0;
      for (std::size_t k = 0; k < targets.size(); ++k)
        most = std::max(most, std::fabs(entry(static_cast<int>(i), static_cast<int>(k))));
      if (most < kLeastSlope) return targets[i].*name;
    }
    return std::string();
  };
  const std::string held = part(&TrimTarget::held, [&](int i, int k) { return slope(i, k); });
  const std::string freed = part(&TrimTarget::freed, [&](int j, int k) { return slope(k, j); });
  const std::string all_held = with_and(targets, &TrimTarget::held),
                    all_freed = with_and(targets, &TrimTarget::freed);
  if (!held.empty()) return held + " does not move with " + all_freed + " here: free another";
  if (!freed.empty()) return all_held + " do not move with " + freed + " here: free another";
  return all_held + " do not each move alone with " + all_freed + " here: free others";
}

template <class Shape, std::size_t kCount>
void add(double by, const Shape& more, Shape& to, double (&sum)[kCount]) {
  double part[kCount];
  flatten(to, sum);
  flatten(more, part);
  for (std::size_t i = 0; i < kCount; ++i) sum[i] += by * part[i];
  unflatten(sum, to);
}

// Motions are linear: a multiple of one beside another.
void add(double by, const FlightMotion& more, FlightMotion& to) {
  double x[state_count], u[control_count];
  add(by, more.trim.x, to.trim.x, x);
  add(by, more.trim.u, to.trim.u, u);
  to.power += by * more.power;
  for (std::size_t i = 0; i < to.root.size(); ++i) {
    const RootMotion<double>& part = more.root[i];
    RootMotion<double>& root = to.root[i];
    root = {root.real + by * part.real, root.imag + by * part.imag, root.frequency + by * part.frequency,
            root.damping_ratio + by * part.damping_ratio};
  }
}

}  // namespace

struct Sensitivity::Memory {
  LinearModel<double> model;
  ModesWorkspace<double> modes;
  ModeSet<double> set;
  VehicleMatrices matrices;
  VehicleModes<double> vehicle_modes;
  Eigensystem<double, kMaxVehicleStates> vehicle_system;
  ModelSlope slope;
  ModelSlope::Airframe airframe;
  ModelSlope::Square closed_loop;  // its slope
  SensitivityWorkspace<double> columns;
  ConfigurationSensitivity<double> column;
  TrimMotionWorkspace<double> trims;
  ModelMotionWorkspace<double> motions;
  ModelMotion<double> motion;
  RootMotionWorkspace<double> roots;
  RootMotion<double> root[kMaxLinearStates];
  std::vector<FlightMotion> freed;  // by a unit of what each target lets go
  Targets by_freed;                 // how what is held moves with it
  LU<double, kMostTargets> scaled;  // the same by steps of the search, of the size of what is held
};

Sensitivity::Sensitivity(const SensitivitySystems& systems)
    : systems_(systems), memory_(std::make_unique<Memory>()) {}
Sensitivity::~Sensitivity() = default;

// In systems the aircraft is changed where it can be: they make what follows from a setting anew, as what is held does.
bool Sensitivity::changes_aircraft(const SensitivityParameter& p) const {
  const bool needed = systems_.any() || !flight_->targets.empty();
  return p.change.along != nullptr && (p.parameter == ConfigurationParameter::count || needed);
}

Status Sensitivity::begin(const TrimmedFlight& flight, Analyses& work) {
  Memory& m = *memory_;
  flight_ = &flight;
  work_ = &work;
  fault_.clear();
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
  return status == Status::ok ? begin_targets() : status;
}

Status Sensitivity::begin_targets() {
  Memory& m = *memory_;
  const TrimTargets& targets = flight_->targets;
  const SteadyFlight<double>& flight = flight_->flight;
  const int count = static_cast<int>(targets.size());
  m.freed.assign(targets.size(), {});
  set_zero(m.by_freed);
  if (count == 0) return Status::ok;
  Targets scaled;
  set_zero(scaled);
  for (int j = 0; j < count; ++j) {
    const auto place = static_cast<std::size_t>(j);
    const TrimTarget& target = targets[place];
    m.freed[place].root.resize(roots_.size());
    if (is_fixed(target, flight)) {
      scaled(j, j) = 1;
      continue;
    }
    if (target.freed == "climb_deg" && is_vertical(flight) &&
        std::fabs(std::sin(flight_->trim.state.roll)) > kLevel) {
      fault_ = "climb_deg has no slope in vertical flight with a bank: free another";
      return Status::out_of_range;
    }
    const SensitivityParameter& freed = freed_parameter(target.freed);
    std::vector<double> held;
    const Status status = move_alone(freed, m.freed[place], held);
    if (status != Status::ok) return status;
    const double step = freed_quantity(target.freed).step * freed.in_si(flight_->configuration);
    for (int i = 0; i < count; ++i) {
      const auto of = static_cast<std::size_t>(i);
      m.by_freed(i, j) = held[of];
      if (!is_fixed(targets[of], flight)) scaled(i, j) = held[of] * step / size_of(targets[of]);
    }
  }
  Status status = lu_factor(scaled, count, m.scaled);
  for (int i = 0; i < count && status == Status::ok; ++i) {
    double steps[kMostTargets] = {};
    steps[i] = 1;
    status = lu_solve(m.scaled, steps);
    for (const double step : steps)
      if (std::fabs(step) > 1 / kLeastSlope) status = Status::singular;
  }
  if (status == Status::singular) fault_ = unmoved(scaled, targets);
  return status;
}

// What is let go moves so that what is held stays, where the flight lets it.
Status Sensitivity::keep_targets(const SensitivityParameter& p, double change,
                                 const std::vector<double>& held, FlightMotion& motion) {
  const Memory& m = *memory_;
  const TrimTargets& targets = flight_->targets;
  const std::size_t count = targets.size();
  if (count == 0) return Status::ok;
  double steps[kMostTargets] = {}, left[kMostTargets] = {};
  for (std::size_t i = 0; i < count; ++i) {
    left[i] = held[i];
    steps[i] = is_fixed(targets[i], flight_->flight) ? 0 : -held[i] / size_of(targets[i]);
  }
  const Status status = lu_solve(m.scaled, steps);
  if (status != Status::ok) return status;
  for (std::size_t j = 0; j < count; ++j) {
    motion.freed.push_back(steps[j] * freed_quantity(targets[j].freed).step);
    const double by = motion.freed[j] * freed_parameter(targets[j].freed).in_si(flight_->configuration);
    add(by, m.freed[j], motion);
    for (std::size_t i = 0; i < count; ++i)
      left[i] += m.by_freed(static_cast<int>(i), static_cast<int>(j)) * by;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_fixed(targets[i], flight_->flight) || std::fabs(left[i] * change) <= kStays * size_of(targets[i]))
      continue;
    fault_ = targets[i].held + " moves with " + p.name + ", for which " + targets[i].freed +
             " has no effect here: free another";
    return Status::singular;
  }
  return Status::ok;
}

Status Sensitivity::move(const SensitivityParameter& p, FlightMotion& out) {
  fault_.clear();
  std::vector<double> held;
  FlightMotion alone;
  Status status = move_alone(p, alone, held);
  if (status != Status::ok) return status;
  const double change = changes_aircraft(p) ? p.amount : p.amount * p.in_si(flight_->configuration);
  status = keep_targets(p, change, held, alone);
  if (status != Status::ok) return status;
  out = {};
  out.root.resize(alone.root.size());
  add(change, alone, out);
  for (const double freed : alone.freed) out.freed.push_back(change * freed);
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

// By one unit of the parameter.
Status Sensitivity::begin_slope(const SensitivityParameter& p) {
  const Configuration<double>& c = flight_->configuration;
  return memory_->slope.begin(c, [&](Moved moved) {
    const Along by(0, 1);
    if (p.held != nullptr) return;
    if (changes_aircraft(p)) return p.change.along(moved.aircraft, by);
    if (is_of_air(p)) return move_air(c, p.parameter, by, moved.around);
    move_setting(p.parameter, by, moved.setting);
  });
}

// At the attitude of the trim velocity is proportional to speed, and body rates to the turn rate.
State<double> Sensitivity::set_by_flight(const SensitivityParameter& p) const {
  using F = SteadyFlight<double>;
  const State<double>& x = flight_->trim.state;
  const F& f = flight_->flight;
  F unit = f;
  unit.*p.held = 1;
  State<double> direct{};
  if (p.held == &F::turn_rate) direct.rates = steady_rates(unit, x.roll, x.pitch);
  if (p.held == &F::turn_rate) return direct;
  if (flight_->azimuth_deg) {
    study::Track track = track_of(*flight_, unit);
    if (p.held == &F::climb) {
      track.speed = -f.speed * std::sin(f.climb);
      track.down = -f.speed * std::cos(f.climb);
    }
    direct.velocity = study::TrackMotion{track}.velocity(x.roll, x.pitch);
  } else {
    direct.velocity =
        p.held == &F::speed ? steady_velocity(unit, x.roll, x.pitch) : by_path(f, x, p.held == &F::climb);
  }
  return direct;
}

void Sensitivity::rates_along(const State<double>& direct, double (&rates)[state_count]) const {
  const LinearModel<double>& model = memory_->model;
  double x[state_count];
  flatten(direct, x);
  for (int i = 0; i < model.states; ++i)
    for (int j = 0; j < model.states; ++j) rates[model.state[i]] += model.a(i, j) * x[model.state[j]];
}

Status Sensitivity::move_alone(const SensitivityParameter& p, FlightMotion& out,
                               std::vector<double>& of_targets) {
  Memory& m = *memory_;
  const Configuration<double>& c = flight_->configuration;
  const State<double>& x = flight_->trim.state;
  const Controls<double>& u = flight_->trim.controls;
  const bool by_aircraft = changes_aircraft(p);
  const bool needs_slope = by_aircraft || systems_.any() || !flight_->targets.empty();
  Status status = needs_slope ? begin_slope(p) : Status::ok;
  if (status != Status::ok) return status;

  // With state and controls held.
  double held[state_count] = {};
  State<double> direct{};  // what the flight sets itself
  if (p.held != nullptr) {
    direct = set_by_flight(p);
    rates_along(direct, held);
  } else if (by_aircraft) {
    status = m.slope.rates(x, u, held);
  } else {
    status = configuration_sensitivity(c, x, u, {1, {p.parameter}}, m.columns, m.column);
    for (int i = 0; i < state_count; ++i) held[i] = m.column.rates(i, 0);
  }
  if (status == Status::ok) status = trim_motion(held, m.trims, out.trim);
  if (status != Status::ok) return status;
  out.trim.x.velocity = out.trim.x.velocity + direct.velocity;
  out.trim.x.rates = out.trim.x.rates + direct.rates;

  // And with the trim: of the airframe,
  if (by_aircraft) {
    status = m.slope.airframe(x, u, out.trim, m.airframe);
    out.power = m.airframe.power;
    for (int i = 0; i < m.model.states; ++i)
      for (int j = 0; j < m.model.states; ++j)
        m.motion.a(i, j) = m.airframe.a[m.model.state[i]][m.model.state[j]];
  } else {
    status = model_motion(c, x, u, m.model, p.parameter, out.trim, m.motions, m.motion);
    out.power = m.motion.power[right] + m.motion.power[left];
  }
  // or of the closed loop.
  if (status == Status::ok && systems_.any())
    status = m.slope.closed_loop(x, u, out.trim, systems_.scas, m.closed_loop);
  if (status != Status::ok) return status;
  find_roots(out.root);

  of_targets.clear();
  for (const TrimTarget& target : flight_->targets)
    of_targets.push_back(m.slope.held(target, *flight_, out.trim));
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

// Time response of the complete nonlinear model: a stepper with fixed step and fixed memory.
//
//   Simulation<double> flight;  static SimulationWorkspace<double> work;
//   start(c, trimmed.state, trimmed.controls, 0.005, Integrator::rk4, flight);
//   add_input(flight, {InputShape::step, kControlIndex.collective, one_degree, 0.0, 0.0});
//   for (...) if (advance(c, work, flight) != Status::ok) ... flight.fault_state, flight.fault_time
//
// The impulse of every input is exact whatever the step: a step is cut where an input jumps inside it, and
// into equal parts where it is too long for the method (stable_step.hpp). change_step() goes on with another
// one, so that a flight may end at any time.
//
// Heading, and position when it is a state, are integrated with the rest. A and B at any moment: linearize(c,
// current_state(flight), current_controls(flight), ..., current_azimuth(c, flight)); the rates it finds are the
// first evaluation of the step that follows: advance(c, work, flight, model.xdot) takes them over and finds the
// same bits for one derivative less.
//
// Masts, rotor speed and air that move while the flight lasts: advance_moving().
#pragma once

#include <type_traits>

#include "tiltrotor/analysis/flight/attitude.hpp"
#include "tiltrotor/analysis/flight/configuration_motion.hpp"
#include "tiltrotor/analysis/flight/simulation.hpp"
#include "tiltrotor/analysis/flight/stable_step.hpp"
#include "tiltrotor/analysis/linear/differentiation.hpp"
#include "tiltrotor/math/integrate.hpp"

namespace tiltrotor {

template <class R, class Policy = DefaultDifferentiation>
struct SimulationWorkspace {
  using Seeded = typename Policy::template Scalar<R, kModelDirections>;
  ModelWorkspaces<R, Seeded> model;
  typename Policy::template Workspace<R, kModelDirections, state_count, state_count> differentiation;
  Matrix<R, state_count, state_count> jacobian;
  union Method {
    RungeKuttaWorkspace<R, state_count> runge_kutta;
    RosenbrockWorkspace<R, state_count> rosenbrock;
  } method;
  ActiveStates active;
  R x[state_count];  // active states; of the sums what the step adds
  R rates[state_count];
  R ahead[state_count], behind[state_count];
  R scale[state_count];
  R upright[state_count];  // active states with Euler angles, in steep flight
  R whole[state_count];    // every state, for those that stand still
};

namespace response_detail {

// Places of the attitude and of the body rates among the active states: the first nine are alive always.
inline constexpr int kRoll = kStateIndex.roll, kPitch = kStateIndex.pitch, kYaw = kStateIndex.yaw;
inline constexpr int kRates[] = {kStateIndex.rates.x, kStateIndex.rates.y, kStateIndex.rates.z};
static_assert(kYaw == 8 && kRoll == 6 && kPitch == 7);

// Attitude at the beginning of a part in steep flight.
template <class R>
struct SteepStart {
  EulerAngles<R> angles;
  Rotation<R> rotation;
  R bank, heading;  // added since the beginning of the step
};

// Right side of the active states at constant controls.
template <class R, class Policy>
struct RightSide {
  const Configuration<R>& c;
  SimulationWorkspace<R, Policy>& work;
  const Controls<R>& controls;
  int& fault_state;
  R azimuth_at_0;
  const MovingConfiguration<R>* moving;  // of `c`, or nullptr
  const SteepStart<R>* steep;            // of a part in steep flight, or nullptr

  R azimuth(R time) const {
    if (moving == nullptr) return azimuth_at_0 + c.setup.rotor_speed * time;
    return azimuth_at_0 + moving->from.rotor_speed * moving->begin +
           turned(moving->from, time - moving->begin);
  }
  void place_configuration(R time, const R* x) const {
    if (moving == nullptr) return;
    R down = work.whole[kStateIndex.position.z];
    for (int k = 0; k < work.active.count; ++k)
      if (work.active.index[k] == kStateIndex.position.z) down += x[k];
    place(*moving, time, down);
  }

  template <class T>
  void rates(const T* x, T* rates, R azimuth) const {
    ModelWorkspace<T>& at = work.model.template of<T>();
    R u[control_count];
    flatten(controls, u);
    for (int i = 0; i < state_count; ++i) at.x[i] = T(work.whole[i]);
    for (int j = 0; j < control_count; ++j) at.u[j] = T(u[j]);
    for (int k = 0; k < work.active.count; ++k) {
      const int i = work.active.index[k];
      at.x[i] = sum_of(i) < 0 ? x[k] : at.x[i] + x[k];
    }
    model_rates(c, azimuth, at);
    for (int k = 0; k < work.active.count; ++k) rates[k] = at.x[work.active.index[k]];
  }

  // The attitude by its turn since the beginning of the part: attitude.hpp.
  void steep_rates(const R* x, R* xdot, R azimuth) const {
    const Vec3<R> turn = {x[kRoll], x[kPitch], x[kYaw]};
    // At the beginning the angles themselves, so that rates found there before are the same bits.
    const bool begins = turn.x == R(0) && turn.y == R(0) && turn.z == R(0);
    const EulerAngles<R> now =
        begins ? steep->angles : euler_angles(turned_by(turn, steep->rotation), steep->angles.roll);
    for (int k = 0; k < work.active.count; ++k) work.upright[k] = x[k];
    work.upright[kRoll] = begins ? steep->bank : now.roll - work.whole[kRoll];
    work.upright[kPitch] = now.pitch;
    work.upright[kYaw] = begins ? steep->heading : now.yaw - work.whole[kYaw];
    rates(static_cast<const R*>(work.upright), xdot, azimuth);
    const Vec3<R> rate = turn_rate(turn, {x[kRates[0]], x[kRates[1]], x[kRates[2]]});
    xdot[kRoll] = rate.x;
    xdot[kPitch] = rate.y;
    xdot[kYaw] = rate.z;
  }

  Status operator()(R time, const R* x, R* xdot) const {
    place_configuration(time, x);
    if (steep == nullptr) {
      rates(x, xdot, azimuth(time));
    } else {
      steep_rates(x, xdot, azimuth(time));
    }
    for (int k = 0; k < work.active.count; ++k) {
      if (!is_finite(xdot[k])) {
        fault_state = work.active.index[k];
        return Status::not_finite;
      }
    }
    return Status::ok;
  }
};

template <class R, class Policy>
Status rodas3(const RightSide<R, Policy>& f, R time, R dt) {
  SimulationWorkspace<R, Policy>& work = f.work;
  const Configuration<R>& c = f.c;
  const int n = work.active.count;
  const R azimuth = f.azimuth(time);
  f.place_configuration(time, work.x);
  for (int k = 0; k < n; ++k) work.scale[k] = state_scale<R>(work.active.index[k]);
  Policy::jacobian([&f, azimuth](const auto* x, auto* rates) { f.rates(x, rates, azimuth); },
                   {n, n, work.x, work.scale, work.rates}, work.differentiation,
                   [&work](int i, int j, R slope) { work.jacobian(i, j) = slope; });
  const R* known = work.rates;
  if (c.setup.options.azimuth == AzimuthMode::averaged && f.moving == nullptr)
    return rodas3_step(f, work.jacobian, {time, dt, work.x, n, known}, work.method.rosenbrock);

  // Blades that turn and masts that move make f depend on time; they carry no partials, so a central difference.
  const R step = std::cbrt(std::numeric_limits<R>::epsilon());
  const R rotor_speed = c.setup.rotor_speed;
  f.place_configuration(time + step / rotor_speed, work.x);
  f.rates(static_cast<const R*>(work.x), work.ahead, azimuth + step);
  f.place_configuration(time - step / rotor_speed, work.x);
  f.rates(static_cast<const R*>(work.x), work.behind, azimuth - step);
  for (int k = 0; k < n; ++k) work.ahead[k] = rotor_speed * (work.ahead[k] - work.behind[k]) / (R(2) * step);
  return rodas3_step(f, work.jacobian, {time, dt, work.x, n, known, work.ahead}, work.method.rosenbrock);
}

template <class R, class Policy>
Status explicit_or_rodas3(const RightSide<R, Policy>& f, Integrator integrator, R time, R dt,
                          const R* known) {
  SimulationWorkspace<R, Policy>& work = f.work;
  const int n = work.active.count;
  switch (integrator) {
    case Integrator::rk3:
      return rk3_step(f, {time, dt, work.x, n, known}, work.method.runge_kutta);
    case Integrator::rk4:
      return rk4_step(f, {time, dt, work.x, n, known}, work.method.runge_kutta);
    case Integrator::rodas3:
      return rodas3(f, time, dt);
  }
  return Status::bad_argument;
}

// A part in steep flight: the places of the attitude hold its turn meanwhile.
template <class R, class Policy>
Status steep_step(const RightSide<R, Policy>& f, Integrator integrator, R time, R dt, const R* known) {
  SimulationWorkspace<R, Policy>& work = f.work;
  R* const x = work.x;
  const EulerAngles<R> before = {work.whole[kRoll] + x[kRoll], x[kPitch], work.whole[kYaw] + x[kYaw]};
  const SteepStart<R> start = {before, earth_to_body(before), x[kRoll], x[kYaw]};
  x[kRoll] = x[kPitch] = x[kYaw] = R(0);
  if (known != nullptr) {
    work.rates[kRoll] = R(0.25) * x[kRates[0]];
    work.rates[kPitch] = R(0.25) * x[kRates[1]];
    work.rates[kYaw] = R(0.25) * x[kRates[2]];
  }
  RightSide<R, Policy> steep = f;
  steep.steep = &start;
  const Status status = explicit_or_rodas3(steep, integrator, time, dt, known);
  if (status != Status::ok) return status;
  const Vec3<R> turn = {x[kRoll], x[kPitch], x[kYaw]};
  const EulerAngles<R> now = euler_angles(turned_by(turn, start.rotation), before.roll);
  const auto added = [](R from, R to) {
    return static_cast<R>(within_half_a_turn(static_cast<double>(to) - static_cast<double>(from)));
  };
  x[kRoll] = start.bank + added(before.roll, now.roll);
  // Straight up and down are left to the neighbourhood: there, bank and heading are one.
  const R most = state_bound<R>(kPitch);
  x[kPitch] = now.pitch > most ? most : now.pitch < -most ? -most : now.pitch;
  x[kYaw] = start.heading + added(before.yaw, now.yaw);
  return status;
}

// rodas3 keeps to Euler angles: its Jacobian is that of the state.
template <class R, class Policy>
Status step(const RightSide<R, Policy>& f, Integrator integrator, R time, R dt, const R* known) {
  const bool is_steep = std::fabs(f.work.x[kPitch]) > kSteepPitch<R>;
  return is_steep && integrator != Integrator::rodas3 ? steep_step(f, integrator, time, dt, known)
                                                      : explicit_or_rodas3(f, integrator, time, dt, known);
}

// Equal parts of a step in which the method is stable. The limit ends the loop; no state within its bounds
// reaches it.
inline constexpr int kMaxParts = 4096;
template <class R>
int parts(Integrator integrator, R duration, const FastestRates<R>& fastest) {
  if (integrator == Integrator::rodas3) return 1;
  const StabilityLimits& limits = integrator == Integrator::rk3 ? kRungeKutta3Limits : kRungeKutta4Limits;
  const R whole = duration / longest_stable_step(fastest, limits);
  return whole < R(kMaxParts) ? 1 + static_cast<int>(whole) : kMaxParts;
}

// Constant controls for `duration`, in `count` parts.
template <class R, class Policy>
Status hold(const RightSide<R, Policy>& f, Integrator integrator, R time, R duration, int count,
            const R* known) {
  const R part = duration / static_cast<R>(count);
  for (int i = 0; i < count; ++i) {
    const Status status =
        step(f, integrator, time + static_cast<R>(i) * part, part, i == 0 ? known : nullptr);
    if (status != Status::ok) return status;
    for (int k = 0; k < f.work.active.count; ++k) {
      f.fault_state = f.work.active.index[k];
      if (!(std::fabs(f.work.x[k]) <= state_bound<R>(f.fault_state))) return Status::out_of_range;
    }
    f.fault_state = -1;
  }
  return Status::ok;
}

// The configuration at the end of a stretch of a step.
template <class R, class Policy>
Status arrive(const MovingConfiguration<R>& moving, R time, bool at_stop, const RightSide<R, Policy>& f,
              int& fault_state) {
  Configuration<R>& c = *moving.configuration;
  f.place_configuration(time, f.work.x);
  // A mast that comes to rest at its stop may lie beyond it by a rounding.
  const Bounds<R>& stops = c.aircraft->limits.mast_deg;
  if (at_stop || c.setup.mast_deg < stops.low || c.setup.mast_deg > stops.high) {
    stop_mast<R>(c.setup, stops);
    configure(c);
  }
  const SetupField fault = first_out_of_range(*c.aircraft, c.setup).field;
  if (fault == SetupField::none) return Status::ok;
  if (fault == SetupField::altitude) fault_state = kStateIndex.position.z;
  return Status::out_of_range;
}

// A step; `moving`: of `c`, or nullptr.
template <class R, class Policy>
Status advance(const Configuration<R>& c, MovingConfiguration<R>* moving,
               SimulationWorkspace<R, Policy>& work, Simulation<R>& s, const R* xdot) {
  work.active = active_states(c.setup.options, true);
  const int n = work.active.count;
  Travel travel = s.travel;
  follow(s.state, travel);
  flatten(without_turns(s.state, travel), work.whole);
  // Sums begin at zero: what a step adds is not rounded to the size of the sum.
  for (int k = 0; k < n; ++k)
    work.x[k] = sum_of(work.active.index[k]) < 0 ? work.whole[work.active.index[k]] : R(0);
  s.fault_state = -1;

  const R* known = nullptr;
  if (xdot != nullptr) {
    for (int k = 0; k < n; ++k) work.rates[k] = xdot[work.active.index[k]];
    known = work.rates;
  }
  const R begin = current_time(s);
  R azimuth = s.azimuth;
  R since = R(0);
  for (int k = 0; k < kMaxStretches && since < s.dt && s.status == Status::ok; ++k) {
    R until = next_change(s, since);
    bool stops = false;
    if (moving != nullptr) {
      moving->from = c.setup;
      moving->begin = begin + since;
      const R stop = since + time_to_stop(moving->from, c.aircraft->limits.mast_deg, until - since);
      stops = stop < until;
      if (stops) until = stop;
    }
    const Controls<R> controls = controls_at(s, begin + R(0.5) * (since + until));
    const RightSide<R, Policy> f{c, work, controls, s.fault_state, azimuth, moving, nullptr};
    if (until > since) {
      const int count = parts(s.integrator, until - since, fastest_rates(c, s.state, controls));
      s.status = hold(f, s.integrator, begin + since, until - since, count, known);
      known = nullptr;
    }
    if (stops) known = nullptr;  // they are those of a mast on its way
    if (moving != nullptr && s.status == Status::ok) {
      const R azimuth_now = f.azimuth(begin + until);
      s.status = arrive(*moving, begin + until, stops, f, s.fault_state);
      if (moving->from.rotor_acceleration != R(0))
        azimuth = azimuth_now - c.setup.rotor_speed * (begin + until);
    }
    since = until;
  }
  for (int k = 0; k < n && s.status == Status::ok; ++k) {
    const int index = work.active.index[k];
    const int sum = sum_of(index);
    if (sum < 0) continue;
    travel.sum[sum] += static_cast<double>(work.x[k]);
    work.x[k] = static_cast<R>(travel.sum[sum]);
    if (!(std::fabs(travel.sum[sum]) <= static_cast<double>(state_bound<R>(index)))) {
      s.fault_state = index;
      s.status = Status::out_of_range;
    }
  }
  if (s.status != Status::ok) {
    s.fault_time = begin + s.dt;
    return s.status;
  }
  for (int k = 0; k < n; ++k) work.whole[work.active.index[k]] = work.x[k];
  unflatten(work.whole, s.state);
  if (moving != nullptr && moving->air_follows_altitude)
    set_altitude(*moving->configuration, moving->altitude_origin - s.state.position.z);
  s.travel = travel;
  s.azimuth = azimuth;
  ++s.steps;
  return s.status;
}

}  // namespace response_detail

// One step of dt, from edge to edge of the inputs inside it, in equal parts where the method would be
// unstable (stable_step.hpp). Status: ok; not_finite or out_of_range (the flight has diverged: fault_state
// and fault_time tell which state and when, the state stays that of the last good step); singular (rodas3);
// bad_argument (an unknown integrator). A failed simulation does not move again. Cost of a part: three
// derivatives (rk3); four (rk4); two and a Jacobian (rodas3). `xdot`[state_count]: the rates at the present
// state and controls, when they are known (LinearModel); they spare rk3 and rk4 their first derivative.
template <class R, class Policy>
Status advance(const Configuration<R>& c, SimulationWorkspace<R, Policy>& work, Simulation<R>& s,
               const R* xdot = nullptr) {
  if (s.status != Status::ok) return s.status;
  return response_detail::advance(c, static_cast<MovingConfiguration<R>*>(nullptr), work, s, xdot);
}

// The same, while masts and rotors move as the rates and accelerations of the setting carry them, every evaluation
// sees them where they are, and air follows the altitude when asked to. At its stop a mast stays; the step is cut
// there. The configuration goes along and is as it was unless ok; out_of_range also where it leaves the ranges of
// a setting. Where nothing moves: the bits of advance(), for its cost; else a twentieth of a derivative more an
// evaluation.
template <class R, class Policy>
Status advance_moving(MovingConfiguration<R>& moving, SimulationWorkspace<R, Policy>& work, Simulation<R>& s,
                      const R* xdot = nullptr) {
  if (s.status != Status::ok) return s.status;
  Configuration<R>& c = *moving.configuration;
  if (!is_moving<R>(c.setup) && !moving.air_follows_altitude) return advance(c, work, s, xdot);
  const ConfigurationSetting<R> before = c.setup;
  const Status status = response_detail::advance(c, &moving, work, s, xdot);
  if (status != Status::ok) {
    static_cast<ConfigurationSetting<R>&>(c.setup) = before;
    configure(c);
  }
  return status;
}

}  // namespace tiltrotor

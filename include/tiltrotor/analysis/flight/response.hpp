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
// Simulation is plain: a snapshot is a copy, and a replay is exact. Heading, and position when it is a state,
// are integrated with the rest. A and B at any moment: linearize(c, current_state(flight),
// current_controls(flight), ..., current_azimuth(c, flight)); the rates it finds are the first evaluation of
// the step that follows:
// advance(c, work, flight, model.xdot) takes them over and finds the same bits for one derivative less.
#pragma once

#include <type_traits>

#include "tiltrotor/analysis/flight/input_signal.hpp"
#include "tiltrotor/analysis/flight/stable_step.hpp"
#include "tiltrotor/analysis/flight/travel.hpp"
#include "tiltrotor/analysis/linear/differentiation.hpp"
#include "tiltrotor/math/integrate.hpp"

namespace tiltrotor {

// rk3: explicit, three derivatives a part of a step; for frames of 5 ms and less.
// rk4: explicit, four derivatives a part of a step.
// rodas3: Rosenbrock, L-stable, two derivatives and one Jacobian a step; for longer steps and stiff settings.
enum class Integrator : unsigned char { rk3, rk4, rodas3 };

inline constexpr int kMaxInputs = 8;
template <class R>
inline constexpr R kLongestStep = R(1);  // s

template <class R>
struct Simulation {
  State<R> state;
  Travel travel;         // its sums, more exactly
  Controls<R> controls;  // what the inputs add to; may be changed between steps
  InputSignal<R> input[kMaxInputs];
  int inputs;
  Integrator integrator;
  R dt;
  R origin;         // s, when steps of dt began
  unsigned steps;   // done since; time = origin + steps dt
  Status status;    // of the last step; a failed flight stays where it was
  int fault_state;  // place in kStateVariables of the state that failed, or -1
  R fault_time;     // s, end of the step that failed
};

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
  R whole[state_count];  // every state, for those that stand still
};

template <class R>
R current_time(const Simulation<R>& s) {
  return s.origin + static_cast<R>(s.steps) * s.dt;
}

// Position of the right rotor's first blade.
template <class R>
R current_azimuth(const Configuration<R>& c, const Simulation<R>& s) {
  return c.setup.rotor_speed * current_time(s);
}

// The state with bank and heading within half a turn: what the next step begins with.
template <class R>
State<R> current_state(const Simulation<R>& s) {
  Travel travel = s.travel;
  follow(s.state, travel);
  return without_turns(s.state, travel);
}

// Controls at a time: the simulation's own and every input.
template <class R>
Controls<R> controls_at(const Simulation<R>& s, R time) {
  R u[control_count];
  flatten(s.controls, u);
  for (int k = 0; k < s.inputs; ++k) u[s.input[k].control] += value_at(s.input[k], time);
  Controls<R> controls;
  unflatten(u, controls);
  return controls;
}

// Controls are constant between the edges of inputs. How long they stay as they are, `since` the beginning of
// the next step: to the next edge inside it, or to its end. An edge within kEdgeRoundings of the times is
// on the step boundary.
inline constexpr int kEdgeRoundings = 8;
inline constexpr int kMaxStretches = kMaxInputs * kMaxEdges + 1;  // of constant controls in a step
template <class R>
R next_change(const Simulation<R>& s, R since) {
  const R begin = current_time(s);
  R next = s.dt;
  for (int k = 0; k < s.inputs; ++k) {
    R times[kMaxEdges];
    const int count = edges(s.input[k], times);
    const R size = begin + s.dt + std::fabs(s.input[k].start);
    const R rounding = R(kEdgeRoundings) * std::numeric_limits<R>::epsilon() * size;
    for (int i = 0; i < count; ++i) {
      const R edge = times[i] - begin;
      if (edge > since + rounding && edge < s.dt - rounding && edge < next) next = edge;
    }
  }
  return next;
}

// What acts from now on, to the next change.
template <class R>
Controls<R> current_controls(const Simulation<R>& s) {
  return controls_at(s, current_time(s) + R(0.5) * next_change(s, R(0)));
}

// Begin at a state with constant controls, no inputs, time 0. dt: 0 < dt <= 1 s.
// Status: ok; out_of_range (dt); not_finite (state or controls).
template <class R>
Status start(const Configuration<R>& c, const State<R>& x, const Controls<R>& u, R dt, Integrator integrator,
             Simulation<R>& s) {
  s.state = x;
  s.travel = Travel{};
  s.controls = u;
  s.inputs = 0;
  s.integrator = integrator;
  s.dt = dt;
  s.origin = R(0);
  s.steps = 0;
  s.fault_state = -1;
  s.fault_time = R(0);
  s.status = Status::ok;
  if (c.aircraft == nullptr) return s.status = Status::bad_argument;
  if (!(dt > R(0) && dt <= kLongestStep<R>)) return s.status = Status::out_of_range;
  bool finite = true;
  State<R>::each(x, [&finite](R value) { finite = finite && is_finite(value); });
  Controls<R>::each(u, [&finite](R value) { finite = finite && is_finite(value); });
  if (!finite) s.status = Status::not_finite;
  return s.status;
}

// Status: ok; bad_argument (no room left, or the signal is not valid).
template <class R>
Status add_input(Simulation<R>& s, const InputSignal<R>& signal) {
  if (s.inputs >= kMaxInputs || !is_valid(signal)) return Status::bad_argument;
  s.input[s.inputs++] = signal;
  return Status::ok;
}

// Goes on with steps of another length, 0 < dt <= 1 s. Status: ok; out_of_range, and nothing is changed.
template <class R>
Status change_step(Simulation<R>& s, R dt) {
  if (!(dt > R(0) && dt <= kLongestStep<R>)) return Status::out_of_range;
  s.origin = current_time(s);
  s.steps = 0;
  s.dt = dt;
  return Status::ok;
}

namespace response_detail {

// Right side of the active states at constant controls.
template <class R, class Policy>
struct RightSide {
  const Configuration<R>& c;
  SimulationWorkspace<R, Policy>& work;
  const Controls<R>& controls;
  int& fault_state;

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

  Status operator()(R time, const R* x, R* xdot) const {
    rates(x, xdot, c.setup.rotor_speed * time);
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
  const R azimuth = c.setup.rotor_speed * time;
  for (int k = 0; k < n; ++k) work.scale[k] = state_scale<R>(work.active.index[k]);
  Policy::jacobian([&f, azimuth](const auto* x, auto* rates) { f.rates(x, rates, azimuth); },
                   {n, n, work.x, work.scale, work.rates}, work.differentiation,
                   [&work](int i, int j, R slope) { work.jacobian(i, j) = slope; });
  const R* known = work.rates;
  if (c.setup.options.azimuth == AzimuthMode::averaged)
    return rodas3_step(f, work.jacobian, {time, dt, work.x, n, known}, work.method.rosenbrock);

  // Blades that turn make f depend on time; azimuth carries no partials, so a central difference.
  const R step = std::cbrt(std::numeric_limits<R>::epsilon());
  f.rates(static_cast<const R*>(work.x), work.ahead, azimuth + step);
  f.rates(static_cast<const R*>(work.x), work.behind, azimuth - step);
  for (int k = 0; k < n; ++k)
    work.ahead[k] = c.setup.rotor_speed * (work.ahead[k] - work.behind[k]) / (R(2) * step);
  return rodas3_step(f, work.jacobian, {time, dt, work.x, n, known, work.ahead}, work.method.rosenbrock);
}

template <class R, class Policy>
Status step(const RightSide<R, Policy>& f, Integrator integrator, R time, R dt, const R* known) {
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
  R since = R(0);
  for (int k = 0; k < kMaxStretches && since < s.dt && s.status == Status::ok; ++k) {
    const R until = next_change(s, since);
    const Controls<R> controls = controls_at(s, begin + R(0.5) * (since + until));
    const response_detail::RightSide<R, Policy> f{c, work, controls, s.fault_state};
    const int count =
        response_detail::parts(s.integrator, until - since, fastest_rates(c, s.state, controls));
    s.status = response_detail::hold(f, s.integrator, begin + since, until - since, count, known);
    known = nullptr;
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
  s.travel = travel;
  ++s.steps;
  return s.status;
}

}  // namespace tiltrotor

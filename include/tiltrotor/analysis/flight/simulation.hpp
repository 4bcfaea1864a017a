// A flight on its way: state, controls, test inputs, and the time that has passed. response.hpp moves it on.
//
// Simulation is plain: a snapshot is a copy, and a replay is exact.
#pragma once

#include <cmath>
#include <limits>

#include "tiltrotor/analysis/flight/input_signal.hpp"
#include "tiltrotor/analysis/flight/travel.hpp"
#include "tiltrotor/model/setup/configuration.hpp"

namespace tiltrotor {

// rk3: explicit, three derivatives a part of a step; for frames of 5 ms and less.
// rk4: explicit, four derivatives a part of a step.
// rodas3: Rosenbrock, L-stable, two derivatives and one Jacobian a step; for longer steps and stiff settings.
// exponential: order 2, stable wherever the linear model is, one Jacobian a step and nothing where it is known; for
// the long frames of a rig that has A and B anyway.
enum class Integrator : unsigned char { rk3, rk4, rodas3, exponential };

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
  R azimuth;        // rad, of the right rotor's first blade at time 0, seen from its present speed
  R origin;         // s, when steps of dt began
  unsigned steps;   // done since; time = origin + steps dt
  Status status;    // of the last step; a failed flight stays where it was
  int fault_state;  // place in kStateVariables of the state that failed, or -1
  R fault_time;     // s, end of the step that failed
};

template <class R>
R current_time(const Simulation<R>& s) {
  return s.origin + static_cast<R>(s.steps) * s.dt;
}

// Position of the right rotor's first blade.
template <class R>
R current_azimuth(const Configuration<R>& c, const Simulation<R>& s) {
  return s.azimuth + c.setup.rotor_speed * current_time(s);
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
inline constexpr int kMaxStops = 2;  // of a mast in a step
inline constexpr int kMaxStretches =
    kMaxInputs * kMaxEdges + kMaxStops + 1;  // of constant controls in a step
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
  s.azimuth = R(0);
  s.origin = R(0);
  s.steps = 0;
  s.fault_state = -1;
  s.fault_time = R(0);
  s.status = Status::ok;
  if (c.aircraft == nullptr) return s.status = Status::bad_argument;
  if (!(dt > R(0) && dt <= kLongestStep<R>)) return s.status = Status::out_of_range;
  bool finite = true;
  State<R>::each(x, [&finite](R value) { finite &= is_finite(value); });
  Controls<R>::each(u, [&finite](R value) { finite &= is_finite(value); });
  if (!finite) s.status = Status::not_finite;
  return s.status;
}

// Status: ok; bad_argument (no place left, or the signal is not valid).
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

// Another setting in flight. The state stays, but for the inflow: it keeps its speed, and so changes its ratio to
// the tip's. Status as of reconfigure(); unless ok, nothing is changed.
template <class R>
Status change_configuration(const ConfigurationSetting<R>& setting, Configuration<R>& c, State<R>& x) {
  const R before[] = {c.rotor[right].speed, c.rotor[left].speed};
  const Status status = reconfigure(setting, c);
  if (status != Status::ok) return status;
  for (const Side side : {right, left}) {
    if (c.rotor[side].speed == before[side]) continue;
    const R faster = before[side] / c.rotor[side].speed;
    RotorState<R>& rotor = x.rotor[side];
    rotor.lambda_0 *= faster;
    rotor.lambda_c *= faster;
    rotor.lambda_s *= faster;
  }
  return status;
}
// The same; blades keep their azimuth.
template <class R>
Status change_configuration(const ConfigurationSetting<R>& setting, Configuration<R>& c, Simulation<R>& s) {
  const R before = c.setup.rotor_speed;
  const Status status = change_configuration(setting, c, s.state);
  if (status == Status::ok) s.azimuth += (before - c.setup.rotor_speed) * current_time(s);
  return status;
}

}  // namespace tiltrotor

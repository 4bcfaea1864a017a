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

#include "tiltrotor/analysis/flight/jacobian_steps.hpp"
#include "tiltrotor/analysis/flight/stable_step.hpp"
#include "tiltrotor/systems/system_behind.hpp"

namespace tiltrotor {

namespace flight_step {

template <class R, class Policy>
Status by_method(const RightSide<R, Policy>& f, Integrator integrator, R time, R dt, const R* known) {
  SimulationWorkspace<R, Policy>& work = f.work;
  const int n = work.count();
  switch (integrator) {
    case Integrator::rk3:
      return rk3_step(f, {time, dt, work.x, n, known}, work.method.runge_kutta);
    case Integrator::rk4:
      return rk4_step(f, {time, dt, work.x, n, known}, work.method.runge_kutta);
    case Integrator::rodas3:
      if constexpr (!std::is_same_v<Policy, NoDifferentiation> && !std::is_same_v<Policy, KnownJacobian>) {
        if (f.systems == nullptr) return rodas3(f, time, dt);
      }
      return Status::bad_argument;
    case Integrator::exponential:
      if constexpr (!std::is_same_v<Policy, NoDifferentiation>) {
        if (f.systems == nullptr) return exponential(f, time, dt, known);
      }
      return Status::bad_argument;
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
  const Status status = by_method(steep, integrator, time, dt, known);
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

// Methods with a Jacobian keep to Euler angles: it is that of the state.
constexpr bool is_explicit(Integrator integrator) {
  return integrator == Integrator::rk3 || integrator == Integrator::rk4;
}
template <class R, class Policy>
Status step(const RightSide<R, Policy>& f, Integrator integrator, R time, R dt, const R* known) {
  const bool is_steep = std::fabs(f.work.x[kPitch]) > kSteepPitch<R>;
  return is_steep && is_explicit(integrator) ? steep_step(f, integrator, time, dt, known)
                                             : by_method(f, integrator, time, dt, known);
}

// Equal parts of a step in which the method is stable. The limit ends the loop; no state within its bounds
// reaches it.
inline constexpr int kMaxParts = 4096;
template <class R>
int parts(Integrator integrator, R duration, const FastestRates<R>& fastest) {
  if (!is_explicit(integrator)) return 1;
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
    for (int k = 0; k < f.work.count(); ++k) {
      f.fault_state = f.work.place(k);
      const R bound = static_cast<R>(vehicle_variable(f.fault_state).facts().bound);
      if (!(std::fabs(f.work.x[k]) <= bound)) return Status::out_of_range;
    }
    f.fault_state = -1;
  }
  return Status::ok;
}

// At its stop a mast that a system drives stays as well.
template <class R>
void stop_driven_mast(const Bounds<R>& stops_deg, SystemState<R>& s) {
  const R low = stops_deg.low * kRadPerDeg<R>, high = stops_deg.high * kRadPerDeg<R>;
  if (is_within(s.mast, low, high)) return;
  s.mast = s.mast < low ? low : high;
  s.mast_rate = R(0);
}

// What the systems make of the configuration at the end of a stretch of a step.
template <class R, class Policy>
void put_systems(const RightSide<R, Policy>& f) {
  SystemPart<R>& part = *f.systems;
  const Vehicle<R>& v = part.flight->vehicle;
  SystemState<R> s = f.system_state(f.work.x);
  if (v.on.conversion) stop_driven_mast(f.c.aircraft->limits.mast_deg, s);
  part.flight->state = s;
  R flat[system_state_count];
  flatten(s, flat);
  for (int k = 0; k < f.work.systems.count; ++k)
    f.work.x[f.work.active.count + k] = flat[f.work.systems.index[k]];
  SystemState<R> rates;
  airframe_demand(v, f.c, part.base, *part.c, f.airframe_state(f.work.x), s, v.commands, f.controls,
                  f.work.demand, f.work.flows, rates);
  put_into(f.work.demand, *part.c);
}

// The configuration at the end of a stretch of a step.
template <class R, class Policy>
Status arrive(const MovingConfiguration<R>& moving, R time, bool at_stop, const RightSide<R, Policy>& f,
              int& fault_state) {
  Configuration<R>& c = *moving.configuration;
  f.place_configuration(time, f.work.x);
  // A mast that comes to rest at its stop may lie beyond it by a rounding.
  const Bounds<R>& stops = c.aircraft->limits.mast_deg;
  ConfigurationSetting<R>& setting = f.systems == nullptr ? c.setup : f.systems->base;
  if (at_stop || !is_within(setting.mast_deg, stops.low, stops.high)) {
    stop_mast<R>(setting, stops);
    if (f.systems == nullptr) configure(c);
  }
  if (f.systems != nullptr) put_systems(f);
  const SetupField fault = first_out_of_range(*c.aircraft, c.setup).field;
  if (fault == SetupField::none) return Status::ok;
  if (fault == SetupField::altitude) fault_state = kStateIndex.position.z;
  const int system = f.systems == nullptr ? -1 : system_behind(*c.aircraft, c.setup);
  if (system >= 0) fault_state = state_count + system;
  return Status::out_of_range;
}

// What moves by itself, systems that move the same left out.
template <class R>
ConfigurationSetting<R> prescribed(ConfigurationSetting<R> setting, const SystemPart<R>* systems) {
  if (systems == nullptr) return setting;
  const SystemSwitches& on = systems->flight->vehicle.on;
  if (on.conversion) setting.mast_rate = setting.mast_acceleration = R(0);
  if (on.governor == Governor::pi) setting.rotor_acceleration = R(0);
  return setting;
}

// A step; `moving`: of `c`, or nullptr; `systems` of the same, or nullptr.
template <class R, class Policy>
Status advance(const Configuration<R>& c, MovingConfiguration<R>* moving, SystemPart<R>* systems,
               SimulationWorkspace<R, Policy>& work, Simulation<R>& s, const R* xdot) {
  work.active = active_states(c.setup.options, true);
  work.systems = systems == nullptr ? ActiveSystems{} : active_systems(systems->flight->vehicle.on);
  const int n = work.active.count;
  Travel travel = s.travel;
  follow(s.state, travel);
  flatten(without_turns(s.state, travel), work.whole);
  // Sums begin at zero: what a step adds is not rounded to the size of the sum.
  for (int k = 0; k < n; ++k)
    work.x[k] = sum_of(work.active.index[k]) < 0 ? work.whole[work.active.index[k]] : R(0);
  if (systems != nullptr) {
    R flat[system_state_count];
    flatten(systems->flight->state, flat);
    for (int k = 0; k < work.systems.count; ++k) work.x[n + k] = flat[work.systems.index[k]];
  }
  s.fault_state = -1;

  const R* known = nullptr;
  if (xdot != nullptr) {
    for (int k = 0; k < work.count(); ++k) work.rates[k] = xdot[work.place(k)];
    known = work.rates;
  }
  const R begin = current_time(s);
  R azimuth = s.azimuth;
  R since = R(0);
  for (int k = 0; k < kMaxStretches && since < s.dt && s.status == Status::ok; ++k) {
    R until = next_change(s, since);
    bool stops = false;
    if (moving != nullptr) {
      moving->from = prescribed<R>(c.setup, systems);
      moving->begin = begin + since;
      const R stop = since + time_to_stop(moving->from, c.aircraft->limits.mast_deg, until - since);
      stops = stop < until;
      if (stops) until = stop;
    }
    const Controls<R> controls = controls_at(s, begin + R(0.5) * (since + until));
    const RightSide<R, Policy> f{c, work, controls, s.fault_state, azimuth, moving, nullptr, systems};
    if (until > since) {
      const int count = parts(s.integrator, until - since, fastest_rates(c, s.state, controls));
      s.status = hold(f, s.integrator, begin + since, until - since, count, known);
      known = nullptr;
    }
    if (stops) known = nullptr;  // they are those of a mast on its way
    if (moving != nullptr && s.status == Status::ok) {
      const R azimuth_now = f.azimuth(begin + until);
      s.status = arrive(*moving, begin + until, stops, f, s.fault_state);
      if (c.setup.rotor_speed != moving->from.rotor_speed)
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

}  // namespace flight_step

// One step of dt, from edge to edge of the inputs inside it, in equal parts where the method would be
// unstable (stable_step.hpp). Status: ok; not_finite or out_of_range (the flight has diverged: fault_state
// and fault_time tell which state and when, the state stays that of the last good step); singular (rodas3);
// bad_argument (an unknown integrator). A failed simulation does not move again. Cost of a part: three
// derivatives (rk3); four (rk4); two and a Jacobian (rodas3); a Jacobian (exponential). `xdot`[state_count]: the rates at the present
// state and controls, when they are known (LinearModel); they spare rk3 and rk4 their first derivative.
template <class R, class Policy>
Status advance(const Configuration<R>& c, SimulationWorkspace<R, Policy>& work, Simulation<R>& s,
               const R* xdot = nullptr) {
  if (s.status != Status::ok) return s.status;
  return flight_step::advance(c, static_cast<MovingConfiguration<R>*>(nullptr),
                              static_cast<flight_step::SystemPart<R>*>(nullptr), work, s, xdot);
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
  const Status status =
      flight_step::advance(c, &moving, static_cast<flight_step::SystemPart<R>*>(nullptr), work, s, xdot);
  if (status != Status::ok) {
    static_cast<ConfigurationSetting<R>&>(c.setup) = before;
    configure(c);
  }
  return status;
}

// The same with systems: `c` is put into what they ask for, and they move on with the flight. Events of the step come
// first: begin_step(). Of the integrators rk3 and rk4; the others are a bad_argument. `xdot`[vehicle_state_count]: those
// of vehicle_rates(). Unless ok, configuration and systems are as they were; fault_state counts as vehicle_variable();
// out_of_range with the governor's: an ideal one finds no collective for the power of the engines.
// Cost: that of advance(), and a twentieth of a derivative more an evaluation where masts, rotor speed or air move;
// with an ideal governor some three times as many derivatives.
template <class R, class Policy>
Status advance_vehicle(Configuration<R>& c, SystemFlight<R>& flight, SimulationWorkspace<R, Policy>& work,
                       Simulation<R>& s, const R* xdot = nullptr) {
  if (s.status != Status::ok) return s.status;
  const SystemFlight<R> before = flight;
  const ConfigurationSetting<R> setting = c.setup;
  // Rates found before an event are not those after it; those of an ideal governor bring its collective along.
  const bool happened = begin_step(*c.aircraft, s.state, current_controls(s), flight.vehicle, flight.state);
  if (happened || flight.vehicle.on.governor == Governor::ideal) xdot = nullptr;
  const Surroundings<R> around = c.around;
  const Loads<R> outside = c.outside;
  const R ground[] = {c.rotor[right].ground_wash, c.rotor[left].ground_wash, c.download};
  const State<R> now = current_state(s);
  const TurbulentAir<R> air = turbulent_air(c, now, current_controls(s), flight.vehicle);
  c.around = with_turbulence(c, now, current_controls(s), flight.vehicle, flight.state);
  MovingConfiguration<R> moving{&c, false, R(0), {}, R(0)};
  flight_step::SystemPart<R> part{&flight, &c, c.setup};
  const Status status = flight_step::advance(c, &moving, &part, work, s, xdot);
  c.around = around;
  if (status == Status::ok) {
    if (flight.vehicle.on.turbulence) {
      const GustNoise<R> noise = gust_noise<R>(flight.vehicle.turbulence_seed, flight.steps);
      flight.state.gusts = turbulence_step(flight.state.gusts, air, s.dt, noise, *c.aircraft);
    }
    if (flight.vehicle.on.gear)
      flight.state.gear = moved_gear(c.aircraft->gear, flight.vehicle, flight.state.gear, s.dt);
    ++flight.steps;
  } else {
    flight = before;
    static_cast<ConfigurationSetting<R>&>(c.setup) = setting;
    configure(c);
    c.outside = outside;
    c.rotor[right].ground_wash = ground[0];
    c.rotor[left].ground_wash = ground[1];
    c.download = ground[2];
  }
  return status;
}

}  // namespace tiltrotor

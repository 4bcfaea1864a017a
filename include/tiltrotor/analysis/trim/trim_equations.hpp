// The equations of trim: which unknowns there are, how large a Newton step may be in each, and the scaled
// residuals.
#pragma once

#include "tiltrotor/analysis/linear/differentiation.hpp"
#include "tiltrotor/analysis/trim/steady_flight.hpp"

namespace tiltrotor {

// States that a steady flight sets itself: its motion, rates that vanish with their angle, and what nothing
// depends on. Every other state is an unknown.
constexpr bool is_set_by_flight(VariableKind kind) {
  return kind == VariableKind::speed || kind == VariableKind::body_rate ||
         kind == VariableKind::gimbal_rate || kind == VariableKind::coning_rate ||
         kKindFacts[static_cast<int>(kind)].ignorable;
}
// With the four inceptors.
constexpr int count_trim_unknowns() {
  int count = kControlIndex.pedal + 1;
  for (int i = 0; i < state_count; ++i) count += !is_set_by_flight(kStateVariables[i].kind);
  return count;
}
inline constexpr int kMaxTrimUnknowns = count_trim_unknowns();

// One unknown and one equation. The unknown is a state, a control or, where both places are -1, the part of
// the weight that is carried; the equation says that the rate of a state, scaled, is zero.
template <class R>
struct TrimEquation {
  int state;     // place of the unknown in State, or -1
  int control;   // place of the unknown in Controls, or -1
  R step_limit;  // largest Newton step; 0: none
  R scale;       // of a numerical difference
  int rate;      // the state whose rate shall vanish
  R rate_scale;  // residual = rate * rate_scale
  int mirrored;  // the row that this one equals in symmetric flight; -1: it is zero there
};

// With `relieved` a vertical force takes the rest of the weight off the aircraft; the collective is then
// `collective` where it is no unknown, the part of the weight carried is `carried` where it is none.
template <class R>
struct TrimEquations {
  int count;
  TrimEquation<R> row[kMaxTrimUnknowns];
  bool relieved;
  R carried;
  R collective;  // rad
};

// Places in TrimEquations::row that are the same with all options.
inline constexpr int kRollRow = 0;
inline constexpr int kPitchRow = 1;
inline constexpr int kCollectiveRow = 2;

// Largest Newton steps: of an angle, rad, and of an inflow over tip speed. Largest ones of sticks and pedal are
// the aircraft's (TrimGuessTables::stick_step).
template <class R>
inline constexpr R kAngleStep = R(3) * kRadPerDeg<R>;
template <class R>
inline constexpr R kInflowStep = R(0.02);

// Bounds of the first guess, which is no part of a trim.
template <class R>
struct GuessBounds {
  static constexpr R bank = R(60) * kRadPerDeg<R>;  // largest of a turn, rad
  static constexpr R least_load = R(0.02);          // thrust over weight
  static constexpr R least_flow = R(1e-3);          // through the disk, over tip speed
  static constexpr int inflow_rounds = 40;          // each half of the way to momentum theory
  // Descent along the shaft, over the induced speed of hover, from which on rotors may be windmills. Momentum
  // theory has their wake from 2 on; the attitude of a first guess is rough.
  static constexpr R steep_descent = R(1.5);
};

// The unknowns that are alive under the configuration's options. Forces are scaled by g, moments by 1
// rad/s^2, flapping by Omega^2 (Omega when it is of first order), inflow by Omega, downwash by 1 rad/s.
template <class R>
void trim_equations(const Configuration<R>& c, TrimEquations<R>& equations) {
  const Options& o = c.setup.options;
  const R omega = c.setup.rotor_speed;
  const R gravity = R(1) / kGravity<R>;
  const R stick_step = c.aircraft->guess.stick_step;
  equations.count = 0;
  equations.relieved = false;
  equations.carried = R(1);
  equations.collective = R(0);
  const auto add_state = [&](int state, R limit, int rate, R rate_scale) {
    const int j = equations.count++;
    equations.row[j] = {state, -1, limit, state_scale<R>(state), rate, rate_scale, j};
  };
  const auto add_control = [&](int control, R limit, int rate, R rate_scale) {
    const int j = equations.count++;
    equations.row[j] = {-1, control, limit, control_scale<R>(control), rate, rate_scale, j};
  };
  add_state(kStateIndex.roll, kAngleStep<R>, kStateIndex.velocity.y, gravity);
  add_state(kStateIndex.pitch, kAngleStep<R>, kStateIndex.velocity.x, gravity);
  add_control(kControlIndex.collective, kAngleStep<R>, kStateIndex.velocity.z, gravity);
  add_control(kControlIndex.long_stick, stick_step, kStateIndex.rates.y, R(1));
  add_control(kControlIndex.lat_stick, stick_step, kStateIndex.rates.x, R(1));
  add_control(kControlIndex.pedal, stick_step, kStateIndex.rates.z, R(1));
  const bool second_order = o.flapping == FlapOrder::second;
  const R flap_scale = second_order ? R(1) / (omega * omega) : R(1) / omega;
  int first_of_rotor[3] = {};
  for (int side = 0; side < 2; ++side) {
    const RotorState<int>& at = kStateIndex.rotor[side];
    first_of_rotor[side] = equations.count;
    add_state(at.b1c, kAngleStep<R>, second_order ? at.b1c_rate : at.b1c, flap_scale);
    add_state(at.b1s, kAngleStep<R>, second_order ? at.b1s_rate : at.b1s, flap_scale);
    add_state(at.lambda_0, kInflowStep<R>, at.lambda_0, R(1) / omega);
    if (o.inflow == InflowShape::uniform) continue;
    add_state(at.lambda_c, kInflowStep<R>, at.lambda_c, R(1) / omega);
    add_state(at.lambda_s, kInflowStep<R>, at.lambda_s, R(1) / omega);
  }
  first_of_rotor[2] = equations.count;
  if (o.downwash_lag) add_state(kStateIndex.downwash, R(0), kStateIndex.downwash, R(1));
  if (o.coning_states) {
    for (const ConingState<int>& at : kStateIndex.coning)
      add_state(at.angle, kAngleStep<R>, at.rate, R(1) / (omega * omega));
    equations.row[equations.count - 1].mirrored = equations.count - 2;
  }
  for (int j = 0; j < equations.count; ++j) {
    const int state = equations.row[j].state, control = equations.row[j].control;
    if (state == kStateIndex.roll || control == kControlIndex.lat_stick || control == kControlIndex.pedal)
      equations.row[j].mirrored = -1;
  }
  for (int j = first_of_rotor[left]; j < first_of_rotor[2]; ++j)
    equations.row[j].mirrored = j - first_of_rotor[left] + first_of_rotor[right];
}

// Whether the aircraft stands and answers symmetrically at z, by the numbers. The step of Newton's method is then
// symmetric but for rounding.
template <class R>
bool is_symmetric(const TrimEquations<R>& equations, const R* z, const R* residual) {
  for (int j = 0; j < equations.count; ++j) {
    const int as = equations.row[j].mirrored;
    if (z[j] != (as < 0 ? R(0) : z[as]) || residual[j] != (as < 0 ? R(0) : residual[as])) return false;
  }
  return true;
}
template <class R>
void make_symmetric(const TrimEquations<R>& equations, R* step) {
  for (int j = 0; j < equations.count; ++j) {
    const int as = equations.row[j].mirrored;
    step[j] = as < 0 ? R(0) : step[as];
  }
}

// The aircraft carries a given part of its weight, with the collective that this needs.
template <class R>
void set_carried_weight(TrimEquations<R>& equations, R carried) {
  equations.relieved = true;
  equations.carried = carried;
}

// The collective is given, and the aircraft carries the part of its weight that follows: the unknown in the
// collective's place.
template <class R>
void set_collective(TrimEquations<R>& equations, R collective) {
  equations.relieved = true;
  equations.collective = collective;
  TrimEquation<R>& row = equations.row[kCollectiveRow];
  row.control = -1;
  row.step_limit = R(0);
  row.scale = R(1);
}

// Velocity, rates and gust of the steady flight at the attitude of `x`.
template <class T>
TILTROTOR_NOINLINE void set_steady_motion(const SteadyFlight<Real<T>>& flight, State<T>& x, Controls<T>& u) {
  const Vec3<Real<T>>& gust = flight.gust;
  const Vec3<T> velocity = steady_velocity(flight, x.roll, x.pitch);
  x.velocity = {velocity.x + gust.x, velocity.y + gust.y, velocity.z + gust.z};
  x.rates = steady_rates(flight, x.roll, x.pitch);
  u.gust = {T(gust.x), T(gust.y), T(gust.z)};
}

// A force of `part` of the weight, upwards, added to the rates (m/s^2). Roll and pitch in rad.
template <class T>
TILTROTOR_NOINLINE void relieve_weight(const T& roll, const T& pitch, const T& part, State<T>& rates) {
  const T relief = part * kGravity<Real<T>>;
  const T level = relief * cos(pitch);
  rates.velocity.x += relief * sin(pitch);
  rates.velocity.y -= level * sin(roll);
  rates.velocity.z -= level * cos(roll);
}

// State and controls of the unknowns z; those that are none are 0, but for a given collective.
template <class T, class Input>
TILTROTOR_NOINLINE void place_unknowns(const TrimEquations<Real<T>>& equations, const Input& z,
                                       ModelWorkspace<T>& work, T& carried) {
  const ModelPlaces<T> at(work);
  for (T* x : at.x) *x = Real<T>(0);
  for (T* u : at.u) *u = Real<T>(0);
  *at.u[kControlIndex.collective] = equations.collective;
  carried = equations.carried;
  for (int j = 0; j < equations.count; ++j) {
    const TrimEquation<Real<T>>& row = equations.row[j];
    z.put(j, row.state >= 0 ? *at.x[row.state] : row.control >= 0 ? *at.u[row.control] : carried);
  }
}

// residual(j, number): the rate of equation j, scaled.
template <class T, class Output>
TILTROTOR_NOINLINE void put_residuals(const TrimEquations<Real<T>>& equations, const State<T>& rates,
                                      Output&& residual) {
  const T* rate[state_count];
  list_places(rates, rate);
  for (int j = 0; j < equations.count; ++j) {
    const TrimEquation<Real<T>>& row = equations.row[j];
    residual(j, *rate[row.rate] * row.rate_scale);
  }
}

// Residuals of the unknowns z, on plain numbers, or on duals of which z[j] is variable number j: residual(j, number).
template <class T, class Input, class Output>
void trim_residuals(const Configuration<Real<T>>& c, const SteadyFlight<Real<T>>& flight,
                    const TrimEquations<Real<T>>& equations, ModelWorkspace<T>& work, const Input& z,
                    Output&& residual) {
  using R = Real<T>;
  T carried;
  place_unknowns(equations, z, work, carried);
  set_steady_motion(flight, work.state, work.controls);
  const OwnStates own(equations.count, [&equations](int j) { return equations.row[j].state; });
  model_rates(c, R(0), work, own.get());
  if (equations.relieved)
    out_of_line([&] { relieve_weight<T>(z[kRollRow], z[kPitchRow], R(1) - carried, work.rates); });
  put_residuals(equations, work.rates, residual);
}

// Pitch of the blade at the reference radius above the inflow angle, rad; `cm`: cosine of the mast angle.
template <class R>
R blade_angle(const TrimGuessTables<R>& guess, R cm) {
  return (guess.blade_angle_deg + guess.blade_angle_hover_deg * cm * cm) * kRadPerDeg<R>;
}

// First guess for any mast angle and speed, extended to turns and climbs: bank of a coordinated turn, its load
// factor on the rotors, and the part of the climb that thrust along the path must carry. `carried`: part of the
// weight.
template <class R>
void trim_first_guess(const Configuration<R>& c, const SteadyFlight<R>& flight,
                      const TrimEquations<R>& equations, R* z, R carried = R(1)) {
  const GuessBounds<R> bounds{};
  const R sm = sin(c.mast);
  const R cm = cos(c.mast);
  const R weight = carried * c.mass.mass * kGravity<R>;
  R bank = atan2(flight.speed * cos(flight.climb) * flight.turn_rate, kGravity<R>);
  bank = bank > bounds.bank ? bounds.bank : bank < -bounds.bank ? -bounds.bank : bank;

  const TrimGuessTables<R>& guess = c.aircraft->guess;
  const R wing_share = flight.speed < guess.wing_speed ? flight.speed / guess.wing_speed : R(1);
  R load = (guess.hover_load - guess.wing_load * sm * sm * wing_share) / cos(bank) + sm * sin(flight.climb);
  load = load < bounds.least_load ? bounds.least_load : load;
  const R radius = c.aircraft->rotor.radius;
  const R ct =
      R(0.5) * weight * load / (c.air.density * kPi<R> * radius * radius * c.tip_speed * c.tip_speed);

  // Speed along the shaft: level flight sees it through the mast angle, climbing helicopters through the
  // climb.
  const R mu = flight.speed * std::fabs(cos(c.mast + flight.climb * (R(1) - sm * sm))) / c.tip_speed;
  const R through = flight.speed * sin(c.mast + flight.climb * (R(1) - sm * sm)) / c.tip_speed;
  // Momentum theory: lambda_0 = CT/(2 |mu, through + lambda_0|).
  R lambda_0 = guess.hover_inflow;
  for (int k = 0; k < bounds.inflow_rounds; ++k) {
    const R flow = std::sqrt(mu * mu + (through + lambda_0) * (through + lambda_0));
    const R aim = R(0.5) * ct / (flow > bounds.least_flow ? flow : bounds.least_flow);
    lambda_0 = R(0.5) * lambda_0 + R(0.5) * aim;
  }

  const R reference = c.aircraft->rotor.twist_reference;
  const bool wingborne = c.setup.mast_deg >= c.aircraft->wing.borne_mast_deg;
  const R level_pitch = (wingborne ? guess.pitch_airplane_deg : guess.pitch_helicopter_deg) * kRadPerDeg<R>;
  const R collective = atan2(through + lambda_0, reference) + blade_angle(guess, cm);
  for (int j = 0; j < equations.count; ++j) {
    const TrimEquation<R>& row = equations.row[j];
    z[j] = R(0);
    if (row.state == kStateIndex.roll) z[j] = bank;
    if (row.state == kStateIndex.pitch) z[j] = level_pitch + flight.climb * sm * sm;
    if (row.control == kControlIndex.collective) z[j] = collective;
    if (row.state == kStateIndex.rotor[right].lambda_0 || row.state == kStateIndex.rotor[left].lambda_0)
      z[j] = lambda_0;
    if (row.state == kStateIndex.coning[right].angle || row.state == kStateIndex.coning[left].angle)
      z[j] = c.coning;
  }
  find_attitude(flight, z[kRollRow], z[kPitchRow]);
}

// Speed up the shaft in the first guess's attitude, m/s.
template <class R>
R shaft_speed(const Configuration<R>& c, const SteadyFlight<R>& flight) {
  const R sm = sin(c.mast);
  return flight.speed * sin(c.mast + flight.climb * (R(1) - sm * sm));
}

template <class R>
R hover_induced_speed(const Configuration<R>& c) {
  const R disk = kPi<R> * square(c.aircraft->rotor.radius);
  return std::sqrt(c.mass.mass * kGravity<R> / (R(4) * c.air.density * disk));
}

// Descent along the shaft so fast that the rotors may be windmills.
template <class R>
bool is_steep_descent(const Configuration<R>& c, const SteadyFlight<R>& flight) {
  return shaft_speed(c, flight) < -GuessBounds<R>::steep_descent * hover_induced_speed(c);
}

// First guess of rotors that windmill: the least root of momentum theory, v^2 + V v + v_h^2 = 0, V the speed up
// the shaft, v and v_h induced speeds, m/s.
template <class R>
void trim_windmill_guess(const Configuration<R>& c, const SteadyFlight<R>& flight,
                         const TrimEquations<R>& equations, R* z) {
  trim_first_guess(c, flight, equations, z);
  const R half = R(-0.5) * shaft_speed(c, flight);
  const R rest = half * half - square(hover_induced_speed(c));
  const R induced = half - (rest > R(0) ? std::sqrt(rest) : R(0));
  const R angle = atan2((induced - R(2) * half) / c.tip_speed, c.aircraft->rotor.twist_reference);
  z[kCollectiveRow] = angle + blade_angle(c.aircraft->guess, cos(c.mast));
  for (int j = 0; j < equations.count; ++j) {
    const int state = equations.row[j].state;
    if (state == kStateIndex.rotor[right].lambda_0 || state == kStateIndex.rotor[left].lambda_0)
      z[j] = induced / c.tip_speed;
  }
}

}  // namespace tiltrotor

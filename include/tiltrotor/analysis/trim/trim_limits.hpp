// Limits of a trimmed flight: a solution of the equations is no flight when the wing has stalled, a control
// is beyond its stop, the engines lack the power or the rotors fly in their own wake.
#pragma once

#include "tiltrotor/analysis/trim/momentum_range.hpp"
#include "tiltrotor/model/control_mixing.hpp"
#include "tiltrotor/model/derivative.hpp"
#include "tiltrotor/model/rigid_body.hpp"
#include "tiltrotor/model/setup/atmosphere.hpp"

namespace tiltrotor {

enum class [[nodiscard]] TrimStatus : unsigned char{
    ok,
    wing_stall,     // trimmed, but the wing is past its stall
    control_limit,  // trimmed, but a control is beyond its stop
    flap_limit,     // trimmed, but a gimbal is beyond its stop
    vortex_ring,    // trimmed, but a rotor descends in its own wake (momentum_range.hpp)
    power_limit,    // trimmed, but the rotors need more than take-off power, or drive the engines
    torque_limit,   // trimmed, but a mast carries more than its largest steady torque
    rotor_stall,    // no trim: the rotors stall before the weight is carried
    not_converged,  // no trim found
    singular,       // the Newton matrix was singular at the last step
    not_finite,     // a NaN or infinite input, or the model gave one at the first guess
    out_of_range,   // a bad input
    count};

enum class TrimLimit : unsigned char {
  none,
  descent_right,
  descent_left,
  wing_angle,
  long_stick,
  lat_stick,
  pedal,
  elevator,
  aileron,
  rudder,
  gimbal_right,
  gimbal_left,
  power,
  windmill_power,
  torque_right,
  torque_left,
  count
};

struct LimitName {
  const char* word;  // as printed in the `limits` column
  const char* name;
  const char* unit;
  double factor;            // units in one of LimitExcess
  const char* rating = "";  // of the bound
};

namespace trim_limits_detail {
inline constexpr const char* kStatusWords[] = {
    "ok",           "wing_stall",  "control_limit", "flap_limit", "vortex_ring", "power_limit",
    "torque_limit", "rotor_stall", "not_converged", "singular",   "not_finite",  "out_of_range"};
static_assert(sizeof(kStatusWords) / sizeof(kStatusWords[0]) == static_cast<unsigned>(TrimStatus::count),
              "one word per status");
inline constexpr LimitName kLimitNames[] = {
    {"none", "none", "", 1},
    {"descent_right", "right rotor descent", "v_h", 1, "vortex ring from "},
    {"descent_left", "left rotor descent", "v_h", 1, "vortex ring from "},
    {"wing_angle", "wing angle of attack", "deg", kDegPerRad<double>},
    {"long_stick", "longitudinal stick", "in", 1},
    {"lat_stick", "lateral stick", "in", 1},
    {"pedal", "pedal", "in", 1},
    {"elevator", "elevator", "deg", kDegPerRad<double>},
    {"aileron", "aileron", "deg", kDegPerRad<double>},
    {"rudder", "rudder", "deg", kDegPerRad<double>},
    {"gimbal_right", "right gimbal tilt", "deg", kDegPerRad<double>},
    {"gimbal_left", "left gimbal tilt", "deg", kDegPerRad<double>},
    {"power", "power", "kW", 1e-3, "take-off rating "},
    {"windmill_power", "power", "kW", 1e-3, "what the drive absorbs, "},
    {"torque_right", "right mast torque", "kN m", 1e-3, "steady rating "},
    {"torque_left", "left mast torque", "kN m", 1e-3, "steady rating "}};
static_assert(sizeof(kLimitNames) / sizeof(kLimitNames[0]) == static_cast<unsigned>(TrimLimit::count),
              "one name per limit");
}  // namespace trim_limits_detail

// One word, as printed in the `status` column.
constexpr const char* trim_status_word(TrimStatus status) {
  return static_cast<unsigned>(status) < static_cast<unsigned>(TrimStatus::count)
             ? trim_limits_detail::kStatusWords[static_cast<unsigned>(status)]
             : "unknown";
}
constexpr const LimitName& limit_name(TrimLimit limit) {
  return trim_limits_detail::kLimitNames[static_cast<unsigned>(limit)];
}
// Whether state and controls solve the equations of motion, inside the limits or not.
constexpr bool is_trimmed(TrimStatus status) {
  switch (status) {
    case TrimStatus::ok:
    case TrimStatus::wing_stall:
    case TrimStatus::control_limit:
    case TrimStatus::flap_limit:
    case TrimStatus::vortex_ring:
    case TrimStatus::power_limit:
    case TrimStatus::torque_limit:
      return true;
    case TrimStatus::rotor_stall:
    case TrimStatus::not_converged:
    case TrimStatus::singular:
    case TrimStatus::not_finite:
    case TrimStatus::out_of_range:
    case TrimStatus::count:
      break;
  }
  return false;
}

// The stall of the free wing is a limit where the aircraft rests on the wing: not in helicopter mode, where
// rotors carry it through a descent with the wing stalled, and not where a unit of lift coefficient carries
// less than this part of the weight.
template <class R>
inline constexpr R kWingLoadShare = R(0.02);

// Whether the aircraft rests on its wing at an airspeed, m/s.
template <class R>
bool is_wingborne(const Configuration<R>& c, R speed) {
  const R pressure_lift = R(0.5) * c.air.density * speed * speed * c.aircraft->wing.area;
  return c.setup.mast_deg >= c.aircraft->wing.borne_mast_deg &&
         pressure_lift > kWingLoadShare<R> * c.mass.mass * kGravity<R>;
}

// Engines that run: a number, or as many as the aircraft has.
inline constexpr int kAllEngines = -1;

// Shaft power that `engines` give the rotors at an altitude, W, from a rating of one engine at sea level:
// less the losses of the transmission, and as choice engine_lapse says by pressure over the square root of
// temperature.
template <class R>
R shaft_power(const Configuration<R>& c, R engine_rating, int engines = kAllEngines) {
  const Air<R> here = surrounding_air(c.setup.altitude, c.around.warmer, c.around.pressure_above);
  const Air<R> sea_level = standard_air(R(0));
  const R lapse = here.density / sea_level.density * (here.speed_of_sound / sea_level.speed_of_sound);
  const ControlTables<R>& t = c.aircraft->controls;
  return static_cast<R>(engines == kAllEngines ? t.engines : engines) * engine_rating *
         t.transmission_efficiency * (R(1) + t.engine_lapse * (lapse - R(1)));
}

template <class R>
struct LimitExcess {
  TrimLimit limit;
  R value, bound;  // rad, in, W, N m; descent over v_h
};

// What is exceeded, the decisive first: the model's own range, then wing, controls, surfaces, gimbals, power,
// torque. `status` belongs to the first.
template <class R>
struct LimitCheck {
  TrimStatus status = TrimStatus::ok;
  int count = 0;
  LimitExcess<R> exceeded[static_cast<unsigned>(TrimLimit::count)] = {};

  void add(TrimStatus reason, TrimLimit limit, R value, R bound) {
    if (count == 0) status = reason;
    exceeded[count++] = {limit, value, bound};
  }
};

// Vortex ring or the wrong root of momentum theory at one rotor. `velocity`: relative to the air, m/s.
template <class R>
void check_descent(const Configuration<R>& c, const State<R>& x, const Vec3<R>& velocity,
                   const BladeControls<R>& blades, R thrust, int side, LimitCheck<R>& check) {
  RotorInput<R> in;
  rotor_input(c, x, velocity, blades, side, in);
  const R in_plane = std::sqrt(square(in.velocity_a.x) + square(in.velocity_a.y));
  const AxialFlow<R> flow = axial_flow(c.air.density, c.aircraft->rotor.radius, thrust, in.velocity_a.z,
                                       in_plane, in.state.lambda_0 * c.tip_speed);
  if (momentum_range(flow, c.setup.options.descent_inflow) == MomentumRange::holds) return;
  const TrimLimit limit = side == right ? TrimLimit::descent_right : TrimLimit::descent_left;
  const R least = R(1e-3);  // m/s
  const R hover = flow.hover > least ? flow.hover : least;
  check.add(TrimStatus::vortex_ring, limit, -flow.axial / hover, VortexRing<R>::kOnset);
}

// The lower collective limit of the power lever (table 8a-IV) is no limit: the rotor governor adds to what the
// lever asks for. Cost: a few comparisons.
template <class R>
LimitCheck<R> check_limits(const Configuration<R>& c, R speed, R wing_angle, const State<R>& x,
                           const Controls<R>& u, const BladeControls<R>& blades,
                           const RotorResponse<R> (&rotor)[2], int engines = kAllEngines) {
  const Aircraft<R>& aircraft = *c.aircraft;
  const ControlTables<R>& t = aircraft.controls;
  LimitCheck<R> check;
  const Vec3<R> velocity = airframe_velocity(x.velocity - u.gust, c.mass.nacelles);
  for (int side = 0; side < 2; ++side)
    check_descent(c, x, velocity, blades, rotor[side].loads.force_a.z, side, check);

  const R stall = aircraft.wing.stall_deg * kRadPerDeg<R>;
  if (is_wingborne(c, speed) && wing_angle > stall)
    check.add(TrimStatus::wing_stall, TrimLimit::wing_angle, wing_angle, stall);

  const auto travel = [&check](TrimLimit limit, R value, R bound) {
    if (std::fabs(value) > bound)
      check.add(TrimStatus::control_limit, limit, value, value < R(0) ? -bound : bound);
  };
  travel(TrimLimit::long_stick, u.long_stick, t.long_travel);
  travel(TrimLimit::lat_stick, u.lat_stick, t.lat_travel);
  travel(TrimLimit::pedal, u.pedal, t.pedal_travel);
  travel(TrimLimit::elevator, blades.elevator, t.elevator_limit);
  travel(TrimLimit::aileron, blades.aileron, t.aileron_limit);
  travel(TrimLimit::rudder, blades.rudder, t.rudder_limit);

  for (int side = 0; side < 2; ++side) {
    const R tilt = std::sqrt(square(x.rotor[side].b1c) + square(x.rotor[side].b1s));
    if (tilt > t.flap_limit)
      check.add(TrimStatus::flap_limit, side == right ? TrimLimit::gimbal_right : TrimLimit::gimbal_left,
                tilt, t.flap_limit);
  }
  const R spin_up = c.rotor[right].spin_up + c.rotor[left].spin_up;
  const R power = (rotor[right].loads.torque + rotor[left].loads.torque + spin_up) * c.setup.rotor_speed;
  const R available = shaft_power(c, t.engine_power, engines);
  if (power > available) check.add(TrimStatus::power_limit, TrimLimit::power, power, available);
  // Rotors that drive the shafts speed up: nothing takes more than the losses of the transmission, whatever engines run.
  const R absorbed = static_cast<R>(t.engines) * t.engine_power * (R(1) - t.transmission_efficiency);
  if (power < -absorbed) check.add(TrimStatus::power_limit, TrimLimit::windmill_power, power, -absorbed);
  for (int side = 0; side < 2; ++side) {
    const R torque = rotor[side].loads.torque + c.rotor[side].spin_up;
    if (std::fabs(torque) > t.mast_torque)
      check.add(TrimStatus::torque_limit, side == right ? TrimLimit::torque_right : TrimLimit::torque_left,
                torque, torque < R(0) ? -t.mast_torque : t.mast_torque);
  }
  return check;
}

}  // namespace tiltrotor

// Limits of a trimmed flight: a solution of the equations is no flight when the wing has stalled or a control
// is beyond its stop.
#pragma once

#include "tiltrotor/model/control_mixing.hpp"
#include "tiltrotor/model/rigid_body.hpp"

namespace tiltrotor {

enum class [[nodiscard]] TrimStatus : unsigned char{
    ok,
    wing_stall,     // trimmed, but the wing is past its stall
    control_limit,  // trimmed, but a control is beyond its stop
    flap_limit,     // trimmed, but a gimbal is beyond its stop
    rotor_stall,    // no trim: the rotors stall before the weight is carried
    not_converged,  // no trim found
    singular,       // the Newton matrix was singular at the last step
    not_finite,     // the model gave NaN or infinity at the first guess
    out_of_range,   // a bad input
    count};

enum class TrimLimit : unsigned char {
  none,
  wing_angle,
  long_stick,
  lat_stick,
  pedal,
  elevator,
  aileron,
  rudder,
  gimbal_right,
  gimbal_left,
  count
};

namespace trim_detail {
inline constexpr const char* kStatusWords[] = {"ok",         "wing_stall",  "control_limit",
                                               "flap_limit", "rotor_stall", "not_converged",
                                               "singular",   "not_finite",  "out_of_range"};
static_assert(sizeof(kStatusWords) / sizeof(kStatusWords[0]) == static_cast<unsigned>(TrimStatus::count),
              "one word per status");
struct LimitName {
  const char* name;
  const char* unit;
};
inline constexpr LimitName kLimitNames[] = {{"none", ""},
                                            {"wing angle of attack", "deg"},
                                            {"longitudinal stick", "in"},
                                            {"lateral stick", "in"},
                                            {"pedal", "in"},
                                            {"elevator", "deg"},
                                            {"aileron", "deg"},
                                            {"rudder", "deg"},
                                            {"right gimbal tilt", "deg"},
                                            {"left gimbal tilt", "deg"}};
static_assert(sizeof(kLimitNames) / sizeof(kLimitNames[0]) == static_cast<unsigned>(TrimLimit::count),
              "one name per limit");
}  // namespace trim_detail

// One word, as printed in the `status` column.
constexpr const char* trim_status_word(TrimStatus status) {
  return static_cast<unsigned>(status) < static_cast<unsigned>(TrimStatus::count)
             ? trim_detail::kStatusWords[static_cast<unsigned>(status)]
             : "unknown";
}
// Whether state and controls solve the equations of motion, inside the limits or not.
constexpr bool is_trimmed(TrimStatus status) {
  return status == TrimStatus::ok || status == TrimStatus::wing_stall ||
         status == TrimStatus::control_limit || status == TrimStatus::flap_limit;
}

// The angle of attack beyond which the free wing stalls. It is a limit where the aircraft
// rests on the wing: not in helicopter mode, where rotors carry it through a descent with the wing stalled,
// and not where a unit of lift coefficient carries less than a fiftieth of the weight (10 m/s at sea level).
template <class R>
inline constexpr R kWingStall = R(16) * kRadian<R>;
template <class R>
inline constexpr R kWingborneMast = R(15);  // deg
template <class R>
inline constexpr R kWingLoadShare = R(0.02);

template <class R>
struct LimitCheck {
  TrimStatus status;  // ok, wing_stall, control_limit or flap_limit
  TrimLimit limit;
  R value, bound;  // rad, in
};

// The first limit exceeded, in the order: wing, controls, surfaces, gimbals. The lower limit of the power
// lever (Gearing::collective_floor) is none of them: the rotor governor adds to what the lever asks for.
template <class R>
LimitCheck<R> check_limits(const Configuration<R>& c, R speed, R wing_angle, const State<R>& x,
                           const Controls<R>& u, const BladeControls<R>& blades) {
  const Aircraft<R>& aircraft = *c.aircraft;
  const ControlTables<R>& t = aircraft.controls;
  const R pressure_lift = R(0.5) * c.air.density * speed * speed * aircraft.wing.area;
  const bool wingborne =
      c.setup.mast_deg >= kWingborneMast<R> && pressure_lift > kWingLoadShare<R> * c.mass.mass * kGravity<R>;
  if (wingborne && wing_angle > kWingStall<R>) {
    return {TrimStatus::wing_stall, TrimLimit::wing_angle, wing_angle, kWingStall<R>};
  }
  const auto outside = [](R value, R bound) { return std::fabs(value) > bound; };
  const auto exceeded = [](TrimStatus status, TrimLimit limit, R value, R bound) {
    return LimitCheck<R>{status, limit, value, value < R(0) ? -bound : bound};
  };
  const TrimStatus control = TrimStatus::control_limit;
  if (outside(u.long_stick, t.long_travel))
    return exceeded(control, TrimLimit::long_stick, u.long_stick, t.long_travel);
  if (outside(u.lat_stick, t.lat_travel))
    return exceeded(control, TrimLimit::lat_stick, u.lat_stick, t.lat_travel);
  if (outside(u.pedal, t.pedal_travel)) return exceeded(control, TrimLimit::pedal, u.pedal, t.pedal_travel);
  if (outside(blades.elevator, t.elevator_limit))
    return exceeded(control, TrimLimit::elevator, blades.elevator, t.elevator_limit);
  if (outside(blades.aileron, t.aileron_limit))
    return exceeded(control, TrimLimit::aileron, blades.aileron, t.aileron_limit);
  if (outside(blades.rudder, t.rudder_limit))
    return exceeded(control, TrimLimit::rudder, blades.rudder, t.rudder_limit);
  for (int side = 0; side < 2; ++side) {
    const R tilt = std::sqrt(square(x.rotor[side].b1c) + square(x.rotor[side].b1s));
    if (tilt > t.flap_limit)
      return {TrimStatus::flap_limit, side == right ? TrimLimit::gimbal_right : TrimLimit::gimbal_left, tilt,
              t.flap_limit};
  }
  return {TrimStatus::ok, TrimLimit::none, R(0), R(0)};
}

}  // namespace tiltrotor

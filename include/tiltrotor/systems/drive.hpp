// Engines, transmission and rotor governor, all referred to the masts: one rotor speed for both rotors, or two where the
// shaft that connects them may twist.
//
// The structure of governor and engines is NASA CR-166536's (subsystems 17 to 19), whose values are not public; the
// numbers are substitutes. An engine is never driven by the rotors: a clutch stands between (TM X-62407), so its power
// is never negative.
#pragma once

#include "tiltrotor/model/setup/configuration.hpp"
#include "tiltrotor/systems/limited.hpp"

namespace tiltrotor {

// Beyond contingency power; 1 is take-off power.
template <class R>
inline constexpr R kMostThrottle = R(1.2);

// Take-off power in this air over that at sea level, as choice engine_lapse says.
template <class C>
C power_lapse(const ControlTables<Real<C>>& t, const Air<C>& air) {
  using R = Real<C>;
  const Air<R> sea_level = standard_air(R(0));
  const C lapse =
      air.density * (R(1) / sea_level.density) * air.speed_of_sound * (R(1) / sea_level.speed_of_sound);
  return R(1) + t.engine_lapse * (lapse - R(1));
}

// Power of one engine at its shaft with a throttle, W: of its take-off power, at most its contingency power. `lapse`: of
// power_lapse().
template <class T, class C>
T lapsed_power(const Aircraft<Real<T>>& aircraft, const C& lapse, const T& throttle) {
  using R = Real<T>;
  const ControlTables<R>& t = aircraft.controls;
  const R width = aircraft.systems.smooth.power / t.engine_power;
  const R most = aircraft.systems.drive.contingency / t.engine_power;
  return lapse * (t.engine_power * limited(throttle, R(0), most, width));
}
template <class T, class C>
T demanded_power(const Aircraft<Real<T>>& aircraft, const Air<C>& air, const T& throttle) {
  return lapsed_power(aircraft, power_lapse(aircraft.controls, air), throttle);
}

// First-order lag, at most power_rate, W/s.
template <class T>
T power_rate(const SystemTables<Real<T>>& t, const T& demanded, const T& power) {
  const DriveTables<Real<T>>& drive = t.drive;
  return limited(T((demanded - power) / drive.power_lag), -drive.power_rate, drive.power_rate,
                 t.smooth.power_rate);
}

// kg/s, by the specific consumption at take-off power.
template <class T>
T fuel_flow(const SystemTables<Real<T>>& t, const T& power) {
  return t.drive.fuel_per_energy * power;
}

// Of one rotor about its mast, kg m^2: that of slender blades about their flapping axis.
template <class R>
R rotor_inertia(const Aircraft<R>& aircraft) {
  return static_cast<R>(aircraft.rotor.blades) * aircraft.rotor.flap_inertia;
}

// Of both rotors and the power turbines of the engines that run, kg m^2.
template <class R>
R drive_inertia(const Aircraft<R>& aircraft, int engines_running) {
  return R(2) * static_cast<R>(aircraft.rotor.blades) * aircraft.rotor.flap_inertia +
         static_cast<R>(engines_running) * aircraft.systems.drive.turbine_inertia;
}

// J Omega' = eta P / Omega - Q_R - Q_L. `power`: of the engines at their shafts, W; `torque`: of the rotors, N m.
template <class T>
T rotor_acceleration(const Aircraft<Real<T>>& aircraft, int engines_running, const T& power, const T& torque,
                     const T& rotor_speed) {
  using R = Real<T>;
  const T driving = aircraft.controls.transmission_efficiency * power / rotor_speed;
  return (driving - torque) * (R(1) / drive_inertia(aircraft, engines_running));
}

// Of a rotor and the power turbine on its side, where the engine runs, kg m^2.
template <class R>
R half_inertia(const Aircraft<R>& aircraft, bool failed) {
  return failed ? rotor_inertia(aircraft) : rotor_inertia(aircraft) + aircraft.systems.drive.turbine_inertia;
}

// Where the interconnect twists, each half for itself: J_s Omega_s' = eta P_s / Omega_s - Q_s -+ k tau. Arrays: right and
// left; `power`: of the engines, W; `torque`: of the rotors, N m; `twist`: right rotor ahead of the left one, rad.
template <class T>
void half_accelerations(const Aircraft<Real<T>>& aircraft, const bool (&failed)[2], const T (&power)[2],
                        const T (&torque)[2], const T (&rotor_speed)[2], const T& twist,
                        T (&acceleration)[2]) {
  using R = Real<T>;
  for (const Side side : {right, left}) {
    const T driving = aircraft.controls.transmission_efficiency * power[side] / rotor_speed[side];
    const T through_shaft = (side_sign<R>(side) * aircraft.systems.drive.interconnect_stiffness) * twist;
    acceleration[side] =
        (driving - torque[side] - through_shaft) * (R(1) / half_inertia(aircraft, failed[side]));
  }
}

// The twist at which neither half gains on the other, rad.
template <class R>
R balanced_twist(const Aircraft<R>& aircraft, const bool (&failed)[2], const R (&power)[2],
                 const R (&torque)[2], R rotor_speed) {
  R alone[2] = {};
  half_accelerations(aircraft, failed, power, torque, {rotor_speed, rotor_speed}, R(0), alone);
  const R stiffness =
      aircraft.systems.drive.interconnect_stiffness *
      (R(1) / half_inertia(aircraft, failed[right]) + R(1) / half_inertia(aircraft, failed[left]));
  return (alone[right] - alone[left]) / stiffness;
}

// Rate of the collective that the governor adds, rad/s: proportional and integral action on the error of the rotor
// speed, e = Omega/Omega_ref - 1, written for its electric actuator, which integrates: theta' = clip(kp e' + ki e).
// At its stops it returns from what it is beyond.
template <class T>
T governor_rate(const SystemTables<Real<T>>& t, const T& mast, const T& reference, const T& rotor_speed,
                const T& acceleration, const T& collective) {
  using R = Real<T>;
  const GovernorTables<R>& g = t.governor;
  const T mast_deg = mast * kDegPerRad<R>;
  const T proportional = lookup(g.proportional, Interpolation::c1, mast_deg);
  const T integral = lookup(g.integral, Interpolation::c1, mast_deg);
  const T wanted = (proportional * acceleration + integral * (rotor_speed - reference)) / reference;
  const R e = t.smooth.actuator_angle;
  const auto past_stop = [&](const auto& angle) {
    return smooth_positive(angle - g.authority, e) - smooth_positive(-g.authority - angle, e);
  };
  const T beyond = by_slope(past_stop, collective);
  return limited(wanted, -g.rate, g.rate, t.smooth.actuator_rate) - g.stop * beyond;
}

// Gains that give the rotor speed the natural frequency and damping of the tables: of both rotors, `q_theta` = dQ/d
// collective (N m/rad), positive, `q_omega` = d(Q - eta P/Omega)/d Omega (N m s/rad); `inertia` kg m^2.
template <class R>
struct GovernorGains {
  R proportional, integral;  // rad, rad/s
};
template <class R>
GovernorGains<R> governor_gains(const GovernorTables<R>& t, R inertia, R reference, R q_theta, R q_omega) {
  return {(R(2) * t.damping * t.frequency * inertia - q_omega) * reference / q_theta,
          square(t.frequency) * inertia * reference / q_theta};
}

}  // namespace tiltrotor

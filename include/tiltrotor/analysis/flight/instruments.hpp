// What the instruments of the aircraft read, from one evaluation of the model; differentiated with it on dual
// numbers.
//
// A reading that has no derivative gets zero: airspeed and its angles at rest, the tilt of a gimbal that is not
// tilted.
#pragma once

#include "tiltrotor/analysis/trim/steady_flight.hpp"
#include "tiltrotor/model/derivative.hpp"

namespace tiltrotor {

template <class T>
struct Instruments {
  T airspeed;                   // relative to the air, m/s
  T angle_of_attack, sideslip;  // the same; of the body; 0 at rest, rad
  Vec3<T> specific_force;       // at the CG, body axes, m/s^2
  T load_factor;                // of load_factor()
  T climb_rate;                 // relative to the undisturbed air, m/s
  T thrust[2];                  // resultant force of a rotor on its hub, N
  T torque[2];                  // N m
  T power[2];                   // shaft power, W
  T collective[2];              // blade pitch at 0.75 radius, rad
  T long_cyclic[2];             // rad
  T gimbal_tilt[2];             // rad
  T elevator, aileron, rudder;  // rad

  static constexpr int kCount = 23;
  template <class Self, class Visit>
  static constexpr void each(Self& s, Visit&& visit) {
    visit(s.airspeed);
    visit(s.angle_of_attack);
    visit(s.sideslip);
    Vec3<T>::each(s.specific_force, visit);
    visit(s.load_factor);
    visit(s.climb_rate);
    for (auto* const pair : {&s.thrust, &s.torque, &s.power, &s.collective, &s.long_cyclic, &s.gimbal_tilt})
      for (auto& x : *pair) visit(x);
    visit(s.elevator);
    visit(s.aileron);
    visit(s.rudder);
  }
};
static_assert(lists_its_members<Instruments>(), "each member of Instruments is listed and counted");

// Of a velocity relative to the air, body axes.
template <class T>
struct Airspeed {
  T speed, angle_of_attack, sideslip;  // m/s, rad; angles are 0 at rest
};
template <class T>
Airspeed<T> airspeed(const Vec3<T>& v) {
  using R = Real<T>;
  const T speed = length(v);
  if (value(speed) < kLeastSpeed<R>) return {T(value(speed)), T(R(0)), T(R(0))};
  return {speed, atan2(v.z, v.x), atan2(v.y, length(Vec3<T>{v.x, T(R(0)), v.z}))};
}

// `found`, `rates`: what derivative() found at `x`.
template <class T, class C>
void read_instruments(const Configuration<C>& c, const State<T>& x, const DerivativeSteps<T>& found,
                      const State<T>& rates, Instruments<T>& out) {
  using R = Real<T>;
  const Airspeed<T> air = airspeed(found.velocity_b);
  out.airspeed = air.speed;
  out.angle_of_attack = air.angle_of_attack;
  out.sideslip = air.sideslip;
  out.specific_force = C(R(1) / c.mass.mass) * found.total.force;
  out.load_factor = load_factor(out.specific_force, found.velocity_b);
  out.climb_rate = c.around.wind_n.z - rates.position.z;
  for (const Side side : {right, left}) {
    const MastLoads<T>& rotor = found.rotor[side].loads;
    out.thrust[side] = length(rotor.force_a);
    out.torque[side] = rotor.torque + c.rotor[side].spin_up;
    out.power[side] = out.torque[side] * c.rotor[side].speed;
    out.collective[side] = found.controls.collective[side];
    out.long_cyclic[side] = found.controls.long_cyclic[side];
    out.gimbal_tilt[side] = length(Vec3<T>{x.rotor[side].b1c, x.rotor[side].b1s, T(R(0))});
  }
  out.elevator = found.controls.elevator;
  out.aileron = found.controls.aileron;
  out.rudder = found.controls.rudder;
}

}  // namespace tiltrotor

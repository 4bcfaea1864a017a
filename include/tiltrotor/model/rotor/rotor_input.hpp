// What a rotor sees of the aircraft, and what one of its blades sees of that.
#pragma once

#include "tiltrotor/math/vector.hpp"
#include "tiltrotor/model/rotor/blade_element.hpp"
#include "tiltrotor/model/variables/state.hpp"

namespace tiltrotor {

template <class T>
struct RotorInput {
  Vec3<T> velocity_a;  // hub relative to the air, m/s
  Vec3<T> rates_a;     // of the hub frame, rad/s
  RotorState<T> state;
  ConingState<T> coning;
  T collective;      // blade pitch at the reference radius, rad
  T lateral_cyclic;  // A1: pitch = ... - A1 cos psi - B1 sin psi, rad
  T long_cyclic;     // B1

  static constexpr int kCount = 18;
  template <class Self, class Visit>
  static constexpr void each(Self& s, Visit&& visit) {
    Vec3<T>::each(s.velocity_a, visit);
    Vec3<T>::each(s.rates_a, visit);
    visit(s.state.b1c);
    visit(s.state.b1s);
    visit(s.state.b1c_rate);
    visit(s.state.b1s_rate);
    visit(s.state.lambda_0);
    visit(s.state.lambda_c);
    visit(s.state.lambda_s);
    visit(s.coning.angle);
    visit(s.coning.rate);
    visit(s.collective);
    visit(s.lateral_cyclic);
    visit(s.long_cyclic);
  }
};
static_assert(lists_its_members<RotorInput>(), "each member of RotorInput is listed and counted");

// A rotor's input, and its conditions.
template <class T>
struct PlacedRotorInput {
  RotorInput<T> in;
  T speed, ground_wash, density, speed_of_sound;  // RotorConditions

  static constexpr int kCount = RotorInput<T>::kCount + 4;
  template <class Self, class Visit>
  static constexpr void each(Self& s, Visit&& visit) {
    RotorInput<T>::each(s.in, visit);
    visit(s.speed);
    visit(s.ground_wash);
    visit(s.density);
    visit(s.speed_of_sound);
  }
};
static_assert(lists_its_members<PlacedRotorInput>(), "each member of PlacedRotorInput is listed and counted");

// Flap angle of the blade at one azimuth.
template <class T, class Plain>
T flap_angle(const RotorInput<T>& in, const Plain& cosine, const Plain& sine) {
  return in.coning.angle + in.state.b1c * cosine + in.state.b1s * sine;
}

// Mean inflow as the blades feel it, m/s: felt_inflow().
template <class T>
struct FeltInflow {
  T even;    // over the disk
  T shaped;  // part of it that follows the radial shape
};

// Flow seen by the blade at one azimuth, no small angles. Derived here: velocity of a point at radius r of a
// blade at flap angle b, less that of the induced air, along the direction of rotation and the blade normal;
// cyclic pitch and signs as in NASA CR-166536, theta = theta75 - A1 cos psi - B1 sin psi.
// `cosine`, `sine`: of the azimuth, a plain number or a batch of blades.
// `omega`: rotor speed, rad/s; `pitch_flap`: pitch taken off by flapping.
template <class T, class C, class Plain>
BladeFlow<T> blade_flow(const C& omega, Real<T> pitch_flap, const RotorInput<T>& in,
                        const FeltInflow<T>& inflow, const T& sin_flap, const T& cos_flap,
                        const Plain& cosine, const Plain& sine) {
  const RotorState<T>& x = in.state;
  const T gimbal = x.b1c * cosine + x.b1s * sine;
  const T flap_rate =
      in.coning.rate + x.b1c_rate * cosine + x.b1s_rate * sine + omega * (x.b1s * cosine - x.b1c * sine);
  BladeFlow<T> flow;
  flow.tangential_0 = in.velocity_a.y * cosine - in.velocity_a.x * sine;
  flow.tangential_r =
      cos_flap * (omega + in.rates_a.z) - sin_flap * (in.rates_a.x * cosine + in.rates_a.y * sine);
  flow.normal_0 = cos_flap * (in.velocity_a.z + inflow.even) -
                  sin_flap * (in.velocity_a.x * cosine + in.velocity_a.y * sine);
  flow.normal_r = flap_rate + in.rates_a.x * sine - in.rates_a.y * cosine +
                  cos_flap * (omega * (x.lambda_c * cosine + x.lambda_s * sine));
  flow.shaped = cos_flap * inflow.shaped;
  flow.pitch = in.collective - in.lateral_cyclic * cosine - in.long_cyclic * sine - pitch_flap * gimbal;
  return flow;
}

}  // namespace tiltrotor

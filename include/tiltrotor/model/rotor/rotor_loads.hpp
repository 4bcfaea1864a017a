// Loads of one rotor: the sum over its blades.
#pragma once

#include "tiltrotor/math/vector.hpp"
#include "tiltrotor/model/rotor/blade_group.hpp"

namespace tiltrotor {

// What the mast takes of a rotor.
template <class T>
struct MastLoads {
  Vec3<T> force_a;  // on the hub, N
  T torque;         // about the shaft, absorbed, N m

  template <class Self, class Visit>
  static constexpr void each(Self& s, Visit&& visit) {
    Vec3<T>::each(s.force_a, visit);
    visit(s.torque);
  }
};

// Sums over the blades.
template <class T>
struct RotorLoads : MastLoads<T> {
  T mc, ms, m0;  // sums of r dF_n times cos psi, sin psi, 1, N m: balanced by gimbal, coning and inflow

  template <class Self, class Visit>
  static constexpr void each(Self& s, Visit&& visit) {
    MastLoads<T>::each(s, visit);
    visit(s.mc);
    visit(s.ms);
    visit(s.m0);
  }
};

// Adds the loads of the blade at one azimuth, number `lane` of its group. Derived here: forces along the
// blade normal (-sin b cos psi, -sin b sin psi, cos b) and the direction of rotation (-sin psi, cos psi, 0),
// and their moments about the hub centre.
template <class T, class C, class S>
void add_blade(const Configuration<C>& c, const ElementAir<S, S>& air, const S& omega,
               const RotorInput<T>& in, const FeltInflow<T>& inflow, Real<T> cosine, Real<T> sine,
               const BladeGroup<T>& group, int lane, RotorLoads<T>& sum) {
  const SineCosine<T> flap = sine_and_cosine(flap_angle(in, cosine, sine));
  const BladeLoads<T> blade = group.loads(
      c, air, lane, blade_flow(omega, c.pitch_flap, in, inflow, flap.sine, flap.cosine, cosine, sine));
  const T radial = flap.sine * blade.normal;  // inward along the blade's projection on the disk
  sum.force_a.x -= cosine * radial + sine * blade.tangential;
  sum.force_a.y += cosine * blade.tangential - sine * radial;
  sum.force_a.z += flap.cosine * blade.normal;
  sum.torque -= flap.cosine * blade.tangential_moment;
  sum.mc += cosine * blade.normal_moment;
  sum.ms += sine * blade.normal_moment;
  sum.m0 += blade.normal_moment;
}

// Blade-element loads of the rotor.
template <class T, class C, class S>
void rotor_loads(const Configuration<C>& c, const RotorConditions<S>& turn, const RotorInput<T>& in,
                 const AzimuthStations<Real<T>>& azimuth, BladeGroup<T>& blades, RotorLoads<T>& sum) {
  using R = Real<T>;
  RotorLoads<T>::each(sum, [](T& x) { x = T(R(0)); });
  const ElementAir<S, S> air = element_air(turn);
  const FeltInflow<T> inflow = felt_inflow(c, turn, in);
  blades.set_input(in, inflow);
  for (int k = 0; k < azimuth.count; ++k) {
    const int lane = k % BladeGroup<T>::kBlades;
    if (lane == 0) blades.compute_blades(c, air, value(turn.speed), azimuth, k);
    add_blade(c, air, turn.speed, in, inflow, azimuth.cosine[k], azimuth.sine[k], blades, lane, sum);
  }
  RotorLoads<T>::each(sum, [&azimuth](T& x) { x = azimuth.weight * x; });
}

}  // namespace tiltrotor

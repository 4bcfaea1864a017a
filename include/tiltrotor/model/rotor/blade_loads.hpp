// From the loads of one blade to those of the rotor.
#pragma once

#include "tiltrotor/math/vector.hpp"
#include "tiltrotor/model/rotor/blade_view.hpp"

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

  static constexpr int kCount = 7;
  template <class Self, class Visit>
  static constexpr void each(Self& s, Visit&& visit) {
    MastLoads<T>::each(s, visit);
    visit(s.mc);
    visit(s.ms);
    visit(s.m0);
  }
};

// What a blade adds. Derived here: forces along the blade normal (-sin b cos psi, -sin b sin psi, cos b) and the direction
// of rotation (-sin psi, cos psi, 0), and their moments about the hub centre. `flap`: of b.
template <class T, class Plain>
RotorLoads<T> loads_on_hub(const BladeLoads<T>& blade, const SineCosine<T>& flap, const Plain& cosine,
                           const Plain& sine) {
  const T radial = flap.sine * blade.normal;  // inward along the blade's projection on the disk
  RotorLoads<T> loads;
  loads.force_a.x = -(cosine * radial + sine * blade.tangential);
  loads.force_a.y = cosine * blade.tangential - sine * radial;
  loads.force_a.z = flap.cosine * blade.normal;
  loads.torque = -(flap.cosine * blade.tangential_moment);
  loads.mc = cosine * blade.normal_moment;
  loads.ms = sine * blade.normal_moment;
  loads.m0 = blade.normal_moment;
  return loads;
}

}  // namespace tiltrotor

// Force and moment of a component, and the names of the components.
#pragma once

#include "tiltrotor/math/vector.hpp"

namespace tiltrotor {

// Force (N) and moment about the CG (N m), body axes.
template <class T>
struct Loads {
  Vec3<T> force;
  Vec3<T> moment;

  static constexpr int kCount = 6;
  template <class Self, class Visit>
  static constexpr void each(Self& s, Visit&& visit) {
    Vec3<T>::each(s.force, visit);
    Vec3<T>::each(s.moment, visit);
  }
};
static_assert(lists_its_members<Loads>(), "each member of Loads is listed and counted");

template <class T>
Loads<T> operator+(const Loads<T>& a, const Loads<T>& b) {
  return {a.force + b.force, a.moment + b.moment};
}

// Loads of a force acting at an arm from the CG.
template <class T, class C>
Loads<T> force_at(const Vec3<C>& arm, const Vec3<T>& force) {
  return {force, arm_cross_force(arm, force)};
}

enum class Component : unsigned char {
  rotor_right,
  rotor_left,
  wing_wake_right,
  wing_wake_left,
  wing_free,
  pylon,
  spinners,
  pylon_side,
  fuselage,
  htail,
  fin_right,
  fin_left,
  engine_jets,
  count
};
inline constexpr int component_count = static_cast<int>(Component::count);

inline constexpr const char* kComponentNames[] = {
    "rotor_right", "rotor_left", "wing_wake_right", "wing_wake_left", "wing_free", "pylon",      "spinners",
    "pylon_side",  "fuselage",   "htail",           "fin_right",      "fin_left",  "engine_jets"};
static_assert(sizeof(kComponentNames) / sizeof(kComponentNames[0]) == component_count,
              "one word per component");

// Component loads of one evaluation, for the user who looks for a wrong sign.
template <class T>
struct LoadRecord {
  Loads<T> component[component_count];  // in the order of Component
  Loads<T>& operator[](Component which) { return component[static_cast<int>(which)]; }
  const Loads<T>& operator[](Component which) const { return component[static_cast<int>(which)]; }
};

}  // namespace tiltrotor

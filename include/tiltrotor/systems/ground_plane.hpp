// The ground as a plane, and an aircraft above it.
#pragma once

#include "tiltrotor/math/vector.hpp"

namespace tiltrotor {

// d = down + slope_north n + slope_east e, m: north and east from where positions count, slopes positive downhill.
template <class R>
struct GroundPlane {
  R down;                     // m
  R slope_north, slope_east;  // tangents
};

// All of it that acts on the aircraft.
template <class T>
struct AboveGround {
  Vec3<T> up_b;  // normal of the ground, upwards, unit vector in body axes
  T height;      // of the CG along it, m; negative below

  static constexpr int kCount = 4;
  template <class Self, class Visit>
  static constexpr void each(Self& s, Visit&& visit) {
    Vec3<T>::each(s.up_b, visit);
    visit(s.height);
  }
};
static_assert(lists_its_members<AboveGround>(), "each member of AboveGround is listed and counted");

// Of an aircraft at the angles of bank, pitch and heading (rad), its CG at `position` (north, east, down, m).
template <class T>
AboveGround<T> above_ground(const GroundPlane<Real<T>>& ground, const T& roll, const T& pitch, const T& yaw,
                            const Vec3<T>& position) {
  using R = Real<T>;
  const R north = ground.slope_north, east = ground.slope_east;
  const R unit = R(1) / sqrt(R(1) + square(north) + square(east));
  const SineCosine<T> r = sine_and_cosine(roll), p = sine_and_cosine(pitch), y = sine_and_cosine(yaw);
  // The normal (slope_north, slope_east, -1), turned by heading, pitch and bank.
  const T ahead = north * y.cosine + east * y.sine;
  const T aside = east * y.cosine - north * y.sine;
  const T below = ahead * p.sine - p.cosine;
  AboveGround<T> a;
  a.up_b = unit * Vec3<T>{ahead * p.cosine + p.sine, aside * r.cosine + below * r.sine,
                          below * r.cosine - aside * r.sine};
  a.height = unit * (ground.down + north * position.x + east * position.y - position.z);
  return a;
}

// Height above the ground of a point at `arm` from the CG, body axes, m.
template <class T, class C>
T height_of(const AboveGround<T>& above, const Vec3<C>& arm) {
  return above.height + component(above.up_b, arm);
}

}  // namespace tiltrotor

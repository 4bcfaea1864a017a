// Vector of three components and the rotation between two right-handed frames.
#pragma once

#include "tiltrotor/math/scalar.hpp"

namespace tiltrotor {

template <class T>
struct Vec3 {
  T x, y, z;

  template <class Self, class Visit>
  static constexpr void each(Self& self, Visit&& visit) {
    visit(self.x);
    visit(self.y);
    visit(self.z);
  }
};

// Whether a struct of scalars lists each of its members once with `each`, and their number as kCount.
template <template <class> class S>
constexpr bool lists_its_members() {
  S<int> s{};
  S<int>::each(s, [](int& member) { ++member; });
  int once = 0;
  S<int>::each(s, [&once](const int& member) { once += member == 1 ? 1 : 0; });
  return once == S<int>::kCount && sizeof s == sizeof(int) * static_cast<unsigned>(once);
}

template <class T>
Vec3<T> operator+(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
Vec3<T> operator-(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class S, class T>
Vec3<T> operator*(const S& s, const Vec3<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
// In the functions of T and C below, C is T or plain: a direction or an arm that moves with the other argument,
// or one that is fixed.
template <class T, class C>
Vec3<T> along(const T& s, const Vec3<C>& direction) {
  return {s * direction.x, s * direction.y, s * direction.z};
}
template <class T>
T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
// a with a vector that is plain, or its own.
template <class T, class C>
Vec3<T> plus_fixed(const Vec3<T>& a, const Vec3<C>& fixed) {
  return {a.x + fixed.x, a.y + fixed.y, a.z + fixed.z};
}
template <class T, class C>
Vec3<T> minus_fixed(const Vec3<T>& a, const Vec3<C>& fixed) {
  return {a.x - fixed.x, a.y - fixed.y, a.z - fixed.z};
}
// Length. At zero it has no derivative: partials are zero there.
template <class T>
T length(const Vec3<T>& a) {
  const T square = dot(a, a);
  return value(square) == Real<T>(0) ? T(Real<T>(0)) : sqrt(square);
}
// Component of a along a direction.
template <class T, class C>
T component(const Vec3<T>& a, const Vec3<C>& direction) {
  return a.x * direction.x + a.y * direction.y + a.z * direction.z;
}
// rate x arm: velocity of a point fixed in a rotating frame.
template <class T, class C>
Vec3<T> rate_cross_arm(const Vec3<T>& rate, const Vec3<C>& arm) {
  return {rate.y * arm.z - rate.z * arm.y, rate.z * arm.x - rate.x * arm.z, rate.x * arm.y - rate.y * arm.x};
}
// arm x force: moment of a force.
template <class T, class C>
Vec3<T> arm_cross_force(const Vec3<C>& arm, const Vec3<T>& force) {
  return {force.z * arm.y - force.y * arm.z, force.x * arm.z - force.z * arm.x,
          force.y * arm.x - force.x * arm.y};
}
template <class T>
Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Rows are the unit vectors of the new frame, written in the old one.
template <class R>
struct Rotation {
  Vec3<R> row_x, row_y, row_z;

  template <class T>
  Vec3<T> apply(const Vec3<T>& a) const {  // old frame -> new frame
    return {component(a, row_x), component(a, row_y), component(a, row_z)};
  }
  template <class T>
  Vec3<T> apply_inverse(const Vec3<T>& a) const {  // new frame -> old frame
    return {a.x * row_x.x + a.y * row_y.x + a.z * row_z.x, a.x * row_x.y + a.y * row_y.y + a.z * row_z.y,
            a.x * row_x.z + a.y * row_y.z + a.z * row_z.z};
  }
};

}  // namespace tiltrotor

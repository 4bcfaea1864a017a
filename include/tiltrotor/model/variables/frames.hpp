// Frames of the tilting masts; mast geometry: NASA CR-166536 p. B-31.
//
// B: body axes. H: hub axes of one rotor, non-rotating: x_h forward at mast 0 and down at mast 90, z_h down
// the shaft. A: rotor frame, x aft, y to the advancing side, z up the shaft; mirrored for the left rotor, so
// that one routine for a counter-clockwise rotor serves both. Azimuth counts from blade aft in the sense of
// rotation. Where two frames meet, a vector's name ends in the frame of its components: force_a, arm_b.
#pragma once

#include "tiltrotor/math/vector.hpp"
#include "tiltrotor/model/variables/state.hpp"

namespace tiltrotor {

// A slower motion through the air is rest, m/s: it has no direction, and its square may be no number.
template <class R>
inline constexpr R kLeastSpeed = R(1e-15);

// +1 right, -1 left.
template <class R>
constexpr R side_sign(int side) {
  return side == right ? R(1) : R(-1);
}

template <class C>
struct HubFrame {
  Rotation<C> from_body;  // B -> H: C_HB
  Vec3<C> arm_b;          // CG to hub, m
  Vec3<C> thrust_axis_b;  // unit vector up the canted shaft
};

// Hub axes at the angles of mast and outboard cant: the rows of C_HB.
template <class C>
HubFrame<C> hub_frame(const SineCosine<C>& mast, const SineCosine<C>& cant, int side,
                      const Vec3<C>& pivot_arm_b, Real<C> mast_length) {
  using R = Real<C>;
  const auto& [sm, cm] = mast;
  const auto& [sc, cc] = cant;
  const R sigma = side_sign<R>(side);
  HubFrame<C> frame;
  frame.thrust_axis_b = {cc * sm, sc * sigma, -cc * cm};
  frame.from_body.row_x = {cm, C(R(0)), sm};
  frame.from_body.row_y = {-sc * sigma * sm, cc, sc * sigma * cm};
  frame.from_body.row_z = {-frame.thrust_axis_b.x, -frame.thrust_axis_b.y, -frame.thrust_axis_b.z};
  frame.arm_b = pivot_arm_b + mast_length * frame.thrust_axis_b;
  return frame;
}

// H -> A and back, which is the same: velocities and forces (polar), rates and moments (axial).
template <class T>
Vec3<T> mirror_polar(const Vec3<T>& v, int side) {
  const Real<T> sigma = side_sign<Real<T>>(side);
  return {-v.x, sigma * v.y, -v.z};
}
template <class T>
Vec3<T> mirror_axial(const Vec3<T>& v, int side) {
  const Real<T> sigma = side_sign<Real<T>>(side);
  return {-sigma * v.x, v.y, -sigma * v.z};
}

}  // namespace tiltrotor

// Frames of the tilting masts; mast geometry: NASA CR-166536 p. B-31.
//
// B: body axes. H: hub axes of one rotor, non-rotating: x_h forward at mast 0 and up at mast 90, z_h down the
// shaft. A: rotor frame, x aft, y to the advancing side, z up the shaft; mirrored for the left rotor, so that
// one routine for a counter-clockwise rotor serves both. Azimuth counts from blade aft in the sense of
// rotation.
#pragma once

#include "tiltrotor/math/vector.hpp"
#include "tiltrotor/model/variables/state.hpp"

namespace tiltrotor {

// +1 right, -1 left.
template <class R>
constexpr R side_sign(int side) {
  return side == right ? R(1) : R(-1);
}

template <class C>
struct HubFrame {
  Rotation<C> from_body;  // B -> H
  Vec3<C> arm;            // CG to hub, B, m
  Vec3<C> thrust_axis;    // unit vector up the canted shaft, B
};

// Hub axes at the angles of mast and outboard cant: the rows of C_HB.
template <class C>
HubFrame<C> hub_frame(const SineCosine<C>& mast, const SineCosine<C>& cant, int side,
                      const Vec3<C>& pivot_arm, Real<C> mast_length) {
  using R = Real<C>;
  const auto& [sm, cm] = mast;
  const auto& [sc, cc] = cant;
  const R sigma = side_sign<R>(side);
  HubFrame<C> frame;
  frame.thrust_axis = {cc * sm, sc * sigma, -cc * cm};
  frame.from_body.row_x = {cm, C(R(0)), sm};
  frame.from_body.row_y = {-sc * sigma * sm, cc, sc * sigma * cm};
  frame.from_body.row_z = {-frame.thrust_axis.x, -frame.thrust_axis.y, -frame.thrust_axis.z};
  frame.arm = pivot_arm + mast_length * frame.thrust_axis;
  return frame;
}

// H -> A and back: velocities and forces (polar), rates and moments (axial).
template <class T>
Vec3<T> mirror_polar(const Vec3<T>& a, int side) {
  const Real<T> sigma = side_sign<Real<T>>(side);
  return {-a.x, sigma * a.y, -a.z};
}
template <class T>
Vec3<T> mirror_axial(const Vec3<T>& a, int side) {
  const Real<T> sigma = side_sign<Real<T>>(side);
  return {-sigma * a.x, a.y, -sigma * a.z};
}

}  // namespace tiltrotor

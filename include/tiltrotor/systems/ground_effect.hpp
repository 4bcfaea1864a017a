// What the ground does to rotors and wing: more thrust for the same power, less download.
//
// Thrust of a rotor at equal power, Cheeseman and Bennett (ARC R&M 3021), z the height of its hub, V its speed in the
// plane of the disk, vi the mean induced speed:
//   T/T_free = 1/(1 - k),  k = (R/4z)^2 cos^2(bM) / (1 + (V/vi)^2)              cos^2: the wake must meet the ground
// The ground turns part of the induced flow back through the disk: blades feel f vi, while momentum still balances vi,
// T = 2 rho A vi^2. Equal induced power, T f vi = T_free vi_free, with vi going with sqrt(T), gives (derived)
//   f = (T_free/T)^(3/2) = (1 - k)^(3/2)
// The inflow states stay those of momentum, so that wakes, skew and time constants do. Their harmonics, which carry no
// mean power, are left alone.
#pragma once

#include "tiltrotor/math/smooth.hpp"
#include "tiltrotor/model/setup/configuration.hpp"
#include "tiltrotor/systems/ground_plane.hpp"

namespace tiltrotor {

// For `ground_wash` of Configuration::rotor, and Configuration::download; 1 away from the ground.
template <class T>
struct GroundEffect {
  T wash[2];   // f of each rotor, right and left
  T download;  // part of the loads left of the wing in the wakes
};

// Part of the ground's effect that mast angle and speed leave, 0..1: cos^2(bM) vi^2/(vi^2 + V^2). `inflow`: mean, vi.
template <class T, class C>
T remaining_effect(const Configuration<C>& c, int side, const Vec3<T>& velocity_b, const Vec3<T>& rates_b,
                   const T& inflow) {
  const HubFrame<C>& hub = c.hub[side];
  const Vec3<T> v = velocity_b + rate_cross_arm(rates_b, hub.arm_b);
  const T in_plane2 = dot(v, v) - square(component(v, hub.thrust_axis_b));
  const T wash2 = square(inflow) + square(c.aircraft->smooth.ground_wash);
  return square(c.nacelle_axis_b.z) * (wash2 / (wash2 + in_plane2));
}

// k at the height of a hub, with nothing lost to mast angle and speed.
template <class R, class T>
T image_strength(const Aircraft<R>& aircraft, const T& height) {
  const GroundTables<R>& g = aircraft.ground;
  const T z = height * (R(1) / aircraft.rotor.radius);
  const T fade = R(1) - smooth_step(T((z - g.fade_start) * (R(1) / (g.fade_end - g.fade_start))));
  return fade / (R(16) * square(smooth_max(z, g.least_height, aircraft.smooth.ground_height)));
}

// Part of the download that the ground takes at the height of a hub, likewise: to nothing at download_end.
template <class R, class T>
T download_relief(const Aircraft<R>& aircraft, const T& height) {
  const GroundTables<R>& g = aircraft.ground;
  const R end = g.download_end * aircraft.rotor.radius;
  const T rise = (height - g.hub_height_on_gear) * (R(1) / (end - g.hub_height_on_gear));
  return (R(1) - g.download_on_gear) * (R(1) - smooth_step(rise));
}

// `velocity_b`, `rates_b`: of the airframe at the CG relative to the air, m/s and rad/s. `inflow`: mean, of each rotor,
// over tip speed (RotorState::lambda_0).
template <class T, class C>
GroundEffect<T> ground_effect(const Configuration<C>& c, const AboveGround<T>& above,
                              const Vec3<T>& velocity_b, const Vec3<T>& rates_b, const T (&inflow)[2]) {
  using R = Real<T>;
  GroundEffect<T> out;
  out.download = T(R(1));
  for (const Side side : {right, left}) {
    const T remaining =
        remaining_effect(c, side, velocity_b, rates_b, T(c.rotor[side].tip_speed * inflow[side]));
    const T height = height_of(above, c.hub[side].arm_b);
    const T k = image_strength(*c.aircraft, height) * remaining;
    out.wash[side] = (R(1) - k) * sqrt(T(R(1) - k));
    out.download = out.download - R(0.5) * download_relief(*c.aircraft, height) * remaining;
  }
  return out;
}

}  // namespace tiltrotor

// Rotor wake on one half wing: immersed area and where it lies, from the geometry of a contracting skewed
// vortex cylinder (on-axis speed of a semi-infinite vortex tube, radius by continuity; the geometry is
// derived here), or from the empirical law of a low-order slipstream model.
#pragma once

#include "tiltrotor/model/airframe/airflow.hpp"

namespace tiltrotor {

template <class T>
struct ImmersedWing {
  T area;     // m^2
  T lateral;  // distance of its centroid from the centre line, m
  T wash;     // K_w v0: speed of the wash on it along the nacelle axis, m/s
};

// Smooth speed fade of the geometric wake: calibration on printed loads at mast 0, 30, 60 and 90, see
// choices.csv. wake_fade_airplane=off withdraws it from mast 60 to 90.
template <class T, class C>
T wake_fade(const Configuration<C>& c, const T& speed) {
  using R = Real<T>;
  if (!c.setup.options.wake_fade) return T(R(1));
  const WakeTables<R>& w = c.aircraft->wake;
  const T by_speed = smooth_step(T((speed - w.fade_start) * (R(1) / (w.fade_end - w.fade_start))));
  if (c.setup.options.wake_fade_airplane) return R(1) - by_speed;
  const C by_mast =
      smooth_step((c.setup.mast_deg - w.fade_mast_start) / (w.fade_mast_end - w.fade_mast_start));
  return R(1) - (R(1) - by_mast) * by_speed;
}

// S_i = S_max [ sin(a x) + cos(b x) ] (1 - V/V_end), x = 90 deg - bM, between 0 and the half wing: a
// low-order slipstream model, known by transcription (aircraft.csv: slipstream_*). Lateral centroid of the
// immersed part: that of the half wing.
template <class T, class C>
ImmersedWing<T> empirical_immersed_wing(const Configuration<C>& c, const AirframeInput<T>& in,
                                        const FreeStream<T>& stream, int side) {
  using R = Real<T>;
  const WakeTables<R>& w = c.aircraft->wake;
  const C upright = kPi<R> / R(2) - c.mast;
  const C shape = sin(w.gtrs_angle_a * upright) + cos(w.gtrs_angle_b * upright);
  const C scale = value(shape) > R(0) ? C(w.gtrs_area * shape) : C(R(0));
  const T remaining =
      smooth_positive(T(R(1) - stream.speed * (R(1) / w.gtrs_end_speed)), c.aircraft->smooth.wake_cut);
  const R half_area = c.aircraft->wing.area / R(2);
  ImmersedWing<T> out;
  out.area = smooth_min(T(scale * remaining), half_area, c.aircraft->smooth.wake_cut * half_area);
  out.lateral = T(c.aircraft->wing.bl);
  out.wash = w.wash_factor * in.mean_wash[side];
  return out;
}

template <class T, class C>
ImmersedWing<T> geometric_immersed_wing(const Configuration<C>& c, const AirframeInput<T>& in,
                                        const FreeStream<T>& stream, int side) {
  using R = Real<T>;
  const WakeTables<R>& w = c.aircraft->wake;
  const WingTables<R>& wing = c.aircraft->wing;
  const SmoothingWidths<R>& e = c.aircraft->smooth;
  const R sigma = side_sign<R>(side);
  const R radius = c.aircraft->rotor.radius;
  const Vec3<C>& axis_b = c.nacelle_axis_b;
  const T& v0 = in.mean_wash[side];

  // Direction of the wake axis: wind relative to the aircraft plus the wash between disk and far wake, 1.5 v0
  // (choices.csv: wake_axis_speed_factor).
  const Vec3<C>& hub_b = c.hub[side].arm_b;
  const Vec3<T> hub_velocity_b = in.velocity_b + rate_cross_arm(in.rates_b, hub_b);
  const Vec3<T> wind_b = T(R(-1)) * hub_velocity_b - along(T(w.axis_speed_factor * v0), axis_b);
  const T inverse = R(1) / sqrt(dot(wind_b, wind_b) + square(e.wake_axis));
  const Vec3<T> d_b = inverse * wind_b;
  const T inverse_plane = R(1) / sqrt(d_b.x * d_b.x + d_b.z * d_b.z + square(e.wake_plane));

  // Closest approach to the quarter-chord line of the half wing, seen in the plane of symmetry (derived
  // here): s = (D . d)/d_xz downstream, h = (D_x d_z - D_z d_x)/d_xz aside.
  const Vec3<C> line_b = station_arm(c.mass, wing.sl, R(0), wing.wl);
  const C dx = line_b.x - hub_b.x;
  const C dz = line_b.z - hub_b.z;
  const T downstream = (dx * d_b.x + dz * d_b.z) * inverse_plane;
  const T miss = (dx * d_b.z - dz * d_b.x) * inverse_plane;
  const T centre = sigma * hub_b.y + sigma * (downstream * d_b.y * inverse_plane);

  // Contraction: K(s) v0 on the axis, K = 1 + (s/R)/sqrt(1 + (s/R)^2) of a semi-infinite vortex
  // tube (law of Biot and Savart); radius by continuity, R_w^2 = R^2 (V_n + v0)/(V_n + K v0).
  const T s = smooth_positive(downstream, e.wake_distance * radius) * (R(1) / radius);
  const T k = R(1) + s / sqrt(R(1) + s * s);
  const T axial = component(hub_velocity_b, axis_b);
  const T flow_ratio =
      smooth_positive(T(axial + v0), e.wake_radius) / smooth_positive(T(axial + k * v0), e.wake_radius);
  const T wake_radius2 = square(radius) * flow_ratio;

  // Chord of the wake circle on the line, between the inboard limit and the wing tip.
  const R cut = e.wake_cut * radius;
  const T half_width = sqrt(smooth_positive(T(wake_radius2 - miss * miss), cut * cut));
  const R tip = wing.span / R(2);
  const T inner = smooth_clip(T(centre - half_width), w.fuselage_side, tip, cut);
  const T outer = smooth_clip(T(centre + half_width), w.fuselage_side, tip, cut);
  const T enters = smooth_step(T(downstream * (R(1) / (e.wake_start * radius))));

  ImmersedWing<T> out;
  out.area = wing.chord * (outer - inner) * enters * wake_fade(c, stream.speed);
  out.lateral = R(0.5) * (outer + inner);
  out.wash = c.setup.options.wash == WashFactor::constant ? w.wash_factor * v0 : k * v0;
  return out;
}

// Immersed part of the half wing on `side`. `lateral` counts outboard from the centre line.
template <class T, class C>
ImmersedWing<T> immersed_wing(const Configuration<C>& c, const AirframeInput<T>& in,
                              const FreeStream<T>& stream, int side) {
  return c.setup.options.wake == WakeModel::geometric ? geometric_immersed_wing(c, in, stream, side)
                                                      : empirical_immersed_wing(c, in, stream, side);
}

}  // namespace tiltrotor

// Fuselage: drag areas and volumes against angle of attack and sideslip, tables 3-I to 3-IX (NASA CR-166536
// p. A-44).
#pragma once

#include "tiltrotor/model/airframe/airflow.hpp"

namespace tiltrotor {

template <class T, class C>
Loads<T> fuselage_loads(const Configuration<C>& c, const AirframeInput<T>& in, const FreeStream<T>& stream) {
  using R = Real<T>;
  const FuselageTables<R>& f = c.aircraft->fuselage;
  const Interpolation mode = c.setup.options.tables;
  const T& alpha = stream.alpha_deg;
  const T beta = stream.beta * kDegPerRad<R>;
  const T& abs_beta = stream.abs_beta_deg;
  const T cos_beta = cos(stream.beta);
  const T cos2 = cos_beta * cos_beta;
  const T q = R(0.5) * c.air.density * dot(in.velocity, in.velocity);

  // Alpha and beta tables both hold the value at zero sideslip: it is subtracted once.
  const T lift = lookup(f.lift_alpha, mode, alpha) * cos2 + lookup(f.lift_beta, mode, abs_beta) - f.lift_zero;
  const T drag = lookup(f.drag_alpha, mode, alpha) * cos2 + lookup(f.drag_beta, mode, abs_beta) -
                 f.drag_zero + f.extra_drag;
  const T pitch =
      lookup(f.moment_alpha, mode, alpha) * cos2 + lookup(f.moment_beta, mode, abs_beta) - f.moment_zero;
  const T side = lookup(f.side_beta, mode, beta);
  const T roll = lookup(f.roll_beta, mode, beta);
  const T yaw = lookup(f.yaw_beta, mode, beta);

  const T sa = sin(stream.alpha);
  const T ca = cos(stream.alpha);
  Loads<T> loads = force_at(station_arm(c.mass, f.sl, R(0), f.wl),
                            q * wind_force(lift, drag, side, stream.alpha, stream.beta));
  loads.moment.x += q * (roll * ca - yaw * sa);
  loads.moment.y += q * pitch;
  loads.moment.z += q * (roll * sa + yaw * ca);
  return loads;
}

}  // namespace tiltrotor

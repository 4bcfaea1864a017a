// Fuselage: drag areas and volumes against angle of attack and sideslip (NASA CR-166536 p. A-44, tables 3-I
// to 3-IX, pp. B-26 to B-30).
#pragma once

#include "tiltrotor/model/airframe/airflow.hpp"

namespace tiltrotor {

template <class T, class C>
Loads<T> fuselage_loads(const Configuration<C>& c, const AirframeInput<T>& in, const FreeStream<T>& stream) {
  using R = Real<T>;
  const FuselageTables<R>& f = c.aircraft->fuselage;
  const Interpolation mode = c.setup.options.tables;
  const T& alpha_deg = stream.alpha_deg;
  const T beta_deg = stream.beta * kDegPerRad<R>;
  const T& abs_beta_deg = stream.abs_beta_deg;
  const SineCosine<T> sideslip = sine_and_cosine(stream.beta);
  const T cos2 = sideslip.cosine * sideslip.cosine;
  const T q = R(0.5) * c.air.density * dot(in.velocity_b, in.velocity_b);

  // Alpha and beta tables both hold the value at zero sideslip: it is subtracted once.
  const auto even = [&](const Table<R, 1>& along_alpha, const Table<R, 1>& along_beta, R zero) {
    return lookup(along_alpha, mode, alpha_deg) * cos2 + lookup(along_beta, mode, abs_beta_deg) - zero;
  };
  const T lift = even(f.lift_alpha, f.lift_beta, f.lift_zero);                 // 3-I, 3-II; m^2
  const T drag = even(f.drag_alpha, f.drag_beta, f.drag_zero) + f.extra_drag;  // 3-III, 3-IV; choices.csv
  const T pitch = even(f.moment_alpha, f.moment_beta, f.moment_zero);          // 3-V, 3-VI; m^3
  const T side = lookup(f.side_beta, mode, beta_deg);                          // 3-VII
  const T roll = lookup(f.roll_beta, mode, beta_deg);                          // 3-VIII
  const T yaw = lookup(f.yaw_beta, mode, beta_deg);                            // 3-IX

  const auto& [sa, ca] = stream.attack;
  Loads<T> loads = force_at(station_arm(c.mass, f.sl, R(0), f.wl),
                            q * wind_force(lift, drag, side, stream.attack, sideslip));
  loads.moment.x += q * (roll * ca - yaw * sa);
  loads.moment.y += q * pitch;
  loads.moment.z += q * (roll * sa + yaw * ca);
  return loads;
}

}  // namespace tiltrotor

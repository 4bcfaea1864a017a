// Wing and pylon: coefficients that depend on mast angle and flap alone (NASA CR-166536 tables 4-VI to 4-XV),
// found once for a configuration.
#pragma once

#include "tiltrotor/model/aircraft/aircraft.hpp"
#include "tiltrotor/model/variables/options.hpp"

namespace tiltrotor {

template <class C>
struct WingConstants {
  C moment;  // Cm
  C roll_beta, roll_beta_per_lift;
  C zero_lift_drag;
  C aileron_roll, aileron_yaw_0, aileron_yaw, aileron_lift_loss;
  C rotor_wash;        // X_RW
  C wake_load_factor;  // K_FW
  Real<C> aspect_ratio;
  int flap_below, flap_above;  // settings around the flap angle
  C flap_fraction;             // weight of the setting above
};

template <class C>
WingConstants<C> wing_constants(const Aircraft<Real<C>>& aircraft, const Options& options, const C& mast_deg,
                                const C& flap_deg) {
  using R = Real<C>;
  const WingTables<R>& w = aircraft.wing;
  const auto at = [&](const Table<R, 1, 1>& table) {
    const GridPoint<C> flap[1] = {grid_point(table.linear[0], flap_deg)};
    const C mast[1] = {mast_deg};
    return lookup(table, Interpolation::linear, flap, mast);
  };
  WingConstants<C> c;
  c.moment = at(w.moment);
  c.roll_beta = at(w.roll_beta);
  c.roll_beta_per_lift = at(w.roll_beta_per_lift);
  c.zero_lift_drag = at(w.zero_lift_drag);
  c.aileron_roll = at(w.aileron_roll);
  c.aileron_yaw_0 = at(w.aileron_yaw_0);
  c.aileron_yaw = at(w.aileron_yaw);
  c.aileron_lift_loss = lookup(w.aileron_lift_loss, Interpolation::linear, flap_deg);
  c.rotor_wash = w.rotor_wash_0 + mast_deg * (w.rotor_wash_1 + mast_deg * w.rotor_wash_2);
  c.wake_load_factor =
      options.wake_load == WakeLoadFactor::calibrated
          ? aircraft.wake.load_factor.at(mast_deg)
          : C(aircraft.wake.gtrs_load_factor_0 + aircraft.wake.gtrs_load_factor_flap * flap_deg);
  c.aspect_ratio = w.span * w.span / w.area;
  const Axis<R> settings{w.flap_settings, w.flap_deg};
  const GridPoint<C> flap = grid_point(settings, flap_deg);
  c.flap_below = flap.interval;
  c.flap_above = flap.interval + 1;
  c.flap_fraction = flap.fraction;
  return c;
}

}  // namespace tiltrotor

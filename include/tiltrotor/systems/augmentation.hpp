// Stability and control augmentation (SCAS): rate feedback in three axes with attitude retention, through series
// actuators of limited authority that add to stick and pedal.
//
// Structure, authority and the time constants that the gains are made for: NASA TM X-62407 pp. 59-61, TM-89428 pp.
// 19-20. Gains are published nowhere: K = (1/tau - damping)/sensitivity at each mast angle, from the linear models of
// this model.
#pragma once

#include "tiltrotor/model/rigid_body.hpp"
#include "tiltrotor/systems/limited.hpp"
#include "tiltrotor/systems/system_state.hpp"

namespace tiltrotor {

// Yaw rate of a coordinated turn, (g/V) sin(bank), faded in with airspeed, rad/s.
template <class T>
T turn_rate_wanted(const AugmentationTables<Real<T>>& t, const T& airspeed, const T& roll) {
  using R = Real<T>;
  const T share = smooth_step(T((airspeed - t.turn_from) * (R(1) / (t.turn_full - t.turn_from))));
  return share * (kGravity<R> / airspeed) * sin(roll);
}

// What the series actuators are asked for, in: within their authority.
template <class T>
struct SeriesCommand {
  T axis[3];      // longitudinal, lateral, yaw
  T washed_rate;  // yaw rate before the washout, rad/s
};

// `airspeed` > 0, m/s. Forward stick, right stick, right pedal are positive, hence the signs.
template <class T>
SeriesCommand<T> augmentation(const SystemTables<Real<T>>& t, const ControlTables<Real<T>>& stick,
                              const T& mast, const T& airspeed, const State<T>& x, const SystemState<T>& s) {
  using R = Real<T>;
  const AugmentationTables<R>& a = t.augmentation;
  const R e = t.smooth.stick;
  const T mast_deg = mast * kDegPerRad<R>;
  const T pitch = lookup(a.pitch, Interpolation::c1, mast_deg) *
                  (x.rates.y + a.attitude * s.holds_pitch * (x.pitch - s.held_pitch));
  const T roll = lookup(a.roll, Interpolation::c1, mast_deg) *
                 (x.rates.x + a.attitude * s.holds_roll * wrapped_difference(x.roll, s.held_roll));
  SeriesCommand<T> out;
  out.washed_rate = x.rates.z - turn_rate_wanted(a, airspeed, x.roll);
  const T yaw = lookup(a.yaw, Interpolation::c1, mast_deg) * (out.washed_rate - s.washout);
  const auto within = [e](const T& wanted, R authority) { return limited(wanted, -authority, authority, e); };
  out.axis[0] = within(pitch, a.pitch_authority * stick.long_travel);
  out.axis[1] = within(T(-roll), a.roll_authority * stick.lat_travel);
  out.axis[2] = within(T(-yaw), a.yaw_authority * stick.pedal_travel);
  return out;
}

// An event of the step: whether an attitude is held, and which. Held from the moment at which the stick is let go and
// the aircraft hardly turns; given up when the stick is moved.
template <class R>
void latch(const AugmentationTables<R>& t, R stick, R rate, R angle, R& holds, R& held) {
  const auto size = [](R x) { return x < R(0) ? -x : x; };
  if (size(stick) > t.dead_band) {
    holds = R(0);
  } else if (holds == R(0) && size(rate) < t.hold_rate) {
    holds = R(1);
    held = angle;
  }
}

}  // namespace tiltrotor

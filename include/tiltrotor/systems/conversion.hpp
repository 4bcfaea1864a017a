// Conversion drive: both masts at one angle, commanded; and the flaps. Rate NASA TM X-62407; laws are choices.
#pragma once

#include "tiltrotor/model/aircraft/aircraft.hpp"
#include "tiltrotor/systems/limited.hpp"

namespace tiltrotor {

template <class T>
struct MastMotion {
  T rate, acceleration;  // rad/s, rad/s^2
};

// A second-order follower: the rate that closes the way in 1/k1 is wanted, at most that of the drive, and reached in
// 1/k2, by at most its acceleration: bM'' = clip(k2 (clip(k1 (command - bM), rate) - bM'), acceleration).
template <class T>
MastMotion<T> mast_motion(const SystemTables<Real<T>>& t, const T& command, const T& mast, const T& rate) {
  using R = Real<T>;
  const ConversionTables<R>& drive = t.conversion;
  const T wanted =
      limited(T(drive.position_gain * (command - mast)), -drive.rate, drive.rate, t.smooth.mast_rate);
  return {rate, limited(T(drive.rate_gain * (wanted - rate)), -drive.acceleration, drive.acceleration,
                        t.smooth.mast_acceleration)};
}

// rad/s.
template <class T>
T flap_rate(const SystemTables<Real<T>>& t, const T& command, const T& flap) {
  const ConversionTables<Real<T>>& drive = t.conversion;
  return limited(T(drive.flap_gain * (command - flap)), -drive.flap_rate, drive.flap_rate,
                 t.smooth.actuator_rate);
}

}  // namespace tiltrotor

// Motion of a point fixed to the airframe, as an inertial unit there measures it.
#pragma once

#include "tiltrotor/model/setup/nacelle_motion.hpp"

namespace tiltrotor {

// Velocity of a point at an arm from the CG, body axes, where the CG has the velocity v and moving nacelles carry it
// through the airframe.
template <class R>
Vec3<R> velocity_at(const Vec3<R>& v, const NacelleMotion<R>& nacelles, const Vec3<R>& rates,
                    const Vec3<R>& arm) {
  return airframe_velocity(v, nacelles) + rate_cross_arm(rates, arm);
}

// Specific force of a point at an arm from the CG: F/m + omega' x r + omega x (omega x r) - c'' - 2 omega x c', with
// the travel c of the CG in the airframe.
template <class R>
Vec3<R> specific_force_at(const Vec3<R>& of_cg, const NacelleMotion<R>& nacelles, const Vec3<R>& rates,
                          const Vec3<R>& acceleration, const Vec3<R>& arm) {
  const Vec3<R> travel = {nacelles.cg_rate_x, R(0), nacelles.cg_rate_z};
  const Vec3<R> travel_rate = {nacelles.cg_acceleration_x, R(0), nacelles.cg_acceleration_z};
  return of_cg + rate_cross_arm(acceleration, arm) + cross(rates, rate_cross_arm(rates, arm)) - travel_rate -
         R(2) * cross(rates, travel);
}

}  // namespace tiltrotor

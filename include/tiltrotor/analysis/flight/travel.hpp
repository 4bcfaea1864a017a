// What adds up during a flight: bank and heading over many turns, and the way flown.
//
// The sums are kept in double precision whatever R is, and an evaluation sees bank and heading within half a
// turn: a step is as accurate after a thousand turns and a thousand kilometres as at the start. A state shows
// the sums rounded to R; one that another hand has changed there begins anew from what it shows.
#pragma once

#include "tiltrotor/math/elementary.hpp"
#include "tiltrotor/model/variables/state.hpp"

namespace tiltrotor {

inline constexpr int kSums = 5;
inline constexpr int kSumIndex[kSums] = {kStateIndex.roll, kStateIndex.yaw, kStateIndex.position.x,
                                         kStateIndex.position.y, kStateIndex.position.z};

struct Travel {
  double sum[kSums];  // roll, yaw (rad, whole turns included), north, east, down (m)
};

// Place in Travel::sum of a state, or -1.
constexpr int sum_of(int state) {
  for (int k = 0; k < kSums; ++k)
    if (kSumIndex[k] == state) return k;
  return -1;
}

template <class R>
void follow(const State<R>& x, Travel& travel) {
  const R shown[kSums] = {x.roll, x.yaw, x.position.x, x.position.y, x.position.z};
  for (int k = 0; k < kSums; ++k)
    if (!(static_cast<R>(travel.sum[k]) == shown[k])) travel.sum[k] = static_cast<double>(shown[k]);
}

// Without whole turns, -pi..pi; exact to 1e-10 rad up to 1e6 rad.
inline double within_half_a_turn(double angle) {
  using E = Elementary<double>;
  const double turns = (angle * (0.5 / 3.14159265358979323846) + E::kRoundToInteger) - E::kRoundToInteger;
  return E::reduce(angle, 4 * turns);
}

// The same attitude and heading as an evaluation sees them.
template <class R>
State<R> without_turns(State<R> x, const Travel& travel) {
  x.roll = static_cast<R>(within_half_a_turn(travel.sum[sum_of(kStateIndex.roll)]));
  x.yaw = static_cast<R>(within_half_a_turn(travel.sum[sum_of(kStateIndex.yaw)]));
  return x;
}

}  // namespace tiltrotor

// Slow level flight in any direction: sideward and rearward, which the steady flights of the trim do not hold
// (sideslip within 60 deg).
#pragma once

#include <cmath>

#include "study/flights.hpp"

namespace tiltrotor::study {

struct SidewardFlight {
  bool found;  // every rate is zero
  State<double> state;
  Controls<double> controls;
  double rate = 0;     // the largest before the last step
  int iterations = 0;  // of Newton
};

// Relative to the air, level with the ground: speed over ground, m/s, its azimuth, rad, + right of the nose, speed down,
// m/s; rate of turn, rad/s, + right.
struct Track {
  double speed, azimuth, down, turn_rate;
};

// A vector of axes level with the ground and turned with the heading, in body axes.
template <class T>
Vec3<T> in_body_axes(const Vec3<double>& v, const T& roll, const T& pitch) {
  const T down = v.x * sin(pitch) + v.z * cos(pitch);
  return {v.x * cos(pitch) - v.z * sin(pitch), down * sin(roll) + v.y * cos(roll),
          down * cos(roll) - v.y * sin(roll)};
}

// Along a track, as SteadyMotion.
struct TrackMotion {
  Track track;

  template <class T>
  Vec3<T> velocity(const T& roll, const T& pitch) const {
    const Vec3<double> level{track.speed * std::cos(track.azimuth), track.speed * std::sin(track.azimuth),
                             track.down};
    return in_body_axes(level, roll, pitch);
  }
  template <class T>
  Vec3<T> rates(const T& roll, const T& pitch) const {
    return in_body_axes({0, 0, track.turn_rate}, roll, pitch);
  }
};

// From hover towards the track. Newton's iteration on the exact linear model.
SidewardFlight flight_along(const Configured& c, const Track& track);
// From a flight straight ahead with the same speed, climb and turn to the azimuth of the track.
SidewardFlight flight_aside(const Configured& c, const Track& track, const SidewardFlight& ahead);

// Level, along a track, rad, + right of the nose.
SidewardFlight sideward_flight(const Configured& c, double speed_mps, double track_rad);

// Largest part of the travel of sticks and pedals.
double travel_used(const Configured& c, const Controls<double>& u);

}  // namespace tiltrotor::study

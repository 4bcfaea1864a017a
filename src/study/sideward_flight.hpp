// Slow level flight in any direction: sideward and rearward, which the steady flights of the trim do not hold
// (sideslip within 60 deg).
#pragma once

#include "study/flights.hpp"

namespace tiltrotor::study {

struct SidewardFlight {
  bool found;  // every rate is zero
  State<double> state;
  Controls<double> controls;
};

// From hover towards the track, rad, + right of the nose. Newton's iteration on the exact linear model.
SidewardFlight sideward_flight(const Configured& c, double speed_mps, double track_rad);

// Largest part of the travel of sticks and pedals.
double travel_used(const Configured& c, const Controls<double>& u);

}  // namespace tiltrotor::study

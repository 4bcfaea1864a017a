// Trim with the wind from any side: backwards and sideways too, which a steady flight with sideslip does not hold.
#pragma once

#include "library/analyses.hpp"
#include "study/sideward_flight.hpp"

namespace tiltrotor::cli {

// Level with the ground.
study::Track track_in_wind(const SteadyFlight<double>& flight, double azimuth);

// Level with the ground, the wind comes from `azimuth`, rad, + right of the nose; speed, climb and turn are those of
// `flight`, its sideslip is not looked at. Newton's iteration on the exact linear model, in stages from hover, or from
// flight straight ahead. Slow flights alone are found where no such way leads: some 25 m/s sideways;
// none straight up or down: out_of_range.
void trim_in_wind(const Configuration<double>& c, const SteadyFlight<double>& flight, double azimuth,
                  Analyses& work, TrimResult<double>& result);

}  // namespace tiltrotor::cli

// Edges of the conversion corridor, found by bisection.
#pragma once

#include "study/flights.hpp"
#include "text/table.hpp"

namespace tiltrotor::study {

using text::Table;

// mast_deg; on the slow side stall_mps (wing) and stop_mps with stop_name (control at its stop), empty where
// there is none down to hover; on the fast side power_mps (continuous rating) and power_reason, and
// takeoff_mps, where the take-off rating of engines or masts ends level flight.
Table corridor_edges(double mast_step_deg);

// The stall side in the conditions of the 1975 design (its flap, rotor speed and masses) against the
// published points.
Table compared_minimum_speeds();

// Stall side and power side with flap and rotor speed as scheduled, against the corridor in use in 1980.
// Columns: mast_deg, published_mps, quantity, here_mps.
Table compared_corridor_in_use();

}  // namespace tiltrotor::study

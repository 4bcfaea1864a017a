// Loads of the components against those printed by the GTRS simulation.
#pragma once

#include "text/table.hpp"

namespace tiltrotor::study {

using text::Table;

// Airframe: replayed at the printed states, tables linear as in the source. Rotor: at this program's trim.
// Columns: set, point, quantity, here, reference, scale (what a fraction of tolerance is of).
Table compared_component_loads();

}  // namespace tiltrotor::study

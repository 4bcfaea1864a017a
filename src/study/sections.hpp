// The sections of the report, in the order of the page. Each runs its part of the study and draws it.
#pragma once

#include <vector>

#include "study/flights.hpp"
#include "study/section.hpp"
#include "study/uncertainty.hpp"

namespace tiltrotor::study {

// Level flights at several mast angles; trim curves, modes, power and load sharing are drawn from them.
using Sweeps = std::vector<SpeedSweep>;

// Bands around the curves of the first three: where `bands` has rows.
Section trim_curves(const Sweeps& sweeps, const Uncertainty& bands = {});  // collective, stick, pitch, power
Section mode_map(const Sweeps& sweeps, const Uncertainty& bands = {});     // eigenvalues
Section collective_response(const Uncertainty& bands = {});                // +1 deg collective at 40 m/s
Section data_flow();                                                       // what feeds what in the model
Section jacobian_timing();                                                 // cost of exact derivatives
Section conversion_corridor();
Section mast_locus();  // roots against mast angle at constant speed
Section power_required(const Sweeps& sweeps);
Section load_sharing(const Sweeps& sweeps);
Section isolated_rotor_tests();
Section lateral_flapping();                      // what each law of the inflow's gradient gives
Section rotor_descent();                         // mean inflow from climb to windmill, autorotation
Section control_response(const Sweeps& sweeps);  // sensitivity, control power, damping
Section frequency_responses();
Section linear_matrices();  // A and B printed by the reference simulation, and here
Section uncertainty_shares(const Uncertainty& bands);  // which inputs make the bands

}  // namespace tiltrotor::study

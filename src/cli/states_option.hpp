// `--states FILE`: given states instead of trimmed ones.
#pragma once

#include "cli/flight_options.hpp"
#include "cli/state_file.hpp"

namespace tiltrotor::cli {

OptionList states_option();

// The file, with the mast angle of every row filled in: from its column mast_deg, else from --mast.
StateFile given_states(const Arguments& arguments, const SetupOptions& setup);

}  // namespace tiltrotor::cli

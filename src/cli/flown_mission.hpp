// The mission of the report, flown.
#pragma once

#include "study/mission.hpp"

namespace tiltrotor::cli {

// src/examples/mission.txt, which the program carries with it. Throws std::runtime_error when it cannot be flown.
study::FlownMission fly_mission();

}  // namespace tiltrotor::cli

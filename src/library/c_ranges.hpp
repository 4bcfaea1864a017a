// What may stand in tr_systems and tr_environment: as a status, and which field and its range in words.
#pragma once

#include "library/c_memory.hpp"

namespace tiltrotor::c_interface {

tr_status check_systems(const tr_systems& systems);
tr_status check_environment(const tr_environment& environment);

}  // namespace tiltrotor::c_interface

// Statuses of the analyses as statuses of the C interface.
#pragma once

#include "tiltrotor/analysis/trim_limits.hpp"
#include "tiltrotor/math/status.hpp"
#include "tiltrotor/tiltrotor.h"

namespace tiltrotor::c_interface {

tr_status translated(Status status);
tr_status translated(TrimStatus status);

}  // namespace tiltrotor::c_interface

#define TILTROTOR_DEFINES_INSTANCES
#include "tiltrotor/analysis/instances.hpp"

namespace tiltrotor {

TILTROTOR_INSTANCES(, float)

}  // namespace tiltrotor

#define TILTROTOR_DEFINES_INSTANCES
#include "tiltrotor/analysis/instances.hpp"

namespace tiltrotor {

template <>
void library_has_these_lanes<kVectorBytes>() {}

TILTROTOR_INSTANCES(, double)

}  // namespace tiltrotor

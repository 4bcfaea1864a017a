#define TILTROTOR_DEFINES_ANALYSIS
#include "tiltrotor/analysis/instances.hpp"

namespace tiltrotor {

TILTROTOR_ANALYSIS(, float, DefaultDifferentiation)

}  // namespace tiltrotor

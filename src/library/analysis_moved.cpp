// For the program and the tests; the C interface has instances of its own.
#include "library/model_instances.hpp"

namespace tiltrotor {

TILTROTOR_MOVED_INSTANCES()

}  // namespace tiltrotor

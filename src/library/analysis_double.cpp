// For the program and the tests; the C interface has instances of its own.
#undef TILTROTOR_EXTERN_INSTANCES
#include "library/model_instances.hpp"

namespace tiltrotor {

TILTROTOR_INSTANCES(, double)

}  // namespace tiltrotor

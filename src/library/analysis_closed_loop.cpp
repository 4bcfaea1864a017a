// For the program and the tests, beside the instances of analyses without a feedback law.
#include "library/closed_loop_flight.hpp"

namespace tiltrotor {

TILTROTOR_CLOSED_LOOP()

}  // namespace tiltrotor

// The analyses that run behind the C interface. The build renames the namespace of every object of the
// library (LIBRARY_FLAGS in the Makefile): no function of a program that includes the headers can take the
// place of one of these.
#define TILTROTOR_C_ANALYSES_CPP
#include "library/c_analyses.hpp"

namespace tiltrotor {

TILTROTOR_C_INSTANCES()

}  // namespace tiltrotor

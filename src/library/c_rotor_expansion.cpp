// The rotors to first order about a point: half the work of a linear model of the aircraft with its systems.
#include "library/c_system_model.hpp"

namespace tiltrotor {
TILTROTOR_ROTOR_INSTANCES()
}  // namespace tiltrotor

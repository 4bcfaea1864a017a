// What a function answers before it computes.
#pragma once

#include "library/processor.hpp"
#include "tiltrotor/tiltrotor.h"

namespace tiltrotor::c_interface {

// Of a library compiled for the instructions `compiled`, where the processor has those `available`.
inline tr_status entry_status(unsigned compiled, unsigned available) {
  return missing_instructions(compiled, available) == nullptr ? TR_OK : TR_BAD_ARITHMETIC;
}

}  // namespace tiltrotor::c_interface

// What a failing call leaves behind for tr_last_fault.
#pragma once

#include "library/c_memory.hpp"

namespace tiltrotor::c_interface {

inline constexpr int kNone = -1;

// `state`, `control`: places in tr_state, or kNone.
inline tr_fault no_fault() { return {TR_OK, kNone, kNone, 0}; }
inline tr_status noted(Sim& s, tr_status status, int state = kNone, int control = kNone) {
  if (status != TR_OK) s.fault = {static_cast<std::int32_t>(status), state, control, s.time};
  return status;
}

// The first that is no number, or kNone.
inline int first_not_finite(const R* numbers, std::size_t length) {
  for (std::size_t i = 0; i < length; ++i)
    if (!is_finite(numbers[i])) return static_cast<int>(i);
  return kNone;
}

}  // namespace tiltrotor::c_interface

// Whether two aircraft are the same to the last byte.
#pragma once

#include <cstring>

#include "tiltrotor/tiltrotor.h"

namespace capi {

// But for what tr_last_fault tells of them: the same refusal is left in a copy of each.
inline bool same_but_for_the_fault(tr_sim a, tr_sim b) {
  (void)tr_set_controls(&a, nullptr, 0);
  (void)tr_set_controls(&b, nullptr, 0);
  return std::memcmp(&a, &b, sizeof a) == 0;
}

}  // namespace capi

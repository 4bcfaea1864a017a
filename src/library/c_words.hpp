// Statuses of the analyses as statuses of the C interface.
#pragma once

#include <cstdint>

#include "tiltrotor/analysis/trim/trim_limits.hpp"
#include "tiltrotor/math/status.hpp"
#include "tiltrotor/tiltrotor.h"

namespace tiltrotor::c_interface {

tr_status translated(Status status);
tr_status translated(TrimStatus status);

// A hash continued over the bytes of a number, least significant first: FNV-1a.
template <class Unsigned>
std::uint64_t hashed(std::uint64_t hash, Unsigned bits) {
  constexpr std::uint64_t prime = 1099511628211u;
  for (unsigned k = 0; k < sizeof bits; ++k) hash = (hash ^ (std::uint64_t{bits} >> (8 * k) & 0xffu)) * prime;
  return hash;
}

}  // namespace tiltrotor::c_interface

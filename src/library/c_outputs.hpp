// Readings of the instruments as tr_outputs.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>

#include "library/c_systems.hpp"
#include "tiltrotor/analysis/flight/instruments.hpp"

namespace tiltrotor::c_interface {

// The numbers of tr_outputs are those of Instruments, in its order.
inline constexpr std::size_t kReadings = Instruments<R>::kCount;
inline constexpr std::size_t kFirstReading = offsetof(tr_outputs, airspeed_mps);
static_assert(kReadings == TR_OUTPUTS);
static_assert(offsetof(tr_outputs, rudder_rad) == kFirstReading + (kReadings - 1) * sizeof(R));

inline void put_outputs(double time, const R (&readings)[kReadings], tr_outputs& outputs) {
  outputs.time_s = time;
  std::memcpy(reinterpret_cast<unsigned char*>(&outputs) + kFirstReading, readings, sizeof readings);
}

// Whether C and, where it is wanted, D find room.
inline tr_status check_output_arrays(std::size_t states, std::size_t inputs, const OutputArrays& to) {
  const bool wants_d = to.d != nullptr || to.d_length > 0;
  if (to.c_length < kReadings * states || (wants_d && to.d_length < kReadings * inputs))
    return TR_SHORT_BUFFER;
  return to.c == nullptr || (wants_d && to.d == nullptr) ? TR_BAD_ARGUMENT : TR_OK;
}

// Outputs at the present state, and what was found for them; `c` is made. TR_NOT_FINITE: both are as computed.
tr_status outputs_here(Configuration<R>& c, const Sim& s, tr_outputs& outputs, Found& found);

inline constexpr R kFarthestStation = 1000;  // m

inline tr_status check_station(const R* station, const void* result) {
  if (station == nullptr || result == nullptr) return TR_BAD_ARGUMENT;
  for (int k = 0; k < 3; ++k) {
    if (!is_finite(station[k])) return TR_NOT_FINITE;
    if (!(std::fabs(station[k]) <= kFarthestStation)) return TR_OUT_OF_RANGE;
  }
  return TR_OK;
}

inline Vec3<R> arm_to(const Sim& s, const R* station) {
  return station_arm(s.configuration.mass, station[0], station[1], station[2]);
}

}  // namespace tiltrotor::c_interface

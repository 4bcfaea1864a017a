// Positions of the blades around the shaft where the blade-element integrals are summed.
#pragma once

#include "tiltrotor/math/differentiation/batch.hpp"

namespace tiltrotor {

inline constexpr int kMaxAzimuthStations = 72;

template <class R>
struct AzimuthStations {
  int count;
  R weight;  // blades per station
  // Beyond `count` zeros, so that blades may be computed in groups.
  R cosine[kMaxAzimuthStations + kBatchLanes<R>];
  R sine[kMaxAzimuthStations + kBatchLanes<R>];
};

// Averaged mode: `count` virtual positions, each with blades/count of a blade.
template <class R>
AzimuthStations<R> averaged_azimuth(int blades, int count) {
  AzimuthStations<R> a{};
  a.count = count;
  a.weight = static_cast<R>(blades) / static_cast<R>(count);
  for (int k = 0; k < count; ++k) {
    const R psi = R(2) * kPi<R> * (static_cast<R>(k) + R(0.5)) / static_cast<R>(count);
    a.cosine[k] = cos(psi);
    a.sine[k] = sin(psi);
  }
  return a;
}

// Individual mode: the blades themselves, the first at `azimuth` (rad).
template <class R>
void individual_azimuth(int blades, R azimuth, AzimuthStations<R>& a) {
  for (R& x : a.cosine) x = R(0);
  for (R& x : a.sine) x = R(0);
  a.count = blades;
  a.weight = R(1);
  for (int k = 0; k < blades; ++k) {
    const R psi = azimuth + R(2) * kPi<R> * static_cast<R>(k) / static_cast<R>(blades);
    a.cosine[k] = cos(psi);
    a.sine[k] = sin(psi);
  }
}

}  // namespace tiltrotor

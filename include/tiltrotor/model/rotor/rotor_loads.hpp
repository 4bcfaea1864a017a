// Loads of one rotor: the sum over its blades.
#pragma once

#include "tiltrotor/model/rotor/radial_inflow.hpp"
#include "tiltrotor/model/rotor/single_blades.hpp"

namespace tiltrotor {

// Blade-element loads of the rotor. `seeded`: number j of `in` has the partial 1 in direction j and
// no other, so that nothing need be chained to them; directions beyond belong to the rotor's conditions.
template <class T, class C, class S>
void rotor_loads(const Configuration<C>& c, const RotorConditions<S>& turn, const RotorInput<T>& in,
                 const AzimuthStations<Real<T>>& azimuth, BladeGroup<T>& blades, RotorLoads<T>& sum,
                 bool seeded = false) {
  const ElementAir<S, S> air = element_air(turn);
  const FeltInflow<T> inflow = felt_inflow(c, turn, in);
  out_of_line([&] { blades.start(turn.speed, c.pitch_flap, in, inflow); });
  constexpr int kAtOnce = BladeGroup<T>::kBlades;
  for (int k = 0; k < azimuth.count; k += kAtOnce)
    blades.add_blades(c, air, azimuth, k, azimuth.count - k < kAtOnce ? azimuth.count - k : kAtOnce);
  out_of_line([&] { blades.finish(turn.speed, c.pitch_flap, air, in, inflow, azimuth.weight, seeded, sum); });
}

}  // namespace tiltrotor

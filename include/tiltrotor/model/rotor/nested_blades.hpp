// Blades on nested dual numbers (math/differentiation/nested_dual.hpp): one after the other, each with respect to the six
// numbers of its flow, and chained. To be included before the model is used on such numbers.
#pragma once

#include "tiltrotor/math/differentiation/nested_dual.hpp"
#include "tiltrotor/model/rotor/nested_vortex_ring.hpp"
#include "tiltrotor/model/rotor/rotor.hpp"

namespace tiltrotor {

struct NestedBladeLoads {
  // Value and slope along the direction; no partials.
  template <class R, int N>
  static auto moving(const Nested<Dual<R, N>>& x) {
    return Nested<Dual<R, BladeFlow<R>::kCount>>(x.v.v, x.along.v);
  }

  template <class R, int N, class C, class Air>
  BladeLoads<Nested<Dual<R, N>>> operator()(const Configuration<C>& c, const Air& outside,
                                            const BladeFlow<Nested<Dual<R, N>>>& flow) const {
    using T = Nested<Dual<R, N>>;
    constexpr int kFlow = BladeFlow<T>::kCount;
    using Local = Nested<Dual<R, kFlow>>;
    T seen[kFlow];
    flatten(flow, seen);
    Local inside[kFlow];
    for (int j = 0; j < kFlow; ++j) {
      inside[j] = moving(seen[j]);
      inside[j].v.d.set(j, R(1));
    }
    BladeFlow<Local> local;
    unflatten(inside, local);
    const ElementAir<Local, Local> air = {moving(T(outside.density)), moving(T(outside.inverse_sound))};
    const BladeLoads<Local> sum = blade_loads(c, air, local);
    return {chain(sum.normal, seen), chain(sum.tangential, seen), chain(sum.normal_moment, seen),
            chain(sum.tangential_moment, seen)};
  }
};

template <class R, int N>
class BladeGroup<Nested<Dual<R, N>>> : public SingleBlades<Nested<Dual<R, N>>, NestedBladeLoads> {};

}  // namespace tiltrotor

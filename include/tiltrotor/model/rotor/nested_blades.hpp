// Blades on nested dual numbers (math/differentiation/nested_dual.hpp): one after the other, each with respect to the six
// numbers of its flow, and chained. To be included before the model is used on such numbers.
#pragma once

#include "tiltrotor/math/differentiation/nested_dual.hpp"
#include "tiltrotor/model/rotor/nested_vortex_ring.hpp"
#include "tiltrotor/model/rotor/rotor.hpp"

namespace tiltrotor {

template <class R, int N>
class BladeGroup<Nested<Dual<R, N>>> {
  using T = Nested<Dual<R, N>>;
  static constexpr int kFlow = BladeFlow<T>::kCount;
  using Local = Nested<Dual<R, kFlow>>;

  // Value and slope along the direction; no partials.
  static Local moving(const T& x) { return {x.v.v, x.along.v}; }

 public:
  static constexpr int kBlades = 1;
  void set_input(const RotorInput<T>&, const FeltInflow<T>&) {}
  template <class C, class Air>
  void compute_blades(const Configuration<C>&, const Air&, R, const AzimuthStations<R>&, int) {}

  template <class C, class Air>
  BladeLoads<T> loads(const Configuration<C>& c, const Air& outside, int, const BladeFlow<T>& flow) const {
    T seen[kFlow];
    flatten(flow, seen);
    Local inside[kFlow];
    for (int j = 0; j < kFlow; ++j) {
      inside[j] = moving(seen[j]);
      inside[j].v.d.set(j, R(1));
    }
    BladeFlow<Local> local;
    unflatten(inside, local);
    const ElementAir<Local, Local> air = {moving(outside.density), moving(outside.inverse_sound)};
    BladeLoads<Local> sum = {Local(R(0)), Local(R(0)), Local(R(0)), Local(R(0))};
    each_element<Local>(
        c, air, [&local](const BladeStation<R>& station) { return element_flow(local, station); },
        [&sum](const BladeStation<R>& station, const ElementLoads<Local>& element) {
          sum.normal += element.normal;
          sum.tangential += element.tangential;
          sum.normal_moment += station.radius * element.normal;
          sum.tangential_moment += station.radius * element.tangential;
        });
    return {chain(sum.normal, seen), chain(sum.tangential, seen), chain(sum.normal_moment, seen),
            chain(sum.tangential_moment, seen)};
  }
};

}  // namespace tiltrotor

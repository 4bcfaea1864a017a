// Blades at several azimuths, computed together: one in each lane of the target's vectors.
//
// The elements of these blades are nearly all the work of a rotor. They are computed on batches of plain
// numbers, with slopes along the six numbers of BladeFlow when the rotor's scalar carries partials; the
// slopes are then chained. Where the configuration carries partials as well, every blade is computed on the
// rotor's own scalar.
#pragma once

#include <complex>
#include <type_traits>

#include "tiltrotor/math/differentiation/preaccumulate.hpp"
#include "tiltrotor/model/rotor/radial_inflow.hpp"

namespace tiltrotor {

namespace blade_group_detail {

template <class R>
Batch<R> load_batch(const R* from) {
  Batch<R> p;
  for (int lane = 0; lane < Batch<R>::kLanes; ++lane) p.set(lane, from[lane]);
  return p;
}

// The same plain numbers of the rotor's input in every lane.
template <class T>
RotorInput<Batch<Real<T>>> in_every_lane(const RotorInput<T>& in) {
  RotorInput<Batch<Real<T>>> batches;
  Real<T> plain[RotorInput<T>::kCount];
  Real<T>* at = plain;
  RotorInput<T>::each(in, [&at](const T& x) { *at++ = value(x); });
  unflatten(plain, batches);
  return batches;
}

}  // namespace blade_group_detail

template <class T>
class BladeGroup {
  using R = Real<T>;
  static constexpr bool kTakesSlopes = ScalarTraits<T>::kTakesSlopes;
  using Lanes = std::conditional_t<kTakesSlopes, Dual<Batch<R>, BladeFlow<T>::kCount>, Batch<R>>;

 public:
  static constexpr int kBlades = kBatchLanes<R>;

  void set_input(const RotorInput<T>& in, const MeanInflow<T>& inflow) {
    in_ = blade_group_detail::in_every_lane(in);
    inflow_ = {Batch<R>(value(inflow.even)), Batch<R>(value(inflow.shaped))};
  }

  // Blades at the azimuths from `first`, where the configuration is plain.
  template <class C>
  void compute_blades(const Configuration<C>&, const AzimuthStations<R>&, int) {}
  void compute_blades(const Configuration<R>& c, const AzimuthStations<R>& azimuth, int first) {
    const Batch<R> cosine = blade_group_detail::load_batch(azimuth.cosine + first);
    const Batch<R> sine = blade_group_detail::load_batch(azimuth.sine + first);
    const Batch<R> flap = flap_angle(in_, cosine, sine);
    const BladeFlow<Batch<R>> flow = blade_flow(c, in_, inflow_, sin(flap), cos(flap), cosine, sine);
    if constexpr (kTakesSlopes) {
      loads_ = blade_loads_and_slopes(c, flow);
    } else {
      loads_ = blade_loads(c, flow);
    }
  }

  // Loads of one blade of the group, seeing `flow`.
  template <class C>
  BladeLoads<T> loads(const Configuration<C>& c, int lane, const BladeFlow<T>& flow) const {
    if constexpr (!kIsPlain<C>) {
      return blade_loads(c, flow);
    } else if constexpr (kTakesSlopes) {
      T flat[BladeFlow<T>::kCount];
      flatten(flow, flat);
      return {chained_lane(loads_.normal, lane, flat), chained_lane(loads_.tangential, lane, flat),
              chained_lane(loads_.normal_moment, lane, flat),
              chained_lane(loads_.tangential_moment, lane, flat)};
    } else {
      return {loads_.normal.get(lane), loads_.tangential.get(lane), loads_.normal_moment.get(lane),
              loads_.tangential_moment.get(lane)};
    }
  }

 private:
  static T chained_lane(const Lanes& load, int lane, const T* flow) {
    R slope[BladeFlow<T>::kCount];
    for (int j = 0; j < BladeFlow<T>::kCount; ++j) slope[j] = load.d.get(j).get(lane);
    return chain(load.v.get(lane), slope, flow);
  }

  RotorInput<Batch<R>> in_;
  MeanInflow<Batch<R>> inflow_;
  BladeLoads<Lanes> loads_;
};

// Complex numbers go through the blade themselves, one after the other.
template <class R>
class BladeGroup<std::complex<R>> {
  using T = std::complex<R>;

 public:
  static constexpr int kBlades = 1;
  void set_input(const RotorInput<T>&, const MeanInflow<T>&) {}
  template <class C>
  void compute_blades(const Configuration<C>&, const AzimuthStations<R>&, int) {}
  template <class C>
  BladeLoads<T> loads(const Configuration<C>& c, int, const BladeFlow<T>& flow) const {
    return blade_loads(c, flow);
  }
};

}  // namespace tiltrotor

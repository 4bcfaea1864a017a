// Blades at several azimuths, computed together: one in each lane of the target's vectors.
//
// The elements of these blades are nearly all the work of a rotor. They are computed on batches of plain
// numbers, with slopes along the six numbers of BladeFlow when the rotor's scalar carries partials; the
// slopes are then chained. Where the air carries partials as well, it makes two numbers more: its speed of sound, and its
// density, to which the loads are proportional.
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
  using Lanes = std::conditional_t<kTakesSlopes, BladeSlopes<Batch<R>>, BladeLoads<Batch<R>>>;

 public:
  static constexpr int kBlades = kBatchLanes<R>;

  void set_input(const RotorInput<T>& in, const FeltInflow<T>& inflow) {
    in_ = blade_group_detail::in_every_lane(in);
    inflow_ = {Batch<R>(value(inflow.even)), Batch<R>(value(inflow.shaped))};
  }

  // Blades at the azimuths from `first`; `omega`: rotor speed, rad/s.
  template <class C, class S>
  void compute_blades(const Configuration<C>& c, const ElementAir<S, S>& air, R omega,
                      const AzimuthStations<R>& azimuth, int first) {
    const Batch<R> cosine = blade_group_detail::load_batch(azimuth.cosine + first);
    const Batch<R> sine = blade_group_detail::load_batch(azimuth.sine + first);
    const SineCosine<Batch<R>> flap = sine_and_cosine(flap_angle(in_, cosine, sine));
    const BladeFlow<Batch<R>> flow =
        blade_flow(omega, c.pitch_flap, in_, inflow_, flap.sine, flap.cosine, cosine, sine);
    if constexpr (kTakesSlopes) {
      blade_loads_and_slopes(c, air, flow, loads_);
    } else {
      loads_ = blade_loads(c, air, flow);
    }
  }

  // Loads of one blade of the group, seeing `flow`.
  template <class C, class S>
  BladeLoads<T> loads(const Configuration<C>&, const ElementAir<S, S>& air, int lane,
                      const BladeFlow<T>& flow) const {
    if constexpr (kTakesSlopes) {
      constexpr bool kPlain = kIsPlain<S>;
      using Load = Dual<Batch<R>, BladeFlow<T>::kCount>;
      constexpr int kFlow = BladeFlow<T>::kCount;
      T seen[kPlain ? kFlow : kFlow + 2];
      flatten(flow, seen);
      if constexpr (!kPlain) {
        seen[kFlow] = air.inverse_sound;
        seen[kFlow + 1] = air.density;
      }
      const auto chained = [&](const Load& load, const Batch<R>& along_inverse_sound) {
        R slope[sizeof seen / sizeof seen[0]];
        for (int j = 0; j < kFlow; ++j) slope[j] = load.d.get(j).get(lane);
        if constexpr (!kPlain) {
          slope[kFlow] = along_inverse_sound.get(lane);
          slope[kFlow + 1] = load.v.get(lane) / value(air.density);
        }
        return chain(load.v.get(lane), slope, seen);
      };
      const BladeLoads<Load>& along = loads_.along_flow;
      const BladeLoads<Batch<R>>& sound = loads_.along_inverse_sound;
      return {chained(along.normal, sound.normal), chained(along.tangential, sound.tangential),
              chained(along.normal_moment, sound.normal_moment),
              chained(along.tangential_moment, sound.tangential_moment)};
    } else {
      return {loads_.normal.get(lane), loads_.tangential.get(lane), loads_.normal_moment.get(lane),
              loads_.tangential_moment.get(lane)};
    }
  }

 private:
  RotorInput<Batch<R>> in_;
  FeltInflow<Batch<R>> inflow_;
  Lanes loads_;
};

// Complex numbers go through the blade themselves, one after the other.
template <class R>
class BladeGroup<std::complex<R>> {
  using T = std::complex<R>;

 public:
  static constexpr int kBlades = 1;
  void set_input(const RotorInput<T>&, const FeltInflow<T>&) {}
  template <class C, class Air>
  void compute_blades(const Configuration<C>&, const Air&, R, const AzimuthStations<R>&, int) {}
  template <class C, class Air>
  BladeLoads<T> loads(const Configuration<C>& c, const Air& air, int, const BladeFlow<T>& flow) const {
    return blade_loads(c, air, flow);
  }
};

}  // namespace tiltrotor

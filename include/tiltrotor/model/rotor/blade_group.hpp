// Blades at several azimuths, computed together, one in each lane of the target's vectors, and added up.
//
// The elements of these blades are nearly all the work of a rotor. They are computed on batches of plain numbers, with
// slopes along the numbers of BladeFlow when the rotor's scalar carries partials. The slopes go back to the numbers of
// the hub (blade_view.hpp), are added up there, and are chained once. Where the air carries partials as well, it makes two
// numbers more: its speed of sound, and its density, to which the loads are proportional.
#pragma once

#include "tiltrotor/math/differentiation/preaccumulate.hpp"
#include "tiltrotor/model/rotor/blade_loads.hpp"
#include "tiltrotor/model/setup/azimuth_stations.hpp"

namespace tiltrotor {

namespace blade_group_detail {

template <class R>
Batch<R> load_batch(const R* from) {
  Batch<R> p;
  for (int lane = 0; lane < Batch<R>::kLanes; ++lane) p.set(lane, from[lane]);
  return p;
}

// sum += x of the first `blades` lanes, one after the other: the same bits whatever the number of lanes.
template <class R>
TILTROTOR_INLINE void add_lanes(const Batch<R>& x, int blades, R& sum) {
  if (blades == Batch<R>::kLanes) {
    for (int lane = 0; lane < Batch<R>::kLanes; ++lane) sum += x.get(lane);
  } else {
    for (int lane = 0; lane < blades; ++lane) sum += x.get(lane);
  }
}

}  // namespace blade_group_detail

template <class T>
class BladeGroup {
  using R = Real<T>;
  using V = Batch<R>;
  static constexpr bool kTakesSlopes = ScalarTraits<T>::kTakesSlopes;
  static constexpr int kHub = BladeHarmonics<T>::kCount;
  static constexpr int kLoads = RotorLoads<T>::kCount;
  static constexpr int kSources = BladeSources<R>::kCount;

 public:
  static constexpr int kBlades = V::kLanes;

  // No blade yet.
  template <class S>
  void start(const S& omega, R pitch_flap, const RotorInput<T>& in, const FeltInflow<T>& inflow) {
    R plain[RotorInput<T>::kCount];
    R* at = plain;
    RotorInput<T>::each(in, [&at](const T& x) { *at++ = value(x); });
    RotorInput<R> input;
    unflatten(plain, input);
    state_ = input.state;
    BladeHarmonics<R> hub;
    blade_harmonics(value(omega), pitch_flap, input, {value(inflow.even), value(inflow.shaped)}, hub);
    R number[kHub];
    flatten(hub, number);
    unflatten(number, hub_);
    for (R& x : sum_) x = R(0);
    for (auto& row : slope_)
      for (R& x : row) x = R(0);
  }

  // The next `blades` from number `first`, at most kBlades.
  template <class C, class S>
  void add_blades(const Configuration<C>& c, const ElementAir<S, S>& air, const AzimuthStations<R>& azimuth,
                  int first, int blades) {
    using blade_group_detail::add_lanes;
    const V cosine = blade_group_detail::load_batch(azimuth.cosine + first);
    const V sine = blade_group_detail::load_batch(azimuth.sine + first);
    const BladeView<V> view = blade_view(hub_, cosine, sine);
    if constexpr (!kTakesSlopes) {
      const SineCosine<V> flap = sine_and_cosine(view.flap);
      loads_ = blade_loads(c, air, blade_flow(view, flap));
      const RotorLoads<V> loads = loads_on_hub(loads_, flap, cosine, sine);
      int i = 0;
      RotorLoads<V>::each(loads, [&](const V& x) { add_lanes(x, blades, sum_[i++]); });
    } else {
      using Flap = Dual<V, 1>;
      const SineCosine<Flap> flap = sine_and_cosine(Flap::variable(view.flap, 0));
      const BladeFlow<Flap> flow = blade_flow(view, flap);
      blade_loads_and_slopes(c, air, values(flow), loads_);
      out_of_line([&] { add_slopes(flap, flow, cosine, sine, blades); });
      if constexpr (!kIsPlain<S>) {
        const RotorLoads<V> along_inverse_sound =
            loads_on_hub(loads_.along_inverse_sound, {flap.sine.v, flap.cosine.v}, cosine, sine);
        int i = 0;
        RotorLoads<V>::each(along_inverse_sound,
                            [&](const V& x) { add_lanes(x, blades, slope_[i++][kHub]); });
      }
    }
  }

  // All blades, `weight` of each. `seeded`: as in rotor_loads().
  template <class S>
  void finish(const S& omega, R pitch_flap, const ElementAir<S, S>& air, const RotorInput<T>& in,
              const FeltInflow<T>& inflow, R weight, bool seeded, RotorLoads<T>& out) {
    if constexpr (!kTakesSlopes) {
      int i = 0;
      RotorLoads<T>::each(out, [&](T& x) { x = weight * sum_[i++]; });
    } else {
      constexpr int kIn = RotorInput<T>::kCount;
      constexpr int kBeside = kIsPlain<S> ? 2 : 5;
      Listed<T, kIn> seen;
      list_places(in, seen.at);
      Listed<T, kBeside> beside;
      beside.at[0] = &inflow.even;
      beside.at[1] = &inflow.shaped;
      if constexpr (!kIsPlain<S>) {
        beside.at[2] = &omega;
        beside.at[3] = &air.inverse_sound;
        beside.at[4] = &air.density;
      }
      T* load[kLoads];
      list_places(out, load);
      for (int i = 0; i < kLoads; ++i) {
        R slope[kSources + 2];  // along BladeSources, the inverse speed of sound and the density
        find_slopes(i, value(omega), pitch_flap, weight, slope);
        if constexpr (!kIsPlain<S>) {
          slope[kSources] = weight * slope_[i][kHub];
          slope[kSources + 1] = weight * (sum_[i] / value(air.density));
        }
        T& x = *load[i];
        x = T(weight * sum_[i]);
        if (seeded) {
          x.d.copy_from(slope, kIn);
        } else {
          add_chained(x.d, std::integral_constant<int, kIn>{}, slope, seen);
        }
        add_chained(x.d, std::integral_constant<int, kBeside>{}, slope + kIn, beside);
      }
    }
  }

 private:
  using Load = BladeDual<V>;

  void add_slopes(const SineCosine<Dual<V, 1>>& flap, const BladeFlow<Dual<V, 1>>& flow, const V& cosine,
                  const V& sine, int blades) {
    using blade_group_detail::add_lanes;
    const RotorLoads<Load> on_hub =
        loads_on_hub(loads_.along_flow, {turning(flap.sine), turning(flap.cosine)}, cosine, sine);
    const Load* load[kLoads];
    list_places(on_hub, load);
    for (int i = 0; i < kLoads; ++i) {
      const Load& x = *load[i];
      add_lanes(x.v, blades, sum_[i]);
      const BladeHarmonics<V> along_hub = slopes_along_hub(
          slopes_along_view(slopes_along_flow(x), x.d.get(kAlongFlap), flow, flap.sine.v, flap.cosine.v),
          cosine, sine);
      V slope[kHub];
      flatten(along_hub, slope);
      for (int j = 0; j < kHub; ++j) add_lanes(slope[j], blades, slope_[i][j]);
    }
  }

  // Of load `i`, with its weight, along BladeSources.
  void find_slopes(int i, R omega, R pitch_flap, R weight, R* slope) const {
    BladeHarmonics<R> along_hub;
    unflatten(slope_[i], along_hub);
    flatten(slopes_along_sources(along_hub, omega, pitch_flap, state_), slope);
    for (int j = 0; j < kSources; ++j) slope[j] = weight * slope[j];
  }

  static BladeFlow<V> values(const BladeFlow<Dual<V, 1>>& flow) {
    return {flow.tangential_0.v, flow.tangential_r.v, flow.normal_0.v,
            flow.normal_r.v,     flow.shaped.v,       flow.pitch.v};
  }
  static BladeFlow<V> slopes_along_flow(const Load& x) {
    return {x.d.get(0), x.d.get(1), x.d.get(2), x.d.get(3), x.d.get(4), x.d.get(5)};
  }
  static Load turning(const Dual<V, 1>& x) {
    Load r(x.v);
    r.d.set(kAlongFlap, x.d.get(0));
    return r;
  }

  RotorState<R> state_;
  BladeHarmonics<V> hub_;
  std::conditional_t<kTakesSlopes, BladeSlopes<V>, BladeLoads<V>> loads_;
  R sum_[kLoads], slope_[kTakesSlopes ? kLoads : 1][kTakesSlopes ? kHub + 1 : 1];
};

}  // namespace tiltrotor

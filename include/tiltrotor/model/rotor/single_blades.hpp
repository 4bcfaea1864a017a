// Blades one after the other, for scalars of which no batches are made: complex numbers, nested dual numbers, those of other
// libraries.
#pragma once

#include <complex>

#include "tiltrotor/model/rotor/blade_group.hpp"

namespace tiltrotor {

// As BladeGroup. LoadsOf: loads of one blade.
template <class T, class LoadsOf>
class SingleBlades {
  using R = Real<T>;

 public:
  static constexpr int kBlades = 1;

  template <class S>
  void start(const S& omega, R pitch_flap, const RotorInput<T>& in, const FeltInflow<T>& inflow) {
    blade_harmonics(omega, pitch_flap, in, inflow, hub_);
    RotorLoads<T>::each(sum_, [](T& x) { x = T(R(0)); });
  }
  template <class C, class Air>
  void add_blades(const Configuration<C>& c, const Air& air, const AzimuthStations<R>& azimuth, int k, int) {
    const R cosine = azimuth.cosine[k], sine = azimuth.sine[k];
    const BladeView<T> view = blade_view(hub_, cosine, sine);
    const SineCosine<T> flap = sine_and_cosine(view.flap);
    const RotorLoads<T> loads = loads_on_hub(LoadsOf{}(c, air, blade_flow(view, flap)), flap, cosine, sine);
    const T* term[RotorLoads<T>::kCount];
    list_places(loads, term);
    int i = 0;
    RotorLoads<T>::each(sum_, [&](T& x) { x += *term[i++]; });
  }
  template <class S, class Air>
  void finish(const S&, R, const Air&, const RotorInput<T>&, const FeltInflow<T>&, R weight, bool,
              RotorLoads<T>& out) {
    out = sum_;
    RotorLoads<T>::each(out, [weight](T& x) { x = weight * x; });
  }

 private:
  BladeHarmonics<T> hub_;
  RotorLoads<T> sum_;
};

// Every operation on the scalar.
struct PlainBladeLoads {
  template <class T, class C, class Air>
  BladeLoads<T> operator()(const Configuration<C>& c, const Air& air, const BladeFlow<T>& flow) const {
    return blade_loads(c, air, flow);
  }
};
template <class R>
class BladeGroup<std::complex<R>> : public SingleBlades<std::complex<R>, PlainBladeLoads> {};

}  // namespace tiltrotor

// Blades for the scalars of other libraries: one after the other, every operation on the library's own
// numbers.
//
// Our own scalars compute several blades at once on plain numbers and chain their slopes
// (model/rotor/blade_group.hpp). With that the peers would differentiate next to nothing themselves.
#pragma once

#include "tiltrotor/model/rotor/blade_group.hpp"

namespace bench {

template <class T>
class SingleBlades {
 public:
  static constexpr int kBlades = 1;
  void set_input(const tiltrotor::RotorInput<T>&, const tiltrotor::FeltInflow<T>&) {}
  using Air = tiltrotor::ElementAir<double, double>;
  void compute_blades(const tiltrotor::Configuration<double>&, const Air&, double,
                      const tiltrotor::AzimuthStations<double>&, int) {}
  tiltrotor::BladeLoads<T> loads(const tiltrotor::Configuration<double>& c, const Air& air, int,
                                 const tiltrotor::BladeFlow<T>& flow) const {
    return tiltrotor::blade_loads(c, air, flow);
  }
};

}  // namespace bench

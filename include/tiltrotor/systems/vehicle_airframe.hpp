// The airframe as the vehicle flies it: its model, in the configuration that the systems have put it into.
#pragma once

#include "tiltrotor/model/derivative.hpp"
#include "tiltrotor/systems/vehicle.hpp"

namespace tiltrotor {

// `c`, prepared and in the scalar of the demand, becomes what the systems ask for. What is asked for already is not made
// again.
template <class T>
void put_into(const AirframeDemand<T>& demand, Configuration<T>& c) {
  ConfigurationSetting<T>& now = c.setup;
  const ConfigurationSetting<T>& to = demand.setting;
  bool same = kIsPlain<T>;
  if constexpr (kIsPlain<T>) {
    same = now.mast_deg == to.mast_deg && now.mast_rate == to.mast_rate &&
           now.mast_acceleration == to.mast_acceleration && now.flap_deg == to.flap_deg &&
           now.rotor_speed == to.rotor_speed && now.rotor_acceleration == to.rotor_acceleration &&
           now.altitude == to.altitude && now.mass == to.mass && now.sl_cg == to.sl_cg &&
           now.wl_cg == to.wl_cg;
  }
  if (same) {
    set_outside(c);
  } else {
    now = to;
    configure(c);
  }
  c.outside = c.outside + demand.outside;
}

// `c`: put into each demand.
template <class T>
struct VehicleAirframe {
  Configuration<T>& c;
  const State<T>& x;
  DerivativeSteps<T>& steps;
  Real<T> azimuth;

  void operator()(const AirframeDemand<T>& demand, AirframeAnswer<T>& answer) const {
    put_into(demand, c);
    derivative(c, x, demand.controls, steps, answer.rates, azimuth);
    for (const Side side : {right, left}) answer.torque[side] = steps.rotor[side].loads.torque;
  }
};

}  // namespace tiltrotor

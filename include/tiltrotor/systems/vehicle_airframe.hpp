// The airframe as the vehicle flies it: its model, in the configuration that the systems have put it into.
#pragma once

#include "tiltrotor/model/derivative.hpp"
#include "tiltrotor/systems/vehicle.hpp"

namespace tiltrotor {

// `c`, prepared and in the scalar of the demand, becomes what the systems ask for. What is asked for already is not made
// again.
template <class T>
void put_into(const AirframeDemand<T>& demand, Configuration<T>& c) {
  vehicle_parts::put_setting(demand.setting, c);
  set_outside(c);
  c.outside = c.outside + demand.gear.total;
  for (const Side side : {right, left}) c.ground_wash[side] = demand.ground.wash[side];
  c.download = demand.ground.download;
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

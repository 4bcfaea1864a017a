// What the instruments read in an aircraft with systems.
#pragma once

#include "tiltrotor/analysis/flight/instruments.hpp"
#include "tiltrotor/systems/vehicle_airframe.hpp"

namespace tiltrotor {

// Of what vehicle_rates() found; `put`: as it left the configuration. Shafts that a governor speeds up carry that as well.
template <class T>
void read_vehicle(const Vehicle<Real<T>>& v, Configuration<T>& put, const State<T>& x,
                  const DerivativeSteps<T>& found, const State<T>& rates, const SystemState<T>& system_rates,
                  Instruments<T>& out) {
  const T before[] = {put.rotor[right].spin_up, put.rotor[left].spin_up};
  put_spin_up(v, system_rates, put);
  read_instruments(put, x, found, rates, out);
  for (const Side side : {right, left}) put.rotor[side].spin_up = before[side];
}

// An aircraft with systems at one moment: where they ask for nothing, and the configuration that is put into what they
// ask for.
template <class R>
struct FlownVehicle {
  const Vehicle<R>& vehicle;
  const SystemState<R>& state;
  const ConfigurationSetting<R>& base;
  Configuration<R>& put;

  R mast_deg() const { return vehicle.on.conversion ? state.mast * kDegPerRad<R> : base.mast_deg; }
};

template <class R>
struct VehicleReadings {
  DerivativeSteps<R> steps;
  AirframeDemand<R> demand;
  AirframeAnswer<R> answer;
  VehicleFlows<R> flows;
  SystemState<R> rates;
  Instruments<R> readings;

  // One evaluation, or those of an ideal governor's search.
  void read(const FlownVehicle<R>& at, const Configuration<R>& c, const State<R>& x, const SystemState<R>& s,
            const Controls<R>& u, R azimuth) {
    vehicle_rates(at.vehicle, c, at.base, at.put, x, s, at.vehicle.commands, u,
                  VehicleAirframe<R>{at.put, x, steps, azimuth}, demand, answer, flows, rates);
    read_vehicle(at.vehicle, at.put, x, steps, answer.rates, rates, readings);
  }
};

}  // namespace tiltrotor

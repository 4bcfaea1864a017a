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
  for (const Side side : {right, left}) c.rotor[side].ground_wash = demand.ground.wash[side];
  c.download = demand.ground.download;
}

// Rates that a load causes beside those that are there: rigid_body.hpp, and of flapping state_rates.hpp.
template <class T, class C>
void add_load(const Configuration<C>& c, const Loads<T>& load, State<T>& rates) {
  using R = Real<T>;
  const Options& o = c.setup.options;
  const Inertia<C>& i = c.mass.inertia;
  const C inverse_mass = R(1) / c.mass.mass;
  const C inverse = R(1) / (i.xx * i.zz - i.xz * i.xz);
  const Vec3<T> acceleration = {inverse * (i.zz * load.moment.x + i.xz * load.moment.z),
                                (R(1) / i.yy) * load.moment.y,
                                inverse * (i.xz * load.moment.x + i.xx * load.moment.z)};
  rates.velocity = rates.velocity + inverse_mass * load.force;
  rates.rates = rates.rates + acceleration;
  if (!o.flap_angular_acceleration || o.flapping != FlapOrder::second) return;
  for (const Side side : {right, left}) {
    const Vec3<T> acceleration_a = mirror_axial(c.hub[side].from_body.apply(acceleration), side);
    rates.rotor[side].b1c_rate += acceleration_a.y;
    rates.rotor[side].b1s_rate -= acceleration_a.x;
  }
}

// `c`: put into each demand; `rotors`: rotor_expansion.hpp.
template <class T, class Rotors = AskedRotors>
struct VehicleAirframe {
  Configuration<T>& c;
  const State<T>& x;
  DerivativeSteps<T>& steps;
  Real<T> azimuth;
  Rotors rotors = {};

  void operator()(const AirframeDemand<T>& demand, AirframeAnswer<T>& answer) const {
    put_into(demand, c);
    derivative(c, x, demand.controls, rotors, azimuth, steps, answer.rates);
    for (const Side side : {right, left}) answer.torque[side] = steps.rotor[side].loads.torque;
  }
  void add(const Loads<T>& loads, State<T>& rates) const { add_load(c, loads, rates); }
};

// What the masts carry includes what speeds the rotors up, where systems do.
template <class T>
void put_spin_up(const Vehicle<Real<T>>& v, const SystemState<T>& rates, Configuration<T>& c) {
  using R = Real<T>;
  if (v.on.governor != Governor::pi) return;
  for (const Side side : {right, left})
    c.rotor[side].spin_up =
        rotor_inertia(*c.aircraft) * (rates.rotor_speed + (R(0.5) * side_sign<R>(side)) * rates.twist_rate);
}

}  // namespace tiltrotor

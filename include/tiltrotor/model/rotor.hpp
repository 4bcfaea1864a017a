// One rotor: from its hub motion, state and blade controls to loads, flap accelerations and inflow rates.
//
// Everything in the rotor frame A (frames.hpp): one routine serves both rotors. It sees RotorInput and nothing else of
// the aircraft, which makes it a waist for derivatives.
#pragma once

#include "tiltrotor/model/blade_group.hpp"
#include "tiltrotor/model/flapping.hpp"
#include "tiltrotor/model/inflow.hpp"
#include "tiltrotor/model/loads.hpp"

namespace tiltrotor {

// Sums over the blades.
template <class T>
struct RotorLoads {
  Vec3<T> force;   // on the hub, N
  T torque;        // about the shaft, absorbed, N m
  T mc, ms, m0;    // sums of r dF_n times cos psi, sin psi, 1, N m
};

template <class T>
struct RotorResponse {
  RotorLoads<T> loads;
  FlapRates<T> flapping;
  T coning_acceleration;  // rad/s^2
  InflowRates<T> inflow;

  static constexpr int kCount = 15;
  template <class Self, class Visit>
  static void each(Self& s, Visit&& visit) {
    Vec3<T>::each(s.loads.force, visit);
    visit(s.loads.torque);
    visit(s.loads.mc);
    visit(s.loads.ms);
    visit(s.loads.m0);
    visit(s.flapping.b1c_rate);
    visit(s.flapping.b1s_rate);
    visit(s.flapping.b1c_acceleration);
    visit(s.flapping.b1s_acceleration);
    visit(s.coning_acceleration);
    visit(s.inflow.n0);
    visit(s.inflow.nc);
    visit(s.inflow.ns);
  }
};

// Blade-element loads of the rotor.
template <class T>
RotorLoads<T> rotor_loads(const Configuration<Real<T>>& c, const RotorInput<T>& in,
                          const AzimuthStations<Real<T>>& azimuth) {
  using R = Real<T>;
  const T zero = T(R(0));
  RotorLoads<T> sum{{zero, zero, zero}, zero, zero, zero, zero};
  BladeGroup<T> group(c, in);
  for (int k = 0; k < azimuth.count; ++k) {
    const int lane = k % BladeGroup<T>::kBlades;
    if (lane == 0) group.compute(azimuth, k);
    const R cosine = azimuth.cosine[k];
    const R sine = azimuth.sine[k];
    const T flap = flap_angle(in, cosine, sine);
    const T sin_flap = sin(flap);
    const T cos_flap = cos(flap);
    const BladeLoads<T> blade = group.loads(lane, blade_flow(c, in, sin_flap, cos_flap, cosine, sine));
    const T radial = sin_flap * blade.normal;  // inward along the blade's projection on the disk
    sum.force.x -= cosine * radial + sine * blade.tangential;
    sum.force.y += cosine * blade.tangential - sine * radial;
    sum.force.z += cos_flap * blade.normal;
    sum.torque -= cos_flap * blade.tangential_moment;
    sum.mc += cosine * blade.normal_moment;
    sum.ms += sine * blade.normal_moment;
    sum.m0 += blade.normal_moment;
  }
  const R w = azimuth.weight;
  return {w * sum.force, w * sum.torque, w * sum.mc, w * sum.ms, w * sum.m0};
}

// What drives the inflow: load coefficients and the motion of the hub through the air.
template <class T>
InflowForcing<T> inflow_forcing(const Configuration<Real<T>>& c, const RotorInput<T>& in, const RotorLoads<T>& loads) {
  using R = Real<T>;
  const Options& o = c.setup.options;
  const RotorTables<R>& rotor = c.aircraft->rotor;
  const R inverse_tip = R(1) / c.tip_speed;
  const R inverse_force =
      R(1) / (c.air.density * kPi<R> * square(rotor.radius) * square(c.tip_speed));
  const R inverse_moment = inverse_force / rotor.radius;
  InflowForcing<T> f;
  f.mx = -(in.velocity.x * inverse_tip);
  f.my = -(in.velocity.y * inverse_tip);
  f.mz = in.velocity.z * inverse_tip;
  f.c0 = loads.force.z * inverse_force;
  f.cc = loads.mc * inverse_moment;
  f.cs = loads.ms * inverse_moment;
  if (o.side_by_side) {
    const T mu = sqrt(f.mx * f.mx + f.my * f.my + square(c.aircraft->smooth.advance_ratio));
    f.c0 = f.c0 * (R(1) + lookup(rotor.side_by_side, o.tables, mu));
  }
  if (o.sideward_flight) {
    const T sideward = smooth_abs(f.my, c.aircraft->smooth.advance_ratio);
    f.c0 = f.c0 * (R(1) + lookup(rotor.sideward, o.tables, sideward));
  }
  if (o.disk_plane_inflow) f.mz = f.mz + (f.mx * in.state.b1c + f.my * in.state.b1s);
  return f;
}

// The complete rotor. `azimuth` holds the stations to sum over: the configuration's averaged set, or the blades.
// Cost: one derivative is two of these and little more.
template <class T>
RotorResponse<T> rotor_response(const Configuration<Real<T>>& c, const RotorInput<T>& in,
                                const AzimuthStations<Real<T>>& azimuth) {
  using R = Real<T>;
  RotorResponse<T> out;
  if (c.setup.options.flapping == FlapOrder::first) {
    RotorInput<T> moving = in;
    moving.state.b1c_rate = T(R(0));
    moving.state.b1s_rate = T(R(0));
    const RotorLoads<T> still = rotor_loads(c, moving, azimuth);
    out.flapping = quasi_static_flap_rates(c, in.state, in.rates, still.mc, still.ms);
    moving.state.b1c_rate = out.flapping.b1c_rate;
    moving.state.b1s_rate = out.flapping.b1s_rate;
    out.loads = rotor_loads(c, moving, azimuth);
  } else {
    out.loads = rotor_loads(c, in, azimuth);
    out.flapping = flap_rates(c, in.state, in.rates, out.loads.mc, out.loads.ms);
  }
  out.coning_acceleration = coning_acceleration(c, in.coning, out.loads.m0);
  out.inflow = inflow_rates(c, in.state, inflow_forcing(c, in, out.loads));
  return out;
}

// Hub force and moment on the airframe, body axes about the CG: force, spring moment and torque.
// The load harmonics are balanced inside the gimbal and are not added again.
template <class T>
Loads<T> hub_loads(const Configuration<Real<T>>& c, int side, const RotorState<T>& x, const RotorLoads<T>& loads) {
  const HubFrame<Real<T>>& hub = c.hub[side];
  const Vec3<T> moment_a = {c.hub_spring * x.b1s, -(c.hub_spring * x.b1c), -loads.torque};
  Loads<T> b = force_at(hub.arm, hub.from_body.apply_inverse(mirror_polar(loads.force, side)));
  b.moment = b.moment + hub.from_body.apply_inverse(mirror_axial(moment_a, side));
  return b;
}

}  // namespace tiltrotor

// One rotor: from its hub motion, state and blade controls to loads, flap accelerations and inflow rates.
//
// Everything in the rotor frame A (frames.hpp): one routine serves both rotors. It sees RotorInput and
// nothing else of the aircraft, which makes it a waist for derivatives.
#pragma once

#include "tiltrotor/model/loads.hpp"
#include "tiltrotor/model/rotor/blade_group.hpp"
#include "tiltrotor/model/rotor/flapping.hpp"
#include "tiltrotor/model/rotor/inflow.hpp"

namespace tiltrotor {

// Sums over the blades.
template <class T>
struct RotorLoads {
  Vec3<T> force;  // on the hub, N
  T torque;       // about the shaft, absorbed, N m
  T mc, ms, m0;   // sums of r dF_n times cos psi, sin psi, 1, N m

  template <class Self, class Visit>
  static void each(Self& s, Visit&& visit) {
    Vec3<T>::each(s.force, visit);
    visit(s.torque);
    visit(s.mc);
    visit(s.ms);
    visit(s.m0);
  }
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
    RotorLoads<T>::each(s.loads, visit);
    visit(s.flapping.b1c_rate);
    visit(s.flapping.b1s_rate);
    visit(s.flapping.b1c_acceleration);
    visit(s.flapping.b1s_acceleration);
    visit(s.coning_acceleration);
    visit(s.inflow.lambda_0);
    visit(s.inflow.lambda_c);
    visit(s.inflow.lambda_s);
  }
};

// Adds the loads of the blade at one azimuth, number `lane` of its group.
template <class T>
TILTROTOR_NOINLINE void add_blade(const Configuration<Real<T>>& c, const RotorInput<T>& in, Real<T> cosine,
                                  Real<T> sine, const BladeGroup<T>& group, int lane, RotorLoads<T>& sum) {
  const T flap = flap_angle(in, cosine, sine);
  const T sin_flap = sin(flap);
  const T cos_flap = cos(flap);
  const BladeLoads<T> blade = group.loads(c, lane, blade_flow(c, in, sin_flap, cos_flap, cosine, sine));
  const T radial = sin_flap * blade.normal;  // inward along the blade's projection on the disk
  sum.force.x -= cosine * radial + sine * blade.tangential;
  sum.force.y += cosine * blade.tangential - sine * radial;
  sum.force.z += cos_flap * blade.normal;
  sum.torque -= cos_flap * blade.tangential_moment;
  sum.mc += cosine * blade.normal_moment;
  sum.ms += sine * blade.normal_moment;
  sum.m0 += blade.normal_moment;
}

// Blade-element loads of the rotor.
template <class T>
void rotor_loads(const Configuration<Real<T>>& c, const RotorInput<T>& in,
                 const AzimuthStations<Real<T>>& azimuth, BladeGroup<T>& group, RotorLoads<T>& sum) {
  using R = Real<T>;
  RotorLoads<T>::each(sum, [](T& x) { x = T(R(0)); });
  group.begin(in);
  for (int k = 0; k < azimuth.count; ++k) {
    const int lane = k % BladeGroup<T>::kBlades;
    if (lane == 0) group.compute(c, azimuth, k);
    add_blade(c, in, azimuth.cosine[k], azimuth.sine[k], group, lane, sum);
  }
  RotorLoads<T>::each(sum, [&azimuth](T& x) { x = azimuth.weight * x; });
}

template <class T>
RotorLoads<T> rotor_loads(const Configuration<Real<T>>& c, const RotorInput<T>& in,
                          const AzimuthStations<Real<T>>& azimuth) {
  BladeGroup<T> group;
  RotorLoads<T> sum;
  rotor_loads(c, in, azimuth, group, sum);
  return sum;
}

// What drives the inflow: load coefficients and the motion of the hub through the air.
template <class T>
TILTROTOR_NOINLINE InflowForcing<T> inflow_forcing(const Configuration<Real<T>>& c, const RotorInput<T>& in,
                                                   const RotorLoads<T>& loads) {
  using R = Real<T>;
  const Options& o = c.setup.options;
  const RotorTables<R>& rotor = c.aircraft->rotor;
  const R inverse_tip = R(1) / c.tip_speed;
  const R inverse_force = R(1) / (c.air.density * kPi<R> * square(rotor.radius) * square(c.tip_speed));
  const R inverse_moment = inverse_force / rotor.radius;
  InflowForcing<T> f;
  f.mu_x = -(in.velocity.x * inverse_tip);
  f.mu_y = -(in.velocity.y * inverse_tip);
  f.mu_z = in.velocity.z * inverse_tip;
  f.c0 = loads.force.z * inverse_force;
  f.cc = loads.mc * inverse_moment;
  f.cs = loads.ms * inverse_moment;
  if (o.side_by_side) {
    const T mu = sqrt(f.mu_x * f.mu_x + f.mu_y * f.mu_y + square(c.aircraft->smooth.advance_ratio));
    f.c0 = f.c0 * (R(1) + lookup(rotor.side_by_side, o.tables, mu));
  }
  if (o.sideward_flight) {
    const T sideward = smooth_abs(f.mu_y, c.aircraft->smooth.advance_ratio);
    f.c0 = f.c0 * (R(1) + lookup(rotor.sideward, o.tables, sideward));
  }
  if (o.disk_plane_inflow) f.mu_z = f.mu_z + (f.mu_x * in.state.b1c + f.mu_y * in.state.b1s);
  return f;
}

// Memory of a rotor's evaluation.
template <class T>
struct RotorWorkspace {
  BladeGroup<T> group;
  RotorInput<T> moving;  // first-order flapping alone
  RotorLoads<T> still;
};

// The steps of a rotor's evaluation are functions of their own, so that what one of them needs on the stack
// does not lie below the blade elements, which need most.
namespace rotor_detail {

template <class T>
TILTROTOR_NOINLINE void quasi_static_tilt(const Configuration<Real<T>>& c, const RotorInput<T>& in,
                                          const RotorLoads<T>& still, FlapRates<T>& out) {
  out = quasi_static_flap_rates(c, in.state, in.rates, still.mc, still.ms);
}
template <class T>
TILTROTOR_NOINLINE void second_order_tilt(const Configuration<Real<T>>& c, const RotorInput<T>& in,
                                          RotorResponse<T>& out) {
  out.flapping = flap_rates(c, in.state, in.rates, out.loads.mc, out.loads.ms);
}
template <class T>
TILTROTOR_NOINLINE void coning_and_inflow(const Configuration<Real<T>>& c, const RotorInput<T>& in,
                                          RotorResponse<T>& out) {
  out.coning_acceleration = coning_acceleration(c, in.coning, out.loads.m0);
  out.inflow = inflow_rates(c, in.state, inflow_forcing(c, in, out.loads));
}

}  // namespace rotor_detail

// First-order flapping: tilt rates in balance with the loads at rest, then the loads at those rates.
template <class T>
TILTROTOR_NOINLINE void quasi_static_rotor(const Configuration<Real<T>>& c, const RotorInput<T>& in,
                                           const AzimuthStations<Real<T>>& azimuth, RotorWorkspace<T>& room,
                                           RotorResponse<T>& out) {
  using R = Real<T>;
  room.moving = in;
  room.moving.state.b1c_rate = T(R(0));
  room.moving.state.b1s_rate = T(R(0));
  rotor_loads(c, room.moving, azimuth, room.group, room.still);
  rotor_detail::quasi_static_tilt(c, in, room.still, out.flapping);
  room.moving.state.b1c_rate = out.flapping.b1c_rate;
  room.moving.state.b1s_rate = out.flapping.b1s_rate;
  rotor_loads(c, room.moving, azimuth, room.group, out.loads);
}

// The complete rotor. `azimuth` holds the stations to sum over: the configuration's averaged set, or the
// blades. Cost: one derivative is two of these and little more.
template <class T>
void rotor_response(const Configuration<Real<T>>& c, const RotorInput<T>& in,
                    const AzimuthStations<Real<T>>& azimuth, RotorWorkspace<T>& room, RotorResponse<T>& out) {
  if (c.setup.options.flapping == FlapOrder::first) {
    quasi_static_rotor(c, in, azimuth, room, out);
  } else {
    rotor_loads(c, in, azimuth, room.group, out.loads);
    rotor_detail::second_order_tilt(c, in, out);
  }
  rotor_detail::coning_and_inflow(c, in, out);
}

template <class T>
RotorResponse<T> rotor_response(const Configuration<Real<T>>& c, const RotorInput<T>& in,
                                const AzimuthStations<Real<T>>& azimuth) {
  RotorWorkspace<T> room;
  RotorResponse<T> out;
  rotor_response(c, in, azimuth, room, out);
  return out;
}

// Hub force and moment on the airframe, body axes about the CG: force, spring moment and torque.
// The load harmonics are balanced inside the gimbal and are not added again.
template <class T>
TILTROTOR_NOINLINE Loads<T> hub_loads(const Configuration<Real<T>>& c, int side, const RotorState<T>& x,
                                      const RotorLoads<T>& loads) {
  const HubFrame<Real<T>>& hub = c.hub[side];
  const Vec3<T> moment_a = {c.hub_spring * x.b1s, -(c.hub_spring * x.b1c), -loads.torque};
  Loads<T> b = force_at(hub.arm, hub.from_body.apply_inverse(mirror_polar(loads.force, side)));
  b.moment = b.moment + hub.from_body.apply_inverse(mirror_axial(moment_a, side));
  return b;
}

}  // namespace tiltrotor

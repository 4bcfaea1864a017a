// One rotor: from its hub motion, state and blade controls to loads, flap accelerations and inflow rates.
//
// Everything in the rotor frame A (frames.hpp): one routine serves both rotors. It sees RotorInput,
// 18 numbers with respect to which it is differentiated, and its RotorConditions.
#pragma once

#include "tiltrotor/model/rotor/flapping.hpp"
#include "tiltrotor/model/rotor/inflow.hpp"
#include "tiltrotor/model/rotor/rotor_loads.hpp"
#include "tiltrotor/model/rotor/rotor_workspace.hpp"
#include "tiltrotor/model/variables/loads.hpp"

namespace tiltrotor {

template <class T>
struct RotorResponse {
  MastLoads<T> loads;
  FlapRates<T> flapping;
  T coning_acceleration;  // rad/s^2
  InflowRates<T> inflow;

  static constexpr int kCount = 12;
  template <class Self, class Visit>
  static constexpr void each(Self& s, Visit&& visit) {
    MastLoads<T>::each(s.loads, visit);
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
static_assert(lists_its_members<RotorResponse>(), "each member of RotorResponse is listed and counted");

// What drives the inflow: load coefficients and the motion of the hub through the air.
template <class T, class C, class S>
InflowForcing<T> inflow_forcing(const Configuration<C>& c, const RotorConditions<S>& turn,
                                const RotorInput<T>& in, const RotorLoads<T>& loads) {
  using R = Real<T>;
  const Options& o = c.setup.options;
  const RotorTables<R>& rotor = c.aircraft->rotor;
  const S inverse_tip = R(1) / turn.tip_speed;
  const S inverse_force = R(1) / (turn.density * kPi<R> * square(rotor.radius) * square(turn.tip_speed));
  const S inverse_moment = inverse_force / rotor.radius;
  InflowForcing<T> f;
  f.mu_x = -(in.velocity_a.x * inverse_tip);
  f.mu_y = -(in.velocity_a.y * inverse_tip);
  f.mu_z = in.velocity_a.z * inverse_tip;
  f.c0 = loads.force_a.z * inverse_force;
  f.cc = loads.mc * inverse_moment;
  f.cs = loads.ms * inverse_moment;
  if (o.side_by_side) {  // X_SS: NASA CR-166536 table 1-III, p. B-20
    const T mu = sqrt(f.mu_x * f.mu_x + f.mu_y * f.mu_y + square(c.aircraft->smooth.advance_ratio));
    f.c0 = f.c0 * (R(1) + lookup(rotor.side_by_side, o.tables, mu));
  }
  if (o.sideward_flight) {  // X_SF: table 1-II, p. B-19
    const T sideward = smooth_abs(f.mu_y, c.aircraft->smooth.advance_ratio);
    f.c0 = f.c0 * (R(1) + lookup(rotor.sideward, o.tables, sideward));
  }
  if (o.disk_plane_inflow) f.mu_z = f.mu_z + (f.mu_x * in.state.b1c + f.mu_y * in.state.b1s);
  return f;
}

// First-order flapping: tilt rates in balance with the loads of a gimbal at rest, then the loads at those
// rates.
template <class T, class C, class S>
void quasi_static_rotor(const Configuration<C>& c, const RotorConditions<S>& turn, const RotorInput<T>& in,
                        const AzimuthStations<Real<T>>& azimuth, RotorWorkspace<T>& work,
                        RotorResponse<T>& out) {
  using R = Real<T>;
  RotorInput<T>& at = work.input_at_rest;
  at = in;
  at.state.b1c_rate = T(R(0));
  at.state.b1s_rate = T(R(0));
  rotor_loads(c, turn, at, azimuth, work.blades, work.loads_at_rest);
  const RotorLoads<T>& at_rest = work.loads_at_rest;
  out_of_line(
      [&] { out.flapping = quasi_static_flap_rates(c, turn, in.state, in.rates_a, at_rest.mc, at_rest.ms); });
  at.state.b1c_rate = out.flapping.b1c_rate;
  at.state.b1s_rate = out.flapping.b1s_rate;
  rotor_loads(c, turn, at, azimuth, work.blades, work.loads);
}

// The complete rotor. `azimuth` holds the stations to sum over: the configuration's averaged set, or the
// blades. `turn`: rotor_conditions() of its side. Momentum balances all of the mean inflow, also where the ground leaves less to the
// blades.
// `seeded`: as in rotor_loads(); first-order flapping makes no use of it.
// Cost: one derivative is two of these and little more.
template <class T, class C, class S>
void rotor_response(const Configuration<C>& c, const RotorConditions<S>& turn, const RotorInput<T>& in,
                    const AzimuthStations<Real<T>>& azimuth, RotorWorkspace<T>& work, RotorResponse<T>& out,
                    bool seeded = false) {
  const bool second_order = c.setup.options.flapping == FlapOrder::second;
  if (second_order) {
    rotor_loads(c, turn, in, azimuth, work.blades, work.loads, seeded);
  } else {
    quasi_static_rotor(c, turn, in, azimuth, work, out);
  }
  out_of_line([&] {
    if (second_order) out.flapping = flap_rates(c, turn, in.state, in.rates_a, work.loads.mc, work.loads.ms);
  });
  out_of_line([&] {
    out.loads = work.loads;
    out.coning_acceleration = coning_acceleration(c, turn, in.coning, work.loads.m0);
    out.inflow = inflow_rates(c, turn, in.state, inflow_forcing(c, turn, in, work.loads));
  });
}

// Hub force and moment on the airframe, body axes about the CG: force, spring moment and the torque of the shaft.
// The load harmonics are balanced inside the gimbal and are not added again.
template <class T, class C>
Loads<T> hub_loads(const Configuration<C>& c, int side, const RotorState<T>& x, const MastLoads<T>& loads) {
  const HubFrame<C>& hub = c.hub[side];
  const Vec3<T> moment_a = {c.hub_spring * x.b1s, -(c.hub_spring * x.b1c),
                            -(loads.torque + c.rotor[side].spin_up)};
  Loads<T> loads_b = force_at(hub.arm_b, hub.from_body.apply_inverse(mirror_polar(loads.force_a, side)));
  loads_b.moment = loads_b.moment + hub.from_body.apply_inverse(mirror_axial(moment_a, side));
  return loads_b;
}

}  // namespace tiltrotor

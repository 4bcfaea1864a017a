// What the blades see of their rotor: ten numbers a blade, each a0 + ac cos psi + as sin psi of numbers of the hub.
//
// From hub to blade, and at a given flap angle from there to the flow along it, everything is linear. The transposes of
// these maps carry slopes back: blades are differentiated on plain numbers, and what they add up to is chained once for
// the whole rotor.
#pragma once

#include "tiltrotor/model/rotor/blade_element.hpp"
#include "tiltrotor/model/rotor/rotor_input.hpp"

namespace tiltrotor {

// Of the hub, in the rotor frame A; _c, _s: harmonics.
template <class T>
struct BladeHarmonics {
  T velocity_x, velocity_y;  // of the hub through the air, in the plane, m/s
  T axial;                   // of the hub along the shaft, and of the air down through the disk, m/s
  T rate_x, rate_y, spin;    // of the hub in the plane, of the rotor about the shaft, rad/s
  T flap, flap_c, flap_s;    // rad
  T flap_rate, flap_rate_c, flap_rate_s;  // of a turning blade in space, rad/s
  T inflow_c, inflow_s;                   // harmonics of the inflow over the radius, 1/s
  T shaped;                               // part of the mean inflow that follows the radial shape, m/s
  T pitch, pitch_c, pitch_s;              // at the collective's reference radius, rad

  static constexpr int kCount = 18;
  template <class Self, class Visit>
  static constexpr void each(Self& s, Visit&& visit) {
    visit(s.velocity_x);
    visit(s.velocity_y);
    visit(s.axial);
    visit(s.rate_x);
    visit(s.rate_y);
    visit(s.spin);
    visit(s.flap);
    visit(s.flap_c);
    visit(s.flap_s);
    visit(s.flap_rate);
    visit(s.flap_rate_c);
    visit(s.flap_rate_s);
    visit(s.inflow_c);
    visit(s.inflow_s);
    visit(s.shaped);
    visit(s.pitch);
    visit(s.pitch_c);
    visit(s.pitch_s);
  }
};
static_assert(lists_its_members<BladeHarmonics>(), "each member of BladeHarmonics is listed and counted");

// Of one blade. Forward: along its motion; outward: along its projection on the plane of the hub.
template <class T>
struct BladeView {
  T forward, outward, axial;  // as velocity_x, velocity_y and axial, m/s
  T rolling, spin;            // of the hub about the outward direction, of the rotor about the shaft, rad/s
  T flap, flap_rate;          // rad, rad/s
  T inflow;                   // 1/s
  T shaped;                   // m/s
  T pitch;                    // rad
};

// `omega`: rotor speed, rad/s; `pitch_flap`: pitch taken off by flapping. Cyclic pitch and signs as in NASA CR-166536,
// theta = theta75 - A1 cos psi - B1 sin psi.
template <class T, class S>
void blade_harmonics(const S& omega, Real<T> pitch_flap, const RotorInput<T>& in, const FeltInflow<T>& inflow,
                     BladeHarmonics<T>& hub) {
  const RotorState<T>& x = in.state;
  hub.velocity_x = in.velocity_a.x;
  hub.velocity_y = in.velocity_a.y;
  hub.axial = in.velocity_a.z + inflow.even;
  hub.rate_x = in.rates_a.x;
  hub.rate_y = in.rates_a.y;
  hub.spin = omega + in.rates_a.z;
  hub.flap = in.coning.angle;
  hub.flap_c = x.b1c;
  hub.flap_s = x.b1s;
  hub.flap_rate = in.coning.rate;
  hub.flap_rate_c = x.b1c_rate + omega * x.b1s - in.rates_a.y;
  hub.flap_rate_s = x.b1s_rate - omega * x.b1c + in.rates_a.x;
  hub.inflow_c = omega * x.lambda_c;
  hub.inflow_s = omega * x.lambda_s;
  hub.shaped = inflow.shaped;
  hub.pitch = in.collective;
  hub.pitch_c = -in.lateral_cyclic - pitch_flap * x.b1c;
  hub.pitch_s = -in.long_cyclic - pitch_flap * x.b1s;
}

// What the hub's numbers are made of.
template <class T>
struct BladeSources {
  RotorInput<T> in;
  FeltInflow<T> inflow;
  T omega;

  static constexpr int kCount = RotorInput<T>::kCount + 3;
  template <class Self, class Visit>
  static constexpr void each(Self& s, Visit&& visit) {
    RotorInput<T>::each(s.in, visit);
    visit(s.inflow.even);
    visit(s.inflow.shaped);
    visit(s.omega);
  }
};
static_assert(lists_its_members<BladeSources>(), "each member of BladeSources is listed and counted");

// Slopes along the sources, of those along the hub's numbers: the transpose of the differential of blade_harmonics().
template <class R>
BladeSources<R> slopes_along_sources(const BladeHarmonics<R>& hub, const R& omega, R pitch_flap,
                                     const RotorState<R>& x) {
  BladeSources<R> of;
  of.in.velocity_a = {hub.velocity_x, hub.velocity_y, hub.axial};
  of.in.rates_a = {hub.rate_x + hub.flap_rate_s, hub.rate_y - hub.flap_rate_c, hub.spin};
  of.in.state = {hub.flap_c - omega * hub.flap_rate_s - pitch_flap * hub.pitch_c,
                 hub.flap_s + omega * hub.flap_rate_c - pitch_flap * hub.pitch_s,
                 hub.flap_rate_c,
                 hub.flap_rate_s,
                 R(0),
                 omega * hub.inflow_c,
                 omega * hub.inflow_s};
  of.in.coning = {hub.flap, hub.flap_rate};
  of.in.collective = hub.pitch;
  of.in.lateral_cyclic = -hub.pitch_c;
  of.in.long_cyclic = -hub.pitch_s;
  of.inflow = {hub.axial, hub.shaped};
  of.omega = hub.spin + x.b1s * hub.flap_rate_c - x.b1c * hub.flap_rate_s + x.lambda_c * hub.inflow_c +
             x.lambda_s * hub.inflow_s;
  return of;
}

// `cosine`, `sine`: of the azimuth, plain numbers or of a batch of blades.
template <class T, class Plain>
BladeView<T> blade_view(const BladeHarmonics<T>& hub, const Plain& cosine, const Plain& sine) {
  BladeView<T> view;
  view.forward = hub.velocity_y * cosine - hub.velocity_x * sine;
  view.outward = hub.velocity_x * cosine + hub.velocity_y * sine;
  view.axial = hub.axial;
  view.rolling = hub.rate_x * cosine + hub.rate_y * sine;
  view.spin = hub.spin;
  view.flap = hub.flap + hub.flap_c * cosine + hub.flap_s * sine;
  view.flap_rate = hub.flap_rate + hub.flap_rate_c * cosine + hub.flap_rate_s * sine;
  view.inflow = hub.inflow_c * cosine + hub.inflow_s * sine;
  view.shaped = hub.shaped;
  view.pitch = hub.pitch + hub.pitch_c * cosine + hub.pitch_s * sine;
  return view;
}

// Slopes along the hub's numbers, of those along the view: the transpose of blade_view().
template <class V>
BladeHarmonics<V> slopes_along_hub(const BladeView<V>& view, const V& cosine, const V& sine) {
  BladeHarmonics<V> hub;
  hub.velocity_x = cosine * view.outward - sine * view.forward;
  hub.velocity_y = cosine * view.forward + sine * view.outward;
  hub.axial = view.axial;
  hub.rate_x = cosine * view.rolling;
  hub.rate_y = sine * view.rolling;
  hub.spin = view.spin;
  hub.flap = view.flap;
  hub.flap_c = cosine * view.flap;
  hub.flap_s = sine * view.flap;
  hub.flap_rate = view.flap_rate;
  hub.flap_rate_c = cosine * view.flap_rate;
  hub.flap_rate_s = sine * view.flap_rate;
  hub.inflow_c = cosine * view.inflow;
  hub.inflow_s = sine * view.inflow;
  hub.shaped = view.shaped;
  hub.pitch = view.pitch;
  hub.pitch_c = cosine * view.pitch;
  hub.pitch_s = sine * view.pitch;
  return hub;
}

// Flow along the blade, no small angles. Derived here: velocity of a point at radius r of a blade at flap angle b, less
// that of the induced air, along the direction of rotation and the blade normal. `flap`: of view.flap.
template <class T, class X>
BladeFlow<T> blade_flow(const BladeView<X>& view, const SineCosine<T>& flap) {
  BladeFlow<T> flow;
  flow.tangential_0 = view.forward;
  flow.tangential_r = flap.cosine * view.spin - flap.sine * view.rolling;
  flow.normal_0 = flap.cosine * view.axial - flap.sine * view.outward;
  flow.normal_r = view.flap_rate + flap.cosine * view.inflow;
  flow.shaped = flap.cosine * view.shaped;
  flow.pitch = view.pitch;
  return flow;
}

// Slopes along the view, of those along the flow and the flap angle: the transpose of blade_flow(). `flow`: with its
// slopes along the flap angle.
template <class V>
BladeView<V> slopes_along_view(const BladeFlow<V>& along, const V& along_flap,
                               const BladeFlow<Dual<V, 1>>& flow, const V& sin_flap, const V& cos_flap) {
  const auto turned = [](const Dual<V, 1>& x) { return x.d.get(0); };
  BladeView<V> view;
  view.forward = along.tangential_0;
  view.outward = -(sin_flap * along.normal_0);
  view.axial = cos_flap * along.normal_0;
  view.rolling = -(sin_flap * along.tangential_r);
  view.spin = cos_flap * along.tangential_r;
  view.flap = along_flap + turned(flow.tangential_r) * along.tangential_r +
              turned(flow.normal_0) * along.normal_0 + turned(flow.normal_r) * along.normal_r +
              turned(flow.shaped) * along.shaped;
  view.flap_rate = along.normal_r;
  view.inflow = cos_flap * along.normal_r;
  view.shaped = cos_flap * along.shaped;
  view.pitch = along.pitch;
  return view;
}

}  // namespace tiltrotor

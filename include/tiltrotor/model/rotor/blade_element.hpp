// Aerodynamic load of one blade element and of one blade.
//
// At a given azimuth the flow along a blade is linear in radius but for the mean inflow, whose shape is fixed:
// six numbers describe it whatever the state of the aircraft: BladeFlow. A blade is differentiated with respect
// to these six, an element with respect to the three of ElementFlow.
#pragma once

#include "tiltrotor/math/differentiation/batch.hpp"
#include "tiltrotor/model/rotor/blade_section.hpp"
#include "tiltrotor/model/rotor/stall_delay.hpp"
#include "tiltrotor/model/setup/configuration.hpp"

namespace tiltrotor {

// Flow seen by one blade: U_T = tangential_0 + r tangential_r (positive onto the leading edge),
// U_P = normal_0 + r normal_r + shape(r) shaped (positive from above), and its pitch at the collective's
// reference radius.
template <class T>
struct BladeFlow {
  T tangential_0, tangential_r;  // m/s, 1/s
  T normal_0, normal_r;          // m/s, 1/s
  T shaped;                      // m/s, the part that follows BladeStation::inflow_shape
  T pitch;                       // rad

  static constexpr int kCount = 6;
  template <class Self, class Visit>
  static constexpr void each(Self& s, Visit&& visit) {
    visit(s.tangential_0);
    visit(s.tangential_r);
    visit(s.normal_0);
    visit(s.normal_r);
    visit(s.shaped);
    visit(s.pitch);
  }
};
static_assert(lists_its_members<BladeFlow>(), "each member of BladeFlow is listed and counted");

// Loads of one blade: along the blade normal (up) and the direction of rotation, and their first radial
// moments.
template <class T>
struct BladeLoads {
  T normal, tangential;                // N
  T normal_moment, tangential_moment;  // N m

  static constexpr int kCount = 4;
  template <class Self, class Visit>
  static constexpr void each(Self& s, Visit&& visit) {
    visit(s.normal);
    visit(s.tangential);
    visit(s.normal_moment);
    visit(s.tangential_moment);
  }
};
static_assert(lists_its_members<BladeLoads>(), "each member of BladeLoads is listed and counted");

// Flow at one element: three numbers, whatever lies behind them.
template <class T>
struct ElementFlow {
  T tangential, normal;  // U_T, U_P, m/s
  T pitch;               // rad
};

// Air at the elements. Plain numbers, or with partials of their own.
template <class Density, class Sound>
struct ElementAir {
  Density density;      // kg/m^3
  Sound inverse_sound;  // one over the speed of sound, s/m
};
template <class S>
ElementAir<S, S> element_air(const S& density, const S& speed_of_sound) {
  return {density, Real<S>(1) / speed_of_sound};
}
template <class S>
ElementAir<S, S> element_air(const RotorConditions<S>& at) {
  return element_air(at.density, at.speed_of_sound);
}

template <class T>
struct ElementLoads {
  T normal, tangential;  // N
};

// Valid in reverse flow: the angle of attack runs over the full circle.
template <class T, class C, class Air>
TILTROTOR_INLINE ElementLoads<T> element_loads(const Configuration<C>& c, int region,
                                               const BladeStation<Real<T>>& station, const Air& air,
                                               const ElementFlow<T>& flow) {
  const T& ut = flow.tangential;
  const T& up = flow.normal;
  const T speed = sqrt(T(ut * ut + up * up + square(c.aircraft->smooth.section_speed)));
  const T alpha = wrapped_difference(flow.pitch, atan2(up, ut));
  const SectionCoefficients<T> k = section_coefficients(c.aircraft->rotor, c.setup.options.tables, region,
                                                        alpha, T(speed * air.inverse_sound));
  // Blade-element theory, derived here without small angles; half_chord_dr = c dr/2.
  // dF_n = 1/2 rho U c dr (cl U_T - cd U_P),  dF_t = -1/2 rho U c dr (cl U_P + cd U_T)
  const T scale = (air.density * station.half_chord_dr) * speed;
  T lift = station.lift_weight * k.lift;
  if (c.setup.options.stall_delay)
    lift +=
        (station.lift_weight * kept_by_rotation(c, station)) * lift_lost_by_stall(c, region, alpha, k.lift);
  return {scale * (lift * ut - k.drag * up), -(scale * (lift * up + k.drag * ut))};
}

// Calls see(station, loads) for every element of one blade, from the root to the tip. `flow_at(station)`: its
// flow.
template <class T, class C, class Air, class FlowAt, class See>
TILTROTOR_INLINE void each_element(const Configuration<C>& c, const Air& air, FlowAt&& flow_at, See&& see) {
  int i = 0;
  for (int region = 0; region < kSectionRegions; ++region) {
    for (; i < c.blade.region_end[region]; ++i) {
      const BladeStation<Real<T>>& station = c.blade.station[i];
      see(station, element_loads<T>(c, region, station, air, flow_at(station)));
    }
  }
}

template <class T>
ElementFlow<T> element_flow(const BladeFlow<T>& flow, const BladeStation<Real<T>>& station) {
  return {flow.tangential_0 + station.radius * flow.tangential_r,
          flow.normal_0 + station.radius * flow.normal_r + station.inflow_shape * flow.shaped,
          flow.pitch + station.twist};
}

// Sum over the stations of one blade.
template <class T, class C, class Air>
BladeLoads<T> blade_loads(const Configuration<C>& c, const Air& air, const BladeFlow<T>& flow) {
  using R = Real<T>;
  BladeLoads<T> sum{T(R(0)), T(R(0)), T(R(0)), T(R(0))};
  each_element<T>(
      c, air, [&flow](const BladeStation<R>& station) { return element_flow(flow, station); },
      [&sum](const BladeStation<R>& station, const ElementLoads<T>& element) {
        sum.normal += element.normal;
        sum.tangential += element.tangential;
        sum.normal_moment += station.radius * element.normal;
        sum.tangential_moment += station.radius * element.tangential;
      });
  return sum;
}

// Directions of a blade's loads: the numbers of its flow, and its flap angle, which turns them.
template <class V>
using BladeDual = Dual<V, BladeFlow<V>::kCount + 1>;
inline constexpr int kAlongFlap = BladeFlow<double>::kCount;

// Loads of one blade with their slopes, and where the air carries partials those along the inverse speed of sound.
template <class V>
struct BladeSlopes {
  BladeLoads<BladeDual<V>> along_flow;
  BladeLoads<V> along_inverse_sound;  // not set for plain air
};

// U_T and U_P are linear in the radius and in its inflow shape, so the slopes of the sums are moments of the
// slopes of the elements, which have three, or four. None along the flap angle.
template <class V, class C, class S>
void blade_loads_and_slopes(const Configuration<C>& c, const ElementAir<S, S>& around,
                            const BladeFlow<V>& flow, BladeSlopes<V>& out) {
  using R = Real<V>;
  constexpr bool kPlain = kIsPlain<S>;
  constexpr int kSound = 3;
  using D = Dual<V, kPlain ? 3 : 4>;
  const auto air = [&around] {
    if constexpr (kPlain) {
      return around;
    } else {
      return ElementAir<R, D>{value(around.density), D::variable(V(value(around.inverse_sound)), kSound)};
    }
  }();
  D normal[3] = {D(V(R(0))), D(V(R(0))), D(V(R(0)))};  // sums of the load times 1, r, r^2
  D tangential[3] = {D(V(R(0))), D(V(R(0))), D(V(R(0)))};
  V normal_shaped[2] = {V(R(0)), V(R(0))};  // sums of the slope along U_P times shape, r shape
  V tangential_shaped[2] = {V(R(0)), V(R(0))};
  each_element<D>(
      c, air,
      [&flow](const BladeStation<R>& station) {
        const ElementFlow<V> at = element_flow(flow, station);
        return ElementFlow<D>{D::variable(at.tangential, 0), D::variable(at.normal, 1),
                              D::variable(at.pitch, 2)};
      },
      [&](const BladeStation<R>& station, const ElementLoads<D>& element) {
        const V weight[3] = {V(R(1)), V(station.radius), V(station.radius * station.radius)};
        for (int k = 0; k < 3; ++k) {
          normal[k] += weight[k] * element.normal;
          tangential[k] += weight[k] * element.tangential;
        }
        const V shape[2] = {V(station.inflow_shape), V(station.radius * station.inflow_shape)};
        for (int k = 0; k < 2; ++k) {
          normal_shaped[k] += shape[k] * element.normal.d.get(1);
          tangential_shaped[k] += shape[k] * element.tangential.d.get(1);
        }
      });
  const auto with_slopes = [](const D* moment, const V& shaped) {
    BladeDual<V> r(moment[0].v);
    const V slopes[] = {
        moment[0].d.get(0), moment[1].d.get(0), moment[0].d.get(1), moment[1].d.get(1), shaped,
        moment[0].d.get(2)};
    for (int j = 0; j < BladeFlow<V>::kCount; ++j) r.d.set(j, slopes[j]);
    return r;
  };
  out.along_flow = {with_slopes(normal, normal_shaped[0]), with_slopes(tangential, tangential_shaped[0]),
                    with_slopes(normal + 1, normal_shaped[1]),
                    with_slopes(tangential + 1, tangential_shaped[1])};
  if constexpr (!kPlain)
    out.along_inverse_sound = {normal[0].d.get(kSound), tangential[0].d.get(kSound), normal[1].d.get(kSound),
                               tangential[1].d.get(kSound)};
}

}  // namespace tiltrotor

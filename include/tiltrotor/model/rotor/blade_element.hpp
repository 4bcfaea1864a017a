// Aerodynamic load of one blade element and of one blade.
//
// At a given azimuth the flow along a blade is linear in radius but for the mean inflow, whose shape is fixed:
// six numbers describe it whatever the state of the aircraft: BladeFlow. A blade is differentiated with respect
// to these six, an element with respect to the three of ElementFlow.
#pragma once

#include "tiltrotor/math/differentiation/batch.hpp"
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

template <class T>
struct SectionCoefficients {
  T lift, drag;
};

// Section coefficients at angle of attack `alpha` (rad, -pi..pi) and Mach number: the table of the spanwise
// region inside its range of alpha, blended over `stall_blend` degrees to a flat plate outside. Beyond the
// last Mach column the column holds. Lift and drag share the search along the axes they have in common.
template <class T>
TILTROTOR_INLINE SectionCoefficients<T> section_coefficients(const RotorTables<Real<T>>& rotor,
                                                             Interpolation mode, int region, const T& alpha,
                                                             const T& mach) {
  using R = Real<T>;
  const Table<R, 2>& lift = rotor.section_lift[region];
  const Table<R, 2>& drag = rotor.section_drag[region];
  const T alpha_deg = alpha * kDegPerRad<R>;
  Bracket<T> at_alpha = bracket_on_grid(lift.smooth[0], mode, alpha_deg);
  Bracket<T> at_mach = bracket_on_grid(lift.smooth[1], mode, mach);
  const bool outside = any(at_alpha.outside | at_mach.outside);
  if (outside) {
    fade_outside(lift.smooth[0], mode, at_alpha);
    fade_outside(lift.smooth[1], mode, at_mach);
  }
  SectionCoefficients<T> c;
  c.lift = lookup(lift, at_alpha, at_mach);
  Bracket<T> drag_alpha = at_alpha;
  Bracket<T> drag_mach = at_mach;
  if (drag.smooth[0].knot != lift.smooth[0].knot) drag_alpha = bracket(drag.smooth[0], mode, alpha_deg);
  if (drag.smooth[1].knot != lift.smooth[1].knot) drag_mach = bracket(drag.smooth[1], mode, mach);
  c.drag = lookup(drag, drag_alpha, drag_mach);

  const Axis<R>& range = lift.smooth[0];
  const R low_deg = range.knot[0];
  const R high_deg = range.knot[range.count - 1];
  const auto a = value(alpha_deg);
  if (!outside) return c;  // the blend starts with zero slope and curvature at the ends
  const T beyond = select(a >= high_deg, T(alpha_deg - high_deg), T(low_deg - alpha_deg));
  const T plate = smooth_step(T(beyond * (R(1) / rotor.stall_blend)));
  // Flat plate beyond stall, cl = 1.1 sin 2 alpha, cd = 0.02 + 1.9 sin^2 alpha: choices.csv, plate_*.
  const T sine = sin(alpha);
  const T plate_lift = R(2) * rotor.plate_lift * sine * cos(alpha);
  const T plate_drag = rotor.plate_drag_min + rotor.plate_drag * sine * sine;
  c.lift = c.lift + plate * (plate_lift - c.lift);
  c.drag = c.drag + plate * (plate_drag - c.drag);
  return c;
}

// Flow at one element: three numbers, whatever lies behind them.
template <class T>
struct ElementFlow {
  T tangential, normal;  // U_T, U_P, m/s
  T pitch;               // rad
};

template <class T>
struct ElementLoads {
  T normal, tangential;  // N
};

// Valid in reverse flow: the angle of attack runs over the full circle.
template <class T, class C>
TILTROTOR_INLINE ElementLoads<T> element_loads(const Configuration<C>& c, int region,
                                               const BladeStation<Real<T>>& station,
                                               const ElementFlow<T>& flow) {
  using R = Real<T>;
  const T& ut = flow.tangential;
  const T& up = flow.normal;
  const T speed = sqrt(T(ut * ut + up * up + square(c.aircraft->smooth.section_speed)));
  const T alpha = wrapped_difference(flow.pitch, atan2(up, ut));
  const SectionCoefficients<T> k = section_coefficients(c.aircraft->rotor, c.setup.options.tables, region,
                                                        alpha, T(speed * (R(1) / c.air.speed_of_sound)));
  // Blade-element theory, derived here without small angles; half_chord_dr = c dr/2.
  // dF_n = 1/2 rho U c dr (cl U_T - cd U_P),  dF_t = -1/2 rho U c dr (cl U_P + cd U_T)
  const T scale = (c.air.density * station.half_chord_dr) * speed;
  T lift = station.lift_weight * k.lift;
  if (c.setup.options.stall_delay)
    lift +=
        (station.lift_weight * kept_by_rotation(c, station)) * lift_lost_by_stall(c, region, alpha, k.lift);
  return {scale * (lift * ut - k.drag * up), -(scale * (lift * up + k.drag * ut))};
}

// Calls see(station, loads) for every element of one blade, from the root to the tip. `flow_at(station)`: its
// flow.
template <class T, class C, class FlowAt, class See>
TILTROTOR_INLINE void each_element(const Configuration<C>& c, FlowAt&& flow_at, See&& see) {
  int i = 0;
  for (int region = 0; region < kSectionRegions; ++region) {
    for (; i < c.blade.region_end[region]; ++i) {
      const BladeStation<Real<T>>& station = c.blade.station[i];
      see(station, element_loads<T>(c, region, station, flow_at(station)));
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
template <class T, class C>
BladeLoads<T> blade_loads(const Configuration<C>& c, const BladeFlow<T>& flow) {
  using R = Real<T>;
  BladeLoads<T> sum{T(R(0)), T(R(0)), T(R(0)), T(R(0))};
  each_element<T>(
      c, [&flow](const BladeStation<R>& station) { return element_flow(flow, station); },
      [&sum](const BladeStation<R>& station, const ElementLoads<T>& element) {
        sum.normal += element.normal;
        sum.tangential += element.tangential;
        sum.normal_moment += station.radius * element.normal;
        sum.tangential_moment += station.radius * element.tangential;
      });
  return sum;
}

// The same with its slopes along the six numbers of the flow. U_T and U_P are linear in the radius and in its
// inflow shape, so the slopes of the sums are moments of the slopes of the elements, which have three.
template <class V, class C>
BladeLoads<Dual<V, BladeFlow<V>::kCount>> blade_loads_and_slopes(const Configuration<C>& c,
                                                                 const BladeFlow<V>& flow) {
  using R = Real<V>;
  using D = Dual<V, 3>;
  D normal[3] = {D(V(R(0))), D(V(R(0))), D(V(R(0)))};  // sums of the load times 1, r, r^2
  D tangential[3] = {D(V(R(0))), D(V(R(0))), D(V(R(0)))};
  V normal_shaped[2] = {V(R(0)), V(R(0))};  // sums of the slope along U_P times shape, r shape
  V tangential_shaped[2] = {V(R(0)), V(R(0))};
  each_element<D>(
      c,
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
    Dual<V, BladeFlow<V>::kCount> r(moment[0].v);
    const V slopes[] = {
        moment[0].d.get(0), moment[1].d.get(0), moment[0].d.get(1), moment[1].d.get(1), shaped,
        moment[0].d.get(2)};
    for (int j = 0; j < BladeFlow<V>::kCount; ++j) r.d.set(j, slopes[j]);
    return r;
  };
  return {with_slopes(normal, normal_shaped[0]), with_slopes(tangential, tangential_shaped[0]),
          with_slopes(normal + 1, normal_shaped[1]), with_slopes(tangential + 1, tangential_shaped[1])};
}

}  // namespace tiltrotor

// Stations of the blade where the blade-element integrals are summed.
#pragma once

#include "tiltrotor/math/bracketed_root.hpp"
#include "tiltrotor/model/aircraft/aircraft.hpp"
#include "tiltrotor/model/setup/azimuth_stations.hpp"
#include "tiltrotor/model/setup/quadrature.hpp"
#include "tiltrotor/model/variables/options.hpp"

namespace tiltrotor {

inline constexpr int kMaxBladeStations = 80;

// One blade element: everything about it that does not change in flight.
template <class R>
struct BladeStation {
  R radius;         // m
  R half_chord_dr;  // chord times quadrature width over two, m^2: half density times this is the load scale
  R twist;          // pitch above that at the collective's reference radius, rad
  R lift_weight;    // 1 inside the tip-loss radius, 0 outside
  R inflow_shape;   // mean inflow here over its value lambda_0, less one: radial_inflow.hpp
};

template <class R>
struct BladeStations {
  int count;
  int region_end[kSectionRegions];  // stations of section region k end before region_end[k]
  BladeStation<R> station[kMaxBladeStations];
};

template <class R>
R blade_twist(const RotorTables<R>& rotor, TwistSource source, R x) {
  if (source == TwistSource::linear) return rotor.twist_linear * (x - rotor.twist_reference);
  return lookup(rotor.twist, Interpolation::linear, x) -
         lookup(rotor.twist, Interpolation::linear, rotor.twist_reference);
}

// Lift of a section before stall: `slope` per deg above `zero_deg`, at the lowest Mach number of its table.
template <class R>
struct PotentialLift {
  R zero_deg, slope;
};

template <class R>
PotentialLift<R> potential_lift(const RotorTables<R>& rotor, int region) {
  const Table<R, 2>& table = rotor.section_lift[region];
  const R mach = table.smooth[1].knot[0];
  const auto lift = [&](R alpha_deg) { return lookup(table, Interpolation::linear, alpha_deg, mach); };
  const R span = R(4);  // deg
  const R zero = bracketed_root(lift, -span, span, R(1e-6));
  return {zero, lift(zero + span) / span};
}

template <class R>
R blade_chord(const RotorTables<R>& rotor, ChordSource source, R x) {
  const Table<R, 1>& table = source == ChordSource::cutout ? rotor.chord_cutout
                             : source == ChordSource::text ? rotor.chord_text
                                                           : rotor.chord_camrad;
  return lookup(table, Interpolation::linear, x);
}

// Twist that the stations of one part of an interval see. The table has steps of rounding between its close
// knots, which few stations would meet at random. They see instead the polynomial that, weighed with the
// square of the radius, differs least from the table (degree one less than the points): the lift of the part
// is then that of the table.
template <class R>
void smoothed_twist(const RotorTables<R>& rotor, TwistSource source, R inner, R outer, const GaussRule& rule,
                    int points, R* twist) {
  constexpr int samples = 64;
  constexpr int most = kMaxGaussPoints;
  R basis[samples][most];  // polynomials made orthogonal under the weight, one after the other
  R at_point[most][most];
  for (int i = 0; i < points; ++i) twist[i] = R(0);
  for (int degree = 0; degree < points; ++degree) {
    const auto monomial = [degree](R t) {
      R power = R(1);
      for (int k = 0; k < degree; ++k) power *= t;
      return power;
    };
    const auto place = [](int s) { return (static_cast<R>(s) + R(0.5)) / static_cast<R>(samples); };
    const auto weight = [&](int s) { return square(inner + (outer - inner) * place(s)); };
    for (int s = 0; s < samples; ++s) basis[s][degree] = monomial(place(s));
    for (int i = 0; i < points; ++i) at_point[i][degree] = monomial(static_cast<R>(rule.x[i]));
    const auto project_out = [&](int lower) {
      R along = R(0);
      R size = R(0);
      for (int s = 0; s < samples; ++s) {
        along += weight(s) * basis[s][degree] * basis[s][lower];
        size += weight(s) * square(basis[s][lower]);
      }
      for (int s = 0; s < samples; ++s) basis[s][degree] -= along / size * basis[s][lower];
      for (int i = 0; i < points; ++i) at_point[i][degree] -= along / size * at_point[i][lower];
    };
    for (int lower = 0; lower < degree; ++lower) project_out(lower);
    R along = R(0);
    R size = R(0);
    for (int s = 0; s < samples; ++s) {
      along += weight(s) * basis[s][degree] * blade_twist(rotor, source, inner + (outer - inner) * place(s));
      size += weight(s) * square(basis[s][degree]);
    }
    for (int i = 0; i < points; ++i) twist[i] += along / size * at_point[i][degree];
  }
}

// Radial stations of a quadrature; `refinement` multiplies their number, by that many equal parts of each
// interval.
template <class R>
BladeStations<R> blade_stations(const RotorTables<R>& rotor, const Options& options,
                                const Quadrature& quadrature, int refinement) {
  const bool joined = quadrature.radial[0] == 0;
  const R edge[kBladeIntervals + 1] = {rotor.root_cutout,
                                       joined ? rotor.root_cutout : rotor.taper_end,
                                       rotor.region_edge[0],
                                       rotor.region_edge[1],
                                       rotor.region_edge[2],
                                       rotor.tip_loss,
                                       R(1)};
  const int region_of_interval[kBladeIntervals] = {0, 0, 1, 2, 3, 3};
  const bool gauss = quadrature.rule == RadialRule::gauss;
  BladeStations<R> stations{};
  for (int k = joined ? 1 : 0; k < kBladeIntervals; ++k) {
    const int parts = gauss ? refinement : refinement * quadrature.radial[k];
    const int points = gauss ? quadrature.radial[k] : 1;
    const GaussRule& rule = kGauss[points - 1];
    const R width = (edge[k + 1] - edge[k]) / static_cast<R>(parts);
    for (int part = 0; part < parts; ++part) {
      const R inner = edge[k] + width * static_cast<R>(part);
      R twist[kMaxGaussPoints];
      if (gauss) smoothed_twist(rotor, options.twist, inner, inner + width, rule, points, twist);
      for (int i = 0; i < points; ++i) {
        const R x = inner + width * static_cast<R>(rule.x[i]);
        BladeStation<R>& s = stations.station[stations.count++];
        s.radius = x * rotor.radius;
        s.half_chord_dr = R(0.5) * blade_chord(rotor, options.chord, x) *
                          (width * static_cast<R>(rule.weight[i]) * rotor.radius);
        s.twist = gauss ? twist[i] : blade_twist(rotor, options.twist, x);
        s.lift_weight = x < rotor.tip_loss ? R(1) : R(0);
      }
    }
    stations.region_end[region_of_interval[k]] = stations.count;
  }
  return stations;
}

template <class R>
BladeStations<R> blade_stations(const RotorTables<R>& rotor, const Options& options) {
  return blade_stations(rotor, options, quadrature(options.grid), options.grid_refinement);
}

// Azimuth stations of the averaged mode under a set of options.
inline int azimuth_count(const Options& options) {
  return options.azimuth_stations > 0 ? options.azimuth_stations : quadrature(options.grid).azimuth;
}

}  // namespace tiltrotor

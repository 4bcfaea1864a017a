// Stations of the blade and azimuth where the blade-element integrals are summed.
#pragma once

#include "tiltrotor/math/pack.hpp"
#include "tiltrotor/model/aircraft.hpp"
#include "tiltrotor/model/options.hpp"

namespace tiltrotor {

inline constexpr int kMaxBladeStations = 80;
inline constexpr int kMaxAzimuthStations = 72;

// One blade element: everything about it that does not change in flight.
template <class R>
struct BladeStation {
  R radius;       // m
  R half_chord_dr;  // chord times quadrature width over two, m^2: half density times this is the load scale
  R twist;        // pitch above that at the collective's reference radius, rad
  R lift_weight;  // 1 inside the tip-loss radius, 0 outside
};

template <class R>
struct BladeStations {
  int count;
  int region_end[kSectionRegions];  // stations of section region k end before region_end[k]
  BladeStation<R> station[kMaxBladeStations];
};

template <class R>
struct AzimuthStations {
  int count;
  R weight;  // blades per station
  // Beyond `count` zeros, so that blades may be computed in groups.
  R cosine[kMaxAzimuthStations + kPackLanes<R>];
  R sine[kMaxAzimuthStations + kPackLanes<R>];
};

namespace detail {

template <class R>
struct BladeInterval {
  R inner, outer;  // r/R
  int region;
};

}  // namespace detail

template <class R>
R blade_twist(const RotorTables<R>& rotor, TwistSource source, R x) {
  if (source == TwistSource::linear) return rotor.twist_linear * (x - rotor.twist_reference);
  return lookup(rotor.twist, Interpolation::linear, x) -
         lookup(rotor.twist, Interpolation::linear, rotor.twist_reference);
}

template <class R>
R blade_chord(const RotorTables<R>& rotor, ChordSource source, R x) {
  const Table<R, 1>& table = source == ChordSource::cutout ? rotor.chord_cutout
                             : source == ChordSource::text ? rotor.chord_text
                                                           : rotor.chord_camrad;
  return lookup(table, Interpolation::linear, x);
}

// Radial stations: intervals whose ends are the section regions and the tip-loss radius, so that no station
// straddles a step. Specification grid: equal segments, mid-point rule, 9 | 5 | 4 | 1 | 1 times the refinement.
// Real-time grid: Gauss-Legendre points on the same intervals (see the README's numerics section).
template <class R>
BladeStations<R> blade_stations(const RotorTables<R>& rotor, const Options& options) {
  const detail::BladeInterval<R> interval[] = {{rotor.root_cutout, rotor.region_edge[0], 0},
                                               {rotor.region_edge[0], rotor.region_edge[1], 1},
                                               {rotor.region_edge[1], rotor.region_edge[2], 2},
                                               {rotor.region_edge[2], rotor.tip_loss, 3},
                                               {rotor.tip_loss, R(1), 3}};
  const int segments[] = {9, 5, 4, 1, 1};
  BladeStations<R> stations{};
  const auto add = [&](R x, R width, int region) {
    BladeStation<R>& s = stations.station[stations.count++];
    s.radius = x * rotor.radius;
    s.half_chord_dr = R(0.5) * blade_chord(rotor, options.chord, x) * (width * rotor.radius);
    s.twist = blade_twist(rotor, options.twist, x);
    s.lift_weight = x < rotor.tip_loss ? R(1) : R(0);
    stations.region_end[region] = stations.count;
  };
  for (int k = 0; k < 5; ++k) {
    const R width = interval[k].outer - interval[k].inner;
    const int n = segments[k] * options.grid_refinement;
    for (int i = 0; i < n; ++i) {
      add(interval[k].inner + width * ((static_cast<R>(i) + R(0.5)) / static_cast<R>(n)), width / static_cast<R>(n),
          interval[k].region);
    }
  }
  return stations;
}

inline constexpr int kSpecificationAzimuths = 24;

// Azimuth stations of the averaged mode under a set of options.
inline int azimuth_count(const Options& options) {
  return options.azimuth_stations > 0 ? options.azimuth_stations : kSpecificationAzimuths;
}

// Averaged mode: `count` virtual positions, each with blades/count of a blade.
template <class R>
AzimuthStations<R> averaged_azimuth(int blades, int count) {
  AzimuthStations<R> a{};
  a.count = count;
  a.weight = static_cast<R>(blades) / static_cast<R>(count);
  for (int k = 0; k < count; ++k) {
    const R psi = R(2) * kPi<R> * (static_cast<R>(k) + R(0.5)) / static_cast<R>(count);
    a.cosine[k] = cos(psi);
    a.sine[k] = sin(psi);
  }
  return a;
}

// Individual mode: the blades themselves, the first at `azimuth` (rad).
template <class R>
AzimuthStations<R> individual_azimuth(int blades, R azimuth) {
  AzimuthStations<R> a{};
  a.count = blades;
  a.weight = R(1);
  for (int k = 0; k < blades; ++k) {
    const R psi = azimuth + R(2) * kPi<R> * static_cast<R>(k) / static_cast<R>(blades);
    a.cosine[k] = cos(psi);
    a.sine[k] = sin(psi);
  }
  return a;
}

}  // namespace tiltrotor

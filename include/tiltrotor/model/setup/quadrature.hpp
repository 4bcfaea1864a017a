// How to sum over blade and azimuth: intervals, rules and numbers of stations.
#pragma once

#include "tiltrotor/model/variables/options.hpp"

namespace tiltrotor {

// The blade is integrated interval by interval: their ends are the end of the root's taper, the section
// regions and the tip-loss radius, so that no station straddles a step and no interval a kink of the chord.
inline constexpr int kBladeIntervals = 6;

// Equal segments, or Gauss-Legendre points of the interval.
enum class RadialRule : unsigned char { midpoint, gauss };

// How to sum over blade and azimuth. `radial`: stations in each interval, at most kMaxGaussPoints with the
// Gauss rule; 0 in the first joins it to the second.
struct Quadrature {
  RadialRule rule;
  int radial[kBladeIntervals];
  int azimuth;
};

// Specification grid: 20 radial by 24 azimuth stations. Real-time grid: 16 by 8, which keeps thrust within
// 0.1 % of half the weight; the errors of both are found by bench/grid_convergence.cpp.
inline constexpr Quadrature kSpecificationQuadrature = {RadialRule::midpoint, {0, 9, 5, 4, 1, 1}, 24};
inline constexpr Quadrature kRealtimeQuadrature = {RadialRule::gauss, {3, 4, 4, 3, 1, 1}, 8};

inline const Quadrature& quadrature(BladeGrid grid) {
  return grid == BladeGrid::realtime ? kRealtimeQuadrature : kSpecificationQuadrature;
}

inline constexpr int kMaxGaussPoints = 5;

// Points and weights of the Gauss-Legendre rules on 0..1, by number of points: NIST Digital Library 3.5(v).
struct GaussRule {
  double x[kMaxGaussPoints];
  double weight[kMaxGaussPoints];
};
inline constexpr GaussRule kGauss[kMaxGaussPoints] = {
    {{0.5}, {1.0}},
    {{0.21132486540518712, 0.78867513459481288}, {0.5, 0.5}},
    {{0.11270166537925831, 0.5, 0.88729833462074169},
     {0.27777777777777778, 0.44444444444444444, 0.27777777777777778}},
    {{0.069431844202973712, 0.33000947820757187, 0.66999052179242813, 0.93056815579702629},
     {0.17392742256872693, 0.32607257743127307, 0.32607257743127307, 0.17392742256872693}},
    {{0.046910077030668004, 0.23076534494715845, 0.5, 0.76923465505284155, 0.95308992296933200},
     {0.11846344252809454, 0.23931433524968324, 0.28444444444444444, 0.23931433524968324,
      0.11846344252809454}}};

}  // namespace tiltrotor

// The portable form of the lanes, under another namespace name so that both forms live in one program: the
// other half of test_lanes.cpp.
#include <cmath>

#include "lane_program.hpp"

#define TILTROTOR_PORTABLE_LANES
#define tiltrotor tiltrotor_portable_lanes
#include "tiltrotor/math/differentiation/dual.hpp"
#undef tiltrotor

using tiltrotor_portable_lanes::Dual;

std::vector<double> portable_lane_results(int partials) {
  switch (partials) {
    case 1:
      return lane_program::results<Dual<double, 1>, double, 1>();
    case 3:
      return lane_program::results<Dual<double, 3>, double, 3>();
    case 8:
      return lane_program::results<Dual<double, 8>, double, 8>();
    case 31:
      return lane_program::results<Dual<double, 31>, double, 31>();
    default:
      return {};
  }
}

std::vector<float> portable_lane_results_float(int partials) {
  switch (partials) {
    case 5:
      return lane_program::results<Dual<float, 5>, float, 5>();
    case 16:
      return lane_program::results<Dual<float, 16>, float, 16>();
    default:
      return {};
  }
}

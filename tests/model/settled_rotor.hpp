// A rotor whose tilt and inflow have settled at given hub motion and controls: Newton on the five equations,
// for tests.
#pragma once

#include <algorithm>
#include <array>
#include <utility>

#include "flight_cases.hpp"

namespace settled_rotor {

using namespace tiltrotor;

constexpr double kPound = 0.45359237 * 9.80665;  // N
constexpr double kFoot = 0.3048;

/// Solves a small system by elimination with row exchange.
template <std::size_t N>
std::array<double, N> solve(std::array<std::array<double, N>, N> a, std::array<double, N> b) {
  for (std::size_t k = 0; k < N; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < N; ++i) {
      if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
    }
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = k + 1; i < N; ++i) {
      const double factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < N; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = N; k-- > 0;) {
    for (std::size_t j = k + 1; j < N; ++j) b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
  return b;
}

/// Steady b1c, b1s and, unless `frozen_inflow`, n0, nc, ns. The start is in `in.state`.
inline RotorInput<double> settled(const Configuration<double>& c, RotorInput<double> in,
                                  bool frozen_inflow = false) {
  using T = Dual<double, 5>;
  in.state.b1c_rate = in.state.b1s_rate = 0;
  double residual = 1;
  for (int iteration = 0; iteration < 60 && residual > 1e-13; ++iteration) {
    RotorInput<T> seeded = flight_cases::converted<T>(in);
    T* const unknown[5] = {&seeded.state.b1c, &seeded.state.b1s, &seeded.state.lambda_0,
                           &seeded.state.lambda_c, &seeded.state.lambda_s};
    for (int k = 0; k < 5; ++k) *unknown[k] = T::variable(unknown[k]->v, k);
    const RotorResponse<T> out = rotor_response(c, seeded, c.azimuth);
    const double omega = c.setup.rotor_speed;
    const T equation[5] = {out.flapping.b1c_acceleration / (omega * omega),
                           out.flapping.b1s_acceleration / (omega * omega), out.inflow.lambda_0 / omega,
                           out.inflow.lambda_c / omega, out.inflow.lambda_s / omega};
    std::array<std::array<double, 5>, 5> jacobian{};
    std::array<double, 5> right_side{};
    for (std::size_t i = 0; i < 5; ++i) {
      right_side[i] = -equation[i].v;
      for (std::size_t j = 0; j < 5; ++j) jacobian[i][j] = equation[i].d.get(static_cast<int>(j));
      if (frozen_inflow && i >= 2) {
        jacobian[i] = {};
        jacobian[i][i] = 1;
        right_side[i] = 0;
      }
    }
    residual = 0;
    for (const double r : right_side) residual = std::max(residual, std::abs(r));
    const std::array<double, 5> step = solve(jacobian, right_side);
    double longest = 0;
    for (const double x : step) longest = std::max(longest, std::abs(x));
    const double damping = std::min(1.0, 0.02 / longest);
    double* const place[5] = {&in.state.b1c, &in.state.b1s, &in.state.lambda_0, &in.state.lambda_c,
                              &in.state.lambda_s};
    for (std::size_t k = 0; k < 5; ++k) *place[k] += damping * step[k];
  }
  CHECK_LE(residual, 1e-12);
  return in;
}

/// Settled rotor with the collective that gives a thrust (N).
inline RotorInput<double> settled_at_thrust(const Configuration<double>& c, RotorInput<double> in,
                                            double thrust) {
  double low = 0.0;
  double high = 0.45;
  for (int k = 0; k < 45; ++k) {
    in.collective = 0.5 * (low + high);
    in = settled(c, in);
    (rotor_response(c, in, c.azimuth).loads.force_a.z < thrust ? low : high) = in.collective;
  }
  return in;
}

inline RotorInput<double> hover_input(const Configuration<double>& c) {
  RotorInput<double> in{};
  in.coning.angle = c.coning;
  in.collective = 0.2;
  in.state.lambda_0 = 0.07;
  return in;
}

/// A rotor with closed-form answers: constant chord, no twist, no cutout, no tip loss, section lift a alpha
/// in all alpha and no drag, no hub spring, no pitch-flap coupling.
class TextbookRotor {
 public:
  static constexpr double kLiftSlope = 5.73;

  TextbookRotor() : aircraft_(aircraft_data<double>()) {
    RotorTables<double>& r = aircraft_.rotor;
    r.hub_spring = 0;
    r.hub_damping = 0;
    r.delta3 = 0;
    r.root_cutout = 0;
    r.tip_loss = 1;
    r.chord_cutout = Table<double, 1>{{{2, radius_}}, {{0, nullptr}}, chord_};
    r.twist = Table<double, 1>{{{2, radius_}}, {{0, nullptr}}, no_twist_};
    for (int k = 0; k < 3; ++k) r.region_edge[k] = 0.25 * (k + 1);
    for (int k = 0; k < kSectionRegions; ++k) {
      r.section_lift[k] = Table<double, 2>{{{2, alpha_}, {2, mach_}}, {{0, nullptr}}, lift_};
      r.section_drag[k] = Table<double, 2>{{{2, alpha_}, {2, mach_}}, {{0, nullptr}}, drag_};
    }
  }
  TextbookRotor(const TextbookRotor&) = delete;
  TextbookRotor& operator=(const TextbookRotor&) = delete;

  // Three blades of 0.35 m at a radius of 12.5 ft, or as many as give the same solidity.
  static double chord() {
    const RotorTables<double>& r = aircraft_data<double>().rotor;
    return 0.35 * (3.0 / r.blades) * (r.radius / (12.5 * kFoot));
  }
  const Aircraft<double>& aircraft() const { return aircraft_; }
  Configuration<double> configuration() const {
    FlightSetup<double> setup = flight_setup(aircraft_, 0.0);
    setup.options.tables = Interpolation::linear;
    setup.options.grid_refinement = 4;
    setup.options.radial_inflow = RadialInflow::constant;
    Configuration<double> c;
    CHECK(prepare(aircraft_, setup, c) == Status::ok);
    return c;
  }
  double lock_number(const Configuration<double>& c) const {
    const double r = aircraft_.rotor.radius;
    return c.air.density * kLiftSlope * chord() * r * r * r * r / aircraft_.rotor.flap_inertia;
  }

 private:
  const double radius_[2] = {0, 1};
  const double chord_[4] = {chord(), 0, chord(), 0};  // value, slope
  const double no_twist_[4] = {0, 0, 0, 0};
  const double alpha_[2] = {-180, 180};
  const double mach_[2] = {0, 2};
  const double end_ = kLiftSlope * kPi<double>;
  const double lift_[16] = {-end_, 0, 0, 0, -end_, 0, 0, 0, end_, 0, 0, 0, end_, 0, 0, 0};
  const double drag_[16] = {};
  Aircraft<double> aircraft_;
};

}  // namespace settled_rotor

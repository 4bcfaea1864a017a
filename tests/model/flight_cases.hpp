// Flight conditions and scalars for the tests of the model: configurations, random states with a known seed,
// and the same state in another scalar type.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <random>

#include "check.hpp"
#include "returned.hpp"
#include "tiltrotor/math/differentiation/complex_step.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/model/preparation.hpp"

namespace flight_cases {

using namespace tiltrotor;

inline const Aircraft<double>& aircraft() { return aircraft_data<double>(); }

/// Default setup of the mast angle with other switches.
inline Configuration<double> configuration(double mast_deg, const Options& options = Options{}) {
  FlightSetup<double> setup = flight_setup(aircraft(), mast_deg);
  setup.options = options;
  Configuration<double> c;
  CHECK(prepare(aircraft(), setup, c) == Status::ok);
  return c;
}

inline Options linear_tables() {
  Options options;
  options.tables = Interpolation::linear;
  return options;
}

/// The same numbers in another scalar, without partials.
template <class To, template <class> class S, class From>
S<To> converted(const S<From>& from) {
  From flat[sizeof(S<From>) / sizeof(From)];
  int i = 0;
  S<From>::each(from, [&](const From& x) { flat[i++] = x; });
  S<To> to{};
  i = 0;
  S<To>::each(to, [&](To& x) { x = To(static_cast<Real<To>>(value(flat[i++]))); });
  return to;
}

template <class T>
struct StateAndControls {
  State<T> x;
  Controls<T> u;
};

class Generator {
 public:
  explicit Generator(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  bool coin() { return between(0, 1) < 0.5; }

 private:
  std::mt19937 engine_;
};

/// A flyable, asymmetric state: speed range, inflow and collective by mast angle, everything else at random.
inline StateAndControls<double> random_case(Generator& random, const Configuration<double>& c) {
  StateAndControls<double> s{};
  const double mast = c.setup.mast_deg / 90;
  const double speed = random.between(30 * mast, 45 + 85 * mast);
  const double alpha = random.between(-0.25, 0.25);
  const double beta = random.between(-0.2, 0.2);
  s.x.velocity = {speed * std::cos(alpha) * std::cos(beta), speed * std::sin(beta),
                  speed * std::sin(alpha) * std::cos(beta)};
  s.x.rates = {random.between(-0.3, 0.3), random.between(-0.3, 0.3), random.between(-0.3, 0.3)};
  s.x.roll = random.between(-0.5, 0.5);
  s.x.pitch = random.between(-0.4, 0.4);
  s.x.yaw = random.between(-3, 3);
  const double axial = (speed * std::sin(c.mast)) / c.tip_speed;
  s.u.collective = std::atan(axial / 0.75) + random.between(0.08, 0.2);
  for (int side = 0; side < 2; ++side) {
    RotorState<double>& r = s.x.rotor[side];
    r.b1c = random.between(-0.06, 0.06);
    r.b1s = random.between(-0.06, 0.06);
    r.b1c_rate = random.between(-0.3, 0.3);
    r.b1s_rate = random.between(-0.3, 0.3);
    r.lambda_0 = random.between(0.01, 0.08);
    r.lambda_c = random.between(-0.02, 0.03);
    r.lambda_s = random.between(-0.02, 0.02);
    s.x.coning[side] = {random.between(0.02, 0.06), random.between(-0.2, 0.2)};
  }
  s.x.downwash = random.between(-0.05, 0.15);
  s.x.position = {random.between(-100, 100), random.between(-100, 100), random.between(-100, 100)};
  s.u.long_stick = random.between(-3, 3);
  s.u.lat_stick = random.between(-2.5, 2.5);
  s.u.pedal = random.between(-1.5, 1.5);
  s.u.long_cyclic = random.between(-0.03, 0.03);
  s.u.diff_collective = random.between(-0.02, 0.02);
  s.u.diff_long_cyclic = random.between(-0.02, 0.02);
  s.u.elevator = random.between(-0.1, 0.1);
  s.u.aileron = random.between(-0.1, 0.1);
  s.u.rudder = random.between(-0.1, 0.1);
  s.u.lateral_cyclic = random.between(-0.03, 0.03);
  s.u.gust = {random.between(-3, 3), random.between(-3, 3), random.between(-3, 3)};
  return s;
}

/// Left and right exchanged: lateral variables change sign, those of a rotor change sides.
template <template <class> class S, class T, class Table>
S<T> mirrored(const S<T>& s, const Table& variables) {
  T flat[sizeof variables.row / sizeof variables.row[0]];
  flatten(s, flat);
  S<T> m;
  std::size_t i = 0;
  S<T>::each(m, [&](T& x) {
    const T& other = flat[variables.partner[i]];
    x = variables.row[i++].plane == Plane::lateral ? -other : other;
  });
  return m;
}
template <class T>
State<T> mirrored(const State<T>& x) {
  return mirrored(x, kStateVariables);
}
template <class T>
Controls<T> mirrored(const Controls<T>& u) {
  return mirrored(u, kControlVariables);
}

/// Numbers of a struct in order.
template <class T, template <class> class S>
std::array<T, sizeof(S<T>) / sizeof(T)> flat(const S<T>& s) {
  std::array<T, sizeof(S<T>) / sizeof(T)> a{};
  std::size_t i = 0;
  S<T>::each(s, [&](const T& x) { a[i++] = x; });
  return a;
}

/// Unit-by-unit size of the rates of the state, the scale of "relative" where an entry itself may vanish:
/// accelerations against gravity, angular accelerations against 1 rad/s^2, flapping against Omega^2, inflow
/// against Omega.
inline std::array<double, state_count> rate_scale(const Configuration<double>& c) {
  std::array<double, state_count> s{};
  s.fill(1);
  const double omega = c.setup.rotor_speed;
  for (std::size_t i = 0; i < state_count; ++i) {
    const VariableKind kind = kStateVariables.row[i].kind;
    if (kind == VariableKind::speed) s[i] = kGravity<double>;
    if (kind == VariableKind::gimbal_rate || kind == VariableKind::coning_rate) s[i] = 0.01 * omega * omega;
    if (kind == VariableKind::mean_inflow || kind == VariableKind::cyclic_inflow) s[i] = 0.01 * omega;
  }
  return s;
}

}  // namespace flight_cases

// Dual numbers, tables, LU and eigenvalues on any numbers of any order.
// Expected: plain numbers bit for bit, residuals.
#include <cmath>

#include "fuzz/target.hpp"
#include "tiltrotor/math/algebra/eigen.hpp"
#include "tiltrotor/math/algebra/lu.hpp"
#include "tiltrotor/math/differentiation/dual.hpp"
#include "tiltrotor/math/smooth.hpp"
#include "tiltrotor/math/tables/table.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

namespace {

using namespace tiltrotor;
constexpr int kOrder = 12;
using Square = Matrix<double, kOrder, kOrder>;

int any_matrix(fuzz::Bytes& in, Square& a) {
  const int n = 1 + in.below(kOrder);
  set_zero(a);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) a(i, j) = in.number();
  return n;
}

bool entries_finite(const double* x, int n) {
  for (int i = 0; i < n; ++i)
    if (!std::isfinite(x[i])) return false;
  return true;
}

void solve(fuzz::Bytes& in) {
  static Square a;
  static LU<double, kOrder> lu;
  const int n = any_matrix(in, a);
  const Status factored = lu_factor(a, n, lu);
  REQUIRE(factored == Status::ok || factored == Status::singular || factored == Status::not_finite);
  REQUIRE((factored == Status::ok) == (lu.size == n));
  if (!all_finite(a, n, n)) REQUIRE(factored == Status::not_finite);
  double x[kOrder];
  for (int i = 0; i < n; ++i) x[i] = in.number();
  const Status solved = lu_solve(lu, x);
  REQUIRE(factored == Status::ok || solved == Status::bad_argument);
  if (solved == Status::ok) REQUIRE(entries_finite(x, n));
  const double condition = lu_reciprocal_condition(lu);
  REQUIRE(condition >= 0 && condition <= 1.0001);
}

void decompose(fuzz::Bytes& in) {
  static Square a;
  static EigenWorkspace<double, kOrder> work;
  static Eigenvalues<double, kOrder> values;
  static Eigensystem<double, kOrder> system;
  const int n = any_matrix(in, a);
  const Status status = eigenvalues(a, n, work, values);
  if (!all_finite(a, n, n)) REQUIRE(status == Status::not_finite);
  const Status complete = eigensystem(a, n, work, system);
  REQUIRE(status != Status::ok || complete == Status::ok || complete == Status::not_finite);
  if (status != Status::ok) return;
  REQUIRE(values.sweeps <= 30 * n && entries_finite(values.real, n) && entries_finite(values.imag, n));
  double trace = 0, sum = 0, norm = 0;
  for (int i = 0; i < n; ++i) {
    trace += a(i, i);
    sum += values.real[i];
    for (int j = 0; j < n; ++j) norm += std::fabs(a(i, j));
    if (values.imag[i] > 0) {
      REQUIRE(i + 1 < n && values.imag[i + 1] == -values.imag[i] && values.real[i + 1] == values.real[i]);
      ++i;
      trace += a(i, i);
      sum += values.real[i];
      for (int j = 0; j < n; ++j) norm += std::fabs(a(i, j));
    } else {
      REQUIRE(values.imag[i] == 0);
    }
  }
  if (norm < 1e300 && norm > 1e-290) REQUIRE(std::fabs(trace - sum) <= 1e-11 * norm);
}

// A stack machine: the value of a dual number is the plain number, bit for bit, whatever is computed.
template <class T>
struct Machine {
  T stack[4];
  void run(int operation, int a, int b) {
    T& x = stack[a];
    const T y = stack[b];
    switch (operation) {
      case 0:
        x = x + y;
        break;
      case 1:
        x = x - y;
        break;
      case 2:
        x = x * y;
        break;
      case 3:
        x = x / y;
        break;
      case 4:
        x = tiltrotor::sqrt(x);
        break;
      case 5:
        x = tiltrotor::sin(x);
        break;
      case 6:
        x = tiltrotor::cos(x);
        break;
      case 7:
        x = tiltrotor::atan2(x, y);
        break;
      case 8:
        x = -x;
        break;
      case 9:
        x = smooth_step(x);
        break;
      case 10:
        x = smooth_max(x, 0.25, 0.1);
        break;
      default:
        x = lookup(aircraft_data<double>().rotor.section_lift[a], Interpolation::c1, x, y);
    }
  }
};

void compute(fuzz::Bytes& in) {
  using D = Dual<double, 3>;
  Machine<double> plain;
  Machine<D> dual;
  for (int k = 0; k < 4; ++k) {
    plain.stack[k] = in.number();
    dual.stack[k] = k < 3 ? D::variable(plain.stack[k], k) : D(plain.stack[k]);
  }
  for (int step = 0; step < 24 && !in.empty(); ++step) {
    const int operation = in.below(12), a = in.below(4), b = in.below(4);
    plain.run(operation, a, b);
    dual.run(operation, a, b);
    const double p = plain.stack[a], d = dual.stack[a].v;
    if (operation == 11) {  // look-ups with slopes may round the polynomial differently
      REQUIRE((std::isnan(p) && std::isnan(d)) || std::fabs(p - d) <= 1e-12 * (1 + std::fabs(p)));
      dual.stack[a].v = p;
    } else {
      REQUIRE((std::isnan(p) && std::isnan(d)) || p == d);
    }
  }
}

void look_up(fuzz::Bytes& in) {
  const Aircraft<double>& aircraft = aircraft_data<double>();
  const double x = in.number(), y = in.number();
  const Interpolation mode = in.below(2) == 0 ? Interpolation::c1 : Interpolation::linear;
  const double found[] = {lookup(aircraft.rotor.section_drag[in.below(kSectionRegions)], mode, x, y),
                          lookup(aircraft.fuselage.yaw_beta, mode, x),
                          lookup(aircraft.wing.lift_90[in.below(aircraft.wing.flap_settings)], mode, x, y)};
  const bool number = !std::isnan(x) && !std::isnan(y);
  REQUIRE(!number || entries_finite(found, 3));
  const SineCosine<double> f = sine_cosine(x);
  REQUIRE(!std::isfinite(x) || std::fabs(x) > 1e8 ||
          std::fabs(f.sine * f.sine + f.cosine * f.cosine - 1) < 1e-15);
}

}  // namespace

FUZZ_TARGET(solvers) {
  fuzz::Bytes in(data, size);
  switch (in.below(4)) {
    case 0:
      solve(in);
      break;
    case 1:
      decompose(in);
      break;
    case 2:
      compute(in);
      break;
    default:
      look_up(in);
  }
}

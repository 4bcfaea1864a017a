// Dual numbers against algebra, analytic derivatives, complex steps and duals with a single partial, for the
// lane counts that matter: below, at and beyond one vector, odd and even, double and float.
#include "tiltrotor/math/differentiation/dual.hpp"

#include <array>
#include <complex>
#include <limits>
#include <random>

#include "check.hpp"
#include "tiltrotor/math/differentiation/batch.hpp"
#include "tiltrotor/math/differentiation/complex_step.hpp"

using namespace tiltrotor;

namespace {

constexpr unsigned kSeed = 31415;

template <class R, int N>
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  R number(double low, double high) {
    return static_cast<R>(std::uniform_real_distribution<double>(low, high)(engine_));
  }
  Dual<R, N> dual(double low, double high) {
    Dual<R, N> x(number(low, high));
    for (int j = 0; j < N; ++j) x.d.set(j, number(-2, 2));
    return x;
  }

 private:
  std::mt19937 engine_;
};

template <class R, int N>
void check_same(const Dual<R, N>& a, const Dual<R, N>& b, double tolerance) {
  CHECK_NEAR(a.v, b.v, tolerance * (1 + std::abs(static_cast<double>(b.v))));
  for (int j = 0; j < N; ++j) {
    CHECK_NEAR(a.d.get(j), b.d.get(j), tolerance * (1 + std::abs(static_cast<double>(b.d.get(j)))));
  }
}

template <class R, int N>
void check_algebra() {
  using D = Dual<R, N>;
  const double tolerance = 200 * static_cast<double>(std::numeric_limits<R>::epsilon());
  Random<R, N> random(kSeed + static_cast<unsigned>(N));
  for (int n = 0; n < 50; ++n) {
    const D a = random.dual(0.3, 2);
    const D b = random.dual(0.3, 2);
    const D c = random.dual(-2, 2);
    check_same(D(a + b), D(b + a), 0);
    check_same(D(a * b), D(b * a), tolerance);
    check_same(D((a + b) + c), D(a + (b + c)), tolerance);
    check_same(D((a * b) * c), D(a * (b * c)), tolerance);
    check_same(D(a * (b + c)), D(a * b + a * c), tolerance);
    check_same(D((a / b) * b), a, tolerance);
    check_same(D(a - a), D(R(0)), 0);
    check_same(D(-c), D(R(0) - c), 0);
    check_same(D(R(2) / a), D(D(R(2)) / a), tolerance);
    check_same(D(a / R(3)), D(a / D(R(3))), tolerance);
    check_same(D(R(1) - c), D(D(R(1)) - c), 0);
    check_same(D(c - R(1)), D(c - D(R(1))), 0);
    check_same(D(R(3) * c), D(D(R(3)) * c), tolerance);
    check_same(D(c * R(3)), D(R(3) * c), 0);
    check_same(D(R(3) + c), D(c + R(3)), 0);
    const D root = sqrt(a);
    check_same(D(root * root), a, tolerance);
    const D s = sin(c);
    const D co = cos(c);
    check_same(D(s * s + co * co), D(R(1)), tolerance);
    check_same(D(tan(a * R(0.5))), D(sin(a * R(0.5)) / cos(a * R(0.5))), tolerance);
    check_same(atan2(s, co), c, tolerance);  // |c| < pi
    check_same(square(c), D(c * c), 0);
    D sum = a;
    sum += b;
    check_same(sum, D(a + b), 0);
    sum -= b;
    check_same(sum, D((a + b) - b), 0);
    sum = a;
    sum *= c;
    check_same(sum, D(a * c), 0);
    sum = a;
    sum *= R(2);
    check_same(sum, D(a * R(2)), 0);
  }
}

// A composed function of two variables that uses every operation. Qualified names: for a plain number the
// global sin would win otherwise.
template <class T>
T composed(const T& x, const T& y) {
  using R = Real<T>;
  const T a = tiltrotor::sqrt(T(x * x + y * y + R(1)));
  const T b = tiltrotor::sin(x) * tiltrotor::cos(y) - tiltrotor::tan(T(y * R(0.3))) / a;
  const T c = tiltrotor::atan2(T(b + x), T(a - R(0.5) * y));
  return c * a - R(2) / (a + b * b) + (x - R(3)) * (R(1) - y) - x / R(7);
}

// Every partial is that of a dual with this partial alone, bit for bit, and the value that of the plain
// number.
template <class R, int N>
void check_partials_are_independent() {
  Random<R, N> random(kSeed);
  for (int n = 0; n < 20; ++n) {
    const Dual<R, N> x = random.dual(-2, 2);
    const Dual<R, N> y = random.dual(-2, 2);
    const Dual<R, N> z = composed(x, y);
    CHECK(z.v == composed(x.v, y.v));
    for (int j = 0; j < N; ++j) {
      using One = Dual<R, 1>;
      One x1(x.v);
      One y1(y.v);
      x1.d.set(0, x.d.get(j));
      y1.d.set(0, y.d.get(j));
      CHECK(composed(x1, y1).d.get(0) == z.d.get(j));
    }
  }
}

template <class R, int N>
void check_size() {
  check_algebra<R, N>();
  check_partials_are_independent<R, N>();
}

}  // namespace

TEST(dual_algebra_double) {
  NOTE("seed " << kSeed);
  check_size<double, 1>();
  check_size<double, 3>();
  check_size<double, 5>();
  check_size<double, 8>();
  check_size<double, 9>();
  check_size<double, 16>();
  check_size<double, 31>();
  check_size<double, 32>();
}

TEST(dual_algebra_float) {
  NOTE("seed " << kSeed);
  check_size<float, 1>();
  check_size<float, 3>();
  check_size<float, 5>();
  check_size<float, 8>();
  check_size<float, 9>();
  check_size<float, 16>();
  check_size<float, 31>();
  check_size<float, 32>();
}

TEST(dual_analytic_derivatives) {
  using D = Dual<double, 3>;
  const double points[] = {-1.3, -0.2, 0.4, 1.1};
  for (const double p : points) {
    const D x = D::variable(p, 1);
    CHECK_EQ(x.v, p);
    CHECK_EQ(x.d.get(0), 0.0);
    CHECK_EQ(x.d.get(1), 1.0);
    CHECK_EQ(x.d.get(2), 0.0);
    CHECK_REL(sin(x).d.get(1), std::cos(p), 1e-15);
    CHECK_REL(cos(x).d.get(1), -std::sin(p), 1e-15);
    CHECK_REL(tan(x).d.get(1), 1 / (std::cos(p) * std::cos(p)), 1e-14);
    CHECK_REL(sqrt(x + 2.0).d.get(1), 0.5 / std::sqrt(p + 2), 1e-15);
    CHECK_REL((x * x * x).d.get(1), 3 * p * p, 1e-15);
    CHECK_REL((1.0 / x).d.get(1), -1 / (p * p), 1e-15);
    CHECK_REL(((x + 1.0) / (x * x + 1.0)).d.get(1),
              (p * p + 1 - 2 * p * (p + 1)) / ((p * p + 1) * (p * p + 1)), 1e-14);
    for (const double q : points) {  // all four quadrants
      const D y = D::variable(q, 2);
      const D angle = atan2(x, y);
      CHECK_EQ(angle.v, tiltrotor::atan2(p, q));
      CHECK_NEAR(angle.v, std::atan2(p, q), 1e-15);
      CHECK_REL(angle.d.get(1), q / (p * p + q * q), 1e-14);
      CHECK_REL(angle.d.get(2), -p / (p * p + q * q), 1e-14);
      CHECK_EQ(angle.d.get(0), 0.0);
    }
  }
}

TEST(dual_against_complex_step) {
  NOTE("seed " << kSeed);
  Random<double, 2> random(kSeed);
  for (int n = 0; n < 200; ++n) {
    const double px = random.number(-2, 2);
    const double py = random.number(-2, 2);
    using D = Dual<double, 2>;
    using C = std::complex<double>;
    const D z = composed(D::variable(px, 0), D::variable(py, 1));
    constexpr double step = 1e-30;
    const double dx = composed(C(px, step), C(py)).imag() / step;
    const double dy = composed(C(px), C(py, step)).imag() / step;
    CHECK_NEAR(z.d.get(0), dx, 1e-12 * (1 + std::abs(dx)));
    CHECK_NEAR(z.d.get(1), dy, 1e-12 * (1 + std::abs(dy)));
  }
}

// Chain rule twice through: the derivative of a derivative is a dual of duals' business, but a gradient along
// a curve is a sum over the partials.
TEST(dual_gradient_along_a_curve) {
  using D = Dual<double, 1>;
  const double t = 0.7;
  const D time = D::variable(t, 0);
  const D curve = composed(D(sin(time)), D(time * time));
  using G = Dual<double, 2>;
  const G gradient = composed(G::variable(std::sin(t), 0), G::variable(t * t, 1));
  CHECK_NEAR(curve.d.get(0), gradient.d.get(0) * std::cos(t) + gradient.d.get(1) * 2 * t, 1e-14);
}

TEST(dual_known_value_and_slopes) {
  using D = Dual<double, 5>;
  const D x = D::variable(2, 0);
  const D y = D::variable(3, 4);
  const D* const arguments[2] = {&x, &y};
  const double slopes[2] = {-2, 5};
  const D z = ScalarTraits<D>::from_slopes<2>(7.0, slopes, arguments);
  CHECK_EQ(value(z), 7.0);
  CHECK_EQ(z.d.get(0), -2.0);
  CHECK_EQ(z.d.get(4), 5.0);
  CHECK_EQ(z.d.get(2), 0.0);
}

// Points without a derivative are not hidden: the partials are not finite, the value is that of the plain
// function.
TEST(dual_special_points) {
  using D = Dual<double, 3>;
  const D zero = D::variable(0, 0);
  const D root = sqrt(zero);
  CHECK_EQ(root.v, 0.0);
  CHECK(!std::isfinite(root.d.get(0)));
  const D angle = atan2(zero, D::variable(0, 1));
  CHECK_EQ(angle.v, 0.0);
  CHECK(!std::isfinite(angle.d.get(0)));
  CHECK(!std::isfinite(angle.d.get(1)));
  const D inverse = 1.0 / zero;
  CHECK(!std::isfinite(inverse.v));
  CHECK(!std::isfinite(inverse.d.get(0)));
  const D negative = sqrt(zero - 1.0);
  CHECK(std::isnan(negative.v));
  // On the axes the angle is smooth.
  const D up = atan2(D::variable(2, 0), D::variable(0, 1));
  CHECK_EQ(up.d.get(1), -0.5);
  CHECK_EQ(up.d.get(0), 0.0);
  // Square of zero has the exact slope zero.
  CHECK_EQ((zero * zero).d.get(0), 0.0);
}

// Asked for together they are what each is alone, on every scalar, to the bit.
TEST(dual_sine_and_cosine_together) {
  const auto check = [](const auto& x, auto&& same) {
    const auto both = sine_and_cosine(x);
    CHECK(same(both.sine, tiltrotor::sin(x)));
    CHECK(same(both.cosine, tiltrotor::cos(x)));
  };
  Random<double, 9> random(kSeed);
  for (int k = 0; k < 200; ++k) {
    const Dual<double, 9> x = random.dual(-20, 20);
    check(x, [](const Dual<double, 9>& a, const Dual<double, 9>& b) {
      bool same = a.v == b.v;
      for (int j = 0; j < 9; ++j) same = same && a.d.get(j) == b.d.get(j);
      return same;
    });
    const auto equal = [](const auto& a, const auto& b) { return a == b; };
    check(x.v, equal);
    check(static_cast<float>(x.v), equal);
    check(std::complex<double>(x.v, x.d.get(0)), equal);
    check(Batch<double>(x.v),
          [](const Batch<double>& a, const Batch<double>& b) { return a.get(0) == b.get(0); });
  }
}

// The chain rule through a waist: same values, same derivatives as seeding the whole function, fewer partials
// inside.
#include "tiltrotor/math/differentiation/preaccumulate.hpp"

#include <complex>
#include <random>

#include "check.hpp"
#include "tiltrotor/math/differentiation/complex_step.hpp"

using namespace tiltrotor;

namespace {

template <class T>
struct Through {
  T a, b, c;
  static constexpr int kCount = 3;
  template <class Self, class Visit>
  static void each(Self& s, Visit&& visit) {
    visit(s.a);
    visit(s.b);
    visit(s.c);
  }
};
template <class T>
struct Beyond {
  T first, second;
  static constexpr int kCount = 2;
  template <class Self, class Visit>
  static void each(Self& s, Visit&& visit) {
    visit(s.first);
    visit(s.second);
  }
};

template <class T>
Beyond<T> beyond(const Through<T>& in) {
  return {in.a * tiltrotor::sin(in.b) + in.c / (in.a * in.a + Real<T>(2)),
          tiltrotor::sqrt(T(in.b * in.b + in.c * in.c)) - in.a};
}

// Waist variables as functions of many outer ones.
template <class T, int Count>
Through<T> narrowed(const T (&x)[Count]) {
  Through<T> in{T(Real<T>(0.5)), T(Real<T>(1)), T(Real<T>(2))};
  for (int i = 0; i < Count; ++i) {
    const Real<T> k = static_cast<Real<T>>(i + 1);
    in.a = in.a + (Real<T>(0.1) / k) * x[i];
    in.b = in.b + (Real<T>(0.05) * k) * x[i] * x[i];
    in.c = in.c - tiltrotor::sin(T(k * x[i]));
  }
  return in;
}

template <class R, int M>
void check_waist(bool local_expected, double tolerance) {
  using T = Dual<R, M>;
  std::mt19937 engine(99);
  std::uniform_real_distribution<double> uniform(-1, 1);
  T x[M];
  R plain[M];
  for (int i = 0; i < M; ++i) {
    plain[i] = static_cast<R>(uniform(engine));
    x[i] = T::variable(plain[i], i);
  }
  const Through<T> in = narrowed(x);
  int partials_inside = 0;
  const Beyond<T> out = preaccumulate(in, [&](const auto& local) {
    using L = std::decay_t<decltype(local.a)>;
    partials_inside = L::kPartials;
    return beyond(local);
  });
  CHECK_EQ(partials_inside, local_expected ? 3 : M);
  const Beyond<T> direct = beyond(in);
  const Beyond<R> values = beyond(narrowed(plain));
  CHECK(out.first.v == values.first && out.second.v == values.second);
  for (int j = 0; j < M; ++j) {
    const auto close = [&](double actual, double expected) {
      CHECK_NEAR(actual, expected, tolerance * (1 + std::abs(expected)));
    };
    close(static_cast<double>(out.first.d.get(j)), static_cast<double>(direct.first.d.get(j)));
    close(static_cast<double>(out.second.d.get(j)), static_cast<double>(direct.second.d.get(j)));
  }
}

}  // namespace

TEST(waist_same_derivatives_as_without) {
  check_waist<double, 32>(true, 1e-13);
  check_waist<double, 31>(true, 1e-13);
  check_waist<double, 9>(true, 1e-13);
  check_waist<float, 31>(true, 1e-4);
  // Nothing to gain: the function is called as it is.
  check_waist<double, 3>(false, 0);
  check_waist<double, 1>(false, 0);
}

TEST(waist_plain_and_complex_pass_through) {
  const Through<double> in{0.3, 1.1, -0.7};
  const Beyond<double> out = preaccumulate(in, [](const auto& local) { return beyond(local); });
  CHECK_EQ(out.first, beyond(in).first);
  CHECK_EQ(out.second, beyond(in).second);
  using C = std::complex<double>;
  const Through<C> complex_in{C(0.3, 1e-30), C(1.1), C(-0.7)};
  const Beyond<C> complex_out = preaccumulate(complex_in, [](const auto& local) { return beyond(local); });
  // d/da of a sin b + c/(a^2 + 2)
  const double expected = std::sin(1.1) - (-0.7) * 2 * 0.3 / ((0.09 + 2) * (0.09 + 2));
  CHECK_NEAR(complex_out.first.imag() / 1e-30, expected, 1e-14);
}

// A waist variable that depends on no outer one, and a result that depends on no waist variable.
TEST(waist_constants_keep_zero_partials) {
  using T = Dual<double, 16>;
  const Through<T> in{T(0.3), T::variable(1.1, 7), T(-0.7)};
  const Beyond<T> out = preaccumulate(in, [](const auto& local) {
    using L = std::decay_t<decltype(local.a)>;
    return Beyond<L>{local.b * local.b, L(4.0)};
  });
  for (int j = 0; j < 16; ++j) {
    CHECK_NEAR(out.first.d.get(j), j == 7 ? 2.2 : 0.0, 1e-15);
    CHECK_EQ(out.second.d.get(j), 0.0);
  }
  CHECK_EQ(out.second.v, 4.0);
}

TEST(waist_pack_and_unpack) {
  const Through<double> in{1, 2, 3};
  double array[3];
  flatten(in, array);
  CHECK_EQ(array[0], 1.0);
  CHECK_EQ(array[2], 3.0);
  Through<double> out{};
  unflatten(array, out);
  CHECK_EQ(out.b, 2.0);
  CHECK_EQ(out.c, 3.0);
}

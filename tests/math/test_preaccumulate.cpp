// The chain rule through few inputs: same values, same derivatives as seeding the whole function, fewer partials
// inside.
#include "tiltrotor/math/differentiation/preaccumulate.hpp"

#include <complex>
#include <random>

#include "check.hpp"
#include "tiltrotor/math/differentiation/complex_step.hpp"

using namespace tiltrotor;

namespace {

template <class T>
struct Input {
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
struct Output {
  T first, second;
  static constexpr int kCount = 2;
  template <class Self, class Visit>
  static void each(Self& s, Visit&& visit) {
    visit(s.first);
    visit(s.second);
  }
};

template <class T>
Output<T> output(const Input<T>& in) {
  return {in.a * tiltrotor::sin(in.b) + in.c / (in.a * in.a + Real<T>(2)),
          tiltrotor::sqrt(T(in.b * in.b + in.c * in.c)) - in.a};
}

// The inputs as functions of many outer ones.
template <class T, int Count>
Input<T> narrowed(const T (&x)[Count]) {
  Input<T> in{T(Real<T>(0.5)), T(Real<T>(1)), T(Real<T>(2))};
  for (int i = 0; i < Count; ++i) {
    const Real<T> k = static_cast<Real<T>>(i + 1);
    in.a = in.a + (Real<T>(0.1) / k) * x[i];
    in.b = in.b + (Real<T>(0.05) * k) * x[i] * x[i];
    in.c = in.c - tiltrotor::sin(T(k * x[i]));
  }
  return in;
}

template <class T, class Function>
Output<T> preaccumulated(const Input<T>& in, Function&& function) {
  PreaccumulationWorkspace<Input, Output, T> work;
  Output<T> out;
  preaccumulate(in, work, out, [&](const auto& local, auto& found) { found = function(local); });
  return out;
}

template <class R, int M>
void check_chain(bool local_expected, double tolerance) {
  using T = Dual<R, M>;
  std::mt19937 engine(99);
  std::uniform_real_distribution<double> uniform(-1, 1);
  T x[M];
  R plain[M];
  for (int i = 0; i < M; ++i) {
    plain[i] = static_cast<R>(uniform(engine));
    x[i] = T::variable(plain[i], i);
  }
  const Input<T> in = narrowed(x);
  int partials_inside = 0;
  const Output<T> out = preaccumulated(in, [&](const auto& local) {
    using L = std::decay_t<decltype(local.a)>;
    partials_inside = L::kPartials;
    return output(local);
  });
  CHECK_EQ(partials_inside, local_expected ? 3 : M);
  const Output<T> direct = output(in);
  const Output<R> values = output(narrowed(plain));
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

TEST(preaccumulation_same_derivatives_as_without) {
  check_chain<double, 32>(true, 1e-13);
  check_chain<double, 31>(true, 1e-13);
  check_chain<double, 9>(true, 1e-13);
  check_chain<float, 31>(true, 1e-4);
  // Nothing to gain: the function is called as it is.
  check_chain<double, 3>(false, 0);
  check_chain<double, 1>(false, 0);
}

TEST(preaccumulation_plain_and_complex_pass_through) {
  const Input<double> in{0.3, 1.1, -0.7};
  const Output<double> out = preaccumulated(in, [](const auto& local) { return output(local); });
  CHECK_EQ(out.first, output(in).first);
  CHECK_EQ(out.second, output(in).second);
  using C = std::complex<double>;
  const Input<C> complex_in{C(0.3, 1e-30), C(1.1), C(-0.7)};
  const Output<C> complex_out = preaccumulated(complex_in, [](const auto& local) { return output(local); });
  // d/da of a sin b + c/(a^2 + 2)
  const double expected = std::sin(1.1) - (-0.7) * 2 * 0.3 / ((0.09 + 2) * (0.09 + 2));
  CHECK_NEAR(complex_out.first.imag() / 1e-30, expected, 1e-14);
}

// An input that depends on no outer direction, and a result that depends on no input.
TEST(preaccumulation_constants_keep_zero_partials) {
  using T = Dual<double, 16>;
  const Input<T> in{T(0.3), T::variable(1.1, 7), T(-0.7)};
  const Output<T> out = preaccumulated(in, [](const auto& local) {
    using L = std::decay_t<decltype(local.a)>;
    return Output<L>{local.b * local.b, L(4.0)};
  });
  for (int j = 0; j < 16; ++j) {
    CHECK_NEAR(out.first.d.get(j), j == 7 ? 2.2 : 0.0, 1e-15);
    CHECK_EQ(out.second.d.get(j), 0.0);
  }
  CHECK_EQ(out.second.v, 4.0);
}

TEST(preaccumulation_flatten_and_unflatten) {
  const Input<double> in{1, 2, 3};
  double array[3];
  flatten(in, array);
  CHECK_EQ(array[0], 1.0);
  CHECK_EQ(array[2], 3.0);
  Input<double> out{};
  unflatten(array, out);
  CHECK_EQ(out.b, 2.0);
  CHECK_EQ(out.c, 3.0);
}

// Generalised eigenvalues, transmission zeros and values of transfer functions. Expected: closed forms, and pencils made
// of known ones.
#include <algorithm>
#include <cmath>
#include <complex>
#include <random>
#include <vector>

#include "check.hpp"
#include "tiltrotor/analysis/linear/frequency_measures.hpp"

using namespace tiltrotor;
using C = std::complex<double>;

namespace {

constexpr int kOrder = 12;
using Small = Channel<double, kOrder>;

// Coefficients of prod(s - root), highest power first.
std::vector<double> polynomial(const std::vector<C>& roots) {
  std::vector<C> p = {1.0};
  for (const C& root : roots) {
    p.push_back(0.0);
    for (std::size_t k = p.size() - 1; k > 0; --k) p[k] -= root * p[k - 1];
  }
  std::vector<double> real;
  for (const C& c : p) real.push_back(c.real());
  return real;
}

// gain prod(s - zero)/prod(s - pole) in controllable form, fewer zeros than poles.
Small companion(double gain, const std::vector<C>& zeros, const std::vector<C>& poles) {
  const std::vector<double> above = polynomial(zeros), below = polynomial(poles);
  const int n = static_cast<int>(poles.size()), m = static_cast<int>(zeros.size());
  Small s{};
  s.states = n;
  for (int i = 0; i + 1 < n; ++i) s.a(i, i + 1) = 1;
  for (int j = 0; j < n; ++j) s.a(n - 1, j) = -below[static_cast<std::size_t>(n - j)];
  s.b[n - 1] = 1;
  for (int j = 0; j <= m; ++j) s.c[j] = gain * above[static_cast<std::size_t>(m - j)];
  return s;
}

// Distance from a root to the nearest computed one.
template <int N>
double distance(const Eigenvalues<double, N>& found, C root) {
  double least = 1e300;
  for (int k = 0; k < found.size; ++k)
    least = std::min(least, std::abs(C(found.real[k], found.imag[k]) - root));
  return least;
}

struct Found {
  TransferFunction<double, kOrder> f;
  TransferFunctionWorkspace<double, kOrder> work;
  ResponseWorkspace<double, kOrder> response;
};

}  // namespace

// Pencils Q diag(alpha) Z, Q diag(beta) Z with random Q and Z have the eigenvalues alpha/beta, a pair as a block.
TEST(eigen_generalised_are_those_that_a_pencil_was_made_of) {
  std::mt19937 random(13);
  std::normal_distribution<double> normal;
  static Matrix<double, kOrder, kOrder> a, e, t;
  double worst = 0;
  for (int trial = 0; trial < 50; ++trial) {
    const int n = 1 + trial % kOrder;
    Matrix<double, kOrder, kOrder> q{}, z{}, alpha{}, beta{};
    std::vector<C> expected;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        q(i, j) = normal(random) + 3 * (i == j), z(i, j) = normal(random) + 3 * (i == j);
    for (int i = 0; i < n; ++i) {
      beta(i, i) = 0.5 + std::abs(normal(random));
      alpha(i, i) = 3 * normal(random);
      if (i % 3 == 1 && i + 1 < n) {
        const double imag = 0.5 + std::abs(normal(random)), real = alpha(i, i);
        alpha(i, i + 1) = imag;
        alpha(i + 1, i) = -imag;
        alpha(i + 1, i + 1) = real;
        beta(i + 1, i + 1) = beta(i, i);
        expected.emplace_back(real / beta(i, i), imag / beta(i, i));
        expected.emplace_back(real / beta(i, i), -imag / beta(i, i));
        ++i;
        continue;
      }
      expected.emplace_back(alpha(i, i) / beta(i, i), 0);
    }
    multiply(q, alpha, t);
    multiply(t, z, a);
    multiply(q, beta, t);
    multiply(t, z, e);
    Eigenvalues<double, kOrder> values;
    CHECK(generalised_eigenvalues(a, e, n, values) == Status::ok);
    CHECK_EQ(values.converged, n);
    for (const C& root : expected) worst = std::max(worst, distance(values, root) / (1 + std::abs(root)));
  }
  CHECK_LT(worst, 1e-8);
  NOTE("worst " << worst);
}

TEST(eigen_generalised_refuse_what_they_cannot_solve) {
  Matrix<double, kOrder, kOrder> a = identity<double, kOrder>(), e = a;
  Eigenvalues<double, kOrder> values;
  CHECK(generalised_eigenvalues(a, e, 0, values) == Status::bad_argument);
  CHECK(generalised_eigenvalues(a, e, kOrder + 1, values) == Status::bad_argument);
  a(0, 1) = std::nan("");
  CHECK(generalised_eigenvalues(a, e, 3, values) == Status::not_finite);
  a(0, 1) = 0;
  e(2, 0) = HUGE_VAL;
  CHECK(generalised_eigenvalues(a, e, 3, values) == Status::not_finite);
  e(2, 0) = 0;
  // An eigenvalue at infinity, as far as rounding lets it.
  a = identity<double, kOrder>();
  e(1, 1) = 0;
  CHECK(generalised_eigenvalues(a, e, 3, values) == Status::ok);
  int far = 0;
  for (int k = 0; k < 3; ++k) far += std::abs(values.real[k]) > 1e14;
  CHECK_EQ(far, 1);
}

// Every number of zeros from none to one less than poles; units of the states spread over ten decades.
TEST(transfer_function_has_the_poles_zeros_and_gain_it_was_made_of) {
  static Found at;
  const std::vector<C> poles = {{-1, 2}, {-1, -2}, -0.3, 0.2, {-4, 1}, {-4, -1}, -9};
  const std::vector<C> all = {1.5, {-0.5, 1}, {-0.5, -1}, 0, -3, -7};
  for (const std::size_t m : {0u, 1u, 3u, 4u, 5u, 6u}) {
    const std::vector<C> zeros(all.begin(), all.begin() + static_cast<long>(m));
    Small s = companion(-2.5, zeros, poles);
    for (int i = 0; i < s.states; ++i) {
      const double unit = std::pow(10.0, i % 2 == 0 ? -5 : 5);
      for (int j = 0; j < s.states; ++j) s.a(i, j) *= unit, s.a(j, i) /= unit;
      s.b[i] *= unit;
      s.c[i] /= unit;
    }
    CHECK(transfer_function(s, at.work, at.f) == Status::ok);
    CHECK_EQ(at.f.zeros.size, static_cast<int>(m));
    CHECK_NEAR(at.f.gain, -2.5, 1e-9);
    for (const C& zero : zeros) CHECK_LT(distance(at.f.zeros, zero), 1e-7);
    for (const C& pole : poles) CHECK_LT(distance(at.f.poles, pole), 1e-7);
    double phase_before = 0;
    for (double omega = 0.01; omega < 100; omega *= 1.7) {
      C expected = -2.5;
      for (const C& zero : zeros) expected *= C(0, omega) - zero;
      for (const C& pole : poles) expected /= C(0, omega) - pole;
      const C value = response(at.f, {0, omega}, at.response);
      CHECK_LT(std::abs(value - expected), 1e-9 * std::abs(expected));
      const double phase = continuous_phase(at.f, omega, value);
      CHECK_LT(std::abs(std::polar(1.0, phase) - expected / std::abs(expected)), 1e-8);
      if (omega > 0.011) CHECK_LT(std::abs(phase - phase_before), kPi<double>);
      phase_before = phase;
    }
  }
}

// d alone; nothing; an input that does not reach the output.
TEST(transfer_function_at_the_ends_of_its_range) {
  static Found at;
  Small s{};
  s.d = 3;
  CHECK(transfer_function(s, at.work, at.f) == Status::ok);
  CHECK_EQ(response(at.f, {0, 1}, at.response), C(3));
  s.states = 2;
  s.a(0, 0) = -1;
  s.a(1, 1) = -2;
  s.b[0] = 1;
  s.c[1] = 1;
  CHECK(transfer_function(s, at.work, at.f) == Status::ok);
  CHECK_NEAR(at.f.gain, 3, 0);
  s.d = 0;
  CHECK(transfer_function(s, at.work, at.f) == Status::ok);
  CHECK_EQ(at.f.gain, 0.0);
  CHECK_EQ(at.f.zeros.size, 0);
  // (s + 3)/(s + 1) = 1 + 2/(s + 1)
  s = {};
  s.states = 1;
  s.a(0, 0) = -1;
  s.b[0] = 2;
  s.c[0] = s.d = 1;
  CHECK(transfer_function(s, at.work, at.f) == Status::ok);
  CHECK_EQ(at.f.zeros.size, 1);
  CHECK_NEAR(at.f.zeros.real[0], -3, 1e-14);
  for (const int order : {-1, kOrder + 1}) {
    s.states = order;
    CHECK(transfer_function(s, at.work, at.f) == Status::bad_argument);
    CHECK(transmission_zeros(s, at.work.zeros, at.f.zeros, at.f.gain) == Status::bad_argument);
    CHECK_EQ(at.f.zeros.size, 0);
  }
}

// 10/(s (s + 1)(s + 5)): half a turn at sqrt(5), where its size is 1/3; a double integrator with a zero.
TEST(transfer_function_margins_and_bandwidth_in_closed_form) {
  static Found at;
  const Small s = companion(10, {}, {0, -1, -5});
  CHECK(transfer_function(s, at.work, at.f) == Status::ok);
  Margins<double> m;
  CHECK(margins(s, at.f, 1.0, at.work, at.response, m) == Status::ok);
  CHECK_NEAR(m.omega_gain, std::sqrt(5.0), 1e-12);
  CHECK_NEAR(m.gain, 3, 1e-12);
  CHECK_EQ(m.unstable_closed, 0);
  // |L| = 1 there, and what is left of half a turn.
  const double w = m.omega_phase;
  CHECK_NEAR(100, w * w * (1 + w * w) * (25 + w * w), 1e-9);
  CHECK_NEAR(m.phase, kPi<double> / 2 - std::atan(w) - std::atan(w / 5), 1e-12);
  CHECK_NEAR(m.delay, m.phase / w, 1e-14);
  CHECK(margins(s, at.f, 3.01, at.work, at.response, m) == Status::ok);
  CHECK_EQ(m.unstable_closed, 2);
  CHECK_LT(m.gain, 1);
  CHECK_LT(m.phase, 0);
  CHECK(margins(s, at.f, 2.99, at.work, at.response, m) == Status::ok);
  CHECK_EQ(m.unstable_closed, 0);

  const Bandwidth<double> b = bandwidth(at.f, at.response);
  CHECK_NEAR(b.omega_180, std::sqrt(5.0), 1e-12);
  CHECK_NEAR(std::atan(b.by_phase) + std::atan(b.by_phase / 5), kPi<double> / 4, 1e-12);
  const double g = b.by_gain;  // |G| = 2/3
  CHECK_NEAR(10 / (g * std::sqrt((1 + g * g) * (25 + g * g))), 2.0 / 3, 1e-12);
  CHECK_NEAR(b.rate_command, std::min(b.by_phase, b.by_gain), 0);
  const double twice = 2 * std::sqrt(5.0);
  CHECK_NEAR(b.phase_delay, (std::atan(twice) + std::atan(twice / 5) - kPi<double> / 2) / twice, 1e-12);

  // The sign of the input does not matter for the bandwidth.
  const Small turned = companion(-10, {}, {0, -1, -5});
  CHECK(transfer_function(turned, at.work, at.f) == Status::ok);
  CHECK_NEAR(bandwidth(at.f, at.response).by_phase, b.by_phase, 1e-12);
}

// 10/(s (s + 0.001)(s + 5)): 45 deg are left at 0.001 rad/s and below, slower than is looked for, while the gain
// doubles within: a rate response type has no bandwidth then.
TEST(transfer_function_bandwidth_of_a_rate_response_needs_phase_and_gain) {
  static Found at;
  CHECK(transfer_function(companion(10, {}, {0, -0.001, -5}), at.work, at.f) == Status::ok);
  const Bandwidth<double> b = bandwidth(at.f, at.response);
  CHECK_NEAR(b.omega_180, std::sqrt(0.005), 1e-10);
  CHECK(std::isnan(b.by_phase) && std::isnan(b.rate_command));
  const auto size = [](double w) { return 10 / (w * std::hypot(w, 0.001) * std::hypot(w, 5.0)); };
  CHECK_NEAR(size(b.by_gain), 2 * size(b.omega_180), 1e-9 * size(b.omega_180));
}

// The resonance crosses a gain of one twice beyond the first crossing, with more phase left and less time: the shortest of
// the three counts. Expected: every crossing of the closed form, bracketed here.
TEST(transfer_function_delay_margin_is_the_shortest_of_a_stable_loop) {
  static Found at;
  const C mode(-0.02, 8);
  const std::vector<C> poles = {0, mode, std::conj(mode)};
  const Small s = companion(10, {-2, -2}, poles);
  CHECK(transfer_function(s, at.work, at.f) == Status::ok);
  Margins<double> m;
  for (const double gain : {0.2, -0.2}) {
    CHECK(margins(s, at.f, gain, at.work, at.response, m) == Status::ok);
    const auto loop = [&](double w) {
      const C iw(0, w);
      return 10 * gain * (iw + 2.0) * (iw + 2.0) / (iw * (iw - mode) * (iw - std::conj(mode)));
    };
    double shortest = 1e300;
    int crossings = 0;
    for (double w = 0.01; w < 100; w *= 1.0001) {
      double low = w, high = w * 1.0001;
      if ((std::abs(loop(low)) < 1) == (std::abs(loop(high)) < 1)) continue;
      ++crossings;
      for (int k = 0; k < 60; ++k) {
        const double middle = (low + high) / 2;
        ((std::abs(loop(middle)) < 1) == (std::abs(loop(low)) < 1) ? low : high) = middle;
      }
      double left = std::arg(loop(low)) + kPi<double>;
      if (left < 0) left += 2 * kPi<double>;
      shortest = std::min(shortest, left / low);
    }
    CHECK_EQ(crossings, 3);
    if (m.unstable_closed == 0) {
      CHECK_NEAR(m.delay, shortest, 1e-8);
    } else {
      CHECK(std::isnan(m.delay) && !std::isnan(m.phase));
    }
    NOTE("gain " << gain << ": unstable " << m.unstable_closed << ", delay " << m.delay);
  }
}

// (s + 3)/(s + 1) answers at once: fed back by one or more it bears no delay; by less, that of |L| = 1.
TEST(transfer_function_delay_margin_of_a_loop_that_answers_at_once) {
  static Found at;
  Small s = companion(2, {}, {-1});
  s.d = 1;
  CHECK(transfer_function(s, at.work, at.f) == Status::ok);
  Margins<double> m;
  CHECK(margins(s, at.f, 1.0, at.work, at.response, m) == Status::ok);
  CHECK(m.unstable_closed == 0 && m.delay == 0);
  CHECK(margins(s, at.f, 0.5, at.work, at.response, m) == Status::ok);
  const double w = std::sqrt((9 * 0.25 - 1) / 0.75);  // |3 + i w| = 2 |1 + i w|
  CHECK_NEAR(m.delay, (kPi<double> + std::atan(w / 3) - std::atan(w)) / w, 1e-9);
}

// A loop that is not closed, and one whose output the input does not reach, have no margins.
TEST(transfer_function_without_a_loop_has_no_margins) {
  static Found at;
  Margins<double> m;
  const Small s = companion(10, {}, {0.5, -1, -5});
  CHECK(transfer_function(s, at.work, at.f) == Status::ok);
  CHECK(margins(s, at.f, 0.0, at.work, at.response, m) == Status::ok);
  CHECK(std::isnan(m.gain) && std::isnan(m.phase) && std::isnan(m.delay));
  CHECK(m.unstable_open == 1 && m.unstable_closed == 1);
  Small unreached = s;
  for (double& entry : unreached.b) entry = 0;
  CHECK(transfer_function(unreached, at.work, at.f) == Status::ok);
  CHECK(margins(unreached, at.f, 1.0, at.work, at.response, m) == Status::ok);
  CHECK(std::isnan(m.gain) && std::isnan(m.phase) && m.unstable_closed == 1);
  CHECK(std::isnan(bandwidth(at.f, at.response).omega_180));
}

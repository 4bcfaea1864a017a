// Laws of linear algebra on random matrices of every size: what an eigenvalue solver must keep under
// similarity, transposition, shift and scaling, and how it agrees with the LU factors.
#include <algorithm>
#include <complex>
#include <random>
#include <vector>

#include "check.hpp"
#include "tiltrotor/math/algebra/eigen.hpp"
#include "tiltrotor/math/algebra/lu.hpp"

using namespace tiltrotor;

namespace {

constexpr unsigned kSeed = 20260603;
constexpr int kOrder = 27;  // of the largest linear model
using Square = Matrix<double, kOrder, kOrder>;
using Spectrum = std::vector<std::complex<double>>;

struct Workspace {
  Square a{}, b{}, c{};
  EigenWorkspace<double, kOrder> work;
  Eigenvalues<double, kOrder> values;
  LU<double, kOrder> lu;
};
Workspace& workspace() {
  static Workspace r;
  return r;
}

void fill_random(std::mt19937& engine, int n, Square& a) {
  std::uniform_real_distribution<double> entry(-1, 1);
  set_zero(a);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) a(i, j) = entry(engine);
}

Spectrum spectrum(const Square& a, int n) {
  Workspace& r = workspace();
  CHECK(eigenvalues(a, n, r.work, r.values) == Status::ok);
  Spectrum s;
  for (int k = 0; k < n; ++k) s.emplace_back(r.values.real[k], r.values.imag[k]);
  return s;
}

// Largest distance when every eigenvalue of one is matched with the nearest one left of the other.
double distance(const Spectrum& a, Spectrum b) {
  double worst = 0;
  for (const std::complex<double>& x : a) {
    const auto nearest = std::min_element(
        b.begin(), b.end(), [&](const auto& p, const auto& q) { return std::abs(p - x) < std::abs(q - x); });
    worst = std::max(worst, std::abs(*nearest - x));
    b.erase(nearest);
  }
  return worst;
}

// b = H a H with the reflection H = I - 2 v v^T / v^T v.
void reflect(std::mt19937& engine, int n, const Square& a, Square& b) {
  std::uniform_real_distribution<double> entry(-1, 1);
  std::vector<double> v;
  double length2 = 0;
  for (int i = 0; i < n; ++i) {
    v.push_back(entry(engine));
    length2 += v.back() * v.back();
  }
  const auto at = [&](int i) { return v[static_cast<std::size_t>(i)]; };
  b = a;
  for (int j = 0; j < n; ++j) {
    double sum = 0;
    for (int i = 0; i < n; ++i) sum += at(i) * b(i, j);
    for (int i = 0; i < n; ++i) b(i, j) -= 2 * at(i) * sum / length2;
  }
  for (int i = 0; i < n; ++i) {
    double sum = 0;
    for (int j = 0; j < n; ++j) sum += b(i, j) * at(j);
    for (int j = 0; j < n; ++j) b(i, j) -= 2 * sum * at(j) / length2;
  }
}

}  // namespace

TEST(property_eigenvalues_keep_under_similarity) {
  NOTE("seed " << kSeed);
  std::mt19937 engine(kSeed);
  Workspace& r = workspace();
  for (int n = 2; n <= kOrder; ++n) {
    for (int k = 0; k < 4; ++k) {
      fill_random(engine, n, r.a);
      const Spectrum expected = spectrum(r.a, n);

      reflect(engine, n, r.a, r.b);
      CHECK_LT(distance(spectrum(r.b, n), expected), 1e-9);

      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) r.c(i, j) = r.a(j, i);
      CHECK_LT(distance(spectrum(r.c, n), expected), 1e-9);

      // A diagonal similarity by powers of two has no rounding; balancing has to undo it.
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) r.c(i, j) = std::ldexp(r.a(i, j), 7 * (i % 5) - 7 * (j % 5));
      CHECK_LT(distance(spectrum(r.c, n), expected), 1e-9);

      // A + 3 I, and 2^40 A.
      r.b = r.a;
      for (int i = 0; i < n; ++i) r.b(i, i) += 3;
      Spectrum shifted = expected;
      for (std::complex<double>& x : shifted) x += 3;
      CHECK_LT(distance(spectrum(r.b, n), shifted), 1e-9);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) r.b(i, j) = std::ldexp(r.a(i, j), 40);
      Spectrum larger = expected;
      for (std::complex<double>& x : larger) x *= std::ldexp(1.0, 40);
      CHECK_LT(distance(spectrum(r.b, n), larger), 1e-9 * std::ldexp(1.0, 40));
    }
  }
}

// The product of the eigenvalues is the determinant, with its sign: pivots of LU times the sign of the row
// exchanges.
TEST(property_eigenvalues_and_pivots_give_one_determinant) {
  NOTE("seed " << kSeed + 1);
  std::mt19937 engine(kSeed + 1);
  Workspace& r = workspace();
  for (int n = 1; n <= kOrder; ++n) {
    for (int k = 0; k < 4; ++k) {
      fill_random(engine, n, r.a);
      if (!CHECK(lu_factor(r.a, n, r.lu) == Status::ok)) return;
      double determinant = 1;
      std::vector<int> row(r.lu.row, r.lu.row + n);
      for (int i = 0; i < n; ++i) {
        determinant /= r.lu.inverse_pivot[i];
        while (row[static_cast<std::size_t>(i)] != i) {  // sort by exchanges
          std::swap(row[static_cast<std::size_t>(i)],
                    row[static_cast<std::size_t>(row[static_cast<std::size_t>(i)])]);
          determinant = -determinant;
        }
      }
      std::complex<double> product = 1;
      for (const std::complex<double>& x : spectrum(r.a, n)) product *= x;
      const double condition = 1 / lu_reciprocal_condition(r.lu);
      CHECK_NEAR(product, std::complex<double>(determinant), 1e-13 * condition * std::fabs(determinant));
    }
  }
}

// An eigenvalue makes A - lambda I singular: the reciprocal condition found there by LU is down at rounding.
TEST(property_eigenvalues_make_the_matrix_singular) {
  NOTE("seed " << kSeed + 2);
  std::mt19937 engine(kSeed + 2);
  Workspace& r = workspace();
  int tried = 0;
  for (int n = 1; n <= kOrder; ++n) {
    fill_random(engine, n, r.a);
    for (const std::complex<double>& x : spectrum(r.a, n)) {
      if (x.imag() != 0) continue;
      r.b = r.a;
      for (int i = 0; i < n; ++i) r.b(i, i) -= x.real();
      const Status status = lu_factor(r.b, n, r.lu);
      CHECK(status == Status::singular || lu_reciprocal_condition(r.lu) < 1e-12);
      ++tried;
    }
  }
  CHECK_LT(50, tried);
}

// Eigenvalues of a plant behind a dozen equal lags, as actuators make them: -100 eight times over, with few eigenvectors.
// Expected: all are found; their number at -100 follows from the structure, sums of powers from the matrix.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "check.hpp"
#include "tiltrotor/math/algebra/eigen.hpp"

using namespace tiltrotor;

namespace {

constexpr int kPlant = 4, kLags = 12, kOrder = kPlant + kLags;
EigenWorkspace<double, kOrder> work;
Eigenvalues<double, kOrder> values;

// -1..1, a linear congruence.
double next(std::uint64_t& state) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return static_cast<double>(state >> 33) / 1073741824.0 - 1;
}

}  // namespace

TEST(eigen_of_equal_lags_are_all_found) {
  int most = 0;
  double worst = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    std::uint64_t state = seed;
    Matrix<double, kOrder, kOrder> a{};
    for (int i = 0; i < kOrder; ++i)
      for (int j = 0; j < kOrder; ++j) {
        const double x = next(state);
        if (i < kPlant) a(i, j) = (j < kPlant ? 1 : 0.003) * x;
        if (i >= kPlant && j < kPlant) a(i, j) = 3 * x;
        if (i >= kPlant && j == i) a(i, j) = -100;
      }
    if (!CHECK(eigenvalues(a, kOrder, work, values) == Status::ok)) return;
    most = std::max(most, values.sweeps);
    double sum = 0, squares = 0, trace = 0, trace_of_square = 0;
    int equal = 0;
    for (int i = 0; i < kOrder; ++i) {
      sum += values.real[i];
      squares += values.real[i] * values.real[i] - values.imag[i] * values.imag[i];
      equal += std::hypot(values.real[i] + 100, values.imag[i]) < 1e-4;
      trace += a(i, i);
      for (int j = 0; j < kOrder; ++j) trace_of_square += a(i, j) * a(j, i);
    }
    CHECK(equal >= kLags - kPlant);
    CHECK_REL(sum, trace, 1e-12);
    CHECK_REL(squares, trace_of_square, 1e-12);
    worst = std::max(worst, std::abs(sum / trace - 1));
  }
  NOTE("at most " << most << " sweeps; sum off by " << worst);
  CHECK_LT(most, 10 * kOrder);
}

// Both policies on functions of a few numbers whose derivatives are known in closed form: what they return,
// where they evaluate, and that every entry is delivered once.
#include "tiltrotor/analysis/linear/differentiation.hpp"

#include <string>
#include <vector>

#include "check.hpp"
#include "tiltrotor/model/variables/controls.hpp"

using namespace tiltrotor;

namespace {

constexpr int kInputs = 7;
constexpr int kOutputs = 4;

// y_i = sum over j of (i + 1) (j + 2) x_j^3 + x_j x_k, with k the next input: every entry differs.
template <class Input, class Output>
void cubic(const Input& x, Output&& output, int n, int m) {
  for (int i = 0; i < m; ++i) {
    auto y = x[0] * 0.0;
    for (int j = 0; j < n; ++j)
      y = y + static_cast<double>((i + 1) * (j + 2)) * (x[j] * x[j] * x[j]) + x[j] * x[(j + 1) % n];
    output(i, y);
  }
}
void cubic(const double* x, double* y, int n, int m) { cubic(x, PlainOutputs<double>{y}, n, m); }
double cubic_slope(const double* x, int n, int i, int j) {
  const double neighbours = n == 1 ? 2 * x[0] : n == 2 ? 2 * x[1 - j] : x[(j + 1) % n] + x[(j + n - 1) % n];
  return 3.0 * (i + 1) * (j + 2) * x[j] * x[j] + neighbours;
}

// Entries as they are put, and how often.
struct Record {
  double slope[kOutputs][kInputs] = {};
  int times[kOutputs][kInputs] = {};
  int outside = 0;
  void put(int i, int j, double value) {
    if (i < 0 || j < 0 || i >= kOutputs || j >= kInputs) {
      ++outside;
      return;
    }
    slope[i][j] = value;
    ++times[i][j];
  }
  // As a policy puts them: `count` of row i from column j on.
  auto row() {
    return [this](int i, int j, int count, const double* value) {
      for (int k = 0; k < count; ++k) put(i, j + k, value[k]);
    };
  }
  // Each entry of m x n once and nothing else.
  void check_complete(int n, int m) const {
    CHECK_EQ(outside, 0);
    for (int i = 0; i < kOutputs; ++i)
      for (int j = 0; j < kInputs; ++j) CHECK_EQ(times[i][j], i < m && j < n ? 1 : 0);
  }
};

const double kPoint[kInputs] = {0.5, -1.25, 2, 0, -3, 0.125, 1.5};

}  // namespace

// Passes of three directions: sizes below, at and between multiples of it.
TEST(differentiation_automatic_is_exact) {
  AutoDiff::Workspace<double, 3, kInputs, kOutputs> work;
  for (int n = 1; n <= kInputs; ++n) {
    for (int m = 1; m <= kOutputs; ++m) {
      Record record;
      int passes = 0;
      double y[kOutputs], plain[kOutputs];
      AutoDiff::jacobian(
          [&](const auto& x, auto&& out) {
            ++passes;
            cubic(x, out, n, m);
          },
          {n, m, kPoint, nullptr, y}, work, record.row());
      CHECK_EQ(passes, (n + 2) / 3);
      record.check_complete(n, m);
      cubic(kPoint, plain, n, m);
      for (int i = 0; i < m; ++i) {
        CHECK_EQ(y[i], plain[i]);
        for (int j = 0; j < n; ++j) CHECK_NEAR(record.slope[i][j], cubic_slope(kPoint, n, i, j), 1e-13 * 800);
      }
    }
  }
}

// Of a cubic a x^3 the central difference is 3 a x^2 + a h^2, without remainder: it tells the step.
TEST(differentiation_numerical_step_and_error) {
  NumDiff::Workspace<double, 1, kInputs, kOutputs> work;
  const double cube_root_of_eps = std::pow(2.0, -52.0 / 3);
  const double scale[kInputs] = {1000, 500, 2000, 4000, 800, 1e4, 3000};
  for (int n = 1; n <= kInputs; ++n) {
    for (int m = 1; m <= kOutputs; ++m) {
      Record record;
      double y[kOutputs], plain[kOutputs];
      NumDiff::jacobian([&](const auto& x, auto&& out) { cubic(x, out, n, m); }, {n, m, kPoint, scale, y},
                        work, record.row());
      record.check_complete(n, m);
      cubic(kPoint, plain, n, m);
      for (int i = 0; i < m; ++i) {
        CHECK_EQ(y[i], plain[i]);
        for (int j = 0; j < n; ++j) {
          const double h = cube_root_of_eps * scale[j];
          const double cube = (i + 1) * (j + 2);
          const double error = record.slope[i][j] - cubic_slope(kPoint, n, i, j);
          CHECK_NEAR(error, cube * h * h, 1e-9 + 1e-6 * cube * h * h);  // rounding: eps 1000 / h
        }
      }
    }
  }
}

// 2 n + 1 evaluations: the point, then one input at a time the same distance above and below.
TEST(differentiation_numerical_moves_one_input_at_a_time) {
  NumDiff::Workspace<double, 1, kInputs, kOutputs> work;
  const double scale[kInputs] = {1, 10, 0.1, 1, 10, 0.1, 1};
  std::vector<std::vector<double>> places;
  double y[kOutputs];
  NumDiff::jacobian(
      [&](const auto& x, auto&& out) {
        places.emplace_back(x.x, x.x + kInputs);
        cubic(x, out, kInputs, 1);
      },
      {kInputs, 1, kPoint, scale, y}, work, [](int, int, int, const double*) {});
  if (!CHECK_EQ(places.size(), 2u * kInputs + 1)) return;
  for (std::size_t k = 0; k < places.size(); ++k) {
    for (std::size_t j = 0; j < kInputs; ++j) {
      const double moved = places[k][j] - kPoint[j];
      if (k == 0 || (k - 1) / 2 != j) {
        CHECK_EQ(moved, 0.0);
      } else {
        const double h = std::pow(2.0, -52.0 / 3) * scale[j];
        CHECK_NEAR(k % 2 == 1 ? moved : -moved, h, 1e-15);
      }
    }
  }
}

// By the unit of its name: speeds and places 10, rates of flapping 10, body rates and angles 1, inflow 0.1.
TEST(differentiation_scales_follow_from_units) {
  for (int i = 0; i < state_count; ++i) {
    const std::string name = kStateVariables[i].name, unit = kStateVariables[i].unit();
    const double expected = unit == "m/s" || unit == "m"        ? 10
                            : unit == "-"                       ? 0.1
                            : name[0] == 'd' && unit == "rad/s" ? 10
                                                                : 1;
    if (!CHECK_EQ(state_scale<double>(i), expected)) NOTE(name);
  }
  for (int j = 0; j < control_count; ++j) {
    CHECK_EQ(control_scale<double>(j), std::string(kControlVariables[j].unit()) == "m/s" ? 10.0 : 1.0);
  }
}

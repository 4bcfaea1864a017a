// A and B: against a second implementation, against complex steps and central differences, and by symmetry.
#include <algorithm>
#include <complex>
#include <cstring>

#include "analysis_case.hpp"
#include "tiltrotor/analysis/linear/linear_eigenvalues.hpp"
#include "tiltrotor/math/differentiation/complex_step.hpp"

using namespace analysis_case;

namespace {

// Largest difference of a row over its largest entry.
template <class Entry, class Expected>
double row_error(int columns, Entry&& entry, Expected&& expected) {
  double scale = 0, error = 0;
  for (int j = 0; j < columns; ++j) {
    scale = std::max(scale, std::abs(expected(j)));
    error = std::max(error, std::abs(entry(j) - expected(j)));
  }
  return scale > 0 ? error / scale : error;
}

}  // namespace

// tests/reference: exact Jacobians of a second implementation at its own trim points.
TEST_OF_XV15(linearize_reference_matrices) {
  static LinearModel<double> model;
  for (int k = 0; k < 3; ++k) {
    const std::string name = kReferencePoints[k];
    const Configuration<double> c = reference_configuration(kReferenceMasts[k]);
    const Point p = reference_point(name);
    linear_model(c, p.x, p.u, kInceptors, model);
    const check::CsvFile a("tests/reference/A_" + name + ".csv");
    const check::CsvFile b("tests/reference/B_" + name + ".csv");
    double worst_a = 0, worst_b = 0;
    CHECK_EQ(model.states, 23);
    for (int i = 0; i < model.states; ++i) {
      const int row = model.state[i];  // the files list all states in the order of State
      CHECK_EQ(a.text(row, "row"), model.state_name(i));
      worst_a = std::max(worst_a, row_error(
                                      model.states, [&](int j) { return model.a(i, j); },
                                      [&](int j) { return a.number(row, model.state_name(j)); }));
      worst_b = std::max(worst_b, row_error(
                                      4, [&](int j) { return model.b(i, j); },
                                      [&](int j) { return b.number(row, kReferenceControls[j]); }));
    }
    CHECK_LT(worst_a, 1e-8);
    CHECK_LT(worst_b, 1e-8);
    NOTE(name << ": A within " << worst_a << ", B within " << worst_b << " of the largest entry of the row");
  }
}

// Complex arithmetic shares nothing with dual numbers: f(x + i h) / h.
TEST(linearize_equals_complex_step) {
  static LinearModel<double> model;
  using Complex = std::complex<double>;
  const Configuration<double> c = configuration(30);
  const Point p = slanted_point();
  linear_model(c, p.x, p.u, kAllControls, model);
  double x[state_count], u[control_count];
  flatten(p.x, x);
  flatten(p.u, u);
  const double h = 1e-30;
  static double expected[kMaxLinearStates][kMaxLinearStates + kMaxLinearControls];
  const int n = model.states, m = model.controls;
  for (int j = 0; j < n + m; ++j) {
    Complex cx[state_count], cu[control_count], rates[state_count];
    for (int i = 0; i < state_count; ++i) cx[i] = x[i];
    for (int i = 0; i < control_count; ++i) cu[i] = u[i];
    (j < n ? cx[model.state[j]] : cu[model.control[j - n]]) += Complex(0, h);
    State<Complex> state, xdot;
    Controls<Complex> controls;
    unflatten(cx, state);
    unflatten(cu, controls);
    derivative(c, state, controls, xdot);
    flatten(xdot, rates);
    for (int i = 0; i < n; ++i) expected[i][j] = rates[model.state[i]].imag() / h;
  }
  double worst = 0;
  for (int i = 0; i < n; ++i) {
    worst = std::max(worst, row_error(
                                n + m, [&](int j) { return j < n ? model.a(i, j) : model.b(i, j - n); },
                                [&](int j) { return expected[i][j]; }));
  }
  CHECK_LT(worst, 1e-12);
  NOTE("worst " << worst);
}

TEST(linearize_automatic_and_numerical_agree) {
  static LinearModel<double> exact, differences;
  static LinearizationWorkspace<double, AutoDiff> automatic;
  static LinearizationWorkspace<double, NumDiff> numerical;
  const Configuration<double> c = configuration(30);
  for (const Point& p : {slanted_point(), reference_point("mast30_v050")}) {
    CHECK(linearize(c, p.x, p.u, kAllControls, automatic, exact) == Status::ok);
    CHECK(linearize(c, p.x, p.u, kAllControls, numerical, differences) == Status::ok);
    double worst = 0;
    for (int i = 0; i < exact.states; ++i) {
      CHECK_EQ(exact.rates[i], differences.rates[i]);  // same operations on the value
      worst = std::max(worst, row_error(
                                  exact.states, [&](int j) { return differences.a(i, j); },
                                  [&](int j) { return exact.a(i, j); }));
      worst = std::max(worst, row_error(
                                  exact.controls, [&](int j) { return differences.b(i, j); },
                                  [&](int j) { return exact.b(i, j); }));
    }
    // The C1 tables bend abruptly at their knots: a difference across one is off by its step, 6e-6, times the
    // bend.
    CHECK_LT(worst, 2e-6);
    NOTE("central differences within " << worst);
  }
}

// A policy's Jacobian of a function whose derivatives are written by hand.
TEST(differentiation_policies_on_a_known_function) {
  const auto f = [](const auto& x, auto&& y) {
    y(0, x[0] * x[0] * x[1]);
    y(1, sin(x[1]) / x[2]);
  };
  const double x[] = {1.5, 0.7, -2.0};
  const double expected[2][3] = {{2 * 1.5 * 0.7, 1.5 * 1.5, 0},
                                 {0, std::cos(0.7) / -2.0, -std::sin(0.7) / 4.0}};
  const double scale[] = {1, 1, 1};
  double y[2], j[2][3] = {};
  const auto put = [&](int row, int column, int count, const double* slope) {
    for (int k = 0; k < count; ++k) j[row][column + k] = slope[k];
  };
  AutoDiff::Workspace<double, 2, 3, 2> automatic;  // two passes of two directions
  AutoDiff::jacobian(f, {3, 2, x, scale, y}, automatic, put);
  CHECK_NEAR(y[0], 1.5 * 1.5 * 0.7, 1e-15);
  for (int r = 0; r < 2; ++r)
    for (int k = 0; k < 3; ++k) CHECK_NEAR(j[r][k], expected[r][k], 1e-15);
  NumDiff::Workspace<double, 2, 3, 2> numerical;
  NumDiff::jacobian(f, {3, 2, x, scale, y}, numerical, put);
  for (int r = 0; r < 2; ++r)
    for (int k = 0; k < 3; ++k) CHECK_NEAR(j[r][k], expected[r][k], 1e-9);
}

// More controls than one pass has directions: a second pass changes no bit of the others.
TEST(linearize_in_two_passes_equals_one) {
  static LinearModel<double> one, two;
  const Configuration<double> c = configuration(30);
  const Point p = slanted_point();
  linear_model(c, p.x, p.u, kInceptors, one);
  linear_model(c, p.x, p.u, kAllControls, two);
  CHECK(one.states + one.controls <= kModelDirections);
  CHECK(two.states + two.controls > kModelDirections);
  for (int i = 0; i < one.states; ++i) {
    for (int j = 0; j < one.states; ++j) CHECK_EQ(one.a(i, j), two.a(i, j));
    for (int j = 0; j < one.controls; ++j) CHECK_EQ(one.b(i, j), two.b(i, j));
  }
}

TEST(linearize_leaves_the_model_untouched) {
  static LinearModel<double> first, second;
  static Configuration<double> c, copy;
  c = configuration(60);
  std::memcpy(static_cast<void*>(&copy), &c, sizeof c);
  const Point p = reference_point("mast30_v050");
  Point kept;
  std::memcpy(static_cast<void*>(&kept), &p, sizeof p);
  State<double> before, after;
  derivative(c, p.x, p.u, before);
  linear_model(c, p.x, p.u, kAllControls, first);
  derivative(c, p.x, p.u, after);
  linear_model(c, p.x, p.u, kAllControls, second);
  CHECK_EQ(std::memcmp(&copy, &c, sizeof c), 0);
  CHECK_EQ(std::memcmp(&kept, &p, sizeof p), 0);
  CHECK_EQ(std::memcmp(&before, &after, sizeof before), 0);
  CHECK_EQ(std::memcmp(&first.a, &second.a, sizeof first.a), 0);
  CHECK_EQ(std::memcmp(&first.b, &second.b, sizeof first.b), 0);
}

// Direct increments of blade angles act as the gearing does: a column in inches is a combination of columns
// in radians.
TEST(linearize_inceptors_are_combinations_of_blade_angles) {
  static LinearModel<double> inches, angles;
  const Configuration<double> c = configuration(30);
  const Point p = reference_point("mast30_v050");
  linear_model(c, p.x, p.u, kInceptors, inches);
  linear_model(c, p.x, p.u, kBladeControls, angles);
  CHECK_EQ(std::string(angles.control_name(1)), "long_cyclic");
  const double gain[] = {c.gearing.long_cyclic, c.gearing.elevator};
  for (int i = 0; i < inches.states; ++i) {
    const double stick = gain[0] * angles.b(i, 1) + gain[1] * angles.b(i, 4);
    CHECK_NEAR(inches.b(i, 1), stick, 1e-12 * (1 + std::abs(stick)));
    const double lateral =
        -c.gearing.lateral_collective * angles.b(i, 2) + c.gearing.aileron * angles.b(i, 5);
    CHECK_NEAR(inches.b(i, 2), lateral, 1e-12 * (1 + std::abs(lateral)));
  }
}

// Eigenvalues by halves against those of A as a whole, in symmetric and in slanted flight; and what stands
// for a coupling.
TEST(linear_eigenvalues_by_halves) {
  static LinearModel<double> model;
  static LinearEigenvaluesWorkspace<double> work;
  static EigenWorkspace<double, kMaxLinearStates> whole_work;
  static Eigenvalues<double, kMaxLinearStates> values, whole;
  for (int k = 0; k < 4; ++k) {
    const Point p = k < 3 ? reference_point(kReferencePoints[k]) : slanted_point();
    linear_model(configuration(k < 3 ? kReferenceMasts[k] : 30), p.x, p.u, kInceptors, model);
    CHECK(eigenvalues(model, work, values) == Status::ok);
    CHECK(eigenvalues(model.a, model.states, whole_work, whole) == Status::ok);
    CHECK_EQ(decoupled(work.split), k < 3);
    CHECK_EQ(values.size, 23);
    CHECK_EQ(values.converged, 23);
    double trace = 0;
    for (int i = 0; i < values.size; ++i) {
      trace += values.real[i] - model.a(i, i);
      double nearest = 1e9;
      for (int j = 0; j < whole.size; ++j)
        nearest =
            std::min(nearest, std::hypot(values.real[i] - whole.real[j], values.imag[i] - whole.imag[j]));
      CHECK_LT(nearest, 1e-9);
    }
    CHECK_NEAR(trace, 0, 1e-9);
  }
  SplitModel<double> halves = {};
  halves.largest = 1000;
  halves.coupling = 1e-13;
  CHECK(decoupled(halves));
  halves.coupling = 1e-11;
  CHECK(!decoupled(halves));
  model.a(0, 5) = std::nan("");
  CHECK(eigenvalues(model, work, values) == Status::not_finite);
}

TEST(linearize_refuses_bad_input) {
  static LinearModel<double> model;
  static LinearizationWorkspace<double> work;
  const Configuration<double> c = configuration(0);
  Point p = reference_point("mast00_v000");
  CHECK(linearize(c, p.x, p.u, ControlSet{1, {control_count}}, work, model) == Status::bad_argument);
  CHECK_EQ(model.states, 0);
  CHECK(linearize(c, p.x, p.u, ControlSet{1, {-1}}, work, model) == Status::bad_argument);
  CHECK(linearize(c, p.x, p.u, ControlSet{kMaxLinearControls + 1, {}}, work, model) == Status::bad_argument);
  CHECK(linearize(c, p.x, p.u, ControlSet{-1, {}}, work, model) == Status::bad_argument);
  CHECK(linearize(c, p.x, p.u, ControlSet{0, {}}, work, model) == Status::ok);
  CHECK_EQ(model.controls, 0);
  p.x.velocity.x = std::nan("");
  CHECK(linearize(c, p.x, p.u, kInceptors, work, model) == Status::not_finite);
  CHECK(linearize(Configuration<double>{}, p.x, p.u, kInceptors, work, model) == Status::bad_argument);
}

namespace {

// A model of these states alone, with nothing in it.
LinearModel<double>& empty_model(std::initializer_list<int> states) {
  static LinearModel<double> model;
  clear(model);
  set_zero(model.a);
  for (int state : states) model.state[model.states++] = state;
  return model;
}

}  // namespace

// Models that are not an aircraft's: one state; a rotor without its partner, which has no mean or difference;
// and a root beyond the range in either half.
TEST(linear_eigenvalues_of_unusual_models) {
  static LinearEigenvaluesWorkspace<double> work;
  static Eigenvalues<double, kMaxLinearStates> values;
  LinearModel<double>& one = empty_model({kStateIndex.velocity.z});
  one.a(0, 0) = -0.7;
  CHECK(eigenvalues(one, work, values) == Status::ok);
  CHECK(values.size == 1 && values.real[0] == -0.7 && values.imag[0] == 0);
  for (int rotor :
       {static_cast<int>(kStateIndex.rotor[left].b1c), static_cast<int>(kStateIndex.rotor[right].b1c)}) {
    LinearModel<double>& unmatched = empty_model({kStateIndex.velocity.x, rotor, kStateIndex.velocity.y});
    for (int i = 0; i < 3; ++i) unmatched.a(i, i) = -1 - i;
    CHECK(eigenvalues(unmatched, work, values) == Status::ok);
    if (!CHECK_EQ(values.size, 3)) continue;
    std::sort(values.real, values.real + 3);
    CHECK(values.real[0] == -3 && values.real[1] == -2 && values.real[2] == -1);
  }
  const double largest = std::numeric_limits<double>::max();
  for (int half : {0, 2}) {
    LinearModel<double>& model = empty_model(
        {kStateIndex.velocity.x, kStateIndex.velocity.z, kStateIndex.velocity.y, kStateIndex.rates.x});
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        model.a(half + i, half + j) = largest;  // twice the largest number, and zero
    CHECK(eigenvalues(model, work, values) == Status::not_finite);
    CHECK(decoupled(work.split));
  }
  CHECK(eigenvalues(empty_model({}), work, values) == Status::bad_argument);
}

namespace {

// Exact differentiation that loses the columns of the controls when told to.
bool controls_lost = false;
struct NoControls : AutoDiff {
  template <class R, int N, int MaxInputs, int MaxOutputs, class Function, class Put>
  static void jacobian(Function&& f, const JacobianRequest<R>& at,
                       Workspace<R, N, MaxInputs, MaxOutputs>& work, Put&& put) {
    AutoDiff::jacobian(f, at, work, [&](int i, int first, int count, const R* slope) {
      for (int j = first; j < first + count; ++j) {
        const bool lost = controls_lost && j >= at.inputs - kInceptors.count;
        const R found = lost ? std::numeric_limits<R>::quiet_NaN() : slope[j - first];
        put(i, j, 1, &found);
      }
    });
  }
};

}  // namespace

TEST(linearize_reports_what_is_no_number_in_b) {
  static LinearizationWorkspace<double, NoControls> work;
  static LinearModel<double> model;
  const Configuration<double> c = configuration(30);
  const Point p = reference_point("mast30_v050");
  controls_lost = false;
  CHECK(linearize(c, p.x, p.u, kInceptors, work, model) == Status::ok);
  controls_lost = true;
  CHECK(linearize(c, p.x, p.u, kInceptors, work, model) == Status::not_finite);
  CHECK(all_finite(model.a, model.states, model.states));
}

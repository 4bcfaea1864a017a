// The build with numerical differences: the same trim points, A and B to the accuracy differences allow, and
// the program itself beside the automatic one.
// Expected: the exact derivatives, and the error of central differences by Taylor.
#include <algorithm>
#include <cstdlib>

#include "analysis_case.hpp"
#include "cli/csv_text.hpp"
#include "run_program.hpp"

using namespace analysis_case;

namespace {

struct Level {
  double mast_deg, speed_mps;
};
constexpr Level kFlights[] = {{0, 0},   {0, 25},  {0, 50},  {30, 25}, {30, 50},
                              {60, 50}, {60, 85}, {90, 60}, {90, 140}};

TrimResult<double> numerically_trimmed(const Configuration<double>& c, const SteadyFlight<double>& flight) {
  static TrimWorkspace<double, NumDiff> work;
  TrimResult<double> result;
  CHECK(is_trimmed(trim(c, flight, work, result)));
  return result;
}

// Scale of column j of A, then of B, in which NumDiff takes its step.
double column_scale(const LinearModel<double>& m, int j) {
  return j < m.states ? state_scale<double>(m.state[j]) : control_scale<double>(m.control[j - m.states]);
}

// Largest difference of an entry of A or B over the largest of its row, columns brought to the same scale.
double largest_difference(const LinearModel<double>& exact, const LinearModel<double>& other) {
  double worst = 0;
  for (int i = 0; i < exact.states; ++i) {
    double size = 0;
    double difference = 0;
    for (int j = 0; j < exact.states + exact.controls; ++j) {
      const double e = j < exact.states ? exact.a(i, j) : exact.b(i, j - exact.states);
      const double o = j < exact.states ? other.a(i, j) : other.b(i, j - exact.states);
      size = std::max(size, std::abs(e) * column_scale(exact, j));
      difference = std::max(difference, std::abs(e - o) * column_scale(exact, j));
    }
    if (size > 0) worst = std::max(worst, difference / size);
  }
  return worst;
}

}  // namespace

// Both solve to a residual of 1e-10; states and controls follow from it through the inverse of the Jacobian.
TEST(numdiff_trims_to_the_same_point) {
  double worst = 0;
  for (const Level& at : kFlights) {
    const Configuration<double> c = flown_configuration(at.mast_deg);
    const TrimResult<double> a = trimmed(c, flown(level(at.speed_mps)));
    const TrimResult<double> n = numerically_trimmed(c, flown(level(at.speed_mps)));
    double x[state_count], y[state_count];
    flatten(a.state, x);
    flatten(n.state, y);
    for (int i = 0; i < state_count; ++i)
      worst = std::max(worst, std::abs(x[i] - y[i]) / state_scale<double>(i));
    double u[control_count], w[control_count];
    flatten(a.controls, u);
    flatten(n.controls, w);
    for (int j = 0; j < control_count; ++j)
      worst = std::max(worst, std::abs(u[j] - w[j]) / control_scale<double>(j));
  }
  CHECK_LT(worst, 1e-8);
  NOTE("largest scaled difference of a state or control " << worst);
}

// A step h = cbrt(eps) leaves h^2 times a third derivative. Smoothing widths bend over a hundredth of the
// scale, which makes some 1e4 h^2 = 4e-7; and where a table's second derivative jumps under the point
// (sideslip zero), h itself times the jump. The rest is rounding, eps / h = 4e-11. `make bench` draws the
// curve (step_size.csv).
TEST(numdiff_linear_models_agree) {
  static LinearizationWorkspace<double, NumDiff> numerical_work;
  static LinearModel<double> exact, numerical;
  double worst = 0;
  for (const Level& at : kFlights) {
    const Configuration<double> c = configuration(at.mast_deg);
    const TrimResult<double> t = trimmed(c, level(at.speed_mps));
    linear_model(c, t.state, t.controls, kBladeControls, exact);
    CHECK(linearize(c, t.state, t.controls, kBladeControls, numerical_work, numerical) == Status::ok);
    for (int i = 0; i < exact.states; ++i)
      CHECK_EQ(exact.rates[i], numerical.rates[i]);  // the same plain evaluation
    worst = std::max(worst, largest_difference(exact, numerical));
  }
  CHECK_LT(worst, 2e-6);
  NOTE("largest difference in A and B, over the largest entry of the row " << worst);
}

TEST(numdiff_program_prints_the_same_trims) {
  const std::string command = " trim --mast 0,60 --speed 50 --format csv";
  const check::ProgramResult automatic = check::run_program(check::built("tiltrotor") + command);
  const check::ProgramResult numerical = check::run_program(check::built("tiltrotor-nd") + command);
  CHECK_EQ(automatic.exit_status, numerical.exit_status);
  const check::CsvText a(automatic.out);
  const check::CsvText n(numerical.out);
  if (!CHECK(a.columns == n.columns && a.rows.size() == n.rows.size() && !a.rows.empty())) return;
  for (std::size_t row = 0; row < a.rows.size(); ++row) {
    for (std::size_t k = 0; k < a.columns.size(); ++k) {
      const std::string& column = a.columns[k];
      if (column == "iterations" || column == "residual") continue;
      char* end = nullptr;
      const double expected = std::strtod(a.rows[row][k].c_str(), &end);
      if (end == a.rows[row][k].c_str()) {
        CHECK_EQ(a.rows[row][k], n.rows[row][k]);
      } else {
        CHECK_NEAR(std::strtod(n.rows[row][k].c_str(), nullptr), expected, 1e-6 * (1 + std::abs(expected)));
      }
    }
  }
}

TEST(numdiff_program_names_its_differentiation) {
  CHECK(check::run_program(check::built("tiltrotor-nd") + " version").out.find("numerical") !=
        std::string::npos);
  CHECK(check::run_program(check::built("tiltrotor") + " version").out.find("automatic") !=
        std::string::npos);
}

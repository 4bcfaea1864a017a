#include "study/step_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "plot/plot.hpp"
#include "study/drawn_with.hpp"
#include "study/linear_models.hpp"
#include "study/wording.hpp"

namespace tiltrotor::study {

using namespace plot;

namespace {

struct Case {
  double mast_deg, speed_mps;
  const char* name;
  const char* color;
};
const Case kCases[] = {{0, 30, "mast 0 deg, 30 m/s", kBlue},
                       {60, 65, "mast 60 deg, 65 m/s", kOrange},
                       {90, 100, "mast 90 deg, 100 m/s", kGreen}};
constexpr int kStepsPerDecade = 4;
constexpr int kFirstDecade = -13;
constexpr int kLastDecade = -1;

// Largest error of A by central differences with steps of `relative` times the scale of each state, over the
// largest entry of its row; every column in units of its state's scale.
double worst_error(const Configured& c, const Trimmed& trim, const Linear& exact, double relative) {
  const int n = exact.states;
  std::vector<double> size(static_cast<std::size_t>(n), 0.0);
  std::vector<double> error(static_cast<std::size_t>(n), 0.0);
  const auto rates_at = [&](int state, double value, double* rates) {
    double x[state_count];
    flatten(trim.state, x);
    x[state] = value;
    State<double> moved{};
    State<double> xdot{};
    unflatten(x, moved);
    derivative(c, moved, trim.controls, xdot);
    flatten(xdot, rates);
  };
  for (int j = 0; j < n; ++j) {
    const int state = exact.state[j];
    const double scale = state_scale<double>(state);
    const double above = exact.x[j] + relative * scale;
    const double below = exact.x[j] - relative * scale;
    double plus[state_count];
    double minus[state_count];
    rates_at(state, above, plus);
    rates_at(state, below, minus);
    for (int i = 0; i < n; ++i) {
      const auto row = static_cast<std::size_t>(i);
      const double slope = (plus[exact.state[i]] - minus[exact.state[i]]) / (above - below);
      size[row] = std::max(size[row], std::fabs(exact.a(i, j) * scale));
      error[row] = std::max(error[row], std::fabs(slope - exact.a(i, j)) * scale);
    }
  }
  double worst = 0;
  for (std::size_t i = 0; i < size.size(); ++i)
    if (size[i] > 0) worst = std::max(worst, error[i] / size[i]);
  return worst;
}

}  // namespace

void add_step_error(Section& section) {
  Table table({"mast_deg", "speed_mps", "relative_step", "largest_error"});
  table.comment(
      "relative_step: over the scale of the state; largest_error: of A, over its row's largest entry.");
  Plot plot;
  plot.id = "step_error";
  plot.title = "Error of central differences over their step";
  plot.note = drawn_with();
  plot.x.label = "Step over the scale of the state";
  plot.y.label = "Largest error over the row's largest entry";
  plot.x.logarithmic = plot.y.logarithmic = true;
  double best = std::numeric_limits<double>::infinity();
  double best_step = 0;
  for (const Case& which : kCases) {
    const Configured c = configured(which.mast_deg);
    const Trimmed trim = trimmed_persistently(c, which.speed_mps);
    const auto exact = std::make_unique<Linear>(linear_model(c, trim.state, trim.controls, kInceptors));
    Series s;
    s.name = which.name;
    s.color = which.color;
    for (int k = kFirstDecade * kStepsPerDecade; k <= kLastDecade * kStepsPerDecade; ++k) {
      const double step = std::pow(10.0, static_cast<double>(k) / kStepsPerDecade);
      const double error = worst_error(c, trim, *exact, step);
      table.add({which.mast_deg, which.speed_mps, step, error});
      s.x.push_back(step);
      s.y.push_back(error);
      if (error < best) {
        best = error;
        best_step = step;
      }
    }
    plot.series.push_back(s);
  }
  section.findings.push_back(
      {Finding::remark,
       "Central differences reach " + fixed(1e9 * best, 1) +
           " billionths of a row's largest entry at best, with steps of " + fixed(1e6 * best_step, 1) +
           " millionths of the scale of a state.",
       "Shorter steps lose digits to rounding, longer ones to curvature: no one step suits every entry. "
       "Exact derivatives have neither error."});
  section.pictures.push_back({plot.id, svg(plot)});
  section.tables.push_back({"step_error", "errors of central differences", table});
}

}  // namespace tiltrotor::study

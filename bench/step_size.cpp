// Error of numerical differences against exact derivatives over the step: the V-shaped curve, and its lowest
// point.
#include <cmath>
#include <limits>
#include <memory>
#include <sstream>

#include "flights.hpp"
#include "machine.hpp"
#include "results.hpp"

using namespace bench;

namespace {

constexpr struct { double mast_deg, speed_mps; } kPoints[] = {{0, 0}, {0, 30}, {30, 50}, {60, 65}, {90, 100}};
constexpr int kStepsPerDecade = 4;
constexpr int kSmallest = -13 * kStepsPerDecade;
constexpr int kLargest = -1 * kStepsPerDecade;

constexpr int kInputs = 30;  // 23 states, 7 blade controls

struct Jacobian {
  double entry[kMaxLinearStates][kInputs];
  double scale[kInputs];
  int rows;
};

// f over 23 states and 7 controls, as linearize() sees it, differentiated with step `relative` times the
// scale of each input; exactly when `relative` is zero.
void jacobian(const FlightPoint& p, double relative, Jacobian& out) {
  static LinearizationWorkspace<double, AutoDiff> exact;
  static LinearModel<double> model;
  require(linearize(p.c, p.trim.state, p.trim.controls, kBladeControls, exact, model) == Status::ok, "A, B");
  const int n = model.states;
  const int inputs = n + model.controls;
  require(inputs == kInputs, "the number of states has changed");
  out.rows = n;
  double input[kInputs];
  for (int j = 0; j < inputs; ++j) {
    input[j] = j < n ? model.x[j] : model.u[j - n];
    out.scale[j] = j < n ? state_scale<double>(model.state[j]) : control_scale<double>(model.control[j - n]);
  }
  if (relative == 0) {
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < inputs; ++j) out.entry[i][j] = j < n ? model.a(i, j) : model.b(i, j - n);
    return;
  }
  // NumDiff steps by cbrt(eps) times the scale it is given.
  double scale[kInputs];
  const double own_step = std::cbrt(std::numeric_limits<double>::epsilon());
  for (int j = 0; j < inputs; ++j) scale[j] = out.scale[j] * relative / own_step;
  static NumDiff::Workspace<double, kModelDirections, kInputs, kMaxLinearStates> work;
  static ModelWorkspace<double> model_work;
  double rates[kMaxLinearStates];
  const auto f = [&](const auto& x, auto&& output) {
    model_work.state = p.trim.state;
    model_work.controls = p.trim.controls;
    const ModelPlaces<double> at(model_work);
    for (int j = 0; j < inputs; ++j) x.put(j, j < n ? *at.x[model.state[j]] : *at.u[model.control[j - n]]);
    model_rates(p.c, 0.0, model_work);
    double flat[state_count];
    flatten(model_work.rates, flat);
    for (int i = 0; i < n; ++i) output(i, flat[model.state[i]]);
  };
  NumDiff::jacobian(f, {inputs, n, input, scale, rates}, work,
                    [&out](int i, int j, int, const double* slope) { out.entry[i][j] = *slope; });
}

struct Error {
  double worst;    // of all entries
  double typical;  // root mean square
};

// Entries times the scale of their input, against the largest of their row.
Error compare(const Jacobian& exact, const Jacobian& approximate) {
  Error e{0, 0};
  int count = 0;
  for (int i = 0; i < exact.rows; ++i) {
    double row = 0;
    for (int j = 0; j < kInputs; ++j) row = std::max(row, std::fabs(exact.entry[i][j] * exact.scale[j]));
    if (row == 0) continue;
    for (int j = 0; j < kInputs; ++j) {
      const double d = (approximate.entry[i][j] - exact.entry[i][j]) * exact.scale[j] / row;
      e.worst = std::max(e.worst, std::fabs(d));
      e.typical += d * d;
      ++count;
    }
  }
  e.typical = std::sqrt(e.typical / count);
  return e;
}

}  // namespace

int main(int argc, char** argv) {
  require(argc == 2, "usage: bench_step_size DIRECTORY");
  introduce("Step size: error of central differences in A and B, over the largest entry of the row");
  Results results(argv[1]);
  std::vector<FlightPoint> points;
  for (const auto& at : kPoints) {
    const Configuration<double> c = configuration(at.mast_deg);
    points.push_back({c, at.speed_mps, trimmed(c, at.speed_mps)});
  }
  static Jacobian exact, approximate;
  std::ostringstream csv;
  csv << "relative_step,mast_deg,speed_mps,error_worst,error_rms\n";
  const double own_step = std::cbrt(std::numeric_limits<double>::epsilon());
  double best = 1, best_step = 0, at_own_step = 0, at_own_step_typical = 0;
  std::vector<double> steps = {own_step};
  for (int k = kSmallest; k <= kLargest; ++k)
    steps.push_back(std::pow(10.0, static_cast<double>(k) / kStepsPerDecade));
  std::sort(steps.begin(), steps.end());
  for (double relative : steps) {
    double worst = 0;
    double typical = 0;
    for (const FlightPoint& p : points) {
      jacobian(p, 0, exact);
      jacobian(p, relative, approximate);
      const Error e = compare(exact, approximate);
      csv << number(relative) << ',' << number(p.c.setup.mast_deg) << ',' << number(p.speed_mps) << ','
          << number(e.worst) << ',' << number(e.typical) << '\n';
      worst = std::max(worst, e.worst);
      typical = std::max(typical, e.typical);
    }
    if (worst < best) {
      best = worst;
      best_step = relative;
    }
    if (relative == own_step) {
      at_own_step = worst;
      at_own_step_typical = typical;
    }
  }
  results.write("step_size.csv", csv.str());
  std::printf(
      "  central differences agree with exact derivatives to %.1e at best (relative step %.1e) and to %.1e "
      "with\n"
      "  the step of the numerical build, cbrt(eps) = %.1e\n",
      best, best_step, at_own_step, own_step);
  results.add("nd_best_error", best, "-");
  results.add("nd_best_step", best_step, "-");
  results.add("nd_error", at_own_step, "-");
  results.add("nd_error_rms", at_own_step_typical, "-");
  results.save();
}

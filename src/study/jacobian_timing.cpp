// Cost of exact derivatives: one Jacobian over one evaluation of the model, against central differences.

#include <algorithm>
#include <cmath>
#include <ctime>
#include <memory>
#include <vector>

#include "study/linear_models.hpp"
#include "study/paper_timing.hpp"
#include "study/sections.hpp"
#include "study/step_error.hpp"
#include "study/wording.hpp"

namespace tiltrotor::study {

namespace {

constexpr int kRepeats = 31;  // the median of as many is shown

struct Case {
  const char* mode;
  double mast_deg, speed_mps;
};
constexpr Case kCases[] = {
    {"helicopter mode", 0, 30}, {"conversion mode", 60, 65}, {"airplane mode", 90, 100}};

struct Times {
  double plain, automatic, numerical,
      difference;  // s; largest entry-wise difference of both A, over its row's largest
};

// Time of the processor, not of the wall: other programs do not count.
double now() { return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC); }

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double largest_difference(const Linear& exact, const Linear& approximate) {
  double worst = 0;
  for (int i = 0; i < exact.states; ++i) {
    double size = 0;
    double difference = 0;
    for (int j = 0; j < exact.states; ++j) {
      size = std::max(size, std::fabs(exact.a(i, j)));
      difference = std::max(difference, std::fabs(exact.a(i, j) - approximate.a(i, j)));
    }
    if (size > 0) worst = std::max(worst, difference / size);
  }
  return worst;
}

// The three kinds take turns, so that whatever else the machine does meets all of them.
Times measure(const Case& which) {
  const Configured c = configured(which.mast_deg);
  const Trimmed trim = trimmed_persistently(c, which.speed_mps);
  const auto exact_work = std::make_unique<LinearizationWorkspace<double, AutoDiff>>();
  const auto numerical_work = std::make_unique<LinearizationWorkspace<double, NumDiff>>();
  const auto exact = std::make_unique<Linear>();
  const auto numerical = std::make_unique<Linear>();
  State<double> rates{};
  std::vector<double> times[3];
  constexpr int evaluations = 10;  // one is too short for the clock
  constexpr int exact_passes = 4;
  volatile double kept = 0;  // results are used
  for (int k = 0; k < kRepeats; ++k) {
    const double start = now();
    for (int i = 0; i < evaluations; ++i) {
      State<double> x = trim.state;
      x.velocity.x += 1e-3 * i;
      derivative(c, x, trim.controls, rates);
      kept = kept + rates.velocity.x;
    }
    const double after_plain = now();
    for (int i = 0; i < exact_passes; ++i) {
      (void)linearize(c, trim.state, trim.controls, kInceptors, *exact_work, *exact);
    }
    const double after_exact = now();
    (void)linearize(c, trim.state, trim.controls, kInceptors, *numerical_work, *numerical);
    const double after_numerical = now();
    times[0].push_back((after_plain - start) / evaluations);
    times[1].push_back((after_exact - after_plain) / exact_passes);
    times[2].push_back(after_numerical - after_exact);
  }
  return {median(times[0]), median(times[1]), median(times[2]), largest_difference(*exact, *numerical)};
}

}  // namespace

Section jacobian_timing() {
  Section section{"timing", "Cost of exact derivatives", "", {}, {}, {}};
  section.reading =
      "All 23 x 27 entries of A and B by one pass on numbers that carry 32 partials, over the time of one "
      "plain evaluation; "
      "processor time, medians of 31, the kinds taking turns. Ratios travel between machines, seconds do "
      "not.";
  Table table({"mode", "mast_deg", "speed_mps", "evaluation_us", "automatic_us", "numerical_us",
               "automatic_ratio", "numerical_ratio", "largest_difference"});
  table.comment("largest_difference: of A by the two ways, over the largest entry of its row.");
  double least = 1e9;
  double most = 0;
  double gain = 1e9;
  double difference = 0;
  constexpr double micro = 1e6;
  for (const Case& which : kCases) {
    const Times t = measure(which);
    table.add({std::string(which.mode), which.mast_deg, which.speed_mps, micro * t.plain, micro * t.automatic,
               micro * t.numerical, t.automatic / t.plain, t.numerical / t.plain, t.difference});
    least = std::min(least, t.automatic / t.plain);
    most = std::max(most, t.automatic / t.plain);
    gain = std::min(gain, t.numerical / t.automatic);
    difference = std::max(difference, t.difference);
  }
  section.findings.push_back(
      {Finding::remark,
       "Exact A and B cost " + fixed(least, 1) + " to " + fixed(most, 1) + " evaluations of the model.",
       "Central differences, as well written, cost at least " + fixed(gain, 1) +
           " times as much and differ by up to " + fixed(1e9 * difference, 1) +
           " billionths of a row's largest entry."});
  section.tables.push_back({"jacobian_timing", "times and ratios", table});
  add_paper_timing(section);
  add_step_error(section);
  return section;
}

}  // namespace tiltrotor::study

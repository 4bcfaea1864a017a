// Table 1 of the reference paper: trim, and the stability and control derivatives on top of it, by automatic
// and by numerical differentiation. The same Newton, the same tolerance, the same sources; only the policy
// differs.
#include <memory>

#include "flights.hpp"
#include "machine.hpp"
#include "results.hpp"

using namespace bench;

namespace {

template <class Policy>
struct Work {
  TrimWorkspace<double, Policy> trim;
  LinearizationWorkspace<double, Policy> linearization;
  TrimResult<double> result;
  LinearModel<double> model;
};

struct PointTimes {
  double trim_ad, trim_nd, derivatives_ad, derivatives_nd;  // s
  double trim_ratio, derivatives_ratio;
};

template <class Policy>
void trim_once(const FlightPoint& p, Work<Policy>& work) {
  require(is_trimmed(trim(p.c, level(p.speed_mps), work.trim, work.result)), "no trim");
}

template <class Policy>
void linearize_once(const FlightPoint& p, Work<Policy>& work) {
  require(linearize(p.c, p.trim.state, p.trim.controls, kBladeControls, work.linearization, work.model) ==
              Status::ok,
          "no linear model");
}

PointTimes measure(const FlightPoint& p, Work<AutoDiff>& ad, Work<NumDiff>& nd) {
  Contest contest;
  const int trim_ad = contest.enter("trim AD", [&] { trim_once(p, ad); });
  const int trim_nd = contest.enter("trim ND", [&] { trim_once(p, nd); });
  const int derivatives_ad = contest.enter("derivatives AD", [&] { linearize_once(p, ad); });
  const int derivatives_nd = contest.enter("derivatives ND", [&] { linearize_once(p, nd); });
  contest.run(7, 5e-4);
  return {contest.time(trim_ad).median,           contest.time(trim_nd).median,
          contest.time(derivatives_ad).median,    contest.time(derivatives_nd).median,
          contest.ratio(trim_nd, trim_ad).median, contest.ratio(derivatives_nd, derivatives_ad).median};
}

struct Range {
  double least, most, mean;
};

Range range(const std::vector<PointTimes>& times, double PointTimes::*what) {
  Range r{times[0].*what, times[0].*what, 0};
  for (const PointTimes& t : times) {
    r.least = std::min(r.least, t.*what);
    r.most = std::max(r.most, t.*what);
    r.mean += t.*what / static_cast<double>(times.size());
  }
  return r;
}

void add_row(Results& results, const std::string& name, const Range& r, const std::string& suffix) {
  results.add(name + "_min_ms" + suffix, 1e3 * r.least, "ms");
  results.add(name + "_max_ms" + suffix, 1e3 * r.most, "ms");
  results.add(name + "_mean_ms" + suffix, 1e3 * r.mean, "ms");
}

// Ratio of the means, as the paper's table gives it, and the range of the ratios of single points on paper.
void add_ratio(Results& results, const std::string& name, const Range& above, const Range& below,
               const Range& single) {
  results.add(name, Spread{above.mean / below.mean, single.least, single.most}, "-");
}

void measure(const Grid& grid, Results& results) {
  static Work<AutoDiff> ad;
  static Work<NumDiff> nd;
  const std::vector<FlightPoint> points = paper_set(with_grid(grid.grid));
  std::vector<PointTimes> times;
  int most_iterations = 0;
  for (const FlightPoint& p : points) {
    times.push_back(measure(p, ad, nd));
    most_iterations = std::max(most_iterations, p.trim.iterations);
  }
  const Range trim_ad = range(times, &PointTimes::trim_ad);
  const Range trim_nd = range(times, &PointTimes::trim_nd);
  const Range derivatives_ad = range(times, &PointTimes::derivatives_ad);
  const Range derivatives_nd = range(times, &PointTimes::derivatives_nd);

  std::printf("\n %s grid: %d elements, %d trim points\n", grid.name, elements(points[0].c),
              static_cast<int>(points.size()));
  const std::string s = grid.suffix;
  add_row(results, "trim_ad", trim_ad, s);
  add_row(results, "trim_nd", trim_nd, s);
  add_row(results, "derivatives_ad", derivatives_ad, s);
  add_row(results, "derivatives_nd", derivatives_nd, s);
  add_ratio(results, "trim_nd_over_ad" + s, trim_nd, trim_ad, range(times, &PointTimes::trim_ratio));
  add_ratio(results, "derivatives_nd_over_ad" + s, derivatives_nd, derivatives_ad,
            range(times, &PointTimes::derivatives_ratio));
  results.add("trim_iterations_max" + s, most_iterations, "-");
}

}  // namespace

int main(int argc, char** argv) {
  require(argc == 2, "usage: bench_trim_and_derivatives DIRECTORY");
  introduce("Table 1: trim from a cold start, and A (23 x 23) with B (23 x 7) at the trim point");
  std::printf("  the paper (i7-8700K), mean: trim 270 ms AD, 7140 ms ND; derivatives 10 ms AD, 6010 ms ND\n");
  Results results(argv[1]);
  for (const Grid& grid : kGrids) measure(grid, results);
  results.save();
}

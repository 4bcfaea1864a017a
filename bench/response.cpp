// Table 2 of the reference paper: computing time of a response, with and without A, B and the eigenvalues at
// every step.
#include <memory>

#include "frame.hpp"
#include "machine.hpp"
#include "results.hpp"

using namespace bench;

namespace {

constexpr int kLongest = 3;  // s
constexpr double kDegreeOfCollective = kRadPerDeg<double>;

int frames(int seconds) { return static_cast<int>(seconds / kFrameTime + 0.5); }

void measure(const Grid& grid, Results& results) {
  const Configuration<double> c = configuration(0, with_grid(grid.grid));
  const Simulation<double> begin =
      flight_with_input(c, trimmed(c, 40), InputShape::step, kDegreeOfCollective);
  const auto ad = std::make_unique<FrameWork<AutoDiff>>();
  const auto nd = std::make_unique<FrameWork<NumDiff>>();

  Contest contest;
  int plain[kLongest + 1];
  int with_modes[kLongest + 1];
  for (int s = 1; s <= kLongest; ++s) {
    plain[s] = contest.enter("response", [&, s] {
      Simulation<double> flight = begin;
      for (int k = 0; k < frames(s); ++k) step(c, *ad, flight);
    });
    with_modes[s] = contest.enter("with modes", [&, s] {
      Simulation<double> flight = begin;
      for (int k = 0; k < frames(s); ++k) frame(c, *ad, flight);
    });
  }
  const int numerical = contest.enter("with modes by differences", [&] {
    Simulation<double> flight = begin;
    for (int k = 0; k < frames(1); ++k) frame(c, *nd, flight);
  });
  contest.run(5);

  std::printf("\n %s grid: %d elements\n", grid.name, elements(c));
  const std::string suffix = grid.suffix;
  for (int s = 1; s <= kLongest; ++s)
    results.add("response_" + std::to_string(s) + "s_ms" + suffix, contest.time(plain[s]), "ms", 1e3);
  for (int s = 1; s <= kLongest; ++s)
    results.add("response_" + std::to_string(s) + "s_with_modes_ms" + suffix, contest.time(with_modes[s]),
                "ms", 1e3);
  results.add("realtime_factor" + suffix, kLongest / contest.time(plain[kLongest]).median, "-");
  results.add("realtime_factor_with_modes" + suffix, kLongest / contest.time(with_modes[kLongest]).median,
              "-");
  results.add("realtime_factor_with_modes_nd" + suffix, 1 / contest.time(numerical).median, "-");
}

}  // namespace

int main(int argc, char** argv) {
  require(argc == 2, "usage: bench_response DIRECTORY");
  introduce(
      "Table 2: response to 1 deg of collective at 40 m/s, steps of 5 ms; with A, B and the eigenvalues at "
      "each");
  std::printf("  the paper (i7-8700K), mean: 1 s of flight with derivatives at every step in 0.66 s\n");
  Results results(argv[1]);
  for (const Grid& grid : kGrids) measure(grid, results);
  results.save();
}

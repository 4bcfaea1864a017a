// How long one real-time frame can take: 100,000 frames of a 5 ms step, A, B and the eigenvalues of A, each
// timed, then flown again from the same state.
#include <memory>

#include "frame.hpp"
#include "machine.hpp"
#include "results.hpp"

using namespace bench;

namespace {

constexpr int kFrames = 100000;
constexpr int kFramesOfFlight =
    400;  // 2 s, then again from the next trim point: nothing stabilises the aircraft
constexpr double kInput = 0.5 * kRadPerDeg<double>;

}  // namespace

int main(int argc, char** argv) {
  require(argc == 2, "usage: bench_frame DIRECTORY");
  introduce(
      "Real-time frame: a 5 ms step, A, B and the eigenvalues of A; real-time grid, the paper's trim set");
  Results results(argv[1]);
  const std::vector<FlightPoint> points = paper_set(with_grid(BladeGrid::realtime));
  const auto work = std::make_unique<FrameWork<AutoDiff>>();
  std::vector<double> processor;
  std::vector<double> replayed;
  std::vector<double> wall;
  processor.reserve(kFrames);
  wall.reserve(kFrames);
  replayed.reserve(kFrames);

  Simulation<double> flight;
  for (int k = -kFramesOfFlight; k < kFrames; ++k) {  // the first flight is the warm-up
    const FlightPoint& p =
        points[static_cast<std::size_t>((k + kFramesOfFlight) / kFramesOfFlight) % points.size()];
    if (k % kFramesOfFlight == 0) flight = flight_with_input(p.c, p.trim, InputShape::doublet, kInput);
    const Simulation<double> before = flight;
    const double wall_begin = wall_seconds();
    const double begin = processor_seconds();
    frame(p.c, *work, flight);
    const double end = processor_seconds();
    const double wall_end = wall_seconds();
    flight = before;
    const double again = processor_seconds();
    frame(p.c, *work, flight);
    const double again_end = processor_seconds();
    if (k < 0) continue;
    processor.push_back(end - begin);
    replayed.push_back(std::min(end - begin, again_end - again));
    wall.push_back(wall_end - wall_begin);
  }

  const double median = quantile(processor, 0.5);
  results.add("frame_elements", elements(points[0].c), "-");
  results.add("frame_median_us", 1e6 * median, "us");
  results.add("frame_p999_us", 1e6 * quantile(processor, 0.999), "us");
  results.add("frame_max_us", 1e6 * quantile(processor, 1), "us");
  results.add("frame_p999_over_median", quantile(processor, 0.999) / median, "-");
  results.add("frame_max_over_median", quantile(processor, 1) / median, "-");
  // Every frame flown twice, bit for bit the same: what interrupts only one of the two is not the program's.
  results.add("frame_replayed_max_over_median", quantile(replayed, 1) / quantile(replayed, 0.5), "-");
  std::printf(
      "  by the wall clock, whatever else runs on the core: median %.0f us, 99.9 %% %.0f us, worst %.0f us\n",
      1e6 * quantile(wall, 0.5), 1e6 * quantile(wall, 0.999), 1e6 * quantile(wall, 1));
  results.save();
}

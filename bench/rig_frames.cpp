// Frames of a rig through the C interface, in a turn with sideslip, where no half of the aircraft is the other's mirror:
// A, B, eigenvalues and a step, by the method of order 3 and by the exponential, with all roots and with those of the
// rigid body; and the same with every system on.
#include "harness.hpp"
#include "machine.hpp"
#include "results.hpp"
#include "rig.hpp"

using namespace bench;

namespace {

// Median over flights of a second each: nothing stabilises the aircraft, so it begins again.
template <class Frame>
double frame_seconds(Rig& rig, double dt, Frame&& frame) {
  const tr_sim begun = rig.sim;
  std::vector<double> seconds;
  for (int flight = 0; flight < 12; ++flight) {
    rig.sim = begun;
    for (double time = 0; time < 1; time += dt) {
      const double begin = processor_seconds();
      require(frame(), "a frame failed");
      if (flight > 0) seconds.push_back(processor_seconds() - begin);
    }
  }
  rig.sim = begun;
  return quantile(seconds, 0.5);
}

}  // namespace

int main(int argc, char** argv) {
  require(argc == 2, "usage: bench_rig_frames DIRECTORY");
  introduce("Frames of a rig in asymmetric flight, C interface, real-time grid");
  Results results(argv[1]);
  Rig rig(kMiddleMast, kMiddleSpeed);
  const auto add = [&](const char* name, double dt, double seconds) {
    results.add(std::string("rig_") + name + "_us", 1e6 * seconds, "us");
    results.add(std::string("rig_") + name + "_times_real_time", dt / seconds, "-");
  };
  add("frame_5_ms", 0.005, frame_seconds(rig, 0.005, [&] { return rig.frame(0.005); }));
  add("exponential_5_ms", 0.005, frame_seconds(rig, 0.005, [&] { return rig.exponential_frame(0.005); }));
  add("exponential_20_ms", 0.02, frame_seconds(rig, 0.02, [&] { return rig.exponential_frame(0.02); }));
  add("slow_roots_5_ms", 0.005, frame_seconds(rig, 0.005, [&] { return rig.slow_frame(0.005); }));
  add("slow_roots_20_ms", 0.02, frame_seconds(rig, 0.02, [&] { return rig.slow_frame(0.02); }));
  rig.switch_on();
  add("systems_5_ms", 0.005, frame_seconds(rig, 0.005, [&] { return rig.frame(0.005); }));
  results.save();
}

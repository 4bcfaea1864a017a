// One derivative, one configuration remade, one Jacobian, one trim, one frame, one frame of a rig by the exponential with the
// roots of the rigid body, one linear model with every system on, its outputs: what `make bench-instructions` counts, each in a
// function of its own that callgrind can find. Instructions do not depend on the machine's load or clock.
#include <cstring>
#include <memory>

#include "frame.hpp"
#include "rig.hpp"

using namespace bench;

namespace {

struct Workspaces {
  Configuration<double> c;
  ConfigurationSetting<double> setting;
  TrimResult<double> flight, again;
  State<double> rates;
  LinearModel<double> model;
  TrimWorkspace<double, AutoDiff> trim;
  FrameWork<AutoDiff> work;
  Simulation<double> simulation;
};

}  // namespace

// The real-time grid, unless the name says otherwise.
extern "C" {
__attribute__((noinline)) void counted_derivative(Workspaces& r) {
  derivative(r.c, r.flight.state, r.flight.controls, r.rates);
}
__attribute__((noinline)) void counted_configuration(Workspaces& r) {
  require(reconfigure(r.setting, r.c) == Status::ok, "setting out of range");
}
__attribute__((noinline)) void counted_jacobian(Workspaces& r) {
  require(linearize(r.c, r.flight.state, r.flight.controls, kBladeControls, r.work.linearization, r.model) ==
              Status::ok,
          "A, B");
}
__attribute__((noinline)) void counted_trim(Workspaces& r) {
  require(is_trimmed(trim(r.c, level(kMiddleSpeed), r.trim, r.again)), "no trim");
}
__attribute__((noinline)) void counted_frame(Workspaces& r) { frame(r.c, r.work, r.simulation); }
// Through the C interface.
__attribute__((noinline)) void counted_slow_frame(Rig& rig) { require(rig.slow_frame(0.02), "no frame"); }
__attribute__((noinline)) void counted_systems(Rig& rig) { require(rig.linearize() == TR_OK, "A, B"); }
__attribute__((noinline)) void counted_outputs(Rig& rig) {
  require(rig.linearize_outputs() == TR_OK, "C, D");
}
}

// Argument: the name of the function to call, without counted_; a second argument chooses the specification
// grid.
int main(int argc, char** argv) {
  require(argc == 2 || argc == 3,
          "usage: bench_instructions derivative|configuration|jacobian|trim|frame [specification]\n"
          "       bench_instructions slow_frame|systems|outputs");
  const auto asked = [argv](const char* name) { return std::strcmp(argv[1], name) == 0; };
  if (asked("slow_frame") || asked("systems") || asked("outputs")) {
    Rig rig(kMiddleMast, kMiddleSpeed);
    if (!asked("slow_frame")) rig.switch_on();
    if (asked("slow_frame")) counted_slow_frame(rig);
    if (asked("systems")) counted_systems(rig);
    if (asked("outputs")) counted_outputs(rig);
    return 0;
  }
  const auto workspaces = std::make_unique<Workspaces>();
  Workspaces& r = *workspaces;
  r.c = configuration(kMiddleMast, with_grid(argc == 3 ? BladeGrid::specification : BladeGrid::realtime));
  // Mast and flap between knots, where a place on a table costs most.
  r.setting = r.c.setup;
  r.setting.mast_deg += 5;
  r.setting.flap_deg += 5;
  r.flight = trimmed(r.c, kMiddleSpeed);
  r.flight.state.velocity.y +=
      0.1;  // in symmetric flight one rotor answers for both: only the trim is counted there
  r.simulation = flight_with_input(r.c, r.flight, InputShape::step, kRadPerDeg<double>);
  if (asked("derivative")) counted_derivative(r);
  if (asked("configuration")) counted_configuration(r);
  if (asked("jacobian")) counted_jacobian(r);
  if (asked("trim")) counted_trim(r);
  if (asked("frame")) counted_frame(r);
  return 0;
}

// The law itself: its gains between blocks, and its linear model away from where it counts from. Expected: weights by hand,
// and differences of the controls that a flight takes.
#include <cmath>
#include <memory>

#include "check.hpp"
#include "cli/analyses_workspace.hpp"
#include "library/closed_loop_flight.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

using namespace tiltrotor;

namespace {

struct Scheduled {
  std::unique_ptr<GainBlock<double>[]> block;
  FeedbackLaw<double> law{};

  explicit Scheduled(std::initializer_list<std::pair<double, double>> places)
      : block(new GainBlock<double>[places.size()]) {
    for (const auto& [mast_deg, speed] : places) {
      GainBlock<double>& b = block[static_cast<std::size_t>(law.blocks++)];
      b.mast_deg = mast_deg;
      b.speed = speed;
      set_zero(b.gain);
    }
    law.block = block.get();
  }
  double at(double mast_deg, double speed) const { return gain_shares(law, mast_deg, speed).gain(law, 0, 0); }
  double slope(double mast_deg, double speed) const {
    return gain_shares(law, mast_deg, speed).gain_by_speed(law, 0, 0);
  }
};

}  // namespace

TEST(feedback_gains_are_linear_between_blocks_and_held_outside) {
  // Mast angles need not have the same speeds.
  Scheduled s({{0, 0}, {0, 40}, {60, 50}, {90, 60}, {90, 100}, {90, 110}});
  const double gain[] = {1, 5, 2, 10, 30, 0};
  for (int k = 0; k < 6; ++k) s.block[static_cast<std::size_t>(k)].gain(0, 0) = gain[k];
  struct At {
    double mast_deg, speed, gain, slope;
  };
  constexpr At places[] = {{0, 0, 1, 0.1},     {0, 10, 2, 0.1},     {0, 40, 5, 0},   {0, 70, 5, 0},
                           {-5, 10, 2, 0.1},   {30, 20, 2.5, 0.05}, {60, 0, 2, 0},   {60, 80, 2, 0},
                           {75, 80, 11, 0.25}, {90, 80, 20, 0.5},   {90, 50, 10, 0}, {90, 105, 15, -3},
                           {90, 120, 0, 0},    {95, 80, 20, 0.5}};
  for (const At& at : places) {
    const double found = s.at(at.mast_deg, at.speed), slope = s.slope(at.mast_deg, at.speed);
    const double turn = gain_shares(s.law, at.mast_deg, at.speed).gain_by_mast(s.law, 0, 0), h = 1e-3;
    const bool at_block = std::fmod(at.mast_deg, 30) == 0 && at.mast_deg != 30;
    if (!at_block)
      CHECK_NEAR(turn, (s.at(at.mast_deg + h, at.speed) - s.at(at.mast_deg - h, at.speed)) / (2 * h), 1e-9);
    if (!CHECK(std::fabs(found - at.gain) < 1e-12 && std::fabs(slope - at.slope) < 1e-12))
      NOTE("mast " << at.mast_deg << " deg, " << at.speed << " m/s: " << found << " " << slope);
  }
  Scheduled alone({{30, 20}});
  alone.block[0].gain(0, 0) = 7;
  CHECK_EQ(alone.at(90, 100), 7);
}

TEST_OF_XV15(feedback_away_from_its_reference_has_the_slopes_of_its_controls) {
  const cli::AnalysesWorkspace work;
  Configuration<double> c;
  CHECK(prepare(aircraft_data<double>(), flight_setup(aircraft_data<double>(), 60.0), c) == Status::ok);
  TrimResult<double> trimmed;
  CHECK(is_trimmed(trim(c, SteadyFlight<double>{60, 0, 0, 0}, *work, trimmed)));
  // Two inputs that read two instruments which hang on both, and two states; gains change by half over 20 m/s.
  Scheduled s({{60, 50}, {60, 70}});
  FeedbackLaw<double>& law = s.law;
  law.inputs = 2;
  law.input[0] = kControlIndex.long_stick;
  law.input[1] = kControlIndex.collective;
  law.readings = 4;
  const int reading[] = {kStateIndex.pitch, kStateIndex.rates.y, vehicle_state_count + 6 /* load factor */,
                         vehicle_state_count + 12 /* power of the right rotor */};
  const double gain[2][4] = {{-8, -6, 1, 0}, {0.1, 0, 0.05, 1e-7}};
  for (int k = 0; k < 4; ++k) {
    law.reading[k] = reading[k];
    for (int i = 0; i < 2; ++i) {
      s.block[0].gain(i, k) = gain[i][k];
      s.block[1].gain(i, k) = 1.5 * gain[i][k];
    }
  }
  const auto outputs = std::make_unique<OutputMatrices>();
  const auto reference = std::make_unique<FeedbackReference<double>>();
  CHECK(linearize_outputs(c, trimmed.state, trimmed.controls, kAllControls, *work, *outputs) == Status::ok);
  set_zero(reference->d);
  for (int i = 0; i < OutputMatrices::outputs; ++i)
    for (int j = 0; j < control_count; ++j) reference->d(i, j) = outputs->d(i, j);
  for (int k = 0; k < 4; ++k)
    reference->reading[k] = k == 0   ? trimmed.state.pitch
                            : k == 1 ? trimmed.state.rates.y
                                     : outputs->y[reading[k] - vehicle_state_count];

  const auto search = std::make_unique<FeedbackSearch<double>>();
  const auto acting = [&](const double* x, const double* u, double* found) {
    State<double> state;
    Controls<double> hands, out;
    unflatten(x, state);
    unflatten(u, hands);
    CHECK(feed_back<double>(law, *reference, c, state, nullptr, hands, 0.0, *search, out) == Status::ok);
    flatten(out, found);
  };
  double x[state_count], u[control_count], there[control_count];
  flatten(trimmed.state, x);
  flatten(trimmed.controls, u);
  acting(x, u, there);
  for (int j = 0; j < control_count; ++j) CHECK_NEAR(there[j], u[j], 1e-10);
  x[kStateIndex.velocity.z] += 1.5;
  x[kStateIndex.pitch] += 0.03;
  u[kControlIndex.gust.x] = 0.7;
  acting(x, u, there);
  CHECK_LT(0.02, std::fabs(there[kControlIndex.long_stick] - u[kControlIndex.long_stick]));

  State<double> state;
  Controls<double> at;
  unflatten(x, state);
  unflatten(there, at);
  CHECK(linearize_outputs(c, state, at, kAllControls, *work, *outputs) == Status::ok);
  VehicleShape shape{};
  shape.states = outputs->point.states;
  for (int i = 0; i < shape.states; ++i) shape.state[i] = outputs->point.state[i];
  const auto solve = std::make_unique<ClosedControlsWorkspace<double>>();
  const auto closed = std::make_unique<ClosedControls<double>>();
  CHECK(close_controls(
            law, search->at, shape, [&](int i, int j) { return outputs->c(i, j); },
            [&](int i, int j) { return outputs->d(i, j); }, *solve, *closed) == Status::ok);
  const auto compare = [&](double& moved, double bend, const auto& slope, const char* name) {
    const double before = moved, h = 1e-4 * bend;
    double above[control_count], below[control_count];
    moved = before + h;
    acting(x, u, above);
    moved = before - h;
    acting(x, u, below);
    moved = before;
    for (const int j : {law.input[0], law.input[1]}) {
      const double found = slope(j), expected = (above[j] - below[j]) / (2 * h);
      const double size = kControlVariables[j].facts().bend / bend;
      if (!CHECK_NEAR(found, expected, 1e-5 * (size + std::fabs(expected))))
        NOTE(name << " to " << kControlVariables[j].name);
    }
  };
  for (int i = 0; i < shape.states; ++i)
    compare(
        x[shape.state[i]], state_scale<double>(shape.state[i]), [&](int j) { return -closed->gain(j, i); },
        kStateVariables[shape.state[i]].name);
  for (int v = 0; v < control_count; ++v)
    compare(
        u[v], control_scale<double>(v), [&](int j) { return closed->pilot(j, v); },
        kControlVariables[v].name);
}

// Models on numbers that carry a slope. Expected: nested dual numbers along state and controls.
#include "cli/model_slope.hpp"

#include "check.hpp"
#include "cli/analyses_workspace.hpp"
#include "library/analyses.hpp"
#include "tiltrotor/analysis/linear/model_motion.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/model/preparation.hpp"

using namespace tiltrotor;

// Symmetric flight, in which the left rotor may stand for the right one's mirror: not where it moves.
TEST(cli_sensitivity_slopes_equal_nested_duals) {
  for (const double mast : {0.0, 30.0, 90.0}) {
    Configuration<double> c;
    CHECK(prepare(aircraft_data<double>(), flight_setup(aircraft_data<double>(), mast), c) == Status::ok);
    const cli::AnalysesWorkspace work;
    SteadyFlight<double> flight{};
    flight.speed = 30 + mast;
    TrimResult<double> r;
    CHECK(is_trimmed(trim(c, flight, *work, r)));
    LinearModel<double> model;
    CHECK(linearize(c, r.state, r.controls, ControlSet{}, *work, model) == Status::ok);
    cli::ModelSlope slope;
    CHECK(slope.begin(c, [](cli::Moved) {}) == Status::ok);
    const auto workspace = std::make_unique<ModelMotionWorkspace<double>>();
    const auto nested = std::make_unique<ModelMotion<double>>();
    const auto found = std::make_unique<cli::ModelSlope::Airframe>();
    for (int i = 0; i < kStateIndex.position.x; ++i) {
      TrimMotion<double> motion{};
      double x[state_count] = {};
      x[i] = 1;
      unflatten(x, motion.x);
      motion.u.collective = 0.01;
      CHECK(model_motion(c, r.state, r.controls, model, ConfigurationParameter::count, motion, *workspace,
                         *nested) == Status::ok);
      CHECK(slope.airframe(r.state, r.controls, motion, *found) == Status::ok);
      for (int row = 0; row < model.states; ++row) {
        double largest = 1;
        for (int j = 0; j < model.states; ++j) largest = std::max(largest, std::fabs(nested->a(row, j)));
        for (int j = 0; j < model.states; ++j)
          if (!CHECK_NEAR(found->a[model.state[row]][model.state[j]], nested->a(row, j), 1e-12 * largest))
            NOTE("mast " << mast << " along " << kStateVariables[i].name << ": " << row << ", " << j);
      }
      const double power = nested->power[right] + nested->power[left];
      CHECK_NEAR(found->power, power, 1e-12 * (1e6 + std::fabs(power)));
    }
  }
}

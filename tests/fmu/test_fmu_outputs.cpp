// Outputs of the FMU beside those of tr_outputs, and the names of all. Expected: names of the command line; laws of mechanics; the
// configuration that was asked for; differences.
#include "tiltrotor/tiltrotor.h"

#ifndef TR_SINGLE_PRECISION
#include <cmath>

#include "cli/output_names.hpp"
#include "fmu/master.hpp"

using namespace fmu;
using namespace tiltrotor_fmu;

namespace {

constexpr double kStandardGravity = 9.80665;  // m/s^2

double slope_of(const Master& m, Reference unknown, Reference known) {
  const double one = 1;
  double found = 0;
  CHECK_EQ(FMI(fmi3GetDirectionalDerivative)(m.instance, &unknown, 1, &known, 1, &one, 1, &found, 1), fmi3OK);
  return found;
}

// In a climbing turn with sideslip and a gust, where nothing vanishes.
void begin_askew(Master& m) {
  CHECK_EQ(m.set(setting(kTrimClimb), 0.15), fmi3OK);
  CHECK_EQ(m.set(setting(kTrimTurnRate), 0.1), fmi3OK);
  CHECK_EQ(m.set(setting(kTrimSideslip), 0.05), fmi3OK);
  CHECK_EQ(m.set(input(TR_GUST_W), 1), fmi3OK);
  CHECK_LE(m.start(30, 50), fmi3Warning);
}

}  // namespace

TEST(fmu_outputs_have_the_names_of_the_command_line) {
  const std::string text = description();
  for (int k = 0; k < TR_OUTPUTS; ++k) {
    const std::size_t at = text.find("valueReference=\"" + std::to_string(output(k)) + "\"");
    const std::size_t line = text.rfind('<', at);
    CHECK_EQ(attribute(text, "name", line), std::string("output.") + tiltrotor::cli::kOutputNames[k].name);
  }
}

// Load factors from the specific force, nz against body z; the path from climb rate and speed through the undisturbed air.
TEST(fmu_load_factors_and_flight_path_are_those_of_mechanics) {
  Master m(Master::model_exchange);
  begin_askew(m);
  for (int axis = 0; axis < 3; ++axis)
    CHECK_REL(m.get(output(kOutputNx + axis)),
              (axis == 2 ? -1 : 1) * m.get(output(3 + axis)) / kStandardGravity, 1e-14);
  const std::vector<double> x = m.states();
  const double speed = std::sqrt(x[TR_U] * x[TR_U] + x[TR_V] * x[TR_V] + x[TR_W] * x[TR_W]);
  CHECK_NEAR(m.get(output(kOutputFlightPath)), std::asin(m.get(output(7)) / speed), 1e-13);
  CHECK_LT(0.1, m.get(output(kOutputFlightPath)));
  // Straight up, straight down, at rest.
  const double paths[][2] = {{-5, 0.5}, {5, -0.5}, {0, 0}};
  for (const auto& [w, quarters] : paths) {
    std::vector<double> still = x;
    still[TR_U] = still[TR_V] = still[TR_ROLL] = still[TR_PITCH] = 0;
    still[TR_W] = w;
    CHECK_EQ(FMI(fmi3SetContinuousStates)(m.instance, still.data(), still.size()), fmi3OK);
    CHECK_NEAR(m.get(output(kOutputFlightPath)), quarters * std::acos(-1.0), 1e-15);
  }
}

// Expected: central differences, of order 2 in steps of 1e-6; where tables bend between them of order 1.
TEST(fmu_derivatives_of_further_outputs_are_exact) {
  Master m(Master::model_exchange);
  begin_askew(m);
  const std::vector<double> x = m.states();
  int moving = 0;
  for (int unknown = kOutputNx; unknown <= kOutputFlightPath; ++unknown)
    for (const int known : {int{TR_U}, int{TR_V}, int{TR_W}, int{TR_P}, int{TR_ROLL}, int{TR_PITCH},
                            int{TR_YAW}, int{TR_ROTOR_LEFT}}) {
      double found[2];
      constexpr double step = 1e-6;
      for (const int way : {0, 1}) {
        std::vector<double> y = x;
        y[static_cast<std::size_t>(known)] += way == 0 ? step : -step;
        CHECK_EQ(FMI(fmi3SetContinuousStates)(m.instance, y.data(), y.size()), fmi3OK);
        found[way] = m.get(output(unknown));
      }
      CHECK_EQ(FMI(fmi3SetContinuousStates)(m.instance, x.data(), x.size()), fmi3OK);
      const double exact = slope_of(m, output(unknown), state(known));
      if (!CHECK_NEAR(exact, (found[0] - found[1]) / (2 * step), 2e-7 * (1 + std::abs(exact))))
        NOTE(unknown << " by " << known);
      if (exact != 0) ++moving;
    }
  CHECK_LE(15, moving);
}

// With the drive off the mast stands where the parameter puts it; with it on the output is the state and goes its way.
TEST(fmu_masts_flaps_and_rotor_speed_are_told_on_and_off) {
  const int outputs[] = {kOutputMast, kOutputFlap, kOutputRotorSpeed},
            states[] = {TR_MAST, TR_FLAP, TR_ROTOR_SPEED};
  for (const bool on : {false, true}) {
    Master m(Master::model_exchange);
    CHECK_EQ(m.set_switch(kConversion, on), fmi3OK);
    const Reference governor = setting(kGovernor);
    const std::int64_t pi = on ? 2 : 0;
    CHECK_EQ(FMI(fmi3SetInt64)(m.instance, &governor, 1, &pi, 1), fmi3OK);
    CHECK_EQ(m.set(setting(kFlap), 0.5), fmi3OK);
    CHECK_EQ(m.set(setting(kRotorSpeed), 58), fmi3OK);
    CHECK_LE(m.start(30, 50), fmi3Warning);
    const double expected[] = {30 * kRadians, 0.5, 58};
    for (int k = 0; k < 3; ++k) {
      CHECK_NEAR(m.get(output(outputs[k])), expected[k], 1e-14);
      CHECK_EQ(m.get(state(states[k])), on ? m.get(output(outputs[k])) : 0.0);
      CHECK_EQ(slope_of(m, output(outputs[k]), state(states[k])), on ? 1.0 : 0.0);
      CHECK_EQ(slope_of(m, output(outputs[k]), state(TR_U)), 0.0);
    }
    if (!on) continue;
    std::vector<double> x = m.states();
    for (int k = 0; k < 3; ++k) x[static_cast<std::size_t>(states[k])] = 1.1 * expected[k];
    CHECK_EQ(FMI(fmi3SetContinuousStates)(m.instance, x.data(), x.size()), fmi3OK);
    for (int k = 0; k < 3; ++k) CHECK_EQ(m.get(output(outputs[k])), 1.1 * expected[k]);
  }
}
#endif

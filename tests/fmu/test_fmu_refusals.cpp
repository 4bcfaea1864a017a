// Whatever an importer does wrong is an error with a line in its log, and the instance flies on.
#include "tiltrotor/tiltrotor.h"

#ifndef TR_SINGLE_PRECISION
#include <cmath>
#include <limits>

#include "fmu/master.hpp"

using namespace fmu;
using namespace tiltrotor_fmu;

namespace {
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
}

TEST(fmu_calls_out_of_order_are_errors) {
  Master m(Master::model_exchange);
  std::vector<double> x(kContinuousStates);
  bool flag = false;
  double number = 0;
  CHECK_EQ(FMI(fmi3SetContinuousStates)(m.instance, x.data(), x.size()), fmi3Error);
  CHECK_EQ(FMI(fmi3GetContinuousStateDerivatives)(m.instance, x.data(), x.size()), fmi3Error);
  CHECK_EQ(FMI(fmi3ExitInitializationMode)(m.instance), fmi3Error);
  CHECK_EQ(FMI(fmi3EnterContinuousTimeMode)(m.instance), fmi3Error);
  CHECK_EQ(FMI(fmi3EnterEventMode)(m.instance), fmi3Error);
  CHECK_EQ(FMI(fmi3Terminate)(m.instance), fmi3Error);
  CHECK_EQ(FMI(fmi3SetTime)(m.instance, 1), fmi3Error);
  CHECK_EQ(m.log.size(), 7u);
  CHECK_EQ(m.start(0, 40), fmi3OK);
  CHECK_EQ(m.step(0, 0.01), fmi3Error);
  CHECK_EQ(FMI(fmi3EnterInitializationMode)(m.instance, false, 0, 0, false, 0), fmi3Error);
  CHECK_EQ(m.set(setting(kMast), 0.1), fmi3Error);
  CHECK_EQ(m.set(setting(kWindNorth), 1), fmi3Error);
  CHECK_EQ(m.set(state(TR_U), 1), fmi3Error);
  CHECK_EQ(m.set(rate(TR_U), 1), fmi3Error);
  CHECK_EQ(m.set(output(0), 1), fmi3Error);
  CHECK_EQ(FMI(fmi3EnterStepMode)(m.instance), fmi3Error);
  CHECK_EQ(FMI(fmi3EnterConfigurationMode)(m.instance), fmi3Error);
  CHECK_EQ(FMI(fmi3UpdateDiscreteStates)(m.instance, &flag, &flag, &flag, &flag, &flag, &number), fmi3Error);
  CHECK_EQ(FMI(fmi3Terminate)(m.instance), fmi3OK);
  CHECK_EQ(m.set(input(0), 0.1), fmi3Error);
  CHECK_EQ(FMI(fmi3GetContinuousStateDerivatives)(m.instance, x.data(), x.size()), fmi3OK);
  CHECK_EQ(FMI(fmi3Reset)(m.instance), fmi3OK);
  CHECK_EQ(m.start(90, 100), fmi3OK);
}

TEST(fmu_null_pointers_and_unknown_references_are_errors) {
  Master m(Master::model_exchange);
  const Reference unknown = 999, at = state(0), whole = setting(kGrid);
  double value = 0;
  std::int32_t other = 0;
  CHECK_EQ(FMI(fmi3GetFloat64)(nullptr, &at, 1, &value, 1), fmi3Error);
  CHECK_EQ(FMI(fmi3GetFloat64)(m.instance, nullptr, 1, &value, 1), fmi3Error);
  CHECK_EQ(FMI(fmi3GetFloat64)(m.instance, &at, 1, nullptr, 1), fmi3Error);
  CHECK_EQ(FMI(fmi3GetFloat64)(m.instance, &at, 1, &value, 2), fmi3Error);
  CHECK_EQ(FMI(fmi3GetFloat64)(m.instance, &unknown, 1, &value, 1), fmi3Error);
  CHECK_EQ(FMI(fmi3GetFloat64)(m.instance, &whole, 1, &value, 1), fmi3Error);
  CHECK_EQ(FMI(fmi3SetFloat64)(m.instance, &at, 1, nullptr, 1), fmi3Error);
  CHECK_EQ(FMI(fmi3GetInt32)(m.instance, &at, 1, &other, 1), fmi3Error);
  CHECK_EQ(FMI(fmi3GetFloat64)(m.instance, nullptr, 0, nullptr, 0), fmi3OK);
  CHECK_EQ(FMI(fmi3GetNumberOfContinuousStates)(m.instance, nullptr), fmi3Error);
  CHECK_EQ(m.start(0, 40), fmi3OK);
  CHECK_EQ(FMI(fmi3GetContinuousStates)(m.instance, nullptr, kContinuousStates), fmi3Error);
  CHECK_EQ(FMI(fmi3GetContinuousStates)(m.instance, &value, 1), fmi3Error);
  CHECK_EQ(FMI(fmi3CompletedIntegratorStep)(m.instance, true, nullptr, nullptr), fmi3Error);
  const Reference of_rate = rate(0), of_time = 0;
  const double one = 1;
  const auto slope = [&](const Reference* what, const Reference* by, const double* seed, double* found) {
    return FMI(fmi3GetDirectionalDerivative)(m.instance, what, 1, by, 1, seed, 1, found, 1);
  };
  CHECK_EQ(slope(&of_rate, &at, &one, &value), fmi3OK);
  CHECK_EQ(slope(nullptr, &at, &one, &value), fmi3Error);
  CHECK_EQ(slope(&of_rate, nullptr, &one, &value), fmi3Error);
  CHECK_EQ(slope(&of_rate, &at, nullptr, &value), fmi3Error);
  CHECK_EQ(slope(&of_rate, &at, &one, nullptr), fmi3Error);
  CHECK_EQ(slope(&of_rate, &at, &kNan, &value), fmi3Error);
  CHECK_EQ(slope(&of_time, &at, &one, &value), fmi3Error);
  CHECK_EQ(slope(&of_rate, &whole, &one, &value), fmi3Error);
  fmi3FMUState none = nullptr, foreign = &value;
  std::size_t size = 0;
  CHECK_EQ(FMI(fmi3GetFMUState)(m.instance, nullptr), fmi3Error);
  CHECK_EQ(FMI(fmi3GetFMUState)(m.instance, &foreign), fmi3Error);
  CHECK_EQ(FMI(fmi3SetFMUState)(m.instance, none), fmi3Error);
  CHECK_EQ(FMI(fmi3SetFMUState)(m.instance, foreign), fmi3Error);
  CHECK_EQ(FMI(fmi3SerializedFMUStateSize)(m.instance, none, &size), fmi3Error);
  CHECK_EQ(FMI(fmi3FreeFMUState)(m.instance, &none), fmi3OK);
  FMI(fmi3FreeInstance)(nullptr);
  // No more states than there is place for, and each free again.
  std::vector<fmi3FMUState> held;
  for (fmi3FMUState next = nullptr; FMI(fmi3GetFMUState)(m.instance, &next) == fmi3OK; next = nullptr)
    held.push_back(next);
  CHECK_EQ(held.size(), 16u);
  for (fmi3FMUState& each : held) CHECK_EQ(FMI(fmi3FreeFMUState)(m.instance, &each), fmi3OK);
  CHECK_EQ(FMI(fmi3GetFMUState)(m.instance, &none), fmi3OK);
}

TEST(fmu_bad_numbers_change_nothing) {
  Master m(Master::model_exchange);
  CHECK_EQ(m.set(setting(kMast), 2), fmi3Error);
  CHECK_EQ(m.set(setting(kTrimSpeed), -1), fmi3Error);
  CHECK_EQ(m.set(setting(kTrimSpeed), kNan), fmi3Error);
  CHECK_EQ(m.set(state(TR_U), HUGE_VAL), fmi3Error);
  CHECK_EQ(m.start(0, 40), fmi3OK);
  const std::vector<double> before = m.states();
  std::vector<double> x = before;
  x[TR_Q] = kNan;
  CHECK_EQ(FMI(fmi3SetContinuousStates)(m.instance, x.data(), x.size()), fmi3Error);
  x[TR_Q] = 1000;
  CHECK_EQ(FMI(fmi3SetContinuousStates)(m.instance, x.data(), x.size()), fmi3Discard);
  const Reference two[] = {input(TR_PEDAL), input(TR_LAT_STICK)};
  const double values[] = {0.5, 100};
  const double pedal = m.get(two[0]);
  CHECK_EQ(FMI(fmi3SetFloat64)(m.instance, two, 2, values, 2), fmi3Error);
  CHECK_EQ(m.set(input(TR_COLLECTIVE), kNan), fmi3Error);
  CHECK_EQ(m.get(two[0]), pedal);
  CHECK(m.states() == before);
  CHECK_EQ(FMI(fmi3SetTime)(m.instance, kNan), fmi3Error);

  Master c(Master::co_simulation);
  CHECK_EQ(c.start(0, 40), fmi3OK);
  for (const double dt : {0.0, -0.01, kNan, HUGE_VAL}) CHECK_EQ(c.step(0, dt), fmi3Error);
  CHECK_EQ(c.step(1, 0.01), fmi3Error);
  CHECK_EQ(c.step(kNan, 0.01), fmi3Error);
  CHECK_EQ(FMI(fmi3DoStep)(c.instance, 0, 0.01, true, nullptr, nullptr, nullptr, nullptr), fmi3Error);
  CHECK_EQ(c.step(0, 0.01), fmi3OK);
}

// Each is refused at the end of initialization, in one line that says why.
TEST(fmu_parameters_that_do_not_fit_are_refused_in_words) {
  const auto refusal = [](Master::Kind kind, Reference at, double value, const char* word) {
    Master m(kind);
    const bool on = true;
    const bool set = m.set(at, value) == fmi3OK || FMI(fmi3SetBoolean)(m.instance, &at, 1, &on, 1) == fmi3OK;
    CHECK(set);
    m.log.clear();
    CHECK_EQ(m.start(0, 0), fmi3Error);
    if (CHECK_EQ(m.log.size(), 1u) && !CHECK(m.log[0].find(word) != std::string::npos)) NOTE(m.log[0]);
    CHECK_EQ(FMI(fmi3Reset)(m.instance), fmi3OK);
    CHECK_EQ(m.start(0, 40), fmi3OK);
  };
  refusal(Master::model_exchange, setting(kGear), 1, "environment");
  refusal(Master::co_simulation, setting(kWindEast), 5, "environment");
  refusal(Master::model_exchange, setting(kScas), 1, "Co-Simulation");
  refusal(Master::model_exchange, setting(kTurbulence), 1, "Co-Simulation");
  refusal(Master::model_exchange, setting(kInterconnect), 1, "governor");
  refusal(Master::co_simulation, setting(kTemperatureOffset), 5, "environment");
}

// A description of another version, no name, or what is not there: no instance.
TEST(fmu_instances_are_refused_in_words) {
  std::vector<std::string> log;
  const std::string token = attribute(description(), "instantiationToken");
  const auto begin = FMI(fmi3InstantiateModelExchange);
  CHECK(begin("one", "{another}", "", false, true, &log, keep_message) == nullptr);
  CHECK(begin("one", nullptr, "", false, true, &log, keep_message) == nullptr);
  CHECK(begin(nullptr, token.c_str(), "", false, true, &log, keep_message) == nullptr);
  CHECK(begin("one", "{another}", nullptr, false, true, nullptr, nullptr) == nullptr);
  CHECK(FMI(fmi3InstantiateScheduledExecution)("one", token.c_str(), "", false, true, &log, keep_message,
                                               nullptr, nullptr, nullptr) == nullptr);
  CHECK_EQ(log.size(), 4u);
  const fmi3Instance silent = begin("one", token.c_str(), nullptr, false, false, nullptr, nullptr);
  CHECK(silent != nullptr);
  CHECK_EQ(FMI(fmi3EnterEventMode)(silent), fmi3Error);
  FMI(fmi3FreeInstance)(silent);
  // Without a log that was asked for errors are told all the same, until they are switched off.
  const fmi3Instance terse = begin("one", token.c_str(), nullptr, false, false, &log, keep_message);
  CHECK_EQ(FMI(fmi3EnterEventMode)(terse), fmi3Error);
  CHECK_EQ(log.size(), 5u);
  CHECK_EQ(FMI(fmi3SetDebugLogging)(terse, false, 0, nullptr), fmi3OK);
  CHECK_EQ(FMI(fmi3EnterEventMode)(terse), fmi3Error);
  CHECK_EQ(log.size(), 5u);
  FMI(fmi3FreeInstance)(terse);
}

// Two instances at once are as each alone, and a flight begun by hand stays as it was set.
TEST(fmu_instances_do_not_disturb_each_other) {
  const auto fly = [](Master& m, Master* beside) {
    for (int step = 0; step < 20; ++step) {
      CHECK_EQ(m.step(step * 0.01, 0.01), fmi3OK);
      if (beside != nullptr) CHECK_EQ(beside->step(step * 0.01, 0.01), fmi3OK);
    }
    std::vector<double> x;
    for (int k = 0; k < TR_STATES; ++k) x.push_back(m.get(state(k)));
    return x;
  };
  Master alone(Master::co_simulation), one(Master::co_simulation), two(Master::co_simulation);
  CHECK_EQ(alone.start(0, 40), fmi3OK);
  CHECK_EQ(one.start(0, 40), fmi3OK);
  CHECK_EQ(two.set(state(TR_NORTH), 1000), fmi3OK);
  CHECK_EQ(two.set(input(TR_PEDAL), 0.5), fmi3OK);
  CHECK_EQ(two.start(90, 100), fmi3OK);
  CHECK_EQ(two.get(state(TR_NORTH)), 1000.0);
  CHECK_EQ(two.get(input(TR_PEDAL)), 0.5);
  CHECK(fly(one, &two) == fly(alone, nullptr));
}
#endif

// The landing gear of the FMU. Expected: an order of rates, the same numbers the second time.
#include "tiltrotor/tiltrotor.h"

#ifndef TR_SINGLE_PRECISION
#include "fmu/master.hpp"
#include "this_aircraft.hpp"

using namespace fmu;
using namespace tiltrotor_fmu;

// A gear is down and up at once where no step moves it, and its drag with it.
TEST(fmu_gear_moves_at_once_in_model_exchange) {
  Master m(Master::model_exchange);
  CHECK_EQ(m.set_switch(kEnvironment, true), fmi3OK);
  CHECK_EQ(m.set_switch(kGear, true), fmi3OK);
  CHECK_EQ(m.set(setting(kGroundDown), 500), fmi3OK);
  CHECK_LE(m.start(90, 80), fmi3Warning);
  const auto slows = [&m](bool down) {
    CHECK_EQ(FMI(fmi3EnterEventMode)(m.instance), fmi3OK);
    CHECK_EQ(m.set_switch(kGearDown, down), fmi3OK);
    CHECK_EQ(FMI(fmi3EnterContinuousTimeMode)(m.instance), fmi3OK);
    double rates[kContinuousStates];
    CHECK_EQ(FMI(fmi3GetContinuousStateDerivatives)(m.instance, rates, kContinuousStates), fmi3OK);
    return rates[TR_U];
  };
  const double down = slows(true), up = slows(false);
  CHECK_LT(down + 0.1, up);
  CHECK_EQ(slows(true), down);
}
#endif

// The landing gear of the FMU. Expected: an order of rates, the same numbers the second time; heights by the rotation of
// the published stations of the gear; an acceleration that the gear alone makes.
#include "tiltrotor/tiltrotor.h"

#ifndef TR_SINGLE_PRECISION
#include <algorithm>
#include <array>
#include <cmath>

#include "fmu/master.hpp"
#include "this_aircraft.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

using namespace fmu;
using namespace tiltrotor_fmu;

namespace {

const tiltrotor::Aircraft<double>& aircraft() { return tiltrotor::aircraft_data<double>(); }

// Waterline of the lowest point of an extended wheel, m.
template <class Strut>
double line_of(const Strut& strut) {
  const double oleo = aircraft().gear.static_stroke * strut.stroke;
  return aircraft().gear.ground_wl - oleo - oleo * strut.oleo_stiffness / strut.tyre_stiffness;
}

// Half a metre below the main wheels, m below the start.
double ground() { return aircraft().mass.wl_cg - line_of(aircraft().gear.main) + 0.5; }

void begin_over_ground(Master& m) {
  CHECK_EQ(m.set_switch(kEnvironment, true), fmi3OK);
  CHECK_EQ(m.set_switch(kGear, true), fmi3OK);
  CHECK_EQ(m.set(setting(kGroundDown), ground()), fmi3OK);
  CHECK_LE(m.start(0, 0), fmi3Warning);
}

// Nose, right, left: lowest points of the extended wheels, of the state alone, masts up.
std::array<double, 3> heights(const std::vector<double>& x) {
  tr_setup setup;
  CHECK_EQ(tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0), 0), TR_OK);
  const auto height = [&](const auto& strut, double side) {
    const double ahead = setup.cg_station_m - strut.sl, below = aircraft().mass.wl_cg - line_of(strut);
    const double roll = x[TR_ROLL], pitch = x[TR_PITCH];
    return ground() - x[TR_DOWN] + std::sin(pitch) * ahead -
           std::cos(pitch) * (std::sin(roll) * side * strut.bl + std::cos(roll) * below);
  };
  return {height(aircraft().gear.nose, 0), height(aircraft().gear.main, 1), height(aircraft().gear.main, -1)};
}

std::array<double, 3> indicators(const Master& m) {
  std::array<double, 3> found = {};
  CHECK_EQ(FMI(fmi3GetEventIndicators)(m.instance, found.data(), found.size()), fmi3OK);
  return found;
}

}  // namespace

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

// Down onto the ground, banked to the right: the wheels meet it one after another.
TEST(fmu_event_indicators_change_sign_where_wheels_meet_the_ground) {
  std::size_t count = 0;
  Master m(Master::model_exchange), up(Master::model_exchange);
  CHECK_EQ(FMI(fmi3GetNumberOfEventIndicators)(m.instance, &count), fmi3OK);
  CHECK_EQ(count, 3u);
  begin_over_ground(m);
  begin_over_ground(up);
  CHECK_EQ(FMI(fmi3EnterEventMode)(up.instance), fmi3OK);
  CHECK_EQ(up.set_switch(kGearDown, false), fmi3OK);
  CHECK_EQ(FMI(fmi3EnterContinuousTimeMode)(up.instance), fmi3OK);
  std::vector<double> x = m.states();
  x[TR_ROLL] += 0.05;
  x[TR_W] += 1;
  CHECK_EQ(FMI(fmi3SetContinuousStates)(m.instance, x.data(), x.size()), fmi3OK);
  std::array<double, 3> last = indicators(m);
  int crossed = 0, carried = 0;
  for (int step = 0; step < 400; ++step) {
    m.integrate(0.005, 4);
    x = m.states();
    const std::array<double, 3> now = indicators(m), expected = heights(x);
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK_NEAR(now[k], expected[k], 1e-12);
      CHECK_EQ(now[k], m.get(reference_of(Role::indicator, static_cast<int>(k))));
      if (now[k] < 0 && last[k] >= 0) ++crossed;
    }
    last = now;
    // The same state with the gear up, less its drag: the ground acts where a wheel is below it.
    const double push = up.rates(x)[TR_W] - m.rates(x)[TR_W];
    const double least = *std::min_element(now.begin(), now.end());
    if (least > 0.01) CHECK_LT(std::abs(push), 0.05);
    if (least < -0.02 && x[TR_W] > 0.1) {  // on the rebound a damper lets go
      CHECK_LT(0.1, push);
      ++carried;
    }
  }
  CHECK_EQ(crossed, 3);
  CHECK_LT(10, carried);
}

// Of down, bank, pitch, mast and fuel: differences of order 2. Without gear they are 1 and know nothing.
TEST(fmu_event_indicators_have_exact_derivatives) {
  Master m(Master::model_exchange);
  CHECK_EQ(m.set_switch(kConversion, true), fmi3OK);
  CHECK_EQ(m.set_switch(kEngines, true), fmi3OK);
  begin_over_ground(m);
  std::vector<double> x = m.states();
  x[TR_ROLL] = 0.2;
  x[TR_PITCH] = -0.1;
  x[TR_MAST] = 0.4;
  x[TR_FUEL] = 50;
  for (const int known :
       {int{TR_DOWN}, int{TR_ROLL}, int{TR_PITCH}, int{TR_YAW}, int{TR_MAST}, int{TR_FUEL}}) {
    const double step = known == TR_FUEL ? 5 : 1e-4;
    std::array<double, 3> found[2], slope = {};
    for (const std::size_t way : {0, 1}) {
      std::vector<double> y = x;
      y[static_cast<std::size_t>(known)] += way == 0 ? step : -step;
      CHECK_EQ(FMI(fmi3SetContinuousStates)(m.instance, y.data(), y.size()), fmi3OK);
      found[way] = indicators(m);
    }
    CHECK_EQ(FMI(fmi3SetContinuousStates)(m.instance, x.data(), x.size()), fmi3OK);
    const Reference of[] = {6000, 6001, 6002}, by = state(known);
    const double one = 1;
    CHECK_EQ(FMI(fmi3GetDirectionalDerivative)(m.instance, of, 3, &by, 1, &one, 1, slope.data(), 3), fmi3OK);
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK_NEAR(slope[k], (found[0][k] - found[1][k]) / (2 * step), 1e-7);
      CHECK(known == TR_YAW ? slope[k] == 0 : slope[k] != 0 || (known == TR_ROLL && k == 0));
    }
  }
  Master without(Master::model_exchange);
  CHECK_LE(without.start(0, 0), fmi3Warning);
  for (const double each : indicators(without)) CHECK_EQ(each, 1.0);
}

// As many as the description names, each a variable.
TEST(fmu_event_indicators_are_in_the_description) {
  const std::string text = description();
  int count = 0;
  for (std::size_t at = text.find("<EventIndicator "); at != std::string::npos;
       at = text.find("<EventIndicator ", at + 1), ++count) {
    const std::string named = "valueReference=\"" + attribute(text, "valueReference", at) + "\"";
    CHECK_LT(text.find(named), text.find("</ModelVariables>"));
  }
  CHECK_EQ(count, 3);
  CHECK_LT(text.rfind("<InitialUnknown "), text.find("<EventIndicator "));
}
#endif

// The FMU as an importer meets it, against the library: the same numbers, bit for bit where it steps itself.
#include "tiltrotor/tiltrotor.h"

#ifndef TR_SINGLE_PRECISION
#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#include "fmu/master.hpp"
#include "plot/xml_check.hpp"
#include "this_aircraft.hpp"

using namespace fmu;
using namespace tiltrotor_fmu;

namespace {

// The library's own aircraft in the same flight.
struct Own {
  tr_sim sim;
  std::unique_ptr<tr_work> work = std::make_unique<tr_work>();

  Own(double mast_deg, double speed) {
    tr_setup setup;
    CHECK_EQ(tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0), mast_deg), TR_OK);
    CHECK_EQ(tr_init(&sim, TR_API_VERSION, &setup), TR_OK);
    trim(speed);
  }
  void trim(double speed) {
    const tr_flight flight = {speed, 0, 0, 0};
    CHECK_EQ(tr_trim(&sim, work.get(), &flight, nullptr), TR_OK);
  }
  tr_state state() const {
    tr_state now;
    CHECK_EQ(tr_get_state(&sim, &now), TR_OK);
    return now;
  }
};

constexpr double kFlights[][2] = {{0, 40}, {30, 60}, {90, 100}};

// Into the numbers that A and B hold: how far each unknown moves along one known.
std::vector<double> along(const Master& m, const std::vector<Reference>& unknown, Reference known,
                          double seed) {
  std::vector<double> found(unknown.size());
  CHECK_EQ(FMI(fmi3GetDirectionalDerivative)(m.instance, unknown.data(), unknown.size(), &known, 1, &seed, 1,
                                             found.data(), found.size()),
           fmi3OK);
  return found;
}

}  // namespace

// Expected: tr_step, with the method it uses at this step length.
TEST(fmu_model_exchange_equals_steps) {
  for (const auto& flight : kFlights) {
    Own own(flight[0], flight[1]);
    Master m(Master::model_exchange);
    CHECK_EQ(m.start(flight[0], flight[1]), fmi3OK);
    double worst = 0;
    double control[TR_CONTROLS];
    std::copy_n(own.state().u, TR_CONTROLS, control);
    control[TR_LONG_STICK] += 0.3;
    control[TR_GUST_W] = 1.5;
    CHECK_EQ(tr_set_controls(&own.sim, control, TR_CONTROLS), TR_OK);
    for (const int j : {TR_LONG_STICK, TR_GUST_W}) CHECK_EQ(m.set(input(j), control[j]), fmi3OK);
    for (int step = 0; step < 60; ++step) {
      const bool fine = step < 40;
      const double dt = fine ? 0.004 : 0.011;
      CHECK_EQ(tr_step(&own.sim, own.work.get(), dt), TR_OK);
      m.integrate(dt, fine ? 3 : 4);
      const std::vector<double> x = m.states();
      const tr_state expected = own.state();
      for (std::size_t k = 0; k < x.size(); ++k)
        worst = std::max(worst, std::abs(x[k] - expected.x[k]) / std::max(1.0, std::abs(expected.x[k])));
    }
    CHECK_LE(worst, 1e-12);
    NOTE("mast " << flight[0] << ": " << worst);
    tr_outputs outputs;
    CHECK_EQ(tr_get_outputs(&own.sim, &outputs), TR_OK);
    CHECK_REL(m.get(output(0)), outputs.airspeed_mps, 1e-12);
    CHECK_REL(m.get(output(8)), outputs.thrust_n[0], 1e-10);
    CHECK_NEAR(m.get(output(22)), outputs.rudder_rad, 1e-12);
  }
}

// Short communication steps are steps of the library; long ones are cut.
TEST(fmu_co_simulation_equals_steps_bit_for_bit) {
  for (const auto& flight : kFlights) {
    Own own(flight[0], flight[1]);
    Master m(Master::co_simulation);
    CHECK_EQ(m.start(flight[0], flight[1]), fmi3OK);
    double control[TR_CONTROLS];
    std::copy_n(own.state().u, TR_CONTROLS, control);
    double time = 0;
    for (int step = 0; step < 60; ++step) {
      control[TR_LAT_STICK] = 0.01 * step;
      CHECK_EQ(tr_set_controls(&own.sim, control, TR_CONTROLS), TR_OK);
      CHECK_EQ(m.set(input(TR_LAT_STICK), control[TR_LAT_STICK]), fmi3OK);
      const int parts = step % 20 == 0 ? 4 : 1;
      const double dt = parts == 4 ? 0.04 : 0.005;
      for (int k = 0; k < parts; ++k) CHECK_EQ(tr_step(&own.sim, own.work.get(), dt / parts), TR_OK);
      CHECK_EQ(m.step(time, dt), fmi3OK);
      time += dt;
    }
    const tr_state expected = own.state();
    for (int k = 0; k < TR_STATES; ++k) CHECK_EQ(m.get(state(k)), expected.x[k]);
    for (int j = 0; j < TR_CONTROLS; ++j) CHECK_EQ(m.get(input(j)), expected.u[j]);
    CHECK_EQ(m.get(0), time);
  }
}

// The whole vehicle: systems on, commands given. Expected: the library, set the same way.
TEST(fmu_systems_fly_as_in_the_library) {
  Own own(0, 0);
  tr_environment e;
  CHECK_EQ(tr_default_environment(&e), TR_OK);
  e.ground_down_m = 100;
  CHECK_EQ(tr_set_environment(&own.sim, &e), TR_OK);
  tr_systems s;
  CHECK_EQ(tr_get_systems(&own.sim, &s), TR_OK);
  s.governor = TR_GOVERNOR_PI;
  s.conversion = s.engines = s.actuators = s.scas = s.gear = s.ground_effect = s.turbulence = 1;
  s.turbulence_seed = 7;
  s.turbulence_w20_mps = 7.7;
  s.wind_shear = TR_SHEAR_OTHER;
  CHECK_EQ(tr_set_systems(&own.sim, &s), TR_OK);
  own.trim(20);

  Master m(Master::co_simulation);
  for (const int k :
       {kEnvironment, kConversion, kEngines, kActuators, kScas, kGear, kGroundEffect, kTurbulence})
    CHECK_EQ(m.set_switch(k, true), fmi3OK);
  const Reference governor = setting(kGovernor), seed = setting(kTurbulenceSeed);
  const Reference shear = setting(kWindShear);
  const std::int64_t pi = TR_GOVERNOR_PI, other = TR_SHEAR_OTHER;
  const std::uint32_t seven = 7;
  CHECK_EQ(FMI(fmi3SetInt64)(m.instance, &governor, 1, &pi, 1), fmi3OK);
  CHECK_EQ(FMI(fmi3SetInt64)(m.instance, &shear, 1, &other, 1), fmi3OK);
  CHECK_EQ(FMI(fmi3SetUInt32)(m.instance, &seed, 1, &seven, 1), fmi3OK);
  CHECK_EQ(m.set(setting(kTurbulenceW20), 7.7), fmi3OK);
  CHECK_EQ(m.set(setting(kGroundDown), 100), fmi3OK);
  CHECK_EQ(m.start(0, 20), fmi3OK);

  CHECK_EQ(tr_get_systems(&own.sim, &s), TR_OK);
  s.mast_command_deg = 10;
  s.gear_down = 0;
  CHECK_EQ(tr_set_systems(&own.sim, &s), TR_OK);
  CHECK_EQ(m.set(input(TR_CONTROLS), 10 * kRadians), fmi3OK);
  CHECK_EQ(m.set_switch(kGearDown, false), fmi3OK);
  e.wind_mps[0] = 3;
  CHECK_EQ(tr_set_environment(&own.sim, &e), TR_OK);
  CHECK_EQ(m.set(setting(kWindNorth), 3), fmi3OK);
  for (int step = 0; step < 100; ++step) {
    CHECK_EQ(tr_step(&own.sim, own.work.get(), 0.01), TR_OK);
    CHECK_EQ(m.step(step * 0.01, 0.01), fmi3OK);
  }
  const tr_state expected = own.state();
  for (int k = 0; k < TR_STATES; ++k) CHECK_EQ(m.get(state(k)), expected.x[k]);
  CHECK_LT(0.01, expected.x[TR_MAST]);
}

// Expected: A, B, C and D of the library.
TEST(fmu_directional_and_adjoint_derivatives_are_those_of_the_linear_model) {
  for (const auto& flight : kFlights) {
    Own own(flight[0], flight[1]);
    Master m(Master::model_exchange);
    CHECK_EQ(m.start(flight[0], flight[1]), fmi3OK);
    constexpr int most = TR_MAX_LINEAR_STATES;
    static double a[most * most], b[most * TR_CONTROLS], c[TR_OUTPUTS * most], d[TR_OUTPUTS * TR_CONTROLS];
    tr_linear_shape shape;
    CHECK_EQ(tr_linearize(&own.sim, own.work.get(), TR_ALL_CONTROLS, &shape, a, most * most, b,
                          most * TR_CONTROLS),
             TR_OK);
    CHECK_EQ(tr_linearize_outputs(&own.sim, own.work.get(), TR_ALL_CONTROLS, c, TR_OUTPUTS * most, d,
                                  TR_OUTPUTS * TR_CONTROLS),
             TR_OK);
    const int n = shape.states;
    std::vector<Reference> unknown, known;
    for (int i = 0; i < n; ++i) unknown.push_back(rate(shape.state[i]));
    for (int k = 0; k < TR_OUTPUTS; ++k) unknown.push_back(output(k));
    for (int j = 0; j < n; ++j) known.push_back(state(shape.state[j]));
    for (int j = 0; j < shape.controls; ++j) known.push_back(input(shape.control[j]));
    const auto slope = [&](std::size_t row, std::size_t column) {
      const std::size_t rows = static_cast<std::size_t>(n),
                        controls = static_cast<std::size_t>(shape.controls);
      const double* const of_state = row < rows ? a + row * rows : c + (row - rows) * rows;
      const double* const of_control = row < rows ? b + row * controls : d + (row - rows) * controls;
      return column < rows ? of_state[column] : of_control[column - rows];
    };
    std::vector<double> largest(unknown.size(), 1), seed(unknown.size()), adjoint(known.size()),
        sum(known.size());
    for (std::size_t i = 0; i < unknown.size(); ++i) {
      seed[i] = 1 / (1.0 + static_cast<double>(i));
      for (std::size_t j = 0; j < known.size(); ++j) {
        largest[i] = std::max(largest[i], std::abs(slope(i, j)));
        sum[j] += seed[i] * slope(i, j);
      }
    }
    double worst = 0;
    for (std::size_t j = 0; j < known.size(); ++j) {
      const std::vector<double> column = along(m, unknown, known[j], 2);
      for (std::size_t i = 0; i < unknown.size(); ++i)
        worst = std::max(worst, std::abs(column[i] - 2 * slope(i, j)) / largest[i]);
    }
    CHECK_LE(worst, 1e-11);
    CHECK_EQ(
        FMI(fmi3GetAdjointDerivative)(m.instance, unknown.data(), unknown.size(), known.data(), known.size(),
                                      seed.data(), seed.size(), adjoint.data(), adjoint.size()),
        fmi3OK);
    for (std::size_t j = 0; j < known.size(); ++j)
      CHECK_NEAR(adjoint[j], sum[j], 1e-11 * *std::max_element(largest.begin(), largest.end()));
  }
}

// Where the air follows the altitude, its density is in the derivative by down. Expected: differences of the FMU's own
// derivatives, of order 2 in 4 m.
TEST(fmu_derivative_by_altitude_knows_the_air) {
  Master m(Master::model_exchange);
  CHECK_EQ(m.set_switch(kEnvironment, true), fmi3OK);
  CHECK_EQ(m.start(0, 40), fmi3OK);
  const std::vector<Reference> unknown = {rate(TR_W), rate(TR_Q), rate(TR_DOWN)};
  const std::vector<double> exact = along(m, unknown, state(TR_DOWN), 1);
  std::vector<double> x = m.states();
  x[TR_DOWN] += 2;
  const std::vector<double> below = m.rates(x);
  x[TR_DOWN] -= 4;
  const std::vector<double> above = m.rates(x);
  const std::size_t row[] = {TR_W, TR_Q, TR_DOWN};
  for (std::size_t k = 0; k < 3; ++k) CHECK_NEAR(exact[k], (below[row[k]] - above[row[k]]) / 4, 1e-8);
  CHECK_LT(1e-4, std::abs(exact[0]));
}

// What the description does not name has no slope.
TEST(fmu_dependencies_cover_every_slope) {
  Master m(Master::model_exchange);
  for (const int k : {kEnvironment, kConversion, kEngines, kActuators, kGear, kConing})
    CHECK_EQ(m.set_switch(k, true), fmi3OK);
  CHECK_EQ(m.set(setting(kTrimSideslip), 0.05), fmi3OK);
  // A wind that grows with height, 20 m above the ground.
  const Reference shear = setting(kWindShear);
  const fmi3Int64 terminal = 1;
  CHECK_EQ(FMI(fmi3SetInt64)(m.instance, &shear, 1, &terminal, 1), fmi3OK);
  CHECK_EQ(m.set(setting(kGroundDown), 20), fmi3OK);
  CHECK_EQ(m.set(setting(kWindNorth), -8), fmi3OK);
  CHECK_LE(m.start(30, 60), fmi3Warning);
  std::vector<Reference> unknown;
  for (int k = 0; k < kContinuousStates; ++k) unknown.push_back(rate(k));
  for (int k = 0; k < kOutputs; ++k) unknown.push_back(output(k));
  for (int k = 0; k < kWheels; ++k) unknown.push_back(reference_of(Role::indicator, k));
  std::vector<std::vector<Reference>> named(unknown.size());
  for (std::size_t i = 0; i < unknown.size(); ++i) {
    std::size_t count = 0;
    CHECK_EQ(FMI(fmi3GetNumberOfVariableDependencies)(m.instance, unknown[i], &count), fmi3OK);
    named[i].resize(count);
    std::vector<std::size_t> element(count), other(count);
    std::vector<fmi3DependencyKind> kind(count);
    CHECK_EQ(FMI(fmi3GetVariableDependencies)(m.instance, unknown[i], element.data(), named[i].data(),
                                              other.data(), kind.data(), count),
             fmi3OK);
  }
  for (int k = 0; k < kContinuousStates + TR_INPUTS; ++k) {
    const Reference known = k < kContinuousStates ? state(k) : input(k - kContinuousStates);
    const std::vector<double> slope = along(m, unknown, known, 1);
    for (std::size_t i = 0; i < unknown.size(); ++i)
      if (slope[i] != 0 && !CHECK_EQ(std::count(named[i].begin(), named[i].end(), known), 1))
        NOTE(unknown[i] << " depends on " << known);
  }
}

// Copies and bytes lead back, and the flight is the same from there on.
TEST(fmu_saved_states_replay_bit_for_bit) {
  Master m(Master::co_simulation);
  CHECK_EQ(m.set_switch(kEnvironment, true), fmi3OK);
  CHECK_EQ(m.start(0, 40), fmi3OK);
  CHECK_EQ(m.set(input(TR_PEDAL), 0.4), fmi3OK);
  for (int step = 0; step < 10; ++step) CHECK_EQ(m.step(step * 0.01, 0.01), fmi3OK);
  fmi3FMUState copy = nullptr;
  CHECK_EQ(FMI(fmi3GetFMUState)(m.instance, &copy), fmi3OK);
  std::size_t size = 0;
  CHECK_EQ(FMI(fmi3SerializedFMUStateSize)(m.instance, copy, &size), fmi3OK);
  std::vector<fmi3Byte> bytes(size);
  CHECK_EQ(FMI(fmi3SerializeFMUState)(m.instance, copy, bytes.data(), size), fmi3OK);
  const auto fly = [](const Master& who) {
    for (int step = 10; step < 30; ++step) CHECK_EQ(who.step(step * 0.01, 0.01), fmi3OK);
    std::vector<double> x;
    for (int k = 0; k < TR_STATES; ++k) x.push_back(who.get(state(k)));
    return x;
  };
  const std::vector<double> first = fly(m);
  CHECK_EQ(FMI(fmi3SetFMUState)(m.instance, copy), fmi3OK);
  CHECK(fly(m) == first);
  CHECK_EQ(FMI(fmi3FreeFMUState)(m.instance, &copy), fmi3OK);
  CHECK(copy == nullptr);
  // Another instance, which has not even been initialised.
  Master other(Master::co_simulation);
  CHECK_EQ(FMI(fmi3DeserializeFMUState)(other.instance, bytes.data(), size, &copy), fmi3OK);
  CHECK_EQ(FMI(fmi3SetFMUState)(other.instance, copy), fmi3OK);
  CHECK(fly(other) == first);
  for (const std::size_t at : {std::size_t{3}, sizeof(double) * 12, size / 2}) {
    std::vector<fmi3Byte> changed = bytes;
    changed[at] ^= 4;
    fmi3FMUState none = nullptr;
    CHECK_EQ(FMI(fmi3DeserializeFMUState)(other.instance, changed.data(), size, &none), fmi3Error);
    CHECK(none == nullptr);
  }
}

// In Model Exchange an event: velocity over the ground stays. Expected: tr_set_environment.
TEST(fmu_wind_is_an_event) {
  Own own(0, 0);
  tr_environment e;
  CHECK_EQ(tr_default_environment(&e), TR_OK);
  CHECK_EQ(tr_set_environment(&own.sim, &e), TR_OK);
  own.trim(40);
  e.wind_mps[0] = 5;
  CHECK_EQ(tr_set_environment(&own.sim, &e), TR_OK);
  Master m(Master::model_exchange);
  CHECK_EQ(m.set_switch(kEnvironment, true), fmi3OK);
  CHECK_EQ(m.start(0, 40), fmi3OK);
  const auto states_changed = [&m] {
    bool flag = true, changed = false;
    double next = 0;
    CHECK_EQ(FMI(fmi3UpdateDiscreteStates)(m.instance, &flag, &flag, &flag, &changed, &flag, &next), fmi3OK);
    return changed;
  };
  CHECK_EQ(FMI(fmi3EnterEventMode)(m.instance), fmi3OK);
  CHECK(!states_changed());
  CHECK_EQ(m.set(setting(kWindNorth), 5), fmi3OK);
  CHECK(states_changed());
  CHECK(!states_changed());
  CHECK_EQ(FMI(fmi3EnterContinuousTimeMode)(m.instance), fmi3OK);
  const std::vector<double> x = m.states();
  for (int k = 0; k < TR_MAST; ++k) CHECK_EQ(x[static_cast<std::size_t>(k)], own.state().x[k]);
  CHECK_LT(x[TR_U], 36);
}

// The description is well formed and every variable in it answers with its own type.
TEST(fmu_description_is_that_of_the_binary) {
  const std::string text = description();
  CHECK_EQ(check::XmlChecker::fault(text), "");
  Master m(Master::model_exchange);
  CHECK_EQ(FMI(fmi3EnterInitializationMode)(m.instance, false, 0, 0, false, 0), fmi3OK);
  int count = 0;
  const std::size_t begin = text.find("<ModelVariables>"), end = text.find("</ModelVariables>");
  for (std::size_t at = text.find("    <", begin); at < end; at = text.find("    <", at + 5), ++count) {
    const std::string type = text.substr(at + 5, text.find(' ', at + 5) - at - 5);
    const std::string line = text.substr(at, text.find("/>", at) - at);
    const Reference reference = static_cast<Reference>(std::stoul(attribute(line, "valueReference")));
    const std::string start = attribute(line, "start");
    fmi3Status status = fmi3Error;
    double value = 0;
    if (type == "Float64") {
      status = FMI(fmi3GetFloat64)(m.instance, &reference, 1, &value, 1);
    } else if (type == "Boolean") {
      bool on = false;
      status = FMI(fmi3GetBoolean)(m.instance, &reference, 1, &on, 1);
      CHECK_EQ(start, on ? "true" : "false");
    } else if (type == "UInt32") {
      std::uint32_t number = 1;
      status = FMI(fmi3GetUInt32)(m.instance, &reference, 1, &number, 1);
      CHECK_EQ(std::to_string(number), start);
    } else {
      std::int64_t number = 0;
      status = FMI(fmi3GetInt64)(m.instance, &reference, 1, &number, 1);
      CHECK_EQ(std::to_string(number), start);
    }
    if (!CHECK_EQ(status, fmi3OK)) NOTE(line);
    const std::string unit = attribute(line, "unit");
    if (!CHECK(unit.empty() || text.find("<Unit name=\"" + unit + "\">") < begin)) NOTE(line);
    // A rate is of the unit of its state a second.
    const std::string of_state = "\"" + attribute(line, "derivative") + "\"";
    if (of_state != "\"\"") {
      const std::string whole = attribute(text, "unit", text.find("valueReference=" + of_state, begin));
      const bool is_per_second = whole.size() > 2 && whole.substr(whole.size() - 2) == "/s";
      if (!CHECK(unit == (is_per_second ? whole + "2" : whole + "/s") || unit == "1/s")) NOTE(line);
    }
    if (type == "Float64" && !start.empty() && !CHECK_EQ(std::stod(start), value)) NOTE(line);
  }
  int variables = 0;
  for (const int of_role : kCount) variables += of_role;
  CHECK_EQ(count, variables);
  CHECK_EQ(std::string(FMI(fmi3GetVersion)()), "3.0");
}
#endif

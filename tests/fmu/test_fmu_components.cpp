// Outputs of components in the FMU: loads, and angles of the flow at wing and tail. Expected: names, numbers, C and D of the command
// line; complex steps of the whole model.
#include "tiltrotor/tiltrotor.h"

#ifndef TR_SINGLE_PRECISION
#include <algorithm>
#include <cmath>
#include <memory>

#include "cli/complex_outputs.hpp"
#include "cli/exported_model.hpp"
#include "cli/named_outputs.hpp"
#include "fmu/instance.hpp"
#include "fmu/master.hpp"
#include "library/c_memory.hpp"
#include "this_aircraft.hpp"

using namespace fmu;
using namespace tiltrotor_fmu;
namespace cli = tiltrotor::cli;
namespace c_interface = tiltrotor::c_interface;

namespace {

std::vector<Reference> of_components() {
  std::vector<Reference> all;
  for (int k = kFirstOfComponents; k < kOutputs; ++k) all.push_back(output(k));
  return all;
}

// Of the description, without "output.".
std::string name_of(int place) {
  static const std::string text = description();
  const std::size_t at = text.find("valueReference=\"" + std::to_string(output(place)) + "\"");
  return attribute(text, "name", text.rfind('<', at)).substr(std::string("output.").size());
}

std::vector<double> along(const Master& m, const std::vector<Reference>& unknown, Reference known) {
  const double one = 1;
  std::vector<double> found(unknown.size());
  CHECK_EQ(FMI(fmi3GetDirectionalDerivative)(m.instance, unknown.data(), unknown.size(), &known, 1, &one, 1,
                                             found.data(), found.size()),
           fmi3OK);
  return found;
}

std::vector<double> values(const Master& m, const std::vector<Reference>& all) {
  std::vector<double> found(all.size());
  CHECK_EQ(FMI(fmi3GetFloat64)(m.instance, all.data(), all.size(), found.data(), found.size()), fmi3OK);
  return found;
}

void set_choice(const Master& m, int of, std::int64_t value) {
  const Reference reference = setting(of);
  CHECK_EQ(FMI(fmi3SetInt64)(m.instance, &reference, 1, &value, 1), fmi3OK);
}

// Away from the steady flight, so that nothing vanishes by symmetry; its states.
void upset(const Master& m) {
  std::vector<double> x = m.states();
  const struct {
    int state;
    double by;
  } moves[] = {{TR_V, 3},    {TR_W, 2},     {TR_P, 0.1},         {TR_Q, -0.07},
               {TR_R, 0.05}, {TR_ROLL, .2}, {TR_ROTOR_LEFT, .01}};
  for (const auto& move : moves) x[static_cast<std::size_t>(move.state)] += move.by;
  CHECK_EQ(FMI(fmi3SetContinuousStates)(m.instance, x.data(), x.size()), fmi3OK);
}

double bend_of(bool is_state, int index) {
  return is_state ? tiltrotor::vehicle_variable(index).facts().bend
                  : tiltrotor::vehicle_input(index).facts().bend;
}

// Every slope of every such output, by states and inputs, in the flight that the instance is in: over the largest of its row.
double worst_against_complex_steps(const Master& m) {
  const c_interface::Sim& s = *c_interface::opened(&static_cast<const Instance*>(m.instance)->flight.sim);
  const auto c = std::make_unique<tiltrotor::Configuration<double>>();
  c_interface::equipped(s, *c);
  const std::vector<Reference> unknown = of_components();
  std::vector<cli::AirframeOutput> wanted;
  for (int k = kFirstOfComponents; k < kOutputs; ++k)
    wanted.push_back(cli::output_named(name_of(k), "")->output);
  const std::vector<double> y = values(m, unknown);
  std::vector<double> size(unknown.size(), 1e-9), error(unknown.size(), 0);
  constexpr double step = 1e-30;
  for (int j = 0; j < kContinuousStates + TR_INPUTS; ++j) {
    const bool is_state = j < kContinuousStates;
    const int index = is_state ? j : j - kContinuousStates;
    tiltrotor::VehicleShape one{};
    (is_state ? one.states : one.inputs) = 1;
    (is_state ? one.state : one.input)[0] = index;
    const auto expected =
        complex_model::outputs_of(s.systems, *c, c_interface::evaluated_state(s), s.u, one, 0, step, wanted);
    const std::vector<double> found = along(m, unknown, is_state ? state(index) : input(index));
    for (std::size_t k = 0; k < unknown.size(); ++k) {
      if (!CHECK_NEAR(y[k], expected[k].real(), 1e-11 * (1 + std::abs(expected[k].real())))) NOTE(k);
      const double slope = expected[k].imag() / step, bend = bend_of(is_state, index);
      size[k] = std::max(size[k], std::abs(slope * bend));
      error[k] = std::max(error[k], std::abs((found[k] - slope) * bend));
    }
  }
  double worst = 0;
  for (std::size_t k = 0; k < unknown.size(); ++k) worst = std::max(worst, error[k] / size[k]);
  return worst;
}

}  // namespace

// All names of the command line that can be listed, states apart, with their units.
TEST(fmu_has_every_output_of_the_command_line) {
  const std::string text = description();
  int count = 0;
  for (const std::string& name : cli::output_names()) {
    const auto named = cli::output_named(name, "");
    if (named->reading < 0 && named->output.kind == cli::AirframeOutput::Kind::state) continue;
    ++count;
    const std::size_t at = text.find(" name=\"output." + name + "\"");
    if (!CHECK(at != std::string::npos)) {
      NOTE(name);
      continue;
    }
    const std::size_t line = text.rfind('<', at);
    const std::string unit = attribute(text.substr(line, text.find("/>", line) - line), "unit");
    CHECK_EQ(unit, named->unit == "-"       ? ""
                   : named->unit == "N m"   ? "N.m"
                   : named->unit == "m/s^2" ? "m/s2"
                                            : named->unit);
  }
  CHECK_EQ(count, kOutputs - 3);  // mast, flap, rotor_speed are states of the command line
}

// The command line trims by itself: its y, C and D to the accuracy of a trim.
TEST(fmu_outputs_of_components_are_those_of_the_command_line) {
  const std::vector<Reference> unknown = of_components();
  std::string list;
  for (int k = kFirstOfComponents; k < kOutputs; ++k)
    list += (k == kFirstOfComponents ? "" : ",") + name_of(k);
  const std::pair<const char*, std::pair<double, double>> flights[] = {{"--mast 0 --speed 20", {0, 20}},
                                                                       {"--mast 30 --speed 45", {30, 45}},
                                                                       {"--mast 90 --speed 100", {90, 100}}};
  for (const auto& [text, at] : flights) {
    const check::ExportedModel model(this_aircraft::flown(std::string(text) + " --grid realtime") +
                                     " --outputs " + list);
    Master m(Master::model_exchange);
    CHECK_EQ(m.set(setting(kAltitude), this_aircraft::altitude()), fmi3OK);
    CHECK_LE(m.start(at.first, this_aircraft::given("--speed", at.second)), fmi3Warning);
    const std::vector<double> y = values(m, unknown);
    std::vector<double> row(unknown.size(), 1e-6);
    for (std::size_t k = 0; k < unknown.size(); ++k) {
      if (!CHECK_NEAR(y[k], model.y0[k], 1e-9 * (std::abs(model.y0[k]) + (k < 2 ? 1 : 1e3))))
        NOTE(model.outputs[k]);
      for (std::size_t j = 0; j < model.n(); ++j)
        row[k] = std::max(row[k], std::abs(model.c[k * model.n() + j]));
      for (std::size_t j = 0; j < model.m(); ++j)
        row[k] = std::max(row[k], std::abs(model.d[k * model.m() + j]));
    }
    const auto compare = [&](Reference known, const std::vector<double>& matrix, std::size_t width,
                             std::size_t column) {
      const std::vector<double> found = along(m, unknown, known);
      for (std::size_t k = 0; k < unknown.size(); ++k)
        if (!CHECK_NEAR(found[k], matrix[k * width + column], 1e-8 * row[k]))
          NOTE(model.outputs[k] << " by " << known);
    };
    int columns = 0;
    for (int k = 0; k < kContinuousStates; ++k)
      for (std::size_t j = 0; j < model.n(); ++j)
        if (model.states[j] == tr_state_name(k)) compare(state(k), model.c, model.n(), j), ++columns;
    for (int k = 0; k < TR_INPUTS; ++k)
      for (std::size_t j = 0; j < model.m(); ++j)
        if (model.controls[j] == tr_control_name(k)) compare(input(k), model.d, model.m(), j), ++columns;
    CHECK_LE(25, columns);
  }
}

// Expected: complex steps of the model with its systems, alone and in the air of its altitude, whatever governs the rotors.
TEST(fmu_derivatives_of_components_equal_complex_steps) {
  for (const int governor : {0, 1, 2})
    for (const bool systems : {false, true}) {
      Master m(Master::model_exchange);
      set_choice(m, kGovernor, governor);
      CHECK_EQ(m.set_switch(kEnvironment, systems), fmi3OK);
      for (const int k : {kConversion, kEngines, kActuators, kGear, kGroundEffect})
        CHECK_EQ(m.set_switch(k, systems), fmi3OK);
      if (systems) {
        CHECK_EQ(m.set(setting(kGroundDown), 8), fmi3OK);
        CHECK_EQ(m.set(setting(kWindNorth), -5), fmi3OK);
        set_choice(m, kWindShear, 1);
      }
      CHECK_LE(m.start(40, 45 * this_aircraft::speed()), fmi3Warning);
      upset(m);
      const double worst = worst_against_complex_steps(m);
      if (!CHECK_LE(worst, 1e-11)) NOTE("governor " << governor << ", systems " << systems);
      NOTE("largest difference " << worst << " of the row");
    }
}

// The air follows the altitude with no system on.
TEST(fmu_derivatives_of_components_know_the_air) {
  Master m(Master::model_exchange);
  CHECK_EQ(m.set_switch(kEnvironment, true), fmi3OK);
  CHECK_LE(m.start(40, 45 * this_aircraft::speed()), fmi3Warning);
  upset(m);
  CHECK_LE(worst_against_complex_steps(m), 1e-11);
  CHECK_LT(0.1, std::abs(along(m, of_components(), state(TR_DOWN)).back()));
}

// Expected: directions, one by one.
TEST(fmu_adjoints_of_components_are_those_of_directions) {
  Master m(Master::model_exchange);
  CHECK_LE(m.start(40, 45 * this_aircraft::speed()), fmi3Warning);
  upset(m);
  std::vector<Reference> unknown = of_components(), known;
  unknown.push_back(rate(TR_Q));
  unknown.push_back(output(0));
  for (int k = 0; k < TR_NORTH; ++k) known.push_back(state(k));
  for (int j = 0; j < TR_CONTROLS; ++j) known.push_back(input(j));
  std::vector<double> seed(unknown.size()), adjoint(known.size());
  for (std::size_t k = 0; k < seed.size(); ++k) seed[k] = 1 / (1.0 + static_cast<double>(k));
  CHECK_EQ(
      FMI(fmi3GetAdjointDerivative)(m.instance, unknown.data(), unknown.size(), known.data(), known.size(),
                                    seed.data(), seed.size(), adjoint.data(), adjoint.size()),
      fmi3OK);
  for (std::size_t j = 0; j < known.size(); ++j) {
    const std::vector<double> column = along(m, unknown, known[j]);
    double sum = 0, size = 0;
    for (std::size_t k = 0; k < seed.size(); ++k) {
      sum += seed[k] * column[k];
      size += std::abs(seed[k] * column[k]);
    }
    CHECK_NEAR(adjoint[j], sum, 1e-13 * size);
  }
}

// The mass times what the accelerometers feel; in steps, in turbulence and with the augmentation as well.
TEST(fmu_loads_of_all_components_move_the_aircraft) {
  for (const bool systems : {false, true}) {
    Master m(Master::co_simulation);
    for (const int k : {kTurbulence, kScas}) CHECK_EQ(m.set_switch(k, systems), fmi3OK);
    CHECK_LE(m.start(40, 45 * this_aircraft::speed()), fmi3Warning);
    CHECK_EQ(m.set(input(TR_PEDAL), 0.3), fmi3OK);
    for (int k = 0; k < 20; ++k) CHECK_EQ(m.step(k * 0.01, 0.01), fmi3OK);
    const int all = kOutputLoads + (kLoadedComponents - 1) * kNumbersOfLoads;
    const double mass = m.get(setting(kMass));
    for (int axis = 0; axis < 3; ++axis)
      CHECK_REL(m.get(output(all + axis)), mass * m.get(output(3 + axis)), 1e-12);
  }
}
#endif

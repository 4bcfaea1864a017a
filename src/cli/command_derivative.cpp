// `tiltrotor derivative`: f(x, u) at given states.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "cli/command.hpp"
#include "cli/errors.hpp"
#include "cli/output.hpp"
#include "cli/states_option.hpp"
#include "tiltrotor/model/derivative.hpp"

namespace tiltrotor::cli {

namespace {

// The first 24 states always, the others when they are alive.
std::vector<int> printed_states(const Options& options) {
  const ActiveStates active = active_states(options, true);
  std::vector<int> states;
  for (int i = 0; i < kStateIndex.coning[right].angle; ++i) states.push_back(i);
  for (int k = 0; k < active.count; ++k) {
    if (active.index[k] >= kStateIndex.coning[right].angle) states.push_back(active.index[k]);
  }
  return states;
}

int run(const Arguments& arguments) {
  const SetupOptions setup(arguments);
  GivenStates given(arguments, setup);
  StateFile& file = given.file();
  const std::vector<int> states = printed_states(setup.switches());
  std::vector<std::string> columns = file.columns();
  for (const int i : states) columns.push_back(std::string("d_") + kStateVariables[i].name);

  Output output(arguments);
  Records records = output.records(columns, Output::to_compare);
  int status = exit_success;
  const auto visit = [&](const StateRow& row) {
    State<double> rates;
    derivative(given.configuration(row), row.state, row.controls, rates);
    double flat[state_count];
    flatten(rates, flat);
    Row cells = row.cells;
    for (const int i : states) cells.emplace_back(flat[i]);
    records.add(cells);
    const double* const bad =
        std::find_if(flat, flat + state_count, [](double r) { return !std::isfinite(r); });
    if (bad != flat + state_count) {
      std::fprintf(stderr, "tiltrotor: %s:%zu: the derivative of this state is not finite: d_%s\n",
                   file.path().c_str(), row.line, kStateVariables[static_cast<int>(bad - flat)].name);
      status = exit_case_failed;
    }
  };
  file.each(output.shard().begin(file.size()), output.shard().end(file.size()), visit);
  records.finish();
  return status;
}

}  // namespace

Command derivative_command() {
  return {
      "derivative",
      "xdot = f(x, u) at given states",
      "Prints the columns of the file as they stand and, for every state, d_<state>: its rate of change.\n"
      "The configuration follows the columns mast_deg, altitude_m, flap_deg, rotor_rpm, mass_kg and cg_sl_in "
      "of "
      "each\n"
      "row where they are there, else the options of these names.\n",
      "tiltrotor derivative --states trims.csv  # after: tiltrotor trim --speed 20:10:50 --output trims.csv",
      states_option() + mast_option() + SetupOptions::list() + Output::list(),
      run};
}

}  // namespace tiltrotor::cli

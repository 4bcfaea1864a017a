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
  for (int i = 0; i < ix_coning_right; ++i) states.push_back(i);
  for (int k = 0; k < active.count; ++k) {
    if (active.index[k] >= ix_coning_right) states.push_back(active.index[k]);
  }
  return states;
}

int run(const Arguments& arguments) {
  const SetupOptions setup(arguments);
  const StateFile file = given_states(arguments, setup);
  const std::vector<int> states = printed_states(setup.switches());
  std::vector<std::string> columns = file.columns;
  for (const int i : states) columns.push_back(std::string("d_") + kStateNames[i].name);

  Output output(arguments);
  Records records = output.records(columns, Output::to_compare);
  int status = exit_success;
  for (std::size_t r = output.shard().begin(file.rows.size()); r < output.shard().end(file.rows.size());
       ++r) {
    const StateRow& row = file.rows[r];
    State<double> rates;
    derivative(setup.configuration(*row.mast_deg), row.state, row.controls, rates);
    double flat[state_count];
    pack(rates, flat);
    Row cells = row.cells;
    for (const int i : states) cells.emplace_back(flat[i]);
    records.add(cells);
    if (!std::all_of(std::begin(flat), std::end(flat), [](double rate) { return std::isfinite(rate); })) {
      std::fprintf(stderr, "tiltrotor: %s:%zu: the derivative of this state is not finite\n",
                   file.path.c_str(), row.line);
      status = exit_case_failed;
    }
  }
  records.finish();
  return status;
}

}  // namespace

Command derivative_command() {
  return {
      "derivative",
      "xdot = f(x, u) at given states",
      "Prints the columns of the file as they stand and, for every state, d_<state>: its rate of change.\n"
      "The configuration follows the column mast_deg of each row, else --mast.\n",
      "tiltrotor derivative --states states.csv --tables linear",
      states_option() + mast_option() + SetupOptions::list() + Output::list(),
      run};
}

}  // namespace tiltrotor::cli

// `tiltrotor derivative`: f(x, u) at given states.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>

#include "cli/command.hpp"
#include "cli/errors.hpp"
#include "cli/output.hpp"
#include "cli/states_option.hpp"
#include "text/rounding.hpp"
#include "tiltrotor/model/derivative.hpp"

namespace tiltrotor::cli {

namespace {

// Rates at a state, a rate zero where it is the rounding of what acts.
void rates_without_rounding(const Configuration<double>& c, const StateRow& row,
                            double (&rates)[state_count]) {
  Evaluation<double> evaluation;
  evaluate_aircraft(c, row.state, row.controls, evaluation);
  double forces = kGravity<double> * c.mass.mass;
  double moments = 0;
  for (const Loads<double>& l : evaluation.loads.component) {
    forces += std::sqrt(dot(l.force, l.force));
    moments += std::sqrt(dot(l.moment, l.moment));
  }
  flatten(evaluation.rates, rates);
  const double mass = c.mass.mass;
  const Inertia<double>& inertia = c.mass.inertia;
  const Vec3<int>& velocity = kStateIndex.velocity;
  const Vec3<int>& turning = kStateIndex.rates;
  const struct {
    int state;
    double terms;
  } sums[] = {{velocity.x, forces / mass},       {velocity.y, forces / mass},
              {velocity.z, forces / mass},       {turning.x, moments / inertia.xx},
              {turning.y, moments / inertia.yy}, {turning.z, moments / inertia.zz}};
  for (const auto& sum : sums) rates[sum.state] = without_rounding(rates[sum.state], sum.terms);
}

int run(const Arguments& arguments) {
  const SetupOptions setup(arguments);
  GivenStates given(arguments, setup);
  const std::vector<int> states = needed_states(setup.switches());
  std::vector<std::string> columns = given.file().columns();
  for (const int i : states) columns.push_back(std::string("d_") + kStateVariables[i].name);

  Output output(arguments);
  Records records = output.records(columns, Output::to_compare);
  const auto visit = [&](const StateRow& row, const Configuration<double>& configuration) -> int {
    double rates[state_count];
    std::fill(std::begin(rates), std::end(rates), std::numeric_limits<double>::quiet_NaN());
    if (row.fault.empty()) rates_without_rounding(configuration, row, rates);
    Row cells = row.cells;
    for (const int i : states) cells.emplace_back(rates[i]);
    records.add(cells);
    const double* const bad =
        std::find_if(std::begin(rates), std::end(rates), [](double r) { return !std::isfinite(r); });
    if (bad == std::end(rates)) return exit_success;
    if (row.fault.empty()) {
      std::fprintf(stderr, "tiltrotor: %s:%zu: the derivative of this state is not finite: d_%s\n",
                   given.file().path().c_str(), row.line,
                   kStateVariables[static_cast<int>(bad - rates)].name);
    }
    return exit_case_failed;
  };
  const int exit_status = given.each(output.shard(), visit);
  records.finish();
  return exit_status;
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

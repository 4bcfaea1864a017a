// `tiltrotor loads`: force and moment of every component.

#include <cmath>
#include <cstdio>
#include <functional>

#include "cli/command.hpp"
#include "cli/errors.hpp"
#include "cli/flight_records.hpp"
#include "cli/states_option.hpp"
#include "text/rounding.hpp"
#include "tiltrotor/model/derivative.hpp"

namespace tiltrotor::cli {

namespace {

const std::vector<std::string> columns = {"case", "mast_deg", "component", "x_n", "y_n",
                                          "z_n",  "l_nm",     "m_nm",      "n_nm"};

using AddRow = std::function<void(const Row&)>;

void add_row(const AddRow& add, const std::string& name, double mast_deg, const char* component,
             const Loads<double>& loads) {
  const Vec3<double>& f = loads.force;
  const Vec3<double>& m = loads.moment;
  add({name, as_given(mast_deg), component, f.x, f.y, f.z, m.x, m.y, m.z});
}

int add_state(const AddRow& add_to_rows, const std::string& name, const Configuration<double>& configuration,
              const State<double>& state, const Controls<double>& controls) {
  Evaluation<double> evaluation;
  evaluate_aircraft(configuration, state, controls, evaluation);
  Loads<double> total{};
  double forces = 0;
  double moments = 0;
  for (const Loads<double>& l : evaluation.loads.component) {
    total = total + l;
    forces += std::sqrt(dot(l.force, l.force));
    moments += std::sqrt(dot(l.moment, l.moment));
  }
  const auto add = [&](const char* component, const Loads<double>& l) {
    add_row(add_to_rows, name, configuration.setup.mast_deg, component,
            {without_rounding(l.force, forces), without_rounding(l.moment, moments)});
  };
  const bool jets = configuration.setup.options.engine_jets;
  for (int i = 0; i < component_count; ++i)
    if (jets || static_cast<Component>(i) != Component::engine_jets)
      add(kComponentNames[i], evaluation.loads.component[i]);
  add("total_aero", total);
  const double size = dot(total.force, total.force) + dot(total.moment, total.moment);
  if (std::isfinite(size)) return exit_success;
  for (int i = 0; i < component_count; ++i) {
    const Loads<double>& l = evaluation.loads.component[i];
    if (std::isfinite(dot(l.force, l.force) + dot(l.moment, l.moment))) continue;
    std::fprintf(stderr, "tiltrotor: loads: case %s: the loads of this state are not finite: %s\n",
                 name.c_str(), kComponentNames[i]);
    break;
  }
  return exit_case_failed;
}

int loads_at_given_states(const Arguments& arguments, const SetupOptions& setup) {
  GivenStates given(arguments, setup);
  Output output(arguments);
  Records records = output.records(columns, Output::to_compare);
  const auto visit = [&](const StateRow& row, const Configuration<double>& configuration) -> int {
    if (!row.fault.empty()) return exit_case_failed;
    return add_state([&](const Row& r) { records.add(r); }, row.name, configuration, row.state, row.controls);
  };
  const int exit_status = given.each(output.shard(), visit);
  records.finish();
  return exit_status;
}

int loads_at_trim(const Arguments& arguments, const SetupOptions& setup) {
  flight_cases(arguments);
  Output output(arguments);
  FlightRecords records(arguments, {setup}, output, columns, Output::to_compare);
  const AnalysesWorkspace work;
  const int exit_status =
      for_each_trim(arguments, {setup}, output.shard(), *work, [&](const TrimmedFlight& flight) -> int {
        if (!is_trimmed(flight.trim.status)) return exit_case_failed;
        return add_state([&](const Row& row) { records.add(flight, row); }, std::to_string(flight.number),
                         flight.configuration, flight.trim.state, flight.trim.controls);
      });
  records.finish();
  return exit_status;
}

int run(const Arguments& arguments) {
  const SetupOptions setup(arguments);
  return arguments.given("--states") ? loads_at_given_states(arguments, setup)
                                     : loads_at_trim(arguments, setup);
}

}  // namespace

Command loads_command() {
  return {
      "loads",
      "force and moment of every component at given states or at trim",
      "Components and their sum, total_aero: force on the aircraft and moment about the CG, body axes, "
      "without\n"
      "weight. States come from --states, else from trim at every combination of --mast and --speed; `case`\n"
      "counts from 0 unless the file names it.\n",
      "tiltrotor loads --mast 0 --speed 0,40",
      states_option() + flight_list() + SetupOptions::list() + Output::list(),
      run};
}

}  // namespace tiltrotor::cli

// `tiltrotor linearize`: A and B at trim or at given states.

#include <algorithm>
#include <cstdio>
#include <memory>

#include "cli/chosen_model.hpp"
#include "cli/command.hpp"
#include "cli/derived_columns.hpp"
#include "cli/flight_records.hpp"
#include "cli/linear_output.hpp"
#include "cli/states_option.hpp"

namespace tiltrotor::cli {

namespace {

// One linear model after another, written to the output.
class Linearizer {
 public:
  Linearizer(const Arguments& arguments, const Options& options, bool single,
             const std::vector<std::string>& swept = {})
      : model_(arguments, options), output_(arguments, single, swept) {}

  const Shard& shard() const { return output_.shard(); }
  Analyses& work() const { return *work_; }

  int add(LinearCase which, const Configuration<double>& c, const State<double>& x, const Controls<double>& u,
          const TrimmedFlight* flight = nullptr) {
    ShownModel shown;
    const Status status = model_.find(c, x, u, output_.wants_outputs(), *work_, shown);
    which.valid = status == Status::ok;
    tell_settings(c, flight, which);
    which.settings.feedback = model_.gains(c, x, u);
    if (!which.valid) {
      which.status = status_word(status);
      std::fprintf(stderr, "tiltrotor: %s, case %s: %s\n",
                   flight_text("linearize", which.mast_deg, which.speed).c_str(), which.name.c_str(),
                   status_text(status));
    }
    output_.add(which, shown);
    return which.valid ? exit_success : exit_case_failed;
  }

  void add_without_model(LinearCase which, const Configuration<double>& c,
                         const TrimmedFlight* flight = nullptr) {
    tell_settings(c, flight, which);
    output_.add(which, ShownModel());
  }
  void finish() { output_.finish(); }

 private:
  void tell_settings(const Configuration<double>& c, const TrimmedFlight* flight, LinearCase& which) const {
    which.settings = LinearSettings(c);
    if (flight != nullptr) which.settings.add(*flight);
    model_.tell(which.settings);
  }

  ChosenModel model_;
  LinearOutput output_;  // last of what arguments can refuse, since it begins to write
  AnalysesWorkspace work_;
};

int at_given_states(const Arguments& arguments, const SetupOptions& setup) {
  GivenStates given(arguments, setup);
  Linearizer linearizer(arguments, setup.switches(), given.file().size() == 1);
  const auto visit = [&](const StateRow& row, const Configuration<double>& configuration) -> int {
    const bool usable = row.fault.empty();
    // In the digits that files of states have.
    double speed = 0;
    read_number(number_text(airspeed(row.state, row.controls), Output::to_read), speed);
    const LinearCase which{row.name, configuration.setup.mast_deg, speed, usable ? "ok" : "no_state", usable,
                           {}};
    if (usable) return linearizer.add(which, configuration, row.state, row.controls);
    linearizer.add_without_model(which, configuration);
    return exit_case_failed;
  };
  const int exit_status = given.each(linearizer.shard(), visit);
  linearizer.finish();
  return exit_status;
}

int at_trim(const Arguments& arguments, const SetupOptions& setup) {
  const SweptColumns swept(arguments, {setup}, {"mast_deg", "speed_mps"});
  Linearizer linearizer(arguments, setup.switches(), flight_cases(arguments).size() == 1, swept.names());
  const int exit_status = for_each_trim(
      arguments, {setup}, linearizer.shard(), linearizer.work(), [&](const TrimmedFlight& flight) -> int {
        const bool trimmed = is_trimmed(flight.trim.status);
        LinearCase which{std::to_string(flight.number),        flight.mast_deg, flight.flight.speed,
                         trim_status_word(flight.trim.status), trimmed,         {}};
        which.swept = swept.values(flight);
        if (trimmed)
          return linearizer.add(which, flight.configuration, flight.trim.state, flight.trim.controls,
                                &flight);
        linearizer.add_without_model(which, flight.configuration, &flight);
        return exit_success;
      });
  linearizer.finish();
  return exit_status;
}

int run(const Arguments& arguments) {
  const SetupOptions setup(arguments);
  // Rows of files need the switch to be read.
  if (!arguments.given("--states")) require_no_positions(setup.switches(), arguments);
  return arguments.given("--states") ? at_given_states(arguments, setup) : at_trim(arguments, setup);
}

}  // namespace

Command linearize_command() {
  return {
      "linearize",
      "exact linear models A, B at trim or at given states",
      "A = df/dx and B = df/du with names and units of every row and column, at every combination of "
      "--mast and\n"
      "--speed or at the states of a file. JSON is an object for one case and an array for several:\n"
      "  case mast_deg speed_mps status program{name,version,aircraft,commit,derivatives}\n"
      "  settings{mast_deg,...,isa_offset_k,engines,...,hold,free,feedback[{input,output,gain}],switches{NAME}} states[{name,unit}]\n"
      "  controls[{name,unit}] x0 u0 A B outputs[{name,unit}] y0 C D.\n"
      "With --feedback they are those of the closed loop, with what the pilot adds in the place of u.\n"
      "The matlab script makes `model`, with the same members, and of every case model(k).ss where ss() is known.\n",
      "tiltrotor linearize --mast 90 --speed 80 --format json",
      reduce_option() + control_set_option() + outputs_option() + scas_option() + feedback_option() +
          states_option() + flight_list() + SetupOptions::list() + LinearOutput::list(),
      run};
}

}  // namespace tiltrotor::cli

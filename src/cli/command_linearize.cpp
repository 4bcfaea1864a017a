// `tiltrotor linearize`: A and B at trim or at given states.

#include <algorithm>
#include <cstdio>
#include <memory>

#include "cli/command.hpp"
#include "cli/derived_columns.hpp"
#include "cli/feedback.hpp"
#include "cli/flight_records.hpp"
#include "cli/governed.hpp"
#include "cli/linear_options.hpp"
#include "cli/linear_output.hpp"
#include "cli/named_outputs.hpp"
#include "cli/states_option.hpp"

namespace tiltrotor::cli {

namespace {

// One linear model after another, written to the output.
class Linearizer {
 public:
  Linearizer(const Arguments& arguments, const Options& options, bool single,
             const std::vector<std::string>& swept = {})
      : rigid_(wants_rigid(arguments)),
        order_(reduction_order(arguments)),
        controls_(control_set(arguments)),
        scas_(wants_scas(arguments)),
        feedback_(arguments, options, scas_),
        chosen_(chosen_outputs(arguments)),
        output_(arguments, single, swept),
        model_(std::make_unique<LinearModel<double>>()),
        matrices_(std::make_unique<VehicleMatrices>()),
        outputs_(std::make_unique<OutputMatrices>()) {
    for (const NamedOutput& output : chosen_)
      if (output.reading < 0) airframe_.push_back(output);
  }

  const Shard& shard() const { return output_.shard(); }
  Analyses& work() const { return *work_; }

  int add(LinearCase which, const Configuration<double>& c, const State<double>& x, const Controls<double>& u,
          const TrimmedFlight* flight = nullptr) {
    ShownModel shown;
    const Status status = find(c, x, u, shown);
    which.valid = status == Status::ok;
    tell_settings(c, flight, which);
    which.settings.feedback = feedback_.gains(c, x, u);
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
    which.settings.switches.emplace_back("reduce", reduce_word(rigid_, order_));
    which.settings.switches.emplace_back("feedback", feedback_.name());
    which.settings.switches.emplace_back("scas", scas_ ? "on" : "off");
  }

  Status find(const Configuration<double>& c, const State<double>& x, const Controls<double>& u,
              ShownModel& shown) {
    Controls<double> at = u;
    const SystemFlight<double> flight = governed(c, x, at, scas_);
    const bool wants_outputs = output_.wants_outputs() || !chosen_.empty();
    if (c.setup.options.governor != Governor::off || scas_) {
      VehicleOutputs* const outputs = wants_outputs ? governed_outputs_.get() : nullptr;
      Status status = feedback_.linearize_governed(c, x, u, controls_, *work_, *matrices_, scas_, outputs);
      if (status == Status::ok) status = find_rows(flight, c, x, at);
      if (status == Status::ok && rigid_) status = reduce_to_rigid(*matrices_, order_, outputs, &rows_);
      shown = ShownModel(*matrices_, x, flight.state, at, flight.vehicle.commands);
      if (status == Status::ok && outputs != nullptr) show_outputs(*outputs, shown);
      return status;
    }
    OutputMatrices* const outputs = wants_outputs ? outputs_.get() : nullptr;
    Status status = feedback_.is_given() ? feedback_.linearize(c, x, u, controls_, *work_, *model_, outputs)
                                         : linearize(c, x, u, controls_, *work_, *model_);
    if (status == Status::ok && outputs != nullptr && !feedback_.is_given())
      status = linearize_outputs(c, x, u, controls_, *work_, *outputs);
    if (status == Status::ok) status = find_rows(flight, c, x, at);
    if (status == Status::ok && rigid_) status = reduce_to_rigid(*model_, order_, outputs, &rows_);
    shown = ShownModel(*model_);
    if (status == Status::ok && outputs != nullptr) show_outputs(*outputs, shown);
    return status;
  }

  // Outputs that no instrument reads, of the model found last.
  Status find_rows(const SystemFlight<double>& flight, const Configuration<double>& c, const State<double>& x,
                   const Controls<double>& u) {
    return airframe_.empty() ? Status::ok
                             : feedback_.linearize_rows(flight, c, x, u, controls_, scas_, airframe_, rows_);
  }

  // All that instruments read, or what was chosen.
  template <class Instrumental>
  void show_outputs(const Instrumental& outputs, ShownModel& shown) const {
    if (chosen_.empty()) return shown.add_outputs(outputs);
    int row = 0;
    for (const NamedOutput& output : chosen_) {
      if (output.reading >= 0) shown.add_output(output, outputs, output.reading);
      if (output.reading < 0) shown.add_output(output, rows_, row++);
    }
  }

  bool rigid_;
  Reduction order_;
  ControlSet controls_;
  bool scas_;
  Feedback feedback_;
  std::vector<NamedOutput> chosen_;
  std::vector<NamedOutput> airframe_;  // those among them that no instrument reads
  LinearOutput output_;                // last of what arguments can refuse, since it begins to write
  std::unique_ptr<LinearModel<double>> model_;
  std::unique_ptr<VehicleMatrices> matrices_;
  std::unique_ptr<OutputMatrices> outputs_;
  std::unique_ptr<VehicleOutputs> governed_outputs_ = std::make_unique<VehicleOutputs>();
  VehicleRows rows_;
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

// The linear model that a command was asked for: --reduce, --control-set, --scas, --feedback and --outputs.
#pragma once

#include <memory>
#include <vector>

#include "cli/feedback.hpp"
#include "cli/linear_options.hpp"
#include "cli/linear_settings.hpp"
#include "cli/shown_model.hpp"

namespace tiltrotor::cli {

class ChosenModel {
 public:
  // Throws UsageError for a law or an output that is none.
  ChosenModel(const Arguments& arguments, const Options& options);

  const std::vector<NamedOutput>& outputs() const { return outputs_; }  // that were chosen
  // At (x, u) of the airframe. `with_outputs`: all that instruments read, where none were chosen. Status: those of linear
  // models, of their outputs, and of reduce_to_rigid().
  Status find(const Configuration<double>& c, const State<double>& x, const Controls<double>& u,
              bool with_outputs, Analyses& work, ShownModel& shown);
  // A and B of the model found last, without what rounding is taken off for display.
  const VehicleMatrices& matrices() const { return *matrices_; }
  // Names of rows and columns, whatever the flight.
  ShownModel names(const Options& options) const;
  // What was chosen, and the gains of the law at a state.
  void tell(LinearSettings& settings) const;
  std::vector<FeedbackGain> gains(const Configuration<double>& c, const State<double>& x,
                                  const Controls<double>& u) const {
    return feedback_.gains(c, x, u);
  }

 private:
  Status find_airframe_model(const Configuration<double>& c, const State<double>& x,
                             const Controls<double>& u, OutputMatrices* outputs, Analyses& work);
  Status find_rows(const SystemFlight<double>& flight, const Configuration<double>& c, const State<double>& x,
                   const Controls<double>& u);
  template <class Instrumental>
  void show_outputs(const Instrumental& found, ShownModel& shown) const;

  bool rigid_;
  Reduction order_;
  ControlSet controls_;
  bool scas_;
  Feedback feedback_;
  std::vector<NamedOutput> outputs_;
  std::vector<NamedOutput> airframe_;  // those among them that no instrument reads
  std::unique_ptr<LinearModel<double>> model_ = std::make_unique<LinearModel<double>>();
  std::unique_ptr<VehicleMatrices> matrices_ = std::make_unique<VehicleMatrices>();
  std::unique_ptr<OutputMatrices> instruments_ = std::make_unique<OutputMatrices>();
  std::unique_ptr<VehicleOutputs> governed_instruments_ = std::make_unique<VehicleOutputs>();
  VehicleRows rows_;
};

}  // namespace tiltrotor::cli

// The feedback law of a command, and linear models closed by it.
#pragma once

#include <memory>
#include <string>

#include "cli/arguments.hpp"
#include "cli/feedback_file.hpp"
#include "cli/governed.hpp"
#include "cli/named_outputs.hpp"
#include "library/vehicle_outputs.hpp"

namespace tiltrotor::cli {

OptionList feedback_option();

// One of a law, by name.
struct FeedbackGain {
  std::string input, output;
  double gain;  // unit of the input over that of the output
};

class Feedback {
 public:
  Feedback() = default;  // none
  // --feedback, for the model of these options. Throws UsageError for a file that is no law for it.
  Feedback(const Arguments& arguments, const Options& options, bool scas);
  // The same for a vehicle of these states.
  Feedback(const Arguments& arguments, const Options& options, const VehicleShape& shape);

  bool is_given() const { return file_ != nullptr; }
  const FeedbackLaw<double>& law() const { return file_->law(); }
  const std::string& name() const { return name_; }  // of the file, or "none"
  // Those that close a linear model there; none without a law.
  std::vector<FeedbackGain> gains(const Configuration<double>& c, const State<double>& x,
                                  const Controls<double>& u) const;

  // The airframe's model of these columns, closed; `outputs`, or nullptr: C and D beside it. `at`: where the law stands,
  // or nullptr at y_0. Status: those of linearize() and close_controls().
  Status linearize(const Configuration<double>& c, const State<double>& x, const Controls<double>& u,
                   const ControlSet& columns, Analyses& work, LinearModel<double>& model,
                   OutputMatrices* outputs, const FeedbackPoint<double>* at = nullptr,
                   double azimuth = 0) const;
  // linearize_flight() and linearize_governed(), closed where there is a law; outputs and `at` as above.
  Status linearize_flight(const Configuration<double>& c, const SystemFlight<double>& flight,
                          const State<double>& x, const Controls<double>& u, const ControlSet& columns,
                          CommandColumns commands, Analyses& work, VehicleMatrices& matrices,
                          VehicleOutputs* outputs = nullptr, const FeedbackPoint<double>* at = nullptr,
                          double azimuth = 0) const;
  Status linearize_governed(const Configuration<double>& c, const State<double>& x, const Controls<double>& u,
                            const ControlSet& columns, Analyses& work, VehicleMatrices& matrices,
                            bool scas = false, VehicleOutputs* outputs = nullptr) const;

  // y, C and D of outputs that no instrument reads, in the columns of the model that was found last; `u` with what
  // systems add. Status: those of linearize_airframe_outputs().
  Status linearize_rows(const SystemFlight<double>& flight, const Configuration<double>& c,
                        const State<double>& x, const Controls<double>& u, const ControlSet& columns,
                        bool scas, const std::vector<NamedOutput>& outputs, VehicleRows& rows) const;

 private:
  struct Work;
  Feedback(const Arguments& arguments, const ReadingNames& names);
  // How the controls follow, in the work area; `outputs`: C and D that the law reads, or nullptr.
  template <class Outputs>
  Status find_controls(const FeedbackPoint<double>& at, const VehicleShape& shape,
                       const Outputs* outputs) const;

  std::string name_ = "none";
  std::shared_ptr<FeedbackFile> file_;
  std::shared_ptr<Work> work_;
};

}  // namespace tiltrotor::cli

// Which input to which output, at which frequencies: chosen on the command line.
#pragma once

#include <optional>

#include "cli/named_outputs.hpp"
#include "tiltrotor/analysis/linear/channel.hpp"

namespace tiltrotor::cli {

struct ChannelChoice {
  int output;  // place in vehicle_variable(): a state of the model, or the heading
  int input;   // place in vehicle_input()
  std::optional<NamedOutput> named = std::nullopt;  // in the place of `output`
  bool is_heading() const { return !named && output == kStateIndex.yaw; }
  std::string output_name() const;
  std::string name() const;
  std::string unit() const;  // of the output over that of the input
};

// --from and --to, of which each may be a list.
OptionList channel_options();
// Every combination, outputs of one input together: states, psi, and what `linearize --outputs` takes. Throws UsageError
// for a name that the model has not.
std::vector<ChannelChoice> channel_choices(const Arguments& arguments, const VehicleShape& shape);

// --frequency, rad/s: values, lists, ranges, and LOW..HIGH.
Option frequency_option();
std::vector<double> frequencies(const Arguments& arguments);

}  // namespace tiltrotor::cli

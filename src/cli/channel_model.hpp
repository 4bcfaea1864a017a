// The linear model of a flight with the rows of the outputs that --to chose, and its channels.
#pragma once

#include <memory>
#include <vector>

#include "cli/channel_options.hpp"
#include "cli/feedback.hpp"
#include "cli/transfer_of.hpp"
#include "cli/trimmed_flights.hpp"

namespace tiltrotor::cli {

class ChannelModel {
 public:
  // --from, --to, --scas and --feedback.
  ChannelModel(const Arguments& arguments, const Options& options);

  const std::vector<ChannelChoice>& choices() const { return choices_; }
  // At a trim. Status: those of linear models and of their outputs.
  Status find(const TrimmedFlight& flight, Analyses& work);
  // Of the model found last. Status: those of transfer_function().
  Status find_channel(const ChannelChoice& which, TransferOf& transfer) const;

 private:
  bool scas_;
  Feedback feedback_;
  std::vector<ChannelChoice> choices_;
  std::vector<NamedOutput> airframe_;  // outputs that no instrument reads, each once: the rows
  bool reads_instruments_ = false;
  State<double> x_{};  // of the trim
  std::unique_ptr<VehicleMatrices> matrices_ = std::make_unique<VehicleMatrices>();
  std::unique_ptr<VehicleOutputs> instruments_ = std::make_unique<VehicleOutputs>();
  VehicleRows rows_;
};

}  // namespace tiltrotor::cli

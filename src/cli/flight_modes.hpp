// Linear models of the whole vehicle along a flight, and their modes.
#pragma once

#include "cli/analyses_workspace.hpp"
#include "cli/script_flight.hpp"
#include "cli/shown_model.hpp"

namespace tiltrotor::cli {

class FlightModes {
 public:
  explicit FlightModes(const ControlSet& controls);
  // Whatever is switched on; `twists`: the interconnect may.
  static VehicleShape shape(const Options& options, bool twists);
  ~FlightModes();
  // Names of every state and input that a model may have, whatever is switched on.
  std::vector<std::string> states(const Options& options, bool twists) const;
  std::vector<std::string> inputs() const;

  // At this moment, every system that is on within, in the air that there is; of the loop that a feedback law closes.
  Status linearize(const ScriptFlight& flight);
  ShownModel model(const ScriptFlight& flight) const;
  // Of that model.
  Status find();
  const VehicleModes<double>& found() const;

 private:
  struct Work;
  ControlSet controls_;
  std::unique_ptr<Work> work_;
};

}  // namespace tiltrotor::cli

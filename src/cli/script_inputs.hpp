// What a script does to single inputs: places they are taken to, steps and doublets on top, series, gusts.
#pragma once

#include <initializer_list>
#include <vector>

#include "cli/flight_script.hpp"

namespace tiltrotor::cli {

// Inputs as in input_series.hpp: places in kControlVariables, then the throttles.
class ScriptInputs {
 public:
  explicit ScriptInputs(const FlightScript& script) : script_(script) {}

  void take(int input, double place);
  void shift(int input, double way);  // of a place that was taken
  void release(std::initializer_list<int> inputs);
  void add(const ScriptEvent& signal);   // step or doublet
  void play(const ScriptEvent& series);  // from its time on
  void blow(const ScriptEvent& gust);
  // u[control_count + 2] at a time, which never goes back. Steps and doublets end at the stops.
  void apply(double time, double* u);
  // Whether a stop held a control back, the last time.
  bool is_stopped(int control) const { return is_stopped_[control]; }

 private:
  static constexpr int kInputs = control_count + 2;
  struct Taken {
    bool is_taken;
    double place;
    const ScriptEvent* series;  // or nullptr
    std::size_t column;
  };
  const FlightScript& script_;
  Taken taken_[kInputs] = {};
  void move(double time, double* u);
  std::vector<ScriptEvent> signals_, gusts_;
  bool is_stopped_[control_count] = {};
};

}  // namespace tiltrotor::cli

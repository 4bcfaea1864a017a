#include "cli/script_inputs.hpp"

#include <algorithm>
#include <cmath>

#include "tiltrotor/math/scalar.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/model/variables/control_range.hpp"

namespace tiltrotor::cli {

namespace {

constexpr double kRounding = 1e-9;  // of the times of steps, s, and of places

// Signals that are over are forgotten.
void forget(std::vector<ScriptEvent>& events, double time, std::size_t duration) {
  events.erase(
      std::remove_if(events.begin(), events.end(),
                     [&](const ScriptEvent& e) { return time > e.time + e.number[duration] - kRounding; }),
      events.end());
}

}  // namespace

void ScriptInputs::take(int input, double place) { taken_[input] = {true, place, nullptr, 0}; }

void ScriptInputs::shift(int input, double way) {
  if (taken_[input].is_taken && taken_[input].series == nullptr) taken_[input].place += way;
}

void ScriptInputs::release(std::initializer_list<int> inputs) {
  for (const int input : inputs) taken_[input] = {};
}

void ScriptInputs::add(const ScriptEvent& signal) { signals_.push_back(signal); }

void ScriptInputs::play(const ScriptEvent& series) {
  const std::vector<int>& input = script_.series[series.series].input;
  for (std::size_t column = 0; column < input.size(); ++column)
    taken_[input[column]] = {true, 0, &series, column};
}

void ScriptInputs::blow(const ScriptEvent& gust) { gusts_.push_back(gust); }

// From where the controls stand, a stick that stands beyond its stop no further out.
void ScriptInputs::move(double time, double* u) {
  forget(signals_, time, 1);
  double way[control_count] = {};
  for (const ScriptEvent& e : signals_) {
    const bool back = e.command == ScriptCommand::doublet && time - e.time > 0.5 * e.number[1] - kRounding;
    way[e.control] += back ? -e.number[0] : e.number[0];
  }
  for (int control = 0; control < control_count; ++control) {
    is_stopped_[control] = false;
    if (way[control] == 0) continue;
    const Bounds<double> range = control_range(aircraft_data<double>(), control);
    const double wanted = u[control] + way[control];
    u[control] = std::clamp(wanted, std::min(range.low, u[control]), std::max(range.high, u[control]));
    is_stopped_[control] = std::fabs(wanted - u[control]) > kRounding;
  }
}

void ScriptInputs::apply(double time, double* u) {
  for (int input = 0; input < kInputs; ++input) {
    const Taken& taken = taken_[input];
    if (!taken.is_taken) continue;
    u[input] = taken.series == nullptr
                   ? taken.place
                   : value_at(script_.series[taken.series->series], taken.column, time - taken.series->time);
  }
  move(time, u);
  constexpr std::size_t duration = 3;
  forget(gusts_, time, duration);
  const int gust[3] = {kControlIndex.gust.x, kControlIndex.gust.y, kControlIndex.gust.z};
  for (const ScriptEvent& e : gusts_) {
    const double part = 0.5 * (1 - std::cos(2 * kPi<double> * (time - e.time) / e.number[duration]));
    for (int axis = 0; axis < 3; ++axis) u[gust[axis]] += part * e.number[axis];
  }
}

}  // namespace tiltrotor::cli

#include "cli/flight_range.hpp"

#include <algorithm>
#include <cmath>

#include "cli/errors.hpp"
#include "cli/output.hpp"
#include "text/number.hpp"
#include "tiltrotor/math/differentiation/preaccumulate.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/model/variables/control_range.hpp"

namespace tiltrotor::cli {

namespace {

constexpr int digits = 6;
constexpr double rounding = 1e-9;  // of a trim and its inputs

// A range and a value in the unit of the command line.
struct Shown {
  explicit Shown(int control)
      : angle(kControlVariables[control].unit() == std::string("rad")), control_(control) {}
  const char* unit() const {
    return angle                             ? "deg"
           : control_ <= kControlIndex.pedal ? "in from neutral"
                                             : kControlVariables[control_].unit();
  }
  // All digits of a value that six would round into its range.
  std::string text(double value, const Bounds<double>& range) const {
    if (std::abs(value) < rounding) value = 0;
    const bool outside = value < range.low || value > range.high;
    double rounded = 0;
    read_number(number_text(shown(value), digits), rounded);
    const bool reads_inside = rounded >= shown(range.low) && rounded <= shown(range.high);
    return number_text(shown(value), outside && reads_inside ? kShortest : digits) + " " + unit();
  }
  Range range(const Bounds<double>& bounds) const { return {shown(bounds.low), shown(bounds.high), unit()}; }
  double shown(double value) const { return angle ? given_as(value, kRadPerDeg<double>) : value; }
  bool angle;

 private:
  int control_;
};

}  // namespace

std::vector<std::string> controls_beyond_stops(const Controls<double>& u) {
  double value[control_count];
  flatten(u, value);
  std::vector<std::string> names;
  for (int control = 0; control < control_count; ++control) {
    const Range range = Shown(control).range(control_range(aircraft_data<double>(), control));
    double printed = 0;
    read_number(number_text(Shown(control).shown(value[control]), Output::to_read), printed);
    if (printed < range.low || printed > range.high) names.emplace_back(kControlVariables[control].name);
  }
  return names;
}

std::string words_of(const std::vector<std::string>& limits) {
  std::string words;
  for (const std::string& limit : limits) words += (words.empty() ? "" : " ") + limit;
  return words;
}

double largest_amplitude(int control) {
  const Bounds<double> range = control_range(aircraft_data<double>(), control);
  return range.high - range.low;
}

void require_inputs(const Simulation<double>& simulation, const std::string& where) {
  double trimmed[control_count];
  flatten(simulation.controls, trimmed);
  for (int i = 0; i < simulation.inputs; ++i) {
    const InputSignal<double>& signal = simulation.input[i];
    const int control = signal.control;
    const Bounds<double> range = control_range(aircraft_data<double>(), control);
    // Inputs change at these times only.
    for (const double edge :
         {signal.start, signal.start + signal.duration, signal.start + 2 * signal.duration}) {
      double value = trimmed[control];
      for (int k = 0; k < simulation.inputs; ++k)
        if (simulation.input[k].control == control) value += value_at(simulation.input[k], edge);
      const double low = std::min(range.low, trimmed[control]);
      const double high = std::max(range.high, trimmed[control]);
      if (value >= low - rounding && value <= high + rounding) continue;
      const Shown shown(control);
      throw UsageError(where + ": " + kControlVariables[control].name + " would be " +
                       shown.text(value, range) + " at " + number_text(edge, digits) + " s (" +
                       shown.text(trimmed[control], range) + " in trim), outside " +
                       range_text(shown.range(range)));
    }
  }
}

std::string fault_text(const Simulation<double>& simulation) {
  const int state = simulation.fault_state;
  if (state < 0) return "";
  double x[state_count];
  flatten(simulation.state, x);
  const Variable& variable = kStateVariables[state];
  const double bound = state_bound<double>(state);
  return std::string(", state ") + variable.name + ", " + number_text(x[state], digits) + " " +
         variable.unit() + " in the last good step, range " + range_text({-bound, bound, variable.unit()});
}

}  // namespace tiltrotor::cli

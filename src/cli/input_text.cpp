#include "cli/input_text.hpp"

#include <algorithm>
#include <vector>

#include "cli/arguments.hpp"
#include "cli/errors.hpp"
#include "cli/flight_range.hpp"
#include "text/nearest.hpp"
#include "tiltrotor/model/aircraft/aircraft.hpp"

namespace tiltrotor::cli {

const char* const kInputGrammar =
    "An input is NAME=AMPLITUDE[UNIT]@START[..END][:SHAPE], added to the trimmed control; times in seconds.\n"
    "  NAME   collective, long_stick, lat_stick, pedal, long_cyclic, diff_collective, diff_long_cyclic, "
    "elevator,\n"
    "         aileron, rudder, lateral_cyclic, gust_u, gust_v or gust_w\n"
    "  UNIT   deg (the default) or rad for angles, in for the stick and pedal, mps for gusts\n"
    "  SHAPE  step (the default without END), pulse (the default with END) or doublet (half the time each "
    "way)\n"
    "Masts move by mast=CHANGE[deg]@START..END at a constant rate, within their range; rows hold the angle.\n"
    "Examples: collective=1deg@0  pedal=0.5in@1..2  long_stick=1in@1..3:doublet  mast=30deg@1..5\n";

namespace {

constexpr Range time_range{0, 3600, "s"};

struct Unit {
  const char* name;
  double size;
};

std::vector<Unit> units_of(int control) {
  const std::string unit = kControlVariables[control].unit();
  if (unit == "rad") return {{"deg", kRadPerDeg<double>}, {"rad", 1}};
  if (unit == "in") return {{"in", 1}};
  return {{"mps", 1}};
}

int find_control(const std::string& name, const std::string& where) {
  std::vector<std::string> names;
  for (int i = 0; i < control_count; ++i) {
    if (name == kControlVariables[i].name) return i;
    names.emplace_back(kControlVariables[i].name);
  }
  std::vector<std::string> near = names;
  near.emplace_back("mast");
  throw UsageError(where + ": no control " + quoted(name) + did_you_mean(name, near) + "; choose " +
                   one_of(names));
}

double parse_amplitude(const std::string& text, int control, const std::string& where) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  std::size_t end = text.size();
  while (end > 0 && is_letter(text[end - 1])) --end;
  if (end == 0) end = text.size();  // a word that is no number at all
  const std::string unit_name = text.substr(end);
  const std::vector<Unit> units = units_of(control);
  const auto unit =
      std::find_if(units.begin(), units.end(), [&](const Unit& u) { return unit_name == u.name; });
  if (!unit_name.empty() && unit == units.end()) {
    std::vector<std::string> names;
    for (const Unit& u : units) names.emplace_back(u.name);
    throw UsageError(where + ": unit " + quoted(unit_name) + did_you_mean(unit_name, names) + " of " +
                     kControlVariables[control].name + " is not " + one_of(names));
  }
  const Unit& in = unit_name.empty() ? units.front() : *unit;
  const double most = largest_amplitude(control) / in.size;
  return parse_number(text.substr(0, end), where, {-most, most, in.name}) * in.size;
}

// Text before and after the first separator; `found` tells whether there was one.
struct Halves {
  std::string before, after;
  bool found;
};
Halves cut(const std::string& text, const std::string& separator) {
  const std::size_t place = text.find(separator);
  if (place == std::string::npos) return {text, "", false};
  return {text.substr(0, place), text.substr(place + separator.size()), true};
}

}  // namespace

InputSignal<double> parse_input(const std::string& text, const std::string& where_option) {
  const std::string where = where_option + " " + text;
  const Halves name = cut(text, "=");
  const Halves amplitude = cut(name.after, "@");
  if (!name.found || !amplitude.found) {
    throw UsageError(where +
                     ": not NAME=AMPLITUDE[UNIT]@START[..END][:SHAPE], for example collective=1deg@0");
  }
  const Halves shape = cut(amplitude.after, ":");
  const Halves times = cut(shape.before, "..");

  InputSignal<double> signal{};
  signal.control = find_control(name.before, where);
  signal.amplitude = parse_amplitude(amplitude.before, signal.control, where);
  signal.start = parse_number(times.before, where, time_range);
  const std::vector<std::string> shapes = {"step", "pulse", "doublet"};
  const std::string word = shape.found ? shape.after : shapes[times.found ? 1 : 0];
  const auto place = std::find(shapes.begin(), shapes.end(), word);
  if (place == shapes.end())
    throw UsageError(where + ": shape " + quoted(word) + did_you_mean(word, shapes) + " is not " +
                     one_of(shapes));
  signal.shape = static_cast<InputShape>(place - shapes.begin());
  if (signal.shape == InputShape::step) {
    if (times.found)
      throw UsageError(where + ": a step has no end; write " + times.before + " or choose pulse");
    return signal;
  }
  if (!times.found) throw UsageError(where + ": a " + word + " needs START..END");
  const double end = parse_number(times.after, where, time_range);
  if (end <= signal.start) throw UsageError(where + ": the end is not after the start");
  signal.duration = (end - signal.start) / (signal.shape == InputShape::doublet ? 2 : 1);
  return signal;
}

}  // namespace tiltrotor::cli

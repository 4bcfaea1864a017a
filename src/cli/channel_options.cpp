#include "cli/channel_options.hpp"

#include <algorithm>
#include <cmath>

#include "text/nearest.hpp"

namespace tiltrotor::cli {

namespace {

constexpr int per_decade = 20;
constexpr Range frequency_range{1e-4, 1e4, "rad/s"};

// Places of the names that were given, among `count` whose names are `name(k)`.
template <class Name>
std::vector<int> places(const Arguments& arguments, const char* option, const char* otherwise, int count,
                        Name&& name) {
  std::vector<std::string> known;
  for (int k = 0; k < count; ++k) known.emplace_back(name(k));
  std::vector<int> out;
  for (const std::string& word : split(arguments.text(option, otherwise), ',')) {
    const auto found = std::find(known.begin(), known.end(), word);
    if (found == known.end())
      throw UsageError(arguments.where(option) + ": " + quoted(word) + " is not in this model" +
                       did_you_mean(word, known) + "; choose among " + one_of(known));
    out.push_back(static_cast<int>(found - known.begin()));
  }
  return out;
}

}  // namespace

std::string ChannelChoice::name() const {
  return std::string(vehicle_variable(output).name) + " to " + vehicle_input(input).name;
}

std::string ChannelChoice::unit() const {
  const std::string above = vehicle_variable(output).unit(), below = vehicle_input(input).unit();
  return "(" + above + ")/(" + below + ")";
}

OptionList channel_options() {
  return {{"--from", "NAMES", "inputs by name, as `conventions` lists them (long_stick)"},
          {"--to", "NAMES", "outputs: states by name (theta)"}};
}

std::vector<ChannelChoice> channel_choices(const Arguments& arguments, const VehicleShape& shape) {
  const std::vector<int> inputs = places(arguments, "--from", "long_stick", shape.inputs,
                                         [&](int j) { return vehicle_input(shape.input[j]).name; });
  const std::vector<int> outputs = places(arguments, "--to", "theta", shape.states,
                                          [&](int i) { return vehicle_variable(shape.state[i]).name; });
  std::vector<ChannelChoice> out;
  for (const int j : inputs)
    for (const int i : outputs) out.push_back({shape.state[i], shape.input[j]});
  return out;
}

Option frequency_option() {
  return {"--frequency", "RAD/S",
          "a value, a list, a range, or LOW..HIGH in 20 equal ratios a decade\n"
          "(0.1..100)"};
}

std::vector<double> frequencies(const Arguments& arguments) {
  const std::string text = arguments.text("--frequency", "0.1..100");
  const std::string where = arguments.where("--frequency");
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos) return parse_sweep(text, where, frequency_range);
  const double low = parse_number(text.substr(0, dots), where, frequency_range);
  const double high = parse_number(text.substr(dots + 2), where, frequency_range);
  if (!(low < high))
    throw UsageError(where + ": " + quoted(text) + ": the lower frequency stands first, LOW..HIGH");
  const int steps = static_cast<int>(std::ceil(per_decade * std::log10(high / low) - 1e-9));
  std::vector<double> out;
  for (int k = 0; k <= steps; ++k) out.push_back(low * std::pow(high / low, static_cast<double>(k) / steps));
  out.back() = high;
  return out;
}

}  // namespace tiltrotor::cli

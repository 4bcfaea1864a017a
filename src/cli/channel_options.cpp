#include "cli/channel_options.hpp"

#include <algorithm>
#include <cmath>

#include "text/nearest.hpp"

namespace tiltrotor::cli {

namespace {

constexpr int per_decade = 20;
constexpr Range frequency_range{1e-4, 1e4, "rad/s"};

std::vector<std::string> words(const Arguments& arguments, const char* option, const char* otherwise) {
  return split(arguments.text(option, otherwise), ',');
}

// The place of a name, -1 where it is not among them.
int place(const std::vector<std::string>& known, const std::string& word) {
  const auto found = std::find(known.begin(), known.end(), word);
  return found == known.end() ? -1 : static_cast<int>(found - known.begin());
}

[[noreturn]] void refuse(const std::string& where, const std::string& word,
                         const std::vector<std::string>& known, const std::string& more) {
  throw UsageError(where + ": " + quoted(word) + " is not in this model" + did_you_mean(word, known) +
                   "; choose among " + one_of(known) + more);
}

std::vector<int> chosen_inputs(const Arguments& arguments, const VehicleShape& shape) {
  std::vector<std::string> known;
  for (int j = 0; j < shape.inputs; ++j) known.emplace_back(vehicle_input(shape.input[j]).name);
  std::vector<int> out;
  for (const std::string& word : words(arguments, "--from", "long_stick")) {
    const int j = place(known, word);
    if (j < 0) refuse(arguments.where("--from"), word, known, "");
    out.push_back(shape.input[j]);
  }
  return out;
}

// States before outputs of the same name. Inputs are left to the caller.
std::vector<ChannelChoice> outputs_of_channels(const Arguments& arguments, const VehicleShape& shape) {
  std::vector<std::string> known;
  for (int i = 0; i < shape.states; ++i) known.emplace_back(vehicle_variable(shape.state[i]).name);
  known.emplace_back(vehicle_variable(kStateIndex.yaw).name);
  const std::string where = arguments.where("--to");
  std::vector<ChannelChoice> out;
  for (const std::string& word : words(arguments, "--to", "theta")) {
    const int i = place(known, word);
    if (i >= 0) {
      out.push_back({i < shape.states ? shape.state[i] : kStateIndex.yaw, 0});
      continue;
    }
    const std::optional<NamedOutput> named = output_named(word, where);
    if (!named) {
      for (const std::string& name : short_output_names()) known.push_back(name);
      refuse(where, word, known, std::string("; or ") + kOtherOutputs);
    }
    out.push_back({-1, 0, named});
  }
  return out;
}

}  // namespace

std::string ChannelChoice::output_name() const { return named ? named->name : vehicle_variable(output).name; }

std::string ChannelChoice::name() const { return output_name() + " to " + vehicle_input(input).name; }

std::string ChannelChoice::unit() const {
  const std::string above = named ? named->unit : vehicle_variable(output).unit();
  return "(" + above + ")/(" + vehicle_input(input).unit() + ")";
}

OptionList channel_options() {
  return {{"--from", "NAMES", "inputs by name, as `conventions` lists them (long_stick)"},
          {"--to", "NAMES",
           "outputs: states by name, psi, and what --outputs of linearize\n"
           "takes: airspeed, nz@SL/BL/WL, htail_moment_y, .. (theta)"}};
}

std::vector<ChannelChoice> channel_choices(const Arguments& arguments, const VehicleShape& shape) {
  std::vector<ChannelChoice> out;
  const std::vector<ChannelChoice> outputs = outputs_of_channels(arguments, shape);
  for (const int input : chosen_inputs(arguments, shape))
    for (ChannelChoice which : outputs) {
      which.input = input;
      out.push_back(which);
    }
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

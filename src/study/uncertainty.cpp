#include "study/uncertainty.hpp"

#include <algorithm>
#include <cmath>

#include "study/collective_step.hpp"
#include "study/doubtful_inputs.hpp"
#include "study/linear_models.hpp"
#include "study/missing.hpp"
#include "study/trim_pictures.hpp"
#include "study/wording.hpp"

namespace tiltrotor::study {

namespace {

constexpr double kSpeedStep = 2.5;      // m/s
constexpr double kHighest = 140;        // m/s
constexpr double kResponseStep = 0.01;  // s

constexpr const char* kModes[] = {"phugoid", "short_period", "dutch_roll", "roll", "spiral"};
constexpr int kModeQuantities = 3;
constexpr const char* kModeQuantity[kModeQuantities] = {"damping_ratio", "frequency_rad_s", "real"};
using ModeNumbers = std::array<double, kModeQuantities>;

ModeNumbers numbers_of(const Mode<double>& m) { return {m.damping_ratio, m.frequency, m.real}; }

// Changes are those of the real-time grid, whose trims differ from those of the curves by less than the band.
Setup on_fast_grid(Setup setup) {
  setup.options.grid = BladeGrid::realtime;
  return setup;
}

// Both ends of an input's range: `evaluate(by, is_high)` for each end that differs from the value used.
template <class Evaluate>
void at_ends(const DoubtfulInput& input, Evaluate&& evaluate) {
  if (input.below > 0) evaluate(-input.below, false);
  if (input.above > 0) evaluate(input.above, true);
}

double& end_of(EndChange& change, bool is_high) { return is_high ? change.at_high : change.at_low; }

// A level flight, its numbers, and their changes by input.
struct Node {
  double speed;
  Trimmed trim;
  Modes modes;
  std::vector<std::array<EndChange, kTrimQuantities>> trim_change;               // [input]
  std::vector<std::vector<std::array<EndChange, kModeQuantities>>> mode_change;  // [mode of `modes`][input]
};

// Exact for parameters of the configuration.
void add_exact_changes(const Configured& c, Node& node) {
  ParameterSet set{0, {}};
  std::vector<std::size_t> place;
  const std::vector<DoubtfulInput>& inputs = doubtful_inputs();
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (parameter_of(inputs[i]) == ConfigurationParameter::count) continue;
    set.parameter[set.count++] = parameter_of(inputs[i]);
    place.push_back(i);
  }
  const std::vector<TrimNumbers> slopes = trim_sensitivity(c, node.trim, set);
  for (std::size_t k = 0; k < place.size(); ++k) {
    const DoubtfulInput& input = inputs[place[k]];
    at_ends(input, [&](double by, bool is_high) {
      for (std::size_t q = 0; q < kTrimQuantities; ++q)
        end_of(node.trim_change[place[k]][q], is_high) = slopes[k][q] * parameter_amount(input, c, by);
    });
  }
}

// By another trim, for the rest.
void add_trimmed_change(const Trimmed& moved, bool is_high, std::size_t input, Node& node) {
  const TrimNumbers before = trim_numbers(node.trim);
  const TrimNumbers after = trim_numbers(moved);
  for (std::size_t q = 0; q < kTrimQuantities; ++q)
    end_of(node.trim_change[input][q], is_high) = is_trimmed(moved.status) ? after[q] - before[q] : kMissing;
}

// A mode that no longer continues one of before has no change.
void add_mode_change(const Configured& c, const Trimmed& moved, bool is_high, std::size_t input, Node& node) {
  Modes after;
  const bool found = is_trimmed(moved.status);
  if (found) {
    after = modes_of(c, moved);
    if (follow(node.modes, after) != Status::ok) throw std::runtime_error("uncertainty: modes do not match");
  }
  for (int k = 0; k < node.modes.count; ++k) {
    const Mode<double>& before = node.modes.mode[k];
    const Mode<double>* end = after.mode + (found ? after.count : 0);
    const Mode<double>* same =
        found ? std::find_if(after.mode, after.mode + after.count,
                             [&](const Mode<double>& m) { return m.branch == before.branch; })
              : end;
    for (std::size_t q = 0; q < kModeQuantities; ++q)
      end_of(node.mode_change[static_cast<std::size_t>(k)][input][q], is_high) =
          same == end ? kMissing : numbers_of(*same)[q] - numbers_of(before)[q];
  }
}

std::vector<Node> nodes_of(const Setup& setup, const std::vector<double>& speeds, bool with_modes) {
  const Configured c = configured(setup);
  const std::vector<DoubtfulInput>& inputs = doubtful_inputs();
  std::vector<Node> nodes;
  for (const double speed : speeds) {
    Node node{speed, trimmed_persistently(c, speed), {}, {}, {}};
    if (!is_trimmed(node.trim.status)) continue;
    node.trim_change.resize(inputs.size());
    if (with_modes) {
      node.modes = modes_of(c, node.trim);
      node.mode_change.resize(static_cast<std::size_t>(node.modes.count));
      for (auto& of_mode : node.mode_change) of_mode.resize(inputs.size());
    }
    add_exact_changes(c, node);
    nodes.push_back(std::move(node));
  }
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const bool is_exact = parameter_of(inputs[i]) != ConfigurationParameter::count;
    if (is_exact && !with_modes) continue;
    at_ends(inputs[i], [&](double by, bool is_high) {
      const MovedAircraft aircraft(setup, inputs[i], by);
      const Configured& moved = aircraft.configuration();
      for (Node& node : nodes) {
        const Trimmed trim = trimmed_near(moved, node.speed, node.trim);
        if (!is_exact) add_trimmed_change(trim, is_high, i, node);
        if (with_modes) add_mode_change(moved, trim, is_high, i, node);
      }
    });
  }
  return nodes;
}

// The changes of one quantity, in the order of the inputs.
template <std::size_t Quantities>
std::vector<EndChange> column(const std::vector<std::array<EndChange, Quantities>>& changes,
                              std::size_t quantity) {
  std::vector<EndChange> out;
  for (const auto& of_input : changes) out.push_back(of_input[quantity]);
  return out;
}

void add_point(const std::string& point, const std::string& quantity, double value,
               const std::vector<EndChange>& changes, Uncertainty& out) {
  const Spread spread = root_sum_square(changes);
  out.points.add({point, quantity, value, spread.below, spread.above});
  for (std::size_t i = 0; i < changes.size(); ++i)
    out.parts.add({point, quantity, doubtful_inputs()[i].name, changes[i].at_low, changes[i].at_high,
                   share(changes[i], spread)});
}

// Where the shares of the inputs are told.
bool is_point(double mast_deg, double speed) {
  return (mast_deg == 0 && (speed == 0 || speed == 15 || speed == 40)) || (mast_deg == 60 && speed == 70) ||
         (mast_deg == 90 && speed == 100);
}

void add_flights(double mast_deg, Uncertainty& out) {
  const Setup setup = on_fast_grid(trim_setup(ComparedAircraft::standard, mast_deg));
  std::vector<double> speeds;
  for (const LevelFlight& f : speed_sweep(setup, kSpeedStep, kHighest).flights) speeds.push_back(f.speed_mps);
  for (const Node& node : nodes_of(setup, speeds, true)) {
    const std::string point = "mast " + fixed(mast_deg, 0) + ", " + fixed(node.speed, 0) + " m/s";
    const TrimNumbers value = trim_numbers(node.trim);
    for (std::size_t q = 0; q < kTrimQuantities; ++q) {
      const std::vector<EndChange> changes = column(node.trim_change, q);
      const Spread spread = root_sum_square(changes);
      out.trim.add(
          {mast_deg, node.speed, std::string(kTrimQuantity[q]), value[q], spread.below, spread.above});
      if (is_point(mast_deg, node.speed)) add_point(point, kTrimQuantity[q], value[q], changes, out);
    }
    for (int k = 0; k < node.modes.count; ++k) {
      const Mode<double>& mode = node.modes.mode[k];
      const std::string name = mode.name;
      if (std::find(std::begin(kModes), std::end(kModes), name) == std::end(kModes)) continue;
      for (std::size_t q = 0; q < kModeQuantities; ++q) {
        const std::vector<EndChange> changes = column(node.mode_change[static_cast<std::size_t>(k)], q);
        const Spread spread = root_sum_square(changes);
        out.modes.add({mast_deg, node.speed, name, std::string(kModeQuantity[q]), numbers_of(mode)[q],
                       spread.below, spread.above});
        // Of a pair damping ratio and frequency, of a real root the root say it all.
        const bool tells = (mode.imag > 0) == (kModeQuantity[q] != std::string("real"));
        if (tells && is_point(mast_deg, node.speed))
          add_point(point, name + " " + kModeQuantity[q], numbers_of(mode)[q], changes, out);
      }
    }
  }
}

void add_response(Uncertainty& out) {
  const Setup setup = on_fast_grid(default_setup(0));
  const Configured c = configured(setup);
  const Trimmed trim = trimmed_persistently(c, kStepSpeed);
  const std::vector<Motion> base = motion_after_step(c, trim, kResponseStep);
  const std::vector<DoubtfulInput>& inputs = doubtful_inputs();
  std::vector<std::vector<std::array<EndChange, kMotionQuantities>>> change(base.size());  // [time][input]
  for (auto& at_time : change) at_time.resize(inputs.size());
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    at_ends(inputs[i], [&](double by, bool is_high) {
      const MovedAircraft aircraft(setup, inputs[i], by);
      const Trimmed moved = trimmed_near(aircraft.configuration(), kStepSpeed, trim);
      if (!is_trimmed(moved.status)) throw std::runtime_error("uncertainty: no trim with " + inputs[i].name);
      const std::vector<Motion> motion = motion_after_step(aircraft.configuration(), moved, kResponseStep);
      for (std::size_t k = 0; k < base.size(); ++k)
        for (std::size_t q = 0; q < kMotionQuantities; ++q)
          end_of(change[k][i][q], is_high) = motion[k][q] - base[k][q];
    });
  }
  for (std::size_t k = 0; k < base.size(); ++k) {
    for (std::size_t q = 0; q < kMotionQuantities; ++q) {
      const std::vector<EndChange> changes = column(change[k], q);
      const Spread spread = root_sum_square(changes);
      out.response.add({static_cast<double>(k) * kStepRecordEvery, std::string(kMotionQuantity[q]),
                        base[k][q], spread.below, spread.above});
      if (k + 1 == base.size())
        add_point("3 s after +1 deg collective", kMotionQuantity[q], base[k][q], changes, out);
    }
  }
}

}  // namespace

std::vector<std::array<EndChange, kTrimQuantities>> trim_changes(const Setup& setup, double speed_mps) {
  const std::vector<Node> nodes = nodes_of(setup, {speed_mps}, false);
  if (nodes.empty()) throw std::runtime_error("uncertainty: no trim at " + fixed(speed_mps, 0) + " m/s");
  return nodes[0].trim_change;
}

Uncertainty uncertainty() {
  Uncertainty out;
  for (const double mast : kTrimMasts) add_flights(mast, out);
  add_response(out);
  return out;
}

}  // namespace tiltrotor::study

#include "cli/mode_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "text/nearest.hpp"
#include "tiltrotor/analysis/linear/mode_shape.hpp"

namespace tiltrotor::cli {

namespace {

std::vector<std::string> rigid_names() {
  std::vector<std::string> names;
  for (const int state : kRigidOrder) names.emplace_back(kStateVariables[state].name);
  return names;
}

// A rotor's state without its side, as mean or difference of both.
std::string coordinate_name(int state, Symmetry symmetry) {
  const std::string name = vehicle_variable(state).name;
  if (symmetry == Symmetry::none) return name;
  return name.substr(0, name.size() - 2) + (symmetry == Symmetry::mean ? " mean" : " difference");
}

// Coordinate i of the eigensystem by `at`.
template <int N>
NamedShape shape_of(const Eigensystem<double, N>& system, int k, int normalising,
                    const std::function<SplitCoordinate(int)>& at) {
  const auto counts = [&](int i) { return at(i).state < state_count && is_rigid(at(i).state); };
  const int n = system.values.size;
  int reference = largest_state(system, k, counts);
  Phasor<double> phasor[N];
  mode_shape(system, k, reference, phasor);
  constexpr double still = 1e-11;  // of the largest: rounding
  for (int i = 0; i < n; ++i)
    if (at(i).state == normalising && phasor[i].magnitude > still) reference = i;
  mode_shape(system, k, reference, phasor);
  NamedShape out;
  out.real = system.values.real[k];
  out.imag = system.values.imag[k];
  out.reference = coordinate_name(at(reference).state, at(reference).symmetry);
  for (int i = 0; i < n; ++i) {
    const SplitCoordinate c = at(i);
    const bool moves = !(phasor[i].magnitude < still);
    out.entry.push_back({coordinate_name(c.state, c.symmetry), vehicle_variable(c.state).unit(), counts(i),
                         moves ? phasor[i].magnitude : 0,
                         moves ? phasor[i].angle / kRadPerDeg<double> : std::nan(""),
                         phasor[i].participation});
  }
  return out;
}

// At the tip of an arrow, on the inner side, clear of those that are there.
plot::Label tip_label(double x, double y, const std::string& words, const std::string& color,
                      const plot::Plot& p) {
  constexpr double letter = 6.5, row = 13, near = 0.25;
  plot::Label label{x, y, words, color};
  if (x > 0) label.dx = -letter * static_cast<double>(words.size());
  for (const plot::Label& other : p.labels)
    if (std::abs(other.x - x) < 1 && std::abs(other.y - y) < near)
      label.dy = std::max(label.dy, other.dy + row);
  return label;
}

}  // namespace

OptionList normalise_option() {
  return {{"--normalise", "STATE",
           "of --show shapes: a rigid-body state by name that is 1 at angle 0, or\n"
           "largest: of the rigid body in the units of the model, also in modes in\n"
           "which that state stands still (largest)"}};
}

int normalising_state(const Arguments& arguments) {
  const std::string name = arguments.text("--normalise", "largest");
  if (name == "largest") return -1;
  std::vector<std::string> names = rigid_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return kRigidOrder[found - names.begin()];
  names.insert(names.begin(), "largest");
  throw UsageError(arguments.where("--normalise") + ": " + quoted(name) + did_you_mean(name, names) +
                   " is none of " + one_of(names));
}

std::vector<NamedShape> shapes_of(const ModeSet<double>& set, int normalising) {
  std::vector<NamedShape> out;
  for (int m = 0; m < set.count; ++m) {
    const Mode<double>& mode = set.mode[m];
    out.push_back(
        shape_of(set.system, mode.eigenvalue, normalising, [&](int i) { return set.coordinate[i]; }));
    out.back().mode = mode.name;
    out.back().axis = axis_word(mode.axis);
  }
  return out;
}

std::vector<NamedShape> shapes_of(const VehicleModes<double>& modes,
                                  const Eigensystem<double, kMaxVehicleStates>& system,
                                  const VehicleShape& shape, int normalising) {
  const auto has = [&](int state) {
    return std::find(shape.state, shape.state + shape.states, state) != shape.state + shape.states;
  };
  // As split_rotors() leaves them.
  const auto at = [&](int i) {
    const int state = shape.state[i];
    const bool paired =
        state < state_count && kStateVariables[state].side != kNoSide && has(kStateVariables.partner[state]);
    if (!paired) return SplitCoordinate{state, Symmetry::none};
    return SplitCoordinate{state,
                           kStateVariables[state].side == right ? Symmetry::mean : Symmetry::difference};
  };
  std::vector<NamedShape> out;
  for (int m = 0; m < modes.count; ++m) {
    const VehicleMode<double>& mode = modes.mode[m];
    out.push_back(shape_of(system, mode.eigenvalue, normalising, at));
    out.back().mode = mode.name;
    out.back().axis = mode.is_system ? "system" : axis_word(mode.axis);
  }
  return out;
}

plot::Plot phasor_diagram(const NamedShape& shape, const std::string& where, std::size_t number) {
  plot::Plot p;
  p.id = "phasors_" + std::to_string(number);
  p.title = shape.mode + ", " + where;
  p.x.label = "Real part";
  p.y.label = "Imaginary part";
  p.x.low = p.y.low = -1.25;
  p.x.high = p.y.high = 1.25;
  p.equal_scale = true;
  p.note =
      "Speeds, rates and angles each to a scale of their own, the longest 1; the numbers are those of the table, over " +
      shape.reference + ".";
  constexpr double least_shown = 1e-3;
  for (const char* const unit : {"m/s", "rad/s", "rad"}) {
    double longest = 0;
    for (const ShapeEntry& e : shape.entry)
      if (e.is_rigid && e.unit == unit && std::isfinite(e.magnitude))
        longest = std::max(longest, e.magnitude);
    for (const ShapeEntry& e : shape.entry) {
      if (!e.is_rigid || e.unit != unit || !(e.magnitude > least_shown * longest)) continue;
      const double size = e.magnitude / longest, angle = e.angle_deg * kRadPerDeg<double>;
      const double x = size * std::cos(angle), y = size * std::sin(angle);
      plot::Series arrow;
      arrow.color = plot::kLineColor[p.labels.size() % plot::kLineColors];
      arrow.x = {0, x};
      arrow.y = {0, y};
      p.series.push_back(arrow);
      plot::Series tip = arrow;
      tip.line = plot::Line::none;
      tip.marker = plot::Marker::circle;
      tip.x = {x};
      tip.y = {y};
      p.series.push_back(tip);
      p.labels.push_back(tip_label(x, y, e.state + " " + text::number_text(e.magnitude, 3), arrow.color, p));
    }
  }
  return p;
}

}  // namespace tiltrotor::cli

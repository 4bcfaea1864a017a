#include "cli/qlpv_grid.hpp"

#include <algorithm>
#include <functional>

#include "cli/errors.hpp"
#include "cli/governed.hpp"
#include "cli/targeted_trim.hpp"

namespace tiltrotor::cli {

namespace {

constexpr const char* kOptions[] = {"--altitude", "--mast", "--speed"};

// Number of a place, counted along the axes with the last one fastest.
std::size_t digit(std::size_t& number, std::size_t count) {
  const std::size_t found = number % count;
  number /= count;
  return found;
}

VehicleShape shape_of(const LinearModel<double>& model) {
  VehicleShape shape{};
  shape.states = model.states;
  shape.inputs = model.controls;
  for (int i = 0; i < model.states; ++i) shape.state[i] = model.state[i];
  for (int j = 0; j < model.controls; ++j) shape.input[j] = model.control[j];
  return shape;
}

}  // namespace

QlpvGrid::QlpvGrid(const Arguments& arguments)
    : command_(arguments.command()),
      setup_(SetupOptions::every_combination(arguments).front()),
      flight_(flight_cases(arguments).front()),
      reduced_(wants_rigid(arguments)),
      order_(reduction_order(arguments)),
      controls_(control_set(arguments)),
      scas_(wants_scas(arguments)) {
  const Range ranges[] = {kAltitudeRange, kMastRange, kSpeedRange};
  for (int k = 0; k < kSchedulingVariables; ++k) {
    axis_[k] = arguments.sweep(kOptions[k], "0", ranges[k]);
    if (std::adjacent_find(axis_[k].begin(), axis_[k].end(), std::greater_equal<double>()) != axis_[k].end())
      throw UsageError(arguments.where(kOptions[k]) + ": the values of a grid must increase");
  }
  const bool one_flight = flight_cases(arguments).size() == axis_[kByMast].size() * axis_[kBySpeed].size();
  if (!one_flight || SetupOptions::every_combination(arguments).size() != axis_[kByAltitude].size())
    throw UsageError(
        command_ +
        ": the scheduling variables are --altitude, --mast and --speed; everything else takes one value");
  require_no_positions(setup_.switches(), arguments);
  require_few(command_, {axis_[0].size(), axis_[1].size(), axis_[2].size()});
}

std::size_t QlpvGrid::points() const { return axis_[0].size() * axis_[1].size() * axis_[2].size(); }

void QlpvGrid::place_point(std::size_t number, SchedulingPoint& at) const {
  for (int k = kSchedulingVariables; k-- > 0;) at[k] = axis_[k][digit(number, axis_[k].size())];
}

std::size_t QlpvGrid::cells() const {
  std::size_t count = 1;
  bool any = false;
  for (const std::vector<double>& axis : axis_) {
    any = any || axis.size() > 1;
    count *= std::max<std::size_t>(axis.size(), 2) - 1;
  }
  return any ? count : 0;
}

void QlpvGrid::place_cell(std::size_t number, SchedulingPoint& centre,
                          std::vector<std::size_t>& corners) const {
  corners.assign(1, 0);
  std::size_t stride = 1;
  for (int k = kSchedulingVariables; k-- > 0;) {
    const std::size_t size = axis_[k].size();
    const std::size_t first = digit(number, std::max<std::size_t>(size, 2) - 1);
    const std::size_t last = size > 1 ? first + 1 : first;
    centre[k] = 0.5 * (axis_[k][first] + axis_[k][last]);
    const std::vector<std::size_t> before = corners;
    for (std::size_t& corner : corners) corner += first * stride;
    if (last > first)
      for (const std::size_t corner : before) corners.push_back(corner + last * stride);
    stride *= size;
  }
}

std::string QlpvGrid::where(const SchedulingPoint& at) const {
  return flight_text(command_, at[kByMast], at[kBySpeed]) + ", " + number_text(at[kByAltitude], 6) + " m";
}

QlpvPoint QlpvGrid::find(const SchedulingPoint& at, Analyses& work) const {
  QlpvPoint point{std::make_unique<TrimmedFlight>(), std::make_unique<VehicleMatrices>(), {}, false, "", ""};
  TrimmedFlight& f = *point.flight;
  f.where = where(at);
  f.mast_deg = at[kByMast];
  f.flight = flight_.flight;
  f.flight.speed = at[kBySpeed];
  f.climb_deg = flight_.climb_deg;
  f.sideslip_deg = flight_.sideslip_deg;
  f.turn_rate_degps = flight_.turn_rate_degps;
  f.azimuth_deg = flight_.azimuth_deg;
  f.targets = flight_.targets;
  f.setup = &setup_;
  f.configuration = setup_.configuration(at[kByMast]);
  ConfigurationSetting<double> setting = f.configuration.setup;
  setting.altitude = at[kByAltitude];
  if (reconfigure(setting, f.configuration) != Status::ok) throw UsageError(f.where + ": out of range");
  const std::string unreached = trim_to_targets(f.targets, work, f);
  point.status = trim_status_word(f.trim.status);
  point.valid = is_trimmed(f.trim.status);
  if (f.trim.status != TrimStatus::ok)
    point.explanation = unreached.empty() ? trim_explanation(f.trim) : unreached;
  if (!point.valid) return point;
  const Status status = find_model(point, work);
  if (status == Status::ok) return point;
  point.valid = false;
  point.status = status_word(status);
  point.explanation = status_text(status);
  return point;
}

Status QlpvGrid::find_airframe_model(QlpvPoint& point, Analyses& work) const {
  const TrimmedFlight& f = *point.flight;
  const State<double>& x = f.trim.state;
  const Controls<double>& u = f.trim.controls;
  const auto model = std::make_unique<LinearModel<double>>();
  const auto outputs = std::make_unique<OutputMatrices>();
  Status status = linearize(f.configuration, x, u, controls_, work, *model);
  if (status == Status::ok) status = linearize_outputs(f.configuration, x, u, controls_, work, *outputs);
  if (status == Status::ok && reduced_) status = reduce_to_rigid(*model, order_, outputs.get());
  if (status != Status::ok) return status;
  point.shown = ShownModel(*model);
  point.shown.add_outputs(*outputs);
  VehicleMatrices& m = *point.model;
  m.shape = shape_of(*model);
  for (int i = 0; i < m.shape.states; ++i) {
    for (int j = 0; j < m.shape.states; ++j) m.a(i, j) = model->a(i, j);
    for (int j = 0; j < m.shape.inputs; ++j) m.b(i, j) = model->b(i, j);
  }
  return status;
}

Status QlpvGrid::find_model(QlpvPoint& point, Analyses& work) const {
  const TrimmedFlight& f = *point.flight;
  const Options& options = f.configuration.setup.options;
  if (options.governor == Governor::off && !scas_) return find_airframe_model(point, work);
  const State<double>& x = f.trim.state;
  Controls<double> u = f.trim.controls;
  const SystemFlight<double> flight = governed(f.configuration, x, u, scas_);
  const auto outputs = std::make_unique<VehicleOutputs>();
  Status status = linearize_flight(f.configuration, flight, x, u, controls_, governed_commands(options), work,
                                   *point.model);
  if (status == Status::ok)
    status = linearize_vehicle_outputs(flight, f.configuration, x, u, point.model->shape, *outputs);
  if (status == Status::ok && reduced_) status = reduce_to_rigid(*point.model, order_, outputs.get());
  if (status != Status::ok) return status;
  point.shown = ShownModel(*point.model, x, flight.state, u, flight.vehicle.commands);
  point.shown.add_outputs(*outputs);
  return status;
}

ShownModel QlpvGrid::names() const {
  const auto matrices = std::make_unique<VehicleMatrices>();
  matrices->shape = governed_shape(setup_.switches(), controls_, scas_);
  if (reduced_) keep_slow_states(matrices->shape);
  ShownModel shown(*matrices, {}, {}, {}, {});
  shown.outputs = OutputMatrices::outputs;
  return shown;
}

}  // namespace tiltrotor::cli

#include "cli/qlpv_grid.hpp"

#include <algorithm>
#include <functional>

#include "cli/errors.hpp"
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

}  // namespace

QlpvGrid::QlpvGrid(const Arguments& arguments)
    : command_(arguments.command()),
      setup_(SetupOptions::every_combination(arguments).front()),
      flight_(flight_cases(arguments).front()),
      model_(std::make_unique<ChosenModel>(arguments, setup_.switches())) {
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
  QlpvPoint point{std::make_unique<TrimmedFlight>(), nullptr, {}, {}, false, "", ""};
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
  const State<double>& x = f.trim.state;
  const Controls<double>& u = f.trim.controls;
  const Status status = model_->find(f.configuration, x, u, true, work, point.shown);
  if (status == Status::ok) {
    point.model = std::make_unique<VehicleMatrices>(model_->matrices());
    point.gains = model_->gains(f.configuration, x, u);
    return point;
  }
  point.valid = false;
  point.status = status_word(status);
  point.explanation = status_text(status);
  return point;
}

LinearSettings QlpvGrid::settings(const QlpvPoint& point) const {
  LinearSettings settings(point.flight->configuration);
  settings.add(*point.flight);
  model_->tell(settings);
  settings.feedback = point.gains;
  return settings;
}

}  // namespace tiltrotor::cli

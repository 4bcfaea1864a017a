#include "cli/targeted_trim.hpp"

#include <algorithm>
#include <cmath>

#include "cli/axis_search.hpp"
#include "cli/named_outputs.hpp"
#include "cli/output_names.hpp"
#include "cli/state_columns.hpp"
#include "cli/trim_columns.hpp"
#include "cli/trim_readings.hpp"

namespace tiltrotor::cli {

namespace {

constexpr double radian = kRadPerDeg<double>;
constexpr double tolerance = 1e-10;     // of a target, over its size or 1
constexpr double jump = 1e-6;           // the same: what is left where the quantity is not continuous
constexpr int most_trims = 3000;        // in all, of one flight
constexpr int most_wide_searches = 20;  // of those inside, after their window
constexpr double window = 8;  // steps to each side, of a search inside another that has been done before

double quantity(const std::string& name, const TrimmedFlight& flight) {
  if (name == "ny") return side_force(flight.trim.state);
  const std::vector<std::string> own = trim_quantities();
  if (std::find(own.begin(), own.end(), name) != own.end()) return trim_quantity(name)(flight);
  return reading_of(flight, *output_named(name, name));
}

void set(const std::string& freed, double value, TrimmedFlight& f) {
  ConfigurationSetting<double> setting = f.configuration.setup;
  if (freed == "speed_mps") f.flight.speed = value;
  if (freed == "climb_deg") f.flight.climb = (f.climb_deg = value) * radian;
  if (freed == "sideslip_deg") f.flight.sideslip = (f.sideslip_deg = value) * radian;
  if (freed == "turn_rate_degps") f.flight.turn_rate = (f.turn_rate_degps = value) * radian;
  if (freed == "rotor_rpm") setting.rotor_speed = value * kRpm;
  if (freed == "altitude_m") setting.altitude = value;
  if (freed == "mass_kg") setting.mass = value;
  if (freed == "cg_sl_in") setting.sl_cg = value * kInch;
  if (freed == "flap_deg") setting.flap_deg = value;
  if (is_setting(freed)) (void)reconfigure(setting, f.configuration);  // inside its range
}

double start_of(const TrimTarget& target, const TrimmedFlight& f) {
  const double speed = f.flight.speed * std::cos(f.flight.climb);
  const auto turn = [&](double bank) {
    const double rate = speed > 1 ? std::tan(bank) * kGravity<double> / speed / radian : 0;
    return std::clamp(rate, -30.0, 30.0);
  };
  if (target.option == "--bank") return turn(target.value * radian);
  if (target.option == "--load-factor") return turn(std::acos(1 / std::max(target.value, 1.0)));
  if (target.freed == "speed_mps") return f.flight.speed;
  if (target.freed == "climb_deg") return f.climb_deg;
  if (target.freed == "sideslip_deg") return f.sideslip_deg;
  if (target.freed == "turn_rate_degps") return f.turn_rate_degps;
  return f.setting(target.freed);
}

class Search {
 public:
  Search(const TrimTargets& targets, Analyses& work, TrimmedFlight& flight)
      : targets_(targets), work_(work), flight_(flight) {
    begin();
  }

  // Once more where nothing was found, with those inside looked for everywhere when they left their window.
  std::string run() {
    const TrimmedFlight given = flight_;
    if (reach(0)) return "";
    if (targets_.size() < 2 || trims_ >= most_trims) return fault_;
    const TrimmedFlight nearest = flight_;
    const std::string fault = fault_;
    flight_ = given;
    wide_searches_ = most_wide_searches;
    begin();
    if (reach(0)) return "";
    flight_ = nearest;
    return fault;
  }

 private:
  struct Level {
    double start, first;
    bool has_run;
  };

  void begin() {
    levels_.clear();
    for (const TrimTarget& target : targets_) levels_.push_back({start_of(target, flight_), 0, false});
  }

  // --load-factor by a turn to the right, whatever is to the left.
  Range range_of(std::size_t level) const {
    const FreedQuantity& freed = freed_quantity(targets_[level].freed);
    Range range = freed.range;
    if (targets_[level].option == "--load-factor") range.low = 0;
    const Level& here = levels_[level];
    if (level == 0 || !here.has_run) return range;
    return {std::max(range.low, here.start - window * freed.step),
            std::min(range.high, here.start + window * freed.step), range.unit};
  }

  // Whether the targets from `level` on are reached; the flight is then the one that reaches them.
  bool reach(std::size_t level) {
    if (level == targets_.size()) return is_found();
    Level& here = levels_[level];
    const TrimTarget& target = targets_[level];
    const FreedQuantity& freed = freed_quantity(target.freed);
    const double size = std::max(std::fabs(target.value), 1.0);
    const Range range = range_of(level);
    const double start = here.start = std::clamp(here.start, range.low, range.high);
    const bool outermost = level == 0;
    TrimmedFlight kept{};
    // Of those inside the nearest alone, so that it moves steadily with what is outside.
    AxisSearch search(
        {range.low, range.high, freed.step, start, here.first, tolerance * size, jump * size, outermost,
         !outermost},
        [&](double at) -> SearchPoint {
          return {at, miss_at(level, at), flight_.trim.status == TrimStatus::ok};
        },
        [&] { kept = flight_; });
    if (search.run()) {
      flight_ = kept;
      here = {search.best().at, freed.step / closer, true};  // the next search begins near
      return true;
    }
    // It may have moved farther than the window since.
    if (!outermost && here.has_run && wide_searches_ > 0) {
      --wide_searches_;
      here = {start, 0, false};
      return reach(level);
    }
    if (!std::isfinite(search.best().miss)) {
      if (outermost) tell_nothing_found(target, start);
      return false;
    }
    set(target.freed, search.best().at, flight_);
    flight_.trim.status = TrimStatus::not_converged;
    fault_ = unreached(target, search.best(), range);
    return false;
  }

  // The fault is that of the flight as it was given, unless no trim is left to say it.
  void tell_nothing_found(const TrimTarget& target, double start) {
    if (trims_ < most_trims) return (void)miss_at(0, start);
    set(target.freed, start, flight_);
    flight_.trim.status = TrimStatus::not_converged;
    fault_ = target.held + " " + number_text(target.value, 6) + " is not reached: nothing was found by " +
             std::to_string(most_trims) + " trims, where the search ends";
  }

  bool is_found() {
    if (++trims_ > most_trims) {
      flight_.trim.status = TrimStatus::not_converged;
      return false;
    }
    trim_flight(flight_, work_);
    if (!is_trimmed(flight_.trim.status)) fault_ = trim_explanation(flight_.trim);
    return is_trimmed(flight_.trim.status);
  }

  double miss_at(std::size_t level, double at) {
    set(targets_[level].freed, at, flight_);
    if (!reach(level + 1)) return std::nan("");
    return quantity(targets_[level].held, flight_) - targets_[level].value;
  }

  std::string unreached(const TrimTarget& target, const SearchPoint& nearest, const Range& range) const {
    constexpr int digits = 6;
    return target.held + " " + number_text(target.value, digits) + " is not reached: nearest " +
           number_text(target.value + nearest.miss, digits) + " at " + target.freed + " " +
           number_text(nearest.at, digits) + ", searched in " + range_text(range) + " by " +
           std::to_string(std::min(trims_, most_trims)) + " trims" +
           (trims_ > most_trims ? ", where the search ends" : "");
  }

  static constexpr double closer = 8;
  const TrimTargets& targets_;
  Analyses& work_;
  TrimmedFlight& flight_;
  std::vector<Level> levels_;
  std::string fault_;
  int trims_ = 0, wide_searches_ = 0;
};

}  // namespace

std::vector<std::string> held_quantities() {
  std::vector<std::string> names = trim_quantities();
  names.emplace_back("ny");
  for (const OutputName& output : kOutputNames)
    if (std::find(names.begin(), names.end(), output.name) == names.end()) names.emplace_back(output.name);
  return names;
}

std::string trim_to_targets(const TrimTargets& targets, Analyses& work, TrimmedFlight& flight) {
  return Search(targets, work, flight).run();
}

}  // namespace tiltrotor::cli

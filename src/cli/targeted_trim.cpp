#include "cli/targeted_trim.hpp"

#include <algorithm>
#include <cmath>

#include "cli/state_columns.hpp"
#include "cli/trim_columns.hpp"

namespace tiltrotor::cli {

namespace {

constexpr double radian = kRadPerDeg<double>;
constexpr int most_steps = 40;       // away from the start, each way
constexpr int most_shortenings = 8;  // of a step to where there is no trim
constexpr int most_worse = 4;        // steps that lead away from the target
constexpr int most_falsi = 60;
constexpr double step_growth = 1.5;
constexpr double tolerance = 1e-10;  // of a target, over its size or 1
constexpr double jump = 1e-6;        // the same: what is left where the quantity is not continuous

double quantity(const std::string& name, const TrimmedFlight& flight) {
  return name == "ny" ? side_force(flight.trim.state) : trim_quantity(name)(flight);
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
    for (const TrimTarget& target : targets)
      levels_.push_back({start_of(target, flight), freed_quantity(target.freed).step});
  }

  std::string run() {
    if (reach(0)) return "";
    return fault_;
  }

 private:
  struct Level {
    double start, step;
  };
  struct Point {
    double at, miss;
  };

  // Whether the targets from `level` on are reached; the flight is then the one that reaches them.
  bool reach(std::size_t level) {
    if (level == targets_.size()) {
      trim_flight(flight_, work_);
      if (!is_trimmed(flight_.trim.status)) fault_ = trim_explanation(flight_.trim);
      return is_trimmed(flight_.trim.status);
    }
    Level& here = levels_[level];
    const TrimTarget& target = targets_[level];
    const double size = std::max(std::fabs(target.value), 1.0);
    Point start{here.start, 0}, beyond{};
    if (!miss_at(level, start)) return false;
    Point nearest = start;
    bool found = std::fabs(start.miss) <= tolerance * size;
    if (!found && bracket(level, start, beyond, nearest)) found = close(level, start, beyond, nearest, size);
    if (!found) {
      set(target.freed, nearest.at, flight_);
      flight_.trim.status = TrimStatus::not_converged;
      fault_ = unreached(target, nearest);
      return false;
    }
    here.start = nearest.at;  // the next search begins near
    here.step = freed_quantity(target.freed).step / 4;
    return true;
  }

  bool miss_at(std::size_t level, Point& point) {
    set(targets_[level].freed, point.at, flight_);
    if (!reach(level + 1)) return false;
    point.miss = quantity(targets_[level].held, flight_) - targets_[level].value;
    return std::isfinite(point.miss);
  }

  // Two neighbouring points with the target between them: first in the direction in which it comes nearer.
  bool bracket(std::size_t level, Point& low, Point& high, Point& nearest) {
    const Point start = low;
    const double step = levels_[level].step;
    const Range range = freed_quantity(targets_[level].freed).range;
    Point ahead{std::min(start.at + step, range.high), 0};
    const bool up = ahead.at > start.at && miss_at(level, ahead) &&
                    ((ahead.miss > 0) != (start.miss > 0) || std::fabs(ahead.miss) < std::fabs(start.miss));
    for (const double direction : {up ? 1.0 : -1.0, up ? -1.0 : 1.0}) {
      double size = step;
      int shortened = 0, worse = 0;
      low = start;
      for (int k = 0; k < most_steps && worse < most_worse && shortened < most_shortenings; ++k) {
        high.at = std::clamp(low.at + direction * size, range.low, range.high);
        if (high.at == low.at) break;
        if (!miss_at(level, high)) {
          size /= 2;
          ++shortened;
          continue;
        }
        if (std::fabs(high.miss) < std::fabs(nearest.miss)) nearest = high;
        if ((high.miss > 0) != (low.miss > 0)) return true;
        worse = std::fabs(high.miss) > std::fabs(low.miss) ? worse + 1 : 0;
        low = high;
        if (shortened == 0) size *= step_growth;
      }
    }
    return false;
  }

  // Regula falsi between the two; the last point tried is the one that is taken.
  bool close(std::size_t level, Point a, Point b, Point& nearest, double size) {
    double weight_a = 1;
    for (int k = 0; k < most_falsi; ++k) {
      const double miss_a = weight_a * a.miss;
      Point next{(a.at * b.miss - b.at * miss_a) / (b.miss - miss_a), 0};
      if (!miss_at(level, next)) return false;
      nearest = next;
      const bool stands = next.at == b.at || next.at == a.at;
      if (std::fabs(next.miss) <= tolerance * size || stands) break;
      if ((next.miss > 0) == (b.miss > 0)) {
        weight_a *= 0.5;
      } else {
        a = b;
        weight_a = 1;
      }
      b = next;
    }
    return std::fabs(nearest.miss) <= jump * size;
  }

  std::string unreached(const TrimTarget& target, const Point& nearest) const {
    constexpr int digits = 6;
    const FreedQuantity& freed = freed_quantity(target.freed);
    return target.held + " " + number_text(target.value, digits) + " is not reached: nearest " +
           number_text(target.value + nearest.miss, digits) + " at " + target.freed + " " +
           number_text(nearest.at, digits) + ", searched in " + range_text(freed.range);
  }

  const TrimTargets& targets_;
  Analyses& work_;
  TrimmedFlight& flight_;
  std::vector<Level> levels_;
  std::string fault_;
};

}  // namespace

std::vector<std::string> held_quantities() {
  std::vector<std::string> names = trim_quantities();
  names.emplace_back("ny");
  return names;
}

std::string trim_to_targets(const TrimTargets& targets, Analyses& work, TrimmedFlight& flight) {
  return Search(targets, work, flight).run();
}

}  // namespace tiltrotor::cli

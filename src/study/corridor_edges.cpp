#include "study/corridor_edges.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "study/missing.hpp"
#include "study/reference_points.hpp"

namespace tiltrotor::study {

namespace {

constexpr double kResolution = 0.2;  // m/s
constexpr double kHighest = 150;     // m/s, of the tables

struct Edge {
  double speed_mps;  // NaN: none before the end of the range
  Trimmed beyond;    // the trim just outside
};

const char* limit_word(const Trimmed& t) { return limit_name(t.limits.exceeded[0].limit).name; }

// From a speed at which `flies` holds towards one at which it may not: in coarse steps to the first failure,
// then by halving.
Edge edge_towards(const Configured& c, double from, double end,
                  const std::function<bool(const Trimmed&)>& flies) {
  const double coarse = end > from ? 4 : -4;
  double good = from;
  Trimmed failed{};
  double bad = kMissing;
  Trimmed last = trimmed_persistently(c, from);
  while (good != end) {
    const double next = std::fabs(end - good) > std::fabs(coarse) ? good + coarse : end;
    Trimmed t = trimmed(c, next);
    if (!is_trimmed(t.status)) t = trimmed_near(c, next, last);
    if (!flies(t)) {
      bad = next;
      failed = t;
      break;
    }
    good = next;
    last = t;
  }
  if (!std::isfinite(bad)) return {kMissing, failed};
  while (std::fabs(bad - good) > kResolution) {
    const double middle = 0.5 * (good + bad);
    const Trimmed t = trimmed_near(c, middle, last);
    if (flies(t)) {
      good = middle;
      last = t;
    } else {
      bad = middle;
      failed = t;
    }
  }
  return {good, failed};
}

Edge stall_side(const Configured& c, double from) {
  return edge_towards(c, from, 0, [](const Trimmed& t) {
    return is_trimmed(t.status) && t.status != TrimStatus::wing_stall;
  });
}

Edge stop_side(const Configured& c, double from) {
  return edge_towards(c, from, 0, [](const Trimmed& t) { return t.status == TrimStatus::ok; });
}

Edge power_side(const Configured& c, double from) {
  const double engines = shaft_power(c, c.aircraft->controls.engine_power_continuous);
  const double limit = kWatt * std::min(transmission_power(c), engines);
  return edge_towards(c, from, kHighest, [limit](const Trimmed& t) {
    return t.status == TrimStatus::ok && total_power_kw(t) <= limit;
  });
}

// Power or torque at the take-off rating: NaN where something else ends the flight before.
double takeoff_side(const Configured& c, double from) {
  const Edge edge =
      edge_towards(c, from, kHighest, [](const Trimmed& t) { return t.status == TrimStatus::ok; });
  const TrimStatus reason = edge.beyond.status;
  const bool rated = reason == TrimStatus::power_limit || reason == TrimStatus::torque_limit;
  return rated ? edge.speed_mps : kMissing;
}

}  // namespace

Table corridor_edges(double mast_step_deg) {
  Table table({"mast_deg", "stall_mps", "stop_mps", "stop_name", "power_mps", "power_reason", "takeoff_mps"});
  for (double mast = 0; mast <= 90; mast += mast_step_deg) {
    const Configured c = configured(mast);
    const double middle = middle_speed(mast);
    const Edge stall = stall_side(c, middle);
    const Edge stop = stop_side(c, middle);
    const Edge power = power_side(c, middle);
    const bool is_stop = stop.beyond.status == TrimStatus::control_limit;
    const bool is_power = power.beyond.status == TrimStatus::ok;
    const bool is_torque = c.setup.rotor_speed < c.aircraft->rotor.speed_helicopter;
    table.add({mast, stall.speed_mps, is_stop ? stop.speed_mps : kMissing,
               std::string(is_stop ? limit_word(stop.beyond) : ""), power.speed_mps,
               std::string(!is_power   ? trim_status_word(power.beyond.status)
                           : is_torque ? "torque"
                                       : "power"),
               takeoff_side(c, middle)});
  }
  return table;
}

Table compared_minimum_speeds() {
  Table table({"mast_deg", "mass_lb", "here_mps", "reason", "design_mps", "difference_mps"});
  table.comment("Design: NASA TM X-62407 (1975), fig. 5.4.1; both with flap 40/25 and 565 rpm at sea level.");
  const Table rows = reference_points("conversion_corridor").where("boundary", std::string("design_minimum"));
  constexpr double attitude_limited = 30;  // deg; below, the design's limit is an attitude, not stall
  constexpr double pound = 0.45359237;     // kg
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    const double mast = rows.number(i, "mast_deg");
    if (mast < attitude_limited) continue;
    Setup setup = default_setup(mast);
    setup.flap_deg = 40;
    setup.rotor_speed = 565 * kPi<double> / 30;
    setup.mass = pound * rows.number(i, "mass_lb");
    const Configured c = configured(setup);
    const Edge edge = stall_side(c, middle_speed(mast));
    const double design = rows.number(i, "speed_mps");
    table.add({mast, rows.number(i, "mass_lb"), edge.speed_mps,
               std::string(trim_status_word(edge.beyond.status)), design, edge.speed_mps - design});
  }
  return table;
}

Table compared_corridor_in_use() {
  Table table({"mast_deg", "published_mps", "quantity", "here_mps"});
  table.comment(
      "Published: NASA TM-81244 (1980), fig. 14. Here: wing stall, and the power of the transmission.");
  const Table all = reference_points("conversion_corridor");
  for (const std::string kind : {"stall", "minimum", "maximum"}) {
    const Table rows = all.where("boundary", "corridor_" + kind);
    for (std::size_t i = 0; i < rows.rows(); ++i) {
      const double mast = rows.number(i, "mast_deg");
      const double speed = rows.number(i, "speed_mps");
      const bool is_corner = mast < 0 || speed == 0;  // masts tilted back; where a line meets hover
      if (is_corner) continue;
      const Configured c = configured(mast);
      const double from = middle_speed(mast);
      const Edge edge = kind == "maximum" ? power_side(c, from) : stall_side(c, from);
      table.add({mast, speed, kind + "_mps", edge.speed_mps});
    }
  }
  return table;
}

}  // namespace tiltrotor::study

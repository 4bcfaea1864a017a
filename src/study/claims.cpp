#include "study/claims.hpp"

#include <algorithm>
#include <cmath>

namespace tiltrotor::study {

namespace {

constexpr double kLowSpeed = 30;     // m/s: the paper's "hover and low speed" ends here
constexpr double kSteadyStick = 21;  // m/s, 40 kt: from here on GTRS supports a rising stick
constexpr double kAirplaneSpeed = 75;

using Text = std::string;

double largest_rise(const std::vector<double>& values) {
  double rise = -1e9;
  for (std::size_t i = 1; i < values.size(); ++i) rise = std::max(rise, values[i] - values[i - 1]);
  return rise;
}

// Range of the stick over the speeds of the GTRS points, in.
double stick_range(const Table& trims, double mast) {
  const std::vector<double> stick = trims.where("set", Text("trim_gtrs_figures"))
                                        .where("quantity", Text("long_stick_in"))
                                        .where("mast_deg", mast)
                                        .numbers("here");
  const auto [low, high] = std::minmax_element(stick.begin(), stick.end());
  return *high - *low;
}

void trim_claims(const Table& curves, const Table& trims, Table& table) {
  const Table helicopter = curves.where("mast_deg", 0.0);
  const std::vector<double> speed = helicopter.numbers("speed_mps");
  const std::vector<double> collective = helicopter.numbers("collective_root_deg");
  const auto lowest =
      static_cast<std::size_t>(std::min_element(collective.begin(), collective.end()) - collective.begin());
  const Text bucket = "collective follows a bucket";
  table.add({bucket, 0.0, Text("bucket_speed_mps"), speed[lowest], 32.5});
  table.add({bucket, 0.0, Text("bucket_depth_deg"), collective.front() - collective[lowest], 4.0});

  const Text forward = "stick forward and nose down with speed";
  table.add(
      {forward, 0.0, Text("largest_rise_of_pitch_deg"), largest_rise(helicopter.numbers("pitch_deg")), 0.0});
  std::vector<double> aft_stick;
  for (std::size_t i = 0; i < speed.size(); ++i) {
    if (speed[i] >= kSteadyStick) aft_stick.push_back(-helicopter.number(i, "long_stick_in"));
  }
  table.add({forward, 0.0, Text("least_rise_of_stick_in"), -largest_rise(aft_stick), 0.0});

  const double others = std::min({stick_range(trims, 0), stick_range(trims, 30), stick_range(trims, 60)});
  table.add({Text("least variation of controls in airplane mode"), 90.0, Text("stick_range_ratio"),
             stick_range(trims, 90) / others, 1.0});
  const Table airplane = curves.where("mast_deg", 90.0);
  table.add({Text("high collective in airplane mode"), 90.0, Text("collective_root_deg"),
             airplane.where("speed_mps", kAirplaneSpeed).number(0, "collective_root_deg"), 55.0});
}

void mode_claims(const Table& modes, Table& table) {
  const auto found = [](const Table& rows, std::initializer_list<const char*> names) {
    double count = 0;
    for (const char* name : names) count += rows.where("mode", Text(name)).rows() > 0;
    return count;
  };
  const Table hover = modes.where("mast_deg", 0.0).where("speed_mps", 0.0);
  const Table cruise = modes.where("mast_deg", 90.0).where("speed_mps", 100.0);
  table.add({Text("hover: oscillation, pitch subsidence, heave"), 0.0, Text("modes_found"),
             found(hover, {"phugoid", "pitch_subsidence", "heave"}), 3.0});
  table.add({Text("airplane: short period, phugoid"), 90.0, Text("modes_found"),
             found(cruise, {"short_period", "phugoid"}), 2.0});
  table.add({Text("airplane: Dutch roll, roll, spiral"), 90.0, Text("modes_found"),
             found(cruise, {"dutch_roll", "roll", "spiral"}), 3.0});
  for (const Text& mast : modes.different("mast_deg")) {
    const Table rows = modes.where("mast_deg", mast);
    double growth = -1e9;
    for (std::size_t i = 0; i < rows.rows(); ++i) {
      if (rows.number(i, "speed_mps") >= kLowSpeed) growth = std::max(growth, rows.number(i, "real"));
    }
    table.add({"unstable only below 30 m/s, mast " + mast, rows.number(0, "mast_deg"),
               Text("fastest_growth_1_per_s"), growth, 0.0});
  }
}

double least_stable(const Table& rows) {
  const std::vector<double> real = rows.numbers("real");
  return *std::max_element(real.begin(), real.end());
}

void response_claims(const Table& motion, const Table& motion_modes, Table& table) {
  for (const Text name : {"flap 40/25", "flap 0/0"}) {
    const Table rows = motion.where("case", name);
    const std::size_t last = rows.rows() - 1;
    const Text point = "+1 deg collective at 40 m/s, " + name + ", after 3 s";
    table.add({point, 0.0, Text("climb_mps"), rows.number(last, "climb_mps"), 0.0});
    table.add({point, 0.0, Text("speed_change_mps"),
               rows.number(last, "ground_speed_mps") - rows.number(0, "ground_speed_mps"), 0.0});
    table.add({point, 0.0, Text("pitch_change_deg"),
               rows.number(last, "pitch_deg") - rows.number(0, "pitch_deg"), 0.0});
    for (const Text axis : {"longitudinal", "lateral"}) {
      const Table roots = motion_modes.where("case", name).where("axis", axis);
      table.add({point + ", " + axis, 0.0, Text("growth_change_1_per_s"),
                 least_stable(roots.where("time_s", 3.0)) - least_stable(roots.where("time_s", 0.0)), 0.0});
    }
  }
}

}  // namespace

Table compared_claims(const Table& curves, const Table& trims, const Table& modes, const Table& motion,
                      const Table& motion_modes) {
  Table table({"point", "mast_deg", "quantity", "here", "reference"});
  trim_claims(curves, trims, table);
  mode_claims(modes, table);
  response_claims(motion, motion_modes, table);
  return table;
}

}  // namespace tiltrotor::study

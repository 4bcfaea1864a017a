// Power required in level flight at every mast angle.

#include <algorithm>
#include <cmath>

#include "plot/plot.hpp"
#include "study/drawn_with.hpp"
#include "study/missing.hpp"
#include "study/reference_points.hpp"
#include "study/sections.hpp"
#include "study/wording.hpp"

namespace tiltrotor::study {

using namespace plot;

namespace {

Table power_table(const Sweeps& sweeps) {
  Table table({"mast_deg", "speed_mps", "power_kw"});
  for (const SpeedSweep& sweep : sweeps) {
    for (const LevelFlight& f : sweep.flights)
      table.add({sweep.mast_deg, f.speed_mps, total_power_kw(f.trim)});
  }
  return table;
}

// The conditions of the prediction: flap 40/25 and 565 rpm at every mast angle.
Setup predicted_setup(double mast_deg) {
  Setup setup = default_setup(mast_deg);
  setup.flap_deg = 40;
  setup.rotor_speed = 565 * kPi<double> / 30;
  return setup;
}

Table compared_with_prediction() {
  Table table({"mast_deg", "speed_mps", "here_kw", "prediction_kw", "difference_pct"});
  table.comment("Prediction: NASA TM X-62407 (1975), fig. 5.4.2; both with flap 40/25, 565 rpm, 13000 lb.");
  const Table set = reference_points("power_required");
  for (std::size_t i = 0; i < set.rows(); ++i) {
    const double mast = set.number(i, "mast_deg");
    const double speed = set.number(i, "speed_mps");
    const Trimmed t = trimmed_persistently(configured(predicted_setup(mast)), speed);
    const double there = set.number(i, "power_kw");
    const double here = is_trimmed(t.status) ? total_power_kw(t) : kMissing;
    table.add({mast, speed, here, there, 100 * (here / there - 1)});
  }
  return table;
}

// Between the first and the last speed of the prediction, as far as the wing is short of its stall.
Table predicted_curves() {
  constexpr double step = 1;  // m/s
  Table table({"mast_deg", "speed_mps", "power_kw"});
  table.comment("This program with flap 40/25, 565 rpm, 13000 lb, over the speeds of the 1975 prediction.");
  const Table set = reference_points("power_required");
  for (const std::string& mast : set.different("mast_deg")) {
    const std::vector<double> speeds = set.where("mast_deg", mast).numbers("speed_mps");
    const auto [low, high] = std::minmax_element(speeds.begin(), speeds.end());
    const double mast_deg = set.where("mast_deg", mast).number(0, "mast_deg");
    const Configured c = configured(predicted_setup(mast_deg));
    for (double speed = std::ceil(*low); speed <= *high; speed += step) {
      const Trimmed t = trimmed_persistently(c, speed);
      const bool flies = is_trimmed(t.status) && t.status != TrimStatus::wing_stall;
      table.add({mast_deg, speed, flies ? total_power_kw(t) : kMissing});
    }
  }
  return table;
}

Picture power_picture(const Table& table) {
  Plot plot;
  plot.id = "power_required";
  plot.title = "Power required, flaps as scheduled";
  plot.note = drawn_with();
  plot.x.label = "Speed, m/s";
  plot.y.label = "Power of both rotors, kW";
  plot.x.low = 0;
  plot.y.low = 0;
  int color = 0;
  for (const std::string& mast : table.different("mast_deg")) {
    const Table rows = table.where("mast_deg", mast);
    Series s;
    s.name = "mast " + mast;
    s.color = kLineColor[color++ % kLineColors];
    s.x = rows.numbers("speed_mps");
    s.y = rows.numbers("power_kw");
    plot.series.push_back(s);
  }
  return {plot.id, svg(plot)};
}

// Curves of this program, points of the prediction.
Picture prediction_picture(const Table& curves, const Table& compared) {
  Plot plot;
  plot.id = "power_prediction";
  plot.title = "Against the 1975 prediction (flap 40/25, 565 rpm)";
  plot.note = drawn_with();
  plot.x.label = "Speed, m/s";
  plot.y.label = "Power of both rotors, kW";
  plot.x.low = 0;
  plot.y.low = 0;
  std::size_t i = 0;
  for (const std::string& mast : compared.different("mast_deg")) {
    const Table curve = curves.where("mast_deg", mast);
    const Table points = compared.where("mast_deg", mast);
    Series here;
    here.name = "mast " + mast;
    here.color = kLineColor[i++];
    here.x = curve.numbers("speed_mps");
    here.y = curve.numbers("power_kw");
    Series there = here;
    there.name.clear();
    there.line = Line::none;
    there.marker = Marker::diamond;
    there.filled = false;
    there.x = points.numbers("speed_mps");
    there.y = points.numbers("prediction_kw");
    plot.series.push_back(here);
    plot.series.push_back(there);
  }
  Series key;  // for every mast angle
  key.name = "1975 prediction";
  key.color = kGrey;
  key.line = Line::none;
  key.marker = Marker::diamond;
  key.filled = false;
  plot.series.push_back(key);
  return {plot.id, svg(plot)};
}

// The speed at which the torque of the transmission is used up.
double torque_limited_speed(double mast_deg, double rotor_rpm) {
  Setup setup = default_setup(mast_deg);
  setup.rotor_speed = rotor_rpm * kPi<double> / 30;
  const Configured c = configured(setup);
  double low = middle_speed(mast_deg);
  double high = 150;
  constexpr double resolution = 0.05;  // m/s
  while (high - low > resolution) {
    const double middle = 0.5 * (low + high);
    const Trimmed t = trimmed(c, middle);
    const bool has_torque = is_trimmed(t.status) && total_power_kw(t) < kWatt * transmission_power(c);
    (has_torque ? low : high) = middle;
  }
  return low;
}

// Speed of least power: vertex of the parabola through the lowest point and its neighbours.
double bucket_speed(const Table& power) {
  const std::vector<double> v = power.numbers("speed_mps");
  const std::vector<double> p = power.numbers("power_kw");
  const auto k = static_cast<std::size_t>(std::min_element(p.begin(), p.end()) - p.begin());
  if (k == 0 || k + 1 >= p.size()) return kMissing;
  const double step = v[k + 1] - v[k];
  return v[k] + 0.5 * step * (p[k - 1] - p[k + 1]) / (p[k - 1] - 2 * p[k] + p[k + 1]);
}

Table compared_buckets(const Table& power) {
  Table table({"mast_deg", "here_mps", "reference_mps"});
  table.comment("Speed of least power here, of least fuel flow in NASA TM-81244 (1980), fig. 13.");
  const Table set = reference_points("bucket_speed");
  for (std::size_t i = 0; i < set.rows(); ++i) {
    const double mast = set.number(i, "mast_deg");
    table.add({mast, bucket_speed(power.where("mast_deg", mast)), set.number(i, "speed_mps")});
  }
  return table;
}

// "Least power: mast 0 deg 763 kW at 29 m/s, ..."
std::string least_power(const Table& table) {
  std::string text;
  for (const std::string& mast : table.different("mast_deg")) {
    const Table rows = table.where("mast_deg", mast);
    const std::vector<double> power = rows.numbers("power_kw");
    const auto least = std::min_element(power.begin(), power.end());
    const auto place = static_cast<std::size_t>(least - power.begin());
    text += (text.empty() ? "Least power: mast " : ", mast ") + mast + " deg " + fixed(*least, 0) +
            " kW at " + fixed(rows.number(place, "speed_mps"), 0) + " m/s";
  }
  return text + ".";
}

}  // namespace

Section power_required(const Sweeps& sweeps) {
  Section section{"power", "Power required", "", {}, {}, {}};
  section.reading =
      "The curves end at stall on the left and at the power of the transmission, two times 1160 hp, on the "
      "right; rotor speed as scheduled. With the flap and rotor speed of the prediction they end where the "
      "wing stalls. ";
  const Table table = power_table(sweeps);
  section.reading += least_power(table);
  const Table compared = compared_with_prediction();
  const Table curves = predicted_curves();
  section.pictures = {power_picture(table), prediction_picture(curves, compared)};

  double worst = 0;
  double sum = 0;
  int count = 0;
  int close_points = 0;
  constexpr double tolerance = 12;
  for (const double d : compared.numbers("difference_pct")) {
    if (!std::isfinite(d)) continue;
    worst = std::fabs(d) > std::fabs(worst) ? d : worst;
    sum += std::fabs(d);
    ++count;
    close_points += std::fabs(d) <= tolerance;
  }
  const double mean = count > 0 ? sum / count : 100;
  section.findings.push_back(
      {verdict_of(close_points, static_cast<int>(compared.rows())),
       "Agreement with the 1975 prediction of power (12 %).",
       std::to_string(close_points) + " of " + std::to_string(compared.rows()) + " points within 12 %; " +
           std::to_string(count) + " of " + std::to_string(compared.rows()) +
           " points trim in those conditions; mean difference " + fixed(mean, 1) + " %, largest " +
           with_sign(worst, 1) + " %. A prediction, not a measurement."});
  const Table top = reference_points("top_speed");
  Table top_compared({"source", "mast_deg", "rotor_rpm", "here_mps", "reference_mps"});
  std::string found;
  int close = 0;
  for (std::size_t i = 0; i < top.rows(); ++i) {
    const double here = torque_limited_speed(top.number(i, "mast_deg"), top.number(i, "rotor_rpm"));
    const double there = top.number(i, "speed_mps");
    top_compared.add(
        {top.text(i, "source"), top.number(i, "mast_deg"), top.number(i, "rotor_rpm"), here, there});
    constexpr double speed_tolerance = 4.1;  // m/s, 8 kt
    close += std::fabs(here - there) <= speed_tolerance;
    found += top.text(i, "rotor_rpm") + " rpm: " + fixed(here, 1) + " m/s against " + fixed(there, 1) + " (" +
             top.text(i, "source") + "). ";
  }
  section.findings.push_back({verdict_of(close, static_cast<int>(top.rows())),
                              "Top level speed by torque (8 kt).",
                              found + "Torque limit: 1160 hp a rotor at 589 rpm."});
  section.tables.push_back({"power_required", "power at every mast angle", table});
  section.tables.push_back(
      {"power_prediction", "the curves in the conditions of the 1975 prediction", curves});
  section.tables.push_back({"power_compared", "against the 1975 prediction", compared});
  section.tables.push_back({"top_speed_compared", "torque-limited speed", top_compared});
  section.tables.push_back(
      {"bucket_compared", "speed of least power against that of least fuel flow", compared_buckets(table)});
  return section;
}

}  // namespace tiltrotor::study

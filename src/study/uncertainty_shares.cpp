// The doubtful inputs, how far each may be off and why, and what each has of the bands.

#include <algorithm>
#include <cmath>

#include "study/doubtful_inputs.hpp"
#include "study/sections.hpp"
#include "study/wording.hpp"

namespace tiltrotor::study {

namespace {

// Columns of the table of inputs.
constexpr struct {
  const char* column;
  const char* point;
  const char* quantity;
} kShown[] = {{"hover_power", "mast 0, 0 m/s", "power_kw"},
              {"pitch_15", "mast 0, 15 m/s", "pitch_deg"},
              {"pitch_40", "mast 0, 40 m/s", "pitch_deg"},
              {"stick_40", "mast 0, 40 m/s", "long_stick_in"},
              {"pitch_mast_60", "mast 60, 70 m/s", "pitch_deg"},
              {"cruise_power", "mast 90, 100 m/s", "power_kw"},
              {"cruise_stick", "mast 90, 100 m/s", "long_stick_in"},
              {"short_period", "mast 90, 100 m/s", "short_period frequency_rad_s"},
              {"dutch_roll", "mast 90, 100 m/s", "dutch_roll damping_ratio"},
              {"climb_3_s", "3 s after +1 deg collective", "climb_mps"}};

// As many decimals as show that many digits of a width.
int decimals(double width, int digits) {
  return width > 0 ? std::max(0, digits - 1 - static_cast<int>(std::floor(std::log10(width)))) : 0;
}

// To the place of the first digit of half the band.
std::string rounded_by_band(double value, double half) {
  if (!(half > 0)) return "";
  const double unit = std::pow(10.0, std::floor(std::log10(half)));
  return fixed(std::round(value / unit) * unit, decimals(half, 1));
}

// The inputs of the largest shares, "name 43 %".
std::string largest(const Table& parts) {
  constexpr std::size_t most = 3;
  constexpr double least = 0.05;
  std::vector<std::size_t> order;
  const std::vector<double> shares = parts.numbers("share");
  for (std::size_t i = 0; i < shares.size(); ++i)
    if (shares[i] >= least) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return shares[a] > shares[b]; });
  std::string text;
  for (std::size_t i = 0; i < std::min(most, order.size()); ++i)
    text += (i ? ", " : "") + parts.text(order[i], "input") + " " + fixed(100 * shares[order[i]], 0) + " %";
  return text;
}

Table point_table(const Uncertainty& bands) {
  Table table({"point", "quantity", "value", "below", "above", "rounded", "mostly"});
  table.comment(
      "rounded: the value to the digit that the band leaves; mostly: shares in the squares of the band.");
  for (std::size_t i = 0; i < bands.points.rows(); ++i) {
    const std::string& point = bands.points.text(i, "point");
    const std::string& quantity = bands.points.text(i, "quantity");
    const double value = bands.points.number(i, "value");
    const double below = bands.points.number(i, "below");
    const double above = bands.points.number(i, "above");
    const double half = 0.5 * (below + above);
    if (!std::isfinite(half)) continue;  // an input leaves no such mode
    const int shown = decimals(half, 2);
    table.add({point, quantity, fixed(value, shown), fixed(below, shown), fixed(above, shown),
               rounded_by_band(value, half),
               largest(bands.parts.where("point", point).where("quantity", quantity))});
  }
  return table;
}

Table input_table(const Uncertainty& bands) {
  std::vector<std::string> columns = {"input", "below", "above", "unit"};
  for (const auto& shown : kShown) columns.push_back(std::string(shown.column) + "_pct");
  columns.push_back("reason");
  Table table(columns);
  table.comment(
      "below, above: how far the true value may lie from the one used. Shares in the squares of a band,");
  table.comment("empty below 0.05:");
  for (const auto& shown : kShown)
    table.comment(std::string(shown.column) + ": " + shown.quantity + " at " + shown.point);
  for (const DoubtfulInput& input : doubtful_inputs()) {
    std::vector<Table::Cell> row = {input.name, input.below, input.above, input.unit};
    for (const auto& shown : kShown) {
      const Table part = bands.parts.where("point", std::string(shown.point))
                             .where("quantity", std::string(shown.quantity))
                             .where("input", input.name);
      const std::string percent = part.rows() > 0 ? fixed(100 * part.number(0, "share"), 1) : "";
      row.emplace_back(percent == "0.0" ? "" : percent);
    }
    row.emplace_back(input.reason);
    table.add(row);
  }
  return table;
}

}  // namespace

Section uncertainty_shares(const Uncertainty& bands) {
  Section section{"uncertainty", "What the doubtful inputs leave open", "", {}, {}, {}};
  section.reading =
      "Each input that no source settles is moved to either end of its range, alone, and the changes are combined as "
      "independent ones, upwards and downwards apart. The bands of trim, modes and response are made so. They hold what "
      "is known to be doubtful, not what the form of the model leaves out: a published point beside the band shows the "
      "latter.";
  section.tables.push_back({"uncertainty_points", "numbers, their bands and the digits that mean something",
                            point_table(bands), true});
  section.tables.push_back({"uncertainty_inputs",
                            "every doubtful input, its range, its shares and its reason", input_table(bands),
                            true});
  section.tables.push_back({"uncertainty_trim", "bands of trim", bands.trim});
  section.tables.push_back({"uncertainty_modes", "bands of modes", bands.modes});
  section.tables.push_back({"uncertainty_response", "bands of the response to collective", bands.response});
  section.tables.push_back({"uncertainty_parts", "changes by input", bands.parts});
  return section;
}

}  // namespace tiltrotor::study

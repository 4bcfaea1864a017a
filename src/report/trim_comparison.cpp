#include "report/trim_comparison.hpp"

#include <cmath>

#include "report/flights.hpp"
#include "report/reference_points.hpp"
#include "report/wording.hpp"

namespace tiltrotor::report {

namespace {

// What counts as agreement. A fraction is of the reference.
struct Tolerance {
  const char* set;
  const char* quantity;
  double absolute, fraction;
};
constexpr Tolerance kTolerances[] = {
    {"trim_gtrs_printed", "pitch_deg", 0.7, 0},           {"trim_gtrs_printed", "long_stick_in", 0.5, 0},
    {"trim_gtrs_printed", "thrust_n", 0, 0.025},          {"trim_gtrs_figures", "pitch_deg", 1.8, 0},
    {"trim_gtrs_figures", "long_stick_in", 0.48, 0},      {"trim_gtrs_figures", "power_kw", 0, 0.10},
    {"trim_gtrs_figures", "collective_root_deg", 1.5, 0}, {"trim_flight", "pitch_deg", 2, 0},
    {"trim_flight", "long_stick_in", 0.576, 0},           {"trim_flight", "power_kw", 0, 0.12},
};

double value_here(const Trimmed& t, const std::string& quantity) {
  if (quantity == "pitch_deg") return degrees(t.state.pitch);
  if (quantity == "long_stick_in") return stick_position(t);
  if (quantity == "thrust_n") return t.thrust[right];
  if (quantity == "power_kw") return total_power_kw(t);
  return degrees(t.collective_root);
}

double value_there(const Table& set, std::size_t row, const std::string& quantity) {
  const bool in_percent = quantity == "long_stick_in" && set.columns()[3] == "long_stick_pct";
  return in_percent ? kStickTravel / 100 * set.number(row, "long_stick_pct") : set.number(row, quantity);
}

}  // namespace

Table trim_comparison() {
  Table table(
      {"set", "mast_deg", "speed_mps", "quantity", "here", "reference", "difference", "tolerance", "within"});
  table.comment(
      "Sources of the sets: Wang et al. 2025 (figures, flight), NASA CR-166537 and Kleinhesselink 2007 "
      "(printed).");
  for (const char* name : {"trim_gtrs_printed", "trim_gtrs_figures", "trim_flight"}) {
    const Table set = reference_points(name);
    for (std::size_t i = 0; i < set.rows(); ++i) {
      const double mast = set.number(i, "mast_deg");
      const double speed = set.number(i, "speed_mps");
      const Trimmed t = trimmed_persistently(configured(mast), speed);
      for (const Tolerance& tolerance : kTolerances) {
        if (std::string(name) != tolerance.set) continue;
        const double there = value_there(set, i, tolerance.quantity);
        if (!std::isfinite(there)) continue;
        const bool has_trim = is_trimmed(t.status);
        const double here = has_trim ? value_here(t, tolerance.quantity) : double(NAN);
        const double allowed = tolerance.absolute + tolerance.fraction * std::fabs(there);
        const bool within = std::fabs(here - there) <= allowed;
        table.add({std::string(name), mast, speed, std::string(tolerance.quantity), here, there, here - there,
                   allowed,
                   std::string(within     ? "yes"
                               : has_trim ? "no"
                                          : trim_status_word(t.status))});
      }
    }
  }
  return table;
}

std::vector<Finding> trim_comparison_findings(const Table& compared) {
  const auto judge = [&](const char* set, const char* statement, const char* cause) {
    const Table rows = compared.where("set", std::string(set));
    std::size_t within = 0;
    std::string outside;
    for (std::size_t i = 0; i < rows.rows(); ++i) {
      if (rows.text(i, "within") == "yes") {
        ++within;
        continue;
      }
      outside += (outside.empty() ? "" : "; ") + rows.text(i, "quantity") + " at mast " +
                 rows.text(i, "mast_deg") + ", " + fixed(rows.number(i, "speed_mps"), 1) +
                 " m/s: " + with_sign(rows.number(i, "difference"), 2);
    }
    const bool all = within == rows.rows();
    return Finding{all ? Finding::holds : Finding::partly, statement,
                   std::to_string(within) + " of " + std::to_string(rows.rows()) +
                       " numbers within tolerance." + (all ? "" : " Outside: " + outside + ". " + cause)};
  };
  return {
      judge("trim_gtrs_printed",
            "Agreement with the printed GTRS trim at mast 0 (0.7 deg, 0.5 in, 2.5 % of force).", ""),
      judge("trim_gtrs_figures",
            "Agreement with GTRS read off a figure, four modes (1.8 deg, 5 % of travel, 10 % of power, 1.5 "
            "deg).",
            "The points at mast 30 and 90 are a first reading, known to lie low."),
      judge("trim_flight", "Agreement with flight (2 deg, 6 % of travel, 12 % of power).",
            "GTRS itself stands up to 5 deg, 5 % and 15 % from these flights, whose loading is unknown."),
  };
}

}  // namespace tiltrotor::report

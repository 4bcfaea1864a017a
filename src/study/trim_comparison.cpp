#include "study/trim_comparison.hpp"

#include <algorithm>
#include <cmath>

#include "study/compared_aircraft.hpp"
#include "study/missing.hpp"
#include "study/reference_points.hpp"
#include "study/validation_rules.hpp"
#include "study/wording.hpp"

namespace tiltrotor::study {

namespace {

constexpr const char* kSets[] = {
    "trim_gtrs_printed",          "trim_gtrs_figures",         "trim_flight",
    "trim_gtrs_second_reading",   "trim_other_kleinhesselink", "trim_other_sheng_fig7_xv15",
    "trim_other_sheng_fig7_gtrs", "trim_other_sheng_model"};
constexpr const char* kQuantities[] = {"pitch_deg", "long_stick_in", "long_cyclic_deg",    "elevator_deg",
                                       "thrust_n",  "power_kw",      "collective_root_deg"};

bool has_column(const Table& set, const std::string& name) {
  return std::find(set.columns().begin(), set.columns().end(), name) != set.columns().end();
}

double value_here(const Configured& c, const Trimmed& t, const std::string& quantity) {
  if (quantity == "pitch_deg") return degrees(t.state.pitch);
  if (quantity == "long_stick_in") return stick_position(t);
  if (quantity == "long_cyclic_deg") return degrees(t.blades.long_cyclic[right]);
  if (quantity == "elevator_deg") return degrees(t.blades.elevator);
  if (quantity == "thrust_n") return shaft_thrust(c, t);
  if (quantity == "power_kw") return total_power_kw(t);
  return degrees(t.collective_root);
}

// NaN where the set does not have it.
double value_there(const Table& set, std::size_t row, const std::string& quantity) {
  if (quantity == "long_stick_in" && has_column(set, "long_stick_pct"))
    return kStickTravel / 100 * set.number(row, "long_stick_pct");
  return has_column(set, quantity) ? set.number(row, quantity) : kMissing;
}

}  // namespace

Table trim_comparison() {
  Table table({"set", "mast_deg", "speed_mps", "quantity", "here", "reference", "difference", "tolerance",
               "within", "other"});
  table.comment(
      "Sources of the sets: tables/xv15/published, comments of the file of that name; trim_other_*: information.");
  table.comment("other: by the other of the simulated and the flown aircraft; elsewhere the same number.");
  for (const char* name : kSets) {
    const Table set = reference_points(name);
    for (std::size_t i = 0; i < set.rows(); ++i) {
      const double mast = set.number(i, "mast_deg");
      const double speed = set.number(i, "speed_mps");
      const ComparedAircraft aircraft = compared_aircraft(name);
      const Configured c = configured(setup_of(aircraft, mast));
      const Configured other_c = configured(setup_of(other_aircraft(aircraft), mast));
      const Trimmed t = trimmed_persistently(c, speed);
      const Trimmed other = trimmed_persistently(other_c, speed);
      for (const std::string quantity : kQuantities) {
        const double there = value_there(set, i, quantity);
        if (!std::isfinite(there)) continue;
        const bool has_trim = is_trimmed(t.status);
        const double here = has_trim ? value_here(c, t, quantity) : kMissing;
        const double most = allowed(tolerance_of(name, quantity, mast), there);
        const bool within = std::fabs(here - there) <= most;
        table.add({std::string(name), mast, speed, quantity, here, there, here - there, most,
                   std::string(!has_trim              ? trim_status_word(t.status)
                               : !std::isfinite(most) ? "information"
                               : within               ? "yes"
                                                      : "no"),
                   is_trimmed(other.status) ? value_here(other_c, other, quantity) : kMissing});
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
    return Finding{verdict_of(static_cast<int>(within), static_cast<int>(rows.rows())), statement,
                   std::to_string(within) + " of " + std::to_string(rows.rows()) +
                       " numbers within tolerance." + (all ? "" : " Outside: " + outside + ". " + cause)};
  };
  return {
      judge("trim_gtrs_printed",
            "Agreement with the printed GTRS trim at mast 0 (0.7 deg, 0.4 in, 2.5 % of force).", ""),
      judge("trim_gtrs_figures",
            "Agreement with GTRS read off a figure, four modes (1.8 deg, 0.7 deg at mast 0, 5 % of travel, "
            "10 % of power, 1.5 deg of collective).",
            "The points at mast 30 and 90 are a first reading, known to lie low."),
      judge("trim_flight", "Agreement with flight (2 deg, 6 % of travel, 12 % of power).",
            "GTRS itself stands up to 5 deg, 5 % and 15 % from these flights, whose loading is unknown."),
  };
}

}  // namespace tiltrotor::study

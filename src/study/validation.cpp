#include "study/validation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "study/claims.hpp"
#include "study/compared_aircraft.hpp"
#include "study/component_loads.hpp"
#include "study/flight_facts.hpp"
#include "study/linear_comparison.hpp"
#include "study/missing.hpp"
#include "study/printed_flights.hpp"
#include "study/reference_points.hpp"
#include "study/validation_rules.hpp"
#include "study/wording.hpp"

namespace tiltrotor::study {

namespace {

const Table& table_of(const std::vector<Section>& sections, const std::string& name) {
  for (const Section& s : sections) {
    for (const NumberedTable& t : s.tables) {
      if (t.name == name) return t.table;
    }
  }
  throw std::logic_error("the report has no table '" + name + "'");
}

bool has_column(const Table& table, const std::string& name) {
  return std::find(table.columns().begin(), table.columns().end(), name) != table.columns().end();
}

// How to read a table of the report as comparisons.
struct Reading {
  const char* table;
  const char* set;                 // or a column of that name
  std::vector<const char*> point;  // columns that tell one point from another
  const char* quantity;            // or a column of that name
  const char *here, *reference;    // columns
  const char* other = nullptr;     // the same
};
const std::vector<Reading>& readings() {
  static const std::vector<Reading> all = {
      {"trim_compared", "set", {"mast_deg", "speed_mps"}, "quantity", "here", "reference", "other"},
      {"modes_compared", "modes_identified", {"condition"}, "quantity", "here", "identified", "other"},
      {"control_compared", "hover_control_response", {"axis"}, "quantity", "here", "estimate"},
      {"rotor_tunnel_compared", "rotor_hover_80x120", {"test", "ct"}, "figure_of_merit", "here", "measured"},
      {"rotor_resolved_compared", "rotor_hover_resolved_blade", {"collective75_deg"}, "ct", "ct_here", "ct"},
      {"rotor_resolved_compared",
       "rotor_hover_resolved_blade",
       {"collective75_deg"},
       "figure_of_merit",
       "figure_of_merit_here",
       "figure_of_merit"},
      {"rotor_forward_flight",
       "rotor_forward_flight",
       {"shaft_angle_deg", "advance_ratio", "ct_over_sigma"},
       "cq_over_sigma",
       "cq_over_sigma",
       "measured_cq_over_sigma"},
      {"rotor_airplane_compared",
       "rotor_airplane_mode",
       {"speed_over_tip", "ct"},
       "efficiency",
       "here",
       "measured"},
      {"descent_compared",
       "rotor_descent",
       {"twist_deg", "descent_over_vh"},
       "total_inflow_over_vh",
       "here",
       "measured"},
      {"autorotation_compared", "rotor_descent_runs", {"run"}, "autorotation_descent", "here", "measured"},
      {"corridor_compared",
       "conversion_corridor",
       {"mast_deg", "mass_lb"},
       "minimum_speed_mps",
       "here_mps",
       "design_mps"},
      {"corridor_in_use_compared",
       "conversion_corridor_1980",
       {"mast_deg", "published_mps"},
       "quantity",
       "here_mps",
       "published_mps"},
      {"power_compared", "power_required", {"mast_deg", "speed_mps"}, "power_kw", "here_kw", "prediction_kw"},
      {"top_speed_compared",
       "top_speed",
       {"mast_deg", "rotor_rpm"},
       "speed_mps",
       "here_mps",
       "reference_mps"},
      {"bucket_compared", "bucket_speed", {"mast_deg"}, "speed_mps", "here_mps", "reference_mps"},
  };
  return all;
}

std::string point_text(const Table& table, std::size_t row, const std::vector<const char*>& columns) {
  std::string text;
  for (const char* column : columns) {
    text += (text.empty() ? "" : " ") + std::string(column) + "=" + table.text(row, column);
  }
  return text;
}

void read(const Table& table, const Reading& how, std::vector<Comparison>& out) {
  const bool has_mast = has_column(table, "mast_deg");
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const auto text = [&](const char* name) {
      return has_column(table, name) && std::string(name) != how.reference && std::string(name) != how.here
                 ? table.text(i, name)
                 : std::string(name);
    };
    out.push_back({text(how.set), point_text(table, i, how.point), text(how.quantity),
                   table.number(i, how.here), table.number(i, how.reference),
                   has_mast ? table.number(i, "mast_deg") : kMissing, kMissing,
                   how.other != nullptr ? table.number(i, how.other) : kMissing});
  }
}

void read_hover(const Table& table, std::vector<Comparison>& out) {
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const bool is_oarf = table.text(i, "facility") == "OARF";
    const std::string set = is_oarf ? "rotor_hover" : "rotor_hover_wadc";
    const std::string point = point_text(table, i, {"run", "point", "ct"});
    out.push_back({set, point, "cp", table.number(i, "cp_here"), table.number(i, "cp_measured")});
    out.push_back({set, point, "figure_of_merit", table.number(i, "figure_of_merit_here"),
                   table.number(i, "figure_of_merit_measured")});
  }
}

// The frequency tables are dense, for drawing; published points stand eight steps to a band.
void read_frequencies(const Table& table, const std::string& name, double mast_deg,
                      std::vector<Comparison>& out) {
  constexpr std::size_t steps = 8;
  const std::size_t stride = (table.rows() - 1) / steps;
  for (std::size_t i = 0; i < table.rows(); i += stride) {
    const std::string point = name + " omega=" + fixed(table.number(i, "omega_rad_s"), 4);
    for (const std::string column : {"gain_db", "phase_deg"}) {
      out.push_back({"transfer_functions", point, column, table.number(i, column),
                     table.number(i, "identified_" + column), mast_deg, kMissing,
                     table.number(i, "other_" + column)});
    }
  }
}

void read_other_modes(const Table& modes, std::vector<Comparison>& out) {
  const Table set = reference_points("modes_other_sheng");
  for (std::size_t i = 0; i < set.rows(); ++i) {
    const Table here = modes.where("mast_deg", set.number(i, "mast_deg"))
                           .where("speed_mps", set.number(i, "speed_mps"))
                           .where("mode", set.text(i, "mode"));
    const std::string point = point_text(set, i, {"mast_deg", "speed_mps", "mode"});
    const auto value = [&](const char* column) {
      return here.rows() > 0 ? here.number(0, column) : kMissing;
    };
    out.push_back({"modes_other_sheng", point, "real_1_per_s", value("real"), set.number(i, "real_1_per_s")});
    out.push_back(
        {"modes_other_sheng", point, "imag_rad_per_s", value("imag"), set.number(i, "imag_rad_per_s")});
  }
}

std::vector<Comparison> comparisons(const std::vector<Section>& sections) {
  std::vector<Comparison> all;
  for (const Reading& how : readings()) read(table_of(sections, how.table), how, all);
  read_hover(table_of(sections, "rotor_hover_compared"), all);
  for (const auto& [name, mast] : {std::pair("cruise_q_elevator", 90.0), std::pair("hover_az_power", 0.0)})
    read_frequencies(table_of(sections, std::string("frequency_") + name), name, mast, all);
  read_other_modes(table_of(sections, "modes"), all);
  const Table claims = compared_claims(table_of(sections, "trim_curves"), table_of(sections, "trim_compared"),
                                       table_of(sections, "modes"), table_of(sections, "response"),
                                       table_of(sections, "response_modes"));
  for (std::size_t i = 0; i < claims.rows(); ++i) {
    all.push_back({"paper_claims", claims.text(i, "point"), claims.text(i, "quantity"),
                   claims.number(i, "here"), claims.number(i, "reference"), claims.number(i, "mast_deg")});
  }
  compare_component_loads(all);
  compare_printed_trims(all);
  compare_linear_model(all);
  compare_modes(all);
  compare_lateral_frequencies(all);
  compare_flight_facts(all);
  return all;
}

struct Judged {
  Comparison what;
  double tolerance, ratio;  // NaN: information; infinite: there is no number here
  std::string status, cause;
};

// Judged numbers by ratio, the worst first, then information.
bool comes_before(const Judged& a, const Judged& b) {
  const auto rank = [](const Judged& j) { return std::isnan(j.ratio) ? -1.0 : j.ratio; };
  return rank(a) > rank(b);
}

std::vector<Judged> judge(const std::vector<Comparison>& all) {
  std::vector<Judged> judged;
  for (const Comparison& c : all) {
    const Tolerance rule = tolerance_of(c.set, c.quantity, c.mast_deg);
    const double most = allowed(rule, std::isnan(c.scale) ? c.reference : c.scale);
    const double off = shortfall(rule, c.here, c.reference);
    Judged j{c, most, kMissing, "information", rule.cause};
    if (rule.judged) {
      j.cause = cause_of(rule, c.set, c.quantity, c.mast_deg, c.here - c.reference);
      j.ratio = std::isfinite(off) ? off / most : HUGE_VAL;
      j.status = j.ratio <= 1 ? "within" : "exceeds";
    }
    judged.push_back(j);
  }
  return judged;
}

std::string ratio_text(double ratio) { return std::isfinite(ratio) ? fixed(ratio, 3) : ""; }

std::string named(const Comparison& c) { return c.set + ", " + c.point + ", " + c.quantity; }

// Marks what is on the list, and says where the list is no longer true.
std::vector<std::string> compare_with_list(std::vector<Judged>& judged, const Table& known) {
  std::vector<std::string> faults;
  for (std::size_t i = 0; i < known.rows(); ++i) {
    const auto found = std::find_if(judged.begin(), judged.end(), [&](const Judged& j) {
      return j.what.set == known.text(i, "set") && j.what.point == known.text(i, "point") &&
             j.what.quantity == known.text(i, "quantity");
    });
    if (found == judged.end()) {
      faults.push_back("known exceedance that is not compared: " + known.text(i, "set") + ", " +
                       known.text(i, "point") + ", " + known.text(i, "quantity"));
      continue;
    }
    found->cause = known.text(i, "reason");
    if (found->status == "exceeds") {
      found->status = "known";
    } else {
      found->status = "better";
      faults.push_back("within tolerance now, take it off the list of known exceedances: " +
                       named(found->what));
    }
  }
  for (const Judged& j : judged) {
    if (j.status == "exceeds") faults.push_back("exceeds its tolerance: " + named(j.what));
  }
  return faults;
}

// In the order of the comparisons; a reason once given is kept, a new one is the cause of the rules.
Table true_list(const std::vector<Judged>& judged, const Table& known) {
  Table list({"set", "point", "quantity", "reason"});
  for (const std::string& line : known.comments()) list.comment(line);
  for (const Judged& j : judged) {
    if (j.ratio > 1) list.add({j.what.set, j.what.point, j.what.quantity, j.cause});
  }
  return list;
}

Table sets_table(const std::vector<Judged>& judged) {
  Table table({"set", "kind", "numbers", "judged", "within", "known", "worst_ratio", "source"});
  table.comment("worst_ratio: largest difference over its tolerance; empty where nothing is judged.");
  const Table sets = reference_points("validation_sets");
  for (std::size_t i = 0; i < sets.rows(); ++i) {
    double count = 0;
    double in_judgement = 0;
    double within = 0;
    double known = 0;
    double worst = kMissing;
    for (const Judged& j : judged) {
      if (j.what.set != sets.text(i, "set")) continue;
      ++count;
      in_judgement += j.status != "information";
      within += j.status == "within" || j.status == "better";
      known += j.status == "known";
      if (std::isfinite(j.ratio)) worst = std::isnan(worst) ? j.ratio : std::max(worst, j.ratio);
    }
    table.add({sets.text(i, "set"), sets.text(i, "kind"), count, in_judgement, within, known,
               ratio_text(worst), sets.text(i, "source")});
  }
  return table;
}

}  // namespace

Validation validate(const std::vector<Section>& sections) {
  return validate(sections, reference_points("known_exceedances"));
}

Validation validate(const std::vector<Section>& sections, const Table& known) {
  std::vector<Judged> judged = judge(comparisons(sections));
  Validation v{Table({"set", "point", "quantity", "here", "reference", "difference", "tolerance", "ratio",
                      "status", "kind", "aircraft", "other", "source", "cause"}),
               Table({}),
               Table({}),
               {}};
  v.faults = compare_with_list(judged, known);
  v.known = true_list(judged, known);
  std::stable_sort(judged.begin(), judged.end(), comes_before);
  v.rows.comment("ratio: difference over tolerance; of a bound, only what lies beyond it. Empty: no number");
  v.rows.comment("here, or not judged. status: within, known (see known_exceedances), exceeds, better,");
  v.rows.comment(
      "information (not judged). aircraft: which one is compared, by the kind of evidence; other: the number");
  v.rows.comment("of the other of simulated and flown aircraft, where it differs.");
  const Table sets = reference_points("validation_sets");
  for (const Judged& j : judged) {
    const Comparison& c = j.what;
    const Table set = sets.where("set", c.set);
    if (set.rows() != 1) throw std::runtime_error("validation_sets.csv: no single row for " + c.set);
    v.rows.add({c.set, c.point, c.quantity, c.here, c.reference, c.here - c.reference, j.tolerance,
                ratio_text(j.ratio), j.status, set.text(0, "kind"),
                std::string(word(compared_aircraft(c.set))), c.other == c.here ? kMissing : c.other,
                set.text(0, "source"), j.cause});
  }
  v.sets = sets_table(judged);
  return v;
}

Section validation_section(const Validation& v) {
  Section section{"validation", "Validation: every number, the worst first", "", {}, {}, {}};
  section.reading =
      "Each published number, the number of this run, what would count as agreement, the kind of evidence, "
      "and what explains "
      "the rest. No constant was adjusted to any of them but those whose reason in choices.csv says calibrated or "
      "identified: the wake on the wing, a drag area of the fuselage, the jets of the engines. Numbers outside their tolerance are listed one by "
      "one with a "
      "reason; one more, or one less, fails the validation.";
  const auto count = [&](const char* status) { return v.rows.where("status", std::string(status)).rows(); };
  const std::size_t information = count("information");
  std::string found = std::to_string(count("within") + count("better")) + " within tolerance, " +
                      std::to_string(count("known")) + " known exceedances, " +
                      std::to_string(count("exceeds")) + " others; " + std::to_string(information) +
                      " more for information.";
  for (const std::string& fault : v.faults) found += " Fault: " + fault + ".";
  section.findings.push_back(
      {!v.faults.empty()    ? Finding::differs
       : count("known") > 0 ? Finding::partly
                            : Finding::holds,
       std::to_string(v.rows.rows() - information) + " numbers judged against published ones.", found});
  section.findings.push_back(
      {Finding::remark, "Not compared:",
       "stick responses without a stated flight condition; hover ceiling and fuel flow, which need an engine "
       "model; the 1975 design speeds Vc and Vd and the blade life of 1980, which are structural; roots of other "
       "models that follow from sign errors; the attitude after one second in hover, whose axis is printed "
       "ambiguously. Of the conversion and augmentation facts: time constants, damping and sensitivity with "
       "augmentation, which the bare airframe does not have; the ratio of hover pitch sensitivity, simulation "
       "over flight, since that of flight is not published; the acceleration of up to 0.4 g in a conversion, "
       "which is the pilot's choice and no trim. Of the earlier yaw response in hover the pole alone, since it "
       "is a second fit of the same record; u and w of the printed trims, which are speed and pitch again."});
  section.tables.push_back({"validation_sets", "the sets", v.sets, true});
  section.tables.push_back({"validation", "every number, the worst first", v.rows, true});
  section.tables.push_back({"known_exceedances", "what lies outside, as this run would list it", v.known});
  return section;
}

void print(const Validation& v) {
  std::printf("%7s %-11s %-26s %-52s %-28s %12s %12s %11s %11s  %-18s %s\n", "ratio", "status", "set",
              "point", "quantity", "here", "reference", "difference", "tolerance", "kind", "cause");
  for (std::size_t i = 0; i < v.rows.rows(); ++i) {
    const auto text = [&](const char* column) {
      const std::string& cell = v.rows.text(i, column);
      return cell.empty() ? "-" : cell.c_str();
    };
    std::printf("%7s %-11s %-26s %-52s %-28s %12s %12s %11s %11s  %-18s %s\n", text("ratio"), text("status"),
                text("set"), text("point"), text("quantity"), text("here"), text("reference"),
                text("difference"), text("tolerance"), text("kind"), text("cause"));
  }
  std::printf("\n%s\n", validation_section(v).findings.front().found.c_str());
}

}  // namespace tiltrotor::study

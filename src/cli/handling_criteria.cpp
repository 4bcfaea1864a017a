#include "cli/handling_criteria.hpp"

#include <cstdio>
#include <optional>

#include "cli/errors.hpp"
#include "study/reference_points.hpp"
#include "text/number.hpp"

namespace tiltrotor::cli {

namespace {

// Rows of the file; % stands for the category. `low` and `high`: of levels 1, 2, 3.
struct Form {
  const char *name, *quantity;
  bool in_hover, has_levels;
  const char *low[3], *high[3];
};
constexpr Form forms[] = {
    {"MIL-H-8501A pitch sensitivity", "sensitivity_pitch", true, false, {"MILH8501_sensitivity_pitch"}, {}},
    {"MIL-H-8501A roll sensitivity", "sensitivity_roll", true, false, {"MILH8501_sensitivity_roll"}, {}},
    {"MIL-H-8501A yaw sensitivity", "sensitivity_yaw", true, false, {"MILH8501_sensitivity_yaw"}, {}},
    {"AGARD R-577 pitch sensitivity", "sensitivity_pitch", true, false, {"AGARD577_sensitivity_pitch"}, {}},
    {"AGARD R-577 roll sensitivity", "sensitivity_roll", true, false, {"AGARD577_sensitivity_roll"}, {}},
    {"AGARD R-577 yaw sensitivity", "sensitivity_yaw", true, false, {"AGARD577_sensitivity_yaw"}, {}},
    {"MIL-H-8501A pitch after 1 s",
     "attitude_one_pitch",
     true,
     false,
     {"MILH8501_attitude_1s_1in_pitch"},
     {}},
    {"MIL-H-8501A roll after 0.5 s",
     "attitude_half_roll",
     true,
     false,
     {"MILH8501_attitude_1s_1in_roll"},
     {}},
    {"MIL-H-8501A yaw after 1 s", "attitude_one_yaw", true, false, {"MILH8501_attitude_1s_1in_yaw"}, {}},
    {"MIL-F-83300 pitch after 1 s",
     "attitude_one_pitch",
     true,
     false,
     {"MILF83300_attitude_1s_1in_pitch"},
     {}},
    {"MIL-F-83300 roll after 1 s", "attitude_one_roll", true, true, {"MILF83300_3232_roll_Level1"}, {}},
    {"MIL-F-83300 yaw after 1 s", "attitude_one_yaw", true, false, {"MILF83300_attitude_1s_1in_yaw"}, {}},
    {"AGARD R-577 pitch after 1 s",
     "attitude_one_pitch",
     true,
     false,
     {"AGARD577_attitude_1s_1in_pitch"},
     {}},
    {"AGARD R-577 roll after 1 s", "attitude_one_roll", true, false, {"AGARD577_attitude_1s_1in_roll"}, {}},
    {"MIL-H-8501A pitch control power",
     "control_power_pitch",
     true,
     false,
     {"MILH8501_control_power_pitch"},
     {}},
    {"MIL-H-8501A roll control power",
     "control_power_roll",
     true,
     false,
     {"MILH8501_control_power_roll"},
     {}},
    {"MIL-H-8501A yaw control power", "control_power_yaw", true, false, {"MILH8501_control_power_yaw"}, {}},
    {"AGARD R-577 pitch control power",
     "control_power_pitch",
     true,
     false,
     {"AGARD577_control_power_pitch"},
     {}},
    {"AGARD R-577 roll control power",
     "control_power_roll",
     true,
     false,
     {"AGARD577_control_power_roll"},
     {}},
    {"AGARD R-577 yaw control power", "control_power_yaw", true, false, {"AGARD577_control_power_yaw"}, {}},
    {"MIL-H-8501A pitch damping", "damping_pitch", true, false, {"MILH8501_damping_pitch"}, {}},
    {"MIL-H-8501A roll damping", "damping_roll", true, false, {"MILH8501_damping_roll"}, {}},
    {"MIL-H-8501A yaw damping", "damping_yaw", true, false, {"MILH8501_damping_yaw"}, {}},
    {"AGARD R-577 pitch damping", "damping_pitch", true, false, {"AGARD577_damping_pitch"}, {}},
    {"AGARD R-577 roll damping", "damping_roll", true, false, {"AGARD577_damping_roll"}, {}},
    {"AGARD oscillation in hover", "oscillation_zeta", true, true, {"AGARD_unstable_damping_limit"}, {}},
    {"ADS-33 heave time constant", "heave_time", true, true, {}, {"ADS33_heave_T_L1_max"}},
    {"ADS-33 yaw oscillation", "lateral_oscillation_zeta", true, true, {"ADS33_yaw_osc_damping_L1"}, {}},
    {"ADS-33 yaw bandwidth for target acquisition",
     "bandwidth_yaw",
     true,
     true,
     {"ADS33_yaw_bandwidth_target_acquisition_L1"},
     {}},
    {"ADS-33 oscillation with divided attention",
     "oscillation_zeta",
     true,
     true,
     {"ADS33_midterm_damping_divided_attention_L1"},
     {}},
    {"Dutch roll damping ratio",
     "dutch_zeta",
     false,
     true,
     {"dutch_zeta_L1_cat%", "dutch_zeta_L2", "dutch_zeta_L3"},
     {}},
    {"Dutch roll damping",
     "dutch_zeta_omega",
     false,
     true,
     {"dutch_zeta_omega_L1_cat%", "dutch_zeta_omega_L2"},
     {}},
    {"Dutch roll frequency",
     "dutch_omega",
     false,
     true,
     {"dutch_omega_L1_cat%", "dutch_omega_L2_L3", "dutch_omega_L2_L3"},
     {}},
    {"Roll time constant",
     "roll_time",
     false,
     true,
     {},
     {"roll_TR_L1_cat%", "roll_TR_L2_class23", "roll_TR_L3"}},
    {"Spiral time to double",
     "spiral_double_time",
     false,
     true,
     {"spiral_T2_L1_cat%", "spiral_T2_L2", "spiral_T2_L3"},
     {}},
    {"Roll-spiral damping",
     "roll_spiral_zeta_omega",
     false,
     true,
     {"roll_spiral_zeta_omega_L1", "roll_spiral_zeta_omega_L2", "roll_spiral_zeta_omega_L3"},
     {}},
    {"Phugoid damping ratio", "phugoid_zeta", false, true, {"phugoid_zeta_L1"}, {}},
    {"Short period damping ratio",
     "short_period_zeta",
     false,
     true,
     {"sp_zeta_min_L1_cat%", "sp_zeta_min_L2_cat%", "sp_zeta_min_L3_cat%"},
     {"sp_zeta_max_L1_cat%", "sp_zeta_max_L2_cat%"}},
    {"Short period CAP",
     "cap",
     false,
     true,
     {"CAP_min_L1_cat%", "CAP_min_L2_cat%"},
     {"CAP_max_L1_cat%", "CAP_max_L2_cat%"}},
    {"Short period frequency",
     "short_period_omega",
     false,
     true,
     {"sp_omega_min_cat%_L1", "sp_omega_min_cat%_L2"},
     {}},
    {"MIL-F-83300 bank to 45 deg flaps up", "bank_45", false, false, {}, {"MILF83300_339_bank_flaps_up"}},
    {"MIL-F-83300 bank to 30 deg flaps down", "bank_30", false, false, {}, {"MILF83300_339_bank_flaps_down"}},
};

std::string with(const std::string& pattern, const std::string& category) {
  const std::size_t place = pattern.find('%');
  return place == std::string::npos ? pattern
                                    : pattern.substr(0, place) + category + pattern.substr(place + 1);
}

class LimitsFile {
 public:
  explicit LimitsFile(const study::Table& table) : table_(table) {}

  // The row of a name, or of its categories A and C together; none where it is not held or not to be trusted.
  std::optional<std::size_t> row(const std::string& pattern, char category) const {
    std::vector<std::string> names = {with(pattern, std::string(1, category))};
    if (category != 'B') {
      names.push_back(with(pattern, "AC"));
      names.push_back(with(pattern, "AC_class23"));
    }
    for (const std::string& name : names)
      for (std::size_t i = 0; i < table_.rows(); ++i) {
        const std::string& trust = table_.text(i, "confidence");
        if (table_.text(i, "name") == name && (trust == "high" || trust == "medium")) return i;
      }
    return std::nullopt;
  }

  // Puts a limit into `level`; `high` or low.
  void put(const char* pattern, char category, bool high, Limit& level, Criterion& criterion) const {
    if (pattern == nullptr) return;
    const std::optional<std::size_t> at = row(pattern, category);
    if (!at) return;
    (high ? level.high : level.low) = text::parse_number(table_.text(*at, "value"), pattern);
    level.given = true;
    if (!criterion.source.empty()) return;
    criterion.source = table_.text(*at, "source");
    criterion.confidence = table_.text(*at, "confidence");
    criterion.unit = table_.text(*at, "unit");
    if (criterion.unit == "text") criterion.unit = "1/(g s2)";
  }

  // "45 deg in 1.4/1.9/2.8": levels 1, 2, 3.
  void add_bank(char category, std::vector<Criterion>& all) const {
    const std::optional<std::size_t> at = row("bank_classII_cat%", category);
    if (!at) return;
    Criterion c{};
    int bank = 0;
    double limit[3];
    if (std::sscanf(table_.text(*at, "value").c_str(), "%d deg in %lf/%lf/%lf", &bank, limit, limit + 1,
                    limit + 2) != 4)
      return;
    c.name = "Bank to " + std::to_string(bank) + " deg class II";
    c.quantity = "bank_" + std::to_string(bank);
    c.unit = "s";
    c.has_levels = true;
    for (int k = 0; k < 3; ++k) c.level[k].high = limit[k], c.level[k].given = true;
    c.source = table_.text(*at, "source");
    c.confidence = table_.text(*at, "confidence");
    all.push_back(c);
  }

 private:
  const study::Table& table_;
};

}  // namespace

std::vector<Criterion> handling_criteria(char category, const std::string& where) {
  if (!study::has_reference_points())
    throw UsageError(where + ": this aircraft comes without published numbers, tables/README.md");
  const study::Table table = study::reference_points("handling_qualities");
  const LimitsFile file(table);
  std::vector<Criterion> all;
  for (const Form& form : forms) {
    Criterion c{};
    c.name = form.name;
    c.quantity = form.quantity;
    c.in_hover = form.in_hover;
    c.has_levels = form.has_levels;
    for (int k = 0; k < 3; ++k) {
      file.put(form.low[k], category, false, c.level[k], c);
      file.put(form.high[k], category, true, c.level[k], c);
    }
    if (!c.source.empty()) all.push_back(c);
  }
  file.add_bank(category, all);
  return all;
}

std::string level_of(const Criterion& criterion, double value) {
  int last = 0;
  for (int k = 0; k < 3; ++k) {
    const Limit& limit = criterion.level[k];
    if (!limit.given) continue;
    last = k + 1;
    const bool holds = value >= limit.low && value <= limit.high;
    if (holds) return criterion.has_levels ? std::to_string(last) : "met";
  }
  return criterion.has_levels ? "below " + std::to_string(last) : "not met";
}

}  // namespace tiltrotor::cli

// `tiltrotor sensitivity`: what a change of aircraft, loading or gains does to trim and modes.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>

#include "cli/command.hpp"
#include "cli/errors.hpp"
#include "cli/flight_records.hpp"
#include "cli/governed.hpp"
#include "cli/linear_options.hpp"
#include "cli/output.hpp"
#include "cli/sensitivity.hpp"
#include "text/nearest.hpp"
#include "text/split.hpp"

namespace tiltrotor::cli {

namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
enum class Of : unsigned char { modes, trim };

const std::vector<std::string> mode_columns = {
    "mast_deg",          "speed_mps", "axis",     "mode",
    "parameter",         "change",    "unit",     "d_damping_ratio",
    "d_frequency_rad_s", "d_real",    "d_imag",   "damping_ratio",
    "frequency_rad_s",   "real",      "imag",     "status",
    "altitude_m",        "mass_kg",   "cg_sl_in", "flap_deg"};
// And what was let go, behind the power.
const std::vector<std::string> trim_begin = {
    "mast_deg",   "speed_mps",          "parameter",       "change",         "unit",       "d_pitch_deg",
    "d_roll_deg", "d_collective75_deg", "d_long_stick_in", "d_lat_stick_in", "d_pedal_in", "d_power_kw"};
const std::vector<std::string> trim_end = {"status", "altitude_m", "mass_kg", "cg_sl_in", "flap_deg"};

// A row before it has its place among the others.
struct Sorted {
  double size;
  Row row;
};

// What every flight holds and lets go, if not the values.
std::vector<std::string> of_targets(const Arguments& arguments, std::string TrimTarget::*name) {
  std::vector<std::string> names;
  const std::vector<TrimTargets> sets = target_sets(arguments);
  for (const TrimTarget& target : sets.front()) names.push_back(target.*name);
  return names;
}

std::vector<std::string> trim_columns(const std::vector<std::string>& freed) {
  std::vector<std::string> columns = trim_begin;
  for (const std::string& name : freed) columns.push_back("d_" + name);
  columns.insert(columns.end(), trim_end.begin(), trim_end.end());
  return columns;
}

bool holds_power(const Arguments& arguments) {
  const std::vector<std::string> held = of_targets(arguments, &TrimTarget::held);
  return std::any_of(held.begin(), held.end(), [](const std::string& name) { return name == "power_kw"; });
}

class SensitivityRows {
 public:
  SensitivityRows(const Arguments& arguments, const std::vector<SetupOptions>& setups,
                  const SensitivitySystems& systems)
      : of_(static_cast<Of>(arguments.choice("--of", "modes", {"modes", "trim"}))),
        freed_(of_targets(arguments, &TrimTarget::freed)),
        by_freed_(holds_power(arguments)),
        parameters_(
            chosen_parameters(arguments.text("--to", "all"), arguments.where("--to"), systems, freed_)),
        modes_(arguments.text("--mode", "body")),
        where_(arguments.where("--mode")),
        output_(arguments),
        records_(arguments, setups, output_, of_ == Of::modes ? mode_columns : trim_columns(freed_),
                 Output::to_read),
        sensitivity_(systems) {}

  const Shard& shard() const { return output_.shard(); }
  // A name that no flight had is a slip of the hand: throws UsageError where there is no other. A shard does not see every
  // flight.
  int finish() {
    const std::vector<std::string> missing = unseen();
    if (!missing.empty() && has_begun_) {
      const std::set<std::string>& all = seen_;
      const std::string fault = "no flight has a mode called " + quoted(missing.front()) +
                                did_you_mean(missing.front(), {all.begin(), all.end()});
      if (none_seen() && shard().parts == 1)
        throw UsageError(where_ + ": " + fault + "; choose all, body, " + one_of({all.begin(), all.end()}));
      waiting_.messages += "tiltrotor: " + where_ + ": " + fault + "\n";
    }
    write_waiting();
    records_.finish();
    return missing.empty() || !has_begun_ ? exit_success : exit_case_failed;
  }

  int add(const TrimmedFlight& flight, Analyses& work) {
    const char* const trim_status = trim_status_word(flight.trim.status);
    if (!is_trimmed(flight.trim.status)) return add_failed(flight, trim_status);
    Status status = sensitivity_.begin(flight, work);
    if (status != Status::ok) return fail(flight, status, "");
    has_begun_ = true;
    for (const NamedRoot& root : sensitivity_.roots()) seen_.insert(root.name);
    const std::vector<std::size_t> shown = shown_roots();
    if (of_ == Of::modes && shown.empty()) {
      waiting_.messages +=
          "tiltrotor: " + flight.where + ": no mode called " + modes_ + " here: " + root_names() + "\n";
      return add_failed(flight, "no_such_mode");
    }
    std::vector<std::vector<Sorted>> rows(of_ == Of::modes ? shown.size() : 1);
    int exit_status = exit_success;
    for (const SensitivityParameter* parameter : parameters_) {
      FlightMotion motion{};
      status = sensitivity_.move(*parameter, motion);
      if (status != Status::ok) {
        exit_status = fail(flight, status, parameter->name);
        continue;
      }
      if (of_ == Of::trim) rows[0].push_back(trim_row(flight, *parameter, motion));
      for (std::size_t k = 0; k < shown.size() && of_ == Of::modes; ++k)
        rows[k].push_back(
            mode_row(flight, *parameter, sensitivity_.roots()[shown[k]], motion.root[shown[k]]));
    }
    for (std::vector<Sorted>& part : rows) {
      std::stable_sort(part.begin(), part.end(),
                       [](const Sorted& a, const Sorted& b) { return a.size > b.size; });
      for (const Sorted& sorted : part) write(flight, sorted.row);
    }
    return exit_status;
  }

 private:
  // Names of --mode that no flight had so far.
  std::vector<std::string> unseen() const {
    std::vector<std::string> names;
    if (modes_ == "all" || modes_ == "body") return names;
    for (const std::string& name : split(modes_, ','))
      if (seen_.count(name) == 0) names.push_back(name);
    return names;
  }
  bool none_seen() const {
    const bool named = modes_ != "all" && modes_ != "body";
    return named && unseen().size() == split(modes_, ',').size();
  }
  // Rows and messages wait until a name has been seen, since nothing is written where none is one.
  void write(const TrimmedFlight& flight, const Row& row) {
    waiting_.rows.push_back(records_.complete(flight, row));
    if (!none_seen()) write_waiting();
  }
  void write_waiting() {
    std::fputs(waiting_.messages.c_str(), stderr);
    for (const Row& row : waiting_.rows) records_.add(row);
    waiting_ = {};
  }

  std::vector<std::size_t> shown_roots() const {
    const std::vector<std::string> names = split(modes_, ',');
    const std::vector<NamedRoot>& roots = sensitivity_.roots();
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < roots.size(); ++i) {
      const bool wanted = modes_ == "all" ? true
                          : modes_ == "body"
                              ? roots[i].axis != "rotor"
                              : std::find(names.begin(), names.end(), roots[i].name) != names.end();
      if (wanted) shown.push_back(i);
    }
    return shown;
  }
  std::string root_names() const {
    std::string names;
    for (const NamedRoot& root : sensitivity_.roots()) names += (names.empty() ? "" : ", ") + root.name;
    return names;
  }

  Row head(const TrimmedFlight& flight) const {
    return {as_given(flight.mast_deg), as_given(flight.flight.speed)};
  }
  void end(const TrimmedFlight& flight, const char* status, Row& row) const {
    row.emplace_back(std::string(status));
    for (const char* setting : {"altitude_m", "mass_kg", "cg_sl_in", "flap_deg"})
      row.emplace_back(as_given(flight.setting(setting)));
  }
  static void add_parameter(const SensitivityParameter& p, Row& row) {
    row.insert(row.end(), {p.name, as_given(p.amount), p.unit});
  }

  // Of a pair the damping ratio says what is better, of a real root the root.
  Sorted mode_row(const TrimmedFlight& flight, const SensitivityParameter& p, const NamedRoot& root,
                  const RootMotion<double>& motion) const {
    Row row = head(flight);
    row.insert(row.end(), {root.axis, root.name});
    add_parameter(p, row);
    for (const double number : {motion.damping_ratio, motion.frequency, motion.real, motion.imag,
                                root.damping_ratio, root.frequency, root.real, root.imag})
      row.emplace_back(number);
    end(flight, trim_status_word(flight.trim.status), row);
    return {std::abs(root.imag > 0 ? motion.damping_ratio : motion.real), row};
  }

  Sorted trim_row(const TrimmedFlight& flight, const SensitivityParameter& p,
                  const FlightMotion& motion) const {
    constexpr double radian = kRadPerDeg<double>;
    Row row = head(flight);
    add_parameter(p, row);
    for (const double number :
         {motion.trim.x.pitch / radian, motion.trim.x.roll / radian, motion.trim.u.collective / radian,
          motion.trim.u.long_stick, motion.trim.u.lat_stick, motion.trim.u.pedal, motion.power / 1000})
      row.emplace_back(number);
    for (const double number : motion.freed) row.emplace_back(number);
    end(flight, trim_status_word(flight.trim.status), row);
    return {std::abs(by_freed_ ? motion.freed.front() : motion.power), row};
  }

  int add_failed(const TrimmedFlight& flight, const char* status, const char* parameter = "") {
    Row row = head(flight);
    const bool of_modes = of_ == Of::modes;
    if (of_modes) row.insert(row.end(), {"", ""});
    row.insert(row.end(), {parameter, kNothing, ""});
    row.insert(row.end(), of_modes ? 8 : 7 + freed_.size(), kNothing);
    end(flight, status, row);
    write(flight, row);
    return exit_case_failed;
  }
  int fail(const TrimmedFlight& flight, Status status, const char* parameter) {
    const std::string& fault = sensitivity_.fault();
    std::fprintf(stderr, "tiltrotor: %s: %s%s%s\n", flight.where.c_str(), parameter,
                 *parameter == '\0' ? "" : ": ", fault.empty() ? status_text(status) : fault.c_str());
    return add_failed(flight, status_word(status), parameter);
  }

  Of of_;
  std::vector<std::string> freed_;
  bool by_freed_;  // rows of trims are in the order of what is let go first, since their power stays
  std::vector<const SensitivityParameter*> parameters_;
  std::string modes_, where_;
  Output output_;  // last of what arguments can refuse
  FlightRecords records_;
  Sensitivity sensitivity_;
  struct {
    std::vector<Row> rows;
    std::string messages;
  } waiting_;
  bool has_begun_ = false;
  std::set<std::string> seen_;  // names of modes, in any flight
};

int run(const Arguments& arguments) {
  const std::vector<SetupOptions> setups = SetupOptions::every_combination(arguments);
  const bool of_trim = arguments.choice("--of", "modes", {"modes", "trim"}) == 1;
  const SensitivitySystems systems = {of_trim ? Governor::off : setups.front().switches().governor,
                                      wants_scas(arguments)};
  if (!of_trim) require_no_positions(setups.front().switches(), arguments);
  for (const char* option : {"--scas", "--mode"})
    if (arguments.given(option) && of_trim)
      throw UsageError(arguments.where(option) + ": goes with --of modes");
  flight_cases(arguments, setups.size());
  SensitivityRows rows(arguments, setups, systems);
  const AnalysesWorkspace work;
  const int exit_status =
      for_each_trim(arguments, setups, rows.shard(), *work,
                    [&](const TrimmedFlight& flight) -> int { return rows.add(flight, *work); });
  const int names = rows.finish();
  return exit_status != exit_success ? exit_status : names;
}

std::string parameter_names() {
  std::string names;
  std::size_t line = 0;
  for (const SensitivityParameter& parameter : sensitivity_parameters()) {
    const std::string word = parameter.name;
    if (line + word.size() > 100) {
      names += ",\n";
      line = 0;
    } else if (!names.empty()) {
      names += ", ";
    }
    names += word;
    line += word.size() + 2;
  }
  return names;
}

}  // namespace

Command sensitivity_command() {
  static const std::string description =
      "For each mode, or for the trim, one row a parameter: what its usual `change`, in `unit`, does to first order, the\n"
      "largest effect first: of a pair on the damping ratio, of a real root on the root, of a trim on the power. The trim\n"
      "moves with the parameter, and with a governor the balance of power; speed, climb, turn rate, sideslip or azimuth stay.\n"
      "With --hold, --bank, --load-factor or --ball what they hold stays, and what they let go moves for it: in --of trim a\n"
      "column for each (`d_climb_deg`), and the order of rows where power is held. Where nothing let go moves what is held,\n"
      "as power at its least, the status is `singular`. Exact: second derivatives of the model, which carries the slope of\n"
      "the parameter through every number and table, and both eigenvectors. On a knot of a table, as sideslip 0 is, it is\n"
      "that of the interval above.\n"
      "Parameters: " +
      parameter_names() + ".\n";
  return {
      "sensitivity",
      "what would make a mode better: exact derivatives of modes and trim",
      description.c_str(),
      "tiltrotor sensitivity --mast 90 --speed 100 --mode dutch_roll --to all",
      OptionList{{"--of", "WHAT", "modes or trim (modes)"},
                 {"--to", "NAMES", "all, or parameters with commas between (all)"},
                 {"--mode", "NAMES", "body: all but the rotors'; all; or modes with commas between (body)"}} +
          scas_option() + flight_list() + SetupOptions::list() + Output::list(),
      run};
}

}  // namespace tiltrotor::cli

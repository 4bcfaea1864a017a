// `tiltrotor trim`: equilibrium at every combination of mast angle, speed and loading.

#include <algorithm>
#include <limits>

#include "cli/chosen_columns.hpp"
#include "cli/command.hpp"
#include "cli/flight_range.hpp"
#include "cli/flight_records.hpp"
#include "cli/model_options.hpp"
#include "cli/output.hpp"
#include "cli/state_columns.hpp"
#include "cli/trim_columns.hpp"
#include "cli/trim_readings.hpp"
#include "cli/trimmed_flights.hpp"

namespace tiltrotor::cli {

namespace {

constexpr double radian = kRadPerDeg<double>;
constexpr double kilo = 1000;

using Flight = const TrimmedFlight&;

enum class Kind { result, search, given };  // a number of the trim, of the search for it, or of the user

struct Column {
  const char* name;
  double (*value)(Flight);
  Kind kind = Kind::result;  // only a result needs a trim
};

double mean(const double (&sides)[2]) { return (sides[right] + sides[left]) / 2; }
double half_difference(const double (&sides)[2]) { return (sides[right] - sides[left]) / 2; }

const Column columns_before_status[] = {
    {"mast_deg", [](Flight f) { return f.mast_deg; }, Kind::given},
    {"speed_mps", [](Flight f) { return f.flight.speed; }, Kind::given},
    {"altitude_m", [](Flight f) { return f.setting("altitude_m"); }, Kind::given},
    {"climb_deg", [](Flight f) { return f.climb_deg; }, Kind::given},
};

const Column columns_after_status[] = {
    {"iterations", [](Flight f) { return static_cast<double>(f.trim.iterations); }, Kind::search},
    {"residual", [](Flight f) { return f.trim.residual; }, Kind::search},
    {"pitch_deg", [](Flight f) { return f.trim.state.pitch / radian; }},
    {"roll_deg", [](Flight f) { return f.trim.state.roll / radian; }},
    {"alpha_deg", [](Flight f) { return f.trim.angle_of_attack / radian; }},
    {"sideslip_deg", [](Flight f) { return f.trim.sideslip / radian; }},
    {"collective75_deg", [](Flight f) { return f.trim.controls.collective / radian; }},
    {"collective_root_deg", [](Flight f) { return f.trim.collective_root / radian; }},
    {"long_cyclic_deg", [](Flight f) { return mean(f.trim.blades.long_cyclic) / radian; }},
    {"diff_collective_deg", [](Flight f) { return half_difference(f.trim.blades.collective) / radian; }},
    {"diff_long_cyclic_deg", [](Flight f) { return half_difference(f.trim.blades.long_cyclic) / radian; }},
    {"elevator_deg", [](Flight f) { return f.trim.blades.elevator / radian; }},
    {"aileron_deg", [](Flight f) { return f.trim.blades.aileron / radian; }},
    {"rudder_deg", [](Flight f) { return f.trim.blades.rudder / radian; }},
    // Counted from the rear stop.
    {"long_stick_in",
     [](Flight f) { return f.configuration.aircraft->controls.long_travel + f.trim.controls.long_stick; }},
    {"lat_stick_in", [](Flight f) { return f.trim.controls.lat_stick; }},
    {"pedal_in", [](Flight f) { return f.trim.controls.pedal; }},
    {"thrust_right_n", [](Flight f) { return f.trim.thrust[right]; }},
    {"thrust_left_n", [](Flight f) { return f.trim.thrust[left]; }},
    {"power_kw", [](Flight f) { return (f.trim.power[right] + f.trim.power[left]) / kilo; }},
    {"download_frac", [](Flight f) { return f.trim.download_fraction; }},
    {"turn_rate_degps", [](Flight f) { return f.turn_rate_degps; }, Kind::given},
    {"load_factor", [](Flight f) { return f.trim.load_factor; }},
    {"wing_alpha_deg", [](Flight f) { return f.trim.wing_angle_of_attack / radian; }},
    {"downwash_deg", [](Flight f) { return f.trim.state.downwash / radian; }},
    {"b1c_right_deg", [](Flight f) { return f.trim.state.rotor[right].b1c / radian; }},
    {"b1s_right_deg", [](Flight f) { return f.trim.state.rotor[right].b1s / radian; }},
    {"b1c_left_deg", [](Flight f) { return f.trim.state.rotor[left].b1c / radian; }},
    {"b1s_left_deg", [](Flight f) { return f.trim.state.rotor[left].b1s / radian; }},
    {"n0_right", [](Flight f) { return f.trim.state.rotor[right].lambda_0; }},
    {"n0_left", [](Flight f) { return f.trim.state.rotor[left].lambda_0; }},
    {"flap_deg", [](Flight f) { return f.setting("flap_deg"); }, Kind::given},
    {"rotor_rpm", [](Flight f) { return f.setting("rotor_rpm"); }, Kind::given},
    {"mass_kg", [](Flight f) { return f.setting("mass_kg"); }, Kind::given},
    {"cg_sl_in", [](Flight f) { return f.setting("cg_sl_in"); }, Kind::given},
};

std::vector<std::string> column_names() {
  std::vector<std::string> names;
  for (const Column& column : columns_before_status) names.emplace_back(column.name);
  names.emplace_back("status");
  for (const Column& column : columns_after_status) names.emplace_back(column.name);
  names.emplace_back("limits");
  return names;
}

// Every limit that is exceeded, by its word.
std::string limit_words(const TrimResult<double>& trim) {
  std::vector<std::string> words;
  for (int k = 0; k < trim.limits.count; ++k)
    words.emplace_back(limit_name(trim.limits.exceeded[k].limit).word);
  for (const std::string& control : controls_beyond_stops(trim.controls))
    if (std::find(words.begin(), words.end(), control) == words.end()) words.push_back(control);
  return words_of(words);
}

bool sideslip_is_given(Flight f) {
  return !f.azimuth_deg && f.flight.speed >= kLeastSpeed<double> && !is_vertical(f.flight);
}

Cell cell(const Column& column, Flight flight) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  if (column.kind == Kind::given) return as_given(column.value(flight));
  if (column.kind == Kind::result && !is_trimmed(flight.trim.status)) return nothing;
  if (column.name == std::string("sideslip_deg") && sideslip_is_given(flight))
    return as_given(flight.sideslip_deg);
  return column.value(flight);
}

Row row(Flight flight, const std::vector<std::string>& completing) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  const bool trimmed = is_trimmed(flight.trim.status);
  Row cells;
  for (const Column& column : columns_before_status) cells.push_back(cell(column, flight));
  cells.emplace_back(trim_status_word(flight.trim.status));
  for (const Column& column : columns_after_status) cells.push_back(cell(column, flight));
  cells.emplace_back(trimmed ? limit_words(flight.trim) : std::string());
  for (const std::string& column : completing) {
    cells.emplace_back(trimmed ? completing_value(column, flight.trim.state, flight.trim.controls) : nothing);
  }
  cells.emplace_back(flight.setup->model());
  return cells;
}

// The row of the chosen columns, with what is read beside it.
Row chosen_row(const ChosenColumns& columns, const Row& own, Flight flight) {
  Instruments<double> readings = no_readings();
  std::vector<double> airframe;
  const bool reads = columns.have_readings() || !columns.airframe().empty();
  if (reads && is_trimmed(flight.trim.status)) read_trim(flight, columns.airframe(), readings, airframe);
  return columns.row(own, readings, airframe);
}

int run(const Arguments& arguments) {
  const std::vector<SetupOptions> setups = SetupOptions::every_combination(arguments);
  std::vector<std::string> names = column_names();
  const std::vector<std::string> completing = completing_columns(names, setups.front().switches(), false);
  names.insert(names.end(), completing.begin(), completing.end());
  names.emplace_back(kModelColumn);
  const SweptColumns swept(arguments, setups, names);
  names.insert(names.end(), swept.names().begin(), swept.names().end());
  const ChosenColumns columns(arguments, names);
  Output output(arguments);
  Records records = output.records(columns.names(), Output::to_read);
  const AnalysesWorkspace work;
  const int exit_status = for_each_trim(arguments, setups, output.shard(), *work, [&](Flight flight) {
    Row own = row(flight, completing);
    for (const Cell& cell : swept.cells(flight)) own.push_back(cell);
    records.add(chosen_row(columns, own, flight));
    return 0;
  });
  records.finish();
  return exit_status;
}

}  // namespace

std::vector<std::string> trim_columns() { return column_names(); }

std::vector<std::string> trim_quantities() {
  std::vector<std::string> names;
  for (const Column& column : columns_after_status)
    if (column.kind == Kind::result) names.emplace_back(column.name);
  return names;
}

double (*trim_quantity(const std::string& name))(Flight) {
  return std::find_if(std::begin(columns_after_status), std::end(columns_after_status),
                      [&](const Column& column) { return name == column.name; })
      ->value;
}

Command trim_command() {
  return {
      "trim",
      "equilibrium at every combination of mast angle, speed, altitude, mass, CG and flaps",
      "Level, climbing, turning or sideslipping flight, with the wind from any side, or with a result held\n"
      "by letting something go (--hold, --free), each from a cold start. What describes the flight takes a\n"
      "value, a list or a range; so do --altitude, --mass, --cg-sl, --flap, --rotor-rpm and --isa-offset.\n"
      "A `status` that is not ok is explained on stderr and\n"
      "makes the exit status 1: trimmed beyond a limit (vortex_ring, wing_stall, control_limit, "
      "flap_limit,\n"
      "power_limit, torque_limit: the first that holds; `limits` lists all), or no trim\n"
      "(rotor_stall, not_converged, singular; out_of_range where the flight asked for cannot be).\n",
      "tiltrotor trim --mast 0,30 --speed 0,40,50 --format csv",
      flight_list() + SetupOptions::list() + columns_option() + Output::list(),
      run};
}

}  // namespace tiltrotor::cli

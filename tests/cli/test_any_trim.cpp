// Trims that hold another quantity than they usually do, with the wind from any side, on hot days, on one engine.
// Expected: laws of steady flight; `derivative` at the states that were found; the plain trim at what was let go.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "cli/refused.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"
#include "this_aircraft.hpp"

using check::check_refused;
using check::CsvText;
using check::run_tiltrotor;
using check::ScratchFolder;

namespace {

constexpr double degree = 3.14159265358979323846 / 180;
constexpr double gravity = 9.80665;

CsvText trims(const std::string& options) {
  return CsvText(run_tiltrotor("trim --format csv --grid realtime " + options).out);
}

// Largest rate that `derivative` has at the states of a trim, heading and position apart.
double largest_rate(const std::string& options, const std::string& setup = "") {
  const ScratchFolder folder;
  const std::string file = folder.path("trim.csv");
  std::ofstream(file) << run_tiltrotor("trim --format csv --grid realtime " + options + setup).out;
  const CsvText rates(run_tiltrotor("derivative --format csv --grid realtime --states " + file + setup).out);
  double largest = 0;
  for (const std::string& column : rates.columns) {
    const bool is_rate = column.rfind("d_", 0) == 0 && column.find("psi") == std::string::npos;
    if (is_rate) largest = std::max(largest, std::fabs(rates.number(0, column)));
  }
  return rates.rows.empty() ? HUGE_VAL : largest;
}

// Of a row of `trim`: r u - p w = g sin(roll) cos(pitch) where no side force is felt.
double side_force(const CsvText& t) {
  const double v = t.number(0, "speed_mps"), alpha = t.number(0, "alpha_deg") * degree;
  const double beta = t.number(0, "sideslip_deg") * degree, turn = t.number(0, "turn_rate_degps") * degree;
  const double roll = t.number(0, "roll_deg") * degree, pitch = t.number(0, "pitch_deg") * degree;
  const double u = v * std::cos(beta) * std::cos(alpha), w = v * std::cos(beta) * std::sin(alpha);
  const double p = -turn * std::sin(pitch), r = turn * std::cos(pitch) * std::cos(roll);
  return (r * u - p * w) / gravity - std::sin(roll) * std::cos(pitch);
}

}  // namespace

TEST(cli_trim_holds_bank_and_ball) {
  for (const std::string bank : {"-20", "35"}) {
    const CsvText t = trims("--mast 30 --speed 50 --ball centred --bank=" + bank);
    CHECK_EQ(t.text(0, "status"), std::string("ok"));
    CHECK_NEAR(t.number(0, "roll_deg"), std::stod(bank), 1e-7);
    CHECK_NEAR(side_force(t), 0, 1e-8);
    CHECK_LT(0, std::fabs(t.number(0, "sideslip_deg")));
    CHECK_LT(0, t.number(0, "turn_rate_degps") * std::stod(bank));
  }
  CHECK_LT(largest_rate("--mast 30 --speed 50 --ball centred --bank=35"), 1e-7);
}

// The plain trim in the turn that was found.
TEST(cli_trim_holds_the_load_factor) {
  const CsvText held = trims("--speed 40 --load-factor 1.25");
  CHECK_NEAR(held.number(0, "load_factor"), 1.25, 1e-8);
  CHECK_LT(0, held.number(0, "turn_rate_degps"));
  const CsvText plain = trims("--speed 40 --turn-rate " + held.text(0, "turn_rate_degps"));
  for (const char* column : {"load_factor", "roll_deg", "power_kw", "long_stick_in"})
    CHECK_NEAR(plain.number(0, column), held.number(0, column),
               1e-7 * (1 + std::fabs(held.number(0, column))));
}

// Each held quantity, with each freed: the plain trim at what was found has it.
TEST(cli_trim_holds_any_result) {
  struct Case {
    const char* flight;
    const char* held;
    double value;
    const char* freed;
    const char* option;
  };
  const Case cases[] = {
      {"--speed 40", "power_kw", 900, "climb_deg", "--climb"},
      {"--mast 90 --speed 90", "power_kw", 0, "climb_deg", "--climb"},
      {"--mast 90 --speed 90", "power_kw", 1500, "speed_mps", "--speed"},
      {"--speed 30", "collective75_deg", 9, "climb_deg", "--climb"},
      {"--mast 60 --speed 60", "pitch_deg", 3, "speed_mps", "--speed"},
      {"--speed 30", "long_stick_in", 6, "speed_mps", "--speed"},
      {"--mast 90 --speed 80", "pitch_deg", 2, "mass_kg", "--mass"},
      {"--speed 0", "power_kw", 1500, "altitude_m", "--altitude"},
      {"--speed 35 --climb -20", "power_kw", 0, "rotor_rpm", "--rotor-rpm"},
  };
  for (const Case& one : cases) {
    char value[40];
    std::snprintf(value, sizeof value, "%g", one.value);
    const std::string flight = one.flight;
    const std::string hold = flight + " --hold " + one.held + "=" + value + " --free " + one.freed;
    const auto run = run_tiltrotor("trim --format csv --grid realtime " + hold);
    const CsvText held(run.out);
    const double size = std::max(1.0, std::fabs(one.value));
    if (!CHECK(held.rows.size() == 1 && !held.text(0, one.held).empty())) {
      NOTE(hold << ": " << run.err);
      continue;
    }
    if (!CHECK_NEAR(held.number(0, one.held), one.value, 1e-8 * size)) NOTE(hold << ": " << run.err);
    const std::string option = std::string(one.option) + "=";
    const std::size_t at = flight.find(one.option);
    std::string rest = flight;
    if (at != std::string::npos) rest.erase(at, flight.find(" --", at + 1) - at);
    const CsvText plain = trims(rest + " " + option + held.text(0, one.freed));
    if (!CHECK_NEAR(plain.number(0, one.held), one.value, 1e-6 * size)) NOTE(hold);
  }
}

// Every state of the flight found is at rest, as `derivative` has it; 90 and 270 are mirrored; 0 is straight ahead.
TEST(cli_trim_flies_with_the_wind_from_any_azimuth) {
  for (const char* azimuth : {"0", "45", "90", "135", "180", "225", "270", "-30"}) {
    const double rate = largest_rate(std::string("--speed 12 --azimuth=") + azimuth);
    if (!CHECK_LT(rate, 1e-6)) NOTE("azimuth " << azimuth);
  }
  CHECK_LT(largest_rate("--speed 12 --azimuth 180 --climb 10 --turn-rate 4"), 1e-6);
  const CsvText t = trims("--speed 12 --azimuth 0,90,180,270");
  const CsvText plain = trims("--speed 12");
  CHECK_NEAR(t.number(0, "pitch_deg"), plain.number(0, "pitch_deg"), 1e-8);
  CHECK_NEAR(t.number(1, "sideslip_deg"), 90, 10);  // less by the roll angle
  CHECK_NEAR(std::fabs(t.number(2, "alpha_deg")), 180, 15);
  for (const char* even : {"pitch_deg", "power_kw", "long_stick_in"})
    CHECK_NEAR(t.number(1, even), t.number(3, even), 1e-7 * (1 + std::fabs(t.number(1, even))));
  for (const char* odd : {"roll_deg", "lat_stick_in", "pedal_in"})
    CHECK_NEAR(t.number(1, odd), -t.number(3, odd), 1e-7);
}

// In airplane mode from straight ahead; what has no trim says so.
TEST(cli_trim_azimuth_from_flight_straight_ahead) {
  CHECK_LT(largest_rate("--mast 90 --speed 90 --azimuth 10"), 1e-6);
  const auto run = run_tiltrotor("trim --format csv --grid realtime --mast 90 --speed 90 --azimuth 180");
  CHECK_EQ(run.exit_status, 1);
  CHECK_EQ(CsvText(run.out).text(0, "status"), std::string("not_converged"));
}

// A flight in air of the same density, where only the speed of sound differs; the engines have less.
TEST(cli_trim_on_a_hot_day) {
  const double warmer = 30, standard = 288.15;
  const double ratio = standard / (standard + warmer);  // of density, at the same pressure
  // ISO 2533: density goes with (1 - 0.0065 h / 288.15)^4.2559
  const double same = (1 - std::pow(ratio, 1 / 4.2559)) * standard / 0.0065;
  char altitude[40];
  std::snprintf(altitude, sizeof altitude, "%.6f", same);
  const CsvText hot = trims("--isa-offset 30"), high = trims(std::string("--altitude ") + altitude);
  CHECK_NEAR(hot.number(0, "power_kw") / high.number(0, "power_kw"), 1, 0.01);
  CHECK_LT(1.02 * trims("").number(0, "power_kw"), hot.number(0, "power_kw"));
  CHECK_EQ(trims("--isa-offset 0").text(0, "power_kw"), trims("").text(0, "power_kw"));
  CHECK_LT(largest_rate("--speed 20", " --isa-offset 25"), 1e-7);
  CHECK(hot.text(0, "model").find("isa_offset=30") != std::string::npos);
}

// Half of the take-off rating of both.
TEST(cli_trim_on_one_engine) {
  const auto one = run_tiltrotor("trim --format csv --grid realtime --engines 1 --speed 0,35");
  const CsvText rows(one.out);
  CHECK_EQ(rows.text(0, "status"), std::string("power_limit"));
  CHECK_EQ(rows.text(1, "status"), std::string("ok"));
  const tiltrotor::ControlTables<double>& t = this_aircraft::numbers().controls;
  char rating[40];
  std::snprintf(rating, sizeof rating, "take-off rating %.2f kW",
                t.engine_power * t.transmission_efficiency / 1000);
  if (!CHECK(one.err.find(rating) != std::string::npos)) NOTE(one.err << rating);
}

TEST(cli_trim_takes_lists_of_every_condition) {
  struct Case {
    const char* list;
    const char* column;
    std::vector<double> values;
  };
  const Case cases[] = {{"--climb=-5,0,5", "climb_deg", {-5, 0, 5}},
                        {"--sideslip 0:4:8", "sideslip_deg", {0, 4, 8}},
                        {"--turn-rate 0,5", "turn_rate_degps", {0, 5}},
                        {"--rotor-rpm 560,589", "rotor_rpm", {560, 589}},
                        {"--bank 0,10", "roll_deg", {0, 10}}};
  for (const Case& one : cases) {
    const CsvText t = trims(std::string("--speed 40 ") + one.list);
    if (!CHECK_EQ(t.rows.size(), one.values.size())) continue;
    for (std::size_t i = 0; i < one.values.size(); ++i)
      CHECK_NEAR(t.number(i, one.column), one.values[i], 1e-7);
  }
}

// The nearest that was found, and where was searched; the row stays.
TEST(cli_trim_says_how_near_it_came) {
  const auto run =
      run_tiltrotor("trim --format csv --grid realtime --speed 40 --hold power_kw=100 --free speed_mps");
  CHECK_EQ(run.exit_status, 1);
  CHECK_EQ(CsvText(run.out).text(0, "status"), std::string("not_converged"));
  CHECK(run.err.find("power_kw 100 is not reached: nearest ") != std::string::npos);
  CHECK(run.err.find(", searched in 0..150 m/s") != std::string::npos);
}

TEST(cli_bad_targets) {
  check_refused("trim --bank 81", "lies outside -80..80 deg");
  check_refused("trim --load-factor 6", "lies outside 0..5 g");
  check_refused("trim --azimuth 361", "lies outside -180..360 deg");
  check_refused("trim --isa-offset 61", "lies outside -60..60 K");
  check_refused("trim --engines 3", "1..2");
  check_refused("trim --ball left", "is not one of centred");
  check_refused("trim --hold power_kw=1", "1 --hold and 0 --free");
  check_refused("trim --free climb_deg", "0 --hold and 1 --free");
  check_refused("trim --hold power_kW=1 --free climb_deg", "did you mean");
  check_refused("trim --hold power_kw --free climb_deg", "not NAME=VALUE");
  check_refused("trim --hold power_kw=1 --free climb", "is not one of speed_mps, climb_deg");
  check_refused("trim --speed 40 --bank 10 --load-factor 1.1", "lets turn_rate_degps go");
  check_refused("trim --speed 40 --bank 10 --turn-rate 3", "leave --turn-rate out");
  check_refused("trim --speed 40 --ball centred --sideslip 3", "leave --sideslip out");
  check_refused("trim --speed 40 --azimuth 30 --sideslip 3", "leave --sideslip out");
  check_refused("trim --speed 40 --azimuth 30 --ball centred", "--azimuth: sets the sideslip");
  check_refused("trim --speed 40,50 --hold power_kw=500 --free speed_mps", "one value, not several");
  check_refused("respond --speed 40 --bank 5,10", "take one value each");
  check_refused("linearize --states x.csv --bank 5", "cannot be read");
}

// Other commands share the flight.
TEST(cli_modes_at_a_trim_with_targets) {
  const auto turn = trims("--speed 40 --bank 20");
  const auto held = run_tiltrotor("modes --format csv --grid realtime --speed 40 --bank 20");
  const auto plain = run_tiltrotor("modes --format csv --grid realtime --speed 40 --turn-rate " +
                                   turn.text(0, "turn_rate_degps"));
  const CsvText a(held.out), b(plain.out);
  if (!CHECK(a.rows.size() == b.rows.size() && a.rows.size() > 4)) return;
  for (std::size_t i = 0; i < 4; ++i) CHECK_NEAR(a.number(i, "real"), b.number(i, "real"), 1e-6);
}

// Rows of a states file that are no flight, contradict themselves or ask for what no pilot can command: one line
// with file, line and reason; the other rows are computed.
#include <algorithm>
#include <cmath>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "cli/scratch_folder.hpp"
#include "cli/states_refused.hpp"
#include "run_program.hpp"
#include "this_aircraft.hpp"

using check::check_states_refused;
using check::contains;
using check::CsvText;
using check::lines;
using check::run_tiltrotor;
using check::ScratchFolder;
using this_aircraft::flown;

namespace {

// The file with one cell written anew.
std::string edited(const std::string& text, std::size_t row, const std::string& column,
                   const std::string& value) {
  const CsvText csv(text);
  std::string out = check::first_line(text) + "\n";
  for (std::size_t r = 0; r < csv.rows.size(); ++r) {
    for (std::size_t i = 0; i < csv.columns.size(); ++i) {
      const bool here = r == row && csv.columns[i] == column;
      out += (i > 0 ? "," : "") + (here ? value : csv.rows[r][i]);
    }
    out += "\n";
  }
  return out;
}

}  // namespace

// The file holds a flight that has no trim: what is computed of the others is what they give alone.
TEST(cli_states_without_trim_lose_no_other_row) {
  const ScratchFolder folder;
  const std::string all = run_tiltrotor("trim --mast 90 --speed 20,80,100").out;
  const std::string good = run_tiltrotor("trim --mast 90 --speed 80,100").out;
  CHECK_EQ(CsvText(all).text(0, "status"), "not_converged");
  const std::string path = folder.write("all.csv", all);
  const std::string good_path = folder.write("good.csv", good);
  const auto run = [](const std::string& command, const std::string& file) {
    return run_tiltrotor(command + " --states " + file);
  };
  for (const char* command : {"derivative", "loads", "linearize"}) {
    const check::ProgramResult with = run(command, path);
    CHECK_EQ(with.exit_status, 1);
    CHECK_EQ(lines(with.err), 1);
    CHECK(contains(with.err, "all.csv:2: the row holds no state: 'not_converged'"));
    CHECK_EQ(run(command, good_path).exit_status, 0);
  }
  const CsvText rates(run("derivative", path).out), good_rates(run("derivative", good_path).out);
  if (!CHECK_EQ(rates.rows.size(), 3u)) return;
  CHECK_EQ(rates.text(0, "d_u"), "");
  CHECK_EQ(rates.text(0, "speed_mps"), "20");
  for (std::size_t row = 0; row < 2; ++row) CHECK(rates.rows[row + 1] == good_rates.rows[row]);
  CHECK(contains(run("derivative --format json", path).out, "\"d_u\": null"));

  const CsvText loads(run("loads", path).out), good_loads(run("loads", good_path).out);
  if (!CHECK_EQ(loads.rows.size(), good_loads.rows.size())) return;
  for (std::size_t row = 0; row < loads.rows.size(); ++row)
    CHECK_EQ(loads.text(row, "z_n"), good_loads.text(row, "z_n"));

  const CsvText models(run("linearize", path).out), good_models(run("linearize", good_path).out);
  CHECK_EQ(models.text(0, "status"), "no_state");
  CHECK_EQ(models.text(0, "matrix"), "");
  CHECK_EQ(models.rows.size(), good_models.rows.size() + 1);

  // Every part of a long run tells of its own rows.
  CHECK_EQ(run("derivative --shard 2/3", path).exit_status, 0);
  CHECK_EQ(run("derivative --shard 1/3", path).exit_status, 1);
  // A file of nothing else, and a row that lacks one number: no empty row.
  CHECK_EQ(run("loads", folder.write("none.csv", run_tiltrotor("trim --mast 90 --speed 20").out)).exit_status,
           1);
  check_states_refused(folder, edited(good, 0, "u_mps", ""), ":2: column u_mps: '' is not a number");
}

// What trim and respond print agrees with its states, in every kind of flight; what was edited does not.
TEST(cli_states_that_contradict_themselves_are_refused) {
  const ScratchFolder folder;
  const char* const flights[] = {"trim --mast 30 --speed 60 --turn-rate 5 --sideslip 4 --climb 3",
                                 "trim --mast 0 --speed 0 --flap 30",
                                 "trim --speed 4 --climb 90",
                                 "trim --mast 90 --speed 100 --climb -3",
                                 "trim --speed 1e-9",
                                 "trim --speed 1e-13 --climb 40",
                                 "respond --mast 30 --speed 60 --duration 0.1 --input gust_w=3@0 "
                                 "--input elevator=2deg@0 --input pedal=0.5@0"};
  for (const char* flight : flights) {
    const check::ProgramResult result =
        run_tiltrotor("derivative --states " + folder.write("s.csv", run_tiltrotor(flight).out));
    if (!CHECK_EQ(result.exit_status, 0)) NOTE(flight << ": " << result.err);
  }
  // Each of them, by a ten thousandth or a little more than nothing.
  const std::string trim =
      run_tiltrotor("trim --mast 30 --speed 60,70 --turn-rate 5 --sideslip 4 --climb 3").out;
  const std::string flight = run_tiltrotor(flights[6]).out;
  const auto check_edit = [&](const std::string& text, const std::string& column) {
    const CsvText csv(text);
    const double before = csv.number(0, column);
    const std::string value = std::to_string(before + 1e-4 * std::max(1.0, std::abs(before)));
    const std::string path = folder.write("edited.csv", edited(text, 0, column, value));
    for (const char* command : {"derivative", "loads", "linearize"}) {
      const check::ProgramResult result = run_tiltrotor(std::string(command) + " --states " + path);
      CHECK_EQ(result.exit_status, 1);
      CHECK_EQ(lines(result.err), 1);
      const bool told =
          contains(result.err, "edited.csv:2: column " + column + ": " + value + ", but ") &&
          (std::abs(before) < 1e-6 || contains(result.err, " give " + csv.text(0, column).substr(0, 6)));
      if (!CHECK(told)) NOTE(command << ": " << result.err);
    }
    const CsvText rates(run_tiltrotor("derivative --states " + path).out);
    CHECK_EQ(rates.rows.size(), csv.rows.size());
    CHECK_EQ(rates.text(0, "d_u"), "");
    CHECK(std::isfinite(rates.number(1, "d_u")));
  };
  for (const char* column : {"speed_mps", "climb_deg", "turn_rate_degps", "alpha_deg", "sideslip_deg",
                             "collective_root_deg", "long_cyclic_deg", "diff_collective_deg",
                             "diff_long_cyclic_deg", "elevator_deg", "aileron_deg", "rudder_deg"})
    check_edit(trim, column);
  for (const char* column : {"speed_mps", "forward_speed_mps", "climb_rate_mps"}) check_edit(flight, column);
  CHECK(contains(
      run_tiltrotor("loads --states " + folder.write("word.csv", edited(trim, 1, "alpha_deg", "high"))).err,
      "word.csv:3: column alpha_deg: 'high' is not a number"));
  // A state that was edited contradicts what was printed beside it.
  const std::string path = folder.write("edited.csv", edited(trim, 1, "w_mps", "3"));
  CHECK(contains(run_tiltrotor("loads --states " + path).err, "edited.csv:3: column "));
}

// Rounded by hand, as a spreadsheet shows it: the digits of the file decide.
TEST(cli_states_of_few_digits_do_not_contradict_themselves) {
  const ScratchFolder folder;
  const std::string exact =
      run_tiltrotor("trim --mast 30 --speed 60 --turn-rate 5 --sideslip 4 --climb 3").out;
  const CsvText csv(exact);
  for (const int decimals : {2, 4, 6}) {
    std::string row;
    for (std::size_t i = 0; i < csv.columns.size(); ++i) {
      char* end = nullptr;
      const double value = std::strtod(csv.rows[0][i].c_str(), &end);
      char text[40];
      std::snprintf(text, sizeof text, "%.*f", decimals, value);
      row += (i > 0 ? "," : "") + (*end == '\0' && !csv.rows[0][i].empty() ? text : csv.rows[0][i]);
    }
    const std::string path = folder.write("s.csv", check::first_line(exact) + "\n" + row + "\n");
    const check::ProgramResult result = run_tiltrotor("loads --states " + path);
    if (!CHECK_EQ(result.exit_status, 0)) NOTE(decimals << ": " << result.err);
  }
}

// With the options that make it alive a state is read; without them it would be ignored, so it is refused.
TEST(cli_bad_states_that_stand_still_are_refused) {
  const ScratchFolder folder;
  const struct {
    const char *options, *column;
  } cases[] = {{"--option coning_states=on", "coning_right_deg"}, {"--option position_states=on", "north_m"}};
  for (const auto& [options, column] : cases) {
    const std::string flight =
        run_tiltrotor(
            flown(std::string("respond --speed 40 --duration 0.05 --input long_stick=1@0 ") + options))
            .out;
    const std::string path = folder.write("s.csv", flight);
    CHECK_EQ(run_tiltrotor("loads --states " + path + " " + options).exit_status, 0);
    check_states_refused(folder, flight, std::string(": column ") + column + ": ");
    check_states_refused(folder, flight, "with these options the state stands still; give");
  }
  const std::string trim = run_tiltrotor(flown("trim --speed 40")).out;
  for (const auto& [options, column] : {std::pair("--option inflow=uniform", "nc_right"),
                                        std::pair("--option downwash_lag=off", "downwash_deg")}) {
    check_states_refused(folder, trim, std::string(":2: column ") + column, options);
    const std::string own = run_tiltrotor(flown(std::string("trim --speed 40 ") + options)).out;
    const check::ProgramResult read =
        run_tiltrotor("loads --states " + folder.write("own.csv", own) + " " + options);
    if (!CHECK_EQ(read.exit_status, 0)) NOTE(options << ": " << read.err);
  }
}

// The ranges of tr_set_controls: tiltrotor.h states them. A trim beyond a stop says so in its own column.
TEST(cli_bad_states_controls_are_in_the_ranges_of_the_c_interface) {
  const ScratchFolder folder;
  const std::string flight =
      run_tiltrotor("respond --speed 40 --duration 0.01 --input elevator=1deg@0 --input gust_u=1@0").out;
  const auto with = [&](const char* column, const char* value) { return edited(flight, 0, column, value); };
  check_states_refused(folder, with("collective75_deg", "81"),
                       ":2: column collective75_deg: 81 lies outside -20.0535228");
  check_states_refused(folder, with("long_stick_from_neutral_in", "4.9"), "4.9 lies outside -4.8..4.8 in");
  check_states_refused(folder, with("lat_stick_in", "-5"), "-5 lies outside -4.8..4.8 in");
  check_states_refused(folder, with("pedal_in", "2.6"), "2.6 lies outside -2.5..2.5 in");
  check_states_refused(folder, with("elevator_increment_deg", "29"), "29 lies outside -28.647889756");
  check_states_refused(folder, with("gust_u_mps", "51"), "51 lies outside -50..50 m/s");
  const std::string trim = run_tiltrotor("trim --speed 40").out;
  check_states_refused(folder, edited(trim, 0, "long_stick_in", "9.7"), "9.7 lies outside 0..9.6 in");

  const std::string beyond = run_tiltrotor("trim --mast 60 --speed 0").out;
  CHECK_LT(CsvText(beyond).number(0, "long_stick_in"), 0.0);
  CHECK_EQ(run_tiltrotor("loads --states " + folder.write("beyond.csv", beyond)).exit_status, 0);
  check_states_refused(folder, edited(beyond, 0, "limits", "elevator"), "lies outside 0..9.6 in");
}

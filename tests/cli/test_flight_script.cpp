// Scripts of flights and series of inputs.
// Expected: what stands in the text of the script, converted by the definitions of the units (1 kt = 0.514 444 4 m/s as in
// the tables, 1 rpm = pi/30 rad/s, 1 ft = 0.3048 m); ranges of the aircraft; linear interpolation by hand.
#include <algorithm>
#include <cmath>
#include <set>

#include "check.hpp"
#include "cli/errors.hpp"
#include "cli/flight_script.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"
#include "text/number.hpp"
#include "tiltrotor/math/scalar.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

using namespace tiltrotor;
using namespace tiltrotor::cli;

namespace {

constexpr double kDegree = kRadPerDeg<double>;

FlightScript read(const check::ScratchFolder& folder, const std::string& text) {
  return read_flight_script(folder.write("script.txt", text));
}

// The event of one line.
ScriptEvent event_of(const std::string& command) {
  const check::ScratchFolder folder;
  return read(folder, "1.5 " + command + "\n2 end\n").events.front();
}

void check_refused(const std::string& text, const std::string& message,
                   const std::string& series = "time_s,pedal_in\n0,1\n") {
  const check::ScratchFolder folder;
  folder.write("inputs.csv", series);
  std::string found = "accepted";
  try {
    read(folder, text);
  } catch (const UsageError& error) {
    found = error.what();
  }
  const std::string expected = folder.path("") + message;
  if (!CHECK_EQ(found, expected)) NOTE(text);
  CHECK(found.find('\n') == std::string::npos);
}

// The message begins so; what follows is a long list.
void check_refused_with(const std::string& text, const std::string& beginning, const std::string& end) {
  const check::ScratchFolder folder;
  std::string found = "accepted";
  try {
    read(folder, text);
  } catch (const UsageError& error) {
    found = error.what();
  }
  const std::string expected = folder.path("") + beginning;
  CHECK_EQ(found.substr(0, expected.size()), expected);
  CHECK(found.size() > end.size() && found.substr(found.size() - end.size()) == end);
}

}  // namespace

// Every row by its example; every command has a row, every row another name, an explanation and its place in the help.
TEST(cli_script_takes_every_command) {
  const check::ScratchFolder folder;
  folder.write("inputs.csv", "time_s,pedal_in\n0,0\n1,0.5\n");
  std::set<ScriptCommand> seen;
  std::set<std::string> names;
  for (const ScriptRule& rule : script_rules()) {
    const std::string line = rule.name + " " + rule.example;
    const bool ends = rule.command == ScriptCommand::end;
    const FlightScript script = read(folder, "1 " + line + "\n" + (ends ? "" : "2 end\n"));
    CHECK(script.events[0].command == rule.command && script.events[0].line == 1 &&
          script.events[0].time == 1);
    CHECK_EQ(script.events[0].control, rule.control);
    CHECK_EQ(script.duration(), ends ? 1 : 2);
    CHECK(names.insert(rule.name).second);
    CHECK(!rule.does.empty());
    CHECK(script_help().find("  " + usage_text(rule)) != std::string::npos);
    seen.insert(rule.command);
    for (const ScriptArgument& argument : rule.arguments) {
      CHECK(script_help().find(argument.name + ": " + range_text(argument)) != std::string::npos ||
            argument.kind == ScriptArgument::Kind::file);
      CHECK(argument.low <= argument.high);
    }
    CHECK_LE(std::count_if(rule.arguments.begin(), rule.arguments.end(),
                           [](const ScriptArgument& a) {
                             return a.kind == ScriptArgument::Kind::number ||
                                    a.kind == ScriptArgument::Kind::whole;
                           }),
             4);
  }
  for (int command = 0; command <= static_cast<int>(ScriptCommand::end); ++command)
    CHECK(seen.count(static_cast<ScriptCommand>(command)) == 1);
}

TEST(cli_script_reads_numbers_in_their_units) {
  const LimitTables<double>& limits = aircraft_data<double>().limits;
  CHECK_NEAR(event_of("mast 37.5deg").number[0], 37.5, 1e-12);
  CHECK_NEAR(event_of("rotor 517").number[0], 517 * kPi<double> / 30, 1e-9);
  CHECK_NEAR(event_of("rotor 517rpm").number[0], 517 * kPi<double> / 30, 1e-9);
  CHECK_NEAR(event_of("rotor 54.1rad/s").number[0], 54.1, 1e-12);
  CHECK_NEAR(event_of("hold speed 40").number[0], 40, 1e-12);
  CHECK_NEAR(event_of("hold speed 80kt").number[0], 80 * 0.5144444, 1e-9);
  CHECK_NEAR(event_of("hold speed 4e1m/s").number[0], 40, 1e-12);
  CHECK_NEAR(event_of("hold height 100ft").number[0], 30.48, 1e-9);
  CHECK_NEAR(event_of("hold climb -600ft/min").number[0], -3.048, 1e-9);
  CHECK_NEAR(event_of("hold heading -90").number[0], -90 * kDegree, 1e-12);
  CHECK_NEAR(event_of("turn 3deg/s").number[0], 3 * kDegree, 1e-12);
  CHECK_NEAR(event_of("stick long -1.25in").number[0], -1.25, 1e-12);
  CHECK_NEAR(event_of("collective 12").number[0], 12 * kDegree, 1e-12);
  CHECK_EQ(event_of("throttle 0.4").count, 1u);
  const ScriptEvent both = event_of("throttle 0.4 0.6");
  CHECK(both.count == 2 && both.number[0] == 0.4 && both.number[1] == 0.6);
  const ScriptEvent gust = event_of("gust 1 -2 3 4.5");
  CHECK(gust.number[0] == 1 && gust.number[1] == -2 && gust.number[2] == 3 && gust.number[3] == 4.5);
  const ScriptEvent engine = event_of("engine 2 restart");
  CHECK(engine.number[0] == 2 && engine.word == 1);
  CHECK_EQ(event_of("governor pi").word, 2u);
  CHECK_EQ(event_of("turbulence 5 42").number[1], 42);
  CHECK_EQ(event_of("step pedal -0.5 2").control, kControlIndex.pedal);
  // The ends of a range belong to it, as they are shown.
  for (const ScriptRule& rule : script_rules()) {
    if (rule.arguments.size() != 1 || rule.arguments[0].kind != ScriptArgument::Kind::number) continue;
    for (std::size_t unit = 0; unit < rule.arguments[0].units.size(); ++unit) {
      const std::string range = range_text(rule.arguments[0], unit);
      const std::size_t dots = range.find("..");
      const std::string name = rule.arguments[0].units[unit].name;
      const ScriptEvent low = event_of(rule.name + " " + range.substr(0, dots) + name);
      const ScriptEvent high =
          event_of(rule.name + " " + range.substr(dots + 2, range.find(' ') - dots - 2) + name);
      CHECK_LE(rule.arguments[0].low, low.number[0]);
      CHECK_LE(high.number[0], rule.arguments[0].high);
      CHECK_NEAR(high.number[0], rule.arguments[0].high, 2e-3);
    }
  }
  CHECK_EQ(event_of("mast " + text::number_text(limits.mast_deg.high)).number[0], limits.mast_deg.high);
}

TEST(cli_script_reads_lines) {
  const check::ScratchFolder folder;
  const FlightScript script = read(
      folder,
      "\xef\xbb\xbf# a comment\r\n\r\n  0 \t mast   10 # and one\r\n#\n0.5 gear up\n0.5 spool\n3 end\n\n# last");
  if (!CHECK_EQ(script.events.size(), 4u)) return;
  CHECK_EQ(script.events[0].line, 3u);
  CHECK_EQ(script.events[1].line, 5u);
  CHECK(script.events[2].command == ScriptCommand::spool && script.events[2].time == 0.5);
  CHECK_EQ(script.where(script.events[3]), folder.path("script.txt") + ":7");
}

TEST_OF_XV15(cli_bad_scripts_are_refused_by_line) {
  const std::string end = "\n9 end\n";
  check_refused("0 mast 91" + end, "script.txt:1: mast ANGLE: '91' lies outside 0..90 deg");
  check_refused("\n# x\n0 mast -1" + end, "script.txt:3: mast ANGLE: '-1' lies outside 0..90 deg");
  check_refused("0 flap 80" + end, "script.txt:1: flap ANGLE: '80' lies outside 0..75 deg");
  check_refused("0 rotor 900rpm" + end,
                "script.txt:1: rotor SPEED: '900rpm' lies outside 190.986..763.943 rpm");
  check_refused("0 rotor 90rad/s" + end, "script.txt:1: rotor SPEED: '90rad/s' lies outside 20..80 rad/s");
  check_refused("0 hold speed 400kt" + end,
                "script.txt:1: hold speed SPEED: '400kt' lies outside 0..291.576 kt");
  check_refused("0 stick long 5" + end, "script.txt:1: stick long PLACE: '5' lies outside -4.8..4.8 in");
  check_refused("0 pedal 2.6in" + end, "script.txt:1: pedal PLACE: '2.6in' lies outside -2.5..2.5 in");
  check_refused("0 mast x" + end,
                "script.txt:1: mast ANGLE: 'x' is not a number, alone or with deg; give 0..90 deg");
  check_refused(
      "0 hold speed nan" + end,
      "script.txt:1: hold speed SPEED: 'nan' is not a number, alone or with m/s or kt; give 0..150 m/s");
  check_refused("0 brakes inf" + end, "script.txt:1: brakes PART: 'inf' is not a number; give 0..1");
  check_refused(
      "0 hold speed 3km/h" + end,
      "script.txt:1: hold speed SPEED: '3km/h' is not a number, alone or with m/s or kt; give 0..150 m/s");
  check_refused("0 mast" + end, "script.txt:1: mast ANGLE: is missing; give 0..90 deg");
  check_refused("0 mast 10 20" + end, "script.txt:1: '20' is one too many; give mast ANGLE");
  check_refused("0 gust 1 2 3" + end, "script.txt:1: gust DURATION: is missing; give 0.01..600 s");
  check_refused("0 engine 3 fail" + end, "script.txt:1: engine NUMBER: '3' is not a whole number in 1..2");
  check_refused("0 engine 1 stop" + end, "script.txt:1: engine EVENT: 'stop' is not one of fail or restart");
  check_refused("0 scas onn" + end,
                "script.txt:1: scas STATE: 'onn' (did you mean on?) is not one of on or off");
  check_refused(
      "0 hold sped 3" + end,
      "script.txt:1: hold: 'sped' (did you mean speed?) is not speed, height, climb, heading, track or "
      "position");
  check_refused("0 stick" + end, "script.txt:1: stick: give long or lat");
  check_refused_with("0 mats 3" + end,
                     "script.txt:1: unknown command 'mats' (did you mean mast?); give mast, flap,",
                     " spool or end");
  check_refused("4 spool\n3 end\n", "script.txt:2: time: 3 s lies before the 4 s of line 1; give 4..3600 s");
  check_refused("x spool" + end, "script.txt:1: time: 'x' is not a number; give 0..3600 s");
  check_refused("-1 spool" + end, "script.txt:1: time: -1 lies outside 0..3600 s");
  check_refused("1" + end, "script.txt:1: no command after the time; `tiltrotor fly --help` lists them");
  check_refused("1 spool\n2 end\n# fine\n3 spool\n", "script.txt:4: a command after the `end` in line 2");
  check_refused("1 spool\n",
                "script.txt:1: the script has no `end`; give TIME end, which says how long the flight is");
  check_refused(
      "1 sp\xff"
      "ool" +
          end,
      "script.txt:1: the text is not UTF-8");
  const check::ScratchFolder folder;
  const std::string none = folder.path("none.csv");
  check_refused("0 spool\n0 series " + none + end,
                "script.txt:2: series FILE: " + none + ": cannot be read: No such file or directory");
}

TEST(cli_script_reads_series) {
  const check::ScratchFolder folder;
  folder.write("inputs.csv", "pedal_in, time_s ,throttle_2\n1,0.5,0\n2,1.5,1\n0,2,0.5\n");
  const FlightScript script = read(folder, "0 series inputs.csv\n1 series inputs.csv held\n2 end\n");
  if (!CHECK_EQ(script.series.size(), 2u)) return;
  CHECK_EQ(script.events[1].series, 1u);
  const InputSeries &linear = script.series[0], &held = script.series[1];
  CHECK(!linear.is_held && held.is_held);
  CHECK(linear.input == std::vector<int>({kControlIndex.pedal, kFirstThrottle + 1}));
  for (const double t : {0.0, 0.5}) CHECK_EQ(value_at(linear, 0, t), 1);
  CHECK_NEAR(value_at(linear, 0, 0.75), 1.25, 1e-12);
  CHECK_NEAR(value_at(linear, 1, 1.25), 0.75, 1e-12);
  CHECK_NEAR(value_at(linear, 0, 1.75), 1, 1e-12);
  CHECK_EQ(value_at(linear, 1, 99), 0.5);
  CHECK_EQ(value_at(held, 0, 1.499), 1);
  CHECK_EQ(value_at(held, 0, 1.5), 2);
  CHECK_EQ(value_at(held, 0, 99), 0);
}

// Columns count as those of `trim`, the long stick from its rear stop; names of the model in its own units.
TEST(cli_script_series_count_from_the_zero_of_their_columns) {
  const check::ScratchFolder folder;
  const auto first = [&](const std::string& column, const std::string& number) {
    folder.write("inputs.csv", "time_s," + column + "\n0," + number + "\n");
    const InputSeries series = read(folder, "0 series inputs.csv\n2 end\n").series[0];
    return std::make_pair(series.input[0], series.value[0]);
  };
  const auto expected = [&](const std::string& column, double number, int input, double value) {
    const auto found = first(column, text::number_text(number));
    const bool right = CHECK_EQ(found.first, input) & CHECK_NEAR(found.second, value, 1e-12);
    if (!right) NOTE(column);
  };
  const Controls<int>& u = kControlIndex;
  const double travel = aircraft_data<double>().controls.long_travel;
  for (const double away : {-1.0, 0.0, 0.67, 1.0}) {
    expected("long_stick_in", travel * (1 + away), u.long_stick, travel * away);
    expected("long_stick_from_neutral_in", travel * away, u.long_stick, travel * away);
    expected("long_stick", travel * away, u.long_stick, travel * away);
  }
  expected("collective75_deg", 8, u.collective, 8 * kDegree);
  expected("collective", 0.1, u.collective, 0.1);
  expected("pedal", -0.5, u.pedal, -0.5);
  expected("elevator_increment_deg", 1, u.elevator, kDegree);
  expected("gust_u", 2, u.gust.x, 2);
  expected("gust_w_mps", -2, u.gust.z, -2);
  expected("throttle_L", 0.4, kFirstThrottle + 1, 0.4);
}

TEST_OF_XV15(cli_bad_scripts_with_bad_series_are_refused_by_line) {
  const std::string script = "0 series inputs.csv\n9 end\n";
  const auto refused = [&](const std::string& series, const std::string& message) {
    check_refused(script, message, series);
  };
  refused("time_s,pedal_in\n0,1\n1,\n", "inputs.csv:3: column pedal_in: a hole; give -2.5..2.5 in");
  refused("time_s,pedal_in\n0,nan\n",
          "inputs.csv:2: column pedal_in: 'nan' is not a finite number; give -2.5..2.5 in");
  refused("time_s,pedal_in\n0,3\n", "inputs.csv:2: column pedal_in: 3 lies outside -2.5..2.5 in");
  refused("time_s,long_stick_in\n0,9.7\n", "inputs.csv:2: column long_stick_in: 9.7 lies outside 0..9.6 in");
  refused("time_s,pedal_in\n0,1\n\n0,1\n",
          "inputs.csv:4: column time_s: 0 s does not come after the 0 s of the row above");
  refused("time_s,pedal_in\n2,1\n1,1\n",
          "inputs.csv:3: column time_s: 1 s does not come after the 2 s of the row above");
  refused("time_s,pedal_in\n0\n", "inputs.csv:2: 1 cells, but the header names 2 columns");
  refused("time_s,throttle_1\n0,1.5\n", "inputs.csv:2: column throttle_1: 1.5 lies outside 0..1.2");
  refused("pedal_in\n0\n", "inputs.csv:1: missing column time_s");
  refused("time_s,time_s\n0,0\n", "inputs.csv:1: columns 'time_s' and 'time_s' give the same quantity");
  refused("time_s,pedal_in\n", "inputs.csv: no rows below the header");
  refused("", "inputs.csv:1: no header line; give time_s and the inputs");
  const check::ScratchFolder folder;
  folder.write("inputs.csv", "time_s,pedl_in\n0,0\n");
  try {
    read(folder, script);
    CHECK(false);
  } catch (const UsageError& error) {
    const std::string found = error.what();
    CHECK(found.find("inputs.csv:1: unknown column 'pedl_in' (did you mean pedal_in?); give time_s, ") !=
          std::string::npos);
  }
}

// From the ground to the ground: every stage of the mission is in it, and its masts go from stop to stop.
TEST_OF_XV15(cli_script_of_the_mission) {
  const FlightScript script = read_flight_script(check::source_path("src/examples/mission.txt"));
  std::set<ScriptCommand> used;
  double most_mast = 0, last_mast = 90, lowest_rotor = 1000;
  for (const ScriptEvent& event : script.events) {
    used.insert(event.command);
    if (event.command == ScriptCommand::mast)
      last_mast = event.number[0], most_mast = std::max(most_mast, last_mast);
    if (event.command == ScriptCommand::rotor_speed) lowest_rotor = std::min(lowest_rotor, event.number[0]);
  }
  for (const ScriptCommand command :
       {ScriptCommand::spool, ScriptCommand::hold_height, ScriptCommand::hold_position,
        ScriptCommand::hold_speed, ScriptCommand::mast, ScriptCommand::rotor_speed, ScriptCommand::turn,
        ScriptCommand::gear, ScriptCommand::land})
    CHECK(used.count(command) == 1);
  CHECK(most_mast == 90 && last_mast == 0);
  CHECK_NEAR(lowest_rotor, 517 * kPi<double> / 30, 1e-9);
}

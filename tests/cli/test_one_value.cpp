// Ranges that messages state are true and whole: their ends are accepted, what lies beyond them is refused. A list
// where one value belongs, empty items and options that contradict each other are told as what they are.
// Expected: the range that the message itself states.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "check.hpp"
#include "cli/refused.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"
#include "this_aircraft.hpp"

using check::check_refused;
using check::run_tiltrotor;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// An option of a command; @ is where its value stands.
struct Ranged {
  const char* line;
  const char* outside;  // a value for which the range is told
};

const Ranged ranged[] = {
    {"trim --mast @ --speed 100", "1e6"},
    {"trim --speed @ --mast 90", "1e6"},
    {"trim --climb @ --speed 40", "1e6"},
    {"trim --sideslip @ --speed 40", "1e6"},
    {"trim --turn-rate @ --speed 40", "1e6"},
    {"trim --azimuth @ --speed 5 --grid realtime", "1e6"},
    {"trim --isa-offset @", "1e6"},
    {"trim --altitude @", "1e6"},
    {"trim --mass @", "1e6"},
    {"trim --cg-sl @", "1e6"},
    {"trim --flap @", "1e6"},
    {"trim --rotor-rpm @", "1e6"},
    {"trim --option hub_spring_factor=@", "1e6"},
    {"trim --option induced_power_factor=@", "1e6"},
    {"respond --duration @ --dt 0.1 --grid realtime --speed 40", "1e6"},
    {"respond --dt @ --duration 0.1", "1e6"},
    {"respond --modes-every @ --dt 0.1 --duration 0.1", "1e6"},
    {"respond --speed 40 --duration 0.1 --input pedal=@@0..0.01", "1e6"},
    {"respond --speed 40 --duration 0.1 --input gust_w=@@0..0.01", "1e6"},
    {"respond --speed 40 --duration 0.1 --input elevator=@@0..0.01", "1e6"},
    {"respond --speed 40 --duration 0.1 --input elevator=@rad@0..0.01", "1e6"},
    {"respond --speed 40 --duration 0.1 --input collective=@@0..0.01", "1e6"},
    {"rotor --collective75 @", "1e6"},
    {"rotor --collective75 8 --rpm @", "1e6"},
    {"rotor --collective75 8 --speed-axial @", "1e6"},
    {"rotor --collective75 8 --speed-inplane @", "1e6"},
    {"rotor --collective75 8 --lateral-cyclic @", "1e6"},
    {"rotor --collective75 8 --long-cyclic @", "1e6"},
};

std::string with(std::string line, const std::string& value) {
  return line.replace(line.find('@'), 1, value);
}

std::string exactly(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

// Whether the value is outside a range of the option: another refusal, of the flight, does not count.
bool lies_outside(const std::string& line) { return contains(run_tiltrotor(line).err, " lies outside "); }

}  // namespace

TEST(cli_bad_ranges_in_messages_are_true) {
  for (const Ranged& one : ranged) {
    const std::string message = run_tiltrotor(with(one.line, one.outside)).err;
    const std::size_t at = message.find(" lies outside ");
    const std::size_t dots = message.find("..", at);
    if (!CHECK(at != std::string::npos && dots != std::string::npos)) {
      NOTE(one.line << ": " << message);
      continue;
    }
    const std::string low = message.substr(at + 14, dots - at - 14);
    const std::string high = message.substr(dots + 2, message.find_first_of(" \n", dots) - dots - 2);
    const double infinity = HUGE_VAL;
    // A flight of an hour is not flown here.
    const bool is_long = contains(one.line, "--duration @");
    if (!CHECK(!lies_outside(with(one.line, low)))) NOTE(one.line << " at " << low);
    if (!is_long && !CHECK(!lies_outside(with(one.line, high)))) NOTE(one.line << " at " << high);
    if (!CHECK(lies_outside(with(one.line, exactly(std::nextafter(std::stod(low), -infinity))))))
      NOTE(one.line << " below " << low);
    if (!CHECK(lies_outside(with(one.line, exactly(std::nextafter(std::stod(high), infinity))))))
      NOTE(one.line << " above " << high);
  }
}

TEST(cli_bad_stations_and_shards_state_all_that_is_accepted) {
  for (const char* few : {"1", "2", "-1", "73", "3.5"})
    check_refused(std::string("trim --option azimuth_stations=") + few,
                  std::string("'") + few + "' is not a whole number in 0 or 3..72");
  for (const char* good : {"0", "3", "72"})
    CHECK_EQ(run_tiltrotor(std::string("trim --speed 20 --option azimuth_stations=") + good).exit_status, 0);
  for (const char* wrong : {"0", "5"})
    check_refused(std::string("trim --option grid_refinement=") + wrong, "is not a whole number in 1..4");
  for (const char* good : {"1", "4"})
    CHECK_EQ(run_tiltrotor(std::string("trim --speed 20 --option grid_refinement=") + good).exit_status, 0);
}

TEST(cli_bad_list_where_one_value_belongs) {
  for (const std::string option :
       {"loads --rotor-rpm", "loads --isa-offset", "performance --wheel-height", "loads --altitude",
        "loads --mass", "loads --cg-sl", "loads --flap", "respond --duration", "respond --dt",
        "respond --modes-every", "rotor --lateral-cyclic", "rotor --long-cyclic", "rotor --mast"}) {
    check_refused(option + " 1,2", "'1,2' is not a number; give ");
    check_refused(option + " 1,2", "; one value, not a list");
    check_refused(option + " 0:1:5", "; one value, not a range");
  }
  check_refused("trim --option hub_spring_factor=1,2", "one value, not a list");
  check_refused("trim --option azimuth_stations=6,12", "one value, not a list");
  check_refused("respond --input pedal=1,2@0", "one value, not a list");
  check_refused("respond --input pedal=1@0,1", "one value, not a list");
  check_refused("performance --wheel-height one,two", "'one,two' is not a number; give 0..100 m\n");
}

TEST(cli_bad_list_with_an_empty_item) {
  for (const char* list : {"1,,2", "1,", ",1", ","})
    for (const char* option : {"trim --speed ", "modes --altitude ", "rotor --collective75 "})
      check_refused(std::string(option) + list, std::string("an item of '") + list + "' is empty");
  for (const char* range : {"0::5", ":1:5", "0:1:", "::"})
    check_refused(std::string("trim --speed ") + range, std::string("a part of '") + range + "' is empty");
}

TEST(cli_bad_cyclic_beside_cancel_tilt) {
  check_refused("rotor --cancel-tilt --lateral-cyclic 3", "--lateral-cyclic: --cancel-tilt finds the cyclic");
  check_refused("rotor --long-cyclic=-1 --cancel-tilt", "--long-cyclic: --cancel-tilt finds the cyclic");
  CHECK_EQ(run_tiltrotor("rotor --collective75 8 --cancel-tilt --speed-inplane 20").exit_status, 0);
}

TEST(cli_bad_control_set_without_matrices) {
  check_refused("respond --speed 40 --control-set all", "--control-set: of the columns of --matrices");
}

// A value that reads like its bound is told with the digits that tell them apart.
TEST(cli_bad_values_next_to_their_bound_are_told_apart) {
  const tiltrotor::LimitTables<double>& limits = this_aircraft::numbers().limits;
  const auto decimals = [](double value, int digits) {
    char text[40];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return std::string(text);
  };
  const std::string most = decimals(std::floor(limits.speed), 10);  // as it is offered
  const std::string speed = decimals(std::stod(most) + 1e-8, 11);
  check_refused("trim --speed " + speed, speed + " lies outside 0.." + most + " m/s");
  const std::string gust = decimals(limits.gust + 1e-7, 9);
  check_refused("respond --speed 40 --input gust_u=" + gust + "@0", "would be " + gust + " m/s at 0 s");
  const std::string half = decimals(limits.gust / 2, 7);
  const double rest = limits.gust - std::stod(half) + 1e-5;
  check_refused("respond --speed 40 --input gust_u=" + half + "@0 --input gust_u=" + decimals(rest, 7) + "@1",
                "would be " + decimals(std::stod(half) + std::stod(decimals(rest, 7)), 7) + " m/s at 1 s");
}

// Bad usage: one line that says what, where and what is possible instead; exit status 2; nothing on stdout.
#include <algorithm>

#include "check.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"

using check::run_tiltrotor;
using check::ScratchFolder;

namespace {

struct BadUsage {
  const char* arguments;
  const char* message;  // part of the line
};

void check_refused(const std::string& arguments, const std::string& message) {
  const check::ProgramResult result = run_tiltrotor(arguments);
  const bool passed = result.exit_status == 2 && result.out.empty() &&
                      std::count(result.err.begin(), result.err.end(), '\n') == 1 &&
                      result.err.compare(0, 11, "tiltrotor: ") == 0 &&
                      result.err.find(message) != std::string::npos;
  if (!CHECK(passed)) NOTE(arguments << ": exit " << result.exit_status << ", stderr: " << result.err);
}

// A complete states file, its header and one row apart.
struct States {
  std::string header =
      "case,mast_deg,u,v,w,p,q,r,phi,theta,psi,b1c_R,b1s_R,db1c_R,db1s_R,n0_R,nc_R,ns_R,"
      "b1c_L,b1s_L,db1c_L,db1s_L,n0_L,nc_L,ns_L,eps,th75_rad,lon_in,lat_in,ped_in";
  std::string row = "a,30,50,0,2,0,0,0,0,0.05,0,0,0,0,0,0.01,0,0,0,0,0,0,0.01,0,0,0.08,0.18,1,0,0";
  std::string text() const { return header + "\n" + row + "\n"; }
  States& replace(std::string States::*part, const std::string& from, const std::string& to) {
    std::string& target = this->*part;
    target.replace(target.find(from), from.size(), to);
    return *this;
  }
};

void check_file_refused(const ScratchFolder& folder, const std::string& text, const std::string& message) {
  const std::string path = folder.write("states.csv", text);
  check_refused("derivative --states " + path, path + message);
  check_refused("loads --states " + path, path + message);
}

}  // namespace

TEST(cli_bad_usage_is_one_line_and_status_2) {
  const BadUsage cases[] = {
      {"", "a command is needed; choose trim"},
      {"fly", "unknown command 'fly'; choose trim"},
      {"trim --wings 3", "unknown option --wings; options are --mast"},
      {"trim 3", "unexpected argument '3'"},
      {"trim --speed", "--speed: a value MPS must follow"},
      {"trim --speed 1 --speed 2", "--speed: given more than once"},
      {"trim --speed fast", "--speed: 'fast' is not a number; give 0..150 m/s"},
      {"trim --speed 10x", "'10x' is not a number"},
      {"trim --speed ''", "'' is not a number"},
      {"trim --speed +-3", "'+-3' is not a number"},
      {"trim --speed +", "'+' is not a number"},
      {"trim --speed nan", "'nan' is not a finite number; give 0..150 m/s"},
      {"trim --speed inf", "'inf' is not a finite number"},
      {"trim --speed=-inf", "'-inf' is not a finite number"},
      {"trim --speed 1e999", "beyond the range"},
      {"trim --mast 95", "--mast: 95 lies outside 0..90 deg"},
      {"trim --mast -1", "--mast: -1 lies outside 0..90 deg"},
      {"trim --mast 0:30:120", "120 lies outside 0..90 deg"},
      {"trim --speed -5", "--speed: -5 lies outside 0..150 m/s"},
      {"trim --speed 151", "--speed: 151 lies outside 0..150 m/s"},
      {"modes --speed 1000", "1000 lies outside 0..150 m/s"},
      {"trim --speed 50:5:0", "range '50:5:0' is empty"},
      {"trim --speed 0:0:10", "step of range '0:0:10' is zero"},
      {"trim --speed 0:5", "'0:5' is not a range; write from:step:to"},
      {"trim --speed 0:1e-9:100", "has more than"},
      {"trim --mast 0:0.002:90 --speed 0:0.002:150", "trim: more than 1000000 combinations"},
      {"trim --speed 0:0.002:150,0:0.002:150", "--speed: the list has more than 100000 values"},
      {"rotor --collective75 0:0.01:90 --speed-axial 0:0.1:150", "rotor: more than 1000000 combinations"},
      {"trim --altitude 20000", "--altitude: 20000 lies outside -500..11000 m"},
      {"trim --mass 1", "--mass: 1 lies outside 3000..10000 kg"},
      {"trim --cg-sl 0", "--cg-sl: 0 lies outside"},
      {"trim --rotor-rpm 0", "--rotor-rpm: 0 lies outside"},
      {"trim --climb 91", "--climb: 91 lies outside -90..90 deg"},
      {"trim --flap 30", "--flap: '30' is not one of 0, 20, 40 or 75"},
      {"trim --tables cubic", "--tables: 'cubic' is not one of c1 or linear"},
      {"trim --grid fine", "--grid: 'fine' is not one of specification or realtime"},
      {"trim --option wash", "not NAME=VALUE"},
      {"trim --option paint=red", "no switch 'paint'; choose tables"},
      {"trim --option wash=red", "'red' is not one of constant or vortex_cylinder"},
      {"trim --option azimuth_stations=2", "'2' is not a whole number in 3..72"},
      {"trim --format xml", "--format: 'xml' is not one of table, csv or json"},
      {"linearize --format xml", "'xml' is not one of table, csv, json or matlab"},
      {"linearize --control-set some", "'some' is not one of inceptors, blades or all"},
      {"linearize --reduce all", "'all' is not one of none or rigid"},
      {"trim --shard 3/2", "--shard 3/2: '3' is not a whole number in 1..2"},
      {"trim --shard 0/2", "'0' is not a whole number in 1..2"},
      {"trim --shard 1/0", "'0' is not a whole number in 1.."},
      {"trim --shard half", "'half' is not k/n with 1 <= k <= n"},
      {"trim --shard 1/2 --format json", "--format csv only"},
      {"trim --output /nonexistent/folder/file.csv", "--output: cannot write /nonexistent/folder/file.csv"},
      {"trim --output /tmp", "/tmp is a folder"},
      {"report --output /proc/none", "--output: cannot create folder /proc/none"},
      {"respond --matrices /proc/none", "--matrices: cannot create folder /proc/none"},
      {"respond --speed 10,20", "take one value each"},
      {"respond --dt 0", "--dt: 0 lies outside"},
      {"respond --duration -1", "--duration: -1 lies outside 0..3600 s"},
      {"respond --duration 3600 --dt 0.0001", "--duration: more than 1e+06 steps of 1e-04 s"},
      {"respond --input pedal=1@0 --input pedal=1@0 --input pedal=1@0 --input pedal=1@0 --input pedal=1@0 "
       "--input pedal=1@0 --input pedal=1@0 --input pedal=1@0 --input pedal=1@0",
       "--input: at most 8 inputs"},
      {"linearize --speed 10 --shard 1/2 --format json", "parts can be joined with --format csv only"},
      {"trim --option coning_states=maybe", "'maybe' is not one of on or off"},
      {"respond --method euler", "'euler' is not one of rk3, rk4 or rodas3"},
      {"respond --modes-every 0.001", "--modes-every: 0.001 lies outside 0.005..3600 s"},
      {"respond --input collective", "not NAME=AMPLITUDE[UNIT]@START[..END][:SHAPE]"},
      {"respond --input collective=1deg", "not NAME=AMPLITUDE[UNIT]@START[..END][:SHAPE]"},
      {"respond --input brake=1@0", "no control 'brake'; choose collective"},
      {"respond --input collective=1in@0", "unit 'in' of collective is not deg or rad"},
      {"respond --input pedal=1deg@0", "unit 'deg' of pedal is not in"},
      {"respond --input collective=1.deg.@0", "is not a number"},
      {"respond --control-set some", "'some' is not one of inceptors, blades or all"},
      {"modes --reduce all", "'all' is not one of none or rigid"},
      {"respond --input collective=1deg@-1", "-1 lies outside 0..3600 s"},
      {"respond --input collective=1deg@2..1", "the end is not after the start"},
      {"respond --input collective=1deg@1..2:step", "a step has no end"},
      {"respond --input collective=1deg@1:doublet", "a doublet needs START..END"},
      {"respond --input collective=1deg@1..2:wave", "shape 'wave' is not step, pulse or doublet"},
      {"derivative", "--states FILE is needed"},
      {"derivative --states /nonexistent.csv", "/nonexistent.csv: cannot be read"},
      {"loads --states /tmp", "/tmp: cannot be read"},
      {"loads --states /dev/null", "/dev/null:1: no header line"},
      {"rotor --collective75 91", "--collective75: 91 lies outside -90..90 deg"},
      {"rotor --rpm 0", "--rpm: 0 lies outside 200..760 rpm"},
      {"rotor --cancel-tilt=1", "--cancel-tilt: takes no value"},
      {"version --mast 3", "unknown option --mast; the command takes no options"},
  };
  for (const BadUsage& bad : cases) check_refused(bad.arguments, bad.message);
}

TEST(cli_good_states_file_is_accepted) {
  const ScratchFolder folder;
  const States good;
  CHECK_EQ(run_tiltrotor("derivative --states " + folder.write("states.csv", good.text())).exit_status, 0);
  std::string windows_lines;
  for (const char c : good.text()) windows_lines += c == '\n' ? std::string("\r\n") : std::string(1, c);
  CHECK_EQ(run_tiltrotor("derivative --states " + folder.write("states.csv", windows_lines + "\r\n")).out,
           run_tiltrotor("derivative --states " + folder.write("states.csv", good.text())).out);
}

TEST(cli_bad_states_file_is_named_with_line) {
  const ScratchFolder folder;
  const auto header = [](const char* from, const char* to) {
    return States().replace(&States::header, from, to).text();
  };
  const auto row = [](const char* from, const char* to) {
    return States().replace(&States::row, from, to).text();
  };
  check_file_refused(folder, header(",theta", ",theta2"), ":1: unknown column 'theta2'");
  check_file_refused(folder, header(",psi,", ",theta,"), ":1: column 'theta' stands there twice");
  States missing;
  missing.replace(&States::header, ",ped_in", "").replace(&States::row, ",1,0,0", ",1,0");
  check_file_refused(folder, missing.text(), ":1: missing column ped_in");
  check_file_refused(folder, row("50", "fast"), ":2: column u: 'fast' is not a number");
  check_file_refused(folder, row("50", ""), ":2: column u: '' is not a number");
  check_file_refused(folder, row("50", "nan"), ":2: column u: 'nan' is not a finite number");
  check_file_refused(folder, row("50", "inf"), ":2: column u: 'inf' is not a finite number");
  check_file_refused(folder, row(",30,", ",91,"), ":2: column mast_deg: 91 lies outside 0..90 deg");
  check_file_refused(folder, row(",50,0,", ",50,"), ":2: 29 cells, but the header names 30 columns");
  check_file_refused(folder, row(",50,0,", ",50,0,0,"), ":2: 31 cells, but the header names 30 columns");
  check_file_refused(folder, States().text() + States().row + ",\n", ":3: 31 cells");
  check_file_refused(folder, States().header + "\n", ": no states below the header");
  const std::string path = folder.write("states.csv", States().text());
  check_refused("derivative --mast 30 --states " + path, "has its own column mast_deg");
  check_refused("loads --speed 30 --states " + path, "--speed: cannot be combined with --states");
  check_refused("derivative --option coning_states=on --states " + path,
                ":1: missing column b0_R db0_R b0_L db0_L");
}

TEST(cli_bad_usage_leaves_no_file) {
  const ScratchFolder folder;
  const std::string file = folder.path("out.csv");
  check_refused("trim --mast 95 --output " + file, "--mast");
  check_refused("trim --shard 3/2 --output " + file, "--shard");
  check_refused("trim --format xml --output " + file, "--format");
  check_refused("linearize --reduce all --output " + file, "--reduce");
  check_refused("respond --input x --output " + file, "--input");
  check_refused("derivative --states /nonexistent.csv --output " + file, "cannot be read");
  check_refused("rotor --collective75 91 --output " + file, "--collective75");
  CHECK_EQ(folder.files(), 0);
}

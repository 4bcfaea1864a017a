// Bad usage: one line that says what, where and what is possible instead; exit status 2; nothing on stdout.
// Expected: messages as the user reads them, ranges of the C header.
#include <algorithm>

#include "check.hpp"
#include "cli/refused.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"

using check::check_refused;
using check::run_tiltrotor;
using check::ScratchFolder;

namespace {

struct BadUsage {
  const char* arguments;
  const char* message;  // part of the line
};

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

TEST_OF_XV15(cli_bad_usage_is_one_line_and_status_2) {
  const BadUsage cases[] = {
      {"", "a command is needed; choose trim"},
      {"glide", "unknown command 'glide'; choose trim"},
      {"fly", "--script: is missing; give a file"},
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
      {"trim --flap 76", "--flap: 76 lies outside 0..75 deg"},
      {"modes --flap 20:10:80", "80 lies outside 0..75 deg"},
      {"loads --flap 20,40", "--flap: '20,40' is not a number; give 0..75 deg"},
      {"trim --tables cubic", "--tables: 'cubic' is not one of c1, linear or c2"},
      {"trim --grid fine", "--grid: 'fine' is not one of specification or realtime"},
      {"trim --option wash", "not NAME=VALUE"},
      {"trim --option paint=red", "no switch 'paint'; choose tables"},
      {"trim --option wash=red", "'red' is not one of constant or vortex_cylinder"},
      {"trim --option azimuth_stations=2", "'2' is not a whole number in 0 or 3..72"},
      {"trim --format xml", "--format: 'xml' is not one of table, csv or json"},
      {"linearize --format xml", "'xml' is not one of table, csv, json or matlab"},
      {"linearize --control-set some", "'some' is not one of inceptors, blades or all"},
      {"linearize --reduce all", "'all' is not one of none, rigid or quasi_steady"},
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
      {"trim --option coning_states=maybe", "'maybe' is not one of off or on"},
      {"respond --method euler", "'euler' is not one of rk3, rk4, rodas3 or exponential"},
      {"respond --modes-every 0.001", "--modes-every: 0.001 lies outside 0.005..3600 s"},
      {"respond --input collective", "not NAME=AMPLITUDE[UNIT]@START[..END][:SHAPE]"},
      {"respond --input collective=1deg", "not NAME=AMPLITUDE[UNIT]@START[..END][:SHAPE]"},
      {"respond --input brake=1@0", "no control 'brake'; choose collective"},
      {"respond --input collective=1in@0", "unit 'in' of collective is not deg or rad"},
      {"respond --input pedal=1deg@0", "unit 'deg' of pedal is not in"},
      {"respond --input collective=1.deg.@0", "is not a number"},
      {"respond --control-set some", "'some' is not one of inceptors, blades or all"},
      {"modes --reduce all", "'all' is not one of none, rigid or quasi_steady"},
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
      {"rotor --rpm 0", "--rpm: 0 lies outside 191..763 rpm"},
      {"rotor --cancel-tilt=1", "--cancel-tilt: takes no value"},
      // Ranges of inputs are those of tr_set_controls, told from the command line alone or with the trim.
      {"respond --input collective=1000deg@0", "collective=1000deg@0: 1000 lies outside -100.267"},
      {"respond --input pedal=-6@0", "pedal=-6@0: -6 lies outside -5..5 in"},
      {"respond --input gust_w=1e5@0", "1e5 lies outside -100..100 mps"},
      {"respond --input elevator=1.2rad@0", "elevator=1.2rad@0: 1.2 lies outside -1..1 rad"},
      {"respond --speed 40 --input pedal=1.5@0 --input pedal=1.5@1..2",
       "pedal would be 3 in from neutral at 1 s (0 in from neutral in trim), outside -2.5..2.5"},
      {"respond --speed 40 --input gust_u=51@0",
       "gust_u would be 51 m/s at 0 s (0 m/s in trim), outside -50..50 m/s"},
      {"respond --speed 40 --input long_stick=3@0..2:doublet --input long_stick=-3@1",
       "long_stick would be "},
      // The nearest name.
      {"trmi", "unknown command 'trmi' (did you mean trim?); choose trim"},
      {"linearise", "(did you mean linearize?)"},
      {"trim --sped 3", "unknown option --sped (did you mean --speed?); options are"},
      {"trim -speed 3", "unexpected argument '-speed' (did you mean --speed?)"},
      {"trim speed=3", "unexpected argument 'speed=3' (did you mean --speed?)"},
      {"trim --cg_sl 300", "(did you mean --cg-sl?)"},
      {"trim --grid realtme", "'realtme' (did you mean realtime?) is not one of"},
      {"trim --option gird=realtime", "no switch 'gird' (did you mean grid?); choose tables"},
      {"trim --option coning_state=on", "(did you mean coning_states?)"},
      {"trim --option coning_states=om", "'om' (did you mean on?) is not one of off or on"},
      {"trim --format jsn", "'jsn' (did you mean json?)"},
      {"respond --method rk5", "'rk5' (did you mean rk3?)"},
      {"respond --input colective=1@0", "no control 'colective' (did you mean collective?)"},
      {"respond --input pedal=1@0..1:doublt", "shape 'doublt' (did you mean doublet?)"},
      {"respond --input gust_u=1m@0", "unit 'm' of gust_u is not mps"},
      {"respond --input collective=nan@0", "'nan' is not a finite number; give -100.267"},
      {"respond --input collective=deg@0", "'deg' is not a number; give -100.267"},
      {"respond --input collective=1e999@0",
       "'1e999' is beyond the range of floating-point numbers; give -100"},
      // One thing said twice.
      {"trim --grid realtime --option grid=realtime",
       "grid is given more than once; --grid stands there too"},
      {"trim --option tables=c1 --tables linear",
       "tables is given more than once; --tables stands there too"},
      {"trim --option wash=constant --option wash=constant",
       "--option wash=constant: wash is given more than once"},
      {"trim --format csv --format=json", "--format: given more than once"},
      // Places of results, before anything is computed.
      {"trim --output ''", "--output: the name is empty; give a file, or - for standard output"},
      {"linearize --output=", "--output: the name is empty"},
      {"report --output ''", "--output: the name is empty; give a folder"},
      {"respond --matrices ''", "--matrices: the name is empty; give a folder"},
      {"trim --output /dev/null/x", "--output: cannot write /dev/null/x"},
      // Odd numbers and words.
      {"trim --speed 0x10", "'0x10' is not a number"},
      {"trim --speed 1e999", "'1e999' is beyond the range of floating-point numbers; give 0..150 m/s"},
      {"trim --speed 40,", "'' is not a number"},
      {"trim --speed ,", "'' is not a number"},
      {"trim --speed '1;5'", "'1;5' is not a number"},
      {"loads --altitude 1,5", "'1,5' is not a number"},
      {"trim --speed 0:1e-300:150", "has more than 100000 values"},
      {"trim --speed 0:nan:5", "'nan' is not a finite number"},
      {"trim --shard 1/1e9", "is not a whole number"},
      {"trim --shard 1/2/3", "is not k/n"},
      {"trim --shard -1/3", "'-1' is not a whole number in 1..3"},
      {"trim 'a\nb'", "unexpected argument 'a?b'"},
      {"trim --speed '1\n2'", "'1?2' is not a number"},
      {"version --mast 3", "unknown option --mast; the command takes no options"},
  };
  for (const BadUsage& bad : cases) check_refused(bad.arguments, bad.message);
}

// A full stick is inside the range although the trim leaves it at 1e-15.
TEST(cli_good_inputs_reach_the_stops) {
  for (const char* input : {"lat_stick=4.8@0", "pedal=-2.5@0", "gust_v=50@0", "elevator=0.5rad@0"})
    CHECK_EQ(run_tiltrotor(std::string("respond --speed 40 --duration 0.02 --input ") + input).exit_status,
             0);
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
  // Found with the trim, before the first row.
  check_refused("respond --speed 40 --input gust_u=51@0 --output " + file, "gust_u would be 51 m/s");
  check_refused("respond --speed 40 --output " + folder.path("m/a.csv") + " --matrices " + folder.path("m"),
                "a.csv");
  check_refused(
      "respond --speed 40 --output " + folder.write("a.csv", "") + " --matrices " + folder.path("."),
      "a.csv is written twice in one run");
  CHECK_EQ(folder.read("a.csv"), "");
  // A file that is not there yet, by two names.
  check_refused("respond --speed 40 --output " + folder.path("./b.csv") + " --matrices " + folder.path("."),
                "b.csv is written twice in one run");
}

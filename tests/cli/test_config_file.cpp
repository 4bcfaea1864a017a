// Options from a file. Expected: what the same options give on the command line; refusals by file and line.
#include <string>

#include "check.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"

using check::run_tiltrotor;

namespace {

void check_refused(const std::string& text, const std::string& message) {
  const check::ScratchFolder folder;
  const std::string file = folder.write("flight.conf", text);
  const check::ProgramResult result = run_tiltrotor("trim --config " + file);
  CHECK_EQ(result.exit_status, 2);
  CHECK_EQ(result.out, "");
  CHECK_EQ(result.err, "tiltrotor: trim: " + file + message + "\n");
}

}  // namespace

TEST(cli_config_is_as_good_as_the_command_line) {
  const check::ScratchFolder folder;
  const std::string file = folder.write("flight.conf",
                                        "# a transition\n"
                                        "mast = 60\r\n"
                                        "\n"
                                        "--speed 60,70  # m/s\n"
                                        "grid=realtime\n"
                                        "\t format\tcsv\n"
                                        "option = wake_fade=off\n"
                                        "option wash=vortex_cylinder\n"
                                        "hold=power_kw=900\n"
                                        "free climb_deg\n"
                                        "columns = speed_mps, power_kw,climb_deg");
  const std::string given =
      "--speed 60,70 --grid realtime --format csv --option wake_fade=off --option wash=vortex_cylinder "
      "--hold power_kw=900 --free climb_deg --columns 'speed_mps, power_kw,climb_deg'";
  const check::ProgramResult from_file = run_tiltrotor("trim --config " + file);
  CHECK_EQ(from_file.err, "");
  CHECK_EQ(from_file.exit_status, 0);
  CHECK_EQ(from_file.out, run_tiltrotor("trim --mast 60 " + given).out);
}

TEST(cli_config_gives_way_to_the_command_line) {
  const check::ScratchFolder folder;
  const std::string file = folder.write(
      "flight.conf", "speed = 60\noption = wash=vortex_cylinder\noption = wake_fade=off\nformat = json\n");
  const std::string given = "--grid realtime --format csv --speed 40 ";
  CHECK_EQ(run_tiltrotor("trim " + given + "--config " + file).out,
           run_tiltrotor("trim " + given + "--option wash=vortex_cylinder --option wake_fade=off").out);
  CHECK_EQ(run_tiltrotor("trim --config " + file + " --option flapping=first " + given).out,
           run_tiltrotor("trim --option flapping=first " + given).out);
}

TEST(cli_config_has_flags_alone) {
  const check::ScratchFolder folder;
  const std::string file = folder.write("options", "cancel-tilt\nformat csv\n");
  const std::string rotor = "rotor --collective75 8 --speed-inplane 40 --grid realtime ";
  const check::ProgramResult result = run_tiltrotor(rotor + "--config " + file);
  CHECK_EQ(result.err, "");
  CHECK_EQ(result.out, run_tiltrotor(rotor + "--cancel-tilt --format csv").out);
}

TEST(cli_bad_config_is_refused_by_file_and_line) {
  const check::ScratchFolder folder;
  CHECK_EQ(run_tiltrotor("trim --config " + folder.path("none")).err,
           "tiltrotor: " + folder.path("none") + ": cannot be read: No such file or directory\n");
  check_refused("speed = 60\nspeed = 70\n", ":2: --speed: given more than once");
  check_refused("speed = 60\nmast\n", ":2: --mast: a value DEG must follow");
  check_refused("mast = sixty\n", ":1: --mast: 'sixty' is not a number; give 0..90 deg");
  check_refused("# none\n\nformat = cvs\n",
                ":3: --format: 'cvs' (did you mean csv?) is not one of table, csv or json");
  check_refused("config = other\n", ":1: --config: a file cannot name another");
  const std::string unknown = folder.write("unknown", "sped = 60\n");
  const std::string err = run_tiltrotor("trim --config " + unknown).err;
  CHECK_EQ(err.substr(0, err.find(';')),
           "tiltrotor: trim: " + unknown + ":1: unknown option --sped (did you mean --speed?)");
  const std::string empty = folder.write("empty", "= 60\n");
  CHECK_EQ(run_tiltrotor("trim --config " + empty).err,
           "tiltrotor: " + empty + ":1: no name before '='; write name = value\n");
  const std::string utf16 = folder.write("utf16", std::string("\xff\xfes\0", 4));
  CHECK_EQ(run_tiltrotor("trim --config " + utf16).err,
           "tiltrotor: " + utf16 + ":1: the file is UTF-16; save it as UTF-8\n");
}

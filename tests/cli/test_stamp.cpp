// --stamp. Expected: the same output without it, below the version and a command that makes the file again.
#include <string>

#include "check.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"

using check::run_program;
using check::run_tiltrotor;

namespace {

// The comment lines at the beginning, and the rest.
struct Stamped {
  std::string version, command, rest;
  explicit Stamped(const std::string& text) {
    const std::size_t first = text.find('\n'), second = text.find('\n', first + 1);
    version = text.substr(0, first);
    command = text.substr(first + 1, second - first - 1);
    rest = text.substr(second + 1);
  }
};

std::string version_line() {
  const std::string text = run_tiltrotor("version").out;
  return "# " + text.substr(0, text.find('\n'));
}

}  // namespace

TEST(cli_stamp_is_version_and_command_above_the_same_rows) {
  const check::ScratchFolder folder;
  const std::string config = folder.write("flight.conf", "grid realtime\ncolumns = speed_mps, pitch_deg\n");
  const std::string script = folder.write("script.txt", "0 hold speed 45\n0.1 end\n");
  for (const std::string& command :
       {"trim --mast 30 --speed 40,60 --config " + config + " --format csv",
        std::string("linearize --mast 90 --speed 100 --grid realtime --format csv"),
        std::string(
            "respond --mast 90 --speed 90 --input pedal=0.5in@0 --duration 0.1 --dt 0.1 --grid realtime "
            "--format csv"),
        std::string("trim --speed 40 --grid realtime --columns speed_mps,pitch_deg --format table"),
        "fly --script " + script + " --speed 40 --format csv"}) {
    const std::string plain = run_tiltrotor(command).out;
    const Stamped stamped(run_tiltrotor(command + " --stamp").out);
    CHECK_EQ(stamped.rest, plain);
    CHECK_EQ(stamped.version, version_line());
    CHECK_EQ(stamped.command.substr(0, 12), "# tiltrotor ");
    // The command alone, without the file of options, makes the rows again.
    CHECK_EQ(run_program(check::built("tiltrotor") + " " + stamped.command.substr(12)).out, plain);
  }
}

TEST(cli_stamp_is_once_in_shards_and_read_over_by_states) {
  const check::ScratchFolder folder;
  const std::string trim = "trim --mast 60:15:90 --speed 80 --grid realtime --format csv --stamp";
  const std::string whole = run_tiltrotor(trim).out;
  CHECK_EQ(run_tiltrotor(trim + " --shard 1/2").out + run_tiltrotor(trim + " --shard 2/2").out, whole);
  const std::string states = " --grid realtime --format csv --states ";
  const std::string stamped = folder.write("stamped.csv", whole),
                    plain = folder.write("plain.csv", Stamped(whole).rest);
  const check::ProgramResult result = run_tiltrotor("derivative" + states + stamped);
  CHECK_EQ(result.err, "");
  CHECK_EQ(result.exit_status, 0);
  CHECK_EQ(result.out, run_tiltrotor("derivative" + states + plain).out);
}

TEST(cli_stamp_is_in_files_beside_the_rows) {
  const check::ScratchFolder folder;
  const std::string flight = "respond --mast 90 --speed 90 --duration 0.1 --dt 0.1 --grid realtime --stamp ";
  CHECK_EQ(run_tiltrotor(flight + "--format csv --matrices " + folder.path(".")).exit_status, 0);
  for (const char* name : {"a.csv", "b.csv"}) CHECK_EQ(Stamped(folder.read(name)).version, version_line());
}

TEST(cli_stamp_keeps_an_input_series_readable) {
  const check::ScratchFolder folder;
  const std::string rows = "time_s,pedal_in\n0,0\n0.1,0.5\n";
  const std::string plain = folder.write("plain.csv", rows),
                    stamped = folder.write("stamped.csv", "# made\n" + rows);
  const auto flown = [&](const std::string& file) {
    return run_tiltrotor("fly --speed 40 --format csv --script " +
                         folder.write("script.txt", "0 series " + file + "\n0.2 end\n"));
  };
  CHECK_EQ(flown(stamped).err.substr(0, 10), flown(plain).err.substr(0, 10));
  CHECK_EQ(flown(stamped).out, flown(plain).out);
}

// In the comments of the language, in the place of the line that a script begins with in any case.
TEST(cli_stamp_begins_a_matlab_script) {
  const std::string command = "linearize --mast 90 --speed 100 --grid realtime --format matlab";
  const std::string plain = run_tiltrotor(command).out;
  const Stamped stamped(run_tiltrotor(command + " --stamp").out);
  CHECK_EQ(stamped.version, "%" + version_line().substr(1));
  CHECK_EQ(stamped.command.substr(0, 12), "% tiltrotor ");
  CHECK_EQ(stamped.version + "\n" + stamped.rest, plain);
  CHECK_EQ(run_program(check::built("tiltrotor") + " " + stamped.command.substr(12)).out, plain);
}

TEST(cli_bad_stamp_of_what_has_no_comments) {
  const check::ProgramResult result = run_tiltrotor("trim --stamp --format json");
  CHECK_EQ(result.exit_status, 2);
  CHECK_EQ(
      result.err,
      "tiltrotor: trim: --stamp: json has no place for comments, and tells its program anyway; choose csv or "
      "table\n");
}

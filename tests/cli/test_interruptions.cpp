// Runs that end early: interrupted, out of room, without a reader, in a folder that refuses, or two at once
// in one place. Each says so in one line with the right exit status; results of earlier runs stay, and
// nothing is left behind.
// Expected: exit statuses of POSIX shells, files as they were before.
#include <algorithm>
#include <filesystem>

#include "check.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"
#include "this_aircraft.hpp"

using check::built;
using check::ProgramResult;
using check::run_program;
using check::run_tiltrotor;
using check::ScratchFolder;
using this_aircraft::flown;

namespace {

const std::string program = built("tiltrotor");
const std::string long_sweep = " " + flown("trim --mast 0:1:90 --speed 0:0.5:145 --format csv");

// Starts a program, sends it a signal after a moment, and tells how it ended. (Not SIGINT: to it, shells
// start jobs in the background deaf.)
ProgramResult interrupted(const std::string& arguments, const std::string& signal,
                          const std::string& after = "0.3") {
  return run_program(program + arguments + " & child=$!; sleep " + after + "; kill -s " + signal +
                     " $child; wait $child; echo status $? >&2");
}

bool says(const ProgramResult& result, const std::string& text) {
  const bool found = result.err.find(text) != std::string::npos;
  if (!found) NOTE("stderr: " << result.err);
  return found;
}

// What the report compares with.
bool has_published_numbers() {
  const std::string folder = std::string("tables/") + tiltrotor::aircraft_identity().folder;
  return std::filesystem::exists(check::source_path(folder + "/published"));
}

bool is_one_line(const std::string& text) { return std::count(text.begin(), text.end(), '\n') == 1; }

}  // namespace

TEST(cli_interrupted_run_keeps_the_earlier_result) {
  const ScratchFolder folder;
  const std::string file = folder.write("trims.csv", "an earlier result\n");
  // TERM: a program started by nohup, as some runners do, is deaf to HUP.
  const ProgramResult result = interrupted(long_sweep + " --output " + file, "TERM");
  CHECK(says(result, "status 143\n"));
  CHECK(says(result, "tiltrotor: interrupted"));
  CHECK_EQ(folder.read("trims.csv"), "an earlier result\n");
  CHECK_EQ(folder.files(), 1);
  const ProgramResult killed = interrupted(long_sweep + " --output " + file, "KILL");
  CHECK(says(killed, "status 137\n"));
  CHECK_EQ(folder.read("trims.csv"), "an earlier result\n");  // not even this harms it
}

TEST_OF_XV15(cli_interrupted_report_keeps_the_earlier_report) {
  const ScratchFolder folder;
  folder.write("index.html", "an earlier report\n");
  const ProgramResult result = interrupted(" report --output " + folder.path(""), "TERM");
  CHECK(says(result, "status 143\n"));
  CHECK_EQ(folder.read("index.html"), "an earlier report\n");
  CHECK_EQ(folder.files(), 1);
}

TEST(cli_run_in_the_background_of_a_closed_terminal_goes_on) {
  const ProgramResult result =
      run_program("trap '' HUP; " + program + " " + flown("trim --speed 0:5:50 --format csv") +
                  " & child=$!; kill -s HUP $child; "
                  "wait $child; echo status $? >&2");
  CHECK(says(result, "status 0\n"));
}

TEST(cli_file_that_may_not_grow_is_reported) {
  const ScratchFolder folder;
  const std::string file = folder.write("trims.csv", "an earlier result\n");
  const ProgramResult result =
      run_program("ulimit -f 1; exec " + program + " trim --speed 0:1:50 --format csv --output " + file);
  CHECK_EQ(result.exit_status, 1);
  CHECK(says(result, "File too large"));
  CHECK_EQ(folder.read("trims.csv"), "an earlier result\n");
  CHECK_EQ(folder.files(), 1);

  const ProgramResult matrices = run_program("ulimit -f 1; exec " + program +
                                             " respond --speed 40 --duration 0.2 --dt 0.01 --matrices " +
                                             folder.path("m") + " --output " + file);
  CHECK_EQ(matrices.exit_status, 1);
  CHECK(says(matrices, "File too large"));
  CHECK_EQ(folder.read("trims.csv"), "an earlier result\n");
  CHECK(std::filesystem::is_empty(folder.path("m")));
}

TEST(cli_every_command_reports_a_full_disk_and_a_closed_pipe) {
  for (const char* command :
       {"trim --mast 90 --speed 60:1:90", "modes --mast 90 --speed 80",
        "linearize --mast 90 --speed 80 --format json", "respond --speed 40 --duration 0.5",
        "loads --mast 90 --speed 80", "rotor", "conventions", "version", "--help"}) {
    const ProgramResult full = run_tiltrotor(std::string(command) + " >/dev/full");
    const bool passed = full.exit_status == 1 && is_one_line(full.err) && says(full, "No space left");
    if (!CHECK(passed)) NOTE(command << ": exit " << full.exit_status);
    const ProgramResult closed = run_tiltrotor(std::string(command) + " >&-");
    if (!CHECK_EQ(closed.exit_status, 1)) NOTE(command);
  }
}

TEST(cli_folder_that_refuses_is_named) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder.path("closed"));
  std::filesystem::permissions(folder.path("closed"), std::filesystem::perms::owner_read);
  folder.write("file", "");
  // The superuser may write anywhere: for it a folder below a file refuses as well.
  const std::string refuses = geteuid() == 0 ? folder.path("file/below") : folder.path("closed/below");
  for (const std::string& arguments : {"trim --output " + refuses + "/x.csv", "report --output " + refuses,
                                       "respond --matrices " + refuses}) {
    const ProgramResult result = run_tiltrotor(arguments);
    CHECK_EQ(result.exit_status, 2);
    const bool has_nothing_to_compare = arguments.compare(0, 6, "report") == 0 && !has_published_numbers();
    CHECK(is_one_line(result.err) &&
          says(result, has_nothing_to_compare ? "no published numbers of this aircraft" : refuses));
  }
  std::filesystem::permissions(folder.path("closed"), std::filesystem::perms::owner_all);
}

TEST(cli_two_runs_with_one_file_leave_one_whole_result) {
  const ScratchFolder folder;
  const std::string sweep = " " + flown("trim --mast 0 --speed 0:0.5:50 --format csv");
  const std::string expected = run_program(program + sweep).out;
  const std::string file = folder.path("trims.csv");
  const ProgramResult result =
      run_program(program + sweep + " --output " + file + " & first=$!; " + program + sweep + " --output " +
                  file + "; second=$?; wait $first; echo $? $second");
  CHECK_EQ(result.out, "0 0\n");
  CHECK(folder.read("trims.csv") == expected);
  CHECK_EQ(folder.files(), 1);
}

TEST_OF_XV15(slow_cli_two_reports_in_one_folder_leave_one_whole_report) {
  const ScratchFolder folder;
  const std::string report = program + " report --output " + folder.path("both") + " >/dev/null 2>&1";
  const ProgramResult result =
      run_program(report + " & first=$!; " + report + "; second=$?; wait $first; echo $? $second");
  CHECK_EQ(result.out, "0 0\n");
  const std::string page = folder.read("both/index.html");
  CHECK(page.find("</html>") != std::string::npos);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path("both")))
    CHECK(entry.path().string().find(".part") == std::string::npos);
}

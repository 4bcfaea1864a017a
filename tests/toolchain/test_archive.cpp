// The archive of `make dist`. Expected: the files that git tracks, and the same bytes a second time, when git is told otherwise.
#include <string>

#include "check.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"

using check::quoted;
using check::run_program;
using check::source_path;

TEST(tools_dist_is_the_tracked_tree_and_reproducible) {
  const std::string here = "cd " + quoted(source_path("")) + " && ";
  const check::ProgramResult tracked =
      run_program(here + "test -e .git && git ls-tree -r --name-only HEAD | sort");
  if (tracked.exit_status != 0 || tracked.out.empty()) {
    NOTE("dist: no git tree, left out");
    return;
  }
  std::string first;
  for (int run = 0; run < 2; ++run) {
    const check::ScratchFolder folder;
    const std::string told = run == 0
                                 ? ""
                                 : "GIT_CONFIG_COUNT=3 GIT_CONFIG_KEY_0=tar.umask GIT_CONFIG_VALUE_0=0077 "
                                   "GIT_CONFIG_KEY_1=core.autocrlf GIT_CONFIG_VALUE_1=true "
                                   "GIT_CONFIG_KEY_2=core.attributesFile GIT_CONFIG_VALUE_2=" +
                                       quoted(folder.write("attributes", "*.md export-ignore\n")) + " ";
    const check::ProgramResult made = run_program(
        here + "env -u MAKEFLAGS -u MFLAGS -u MAKEOVERRIDES -u CXX -u BUILD -u TARGET -u CROSS_COMPILE " +
        told + "make --no-print-directory BUILD=" + quoted(folder.path("build")) + " dist");
    if (!CHECK_EQ(made.exit_status, 0)) NOTE(made.out << made.err);
    const std::string archive = quoted(folder.path("build")) + "/tiltrotor-" TILTROTOR_VERSION ".tar.gz";
    const std::string sum = run_program("cksum <" + archive).out;
    if (run == 0) {
      first = sum;
      CHECK_EQ(run_program("tar tzf " + archive + " | grep -v '/$' | sed 's,[^/]*/,,' | sort").out,
               tracked.out);
      CHECK_EQ(run_program("tar tzf " + archive + " | cut -d/ -f1 | sort -u").out,
               "tiltrotor-" TILTROTOR_VERSION "\n");
    }
    CHECK_EQ(sum, first);
    CHECK_EQ(run_program("ls " + quoted(folder.path("build"))).out,
             "tiltrotor-" TILTROTOR_VERSION ".tar.gz\n");
  }
}

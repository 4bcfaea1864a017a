// Goals of make whose tool is missing or of another version: one line that says which, and no failure.
// Expected: one line in the form of tests/tool.sh.
#include <algorithm>

#include "check.hpp"
#include "run_program.hpp"
#include "scratch_folder.hpp"

using check::ProgramResult;
using check::quoted;
using check::run_program;
using check::ScratchFolder;
using check::source_path;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

auto lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

// A machine without optional tools: what /usr/bin holds, less these.
void leave_out_tools(const ScratchFolder& folder) {
  run_program("cd " + quoted(folder.path("")) +
              " && ln -s /bin/* /usr/bin/* . 2>/dev/null; rm -f clang* *-clang* llvm* valgrind* qemu* "
              "arm-none-* cppcheck* "
              "aarch64-* riscv64-* arm-linux-*");
}

// `command` in the source tree, with that folder as, or before, the search path, and nothing inherited from a
// make around this test.
ProgramResult run_here(const ScratchFolder& folder, const std::string& command, bool alone) {
  return run_program(
      "cd " + quoted(source_path("")) + " && PATH=" + quoted(folder.path("")) +
      (alone ? std::string() : std::string(":$PATH")) +
      " env -u MAKEFLAGS -u MFLAGS -u MAKEOVERRIDES -u CXX -u BUILD -u TARGET -u CROSS_COMPILE " + command);
}

std::string make(const ScratchFolder& folder, const std::string& goal) {
  return "make --no-print-directory BUILD=" + quoted(folder.path("build")) + " " + goal;
}

// A program of a shell script.
void add_tool(const ScratchFolder& folder, const std::string& name, const std::string& script) {
  run_program("chmod +x " + quoted(folder.write(name, "#!/bin/sh\n" + script + "\n")));
}

// A compiler of version 99: what it builds writes a profile that only a tool which finds "99" in it reads.
void add_clang_99(const ScratchFolder& folder) {
  add_tool(folder, "clang++-99",
           "[ \"$1\" = --version ] && echo 'Debian clang version 99.1.0' && exit\n"
           "while [ $# -gt 1 ]; do [ \"$1\" = -o ] && printf '#!/bin/sh\\necho 99 >$LLVM_PROFILE_FILE\\n' "
           ">\"$2\" && "
           "chmod +x \"$2\"; shift; done");
}

const char* const reads_99 =
    "for file; do case $file in *.profraw) cp $file ${5:-/dev/null}; esac; done; exit 0";

}  // namespace

TEST(tools_missing_are_one_line_with_their_package) {
  const ScratchFolder folder;
  leave_out_tools(folder);
  const struct {
    const char *goal, *tool, *package;
  } goals[] = {{"coverage COVERAGE_CXX=clang++", "clang++", "clang"},
               {"budget", "arm-none-eabi-g++", "libstdc++-arm-none-eabi-newlib qemu-system-arm"},
               {"firmware", "arm-none-eabi-g++", "gcc-arm-none-eabi"},
               {"test-firmware", "qemu-system-arm", "qemu-system-arm"},
               {"bench-instructions CXX=g++", "valgrind", "valgrind"},
               {"format", "clang-format", "clang-format"}};
  for (const auto& [goal, tool, package] : goals) {
    const ProgramResult said = run_here(folder, make(folder, goal), true);
    CHECK_EQ(said.exit_status, 0);
    const std::string text = said.out + said.err;
    CHECK_EQ(lines(text), 1);
    CHECK(contains(text, "not installed"));
    CHECK(contains(text, tool));
    CHECK(contains(text, package));
  }
  const ProgramResult lint = run_here(folder, "tests/lint.sh -std=c++17 src/library/c_words.cpp", true);
  CHECK_EQ(lint.exit_status, 0);
  CHECK_EQ(lint.out,
           "lint: not installed: clang-tidy (Debian: clang-tidy), left out\n"
           "lint: not installed: cppcheck (Debian: cppcheck), left out\n");
}

TEST(tools_of_several_packages_are_named_together) {
  const ScratchFolder folder;
  const ProgramResult said =
      run_here(folder, "tests/tool.sh goal no-such-a pack sh dash no-such-b pack no-such-c:x.h other", false);
  CHECK_EQ(said.exit_status, 1);
  CHECK_EQ(said.out,
           "goal: not installed: no-such-a, no-such-b, <x.h> of no-such-c (Debian: pack other), left out\n");
  CHECK_EQ(run_here(folder, "tests/tool.sh goal sh dash", false).out, std::string());
}

TEST(tools_of_coverage_read_what_the_compiler_writes) {
  const ScratchFolder folder;
  add_clang_99(folder);
  // Tools of another version stand first in PATH, under the plain name.
  add_tool(folder, "llvm-profdata", "echo 'error: no profile can be merged' >&2; exit 1");
  add_tool(folder, "llvm-cov", "exit 1");
  const ProgramResult none = run_here(folder, "tests/coverage/tools.sh clang++-99 -O1", false);
  CHECK_EQ(none.exit_status, 1);
  CHECK_EQ(none.out, std::string());
  CHECK_EQ(
      none.err,
      "coverage: no llvm-profdata reads what clang++-99 99 writes (Debian: llvm-99), nothing measured\n");
  const ProgramResult goal = run_here(folder, make(folder, "coverage COVERAGE_CXX=clang++-99"), false);
  CHECK_EQ(goal.exit_status, 0);
  CHECK_EQ(goal.err, none.err);

  add_tool(folder, "llvm-profdata-99", reads_99);
  const ProgramResult half = run_here(folder, "tests/coverage/tools.sh clang++-99 -O1", false);
  CHECK_EQ(half.exit_status, 1);
  CHECK(contains(half.err, "no llvm-cov reads"));
  CHECK_EQ(lines(half.out + half.err), lines(half.out) + 1);

  add_tool(folder, "llvm-cov-99", "exit 0");
  const ProgramResult both = run_here(folder, "tests/coverage/tools.sh clang++-99 -O1", false);
  CHECK_EQ(both.exit_status, 0);
  CHECK(contains(both.out, "llvm-profdata-99\n"));
  CHECK(contains(both.out, "llvm-cov-99\n"));
  CHECK_EQ(both.err, std::string());
}

TEST(tools_of_a_wrong_version_are_one_line) {
  const ScratchFolder folder;
  add_tool(folder, "clang-tidy", "echo 'LLVM version 99.1.0'; [ \"$1\" = --version ]");
  add_tool(folder, "cppcheck", "exit 0");
  const ProgramResult lint = run_here(folder, "tests/lint.sh -std=c++17 src/library/c_words.cpp", false);
  CHECK_EQ(lint.exit_status, 0);
  CHECK_EQ(lines(lint.out), 2);
  CHECK(contains(lint.out, "lint: clang-tidy 99.1.0 cannot read a program of one line"));
  // A cross compiler without the headers of its C++ library.
  add_tool(folder, "arm-none-eabi-g++", "exit 1");
  add_tool(folder, "arm-none-eabi-gcc", "exit 1");
  add_tool(folder, "qemu-system-arm", "exit 0");
  const ProgramResult budget = run_here(folder, make(folder, "budget"), false);
  CHECK_EQ(budget.exit_status, 0);
  CHECK_EQ(budget.out,
           "budget: not installed: <cmath> of arm-none-eabi-g++ (Debian: libstdc++-arm-none-eabi-newlib), "
           "left out\n");
  // Counts of another compiler are not those of the limits.
  add_tool(folder, "g++-99", "[ \"$1\" = -dumpversion ] && echo 99");
  add_tool(folder, "clang++", "[ \"$1\" = -dumpversion ] && echo 99.1");
  add_tool(folder, "valgrind", "exit 0");
  const ProgramResult counts = run_here(folder, make(folder, "bench-instructions CXX=g++-99"), false);
  CHECK_EQ(counts.exit_status, 0);
  CHECK_EQ(lines(counts.out + counts.err), 2);
  CHECK(contains(counts.out, "g++-12") && contains(counts.out, "clang-14"));
  // clang++ is asked by FUZZ_CXX and COVERAGE_CXX, and g++ is not clang.
  const ProgramResult coverage = run_here(folder, make(folder, "coverage COVERAGE_CXX=g++"), false);
  CHECK_EQ(coverage.exit_status, 0);
  CHECK_EQ(coverage.out + coverage.err,
           "coverage: g++ is not clang (Debian: clang llvm), nothing measured\n");
}

TEST(tools_peers_are_asked_one_by_one) {
  const ScratchFolder folder;
  add_tool(folder, "g++-99", "exit 1");
  const ProgramResult peers = run_here(folder, make(folder, "bench-peers CXX=g++-99"), false);
  CHECK_EQ(peers.exit_status, 0);
  CHECK_EQ(lines(peers.out + peers.err), 6);
  for (const char* peer :
       {"ceres (Debian: libceres-dev)", "eigen (Debian: libeigen3-dev)", "lapack (Debian: liblapack-dev)"})
    CHECK(contains(peers.out, std::string("bench-peers: not installed: ") + peer + ", left out\n"));
}

TEST(tools_help_lists_every_goal_in_four_groups) {
  const ScratchFolder folder;
  const std::string help = run_here(folder, make(folder, "help"), false).out;
  std::size_t at = 0;
  for (const char* group : {"use\n  all ", "check\n  test ", "measure\n  bench ", "target\n"}) {
    CHECK(help.find(group, at) != std::string::npos);
    at = help.find(group, at);
  }
  const ProgramResult goals = run_program("cd " + quoted(source_path("")) +
                                          " && cat Makefile */*.mk */*/*.mk | grep -c '^[a-z-]*:.*## '");
  CHECK_EQ(std::to_string(lines(help) - 4) + "\n", goals.out);
}

// The program that writes the page says where it is, with a path that is good from any folder.
TEST(tools_run_leaves_the_path_of_the_page_to_the_program) {
  const ScratchFolder folder;
  const ProgramResult said = run_here(folder, make(folder, "-o all run RUNNER=echo"), false);
  CHECK_EQ(said.exit_status, 0);
  const std::string build = folder.path("build");
  CHECK_EQ(said.out, build + "/tiltrotor report --output " + build + "/report\n");
}

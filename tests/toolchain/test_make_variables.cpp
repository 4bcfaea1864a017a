// Every variable a user may give to make is refused in one line when no build can come of its value.
#include <string>

#include "check.hpp"
#include "run_program.hpp"

using namespace check;

namespace {

const std::string kMake = "make -n -C " + quoted(TILTROTOR_SOURCE_DIR) + " ";
bool has_make() { return run_program("command -v make").exit_status == 0; }

// One line of make, which names the variable and does nothing.
void check_refused(const std::string& assignment, const std::string& goal) {
  const ProgramResult result = run_program(kMake + assignment + " " + goal);
  const std::string name = assignment.substr(0, assignment.find('='));
  bool refused = CHECK_EQ(result.exit_status, 2);
  refused &= CHECK(result.err.find(name) != std::string::npos);
  refused &= CHECK_EQ(result.err.find('\n'), result.err.size() - 1);
  refused &= CHECK(result.out.find("rm ") == std::string::npos);
  if (!refused) NOTE(assignment << " " << goal << ": " << result.err);
}

void check_accepted(const std::string& assignments, const std::string& goal) {
  const ProgramResult result = run_program(kMake + assignments + " " + goal);
  if (!CHECK_EQ(result.exit_status, 0)) NOTE(assignments << " " << goal << ": " << result.err);
}

}  // namespace

TEST(build_make_refuses_folders_that_are_none) {
  if (!has_make()) return;
  const std::string tree = TILTROTOR_SOURCE_DIR;
  for (const char* folder : {"",
                             "' '",
                             "tables",
                             "tables/",
                             "./tables",
                             "tables/new",
                             "tables/../tables/x",
                             "src/cli",
                             "include/x",
                             "tests/a/b",
                             "bench",
                             ".",
                             "..",
                             "../",
                             "/",
                             "nowhere/..",
                             "nowhere/../tables",
                             "README.md",
                             "Makefile/x",
                             "'a b'",
                             "a\\'b",
                             "'a;b'",
                             "'a:b'",
                             "'a*'",
                             "'a%b'",
                             "'~'",
                             "'~/b'",
                             "-b",
                             "'a|b'",
                             "'a\\b'"})
    check_refused(std::string("BUILD=") + folder, "clean");
  for (const std::string& folder : {tree, tree + "/", tree + "/src", tree + "/tables/x", tree + "/LICENSE"})
    check_refused("BUILD=" + quoted(folder), "clean");
  const std::string link = new_temporary_folder();
  run_program("ln -s " + quoted(tree + "/tables") + " " + link + "/link");
  check_refused("BUILD=" + link + "/link/x", "clean");
  check_refused("BUILD=" + link + "/link", "clean");
  for (const std::string& folder :
       {std::string("b"), std::string("b/"), std::string("./b"), std::string("b/c.d-e_f+g@h,i"), link,
        link + "/new/new", std::string("tables2"), std::string("src.build")})
    check_accepted("BUILD=" + folder, "clean");
  run_program("rm -r " + link);
}

TEST(build_make_refuses_places_to_install_that_are_none) {
  if (!has_make()) return;
  const std::string tree = TILTROTOR_SOURCE_DIR;
  for (const char* prefix :
       {"", "' '", ".", "./", "README.md", "README.md/x", "src", "include/x", "a\\'b", "'a\"b'"})
    for (const char* arch : {"", " ARCH="}) check_refused(std::string("PREFIX=") + prefix + arch, "install");
  check_refused("PREFIX=" + quoted(tree), "install");
  for (const char* folder : {".", "README.md", "tables", "a\\'b"})
    check_refused(std::string("DESTDIR=") + folder, "install");
  check_accepted("PREFIX= DESTDIR=tables", "clean");  // nothing is installed
}

// A compiler behind a launcher, with flags: what is not there is named by itself.
TEST(build_page_names_its_compiler) {
  if (!has_make()) return;
  const ProgramResult plan = run_program(kMake + "PAGE_CXX='env no-such-clang++ -g' BUILD=b page");
  CHECK(plan.out.find("tool.sh page no-such-clang++ clang wasm-ld lld 'env no-such-clang++ -g ") !=
        std::string::npos);
}

TEST(build_install_copies_the_licence) {
  if (!has_make()) return;
  const ProgramResult plan = run_program(kMake + "ARCH= PREFIX=/p BUILD=b install");
  CHECK(plan.out.find("install -m 644 LICENSE \"$to/share/doc/tiltrotor\"") != std::string::npos);
}

TEST(build_make_refuses_words_that_are_none) {
  if (!has_make()) return;
  for (const char* assignment : {"WERROR=2",
                                 "WERROR=yes",
                                 "WERROR='1 1'",
                                 "WERROR=0",
                                 "V=0",
                                 "V=2",
                                 "V=yes",
                                 "V='1 1'",
                                 "AIRCRAFT=README.md",
                                 "AIRCRAFT=",
                                 "AIRCRAFT=xv15/",
                                 "AIRCRAFT=./xv15",
                                 "AIRCRAFT=../tables/xv15",
                                 "AIRCRAFT=%",
                                 "AIRCRAFT='xv15 xv15'",
                                 "AIRCRAFT=XV15",
                                 "TARGET=cortexm7",
                                 "TARGET=cortex-m7f",
                                 "TARGET=Cortex-M7",
                                 "TARGET='cortex-m7 cortex-m4f'",
                                 "TARGET=%",
                                 "PRECISION=",
                                 "PRECISION=Double",
                                 "PRECISION=float",
                                 "ARCH=typo",
                                 "ARCH=native,typo",
                                 "CXX=",
                                 "CC=",
                                 "AR=",
                                 "HOST_CXX=",
                                 "CLANG_FORMAT=",
                                 "FUZZ_CXX=",
                                 "COVERAGE_CXX=",
                                 "FIRMWARE_PREFIX="})
    check_refused(assignment, "clean");
  check_accepted("WERROR= V= TARGET= ARCH= TESTS= RUNNER= LDFLAGS= CXXFLAGS= CROSS_COMPILE=", "clean");
  check_accepted("WERROR=1 V=1 AIRCRAFT=xv15 PRECISION=single ARCH=native", "clean");
}

TEST(build_make_refuses_numbers_that_are_none) {
  if (!has_make()) return;
  for (const char* name : {"SECONDS", "MUTANTS", "FIRMWARE_FRAMES", "MEASURED_STATES", "STATES", "FLIGHTS"}) {
    for (const char* value : {"", "abc", "-5", "1.5", "1e6", "'1 2'", "0x10", "' '", "1k"})
      check_refused(std::string(name) + "=" + value, "clean");
    check_accepted(std::string(name) + "=12", "clean");
    const bool counts_from_none = std::string(name) == "STATES" || std::string(name) == "FLIGHTS";
    if (counts_from_none) {
      check_accepted(std::string(name) + "=0", "clean");
    } else {
      check_refused(std::string(name) + "=0", "clean");
    }
  }
}

TEST(build_make_refuses_goals_a_microcontroller_cannot_run) {
  if (!has_make()) return;
  for (const char* goal : {"test", "run", "validate", "hash", "examples", "envelope", "bench"})
    check_refused("TARGET=cortex-m7 CXX=g++ CC=gcc", goal);
}

// `make clean` removes what was built, and nothing else.
TEST(build_clean_leaves_other_folders) {
  if (!has_make()) return;
  const std::string folder = new_temporary_folder();
  const std::string clean = "make -C " + quoted(TILTROTOR_SOURCE_DIR) + " BUILD=" + folder + " clean";
  run_program("echo precious >" + folder + "/letter");
  const ProgramResult refused = run_program(clean);
  CHECK_EQ(refused.exit_status, 2);
  CHECK(refused.out.find("left as it is") != std::string::npos);
  CHECK_EQ(run_program("cat " + folder + "/letter").out, "precious\n");
  run_program("touch " + folder + "/flags.stamp");
  CHECK_EQ(run_program(clean).exit_status, 0);
  CHECK_EQ(run_program("ls " + folder).out, "");
  CHECK_EQ(run_program(clean).exit_status, 0);  // nothing there: nothing to do
}

// The generator's numbers are those of every compiler: no flag of the user turns on fused operations.
TEST(build_table_generator_rounds_every_operation) {
  if (!has_make()) return;
  const ProgramResult plan =
      run_program(kMake + "-B V=1 HOST_CXXFLAGS='-O3 -ffp-contract=fast' BUILD=b b/tablegen");
  const std::size_t asked = plan.out.find("-ffp-contract=fast"), off = plan.out.find("-ffp-contract=off");
  CHECK(asked != std::string::npos && off != std::string::npos && asked < off);
}

// Other machines have compilers and emulators of their own, whatever this one was told to use; here of stubs.
TEST(build_test_cross_is_deaf_to_variables_of_this_machine) {
  if (!has_make()) return;
  const std::string tools = new_temporary_folder();
  for (const char* tool : {"other-g++", "other-gcc", "other-ar", "qemu-other", "mine"})
    run_program("printf '#!/bin/sh\\nexit 0\\n' >" + tools + "/" + tool + " && chmod +x " + tools + "/" +
                tool);
  const ProgramResult plan =
      run_program("PATH=" + tools + ":$PATH " + kMake + "-B V=1 CROSS_TOOLS=other CXX=mine CC=mine AR=mine " +
                  "HOST_CXX=g++ ARCH=x86-64 RUNNER=mine LDFLAGS=-lmine BUILD=" + tools + "/b test-cross");
  const std::size_t begin = plan.out.find("CROSS_COMPILE=$tools-");
  const std::string other = begin == std::string::npos ? "" : plan.out.substr(begin);
  CHECK(other.find("other-g++ -std=c++17") != std::string::npos);
  CHECK(other.find("other-gcc -std=c99") != std::string::npos);
  CHECK(other.find("other-ar rcs") != std::string::npos);
  CHECK(other.find("qemu-other -L /usr/other " + tools + "/b/other/run_tests") != std::string::npos);
  for (const char* mine : {"\nmine ", "-march", "-lmine"})
    if (!CHECK(other.find(mine) == std::string::npos)) NOTE(mine);
  run_program("rm -r " + tools);
}

// A goal that calls make again with variables of its own is not refused for them.
TEST(build_make_goals_are_not_refused_by_themselves) {
  if (!has_make()) return;
  const std::string folder = new_temporary_folder();
  check_accepted("BUILD=" + folder + "/b", "coverage");
  run_program("rm -r " + folder);
}

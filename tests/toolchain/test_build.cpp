// What a stranger's compiler and linker may do to the library: programs are built beside it, as a user would.
// Expected values come from the linker, from nm, and from the same flight of a program in plain C.
#include <sstream>
#include <string>
#include <vector>

#include "check.hpp"
#include "run_program.hpp"
#include "tiltrotor/tiltrotor.h"

using namespace check;

namespace {

// Programs built here run here: not for libraries of another machine.
bool is_native() { return std::string(TILTROTOR_CROSS).empty() && std::string(TILTROTOR_RUNNER).empty(); }

class Room {
 public:
  ~Room() { run_program("rm -r " + quoted(path_)); }
  ProgramResult run(const std::string& command) const {
    return run_program("cd " + quoted(path_) + " && " + command);
  }
  const std::string& path() const { return path_; }

 private:
  std::string path_ = new_temporary_folder();
};

// Whichever precision is built: programs ask for the same.
#ifdef TR_SINGLE_PRECISION
const std::string kThis = " -DTR_SINGLE_PRECISION ";
const std::string kOther = " ";
#else
const std::string kThis = " ";
const std::string kOther = " -DTR_SINGLE_PRECISION ";
#endif
const std::string kCxx = std::string(TILTROTOR_CXX " -I") + quoted(source_path("include"));
const std::string kLibrary = quoted(TILTROTOR_BINARY_DIR "/libtiltrotor.a");
bool has(const std::string& tool) { return run_program("command -v " + tool).exit_status == 0; }

std::string every_function(const std::string& flags) {
  return run_program(kCxx + flags + "-E -P -x c++ - <" + quoted(source_path("include/tiltrotor/sensors.h")) +
                     " | grep -o 'tr_[a-z_]*[0-9a-z_]*(' | tr -d '(' | sort -u")
      .out;
}

}  // namespace

TEST(build_no_function_of_the_library_can_be_replaced) {
  if (!is_native() || !has("nm")) return;
  const ProgramResult symbols =
      run_program("nm " + kLibrary + " | awk '$2 ~ /[TWVuBDRi]/ { print $3 }' | sort -u");
  std::istringstream lines(symbols.out);
  int counted = 0;
  for (std::string name; std::getline(lines, name);) {
    if (name.empty()) continue;
    ++counted;
    const bool is_interface = name.compare(0, 3, "tr_") == 0;
    const bool is_own = name.find("tiltrotor_library_") != std::string::npos;
    const bool is_aircraft_of_headers = name.find("_ZN9tiltrotor13aircraft_data") == 0 ||
                                        name.find("_ZN9tiltrotor17aircraft_identity") == 0 ||
                                        name.find("kAircraftIdentity") != std::string::npos ||
                                        name.find("_ZN9tiltrotor20aircraft_fingerprint") == 0 ||
                                        name.find("AircraftArrays") != std::string::npos;
    const bool is_of_coverage =
        name.find("__cov") == 0 || name.find("__prof") == 0 || name.find("__llvm") == 0;
    if (!CHECK(is_interface || is_own || is_aircraft_of_headers || is_of_coverage)) NOTE(name);
  }
  CHECK(counted > 20);
}

TEST(build_shared_library_exports_the_interface_alone) {
  if (!is_native() || !has("nm")) return;
  const std::string folder = quoted(TILTROTOR_BINARY_DIR);
  const ProgramResult symbols =
      run_program("nm -D --defined-only " + folder + "/libtiltrotor.so.[0-9]* | awk '{ print $3 }'");
  std::istringstream lines(symbols.out);
  int counted = 0;
  for (std::string name; std::getline(lines, name); ++counted)
    if (!CHECK_EQ(name.substr(0, 3), "tr_")) NOTE(name);
  CHECK(counted >= 23);
}

// Linkers of Windows take a list of what a DLL shows. Expected: what the shared library shows.
TEST(build_windows_list_is_the_interface) {
  if (!is_native() || !has("nm")) return;
#ifdef TR_SINGLE_PRECISION
  const std::string renamed = "s/_0x00070008u/_0x00070004u/; t; s/$/_single/";
#else
  const std::string renamed;
#endif
  const std::string listed =
      run_program("sed -n 's/^    //p' " + quoted(source_path("src/library/tiltrotor.def")) + " | sed " +
                  quoted(renamed) + " | sort")
          .out;
  const std::string shown = run_program("nm -D --defined-only " + quoted(TILTROTOR_BINARY_DIR) +
                                        "/libtiltrotor.so.[0-9]* | awk '{ print $3 }' | sort")
                                .out;
  CHECK_EQ(listed, shown);
}

TEST(build_flight_keeps_its_bits_beside_a_file_with_other_flags) {
  if (!is_native()) return;
  const Room room;
  const ProgramResult compiled =
      room.run(kCxx + kThis + "-O1 -c " + quoted(source_path("tests/toolchain/flight.cpp")) +
               " -o flight.o && " TILTROTOR_CXX " flight.o " + kLibrary + " -lm -o alone && ./alone");
  if (!CHECK_EQ(compiled.exit_status, 0)) NOTE(compiled.err);
  for (const char* flags : {"-O0", "-O2 -march=native", "-O1 -frounding-math"}) {
    const ProgramResult mixed = room.run(
        kCxx + " -std=c++17 " + flags + " -c " + quoted(source_path("tests/toolchain/mixed.cpp")) +
        " -o mixed.o && " TILTROTOR_CXX " mixed.o flight.o " + kLibrary + " -lm -o mixed && ./mixed");
    if (!CHECK_EQ(mixed.exit_status, 0)) NOTE(mixed.err);
    CHECK_EQ(mixed.out, compiled.out);
  }
}

TEST(build_every_header_refuses_other_arithmetic) {
  const bool gnu = run_program(TILTROTOR_CXX " --version").out.find("clang") == std::string::npos;
  std::vector<std::string> refused = {"-ffast-math", "-Ofast", "-ffinite-math-only"};
  if (gnu)
    for (const char* part : {"-fassociative-math -fno-signed-zeros -fno-trapping-math", "-freciprocal-math",
                             "-fno-signed-zeros", "-funsafe-math-optimizations"})
      refused.emplace_back(part);
#ifdef __x86_64__
  if (gnu) refused.emplace_back("-mfpmath=387");
#endif
  const std::string headers =
      run_program("cd " + quoted(source_path("include")) + " && find . -name '*.hpp'").out;
  std::istringstream names(headers);
  int counted = 0;
  for (std::string name; std::getline(names, name); ++counted) {
    const std::string tail = " -std=c++17 -E -o /dev/null " + quoted(source_path("include/" + name));
    if (!CHECK(run_program(kCxx + " -ffast-math" + tail).exit_status != 0)) NOTE(name);
  }
  CHECK(counted > 40);
  const std::string prepare =
      " -std=c++17 -E -o /dev/null " + quoted(source_path("include/tiltrotor/math/arithmetic.hpp"));
  CHECK_EQ(run_program(kCxx + prepare).exit_status, 0);
  for (const std::string& flags : refused) {
    const ProgramResult result = run_program(kCxx + " " + flags + prepare);
    if (!CHECK(result.exit_status != 0 && result.err.find("#error \"tiltrotor needs") != std::string::npos))
      NOTE(flags);
  }
}

// What no macro tells is found in samples when the program runs; a constant in single precision by the compiler.
TEST(build_other_arithmetic_is_found_at_run_time) {
  if (!is_native()) return;
  const Room room;
  const std::string source =
      "printf '#include <tiltrotor/math/arithmetic.hpp>\\nint main() { using namespace "
      "tiltrotor; return is_ieee_arithmetic<double>() && is_ieee_arithmetic<float>(); }\\n' ";
  const auto accepts = [&](const std::string& compiler, const std::string& flags) {
    const std::string command = source + "| " + compiler + " -std=c++17 -I" + quoted(source_path("include")) +
                                " -ffp-contract=off " + flags + " -x c++ - -o probe 2>/dev/null";
    return room.run(command).exit_status == 0 ? room.run("./probe").exit_status : -1;
  };
  for (const std::string compiler : {TILTROTOR_CXX, "g++", "clang++"}) {
    const std::string program = compiler.substr(compiler.rfind(' ') + 1);
    if (!has(program)) continue;
    const bool clang = run_program(program + " --version").out.find("clang") != std::string::npos;
    for (const char* plain : {"-O0", "-O1", "-O2", "-O3"}) CHECK_EQ(accepts(program, plain), 1);
    for (const std::string level : {"-O1 ", "-O2 ", "-O3 "}) {
      for (const std::string flags : {"-fno-signed-zeros", "-freciprocal-math",
                                      "-fassociative-math -fno-signed-zeros -fno-trapping-math",
                                      "-funsafe-math-optimizations", "-ffinite-math-only", "-ffast-math"})
        if (!CHECK(accepts(program, level + flags) != 1)) NOTE(program << " " << level << flags);
      if (clang && !CHECK_EQ(accepts(program, level + "-fno-honor-nans"), 0)) NOTE(program << " " << level);
    }
    if (!clang) CHECK_EQ(accepts(program, "-fsingle-precision-constant"), -1);
  }
}

// A fused operation rounds once where the formula rounds twice: other bits than on a machine without. Some compilers form
// them against -ffp-contract=off, so the instructions themselves are looked at, on x86-64 and AArch64.
TEST(build_has_no_fused_operations) {
  if (!is_native() || !has("objdump")) return;
  for (const std::string& library : {kLibrary, quoted(TILTROTOR_BINARY_DIR "/libanalyses.a")}) {
    const std::string lines = "objdump -d --no-show-raw-insn " + library + " | grep -c ";
    CHECK(std::stoi("0" + run_program(lines + "'[[:space:]]v\\?f\\?mulp\\?[sd]\\?'").out) > 1000);
    const ProgramResult fused = run_program(lines + "'[[:space:]]v\\?fn\\?m\\(add\\|sub\\|la\\|ls\\)'");
    if (!CHECK_EQ(fused.out, "0\n")) NOTE(library);
  }
}

TEST(build_precision_is_in_the_names) {
  if (!is_native()) return;
  const Room room;
  std::istringstream names(every_function(" -DTR_SINGLE_PRECISION "));
  int counted = 0;
  for (std::string name; std::getline(names, name); ++counted) {
    const bool marked = (name.size() > 7 && name.substr(name.size() - 7) == "_single") ||
                        name.find("0x00070004u") != std::string::npos;
    if (!CHECK(marked)) NOTE("no name of its own in single precision: " << name);
  }
  CHECK(counted >= 23);
  for (const char* name : {"tr_eigenvalues", "tr_modes", "tr_hash", "tr_init", "tr_step", "tr_version"}) {
    const std::string program =
        std::string("printf '#include <tiltrotor/tiltrotor.h>\\nint main() { const volatile auto f = &") +
        name + "; return f == nullptr; }' | ";
    const std::string tail = " -x c++ - -x none " + kLibrary + " -o program";
    if (!CHECK_EQ(room.run(program + kCxx + kThis + tail).exit_status, 0)) NOTE(name);
    const ProgramResult wrong = room.run(program + kCxx + kOther + tail);
    CHECK(wrong.exit_status != 0 &&
          wrong.err.find(std::string("undefined reference to `") + name) != std::string::npos);
  }
  // Of another version: the three that are not told it.
  for (const char* name : {"tr_eigenvalues", "tr_modes", "tr_hash"}) {
    const std::string program =
        std::string("printf '#include \"older.h\"\\nint main() { const volatile auto f = &") + name +
        "; return f == nullptr; }' | ";
    const ProgramResult wrong = room.run(
        "sed s/0x00070/0x00020/ " + quoted(source_path("include/tiltrotor/tiltrotor.h")) + " >older.h && " +
        program + kCxx + kThis + "-I. -x c++ - -x none " + kLibrary + " -o program");
    CHECK(wrong.exit_status != 0 && wrong.err.find("undefined reference") != std::string::npos);
  }
}

TEST(build_make_refuses_what_it_does_not_know) {
  const std::string make = "make -n -C " + quoted(TILTROTOR_SOURCE_DIR) + " ";
  if (!has("make")) return;
  for (const char* wrong : {"PRECISION=typo", "PRECISION='single double'", "TARGET=cortex-m9", "AIRCRAFT=v22",
                            "ARHC=native", "PRECISON=single", "prefix=/usr"}) {
    const ProgramResult result = run_program(make + wrong + " clean");
    CHECK_EQ(result.exit_status, 2);
    const std::string word(wrong, std::string(wrong).find('='));
    if (!CHECK(result.err.find(word) != std::string::npos)) NOTE(result.err);
  }
  CHECK_EQ(
      run_program(make + "PRECISION=single CFLAGS=-g CPPFLAGS=-DX LDLIBS= DESTDIR=/x PREFIX=/y V=1 clean")
          .exit_status,
      0);
  CHECK_EQ(run_program("SOMETHING=1 CI=true " + make + "clean").exit_status, 0);
}

TEST(build_moved_tree_compiles_its_tests_again) {
  if (!has("make")) return;
  const Room room;
  room.run("mkdir first && cd " + quoted(TILTROTOR_SOURCE_DIR) +
           " && cp -R Makefile include src tests bench tables " + room.path() + "/first");
  const std::string make = "make -s -C ";
  CHECK_EQ(room.run(make + "first BUILD=b b/tests.stamp && cp first/b/tests.stamp before").exit_status, 0);
  CHECK(room.run(make + "first BUILD=b b/tests.stamp && cmp first/b/tests.stamp before").exit_status == 0);
  CHECK(room.run("mv first second && " + make +
                 "second BUILD=b b/tests.stamp && cmp second/b/tests.stamp before")
            .exit_status == 1);
  const std::string plan = room.run(make + "second -n BUILD=b b/tests/check.o b/run_tests").out;
  CHECK(plan.find("second") != std::string::npos);
}

TEST(build_hash_fails_with_its_flight) {
  if (!has("make")) return;
  const Room room;
  room.run(
      "mkdir b && printf '#!/bin/sh\necho hash_states 1\nexit 3\n' >b/reference_flight && chmod +x "
      "b/reference_flight");
  const ProgramResult result =
      room.run("make -s -C " + quoted(TILTROTOR_SOURCE_DIR) + " BUILD=" + room.path() + "/b RUNNER= -o " +
               room.path() + "/b/reference_flight hash");
  CHECK_EQ(result.exit_status, 2);
  CHECK(result.out.find("hash: the flight failed") != std::string::npos);
}

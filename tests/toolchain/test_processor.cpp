// A processor without the instructions of the compiled code is found before they are met. What it has is an
// argument; and an emulated one of 2003 (qemu64) runs the library and the program that were built.
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "check.hpp"
#include "cli/processor_check.hpp"
#include "library/c_entry.hpp"
#include "library/processor.hpp"
#include "run_program.hpp"

using namespace check;
using namespace tiltrotor;

namespace {

constexpr unsigned kAll = (1u << kInstructionCount) - 1;
#ifdef __x86_64__
constexpr unsigned kOlder = instruction_bit(InstructionPlace::sse3);  // of the list, what qemu64 has
#else
constexpr unsigned kOlder = 0;
#endif

std::vector<std::string> instruction_names() {
#define TILTROTOR_NAME(place, name, macro, here) name,
  return {TILTROTOR_INSTRUCTIONS(TILTROTOR_NAME)};
#undef TILTROTOR_NAME
}

// What the program says, and whether it stops.
std::string line_for(unsigned compiled, unsigned available, bool& stops) {
  std::FILE* const errors = std::tmpfile();
  stops = cli::cannot_run(compiled, available, errors);
  std::rewind(errors);
  char line[200] = "";
  const std::size_t length = std::fread(line, 1, sizeof line - 1, errors);
  std::fclose(errors);
  return std::string(line, length);
}

// Why nothing can be emulated here; empty: it can.
std::string no_older_processor() {
#ifdef __x86_64__
  if ((compiled_instructions & ~kOlder) == 0) return "compiled for every x86-64 processor (ARCH=)";
  if (!std::string(TILTROTOR_RUNNER).empty()) return "the programs are of another machine";
  const ProgramResult tool =
      run_program(quoted(source_path("tests/tool.sh")) + " arithmetic_older_processor qemu-x86_64 qemu-user");
  return tool.out;
#else
  return "emulated on x86-64 alone";
#endif
}

}  // namespace

TEST(arithmetic_this_processor_runs_what_was_compiled_for_it) {
  CHECK_EQ(compiled_instructions & ~processor_instructions(), 0u);
  CHECK(missing_instructions(compiled_instructions, processor_instructions()) == nullptr);
  CHECK(missing_instructions(0, 0) == nullptr);
}

TEST(arithmetic_missing_instructions_are_named) {
  const std::vector<std::string> names = instruction_names();
  for (unsigned place = 0; place < kInstructionCount; ++place) {
    const unsigned lacking = kAll & ~(1u << place);
    CHECK_EQ(missing_instructions(kAll, lacking), names[place]);
    CHECK_EQ(missing_instructions(1u << place, 0), names[place]);
    CHECK(missing_instructions(lacking, lacking) == nullptr);
    CHECK(missing_instructions(0, lacking) == nullptr);

    CHECK_EQ(c_interface::entry_status(kAll, lacking), TR_BAD_ARITHMETIC);
    CHECK_EQ(c_interface::entry_status(lacking, lacking), TR_OK);

    bool stops = false;
    CHECK_EQ(line_for(kAll, lacking, stops), "tiltrotor: compiled for " + names[place] +
                                                 ", which this processor lacks; build with ARCH= (empty)\n");
    CHECK(stops);
    CHECK_EQ(line_for(lacking, lacking, stops), "");
    CHECK(!stops);
  }
}

// Every level of x86-64 a user may name is told apart by the list; the compiler says what belongs to it.
TEST(arithmetic_instructions_of_every_level_are_known) {
#ifdef __x86_64__
  const struct {
    const char *flags, *names;
  } levels[] = {{"-march=x86-64", ""},
                {"-march=x86-64 -msse3", "sse3 "},
                {"-march=core2", "sse3 ssse3 "},
                {"-march=nehalem", "sse3 ssse3 sse4.1 sse4.2 popcnt "},
                {"-march=sandybridge", "sse3 ssse3 sse4.1 sse4.2 popcnt avx "},
                {"-march=haswell", "sse3 ssse3 sse4.1 sse4.2 popcnt avx avx2 fma bmi bmi2 "},
                {"-march=skylake-avx512",
                 "sse3 ssse3 sse4.1 sse4.2 popcnt avx avx2 fma bmi bmi2 avx512f avx512cd avx512bw avx512dq "
                 "avx512vl "}};
  const std::vector<std::string> names = instruction_names();
  for (const auto& level : levels) {
    const ProgramResult bits = run_program(
        "printf '#include \"library/processor.hpp\"\\nconst char* const bits = "
        "TILTROTOR_INSTRUCTIONS(TILTROTOR_BIT);\\n' | " TILTROTOR_CXX " -std=c++17 -E -P -I" +
        quoted(source_path("src")) + " '-DTILTROTOR_BIT(place, name, macro, here)=<name macro>' " +
        level.flags + " -x c++ - | grep -o '<\"[a-z0-9.]*\" 1>' | cut -d '\"' -f 2 | tr '\\n' ' '");
    if (!CHECK_EQ(bits.out, level.names)) NOTE(level.flags << bits.err);
  }
#endif
}

TEST(arithmetic_older_processor_is_refused_by_the_program) {
  const std::string reason = no_older_processor();
  if (!reason.empty()) {
    NOTE("not run: " << reason);
    return;
  }
  const std::string first = missing_instructions(compiled_instructions, kOlder);
  for (const char* arguments : {"", " --help", " version", " trim --speed 40"})
    for (const char* program : {"tiltrotor", "tiltrotor-nd"}) {
      const ProgramResult result = run_program("qemu-x86_64 -cpu qemu64 " + built(program) + arguments);
      CHECK_EQ(result.exit_status, 1);
      CHECK_EQ(result.out, "");
      CHECK_EQ(result.err, "tiltrotor: compiled for " + first +
                               ", which this processor lacks; build with ARCH= (empty)\n");
    }
}

TEST(arithmetic_older_processor_is_refused_by_every_call) {
  const std::string reason = no_older_processor();
  if (!reason.empty()) {
    NOTE("not run: " << reason);
    return;
  }
  const std::string folder = new_temporary_folder();
#ifdef TR_SINGLE_PRECISION
  const std::string precision = " -DTR_SINGLE_PRECISION";
#else
  const std::string precision;
#endif
  const ProgramResult compiled =
      run_program(TILTROTOR_CXX " -x c++ -I" + quoted(source_path("include")) + precision + " " +
                  quoted(source_path("tests/toolchain/every_call.c")) + " -x none " +
                  quoted(TILTROTOR_BINARY_DIR "/libtiltrotor.a") + " -lm -o " + folder + "/every_call");
  if (!CHECK_EQ(compiled.exit_status, 0)) NOTE(compiled.err);
  const ProgramResult here = run_program(folder + "/every_call");
  const ProgramResult older = run_program("qemu-x86_64 -cpu qemu64 " + folder + "/every_call");
  CHECK_EQ(here.exit_status, 0);
  CHECK_EQ(older.exit_status, 0);
  std::istringstream here_lines(here.out), older_lines(older.out);
  int counted = 0;
  for (std::string name, status; here_lines >> name >> status; ++counted) {
    if (!CHECK_EQ(status, "ok")) NOTE(name);
    std::string refused;
    older_lines >> name >> refused;
    if (!CHECK_EQ(refused, "bad_arithmetic")) NOTE(name);
  }
  CHECK_EQ(counted, 46);
  run_program("rm -r " + folder);
}

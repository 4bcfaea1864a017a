// A table with one row a state or component does not compile with a row forgotten.
#include "check.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"

using check::quoted;
using check::run_program;
using check::source_path;

namespace {

std::string text_of(const std::string& name) {
  std::ifstream in(source_path(name), std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

// Whether the file compiles from a folder with no other files, `removed` taken out of it once.
bool compiles_without(const std::string& name, const std::string& removed) {
  const check::ScratchFolder folder;
  std::string text = text_of(name);
  const std::size_t place = text.find(removed);
  CHECK(place != std::string::npos);
  if (place != std::string::npos) text.erase(place, removed.size());
  return run_program(TILTROTOR_CXX " -std=c++17 -fsyntax-only -x c++ -I" + quoted(source_path("include")) +
                     " -I" + quoted(source_path("src")) + " -I" TILTROTOR_BINARY_DIR "/generated " +
                     folder.write("part.cpp", text))
             .exit_status == 0;
}

}  // namespace

TEST(build_a_row_forgotten_does_not_compile) {
  const struct {
    const char *file, *row;
  } rows[] = {
      {"include/tiltrotor/model/variables/loads.hpp", "\"fin_left\""},
      {"src/cli/state_columns.cpp", "{\"psi\", \"yaw_deg\", \"deg\"},"},
      {"include/tiltrotor/analysis/trim/trim_explanation.hpp", "\"turn rate must be within 60 deg/s\","}};
  for (const auto& [file, row] : rows) {
    CHECK(compiles_without(file, ""));
    if (!CHECK(!compiles_without(file, row))) NOTE(file << " " << row);
  }
}

// The house the model lives in: which way includes run, how long a header is, where memory may be spoken of.
// Expected: the rules of src/README.md and src/CONTRIBUTING.md.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <string>

#include "check.hpp"
#include "run_program.hpp"

using check::source_path;

namespace {

const std::string kRoot = "include/tiltrotor/";

// Name below include/tiltrotor/ and text of every header.
std::map<std::string, std::string> headers() {
  std::map<std::string, std::string> all;
  const std::filesystem::path root = source_path(kRoot);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    if (entry.path().extension() != ".hpp") continue;
    std::ifstream in(entry.path(), std::ios::binary);
    all[std::filesystem::relative(entry.path(), root).string()] =
        std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return all;
}

bool starts_with(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

auto lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

// 0 mathematics, 1 model, 2 analysis.
int floor_of(const std::string& header) {
  return starts_with(header, "math/") ? 0 : starts_with(header, "model/") ? 1 : 2;
}

}  // namespace

TEST(house_includes_run_from_analysis_to_model_to_mathematics) {
  const std::regex include("#include \"tiltrotor/([^\"]+)\"");
  int seen = 0;
  for (const auto& [name, text] : headers()) {
    for (std::sregex_iterator match(text.begin(), text.end(), include), end; match != end; ++match, ++seen)
      if (!CHECK_LE(floor_of((*match)[1]), floor_of(name))) NOTE(name << " includes " << (*match)[1]);
  }
  CHECK_LT(100, seen);
}

TEST(house_headers_are_short) {
  for (const auto& [name, text] : headers()) {
    const int limit = name == "model/derivative.hpp" ? 120 : starts_with(name, "model/") ? 220 : 400;
    // Still to be parted: the numbers of an aircraft and what is prepared from them.
    if (name == "model/aircraft.hpp" || name == "model/configuration.hpp") continue;
    if (!CHECK_LE(lines(text), limit)) NOTE(name);
  }
}

// Workspaces have headers of their own; inlining and unions are no matter of physics.
TEST(house_physics_is_free_of_memory) {
  for (const auto& [name, text] : headers()) {
    if (!starts_with(name, "model/")) continue;
    const bool is_workspace = name.find("_workspace.hpp") != std::string::npos;
    for (const char* const word : {"TILTROTOR_NOINLINE", "union {", "reinterpret_cast", "Workspace {"})
      if (!CHECK(is_workspace || text.find(word) == std::string::npos)) NOTE(word << " in " << name);
  }
}

// One word for the caller's memory: workspace.
TEST(house_memory_is_called_workspace) {
  const std::regex other("\\b(rooms?|Room|[A-Z][a-z]+Rooms?|Overlay|ModelMemory|waist)\\b");
  for (const auto& [name, text] : headers()) {
    if (name == "analysis/trim/momentum_range.hpp" || name == "analysis/trim/trim_explanation.hpp") continue;
    if (name == "analysis/flight/response.hpp") continue;  // "no room left" for a signal
    std::smatch match;
    if (!CHECK(!std::regex_search(text, match, other))) NOTE(match[1] << " in " << name);
  }
}

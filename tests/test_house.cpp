// The plan of the house: includes run one way, every file is small, and physics is free of memory. Expected: the
// table below, which is that of src/README.md, and the limits of src/CONTRIBUTING.md.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

#include "check.hpp"
#include "run_program.hpp"

using check::source_path;

namespace {

namespace fs = std::filesystem;

// A room includes itself and what is listed, and only rooms above it can be listed. The model has rooms of its own:
// rotor and airframe know nothing of each other, and meet in its top floor.
struct Room {
  const char *name, *includes;
};
#define MODEL "aircraft variables setup rotor airframe model"
constexpr Room kRooms[] = {
    {"generated", ""},  // by the build
    {"interface", ""},  // the C headers
    {"math", ""},
    {"aircraft", "math"},
    {"variables", "math aircraft"},
    {"setup", "math aircraft variables"},
    {"rotor", "math aircraft variables setup"},
    {"airframe", "math aircraft variables setup"},
    {"model", "math aircraft variables setup rotor airframe"},
    {"systems", "math " MODEL},
    {"analysis", "math systems " MODEL},
    {"facade", "math systems analysis " MODEL},  // headers of include/tiltrotor/ itself
    {"library", "generated interface math systems analysis " MODEL},
    {"pilot", "math systems analysis library " MODEL},
    {"text", "generated math systems analysis library " MODEL},
    {"plot", "text"},
    {"study", "generated math systems analysis library text plot " MODEL},
    {"cli", "generated math systems analysis library pilot text plot study " MODEL},
    {"tablegen", "math text " MODEL},
    {"firmware", "interface"},
    {"fmu", "generated interface math systems analysis library " MODEL},
    {"page", "interface firmware library model"},
    {"examples",
     "interface facade math systems analysis " MODEL},  // a user's, with the installed headers alone
};

std::set<std::string> words(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), std::istream_iterator<std::string>()};
}

// The room of a file, by its path from the root of the tree; empty: of none.
std::string room_of(const std::string& path) {
  if (std::regex_match(path, std::regex("include/tiltrotor/\\w+\\.h"))) return "interface";
  std::smatch part;
  if (std::regex_match(path, part, std::regex("include/tiltrotor/model/(\\w+)/.*"))) return part[1];
  if (std::regex_match(path, part, std::regex("include/tiltrotor/(\\w+)/.*"))) return part[1];
  if (std::regex_match(path, std::regex("include/tiltrotor/[^/]*"))) return "facade";
  if (std::regex_match(path, part, std::regex("src/(\\w+)/.*"))) return part[1];
  return "";
}

// What an include means to the compiler; empty for headers of the system.
std::string room_of_included(const std::string& name) {
  if (std::regex_match(name, std::regex("\\w+\\.inc"))) return "generated";
  for (const char* const root : {"include/", "src/", "src/examples/"})
    if (fs::exists(source_path(root + name))) return room_of(root + name);
  return "";
}

bool may_include(const std::string& room, const std::string& included) {
  const auto of_name = [&](const Room& r) { return room == r.name; };
  const auto* const row = std::find_if(std::begin(kRooms), std::end(kRooms), of_name);
  return row != std::end(kRooms) && (room == included || words(row->includes).count(included) == 1);
}

std::vector<std::string> lines_of(const std::string& path) {
  std::ifstream in(source_path(path));
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// Sources below the given folders, or what else is called so, from the root of the tree.
std::vector<std::string> sources(const std::vector<std::string>& folders,
                                 const std::string& pattern = ".*\\.(hpp|cpp|h|c|sh|awk|mk|ld|map)") {
  const std::regex called(pattern);
  std::vector<std::string> names;
  for (const std::string& folder : folders)
    for (const auto& entry : fs::recursive_directory_iterator(source_path(folder)))
      if (std::regex_match(entry.path().filename().string(), called))
        names.push_back(fs::relative(entry.path(), source_path("")).string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

TEST(house_rooms_stand_in_order) {
  std::set<std::string> above;
  for (const Room& room : kRooms) {
    for (const std::string& name : words(room.includes))
      if (!CHECK(above.count(name) == 1))
        NOTE(room.name << " includes " << name << ", which stands below it");
    CHECK(above.insert(room.name).second);
  }
  CHECK(may_include("model", "math") && !may_include("math", "model") && !may_include("setup", "rotor"));
  CHECK(may_include("model", "rotor") && !may_include("rotor", "airframe") &&
        !may_include("airframe", "rotor"));
  CHECK(may_include("cli", "study") && !may_include("study", "cli") && !may_include("text", "plot"));
  CHECK(!may_include("no such room", "math"));
}

TEST(house_includes_run_one_way) {
  const std::regex include("\\s*#\\s*include\\s*([\"<])([^\">]+)[\">].*");
  int count = 0;
  for (const std::string& file : sources({"include", "src"})) {
    const std::string room = room_of(file);
    int number = 0;
    for (const std::string& line : lines_of(file)) {
      ++number;
      std::smatch part;
      if (!std::regex_match(line, part, include)) continue;
      const std::string included = room_of_included(part[2]);
      if (included.empty() && part[1] == "<") continue;  // of the system
      ++count;
      if (!CHECK(may_include(room, included)))
        NOTE(file << ":" << number << ": " << (room.empty() ? "no room" : room) << " includes " << part[2]);
    }
  }
  CHECK_LE(400, count);
}

TEST(house_files_are_small) {
  constexpr std::size_t most = 400;
  const std::vector<std::string> all = sources({"include", "src", "tests", "bench"});
  for (const std::string& file : all) {
    const std::size_t lines = lines_of(file).size();
    if (!CHECK_LE(lines, most)) NOTE(file << " has " << lines << " lines");
  }
  CHECK_LE(300u, all.size());
}

TEST(house_pages_are_short) {
  constexpr std::size_t most = 400;
  int count = 0;
  for (const std::string& file : sources({"include", "src", "tests", "bench", "tables"}, "\\w+\\.md")) {
    const std::size_t lines = lines_of(file).size();
    if (!CHECK_LE(lines, most)) NOTE(file << " has " << lines << " lines");
    ++count;
  }
  CHECK_LE(10, count);
}

// Physics fits a few screens, and the flow of data through the model one and a half.
TEST(house_physics_is_short) {
  constexpr std::size_t most = 220;
  constexpr std::size_t most_of_flow = 119;
  int count = 0;
  for (const std::string& file : sources({"include/tiltrotor/model"})) {
    const bool flow = file == "include/tiltrotor/model/derivative.hpp";
    const std::size_t lines = lines_of(file).size();
    if (!CHECK_LE(lines, flow ? most_of_flow : most)) NOTE(file << " has " << lines << " lines");
    ++count;
  }
  CHECK_LE(30, count);
}

// Workspaces have headers of their own; inlining and unions are no matter of physics.
TEST(house_physics_is_free_of_memory) {
  for (const std::string& file : sources({"include/tiltrotor/model"})) {
    if (file.find("_workspace.hpp") != std::string::npos) continue;
    for (const std::string& line : lines_of(file))
      for (const char* const word : {"TILTROTOR_NOINLINE", "union {", "reinterpret_cast", "Workspace {"})
        if (!CHECK(line.find(word) == std::string::npos)) NOTE(word << " in " << file);
  }
}

// derivative.hpp is the flow of data: memory has other headers, and their names are all it knows of it.
TEST(house_flow_of_data_speaks_of_no_memory) {
  const std::regex memory("workspace|\\broom|overlay|noinline|memory|union|preaccumulate|LocalDual",
                          std::regex::icase);
  for (const std::string& line : lines_of("include/tiltrotor/model/derivative.hpp"))
    if (!CHECK(!std::regex_search(line, memory))) NOTE(line);
}

// An inner namespace NAME_detail belongs to one header; its own test may look inside.
TEST(house_details_stay_in_their_header) {
  std::map<std::string, std::set<std::string>> users;
  const std::regex inner("\\b\\w+_detail\\b");
  for (const std::string& file : sources({"include", "src", "bench"}))
    for (const std::string& line : lines_of(file))
      for (std::sregex_iterator match(line.begin(), line.end(), inner), end; match != end; ++match)
        users[match->str()].insert(file);
  CHECK_LE(15u, users.size());
  for (const auto& [name, files] : users)
    if (!CHECK_EQ(files.size(), 1u))
      for (const std::string& file : files) NOTE(name << " in " << file);
}

// Enumerations of the headers are scoped, so that no enumerator counts as a number unasked: but for sides and the
// settings of the FMU, which are places in arrays.
TEST(house_enumerations_are_scoped) {
  const std::regex open("\\s*enum (?!class |(Side|Setting) \\{)[^;]*\\{?.*");
  for (const std::string& file : sources({"include", "src", "bench"}, "\\w+\\.hpp"))
    for (const std::string& line : lines_of(file))
      if (!CHECK(!std::regex_match(line, open))) NOTE(file << ": " << line);
}

// One word for the caller's memory: workspace.
TEST(house_memory_is_called_workspace) {
  const std::regex other("\\b(rooms?|Room|[A-Z][a-z]+Rooms?|Overlay|ModelMemory|waist)\\b");
  for (const std::string& file : sources({"include"})) {
    // Room for a signal, for text, and a height over a parabola.
    if (std::regex_search(file, std::regex("(momentum_range|trim_explanation|response)\\.hpp"))) continue;
    std::smatch match;
    for (const std::string& line : lines_of(file))
      if (!CHECK(!std::regex_search(line, match, other))) NOTE(match[1] << " in " << file);
  }
}

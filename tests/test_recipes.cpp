// What the recipes of src/README.md would leave to memory: lists that stand in two places, where neither the
// compiler nor a number shows that one of them is short. Expected: the other place.
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "check.hpp"
#include "run_program.hpp"
#include "tiltrotor/model/aircraft/rotor_tables.hpp"

using check::source_path;

namespace {

std::string content_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}
std::string content(const std::string& name) { return content_of(source_path(name)); }

// First groups of all matches.
std::vector<std::string> found(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  std::vector<std::string> all;
  for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match)
    all.push_back((*match)[1]);
  return all;
}

bool has_word(const std::string& text, const std::string& word) {
  return std::regex_search(text, std::regex("\\b" + word + "\\b"));
}

// Members of plain structs, read from their headers: "R area;", "R sl, bl;", "R wash_fit[5];".
struct Member {
  std::string type, name, size;
};
using Structs = std::map<std::string, std::vector<Member>>;

Structs structs_of(const std::string& source) {
  Structs structs;
  const std::string text = std::regex_replace(source, std::regex("//[^\\n]*"), "");
  const std::regex definition("struct (\\w+) \\{([^}]*)\\}");
  for (std::sregex_iterator match(text.begin(), text.end(), definition), end; match != end; ++match) {
    std::vector<Member>& members = structs[(*match)[1]];
    const std::string body = (*match)[2];
    const std::regex line("\\n  (const char\\*|[A-Za-z_]+)(<[^>]*>)? (\\w[^;(]*);");
    for (std::sregex_iterator one(body.begin(), body.end(), line); one != end; ++one) {
      std::istringstream names((*one)[3]);
      for (std::string name; std::getline(names, name, ',');) {
        std::smatch part;
        if (std::regex_match(name, part, std::regex("\\s*(\\w+)(?:\\[([^\\]]+)\\])?(?: = .*)?")))
          members.push_back({(*one)[1], part[1], part[2]});
      }
    }
  }
  return structs;
}

// Elements of an array that must be filled: of flap settings the first, since an aircraft has two to six.
int elements(const std::string& size) {
  if (size == "kSectionRegions") return tiltrotor::kSectionRegions;
  if (size == "kSectionRegions - 1") return tiltrotor::kSectionRegions - 1;
  return size.empty() || size == "kMostFlapSettings" ? 1 : std::stoi(size);
}

// Members that make_aircraft() of the generated text leaves at zero.
void unfilled(const Structs& structs, const std::string& type, const std::string& place,
              const std::set<std::string>& given, std::vector<std::string>& missing) {
  if (given.count(place) != 0) return;
  const auto members = structs.find(type);
  if (members == structs.end()) {
    missing.push_back(place);
    return;
  }
  for (const Member& member : members->second) {
    const int size = elements(member.size);
    for (int i = 0; i < size; ++i)
      unfilled(structs, member.type,
               place + (place.empty() ? "" : ".") + member.name +
                   (member.size.empty() ? "" : "[" + std::to_string(i) + "]"),
               given, missing);
  }
}

std::set<std::string> given_fields(const std::string& generated) {
  std::set<std::string> given;
  for (const std::string& field : found(generated, "\\n  a\\.([\\w.\\[\\]]+) = ")) {
    given.insert(field);
    given.insert(std::regex_replace(field, std::regex("\\.node$"), ""));
  }
  return given;
}

}  // namespace

// A row of src/tablegen/aircraft_fields.cpp, or a line of aircraft_tables.cpp, that was forgotten.
TEST(house_every_number_of_the_aircraft_is_filled) {
  std::string headers = content("include/tiltrotor/model/aircraft/aircraft.hpp");
  for (const std::string& name : found(headers, "#include \"tiltrotor/(model/aircraft/\\w+\\.hpp)\""))
    headers += content("include/tiltrotor/" + name);
  headers += content("include/tiltrotor/model/aircraft/mast_range.hpp");
  const Structs structs = structs_of(headers);
  const std::string generated = content_of(TILTROTOR_BINARY_DIR "/generated/aircraft_tables.inc");
  std::set<std::string> given = given_fields(generated);
  CHECK_LE(180u, given.size());
  CHECK_LE(16u, structs.at("Aircraft").size());
  CHECK_LE(30u, structs.at("WingTables").size());
  std::vector<std::string> missing;
  unfilled(structs, "Aircraft", "", given, missing);
  CHECK(missing.empty());
  for (const std::string& name : missing) NOTE("Aircraft::" << name << " is given by no row of tablegen");

  // The test is not blind: without its row a number, a table and an element of an array are missed.
  for (const char* const row : {"rotor.radius", "fin.drag", "rotor.region_edge[2]", "rotor.coning.at_90"}) {
    std::set<std::string> fewer = given;
    CHECK_EQ(fewer.erase(row), 1u);
    missing.clear();
    unfilled(structs, "Aircraft", "", fewer, missing);
    if (CHECK_EQ(missing.size(), 1u)) CHECK_EQ(missing[0], std::string(row));
  }
}

// A section that is declared and not among the `parts` of the report.
TEST(house_every_section_of_the_report_is_shown) {
  const std::string report = content("src/study/report.cpp");
  const std::size_t begin = report.find("parts = {");
  const std::string parts = report.substr(begin, report.find("};", begin) - begin);
  const std::vector<std::string> sections = found(content("src/study/sections.hpp"), "\\nSection (\\w+)\\(");
  CHECK_LE(12u, sections.size());
  for (const std::string& section : sections)
    if (!CHECK(has_word(parts, section))) NOTE(section << " is not shown");
}

// A switch without the test of what it changes, and one with a range that prepare() does not look at.
TEST(house_every_option_has_its_test) {
  const Structs structs = structs_of(content("include/tiltrotor/model/variables/options.hpp"));
  const std::string tests = content("tests/model/test_options.cpp");
  const std::string ranges = content("include/tiltrotor/model/setup/setup_range.hpp");
  CHECK_LE(30u, structs.at("Options").size());
  for (const Member& option : structs.at("Options")) {
    if (!CHECK(has_word(tests, "o\\." + option.name))) NOTE(option.name << " is switched by no test");
    const bool has_range = option.type == "int" || option.type == "double";
    if (has_range && !CHECK(has_word(ranges, "o\\." + option.name))) NOTE(option.name << " has no range");
  }
}

// A quantity of the setup that prepare() takes whatever it is.
TEST(house_every_setting_has_its_range) {
  const Structs structs = structs_of(content("include/tiltrotor/model/setup/configuration.hpp"));
  const std::string ranges = content("include/tiltrotor/model/setup/setup_range.hpp");
  CHECK_LE(8u, structs.at("ConfigurationSetting").size());
  for (const Member& setting : structs.at("ConfigurationSetting"))
    if (!CHECK(has_word(ranges, "setup\\." + setting.name))) NOTE(setting.name << " has no range");
}

// A component whose change under a switch would go unseen.
TEST(house_every_component_is_watched_by_the_tests_of_switches) {
  const std::string loads = content("include/tiltrotor/model/variables/loads.hpp");
  const std::string tests = content("tests/model/test_options.cpp");
  const std::size_t begin = loads.find("enum class Component");
  const std::string list = loads.substr(begin, loads.find("count", begin) - begin);
  const std::vector<std::string> components = found(list, "\\n  (\\w+),");
  CHECK_LE(12u, components.size());
  for (const std::string& name : components)
    if (!CHECK(has_word(tests, "component\\(Component::" + name))) NOTE(name << " is not compared");
}

// A command that is declared and not offered, or offered and not among those whose help is tested.
TEST(house_every_command_is_offered_and_tested) {
  const std::string main = content("src/cli/all_commands.cpp");
  const std::string tests = content("tests/cli/test_help.cpp");
  const std::vector<std::string> commands =
      found(content("src/cli/command.hpp"), "\\nCommand (\\w+)_command\\(");
  CHECK_LE(10u, commands.size());
  for (const std::string& name : commands) {
    if (!CHECK(has_word(main, name + "_command"))) NOTE(name << " is not offered");
    if (!CHECK(tests.find("\"" + name + "\"") != std::string::npos)) NOTE(name << ": its help is not tested");
  }
}

// A function of the C interface that is given no bad input by the fuzzer, or one that asks for the processor and
// is not tried on an older one. What answers with a status has arguments to refuse.
TEST(house_every_call_is_tried) {
  const auto all_in = [](const std::vector<std::string>& functions, const std::string& file) {
    CHECK_LE(16u, functions.size());
    const std::string text = content(file);
    for (const std::string& name : functions)
      if (!CHECK(has_word(text, name))) NOTE(name << " is not in " << file);
  };
  const std::string headers = content("include/tiltrotor/tiltrotor.h") +
                              content("include/tiltrotor/conditions.h") +
                              content("include/tiltrotor/measure.h") +
                              content("include/tiltrotor/systems.h") + content("include/tiltrotor/sensors.h");
  all_in(found(headers, "\\ntr_status (tr_\\w+)\\("), "tests/fuzz/test_c_interface.cpp");
  all_in(found(content("src/library/c_entry.cpp") + content("src/library/c_entry_sensors.cpp") +
                   content("src/library/c_entry_checks.cpp"),
               "decltype\\(::(tr_\\w+)\\)"),
         "tests/toolchain/every_call.c");
}

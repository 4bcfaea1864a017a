// src/python/tiltrotor.py declares the C interface as the headers do. Expected: the text of the headers.
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "check.hpp"
#include "run_program.hpp"

using check::source_path;

namespace {

std::string content(const std::string& name) {
  std::ifstream in(source_path(name), std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

std::string single_blanks(const std::string& text) {
  const std::string one = std::regex_replace(text, std::regex("\\s+"), " ");
  return std::regex_replace(one, std::regex("^ | $"), "");
}

// Every C header, without remarks: what a program includes.
std::string headers() {
  std::string text;
  for (const char* const name : {"tiltrotor", "conditions", "measure", "systems", "sensors"})
    text += content(std::string("include/tiltrotor/") + name + ".h");
  std::string out;
  for (std::size_t at = 0, end = 0; at < text.size(); at = end) {
    const std::size_t open = text.find("/*", at);
    out += text.substr(at, open - at);
    end = open == std::string::npos ? text.size() : text.find("*/", open) + 2;
  }
  return out;
}

using Matches = std::vector<std::smatch>;
Matches matches(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  return Matches(std::sregex_iterator(text.begin(), text.end(), expression), std::sregex_iterator());
}

// "int32_t a; tr_real b, c[2];" as "int32_t a", "tr_real b", "tr_real c[2]", in order.
std::vector<std::string> members(const std::string& body) {
  std::vector<std::string> out;
  std::istringstream declarations(body);
  for (std::string one; std::getline(declarations, one, ';');) {
    const std::string declared = single_blanks(one);
    if (declared.empty()) continue;
    const std::string type = declared.substr(0, declared.find(' '));
    std::istringstream names(declared.substr(declared.find(' ') + 1));
    for (std::string name; std::getline(names, name, ',');) out.push_back(type + " " + single_blanks(name));
  }
  return out;
}

using Numbers = std::map<std::string, long long>;

// A sum of numbers and of names that are known.
long long value_of(const std::string& expression, const Numbers& known) {
  std::istringstream terms(std::regex_replace(expression, std::regex("\\+"), " "));
  long long sum = 0;
  for (std::string term; terms >> term;) {
    const bool is_number = std::isdigit(static_cast<unsigned char>(term[0])) != 0;
    if (!is_number && !CHECK(known.count(term) == 1)) NOTE(term);
    sum += is_number ? std::stoll(term, nullptr, 0) : known.at(term);
  }
  return sum;
}

// Enumerators of the headers, and macros that are plain numbers.
Numbers numbers_of_headers(const std::string& text) {
  Numbers known;
  for (const std::smatch& enumeration : matches(text, "enum(?: \\w+)? \\{([^}]*)\\}")) {
    std::istringstream items(enumeration[1]);
    long long next = 0;
    for (std::string item; std::getline(items, item, ',');) {
      const std::string one = single_blanks(item);
      const std::size_t equals = one.find(" = ");
      const std::string name = one.substr(0, equals);
      const std::string given = one.substr(equals == std::string::npos ? one.size() : equals + 3);
      known[name] = given.empty() ? next : value_of(given, known);
      next = known[name] + 1;
    }
  }
  for (const char* const macro : {"TR_SAVED_SIZE", "TR_MOST_LOADS"})
    known[macro] = std::stoll(matches(text, std::string("#define ") + macro + " (\\d+)").at(0)[1]);
  return known;
}

// "(A, B) = range(1, 3)", "(A, B) = ( 1, 2)" and "A = 1" at the beginning of a line.
Numbers numbers_of_python(const std::string& text) {
  Numbers known;
  const auto names_in = [](std::string list) {
    std::vector<std::string> names;
    std::istringstream in(std::regex_replace(list, std::regex("[,\\s]+"), " "));
    return std::vector<std::string>(std::istream_iterator<std::string>(in), {});
  };
  for (const std::smatch& tuple : matches(text, "\n\\(([\\w,\\s]+)\\) = (range)?\\(([^)]*)\\)")) {
    const std::vector<std::string> names = names_in(tuple[1]), given = names_in(tuple[3]);
    const bool range = tuple[2].matched;
    if (range)
      CHECK_EQ(static_cast<long long>(names.size()), std::stoll(given.at(1)) - std::stoll(given.at(0)));
    for (std::size_t k = 0; k < names.size(); ++k)
      known[names[k]] =
          range ? std::stoll(given.at(0)) + static_cast<long long>(k) : std::stoll(given.at(k), nullptr, 0);
  }
  for (const std::smatch& one : matches(text, "\n(TR_\\w+) = (\\d{1,9})(?=\n)"))
    known[one[1]] = std::stoll(one[2]);
  return known;
}

}  // namespace

TEST(python_structures_are_those_of_the_headers) {
  const std::string c = headers(), python = content("src/python/tiltrotor.py");
  std::map<std::string, std::vector<std::string>> made;
  for (const std::smatch& one :
       matches(python, "\n(tr_\\w+) = _structure\\(\"(\\w+)\", \"([^\"]+)\",\\s*((?:\"[^\"]*\"\\s*)+)\\)")) {
    CHECK_EQ(one[1].str(), one[2].str());
    CHECK(one[3].length() > 10);  // says what it is
    made[one[1]] = members(std::regex_replace(one[4].str(), std::regex("\"\\s*\"|\""), ""));
  }
  const Matches structures = matches(c, "typedef struct (tr_\\w+) \\{([^}]*)\\} tr_\\w+;");
  CHECK_EQ(structures.size(), made.size());
  for (const std::smatch& one : structures) {
    const std::vector<std::string> expected = members(one[2]);
    CHECK(!expected.empty());
    if (!CHECK(made[one[1]] == expected)) NOTE(one[1].str());
  }
}

TEST(python_functions_are_those_of_the_headers) {
  const std::string python = content("src/python/tiltrotor.py");
  const std::size_t begin = python.find("_DECLARATIONS = \"\"\"");
  const std::string declared = python.substr(begin, python.find("\"\"\"\n", begin + 20) - begin);
  const std::string pattern = "\n((?:const )?\\w+\\*? tr_\\w+\\([^;{]*\\));";
  std::set<std::string> in_c, in_python;
  for (const std::smatch& one : matches(headers(), pattern)) in_c.insert(single_blanks(one[1]));
  for (const std::smatch& one : matches(declared, pattern)) in_python.insert(single_blanks(one[1]));
  for (const std::string& one : in_c)
    if (!CHECK(in_python.count(one) == 1)) NOTE("not in tiltrotor.py: " << one);
  for (const std::string& one : in_python)
    if (!CHECK(in_c.count(one) == 1)) NOTE("not in the headers: " << one);
  CHECK_LE(50u, in_c.size());
}

TEST(python_constants_are_those_of_the_headers) {
  const std::string c = headers(), python = content("src/python/tiltrotor.py");
  const Numbers expected = numbers_of_headers(c), made = numbers_of_python(python);
  for (const auto& [name, number] : expected)
    if (!CHECK(made.count(name) == 1 && made.at(name) == number)) NOTE(name << " = " << number);
  for (const auto& [name, number] : made)
    if (!CHECK(expected.count(name) == 1)) NOTE(name << " is not in the headers");
  CHECK_LE(100u, expected.size());
  // Those that know the precision, single before double in both.
  for (const char* const name : {"TR_API_VERSION", "TR_SIM_SIZE"}) {
    const Matches of_c = matches(c, std::string("#define ") + name + " (\\w+?)u?\\b");
    const Matches of_python = matches(python, std::string("\n") + name + " = (\\w+) if _single else (\\w+)");
    if (!CHECK(of_c.size() == 2 && of_python.size() == 1)) continue;
    for (const std::size_t k : {0u, 1u}) CHECK_EQ(of_c[k][1].str(), of_python[0][k + 1].str());
  }
  const std::string sizes = matches(python, "\nTR_WORK_SIZE = (\\w+ if _single else \\w+)").at(0)[1];
  const auto of_work = [&](const char* precision) {
    return matches(c, std::string("#else\\s+(?:#define \\w+ \\d+\\s+)*#define TR_") + precision +
                          "_WORK_SIZE (\\d+)")
        .at(0)[1]
        .str();
  };
  CHECK_EQ(sizes, of_work("SINGLE") + " if _single else " + of_work("DOUBLE"));
  const std::string start = matches(c, "TR_HASH_START UINT64_C\\((\\d+)\\)").at(0)[1];
  CHECK(python.find("TR_HASH_START = " + start + "\n") != std::string::npos);
  const std::string version = matches(c, "TR_API_VERSION 0x(\\w{4})0008u").at(0)[1];
  CHECK(python.find("_INTERFACE = " + std::to_string(std::stoi(version, nullptr, 16)) + "\n") !=
        std::string::npos);
}

// The library itself by Python: sizes, a trim, derivatives against differences, a saved aircraft, and every refusal.
TEST(python_flies_where_python_is) {
  if (!std::string(TILTROTOR_CROSS).empty() || !std::string(TILTROTOR_RUNNER).empty()) return;
  const std::string tool = check::quoted(source_path("tests/tool.sh"));
  const check::ProgramResult there = check::run_program(tool + " python_flies python3 python3");
  if (there.exit_status != 0) {
    NOTE(there.out);
    return;
  }
  const check::ProgramResult run =
      check::run_program("TILTROTOR_LIBRARY=$(ls " + check::quoted(TILTROTOR_BINARY_DIR) +
                         "/libtiltrotor.so.[0-9]* | head -n 1) " +
                         "PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=" + check::quoted(source_path("src/python")) +
                         " python3 " + check::quoted(source_path("tests/python/flies.py")));
  if (!CHECK_EQ(run.exit_status, 0)) NOTE(run.out << run.err);
}

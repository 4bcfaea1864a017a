// The pages for people: files, goals and tests they name are there, and the table of symbols is complete.
// Expected: the tree, the Makefile and the names of the library.
#include <fnmatch.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

#include "check.hpp"
#include "run_program.hpp"
#include "tiltrotor/model/variables/loads.hpp"
#include "tiltrotor/tiltrotor.h"

using check::source_path;
using Names = std::set<std::string>;

namespace {

const char* const kTheory = "include/tiltrotor/README.md";
const char* const kSymbols = "include/tiltrotor/SYMBOLS.md";
const char* const kPages[] = {"README.md",
                              kTheory,
                              kSymbols,
                              "include/tiltrotor/NUMERICS.md",
                              "include/tiltrotor/POLICY.md",
                              "include/tiltrotor/systems/README.md",
                              "src/README.md",
                              "src/CONTRIBUTING.md",
                              "src/CHANGELOG.md",
                              "tests/README.md",
                              "tables/README.md",
                              "src/cli/README.md",
                              "src/examples/README.md",
                              "src/fmu/README.md",
                              "bench/README.md"};

std::string content(const std::string& name) {
  std::ifstream in(source_path(name), std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

// First groups of all matches, line by line.
std::vector<std::string> found(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  std::vector<std::string> all;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    for (std::sregex_iterator match(line.begin(), line.end(), expression), end; match != end; ++match)
      all.push_back((*match)[1]);
  return all;
}

bool is(const std::string& word, const std::string& pattern) {
  return std::regex_match(word, std::regex(pattern));
}

// What stands in backticks; lines of code are set off by four blanks and hold none.
std::vector<std::string> quoted_words(const std::string& page) {
  return found(std::regex_replace(content(page), std::regex("\n"), " "), "`([^`]+)`");
}

// Files and folders of the tree (these with a slash at their end), from its root.
Names tree() {
  namespace fs = std::filesystem;
  Names names = {"Makefile", "README.md", ".clang-format", ".clang-tidy"};
  for (const char* const part : {".ci", "bench", "include", "src", "tables", "tests"}) {
    names.insert(std::string(part) + "/");
    for (const auto& entry : fs::recursive_directory_iterator(source_path(part)))
      names.insert(fs::relative(entry.path(), source_path("")).string() + (entry.is_directory() ? "/" : ""));
  }
  return names;
}

bool is_file_name(const std::string& word) {
  return is(word, "[\\w.*/-]*\\.(hpp|cpp|h|c|md|csv|mk|sh|txt|svg)") ||
         is(word, "(\\.ci|bench|include|src|tables|tests|math|model|analysis)/[\\w.*/-]*");
}

// Whether something in the tree is called so, with any folders before; NAME stands for any name.
bool exists(const Names& tree, const std::string& word) {
  const std::string pattern = std::regex_replace(word, std::regex("NAME"), "*");
  for (const std::string& name : tree) {
    for (std::size_t at = 0; at != std::string::npos;) {
      for (const char* const end : {"", "/"})
        if (fnmatch((pattern + end).c_str(), name.c_str() + at, FNM_PATHNAME | FNM_PERIOD) == 0) return true;
      const std::size_t slash = name.find('/', at);
      at = slash == std::string::npos || slash + 1 == name.size() ? std::string::npos : slash + 1;
    }
  }
  return false;
}

Names goals(const Names& tree) {
  Names names;
  for (const std::string& file : tree)
    if (file == "Makefile" || is(file, ".*\\.mk"))
      for (const std::string& goal : found(content(file), "^([a-z-]+):.*## ")) names.insert(goal);
  return names;
}

// Goals of a command line: its words but variables, what is quoted, and a remark.
std::vector<std::string> goals_of(const std::string& command) {
  std::istringstream words(std::regex_replace(command, std::regex("\"[^\"]*\"|#.*"), ""));
  std::vector<std::string> all;
  std::string word;
  for (words >> word; words >> word;)
    if (word.find('=') == std::string::npos && word[0] != '-') all.push_back(word);
  return all;
}

}  // namespace

TEST(pages_name_files_that_exist) {
  const Names all = tree();
  CHECK(!exists(all, "model/no_such_file.hpp") && !exists(all, "src/no_such_folder/"));
  int count = 0;
  for (const char* const page : kPages) {
    for (const std::string& word : quoted_words(page)) {
      if (!is_file_name(word)) continue;
      ++count;
      if (!CHECK(exists(all, word))) NOTE(page << ": " << word);
    }
  }
  CHECK_LE(150, count);
}

TEST(pages_name_goals_that_exist) {
  const Names known = goals(tree());
  int count = 0;
  for (const char* const page : kPages) {
    std::vector<std::string> commands = found(content(page), "^    (make .*)");
    for (const std::string& word : quoted_words(page))
      if (word.compare(0, 5, "make ") == 0) commands.push_back(word);
    for (const std::string& command : commands) {
      for (const std::string& goal : goals_of(command)) {
        ++count;
        if (!CHECK(known.count(goal) == 1)) NOTE(page << ": " << command << ": no goal " << goal);
      }
    }
  }
  CHECK_LE(30, count);
}

// Names that end in a star, of choices too, and those that can be nothing but tests.
TEST(pages_name_tests_that_exist) {
  const Names all = tree();
  const std::vector<std::string> choices = found(content("tables/xv15/choices.csv"), "^(\\w+),");
  Names tests(choices.begin(), choices.end());
  for (const std::string& file : all)
    if (is(file, "tests/.*\\.cpp"))
      for (const std::string& name : found(content(file), "^TEST(?:_OF_XV15)?\\((\\w+)\\)"))
        tests.insert(name);
  int count = 0;
  for (const char* const page : kPages) {
    for (const std::string& word : quoted_words(page)) {
      const bool family = is(word, "[a-z0-9_]+_\\*");
      if (!family && !is(word, "(cli|slow|pages)_\\w*[a-z]")) continue;
      ++count;
      const std::string name = family ? word.substr(0, word.size() - 1) : word;
      const auto place = tests.lower_bound(name);
      const bool there =
          place != tests.end() && (family ? place->compare(0, name.size(), name) == 0 : *place == name);
      if (!CHECK(there)) NOTE(page << ": " << word);
    }
  }
  CHECK_LE(15, count);
}

// Links and pictures: relative to the page that has them.
TEST(pages_link_files_that_exist) {
  int count = 0;
  for (const char* const page : kPages) {
    const std::string folder = std::string(page).substr(0, std::string(page).rfind('/') + 1);
    for (const std::string& target : found(content(page), "\\]\\(([^#)][^)]*)\\)")) {
      ++count;
      const std::string path = (page == std::string("README.md") ? "" : folder) + target;
      if (!CHECK(std::filesystem::exists(source_path(path)))) NOTE(page << ": " << target);
    }
  }
  CHECK_LE(2, count);
}

// "One header for C++": every other one of the library is reached from it.
TEST(pages_one_header_reaches_all) {
  std::set<std::string> reached = {"tiltrotor/tiltrotor.hpp"};
  std::vector<std::string> open(reached.begin(), reached.end());
  while (!open.empty()) {
    const std::string header = open.back();
    open.pop_back();
    for (const std::string& next : found(content("include/" + header), "^#include \"(tiltrotor/[^\"]+)\""))
      if (reached.insert(next).second) open.push_back(next);
  }
  for (const std::string& file : tree())
    if (is(file, "include/.*\\.hpp") && !CHECK(reached.count(file.substr(8)) == 1)) NOTE(file);
}

// The README's programs, as they stand there, by the compilers of this machine.
TEST(pages_programs_of_the_readme_compile) {
  std::vector<std::string> programs;
  bool inside = false;
  std::istringstream lines(content("README.md"));
  for (std::string line; std::getline(lines, line);) {
    if (is(line, "    #include .*") && !inside) programs.emplace_back();
    inside = line.compare(0, 4, "    ") == 0 && (inside || is(line, "    #include .*"));
    if (inside) programs.back() += line.substr(4) + "\n";
  }
  if (!CHECK_EQ(programs.size(), 2u)) return;
  const std::string flags =
      " -I" + check::quoted(source_path("include")) + " -fsyntax-only -Wall -Wextra -Werror -x ";
  for (const std::string& program : programs) {
    const bool c = program.find("tiltrotor.hpp") == std::string::npos;
    const std::string compiler = TILTROTOR_CXX + flags + (c ? "c++ -" : "c++ -std=c++17 -");
    const check::ProgramResult result =
        check::run_program("printf %s " + check::quoted(program) + " | " + compiler);
    if (!CHECK_EQ(result.exit_status, 0)) NOTE(result.err);
  }
}

// Those of the folder for CMake are the README's, as are the lines that build them.
TEST(pages_project_of_cmake_is_that_of_the_readme) {
  const std::string readme = content("README.md");
  for (const char* const file : {"CMakeLists.txt", "example.c", "example.cpp"}) {
    const std::string text = content(std::string("src/examples/cmake/") + file);
    const std::string typed = std::regex_replace("\n" + text, std::regex("\n(?=[^\n])"), "\n    ");
    CHECK_LE(100u, text.size());
    if (!CHECK(readme.find(typed) != std::string::npos)) NOTE(file);
  }
}

// The version wherever a page or a remark shows it: that of the Makefile.
TEST(pages_tell_the_version) {
  const std::string version = TILTROTOR_VERSION, series = version.substr(0, version.rfind('.'));
  const struct {
    const char *file, *pattern;
    std::string expected;
  } mentions[] = {{"README.md", "version = \\{([\\d.]+)\\}", version},
                  {"src/fmu/README.md", "TILTROTOR_VERSION='\"([\\d.]+)\"'", version},
                  {"src/examples/README.md", "TILTROTOR_VERSION=.{2}([\\d.]+)\\\\", version},
                  {"include/tiltrotor/tiltrotor.h", "tr_version.*\"([\\d.]+)\"", version},
                  {"src/text/identity.hpp", "\"tiltrotor ([\\d.]+),", version},
                  {"src/text/identity.hpp", "\"version\": \"([\\d.]+)\"", version},
                  {"src/cli/stamp.hpp", "tiltrotor ([\\d.]+),", version},
                  {"src/examples/check.sh", "find_package\\(tiltrotor ([\\d.]+) ", series},
                  {"src/examples/README.md", "Versions ([\\d.]+)\\.x", series},
                  {"src/library/tiltrotorConfigVersion.cmake.in", "one series, ([\\d.]+)\\.x", series}};
  for (const auto& mention : mentions) {
    const std::vector<std::string> told = found(content(mention.file), mention.pattern);
    if (!CHECK(!told.empty())) NOTE(mention.file << ": " << mention.pattern);
    for (const std::string& one : told)
      if (!CHECK_EQ(one, mention.expected)) NOTE(mention.file);
  }
  CHECK_EQ(found(content("src/CHANGELOG.md"), "^## ([\\d.]+),").at(0), version);
}

// Whoever passes the page on passes on the notices too.
TEST(pages_page_carries_its_licences) {
  const check::ProgramResult page = check::run_program(
      "cd " + check::quoted(source_path("")) +
      " && src/page/assemble.sh LICENSE LICENSE tables/xv15 tables/xv15/published/handling_qualities.csv "
      "src/page/explore.html src/page/style.css src/page/numbers.js");
  CHECK_EQ(page.exit_status, 0);
  CHECK(page.out.find(content("LICENSE")) != std::string::npos);
  for (const char* const part : {"wasi-libc", "musl", "libc++", "Apache License 2.0 with LLVM exceptions"})
    if (!CHECK(page.out.find(part) != std::string::npos)) NOTE(part);
}

TEST(pages_name_every_state_input_and_component) {
  const std::vector<std::string> words = quoted_words(kSymbols);
  const Names named(words.begin(), words.end());
  Names wanted;
  for (int i = 0; i < TR_STATES; ++i) wanted.insert(tr_state_name(i));
  for (int j = 0; j < TR_CONTROLS; ++j) wanted.insert(tr_control_name(j));
  for (const char* const component : tiltrotor::kComponentNames) wanted.insert(component);
  for (const std::string& name : wanted)
    if (!CHECK(named.count(name) == 1)) NOTE(name << " is not in " << kSymbols);
}

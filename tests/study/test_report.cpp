// The report as a whole: tables, published points, page, and the files of a run.
// Expected: well-formed XML, the files of published numbers themselves.

#include <filesystem>
#include <fstream>
#include <iterator>

#include "check.hpp"
#include "cli/scratch_folder.hpp"
#include "plot/xml_check.hpp"
#include "run_program.hpp"
#include "study/page.hpp"
#include "study/reference_points.hpp"
#include "study/wording.hpp"

using namespace tiltrotor::study;

namespace {

std::string content(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

}  // namespace

TEST(report_table_reads_what_it_writes) {
  Table table({"name", "value"});
  table.comment("a comment");
  table.add({std::string("with, comma and \"quotes\""), -0.125});
  table.add({std::string(), double(NAN)});
  const Table again = Table::parse(table.csv(), "again.csv");
  CHECK_EQ(again.csv(), table.csv());
  CHECK_EQ(again.text(0, "name"), "with, comma and \"quotes\"");
  CHECK_EQ(again.number(0, "value"), -0.125);
  CHECK(std::isnan(again.number(1, "value")));
  CHECK_EQ(again.where("value", -0.125).rows(), 1u);
}

TEST(report_table_names_the_line_of_a_fault) {
  std::string message;
  try {
    (void)Table::parse("# c\na,b\n1,2\n3\n", "points.csv");
  } catch (const std::exception& error) {
    message = error.what();
  }
  CHECK(message.find("points.csv:4") == 0);
}

// Every file of published numbers is in the program, has its source, and nothing but numbers where numbers
// belong.
TEST_OF_XV15(report_published_points_are_complete) {
  int sets = 0;
  for (const auto& entry : std::filesystem::directory_iterator(check::source_path("tables/xv15/published"))) {
    if (entry.path().extension() != ".csv") continue;
    ++sets;
    const Table set = reference_points(entry.path().stem().string());
    CHECK(set.rows() > 0);
    CHECK_EQ(set.csv(), Table::parse(content(entry.path()), "file").csv());
    std::string comments;
    for (const std::string& line : set.comments()) comments += line;
    bool has_source = false;
    for (const char* word : {"Source", "Original", "NASA", "Yuan"}) {
      has_source = has_source || comments.find(word) != std::string::npos;
    }
    if (!CHECK(has_source)) NOTE(entry.path().string());
  }
  CHECK(sets >= 10);
}

TEST(report_page_is_well_formed_with_any_text) {
  Section section{"one", "A <b> & \"c\"", "reading & more", {}, {}, {}};
  section.pictures.push_back({"p", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>"});
  Table table({"a_b", "c"});
  table.add({std::string("<x> & 'y'"), 1.5});
  section.tables.push_back({"t", "what < that", table});
  section.findings.push_back({Finding::differs, "1 < 2 & 3", "\"quoted\""});
  CHECK_EQ(check::XmlChecker::fault(page({"T & T", "<lead>", {"a < b"}}, {section})), "");
}

TEST(report_wording) {
  CHECK_EQ(fixed(-0.456, 2), "-0.46");
  CHECK_EQ(fixed(-0.001, 2), "0.00");
  CHECK_EQ(with_sign(0.456, 1), "+0.5");
  CHECK_EQ(root_text(-1, 0), "-1.000");
}

TEST_OF_XV15(slow_report_writes_whole_files) {
  const check::ScratchFolder folder;
  const std::string path = folder.path("out");
  const check::ProgramResult run = check::run_tiltrotor("report --output " + path);
  if (!CHECK_EQ(run.exit_status, 0)) return;
  const std::string last = path + "/index.html\n";
  CHECK(run.out.size() > last.size() &&
        run.out.compare(run.out.size() - last.size(), last.size(), last) == 0);
  int drawings = 0;
  int tables = 0;
  for (const auto& entry : std::filesystem::directory_iterator(path)) {
    const std::string text = content(entry.path());
    const std::string kind = entry.path().extension().string();
    if (kind == ".svg" || kind == ".html") {
      const std::string fault = check::XmlChecker::fault(text);
      if (!CHECK(fault.empty())) NOTE(entry.path().string() << ": " << fault);
      CHECK(text.find("NaN") == std::string::npos && text.find("=\"nan") == std::string::npos &&
            text.find("inf\"") == std::string::npos);
      for (const char* word : {"Aircraft: ", "Governor: ", "Inflow: "}) {
        if (!CHECK(text.find(word) != std::string::npos))
          NOTE(entry.path().string() << " does not say its " << word);
      }
      ++drawings;
    } else if (entry.path().filename() == "run.txt") {
      CHECK(text.find("tiltrotor ") == 0);
    } else if (CHECK_EQ(kind, ".csv")) {
      CHECK(Table::parse(text, entry.path().string()).rows() > 0);
      ++tables;
    }
  }
  CHECK(drawings > 20 && tables > 10);

  // A run that cannot write leaves the report as it was: here a folder stands where a table would go.
  const std::string page_before = content(path + "/index.html");
  const std::string trim_before = content(path + "/trim_curves.csv");
  std::filesystem::remove(path + "/power_required.csv");
  std::filesystem::create_directory(path + "/power_required.csv");
  const check::ProgramResult failed = check::run_tiltrotor("report --output " + path);
  CHECK_EQ(failed.exit_status, 2);
  CHECK(failed.err.find('\n') == failed.err.size() - 1);
  CHECK_EQ(content(path + "/index.html"), page_before);
  CHECK_EQ(content(path + "/trim_curves.csv"), trim_before);
  for (const auto& entry : std::filesystem::directory_iterator(path)) {
    CHECK(entry.path().string().find(".part") == std::string::npos);
  }
}

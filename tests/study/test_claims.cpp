// What the page says follows from the numbers beside it, and says of what program and day it is.
// Expected: the numbers of the same run, counted again; tables of the paper.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"
#include "study/reference_points.hpp"
#include "study/section.hpp"
#include "study/validation_rules.hpp"

using namespace tiltrotor::study;
using check::CsvText;
using check::run_tiltrotor;

namespace {

std::string content(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

Table table_of(const std::string& folder, const std::string& name) {
  return Table::parse(content(folder + "/" + name + ".csv"), name);
}

// The paragraph of the page that a statement begins, with its verdict.
std::string finding(const std::string& page, const std::string& statement) {
  const std::size_t at = page.find(statement);
  if (at == std::string::npos) return "";
  const std::size_t begin = page.rfind("<li", at);
  return page.substr(begin, page.find("</li>", at) - begin);
}

}  // namespace

TEST(report_verdict_counts_what_holds) {
  CHECK(verdict_of(3, 3) == Finding::holds && verdict_of(2, 3) == Finding::partly);
  CHECK(verdict_of(0, 3) == Finding::differs);
}

// Tables 1 and 2 of J. Aircraft 57 (2020) 985: minimum, maximum, mean.
TEST_OF_XV15(report_paper_timing_is_as_printed) {
  const Table paper = reference_points("paper_timing");
  const double automatic[] = {0.23, 0.31, 0.27, 0.01, 0.01, 0.01, 0.64, 0.71,
                              0.66, 1.22, 1.37, 1.29, 1.79, 1.94, 1.88};
  const double numerical[] = {5.42, 12.8, 7.14, 5.88, 7.62, 6.01};
  const char* cases[] = {"minimum", "maximum", "mean"};
  if (!CHECK_EQ(paper.rows(), std::size(automatic))) return;
  for (std::size_t i = 0; i < paper.rows(); ++i) {
    CHECK_EQ(paper.text(i, "case"), std::string(cases[i % 3]));
    CHECK_EQ(paper.number(i, "automatic_s"), automatic[i]);
    if (i < std::size(numerical)) CHECK_EQ(paper.number(i, "numerical_s"), numerical[i]);
  }
}

// A cause explains differences on its side; a bound that is met leaves nothing to explain.
TEST_OF_XV15(validation_causes_fit_their_side) {
  const Tolerance bound = tolerance_of("paper_claims", "growth_change_1_per_s", 0);
  const auto of_bound = [&](double difference) {
    return cause_of(bound, "paper_claims", "growth_change_1_per_s", 0, difference);
  };
  CHECK(contains(of_bound(0.004), "bound is met"));
  CHECK_EQ(of_bound(-0.0005), bound.cause);
  const Tolerance power = tolerance_of("rotor_hover", "cp", double(NAN));
  CHECK(contains(cause_of(power, "rotor_hover", "cp", double(NAN), -1e-5), "less induced power"));
  CHECK(contains(cause_of(power, "rotor_hover", "cp", double(NAN), 1e-5), "drag"));
  const Tolerance gain = tolerance_of("transfer_functions", "gain_db", 90);
  CHECK(contains(cause_of(gain, "transfer_functions", "gain_db", 90, 1), "elevator"));
  CHECK(!contains(cause_of(gain, "transfer_functions", "gain_db", 0, 1), "elevator"));
  const Table causes = reference_points("validation_causes");
  for (std::size_t i = 0; i < causes.rows(); ++i) {
    CHECK(causes.text(i, "side") == "above" || causes.text(i, "side") == "below");
    CHECK(!causes.text(i, "cause").empty());
    CHECK(
        tolerance_of(causes.text(i, "set"), causes.text(i, "quantity"), causes.number(i, "mast_deg")).judged);
  }
}

TEST(cli_version_names_aircraft_and_json_names_the_program) {
  const std::string version = run_tiltrotor("version").out;
  CHECK(contains(version, "tiltrotor ") && contains(version, "aircraft "));
  const std::string numbered = version.substr(0, version.find(','));  // "tiltrotor 0.2.0"
  const std::string number = numbered.substr(numbered.find(' ') + 1);
  const std::string program = "\"program\": {\"name\": \"tiltrotor\", \"version\": \"" + number + "\", ";
  for (const char* command :
       {"trim --speed 40", "modes --speed 40", "linearize --speed 40", "linearize --speed 40,45",
        "loads --speed 40", "rotor", "respond --duration 0.01"}) {
    if (!CHECK(contains(run_tiltrotor(std::string(command) + " --format json").out, program))) NOTE(command);
    CHECK(!contains(run_tiltrotor(std::string(command) + " --format csv").out, number));
  }
  CHECK(contains(run_tiltrotor("linearize --speed 40 --format matlab").out, "% " + numbered));
}

TEST_OF_XV15(slow_report_says_what_its_numbers_say) {
  const check::ScratchFolder folder;
  const std::string path = folder.path("out");
  const std::string another = folder.path("again");
  setenv("SOURCE_DATE_EPOCH", "86400", 1);
  CHECK_EQ(run_tiltrotor("report --output " + path).exit_status, 0);
  CHECK_EQ(run_tiltrotor("report --output " + another).exit_status, 0);
  unsetenv("SOURCE_DATE_EPOCH");
  const std::string page = content(path + "/index.html");

  // Of what: program, aircraft, day.
  std::string version = run_tiltrotor("version").out;
  version.erase(version.find('\n'));  // below stands a sentence on the aircraft
  CHECK(contains(page, version + "; run of 1970-01-02"));
  CHECK_EQ(content(path + "/run.txt"), version + "\n1970-01-02\n");
  for (const auto& entry : std::filesystem::directory_iterator(path)) {
    const std::string name = entry.path().filename().string();
    if (name.find("timing") != std::string::npos || entry.path().extension() == ".html") continue;
    if (!CHECK(content(entry.path()) == content(another + "/" + name))) NOTE(name);
  }

  // Roots before the input are those of the trim.
  const CsvText trim(run_tiltrotor("modes --mast 0 --speed 40 --format csv").out);
  const Table before =
      table_of(path, "response_modes").where("case", std::string("flap 40/25")).where("time_s", 0.0);
  CHECK(before.rows() > 3);
  for (std::size_t i = 0; i < before.rows(); ++i) {
    bool found = false;
    for (std::size_t k = 0; k < trim.rows.size(); ++k) {
      found = found || (trim.text(k, "mode") == before.text(i, "mode") &&
                        std::abs(trim.number(k, "real") - before.number(i, "real")) < 1e-6);
    }
    if (!CHECK(found)) NOTE(before.text(i, "mode"));
  }

  // Helicopter mode is unstable at every speed, and the page counts so.
  const Table helicopter = table_of(path, "modes").where("mast_deg", 0.0);
  std::size_t growing = 0;
  for (const std::string& speed : helicopter.different("speed_mps")) {
    double fastest = -1;
    for (const double real : helicopter.where("speed_mps", speed).numbers("real"))
      fastest = std::max(fastest, real);
    growing += fastest > 0;
  }
  const std::string stability = finding(page, "Unstable only in hover and at low speed.");
  CHECK(contains(stability, "mast 0 deg " + std::to_string(growing) + " of " +
                                std::to_string(helicopter.different("speed_mps").size())));
  CHECK_EQ(contains(stability, "differs"), 2 * growing > helicopter.different("speed_mps").size());

  // No reason for a growth that is none, none of better damping where the root grows.
  const Table rows = table_of(path, "validation");
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    if (contains(rows.text(i, "cause"), "better damped")) CHECK_LT(rows.number(i, "difference"), 0.0);
  }

  // Both tables of the paper, open, with this run beside them.
  const Table timing = table_of(path, "paper_timing");
  CHECK_EQ(timing.rows(), 15u);
  for (const double seconds : timing.numbers("here_automatic_s")) CHECK(seconds >= 0);
  const std::size_t shown = page.find("paper_timing.csv</a>");
  CHECK(contains(page.substr(shown, 200), "<details open"));

  // On paper wide tables lie across and break their words instead of running off.
  CHECK(contains(page, "@page wide") && contains(page, "<div class=\"files wide\">"));
}

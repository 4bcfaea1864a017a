// The validation: what it demands, that it holds, and that its list of known exceedances cannot go stale.
// Expected: the files of published numbers themselves; lists changed on purpose.

#include <filesystem>
#include <fstream>
#include <iterator>

#include "check.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"
#include "study/reference_points.hpp"
#include "study/validation.hpp"
#include "study/validation_rules.hpp"

using namespace tiltrotor::study;

namespace {

std::string content(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

// The tables of a report as it wrote them.
std::vector<Section> written_sections(const std::string& folder) {
  Section all{"all", "all", "", {}, {}, {}};
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".csv") continue;
    const std::string name = entry.path().stem().string();
    all.tables.push_back({name, "", Table::parse(content(entry.path()), name)});
  }
  return {all};
}

// The list without its first row, or with another row at the end.
Table without_first(const Table& list) {
  Table result(list.columns());
  for (std::size_t i = 1; i < list.rows(); ++i)
    result.add({list.text(i, 0), list.text(i, 1), list.text(i, 2), list.text(i, 3)});
  return result;
}
Table with(Table list, const std::string& set, const std::string& point, const std::string& quantity) {
  list.add({set, point, quantity, std::string("a reason")});
  return list;
}

}  // namespace

TEST_OF_XV15(validation_tolerances_and_bounds) {
  const Tolerance speed = tolerance_of("conversion_corridor", "minimum_speed_mps", 30);
  CHECK(speed.judged);
  CHECK_EQ(allowed(speed, 50), 4.1);  // 8 kt
  CHECK_EQ(allowed(tolerance_of("trim_gtrs_figures", "pitch_deg", 0), 5), 0.7);
  CHECK_EQ(allowed(tolerance_of("trim_gtrs_figures", "pitch_deg", 30), 5), 1.8);
  CHECK_NEAR(allowed(tolerance_of("trim_gtrs_printed", "thrust_n", 0), -1000), 25.0, 1e-12);
  // The larger of 50 lb and a tenth.
  const Tolerance force = tolerance_of("component_loads_gtrs", "rotor_right_x_lbf", double(NAN));
  CHECK_EQ(allowed(force, 100), 50.0);
  CHECK_EQ(allowed(force, 1000), 100.0);
  CHECK(!tolerance_of("trim_other_sheng_model", "pitch_deg", 0).judged);
  const Tolerance bound = tolerance_of("paper_claims", "climb_mps", 0);
  CHECK_EQ(shortfall(bound, 3, 0), 0.0);
  CHECK_EQ(shortfall(bound, -3, 0), 3.0);
  CHECK_EQ(shortfall(speed, -3, 0), 3.0);
  bool refused = false;
  try {
    (void)tolerance_of("no such set", "pitch_deg", 0);
  } catch (const std::runtime_error&) {
    refused = true;
  }
  CHECK(refused);
}

TEST_OF_XV15(validation_sets_have_kind_and_source) {
  const Table sets = reference_points("validation_sets");
  for (std::size_t i = 0; i < sets.rows(); ++i) {
    CHECK_EQ(sets.where("set", sets.text(i, "set")).rows(), 1u);
    CHECK(!sets.text(i, "kind").empty() && !sets.text(i, "source").empty());
  }
  const Table rules = reference_points("validation_tolerances");
  for (std::size_t i = 0; i < rules.rows(); ++i) {
    CHECK_EQ(sets.where("set", rules.text(i, "set")).rows(), 1u);
    CHECK(!rules.text(i, "cause").empty());
  }
}

TEST_OF_XV15(slow_validation_holds_and_its_list_is_true) {
  const check::ScratchFolder folder;
  const std::string path = folder.path("out");
  const check::ProgramResult run = check::run_tiltrotor("report --validate --output " + path);
  if (!CHECK_EQ(run.exit_status, 0)) NOTE(run.err);

  const Table rows = Table::parse(content(path + "/validation.csv"), "validation.csv");
  double last = HUGE_VAL;
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    CHECK(!rows.text(i, "cause").empty() && !rows.text(i, "source").empty() && !rows.text(i, "kind").empty());
    CHECK_EQ(rows.where("set", rows.text(i, "set"))
                 .where("point", rows.text(i, "point"))
                 .where("quantity", rows.text(i, "quantity"))
                 .rows(),
             1u);
    if (rows.text(i, "ratio").empty()) continue;  // without a number here, or not judged
    CHECK(rows.number(i, "ratio") <= last);
    last = rows.number(i, "ratio");
  }
  for (const std::string& set : reference_points("validation_sets").different("set")) {
    if (!CHECK(rows.where("set", set).rows() > 0)) NOTE(set);
  }

  const Table known = reference_points("known_exceedances");
  CHECK_EQ(rows.where("status", std::string("known")).rows(), known.rows());
  const std::vector<Section> sections = written_sections(path);
  CHECK_EQ(validate(sections, known).faults.size(), 0u);
  // One missing: a number exceeds its tolerance. One too many: it is within, or nothing is compared there.
  const Validation missing = validate(sections, without_first(known));
  CHECK_EQ(missing.faults.size(), 1u);
  CHECK(missing.faults[0].find("exceeds its tolerance: " + known.text(0, "set")) == 0);
  const Table within = rows.where("status", std::string("within"));
  const Validation better = validate(
      sections, with(known, within.text(0, "set"), within.text(0, "point"), within.text(0, "quantity")));
  CHECK_EQ(better.faults.size(), 1u);
  CHECK(better.faults[0].find("within tolerance now") == 0);
  CHECK_EQ(better.rows.where("status", std::string("better")).rows(), 1u);
  const Validation unknown = validate(sections, with(known, "trim_flight", "nowhere", "pitch_deg"));
  CHECK_EQ(unknown.faults.size(), 1u);
  CHECK(unknown.faults[0].find("known exceedance that is not compared") == 0);
}

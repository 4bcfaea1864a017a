// The table generator on broken copies of the tables: exit code 2, one line `file:line: message`, no output
// left.
// Expected: file and line of the fault that the test itself makes.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "check.hpp"
#include "run_program.hpp"
#include "temporary.hpp"

namespace {

namespace fs = std::filesystem;

using Lines = std::vector<std::string>;

// A copy of the tables in a folder of its own, removed at the end.
class Copy {
 public:
  Copy() : base_(check::new_temporary_folder()) {
    fs::copy(check::source_path("tables/xv15"), base_ / "tables", fs::copy_options::recursive);
  }
  ~Copy() {
    std::error_code ignored;
    fs::remove_all(base_, ignored);
  }
  Copy(const Copy&) = delete;
  Copy& operator=(const Copy&) = delete;

  fs::path file(const std::string& name) const { return base_ / "tables" / name; }
  fs::path output() const { return base_ / "out" / "tables.inc"; }

  Lines read(const std::string& name) const {
    std::ifstream in(file(name));
    Lines lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
  }
  void write(const std::string& name, const Lines& lines) const {
    std::ofstream out(file(name));
    for (const std::string& line : lines) out << line << "\n";
  }
  check::ProgramResult generate() const {
    fs::create_directories(output().parent_path());
    return check::run_program(check::built("tablegen") + " " + check::quoted((base_ / "tables").string()) +
                              " " + check::quoted(output().string()));
  }

 private:
  fs::path base_;
};

// First line that begins with `start`, counted from 1.
int line_of(const Lines& lines, const std::string& start) {
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lines[i].compare(0, start.size(), start) == 0) return static_cast<int>(i) + 1;
  throw std::runtime_error("no line begins with " + start);
}

void expect_refusal(const Copy& copy, const std::string& name, int line, const std::string& word) {
  fs::create_directories(copy.output().parent_path());
  std::ofstream(copy.output()) << "of an earlier run\n";
  const check::ProgramResult result = copy.generate();
  CHECK_EQ(result.exit_status, 2);
  CHECK(result.out.empty());
  const std::string start = copy.file(name).string() + ":" + std::to_string(line) + ": ";
  if (!CHECK(result.err.compare(0, start.size(), start) == 0))
    NOTE("expected " << start << ", got " << result.err);
  if (!CHECK(result.err.find(word) != std::string::npos)) NOTE("expected '" << word << "' in " << result.err);
  CHECK_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1);
  CHECK(fs::is_empty(copy.output().parent_path()));
}

// Replaces the line that begins with `start` by `text`; that line is where the fault is.
void expect_refusal_of_line(const std::string& name, const std::string& start, const std::string& text,
                            const std::string& word) {
  const Copy copy;
  Lines lines = copy.read(name);
  const int line = line_of(lines, start);
  lines[static_cast<std::size_t>(line) - 1] = text;
  copy.write(name, lines);
  expect_refusal(copy, name, line, word);
}

TEST(tablegen_accepts_the_tables) {
  const Copy copy;
  const check::ProgramResult result = copy.generate();
  CHECK_EQ(result.exit_status, 0);
  CHECK(result.err.empty());
  CHECK(fs::is_regular_file(copy.output()));
  const auto written =
      std::distance(fs::directory_iterator(copy.output().parent_path()), fs::directory_iterator());
  CHECK_EQ(written, 1);
}

TEST(tablegen_takes_another_aircraft) {
  const Copy copy;
  Lines lines = copy.read("aircraft.csv");
  lines[static_cast<std::size_t>(line_of(lines, "wing_area,")) - 1] =
      "wing_area,200.0,ft2,18.580608,m2,another,high";
  copy.write("aircraft.csv", lines);
  // One knot more in a table.
  Lines drag = copy.read("airframe/t4-XVI_pylon_lateral_drag.csv");
  const int row = line_of(drag, "0,0");
  drag.insert(drag.begin() + row, "1.5,0.001");
  copy.write("airframe/t4-XVI_pylon_lateral_drag.csv", drag);
  CHECK_EQ(copy.generate().exit_status, 0);
  std::ifstream in(copy.output());
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  CHECK(text.find("a.wing.area = R(18.580608);  // wing_area 200.0 ft2") != std::string::npos);
  CHECK(text.find("R(0.0), R(1.5),") != std::string::npos);
}

// tables.csv and identity.csv: each row has its line.
TEST(tablegen_refuses_a_table_without_its_files) {
  {
    const Copy copy;
    Lines lines = copy.read("tables.csv");
    lines.push_back("fin.unheard,,,,airframe/t6-III_vtail_CD.csv");
    copy.write("tables.csv", lines);
    expect_refusal(copy, "tables.csv", static_cast<int>(lines.size()), "no table 'fin.unheard'");
    lines.pop_back();
    lines.erase(lines.begin() + line_of(lines, "fin.drag,") - 1);
    copy.write("tables.csv", lines);
    expect_refusal(copy, "tables.csv", static_cast<int>(lines.size()), "no row for table 'fin.drag'");
  }
  expect_refusal_of_line("tables.csv", "wing.downwash,,15,",
                         "wing.downwash,,0,,airframe/t4-V_d_wing_downwash_bm15.csv", "do not increase");
  expect_refusal_of_line("tables.csv", "wing.downwash,,15,",
                         "wing.downwash,,100,,airframe/t4-V_d_wing_downwash_bm15.csv", "outside 0..90");
  expect_refusal_of_line("tables.csv", "fin.sidewash,,0,2,",
                         "fin.sidewash,,0,3,airframe/t6-V_sidewash_FL2_bm00.csv", "flap settings");
  expect_refusal_of_line("tables.csv", "fin.sidewash,,0,2,",
                         "fin.sidewash,,0,9,airframe/t6-V_sidewash_FL2_bm00.csv", "none of 1..4");
  expect_refusal_of_line("tables.csv", "fin.drag,", "fin.drag,,,,airframe/t6-III_vtail_CD",
                         "no name of a .csv file");
}

TEST(tablegen_refuses_an_aircraft_without_identity) {
  expect_refusal_of_line("identity.csv", "id,", "id,0", "whole number");
  expect_refusal_of_line("identity.csv", "id,", "id,1.5", "whole number");
  expect_refusal_of_line("identity.csv", "name,", "name,", "plain characters");
}

TEST(tablegen_refuses_numbers_that_the_model_cannot_take) {
  expect_refusal_of_line("aircraft.csv", "rotor_blades,", "rotor_blades,2,count,2,count,source,high",
                         "3 to 12 blades");
  expect_refusal_of_line("aircraft.csv", "engine_count,", "engine_count,3,count,3,count,source,high",
                         "an engine beside each rotor");
  expect_refusal_of_line("choices.csv", "mass_max,", "mass_max,2000,kg,reason", "not above 'mass_min'");
  expect_refusal_of_line("aircraft.csv", "rotor_rpm_airplane,",
                         "rotor_rpm_airplane,51.7,rpm,5.414011,rad/s,source,high",
                         "outside 'rotor_speed_min'");
}

TEST(tablegen_takes_any_number_of_flap_settings) {
  const Copy copy;
  Lines choices = copy.read("choices.csv");
  choices.erase(choices.begin() + line_of(choices, "flap_setting_4,") - 1);
  copy.write("choices.csv", choices);
  Lines files = copy.read("tables.csv");
  files.erase(std::remove_if(files.begin(), files.end(),
                             [](const std::string& line) { return line.find("_FL4_") != std::string::npos; }),
              files.end());
  copy.write("tables.csv", files);
  Lines loss = copy.read("airframe/t4-XII_aileron_lift_loss.csv");
  loss.erase(loss.begin() + line_of(loss, "FL4,") - 1);
  copy.write("airframe/t4-XII_aileron_lift_loss.csv", loss);
  CHECK_EQ(copy.generate().exit_status, 0);
  std::ifstream in(copy.output());
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  CHECK(text.find("a.wing.flap_settings = 3;") != std::string::npos);
  CHECK(text.find("a.wing.lift_0[3]") == std::string::npos);
  expect_refusal_of_line("choices.csv", "flap_setting_3,", "flap_setting_3,10,deg,reason", "do not increase");
}

TEST(tablegen_refuses_hole_in_a_column) {
  expect_refusal_of_line("airframe/t5-II_htail_CL_mach.csv", "-2,", "-2,-0.155,,-0.176", "hole");
}

TEST(tablegen_refuses_empty_cell_without_rule) {
  expect_refusal_of_line("airframe/t3-V_fuselage_M_alpha.csv", "-180,", "-180,", "empty cell");
}

TEST(tablegen_refuses_repeated_knot) {
  expect_refusal_of_line("airframe/t5-III_htail_CD.csv", "4,", "0,0.015,0.015,0.015,0.015", "repeated");
}

TEST(tablegen_refuses_knots_out_of_order) {
  expect_refusal_of_line("rotor_airfoil/c81_region1_inboard_cd.csv", "4,", "-4,0.014,0.014,0.135",
                         "increase");
}

TEST(tablegen_refuses_columns_out_of_order) {
  expect_refusal_of_line("rotor_airfoil/c81_region1_inboard_cd.csv", "alpha_deg,", "alpha_deg,M000,M075,M055",
                         "increase");
}

TEST(tablegen_refuses_what_is_no_finite_number) {
  for (const std::string bad :
       {"nan", "inf", "-Infinity", "1e999", "0x10", "1.2.3", "1,5", "twelve", "--1", "1e"}) {
    const bool splits = bad.find(',') != std::string::npos;
    expect_refusal_of_line("airframe/t3-I_fuselage_L_alpha.csv", "-176,", "-176," + bad,
                           splits ? "cells" : "not a finite number");
  }
}

TEST(tablegen_refuses_number_of_cells) {
  expect_refusal_of_line("airframe/t4-VIII_wing_Cm.csv", "15,", "15,0.07,-0.01,-0.09", "4 cells");
}

TEST(tablegen_refuses_missing_column) {
  const Copy copy;
  const std::string name = "airframe/t4-VIII_wing_Cm.csv";
  Lines lines = copy.read(name);
  const int header = line_of(lines, "bm_deg");
  for (std::size_t i = static_cast<std::size_t>(header) - 1; i < lines.size(); ++i)
    lines[i].erase(lines[i].rfind(','));
  copy.write(name, lines);
  expect_refusal(copy, name, header, "'FL4' is missing");
}

// The files of one composite table must have the same columns.
TEST(tablegen_refuses_column_missing_in_one_file_of_several) {
  const Copy copy;
  const std::string name = "airframe/t2-I_b_rotor_wake_htail_bm15.csv";
  Lines lines = copy.read(name);
  const int header = line_of(lines, "alpha_F_deg");
  for (std::size_t i = static_cast<std::size_t>(header) - 1; i < lines.size(); ++i)
    lines[i].erase(lines[i].rfind(','));
  copy.write(name, lines);
  expect_refusal(copy, name, header, "columns differ");
}

TEST(tablegen_refuses_repeated_column) {
  expect_refusal_of_line("airframe/t4-VIII_wing_Cm.csv", "bm_deg", "bm_deg,FL1,FL2,FL3,FL3", "twice");
}

TEST(tablegen_refuses_missing_file) {
  for (const std::string name : {"airframe/t6-VIII_rotor_sidewash_factor.csv",
                                 "rotor_airfoil/blade_twist.csv", "aircraft.csv", "choices.csv"}) {
    const Copy copy;
    fs::remove(copy.file(name));
    expect_refusal(copy, name, 1, "missing");
  }
}

TEST(tablegen_refuses_missing_folder) {
  const check::ProgramResult result =
      check::run_program(check::built("tablegen") + " /nonexistent /tmp/nothing.inc");
  CHECK_EQ(result.exit_status, 2);
  CHECK_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1);
}

TEST(tablegen_refuses_too_many_knots) {
  const Copy copy;
  const std::string name = "airframe/t1-III_side_by_side_factor.csv";
  Lines lines = copy.read(name);
  const int header = line_of(lines, "mubar_abs");
  lines.resize(static_cast<std::size_t>(header));
  for (int i = 0; i < 129; ++i) lines.push_back(std::to_string(i) + ",0");
  copy.write(name, lines);
  expect_refusal(copy, name, header + 129, "128 knots");
}

// Tables in another unit must say so in another way than by silence.
TEST(tablegen_refuses_table_that_does_not_state_its_unit) {
  const Copy copy;
  const std::string name = "airframe/t3-V_fuselage_M_alpha.csv";
  Lines lines = copy.read(name);
  for (std::string& line : lines) {
    const std::size_t at = line.find("ft3");
    if (at != std::string::npos) line.replace(at, 3, "m3");
  }
  copy.write(name, lines);
  expect_refusal(copy, name, line_of(lines, "alpha_F_deg"), "ft3");
}

TEST(tablegen_refuses_unknown_unit) {
  expect_refusal_of_line("aircraft.csv", "wing_span,", "wing_span,32.17,furlong,9.805416,m,x,high",
                         "furlong");
  expect_refusal_of_line("choices.csv", "tip_loss,", "tip_loss,0.97,percent,because", "percent");
}

TEST(tablegen_refuses_unit_of_another_kind) {
  expect_refusal_of_line("choices.csv", "downwash_arm,", "downwash_arm,6.83,deg,because", "cannot be turned");
}

TEST(tablegen_refuses_wrong_si_value) {
  expect_refusal_of_line("aircraft.csv", "wing_span,", "wing_span,32.17,ft,9.805400,m,x,high", "SI value");
  expect_refusal_of_line("aircraft.csv", "wing_span,", "wing_span,32.17,ft,9.805416,kg,x,high", "SI unit");
  // Finite as written, infinite in SI.
  expect_refusal_of_line("aircraft.csv", "wing_span,", "wing_span,1e308,slug,1,kg,x,high", "SI value");
}

TEST(tablegen_refuses_repeated_and_missing_entries) {
  expect_refusal_of_line("aircraft.csv", "wing_area_geometric,", "wing_area,181.0,ft2,16.81545,m2,x,high",
                         "twice");
  // A missing entry is reported at the end of the file.
  const Copy copy;
  Lines lines = copy.read("aircraft.csv");
  lines.erase(lines.begin() + (line_of(lines, "rotor_radius,") - 1));
  copy.write("aircraft.csv", lines);
  expect_refusal(copy, "aircraft.csv", static_cast<int>(lines.size()), "'rotor_radius' is missing");
}

TEST(tablegen_refuses_entry_without_value) {
  expect_refusal_of_line("aircraft.csv", "rotor_radius,", "rotor_radius,,ft,,m,not found,missing",
                         "no value");
}

TEST(tablegen_refuses_choice_without_reason) {
  expect_refusal_of_line("choices.csv", "tip_loss,", "tip_loss,0.97,ND,", "reason");
}

}  // namespace

// The command line in air that moves: speeds are relative to the air at the aircraft.
// Expected: the velocity triangle.
#include <cmath>
#include <fstream>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"

using check::CsvText;
using check::run_tiltrotor;

TEST(cli_respond_shows_airspeed_with_a_gust) {
  const CsvText calm(run_tiltrotor("respond --speed 40 --duration 0.01").out);
  const CsvText gusty(
      run_tiltrotor("respond --speed 40 --duration 0.01 --input gust_u=10mps@0 --input gust_v=-5mps@0").out);
  const double u = calm.number(0, "u_mps") - 10, v = calm.number(0, "v_mps") + 5, w = calm.number(0, "w_mps");
  CHECK_NEAR(calm.number(0, "speed_mps"), 40, 1e-6);
  CHECK_NEAR(gusty.number(0, "speed_mps"), std::sqrt(u * u + v * v + w * w), 1e-4);
  CHECK_NEAR(gusty.number(0, "u_mps"), calm.number(0, "u_mps"), 1e-9);
}

TEST(cli_linearize_names_the_airspeed_of_a_given_state) {
  const check::ScratchFolder folder;
  std::ifstream in(check::source_path("tests/reference/x0_mast30_v050.csv"));
  const std::string calm(std::istreambuf_iterator<char>(in), {});
  const std::size_t end = calm.find('\n');
  const std::string row = calm.substr(end + 1, calm.find('\n', end + 1) - end - 1);
  const std::string file = folder.write(
      "gusty.csv", calm.substr(0, end) + ",mast_deg,gust_u_mps\n" + row + ",30,0\n" + row + ",30,12\n");
  const CsvText model(run_tiltrotor("linearize --format csv --states " + file).out);
  const double u = std::strtod(row.c_str(), nullptr);
  const double w = std::strtod(check::csv_cells(row).at(2).c_str(), nullptr);
  CHECK_NEAR(model.number(0, "speed_mps"), std::hypot(u, w), 1e-6);
  CHECK_NEAR(model.number(model.rows.size() - 1, "speed_mps"), std::hypot(u - 12, w), 1e-6);
}

TEST(cli_conventions_say_which_velocity_is_which) {
  const std::string text = run_tiltrotor("conventions").out;
  for (const char* part : {"undisturbed air", "gust_u", "velocity - gust", "speed_mps"})
    CHECK(text.find(part) != std::string::npos);
}

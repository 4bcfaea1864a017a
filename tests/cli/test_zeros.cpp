// What is nothing is printed as 0: by mirror symmetry a straight flight has no side force, no rolling or yawing
// moment, and its longitudinal motion does not meet the lateral one. What is small but there is printed.
#include <cmath>
#include <set>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"
#include "text/rounding.hpp"

using check::CsvText;
using check::run_tiltrotor;

namespace {

const char* const flights[] = {"--mast 0 --speed 0", "--mast 0 --speed 40 --grid realtime",
                               "--mast 30 --speed 60", "--mast 60 --speed 80 --altitude 3000",
                               "--mast 90 --speed 100"};

bool is_lateral(const std::string& name) {
  return std::set<std::string>{
             "v",       "p",      "phi",   "r", "lat_stick", "pedal", "diff_collective", "diff_long_cyclic",
             "aileron", "rudder", "gust_v"}
             .count(name) > 0;
}
bool is_of_rotor(const std::string& name) {
  return name.find("_R") != std::string::npos || name.find("_L") != std::string::npos;
}

}  // namespace

TEST(cli_loads_of_symmetric_flight_have_no_rounding) {
  for (const char* flight : flights) {
    const CsvText loads(run_tiltrotor(std::string("loads ") + flight).out);
    const std::size_t total = loads.rows.size() - 1;
    CHECK_EQ(loads.text(total, "component"), "total_aero");
    for (const char* column : {"y_n", "l_nm", "n_nm"})
      if (!CHECK_EQ(loads.text(total, column), "0")) NOTE(flight << " " << column);
    for (std::size_t row = 0; row < total; ++row)
      if (loads.text(row, "component") == "wing_free")
        for (const char* column : {"y_n", "l_nm", "n_nm"}) CHECK_EQ(loads.text(row, column), "0");
  }
  // The fins of a hovering aircraft: 1e-8 N, and no rounding.
  const CsvText hover(run_tiltrotor("loads --speed 0").out);
  CHECK_EQ(hover.text(10, "component"), "fin_right");
  CHECK(hover.number(10, "x_n") != 0);
}

TEST(cli_linearize_symmetric_flight_is_decoupled_exactly) {
  for (const std::string flight : flights) {
    for (const std::string set : {"inceptors --reduce rigid", "all"}) {
      const CsvText model(run_tiltrotor("linearize " + flight + " --control-set " + set).out);
      int zeros = 0;
      for (std::size_t row = 0; row < model.rows.size(); ++row) {
        const std::string matrix = model.text(row, "matrix");
        const std::string rate = model.text(row, "row"), column = model.text(row, "column");
        const double value = model.number(row, "value");
        const bool point = matrix == "x0" || matrix == "u0";
        if (point && is_lateral(rate)) CHECK_EQ(value, 0.0);
        if (point || is_of_rotor(rate) || is_of_rotor(column) || is_lateral(rate) == is_lateral(column))
          continue;
        ++zeros;
        if (!CHECK_EQ(value, 0.0)) NOTE(flight << " " << matrix << " " << rate << " " << column);
      }
      CHECK_LT(20, zeros);
    }
  }
}

// A symmetric state off its trim, and the matrices along a flight.
TEST(cli_matrices_and_rates_of_symmetric_flight_have_no_rounding) {
  const check::ScratchFolder folder;
  const std::string flight = folder.path("s.csv");
  const std::string matrices = folder.path("matrices");
  CHECK_EQ(run_tiltrotor("respond --speed 0 --input collective=1deg@0 --duration 0.1 --output " + flight +
                         " --matrices " + matrices)
               .exit_status,
           0);
  const CsvText rates(run_tiltrotor("derivative --states " + flight).out);
  for (std::size_t row = 0; row < rates.rows.size(); ++row)
    for (const char* column : {"d_v", "d_p", "d_r", "d_phi", "d_psi"})
      if (!CHECK_EQ(rates.text(row, column), "0")) NOTE(row << " " << column);
  const CsvText a(folder.read("matrices/a.csv"));
  CHECK_EQ(a.text(0, "row"), "u");
  for (std::size_t row = 0; row < a.rows.size(); ++row)
    if (a.text(row, "row") == "u")
      for (const char* column : {"v", "p", "phi", "r"}) CHECK_EQ(a.text(row, column), "0");
}

// A hovering rotor has no force in its plane, whatever its stations.
TEST(cli_rotor_in_hover_has_no_force_in_its_plane) {
  for (const char* stations : {"", "--grid realtime", "--option azimuth_stations=7", "--speed-axial 30"}) {
    const CsvText rotor(run_tiltrotor(std::string("rotor --collective75 0:1:16 ") + stations).out);
    for (std::size_t row = 0; row < rotor.rows.size(); ++row)
      for (const char* column : {"force_aft_n", "force_advancing_n"})
        if (rotor.text(row, "status") == "ok") CHECK_EQ(rotor.text(row, column), "0");
  }
  const CsvText slow(run_tiltrotor("rotor --collective75 8 --speed-inplane 1e-6").out);
  CHECK_LT(1e-6, slow.number(0, "force_aft_n"));
}

TEST(cli_numbers_below_the_rounding_of_their_terms_are_zero) {
  using tiltrotor::text::without_rounding;
  CHECK_EQ(without_rounding(0.9e-12, 100), 0.0);
  CHECK_EQ(without_rounding(-0.9e-12, 100), 0.0);
  CHECK_EQ(without_rounding(1.1e-12, 100), 1.1e-12);
  CHECK_EQ(without_rounding(1e-300, 0), 1e-300);
  CHECK_EQ(without_rounding(1, HUGE_VAL), 1.0);
  CHECK(std::isnan(without_rounding(std::nan(""), 1)));
}

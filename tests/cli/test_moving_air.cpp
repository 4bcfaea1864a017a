// The command line in air that moves: speeds are relative to the air at the aircraft.
// Expected: the velocity triangle.
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

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

namespace {

// A flight with rates, sideslip and moving controls, body axes; the air moves with `gust` and the aircraft with it.
std::string carried_state(const double (&gust)[3]) {
  std::ostringstream text;
  text.precision(17);
  text
      << "mast_deg,psi,db1c_R,db1s_R,db1c_L,db1s_L,u,v,w,p,q,r,phi,theta,b1c_R,b1s_R,n0_R,nc_R,ns_R,b1c_L,b1s_L,n0_L,nc_L,ns_L,eps,th75_rad,lon_in,"
         "lat_in,ped_in,gust_u_mps,gust_v_mps,gust_w_mps\n30,0.3,0.01,-0.02,0.03,0.04,"
      << 50 + gust[0] << ',' << 3 + gust[1] << ',' << 2.5 + gust[2]
      << ",0.125,-0.0625,0.25,0.1,0.05,-0.02,-0.024,0.0106,0.009,-0.0004,-0.018,-0.02,0.011,0.008,0.0003,0.08,0.18,"
         "1.2,0.4,-0.3,"
      << gust[0] << ',' << gust[1] << ',' << gust[2] << '\n';
  return text.str();
}

constexpr double kCalm[3] = {0, 0, 0}, kGust[3] = {12, -7, 4.5};  // exact in binary, as their sums are
constexpr double kP = 0.125, kQ = -0.0625, kR = 0.25;

class Carried {
 public:
  explicit Carried(const std::string& command)
      : calm(run("calm.csv", command, kCalm)), moving(run("moving.csv", command, kGust)) {}

 private:
  CsvText run(const char* name, const std::string& command, const double (&gust)[3]) const {
    const auto result =
        run_tiltrotor(command + " --format csv --states " + folder_.write(name, carried_state(gust)));
    if (!CHECK_EQ(result.exit_status, 0)) NOTE(result.err);
    return CsvText(result.out);
  }
  check::ScratchFolder folder_;

 public:
  const CsvText calm, moving;
};

}  // namespace

// The same flight in air at rest: an aircraft that the air carries along has its loads, part for part.
TEST(cli_loads_of_an_aircraft_carried_by_the_air) {
  const Carried flight("loads");
  CHECK_EQ(flight.calm.rows.size(), 13u);
  for (std::size_t row = 0; row < flight.calm.rows.size(); ++row)
    for (const char* column : {"x_n", "y_n", "z_n", "l_nm", "m_nm", "n_nm"})
      CHECK_NEAR(flight.moving.number(row, column), flight.calm.number(row, column), 1e-7);
}

// Its rates differ by the turning of the axes alone, -omega x gust: the velocity of the state is that of the aircraft.
TEST(cli_derivative_of_an_aircraft_carried_by_the_air) {
  const Carried flight("derivative");
  const double turning[3] = {-(kQ * kGust[2] - kR * kGust[1]), -(kR * kGust[0] - kP * kGust[2]),
                             -(kP * kGust[1] - kQ * kGust[0])};
  int compared = 0;
  for (const std::string& column : flight.calm.columns) {
    if (column.compare(0, 2, "d_") != 0) continue;
    ++compared;
    const double expected = column == "d_u"   ? turning[0]
                            : column == "d_v" ? turning[1]
                            : column == "d_w" ? turning[2]
                                              : 0;
    if (!CHECK_NEAR(flight.moving.number(0, column) - flight.calm.number(0, column), expected, 1e-9))
      NOTE(column);
  }
  CHECK_EQ(compared, 24);
}

// Its linear model differs by the derivative of -omega x gust to omega; a gust acts as the opposite velocity does, but
// does not turn with the axes.
TEST(cli_linearize_of_an_aircraft_carried_by_the_air) {
  const Carried flight("linearize --control-set all");
  const auto value = [](const CsvText& model, const std::string& matrix, const std::string& row,
                        const std::string& column, double& found) {
    for (std::size_t i = 0; i < model.rows.size(); ++i) {
      if (model.text(i, "matrix") == matrix && model.text(i, "row") == row &&
          model.text(i, "column") == column) {
        found = model.number(i, "value");
        return true;
      }
    }
    return false;
  };
  const auto turned = [](const std::string& row, const std::string& column) {
    if (row == "u") return column == "q" ? -kGust[2] : column == "r" ? kGust[1] : 0;
    if (row == "v") return column == "r" ? -kGust[0] : column == "p" ? kGust[2] : 0;
    if (row == "w") return column == "p" ? -kGust[1] : column == "q" ? kGust[0] : 0;
    return 0.0;
  };
  const auto turning = [](const std::string& row, const std::string& column) {
    if (row == "u") return column == "v" ? kR : column == "w" ? -kQ : 0;
    if (row == "v") return column == "w" ? kP : column == "u" ? -kR : 0;
    if (row == "w") return column == "u" ? kQ : column == "v" ? -kP : 0;
    return 0.0;
  };
  int compared = 0, of_gusts = 0;
  CHECK_EQ(flight.calm.rows.size(), flight.moving.rows.size());
  for (std::size_t i = 0; i < flight.calm.rows.size(); ++i) {
    const std::string matrix = flight.calm.text(i, "matrix"), row = flight.calm.text(i, "row"),
                      column = flight.calm.text(i, "column");
    CHECK_NEAR(flight.moving.number(i, "speed_mps"), flight.calm.number(i, "speed_mps"), 1e-12);
    if (matrix != "A" && matrix != "B") continue;
    ++compared;
    const double calm = flight.calm.number(i, "value"), moving = flight.moving.number(i, "value");
    const double expected = calm + (matrix == "A" ? turned(row, column) : 0);
    if (!CHECK_NEAR(moving, expected, 1e-9 * (1 + std::abs(calm))))
      NOTE(matrix << ' ' << row << ' ' << column);
    if (matrix != "B" || column.compare(0, 5, "gust_") != 0) continue;
    ++of_gusts;
    const std::string velocity(1, column[5]);
    double slope = 0;
    CHECK(value(flight.moving, "A", row, velocity, slope));
    if (!CHECK_NEAR(moving, -(slope - turning(row, velocity)), 1e-9 * (1 + std::abs(slope))))
      NOTE(row << ' ' << column);
  }
  CHECK_LT(500, compared);
  CHECK_LT(60, of_gusts);
}

// In a gust from the first instant on, straight flight begins as the flight at that lower airspeed: every column that
// is not a velocity moves as it, to the order of the step.
TEST(cli_respond_begins_as_in_shifted_flight) {
  const CsvText gusty(
      run_tiltrotor("respond --mast 30 --speed 50 --duration 0.0002 --dt 0.0001 --input gust_u=4mps@0 "
                    "--input gust_v=-2mps@0 --input gust_w=1mps@0")
          .out);
  const CsvText calm(run_tiltrotor("respond --mast 30 --speed 50 --duration 0.0002 --dt 0.0001").out);
  const check::ScratchFolder folder;
  // The state at the start, in still air and with the velocity relative to the moving air.
  std::string names, numbers;
  for (const char* column : {"p_degps",
                             "q_degps",
                             "r_degps",
                             "roll_deg",
                             "pitch_deg",
                             "yaw_deg",
                             "b1c_rate_right_degps",
                             "b1s_rate_right_degps",
                             "b1c_rate_left_degps",
                             "b1s_rate_left_degps",
                             "collective75_deg",
                             "long_stick_from_neutral_in",
                             "lat_stick_in",
                             "pedal_in",
                             "b1c_right_deg",
                             "b1s_right_deg",
                             "n0_right",
                             "b1c_left_deg",
                             "b1s_left_deg",
                             "n0_left",
                             "downwash_deg",
                             "nc_right",
                             "ns_right",
                             "nc_left",
                             "ns_left",
                             "mast_deg"}) {
    names += std::string(column) + ',';
    numbers += calm.text(0, column) + ',';
  }
  std::ostringstream shifted;
  shifted.precision(17);
  shifted << names << "u,v,w\n"
          << numbers << calm.number(0, "u_mps") - 4 << ',' << calm.number(0, "v_mps") + 2 << ','
          << calm.number(0, "w_mps") - 1 << '\n';
  const CsvText rates(
      run_tiltrotor("derivative --format csv --states " + folder.write("shifted.csv", shifted.str())).out);
  const struct {
    const char *column, *rate;
    double unit;
  } compared[] = {{"u_mps", "d_u", 1},
                  {"v_mps", "d_v", 1},
                  {"w_mps", "d_w", 1},
                  {"p_degps", "d_p", 180 / M_PI},
                  {"q_degps", "d_q", 180 / M_PI},
                  {"r_degps", "d_r", 180 / M_PI},
                  {"n0_right", "d_n0_R", 1},
                  {"n0_left", "d_n0_L", 1}};
  for (const auto& k : compared) {
    const double slope = (gusty.number(1, k.column) - gusty.number(0, k.column)) / 1e-4;
    const double expected = rates.number(0, k.rate) * k.unit;
    if (!CHECK_NEAR(slope, expected, 0.02 * std::abs(expected) + 0.02)) NOTE(k.column);
  }
  CHECK_LT(0.5, std::abs(rates.number(0, "d_w")));  // the gust is felt
}

TEST(cli_conventions_say_which_velocity_is_which) {
  const std::string text = run_tiltrotor("conventions").out;
  for (const char* part : {"undisturbed air", "gust_u", "velocity - gust", "speed_mps"})
    CHECK(text.find(part) != std::string::npos);
}

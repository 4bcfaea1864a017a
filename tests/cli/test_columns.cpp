// The columns every command promises, in their order, and what a row without a trim looks like.
// Expected: the specification of the columns; weight and Newton's law for their numbers.
#include "check.hpp"
#include "cli/csv_text.hpp"
#include "run_program.hpp"
#include "this_aircraft.hpp"

using check::CsvText;
using check::first_line;
using check::run_tiltrotor;
using this_aircraft::flown;
using this_aircraft::given;
using this_aircraft::shortest;

namespace {

void check_header(const std::string& arguments, const std::string& promised) {
  const std::string header = first_line(run_tiltrotor(arguments).out);
  // More columns may follow.
  if (!CHECK((header + ",").compare(0, promised.size() + 1, promised + ",") == 0))
    NOTE(arguments << ": " << header);
}

}  // namespace

TEST(cli_columns_are_as_specified) {
  check_header(
      "trim --speed 40",
      "mast_deg,speed_mps,altitude_m,climb_deg,status,iterations,residual,pitch_deg,roll_deg,alpha_deg,"
      "sideslip_deg,collective75_deg,collective_root_deg,long_cyclic_deg,diff_collective_deg,"
      "diff_long_cyclic_deg,elevator_deg,aileron_deg,rudder_deg,long_stick_in,lat_stick_in,pedal_in,"
      "thrust_right_n,thrust_left_n,power_kw,download_frac");
  check_header("modes --speed 40",
               "mast_deg,speed_mps,axis,mode,real,imag,frequency_rad_s,damping_ratio,time_to_half_s");
  check_header("respond --speed 40 --duration 0.01",
               "time_s,u_mps,v_mps,w_mps,p_degps,q_degps,r_degps,roll_deg,pitch_deg,yaw_deg");
  check_header("loads --speed 40", "case,mast_deg,component,x_n,y_n,z_n,l_nm,m_nm,n_nm");
  check_header(
      "rotor",
      "collective75_deg,ct,cp,figure_of_merit,ct_sigma,thrust_n,power_kw,b1c_deg,b1s_deg,n0,efficiency");
}

// The status tells the decisive limit, the last column all of them.
TEST(cli_trim_lists_every_limit) {
  const CsvText trim(run_tiltrotor(flown("trim --climb -60 --speed 45 --grid realtime")).out);
  if (!CHECK_EQ(trim.rows.size(), 1u)) return;
  CHECK_EQ(trim.text(0, "status"), std::string("control_limit"));
  CHECK_EQ(trim.text(0, "limits").find("long_stick elevator gimbal_right gimbal_left"), 0u);
  CHECK_EQ(CsvText(run_tiltrotor(flown("trim --speed 40")).out).text(0, "limits"), std::string());
}

TEST(cli_trim_sweeps_every_combination) {
  const CsvText trim(run_tiltrotor(flown("trim --mast 0,30 --speed 40,45,50")).out);
  if (!CHECK_EQ(trim.rows.size(), 6u)) return;
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK_EQ(trim.text(i, "status"), std::string("ok"));
    CHECK_EQ(trim.number(i, "mast_deg"), i < 3 ? 0.0 : 30.0);
    CHECK_EQ(trim.number(i, "speed_mps"), given("--speed", 40.0 + 5.0 * static_cast<double>(i % 3)));
  }
}

// Altitude, mass and CG are the outer loops; each row is that of the aircraft alone.
TEST(cli_trim_and_modes_sweep_the_loading) {
  const std::string options = " --mast 0 --speed 0,40 --format csv ";
  const CsvText trim(
      run_tiltrotor(flown("trim" + options + "--altitude 0,2000 --mass 5000,6000 --cg-sl 300:2:302")).out);
  const double light = given("--mass", 5000), heavy = given("--mass", 6000);
  const std::string masses = shortest(light) + ":" + shortest(heavy - light) + ":" + shortest(heavy);
  const CsvText modes(
      run_tiltrotor(flown("modes" + options + "--altitude 0,2000") + " --mass " + masses).out);
  if (!CHECK_EQ(trim.rows.size(), 16u)) return;
  for (std::size_t i = 0; i < 16; ++i) {
    CHECK_EQ(trim.number(i, "altitude_m"), given("--altitude", i < 8 ? 0.0 : 2000.0));
    CHECK_EQ(trim.number(i, "mass_kg"), given("--mass", i / 4 % 2 == 0 ? 5000.0 : 6000.0));
    CHECK_NEAR(trim.number(i, "cg_sl_in"), given("--cg-sl", i / 2 % 2 == 0 ? 300.0 : 302.0), 1e-9);
    CHECK_EQ(trim.number(i, "speed_mps"), given("--speed", i % 2 == 0 ? 0.0 : 40.0));
  }
  const std::string last = "--altitude 2000 --mass 6000 ";
  const CsvText alone(run_tiltrotor(flown("trim --mast 0 --speed 40 --cg-sl 302 --format csv " + last)).out);
  CHECK(alone.rows.back() == trim.rows.back());
  const CsvText last_modes(run_tiltrotor(flown("modes" + options + last)).out);
  if (!CHECK_LT(last_modes.rows.size(), modes.rows.size())) return;
  const std::size_t first = modes.rows.size() - last_modes.rows.size();
  for (std::size_t i = 0; i < last_modes.rows.size(); ++i) CHECK(last_modes.rows[i] == modes.rows[first + i]);
}

// A message names the loading where one was given.
TEST(cli_message_names_the_loading) {
  const std::string mass = shortest(std::round(given("--mass", 6000)));
  const check::ProgramResult result =
      run_tiltrotor("trim --mast 90 --speed 20 --altitude 1000,2000 --mass " + mass);
  CHECK(result.err.find("trim: mast 90 deg, 20 m/s, 1000 m, " + mass + " kg: ") != std::string::npos);
  CHECK(result.err.find("trim: mast 90 deg, 20 m/s, 2000 m, " + mass + " kg: ") != std::string::npos);
}

// The stick is counted from its rear stop: 4.8 in the middle (GTRS); near that in hover.
TEST(cli_trim_counts_the_stick_from_the_rear_stop) {
  const CsvText trim(run_tiltrotor("trim").out);
  CHECK_NEAR(trim.number(0, "long_stick_in"), 5.27, 0.5);
  CHECK_NEAR(trim.number(0, "long_cyclic_deg"), 0.99, 0.5);
  const tiltrotor::Aircraft<double>& a = this_aircraft::numbers();
  CHECK_EQ(trim.number(0, "flap_deg"), a.defaults.flap_helicopter);
  CHECK_NEAR(trim.number(0, "rotor_rpm"), a.rotor.speed_helicopter * 30 / tiltrotor::kPi<double>, 1e-9);
}

TEST(cli_flight_without_trim_says_so) {
  const check::ProgramResult result = run_tiltrotor("trim --mast 90 --speed 20,80");
  CHECK_EQ(result.exit_status, 1);
  CHECK(result.err.find("trim: mast 90 deg, 20 m/s: ") != std::string::npos);
  const CsvText trim(result.out);
  if (!CHECK_EQ(trim.rows.size(), 2u)) return;
  CHECK(trim.text(0, "status") != "ok");
  CHECK_EQ(trim.text(1, "status"), std::string("ok"));
  for (const char* command : {"modes", "linearize", "loads", "respond"}) {
    CHECK_EQ(run_tiltrotor(std::string(command) + " --mast 90 --speed 20").exit_status, 1);
  }
}

TEST(cli_loads_at_trim_balance_the_weight) {
  const CsvText loads(run_tiltrotor("loads --mast 30 --speed 50").out);
  if (!CHECK_EQ(loads.rows.size(), 13u)) return;
  CHECK_EQ(loads.text(12, "component"), std::string("total_aero"));
  const double x = loads.number(12, "x_n");
  const double z = loads.number(12, "z_n");
  CHECK_NEAR(std::sqrt(x * x + z * z), this_aircraft::mass() * 13000 * 0.45359237 * 9.80665, 1e-4);
  for (const char* moment : {"l_nm", "m_nm", "n_nm"}) CHECK_NEAR(loads.number(12, moment), 0.0, 1e-4);
}

TEST(cli_rigid_model_has_eight_states) {
  const CsvText model(
      run_tiltrotor("linearize --mast 90 --speed 80 --reduce rigid --control-set blades").out);
  CHECK_EQ(model.rows.size(), 8u + 7u + 8u * 8u + 8u * 7u);
}

TEST(cli_respond_without_input_stays_in_trim) {
  const CsvText flight(run_tiltrotor("respond --mast 30 --speed 50 --duration 0.5").out);
  if (!CHECK_EQ(flight.rows.size(), 101u)) return;
  CHECK_NEAR(flight.number(100, "time_s"), 0.5, 1e-12);
  CHECK_NEAR(flight.number(100, "u_mps"), flight.number(0, "u_mps"), 1e-6);
  CHECK_NEAR(flight.number(100, "climb_rate_mps"), 0.0, 1e-6);
}

TEST(cli_inputs_act_on_the_controls_they_name) {
  const CsvText flight(
      run_tiltrotor("respond --speed 40 --duration 0.4 --dt 0.01 --input collective=1deg@0.1 "
                    "--input pedal=0.5in@0.1..0.3 --input long_stick=1@0.1..0.3:doublet "
                    "--input lat_stick=-0.2in@0.2")
          .out);
  if (!CHECK_EQ(flight.rows.size(), 41u)) return;
  const auto change = [&](std::size_t row, const char* column) {
    return flight.number(row, column) - flight.number(0, column);
  };
  const double tolerance = 1e-9;
  CHECK_NEAR(change(9, "collective75_deg"), 0.0, tolerance);
  CHECK_NEAR(change(10, "collective75_deg"), 1.0, tolerance);
  CHECK_NEAR(change(40, "collective75_deg"), 1.0, tolerance);
  CHECK_NEAR(change(29, "pedal_in"), 0.5, tolerance);
  CHECK_NEAR(change(30, "pedal_in"), 0.0, tolerance);
  CHECK_NEAR(change(19, "long_stick_from_neutral_in"), 1.0, tolerance);
  CHECK_NEAR(change(20, "long_stick_from_neutral_in"), -1.0, tolerance);
  CHECK_NEAR(change(30, "long_stick_from_neutral_in"), 0.0, tolerance);
  CHECK_NEAR(change(20, "lat_stick_in"), -0.2, tolerance);
}

TEST(cli_modes_every_fills_rows_at_its_interval) {
  const CsvText flight(
      run_tiltrotor(
          "respond --speed 40 --input collective=1deg@0 --duration 0.1 --dt 0.01 --modes-every 0.05")
          .out);
  if (!CHECK_EQ(flight.rows.size(), 11u)) return;
  for (std::size_t row = 0; row < flight.rows.size(); ++row) {
    CHECK_EQ(flight.text(row, "mode1").empty(), row % 5 != 0);
  }
}

// The method that keeps to Euler angles ends where the nose points straight up: the rows so far, the time and the state,
// exit status 1.
TEST(cli_respond_reports_a_lost_flight) {
  const check::ProgramResult lost = run_tiltrotor(
      "respond --speed 40 --input long_stick=-4in@0.5 --method rodas3 --duration 30 --dt 0.01 --format csv");
  CHECK_EQ(lost.exit_status, 1);
  CHECK(lost.err.find("respond: the flight cannot be continued beyond ") != std::string::npos);
  CHECK(lost.err.find(", state ") != std::string::npos);
  const CsvText rows(lost.out);
  CHECK_LT(51u, rows.rows.size());
  CHECK_LT(rows.rows.size(), 3001u);
  CHECK_LT(rows.number(rows.rows.size() - 1, "time_s"), 30.0);
}

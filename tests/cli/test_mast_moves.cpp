// Masts that move during `respond`.
// Expected: the way in closed form; the same flight by the library's own steps; a flight with its edges on the steps.
#include <cmath>

#include "analysis/analysis_case.hpp"
#include "check.hpp"
#include "cli/csv_text.hpp"
#include "cli/refused.hpp"
#include "run_program.hpp"

using check::check_refused;
using check::CsvText;
using check::run_tiltrotor;

namespace {

CsvText respond(const std::string& arguments) {
  return CsvText(run_tiltrotor("respond --mast 60 --speed 60 --grid realtime --format csv " + arguments).out);
}

}  // namespace

TEST(cli_respond_moves_the_masts) {
  const CsvText flight =
      respond("--duration 0.6 --dt 0.02 --input mast=3deg@0.1..0.5 --input mast=-1deg@0.53..0.57");
  if (!CHECK_EQ(flight.rows.size(), 31u)) return;
  for (std::size_t row = 0; row < flight.rows.size(); ++row) {
    const double t = flight.number(row, "time_s");
    CHECK_NEAR(t, 0.02 * static_cast<double>(row), 1e-9);
    const double up = 7.5 * std::fmin(std::fmax(t - 0.1, 0), 0.4),
                 down = 25 * std::fmin(std::fmax(t - 0.53, 0), 0.04);
    CHECK_NEAR(flight.number(row, "mast_deg"), 60 + up - down, 1e-9);
  }
}

TEST(cli_respond_cuts_steps_where_masts_begin_and_end) {
  const std::string input = "--duration 0.3 --input mast=1.5deg@0.033..0.233 --input pedal=0.5@0.1..0.2";
  const CsvText fine = respond(input + " --dt 0.001"), coarse = respond(input + " --dt 0.005");
  for (const char* column : {"u_mps", "w_mps", "q_degps", "pitch_deg", "b1c_right_deg", "v_mps"}) {
    const double expected = fine.number(fine.rows.size() - 1, column);
    CHECK_NEAR(coarse.number(coarse.rows.size() - 1, column), expected, 1e-4 * (1 + std::fabs(expected)));
  }
  // The masts do something: pitch and heave of a flight without differ.
  const CsvText still = respond("--duration 0.3 --input pedal=0.5@0.1..0.2");
  CHECK_LT(0.05, std::fabs(still.number(still.rows.size() - 1, "w_mps") -
                           fine.number(fine.rows.size() - 1, "w_mps")));
}

// What the program prints is the library's flight.
TEST(cli_respond_moves_masts_as_the_library_does) {
  using namespace analysis_case;
  const CsvText flight = respond("--duration 0.2 --dt 0.01 --input mast=1.5deg@0..0.2");
  Options options;
  options.grid = BladeGrid::realtime;
  FlightSetup<double> setup = flight_setup(aircraft_data<double>(), 60.0);
  setup.options = options;
  Configuration<double> c;
  CHECK(prepare(aircraft_data<double>(), setup, c) == Status::ok);
  const TrimResult<double> r = trimmed(c, level(60));
  static SimulationWorkspace<double> work;
  Simulation<double> s;
  CHECK(start(c, r.state, r.controls, 0.01, Integrator::rk4, s) == Status::ok);
  ConfigurationSetting<double> setting = c.setup;
  setting.mast_rate = 7.5 * kDeg;
  CHECK(change_configuration(setting, c, s) == Status::ok);
  MovingConfiguration<double> moving{&c, false, 0, {}, 0};
  for (int k = 0; k < 20; ++k) CHECK(advance_moving(moving, work, s) == Status::ok);
  CHECK_NEAR(flight.number(20, "u_mps"), s.state.velocity.x, 1e-9);
  CHECK_NEAR(flight.number(20, "w_mps"), s.state.velocity.z, 1e-9);
  CHECK_NEAR(flight.number(20, "q_degps"), s.state.rates.y / kDeg, 1e-8);
}

TEST_OF_XV15(cli_bad_moves_of_masts_are_refused) {
  check_refused("respond --input mast=30deg@1",
                "not mast=CHANGE[deg]@START..END, for example mast=30deg@1..5");
  check_refused("respond --input mast=x@1..2", "'x' is not a number");
  check_refused("respond --input mast=100@1..2", "100 lies outside -90..90 deg");
  check_refused("respond --input mast=10@2..1", "the end is not after the start");
  check_refused("respond --input mast=60@1..2", "a rate of 60 deg/s lies outside -57.2958..57.2958 deg/s");
  check_refused("respond --input mast=2@0..1 --input mast=2@0.5..2",
                "two moves of the masts at the same time");
  check_refused("respond --duration 2 --input mast=2@3..4", "starts after the end of the flight, 2 s");
  check_refused("respond --mast 89 --speed 80 --input mast=2@0..1",
                "leads the masts to 91 deg, outside 0..90 deg");
}

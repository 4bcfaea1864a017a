// Load factors at stations and loads of components as outputs by name.
// Expected: complex steps of the model with its governor, the load factor from the motion of the station instead of the loads; the rows of
// `loads`; instruments that read the same.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "check.hpp"
#include "cli/complex_outputs.hpp"
#include "cli/csv_text.hpp"
#include "cli/exported_model.hpp"
#include "cli/feedback_law.hpp"
#include "cli/governed.hpp"
#include "cli/named_outputs.hpp"
#include "cli/refused.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"
#include "this_aircraft.hpp"

using namespace tiltrotor;
using check::CsvText;
using check::ExportedModel;
using check::run_tiltrotor;
using cli::AirframeOutput;
using complex_model::Complex;
using complex_model::outputs_of;

namespace {

void compare_with_complex_steps(const Options& options, bool scas = false) {
  std::vector<AirframeOutput> outputs;
  for (const char* const name :
       {"nx@100/20/90", "ny@250/-40/60", "nz@100/20/90", "htail_moment_y", "wing_free_force_z",
        "rotor_left_force_x", "total_aero_moment_x", "engine_jets_force_x", "fin_right_moment_z",
        "flight_path_angle", "wing_angle_of_attack", "htail_angle_of_attack", "nx", "nz", "q", "b1c_R"})
    outputs.push_back(cli::output_named(name, "")->output);
  FlightSetup<double> setup = flight_setup(aircraft_data<double>(), 40.0);
  setup.options = options;
  setup.options.grid = BladeGrid::realtime;
  setup.options.engine_jets = true;
  const auto c = std::make_unique<Configuration<double>>();
  if (!CHECK(prepare(aircraft_data<double>(), setup, *c) == Status::ok)) return;
  State<double> x{};
  x.velocity = {45 * this_aircraft::speed(), 3, 4};
  x.rates = {0.1, -0.07, 0.05};
  x.roll = 0.2;
  x.pitch = 0.1;
  for (const Side side : {right, left}) {
    x.rotor[side].b1c = 0.02;
    x.rotor[side].b1s = side == right ? 0.01 : -0.02;
    x.rotor[side].lambda_0 = 0.02;
  }
  x.downwash = 0.03;
  Controls<double> u{};
  u.collective = 0.35;
  u.pedal = 0.4;
  const SystemFlight<double> flight = governed(*c, x, u, scas);
  CHECK(options.governor == Governor::off || flight.vehicle.commands.throttle[right] > 0.05);
  const VehicleShape shape = cli::governed_shape(options, kAllControls, scas);
  VehicleRows found;
  if (!CHECK(cli::linearize_airframe_outputs(flight, *c, x, u, shape, outputs, found) == Status::ok)) return;
  std::vector<double> size(outputs.size(), 0), error(outputs.size(), 0);
  for (int j = 0; j < shape.states + shape.inputs; ++j) {
    constexpr double step = 1e-30;
    const std::vector<Complex> y = outputs_of(flight, *c, x, u, shape, j, step, outputs);
    const bool is_state = j < shape.states;
    const double bend = is_state ? vehicle_variable(shape.state[j]).facts().bend
                                 : vehicle_input(shape.input[j - shape.states]).facts().bend;
    for (std::size_t k = 0; k < outputs.size(); ++k) {
      const int row = static_cast<int>(k);
      CHECK_NEAR(found.y[k], y[k].real(), 1e-11 * std::fabs(y[k].real()));
      const double slope = is_state ? found.c(row, j) : found.d(row, j - shape.states);
      size[k] = std::max(size[k], std::fabs(y[k].imag() / step * bend));
      error[k] = std::max(error[k], std::fabs((y[k].imag() / step - slope) * bend));
    }
  }
  double worst = 0;
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    if (error[k] > 1e-10 * size[k]) NOTE("output " << k);
    worst = std::max(worst, error[k] / size[k]);
  }
  NOTE("largest difference " << worst << " of the row");
  CHECK_LE(worst, 1e-10);
}

}  // namespace

TEST(cli_linearize_airframe_outputs_equal_complex_steps) { compare_with_complex_steps(Options{}); }
TEST(cli_linearize_governed_airframe_outputs_equal_complex_steps) {
  Options options;
  for (const Governor governor : {Governor::ideal, Governor::pi}) {
    options.governor = governor;
    compare_with_complex_steps(options);
  }
  options.interconnect = Interconnect::twists;
  compare_with_complex_steps(options, true);
  compare_with_complex_steps(Options{}, true);
}

// Of y = C x + D u one stick that reads one output: u = (v - k C x) / (1 + k D), with columns for the throttles behind it.
// A load factor at the CG, which the law reads as well, closes as the instrument does.
TEST(cli_linearize_closed_airframe_outputs_are_exact) {
  const check::ScratchFolder folder;
  const std::string chosen =
      " --outputs specific_force_x,ny@250/-40/60,nz@100/20/90,htail_moment_y,"
      "load_factor,rotor_left_force_x";
  for (const char* const option :
       {"", " --option governor=ideal", " --option governor=pi --scas on", " --scas on"}) {
    const std::string flight = this_aircraft::flown("--mast 60 --speed 60 --grid realtime") + option + chosen;
    const ExportedModel open(flight);
    const std::size_t n = open.n(), m = open.m(), k = open.outputs.size();
    const std::size_t stick = ExportedModel::place(open.controls, "long_stick"), y = 4;
    const double gain = 3, share = 1 / (1 + gain * open.d[y * m + stick]);
    const ExportedModel closed(flight + " " +
                               check::law(folder, "law.csv", "input,load_factor,q\nlong_stick,3,-0.7\n"));
    CHECK(closed.outputs == open.outputs && closed.y0 == open.y0 && closed.controls == open.controls);
    CHECK(std::fabs(gain * open.d[y * m + stick]) > 1e-4);
    const std::size_t q = ExportedModel::place(open.states, "q");
    for (std::size_t i = 0; i < k; ++i) {
      const double by_stick = open.d[i * m + stick];
      double row = 0, wide = 0;
      for (std::size_t j = 0; j < n; ++j) row = std::max(row, std::fabs(open.c[i * n + j]));
      for (std::size_t v = 0; v < m; ++v) wide = std::max(wide, std::fabs(open.d[i * m + v]));
      for (std::size_t j = 0; j < n; ++j) {
        const double reads = gain * open.c[y * n + j] + (j == q ? -0.7 : 0);
        CHECK_NEAR(closed.c[i * n + j], open.c[i * n + j] - by_stick * share * reads, 1e-11 * row);
      }
      for (std::size_t v = 0; v < m; ++v) {
        const double by_other = v == stick ? share - 1 : -share * gain * open.d[y * m + v];
        CHECK_NEAR(closed.d[i * m + v], open.d[i * m + v] + by_stick * by_other, 1e-11 * wide);
      }
    }
  }
}

TEST(cli_linearize_airframe_outputs_are_those_of_loads_and_instruments) {
  const std::string flight = this_aircraft::flown("--mast 30 --speed 45 --grid realtime");
  const CsvText loads(run_tiltrotor("loads --format csv " + flight).out);
  std::string list = "specific_force_z,specific_force_x";
  for (const auto& row : loads.rows)
    for (const char* load : {"_force_x", "_force_z", "_moment_y"}) list += "," + row[2] + load;
  const ExportedModel model(flight + " --outputs " + list);
  const char* const columns[] = {"x_n", "z_n", "m_nm"};
  for (std::size_t i = 0; i < loads.rows.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      CHECK_NEAR(model.y0[2 + 3 * i + k], loads.number(i, columns[k]),
                 1e-9 * (std::fabs(loads.number(i, columns[k])) + 1e3));
  // The forces of all move the CG as its accelerometers say.
  const std::size_t all = ExportedModel::place(model.outputs, "total_aero_force_z");
  const double mass = this_aircraft::numbers().mass.gross;
  for (std::size_t j = 0; j < model.n(); ++j)
    CHECK_NEAR(model.c[all * model.n() + j] / mass, model.c[j], 1e-11 * (std::fabs(model.c[j]) + 1));
}

// Reduced as the instruments are; a load factor at the CG is the specific force there.
TEST(cli_linearize_airframe_outputs_are_reduced) {
  const std::string flight = this_aircraft::flown("--mast 0 --speed 30 --grid realtime");
  char at_cg[80];
  const auto& m = this_aircraft::numbers().mass;
  std::snprintf(at_cg, sizeof at_cg, "nz@%.17g/0/%.17g", m.sl_cg / 0.0254, m.wl_cg / 0.0254);
  const check::ScratchFolder folder;
  const std::string loop = " " + check::law(folder, "law.csv", "input,load_factor,q\nlong_stick,3,-0.7\n");
  for (const std::string& order : {std::string("none"), std::string("rigid"), std::string("quasi_steady"),
                                   "none" + loop, "rigid" + loop}) {
    const ExportedModel model(flight + " --reduce " + order + " --outputs specific_force_z," + at_cg);
    for (std::size_t j = 0; j < model.n(); ++j)
      CHECK_NEAR(model.c[model.n() + j], -model.c[j] / 9.80665, 1e-11 * (std::fabs(model.c[j]) + 1));
    for (std::size_t j = 0; j < model.m(); ++j)
      CHECK_NEAR(model.d[model.m() + j], -model.d[j] / 9.80665, 1e-11 * (std::fabs(model.d[j]) + 1));
  }
}

TEST(cli_linearize_outputs_in_every_format) {
  const std::string command = "linearize " + this_aircraft::flown("--mast 60 --speed 60 --grid realtime") +
                              " --outputs nz@100/0/80,airspeed";
  const CsvText csv(run_tiltrotor(command + " --format csv").out);
  int rows[3] = {};
  for (std::size_t i = 0; i < csv.rows.size(); ++i)
    for (int k = 0; k < 3; ++k)
      rows[k] += csv.text(i, "matrix") == (k == 0 ? "y0" : k == 1 ? "C" : "D") ? 1 : 0;
  CHECK_EQ(rows[0], 2);
  CHECK_EQ(rows[1], 2 * 23);
  CHECK_EQ(rows[2], 2 * 4);
  CHECK(run_tiltrotor(command + " --format matlab").out.find("outputs = {'nz@100/0/80', 'airspeed'};") !=
        std::string::npos);
  CHECK(run_tiltrotor(command + " --format table").out.find("nz@100/0/80") != std::string::npos);
  // What was not asked for is as before.
  CHECK(run_tiltrotor("linearize " + this_aircraft::flown("--speed 30") + " --format csv").out.find(",y0,") ==
        std::string::npos);
}

TEST(cli_columns_of_stations_and_components_are_the_outputs_of_linearize) {
  const std::string flight = this_aircraft::flown("--mast 60 --speed 60 --grid realtime --sideslip 3");
  const std::string names = "nx@100/20/80,ny@100/20/80,nz@100/20/80,htail_moment_y,rotor_right_force_x";
  const ExportedModel model(flight + " --outputs " + names);
  for (const std::string command : {"trim ", "respond --duration 0.1 --dt 0.1 "}) {
    const CsvText rows(run_tiltrotor(command + flight + " --format csv --columns " + names).out);
    for (std::size_t k = 0; k < model.outputs.size(); ++k)
      CHECK_NEAR(rows.number(0, model.outputs[k]), model.y0[k], 1e-9 * (std::fabs(model.y0[k]) + 1));
  }
}

// Pitching up is felt ahead of the CG: nz there differs by the arm times the pitch acceleration over g.
TEST(cli_columns_of_stations_follow_the_flight) {
  const std::string flight = this_aircraft::flown("--mast 60 --speed 60 --grid realtime");
  const std::string chosen = " --format csv --columns time_s,q_degps,nz@100/0/80,nz@300/0/80";
  for (const std::string& command :
       {"respond " + flight + " --duration 0.4 --dt 0.01 --input long_stick=0.5in@0.1..0.6",
        "respond " + flight +
            " --duration 0.4 --dt 0.01 --option governor=pi --input long_stick=0.5in@0.1..0.6"}) {
    const CsvText rows(run_tiltrotor(command + chosen).out);
    if (!CHECK(rows.rows.size() > 30)) return;
    double largest = 0;
    for (std::size_t i = 1; i + 1 < rows.rows.size(); ++i) {
      const double before = rows.number(i - 1, "q_degps"), after = rows.number(i + 1, "q_degps");
      const double h = rows.number(i + 1, "time_s") - rows.number(i - 1, "time_s");
      constexpr double radian = 3.14159265358979323846 / 180;
      const double by_rate = (after - before) / h * radian * 200 * 0.0254 / 9.80665;
      const double felt = rows.number(i, "nz@100/0/80") - rows.number(i, "nz@300/0/80");
      if (std::fabs(rows.number(i, "time_s") - 0.1) > 0.03) CHECK_NEAR(felt, by_rate, 0.003);
      largest = std::max(largest, std::fabs(felt));
    }
    CHECK(largest > 0.01);
  }
}

TEST(cli_bad_outputs_are_refused) {
  check::check_refused("linearize --outputs htail_momnt_y",
                       "no output 'htail_momnt_y' (did you mean htail_moment_y?)");
  check::check_refused("linearize --outputs nz@1/2",
                       "'nz@1/2': a station is SL/BL/WL in inches: nz@230/0/75");
  check::check_refused("linearize --outputs nz@1/x/2", "'x' is not a number");
  check::check_refused("linearize --outputs nz@1/2/99999", "-10000..10000");
  check::check_refused("linearize --outputs nq@1/2/3", "no output 'nq@1/2/3'");
  check::check_refused("linearize --outputs airspeed,airspeed", "airspeed stands there twice");
  check::check_refused("trim --columns nz@1/2", "a station is SL/BL/WL in inches");
  check::check_refused("trim --columns pitch_deg,htail_force_w",
                       "no column 'htail_force_w' (did you mean htail_force_x?)");
  check::check_refused("respond --columns nz@1/2/3,nz@1/2/3", "stands there twice");
}

// Of the whole vehicle: at its CG the load factor along z is that of the accelerometer.
TEST_OF_XV15(cli_columns_of_stations_are_there_in_fly) {
  const check::ScratchFolder folder;
  const std::string script = folder.write("s.txt", "0 hold speed 40\n0.3 hold height 60\n1 end\n");
  const check::ProgramResult result = run_tiltrotor(
      "fly --mast 0 --speed 30 --height 50 --script " + check::quoted(script) +
      " --every 0.1 --format csv --columns nz,specific_force_x,nx@301.2/0/81.65,nz@301.2/0/81.65,htail_force_z");
  if (!CHECK_EQ(result.exit_status, 0)) NOTE(result.err);
  const CsvText rows(result.out);
  if (!CHECK(rows.rows.size() > 5)) return;
  for (std::size_t i = 0; i < rows.rows.size(); ++i) {
    CHECK_NEAR(rows.number(i, "nz@301.2/0/81.65"), rows.number(i, "nz"), 1e-5);
    CHECK_NEAR(rows.number(i, "nx@301.2/0/81.65"), rows.number(i, "specific_force_x") / 9.80665, 1e-5);
    CHECK(std::fabs(rows.number(i, "htail_force_z")) > 1);
  }
}

// The isolated rotor: equilibrium, momentum theory, symmetry, and published measurements.
// Expected: momentum theory, mirror, printed measurements (NASA/CR-2017-219486).
#include <cmath>

#include "analysis/rotor_stand.hpp"
#include "check.hpp"
#include "cli/csv_text.hpp"
#include "run_program.hpp"
#include "this_aircraft.hpp"

using check::CsvText;
using check::run_tiltrotor;
using namespace tiltrotor;
using namespace rotor_stand;

// Hover: the mean of the momentum theory CT = 2 lambda^2 with the model's factor on the induced velocity.
TEST(isolated_rotor_hover_obeys_momentum_theory) {
  Stand stand(0);
  for (const double collective : {4.0, 8.0, 12.0}) {
    if (!CHECK(stand.run(flow(collective, 0, 0)) == Status::ok)) return;
    const double n0 = stand.rotor.input.state.lambda_0;
    const double kappa = stand.configuration.induced_power_factor;
    CHECK_REL(n0, kappa * std::sqrt(stand.rotor.figures.thrust_coefficient / (2 * kappa)), 2e-3);
    CHECK_NEAR(stand.rotor.input.state.b1c, 0.0, 1e-9);
    CHECK_NEAR(stand.rotor.input.state.b1s, 0.0, 1e-9);
    CHECK(stand.rotor.figures.figure_of_merit > 0.4 && stand.rotor.figures.figure_of_merit < 0.9);
  }
}

// Turned by half a revolution the same flow comes from the other side.
TEST(isolated_rotor_does_not_prefer_a_side) {
  Stand ahead(0), behind(0);
  CHECK(ahead.run(flow(8, 3, 40)) == Status::ok);
  CHECK(behind.run(flow(8, 3, -40)) == Status::ok);
  CHECK_REL(behind.rotor.figures.thrust, ahead.rotor.figures.thrust, 1e-10);
  CHECK_REL(behind.rotor.input.state.b1c, -ahead.rotor.input.state.b1c, 1e-9);
  CHECK_REL(behind.rotor.input.state.lambda_s, -ahead.rotor.input.state.lambda_s, 1e-9);
}

TEST(isolated_rotor_cyclic_holds_the_disk) {
  Stand stand(0);
  RotorFlow<double> f = flow(8, 0, 40);
  f.cyclic = CyclicUse::cancels_tilt;
  if (!CHECK(stand.run(f) == Status::ok)) return;
  CHECK_EQ(stand.rotor.input.state.b1c, 0.0);
  CHECK_EQ(stand.rotor.input.state.b1s, 0.0);
  // The same cyclic given beforehand leaves the disk where it is.
  RotorFlow<double> given = flow(8, 0, 40);
  given.lateral_cyclic = stand.rotor.input.lateral_cyclic;
  given.long_cyclic = stand.rotor.input.long_cyclic;
  CHECK(std::abs(given.long_cyclic) > 0.5 * kRadPerDeg<double>);
  Stand free(0);
  CHECK(free.run(given) == Status::ok);
  CHECK_NEAR(free.rotor.input.state.b1c, 0.0, 1e-8);
  CHECK_NEAR(free.rotor.input.state.b1s, 0.0, 1e-8);
}

// Both orders of flapping have the same equilibrium; coning as a state is found with the rest.
TEST(isolated_rotor_switches) {
  Stand second(0);
  CHECK(second.run(flow(8, 0, 40)) == Status::ok);
  Options options;
  options.flapping = FlapOrder::first;
  Stand first(0, options);
  CHECK(first.run(flow(8, 0, 40)) == Status::ok);
  CHECK_REL(first.rotor.figures.thrust, second.rotor.figures.thrust, 1e-8);
  CHECK_REL(first.rotor.input.state.b1c, second.rotor.input.state.b1c, 1e-7);
  options = {};
  options.coning_states = true;
  options.inflow = InflowShape::uniform;
  Stand coning(0, options);
  CHECK(coning.run(flow(8, 0, 40)) == Status::ok);
  CHECK(coning.rotor.input.coning.angle > 0.5 * kRadPerDeg<double>);
  CHECK_NEAR(coning.rotor.response.coning_acceleration, 0.0, 1e-6);
}

TEST(isolated_rotor_refuses_bad_flow) {
  Stand stand(0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(stand.run(flow(nan, 0, 0)) == Status::not_finite);
  CHECK(stand.run(flow(8, 200, 0)) == Status::out_of_range);
  CHECK(stand.run(flow(8, 0, nan)) == Status::not_finite);
  CHECK(stand.run(flow(91, 0, 0)) == Status::out_of_range);
  for (const double cyclic : {nan, 0.6, -0.6}) {
    RotorFlow<double> f = flow(8, 0, 0);
    const Status refused = std::isfinite(cyclic) ? Status::out_of_range : Status::not_finite;
    f.lateral_cyclic = cyclic;
    CHECK(stand.run(f) == refused);
    f.lateral_cyclic = 0;
    f.long_cyclic = cyclic;
    CHECK(stand.run(f) == refused);
  }
}

// Figure of merit and efficiency are ratios of useful to spent power: none where nothing is lifted or pulled,
// and none where the stream turns the rotor.
TEST(isolated_rotor_figures_exist_where_they_mean_something) {
  Stand stand(0);
  const auto run = [&](double collective, double axial, double in_plane) {
    CHECK(stand.run(flow(collective, axial, in_plane)) == Status::ok);
    return stand.rotor.figures;
  };
  const RotorFigures<double> hover = run(9, 0, 0);
  CHECK_LT(0.5, hover.figure_of_merit);
  CHECK_LT(hover.figure_of_merit, 1.0);
  CHECK(std::isnan(hover.efficiency));
  const RotorFigures<double> pushes_down = run(-12, 0, 0);
  CHECK(pushes_down.thrust < 0 && std::isnan(pushes_down.figure_of_merit));
  CHECK(std::isnan(run(9, 0, 20).figure_of_merit) && std::isnan(run(9, 0, 20).efficiency));
  const RotorFigures<double> climb = run(14, 15, 0);
  CHECK_REL(climb.efficiency, climb.thrust * 15 / climb.power, 1e-14);
  CHECK_LT(climb.efficiency, 1.0);
  CHECK(std::isnan(climb.figure_of_merit));
  const RotorFigures<double> windmill = run(0, 60, 0);
  CHECK(windmill.thrust < 0 && std::isnan(windmill.efficiency));
}

TEST(isolated_rotor_converges_over_its_range) {
  int iterations = 0;
  for (const double mast : {0.0, 90.0}) {
    Stand stand(mast);
    for (const double in_plane : {0.0, 20.0, 60.0}) {
      for (const double axial : {0.0, 5.0, 20.0}) {
        const double inflow_angle =
            std::atan(axial / (0.75 * stand.configuration.tip_speed)) / kRadPerDeg<double>;
        for (const double angle : {2.0, 6.0, 10.0}) {
          CHECK(stand.run(flow(inflow_angle + angle, axial, in_plane)) == Status::ok);
          iterations = stand.rotor.iterations > iterations ? stand.rotor.iterations : iterations;
        }
      }
    }
  }
  NOTE("at most " << iterations << " iterations");
  CHECK_LE(iterations, 12);
}

// XV-15 rotor, NASA Ames outdoor facility, run 15, metal blades, tip speed 769 ft/s (NASA/CR-2017-219486,
// table A-2).
TEST_OF_XV15(cli_rotor_hover_power_against_oarf) {
  struct Point {
    double ct, cp;
  };
  const Point measured[] = {{0.005581, 0.000426}, {0.007391, 0.000588}, {0.009208, 0.000796},
                            {0.011063, 0.001044}, {0.012035, 0.001188}, {0.013089, 0.001358}};
  const double rpm = 769 * 0.3048 / 3.81 * 30 / kPi<double>;
  const CsvText run(run_tiltrotor("rotor --collective75 4:0.5:16 --rpm " + std::to_string(rpm)).out);
  double worst = 0;
  int compared = 0;
  for (const Point& point : measured) {
    for (std::size_t i = 1; i < run.rows.size(); ++i) {
      const double below = run.number(i - 1, "ct");
      const double above = run.number(i, "ct");
      if (below > point.ct || above < point.ct) continue;
      const double part = (point.ct - below) / (above - below);
      const double cp = run.number(i - 1, "cp") + part * (run.number(i, "cp") - run.number(i - 1, "cp"));
      worst = std::fmax(worst, std::abs(cp / point.cp - 1));
      ++compared;
      break;
    }
  }
  NOTE("largest difference of power at equal thrust " << 100 * worst << " %");
  CHECK_EQ(compared, 6);
  CHECK_LT(worst, 0.07);
}

TEST(cli_rotor_columns_agree_with_each_other) {
  const std::string flight = "rotor --mast 90 --collective75 28 --rpm 517 --speed-axial 60,70";
  const CsvText run(run_tiltrotor(this_aircraft::flown(flight)).out);
  if (!CHECK_EQ(run.rows.size(), 2u)) return;
  for (std::size_t i = 0; i < 2; ++i) {
    const double power = run.number(i, "power_kw") * 1000;
    CHECK_EQ(run.number(i, "rotor_rpm"), this_aircraft::given("--rpm", 517));
    CHECK_REL(power, run.number(i, "torque_nm") * run.number(i, "rotor_rpm") * kPi<double> / 30, 1e-9);
    CHECK_REL(run.number(i, "efficiency"),
              run.number(i, "thrust_n") * run.number(i, "speed_axial_mps") / power, 1e-9);
    CHECK_EQ(run.text(i, "figure_of_merit"), std::string());
    CHECK_EQ(run.text(i, "status"), std::string("ok"));
  }
}

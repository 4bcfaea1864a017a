// The parts of the isolated rotor's solution one by one, and how it ends where the rotor has no equilibrium.
// Expected: momentum and blade element theory written out; the bounds stated at RotorFlow.
#include "tiltrotor/analysis/isolated_rotor.hpp"

#include "rotor_stand.hpp"

using namespace tiltrotor;
using namespace rotor_stand;
namespace d = rotor_equilibrium;

namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

// Every field alone at its bound, beyond it on either side, and no number.
TEST(isolated_rotor_range_of_each_field) {
  struct Field {
    double RotorFlow<double>::*value;
    double bound;
  };
  using F = RotorFlow<double>;
  const Field fields[] = {{&F::axial, aircraft_data<double>().limits.speed},
                          {&F::in_plane, aircraft_data<double>().limits.speed},
                          {&F::collective, 90 * kRadPerDeg<double>},
                          {&F::lateral_cyclic, 30 * kRadPerDeg<double>},
                          {&F::long_cyclic, 30 * kRadPerDeg<double>}};
  for (const Field& field : fields) {
    for (double part : {-1.001, -1.0, 1.0, 1.001, kNan}) {
      RotorFlow<double> f = flow(8);
      f.*field.value = part * field.bound;
      CHECK_EQ(d::valid(aircraft_data<double>(), f), part == 1 || part == -1);
    }
  }
}

// The start of the inflow: momentum theory for the thrust it assumes. That thrust follows from the angle of
// attack at the reference radius and ends at a coefficient of 0.02, where blades stall.
TEST(isolated_rotor_first_inflow) {
  const Stand stand;
  const Configuration<double>& c = stand.configuration;
  const double solidity = 0.089;
  for (double collective : {-80.0, -60.0, -6.0, 0.5, 6.0, 12.0, 60.0, 80.0}) {
    for (double axial : {-15.0, 0.0, 30.0}) {
      for (double in_plane : {5.0, 40.0}) {
        const RotorFlow<double> f = flow(collective, axial, in_plane);
        const double n0 = d::first_inflow(c, f, solidity);
        const double through = axial / c.tip_speed + n0;
        const double angle = f.collective - std::atan(through / c.aircraft->rotor.twist_reference);
        // Blade element theory: CT = sigma a / 2 times the angle times the mean of r^2.
        double ct = solidity * c.aircraft->rotor.lift_slope / 2 * angle / 3;
        ct = std::fmin(std::fmax(ct, -0.02), 0.02);
        const double speed = std::hypot(in_plane / c.tip_speed, through);
        if (speed > 0.01) CHECK_NEAR(2 * n0 * speed, ct, 1e-4 * 0.02);
      }
    }
  }
  // Thrust without any flow would want infinite inflow: finite all the same.
  CHECK(std::isfinite(d::first_inflow(c, flow(0), solidity)));
}

// A step keeps its direction; no angle moves more than 5 deg and no inflow more than 0.02.
TEST(isolated_rotor_steps_are_limited) {
  const double angle = 5 * kRadPerDeg<double>, inflow = 0.02;
  for (int harmonics : {1, 3}) {
    for (bool coning : {false, true}) {
      const d::Unknowns set{harmonics, coning};
      CHECK_EQ(set.count(), 2 + harmonics + (coning ? 1 : 0));
      for (int moved = 0; moved < set.count(); ++moved) {
        const bool is_inflow = moved >= 2 && moved < 2 + harmonics;
        const double limit = is_inflow ? inflow : angle;
        for (double part : {0.5, -3.0}) {
          double step[kRotorUnknowns];
          for (int j = 0; j < kRotorUnknowns; ++j) step[j] = 1e-4 * (j + 1);
          step[moved] = part * limit;
          d::limit_step(set, step);
          const double factor = part > 0 ? 1 : 1.0 / 3;
          for (int j = 0; j < set.count(); ++j)
            CHECK_REL(step[j], factor * (j == moved ? part * limit : 1e-4 * (j + 1)), 1e-14);
        }
      }
    }
  }
}

// Figure of merit: standing still, lifting and taking power; efficiency: moving along the shaft, pulling and
// taking power. Each of these alone is missing once.
TEST(isolated_rotor_figures_need_every_condition) {
  const Stand stand;
  const Configuration<double>& c = stand.configuration;
  const auto figures = [&](double axial, double in_plane, double thrust, double torque) {
    MastLoads<double> loads{};
    loads.force_a.z = thrust;
    loads.torque = torque;
    return d::figures(c, flow(8, axial, in_plane), loads, 0.089);
  };
  // Ideal power of the momentum theory, T sqrt(T / 2 rho A), over the shaft's.
  const double area = kPi<double> * std::pow(c.aircraft->rotor.radius, 2);
  const double merit = 20000 * std::sqrt(20000 / (2 * c.air.density * area)) / (8000 * c.setup.rotor_speed);
  CHECK_REL(figures(0, 0, 20000, 8000).figure_of_merit, merit, 1e-12);
  CHECK(std::isnan(figures(1, 0, 20000, 8000).figure_of_merit));
  CHECK(std::isnan(figures(0, 1, 20000, 8000).figure_of_merit));
  CHECK(std::isnan(figures(0, 0, -20000, 8000).figure_of_merit));
  CHECK(std::isnan(figures(0, 0, 20000, -8000).figure_of_merit));
  CHECK_REL(figures(50, 3, 9000, 8000).efficiency, 9000 * 50 / (8000 * c.setup.rotor_speed), 1e-12);
  CHECK(std::isnan(figures(-50, 3, 9000, 8000).efficiency));
  CHECK(std::isnan(figures(50, 3, -9000, 8000).efficiency));
  CHECK(std::isnan(figures(50, 3, 9000, -8000).efficiency));
}

TEST(isolated_rotor_refuses_a_flow_that_is_no_number) {
  using Flow = RotorFlow<double>;
  Stand stand;
  for (double Flow::*const field :
       {&Flow::axial, &Flow::in_plane, &Flow::collective, &Flow::lateral_cyclic, &Flow::long_cyclic}) {
    Flow spoilt = flow(8);
    spoilt.*field = kNan;
    CHECK(stand.run(spoilt) == Status::not_finite);
    CHECK_EQ(stand.rotor.iterations, 0);
  }
}

// Blades that are no number, and blades so heavy that nothing moves them: the equations have no solution to
// step to.
TEST(isolated_rotor_says_how_it_failed) {
  Stand stand;
  stand.aircraft.rotor.flap_inertia = kNan;
  CHECK(stand.run(flow(8)) == Status::not_finite);
  CHECK_EQ(stand.rotor.iterations, 0);
  stand.aircraft.rotor.flap_inertia = std::numeric_limits<double>::infinity();
  CHECK(stand.run(flow(8, 0, 30)) == Status::singular);
  CHECK_EQ(stand.rotor.iterations, 0);
  CHECK(std::isfinite(stand.rotor.residual) && stand.rotor.residual > 0);
  stand.aircraft = aircraft_data<double>();
  CHECK(stand.run(flow(8, 0, 30)) == Status::ok);
}

// A stalled rotor in a fast stream across its disk: no cyclic is found that holds the disk level. It says so
// after all the steps of its first start, with the residual that is left; the free disk finds its tilt in
// each of these flows.
TEST(isolated_rotor_ends_without_equilibrium) {
  Stand stand(0, reference_options());
  const double tolerance = 5e4 * std::numeric_limits<double>::epsilon();
  for (const RotorFlow<double>& f : {flow(44, 0, 70), flow(43, 0, 85)}) {
    RotorFlow<double> level = f;
    level.cyclic = CyclicUse::cancels_tilt;
    CHECK(stand.run(f) == Status::ok);
    CHECK_LT(stand.rotor.residual, tolerance);
    CHECK(stand.run(level) == Status::not_converged);
    CHECK_EQ(stand.rotor.iterations, d::kMaxIterations);
    CHECK_LT(1e-3, stand.rotor.residual);
    CHECK(std::isfinite(stand.rotor.figures.thrust) && std::isfinite(stand.rotor.residual));
  }
}

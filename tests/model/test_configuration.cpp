// A configuration remade in flight against the same one prepared anew, bit for bit.
#include <cstring>

#include "flight_cases.hpp"
#include "tiltrotor/analysis/flight/response.hpp"

using namespace flight_cases;

namespace {

FlightSetup<double> random_setup(Generator& random, const Options& options) {
  FlightSetup<double> setup = flight_setup(aircraft(), random.between(0, 90));
  setup.mast_rate = random.between(-0.13, 0.13);
  setup.mast_acceleration = random.between(-0.35, 0.35);
  setup.rotor_acceleration = random.between(-3, 3);
  const LimitTables<double>& limits = aircraft().limits;
  const auto within = [&](const Bounds<double>& range, double low, double high) {
    return range.low + (range.high - range.low) * random.between(low, high);
  };
  setup.flap_deg = within(limits.flap_deg, 0, 1);
  setup.rotor_speed = within(limits.rotor_speed, 0.5, 0.75);
  setup.altitude = within(limits.altitude, 0, 1);
  setup.mass = within(limits.mass, 0.15, 0.57);
  setup.sl_cg = within(limits.sl_cg, 0.3, 0.8);
  setup.wl_cg = within(limits.wl_cg, 0.4, 0.8);
  setup.options = options;
  return setup;
}
Configuration<double> prepared(const FlightSetup<double>& setup) {
  Configuration<double> c;
  CHECK(prepare(aircraft(), setup, c) == Status::ok);
  return c;
}

template <class S>
bool same_bits(const S& a, const S& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

bool evaluates_alike(const Configuration<double>& a, const Configuration<double>& b, Generator& random) {
  const StateAndControls<double> s = random_case(random, b);
  Evaluation<double> x, y;
  evaluate_aircraft(a, s.x, s.u, x);
  evaluate_aircraft(b, s.x, s.u, y);
  return same_bits(x, y);
}

}  // namespace

TEST(configuration_remade_is_the_one_prepared) {
  Generator random(11);
  Options realtime;
  realtime.grid = BladeGrid::realtime;
  Options other;
  other.mast_cant = false;
  other.inertia = InertiaSet::design_1975;
  other.hub_spring_factor = 0.7;
  other.lateral_cyclic = true;
  for (const Options& options : {Options{}, realtime, other}) {
    Configuration<double> moved = prepared(random_setup(random, options));
    for (int n = 0; n < 40; ++n) {
      FlightSetup<double> setup = random_setup(random, options);
      if (n % 4 == 0) setup.mast_deg = 30.0 * (n / 4 % 4);  // on knots and at both ends
      const Configuration<double> anew = prepared(setup);
      CHECK(reconfigure(setup, moved) == Status::ok);
      CHECK(same_bits<ConfigurationSetting<double>>(moved.setup, setup));
      CHECK(same_bits(moved.air, anew.air) && same_bits(moved.mass, anew.mass));
      CHECK(same_bits(moved.hub, anew.hub) && same_bits(moved.gearing, anew.gearing));
      CHECK(evaluates_alike(moved, anew, random));
    }
  }
}

TEST(configuration_refuses_a_setting_out_of_range) {
  Generator random(12);
  const Configuration<double> before = prepared(random_setup(random, Options{}));
  using Member = double ConfigurationSetting<double>::*;
  using S = ConfigurationSetting<double>;
  struct Bad {
    Member member;
    double value;
  };
  const LimitTables<double>& limits = aircraft().limits;
  for (const Bad& bad :
       {Bad{&S::mast_deg, limits.mast_deg.high + 0.01}, Bad{&S::mast_rate, limits.mast_rate.high + 0.01},
        Bad{&S::flap_deg, limits.flap_deg.low - 0.01}, Bad{&S::rotor_speed, 0.5 * limits.rotor_speed.low},
        Bad{&S::altitude, limits.altitude.high + 1}, Bad{&S::mass, 1}, Bad{&S::sl_cg, limits.sl_cg.high + 1},
        Bad{&S::wl_cg, 0}, Bad{&S::mast_deg, std::nan("")}}) {
    Configuration<double> c = before;
    S setting = before.setup;
    setting.*bad.member = bad.value;
    CHECK(reconfigure(setting, c) == Status::out_of_range);
    CHECK(same_bits(c, before));
  }
  Configuration<double> unprepared{};
  CHECK(reconfigure(before.setup, unprepared) == Status::bad_argument);
}

// Remaking takes nothing from a flight: the same values at every step give the same flight.
TEST(configuration_remade_at_every_step_keeps_the_flight) {
  Generator random(13);
  for (const double mast : {0.0, 30.0, 90.0}) {
    FlightSetup<double> setup = flight_setup(aircraft(), mast);
    setup.options.grid = BladeGrid::realtime;
    const Configuration<double> still = prepared(setup);
    Configuration<double> remade = still;
    const StateAndControls<double> s = random_case(random, still);
    static SimulationWorkspace<double, NumDiff> work;
    Simulation<double> a, b;
    CHECK(start(still, s.x, s.u, 0.005, Integrator::rk3, a) == Status::ok);
    CHECK(start(remade, s.x, s.u, 0.005, Integrator::rk3, b) == Status::ok);
    for (int k = 0; k < 100; ++k) {
      const ConfigurationSetting<double> setting = remade.setup;
      CHECK(reconfigure(setting, remade) == Status::ok);
      const bool alive = advance(still, work, a) == Status::ok;
      CHECK_EQ(advance(remade, work, b) == Status::ok, alive);
      if (!alive) break;
    }
    CHECK(same_bits(a.state, b.state));
    CHECK(a.steps > 20);
  }
}

// The setting of a conversion: every quantity that follows moves with it and without a jump between knots.
TEST(configuration_moves_through_a_conversion) {
  FlightSetup<double> setup = flight_setup(aircraft(), 45.0);
  Configuration<double> c = prepared(setup);
  double hub_x = c.hub[right].arm_b.x;
  for (double mast = 45.5; mast <= 90; mast += 0.5) {
    setup.mast_deg = mast;
    CHECK(reconfigure(setup, c) == Status::ok);
    CHECK(c.hub[right].arm_b.x > hub_x);  // the hub swings forward
    CHECK(c.hub[right].arm_b.x - hub_x < 0.5 * kRadPerDeg<double> * 1.5);
    hub_x = c.hub[right].arm_b.x;
    CHECK_NEAR(c.nacelle_axis_b.x, std::sin(mast * kRadPerDeg<double>), 1e-15);
  }
}

// Engines, transmission and fuel: against the energy of what turns, closed forms of lag and limits, and the standard
// atmosphere.
#include "vehicle_case.hpp"

using namespace vehicle_case;

namespace {

const Aircraft<double>& aircraft() { return aircraft_data<double>(); }
const DriveTables<double>& drive() { return aircraft().systems.drive; }

// Of both rotors, their blades turning as stiff ones, and of turbines that run, kg m^2.
double inertia(int turbines) {
  return 2 * aircraft().rotor.blades * aircraft().rotor.flap_inertia + turbines * drive().turbine_inertia;
}

double torque_of(const Flight& f) {
  Evaluation<double> e;
  evaluate_aircraft(f.c, f.s.state, rates(f).demand.controls, e);
  return e.rotor[right].loads.torque + e.rotor[left].loads.torque;
}

SystemSwitches pi_and_engines() {
  SystemSwitches on{};
  on.governor = Governor::pi;
  on.engines = true;
  return on;
}

}  // namespace

// P' = (demanded - P)/lag near by, the largest rate far away; exponential in time.
TEST(drive_engines_have_their_lag_and_largest_rate) {
  const SystemTables<double>& t = aircraft().systems;
  const double power = 5e5, near = 2e3;
  CHECK_REL(power_rate(t, power + near, power), near / drive().power_lag, 1e-4);
  CHECK_REL(power_rate(t, 2 * power, power), drive().power_rate, 1e-3);
  CHECK_REL(power_rate(t, 0.0, power), -drive().power_rate, 1e-3);
  CHECK_EQ(power_rate(t, power, power), 0.0);

  Flight f = begun(0, level(0), pi_and_engines());
  const double before = f.state().power[right];
  for (double& throttle : f.vehicle().commands.throttle) throttle *= 1.02;
  const double demanded = 1.02 * before;
  CHECK(fly(f, 200) == Status::ok);
  CHECK_REL(f.state().power[right], demanded + (before - demanded) * std::exp(-1 / drive().power_lag), 1e-5);
}

// Never negative, never beyond contingency; as delta over sqrt(theta), which choice engine_lapse says.
TEST(drive_power_of_an_engine_has_its_limits) {
  const double take_off = aircraft().controls.engine_power, width = aircraft().systems.smooth.power;
  const Air<double> sea_level = standard_air(0.0);
  CHECK_NEAR(demanded_power(aircraft(), sea_level, 1.0), take_off, width);
  CHECK_NEAR(demanded_power(aircraft(), sea_level, 0.0), 0, width);
  for (const double throttle : {-5.0, -1.0, -0.1, 0.0})
    CHECK_LE(0, demanded_power(aircraft(), sea_level, throttle));
  for (const double throttle : {1.3, 2.0, 50.0}) {
    CHECK_LE(demanded_power(aircraft(), sea_level, throttle), drive().contingency);
    CHECK_NEAR(demanded_power(aircraft(), sea_level, throttle), drive().contingency, 2 * width);
  }
  // ISA at 3000 m: theta = 1 - 0.0065 h/T0, delta = theta^5.25588.
  const double theta = 1 - 0.0065 * 3000 / 288.15, delta = std::pow(theta, 5.25588);
  const double lapse = 1 + aircraft().controls.engine_lapse * (delta / std::sqrt(theta) - 1);
  CHECK_REL(demanded_power(aircraft(), standard_air(3000.0), 0.7), 0.7 * take_off * lapse, 1e-5);
}

// J Omega Omega' = eta P - Q Omega; without an engine its power is gone, and its turbine turns no more with the rotors.
TEST(drive_balances_its_energy) {
  for (const double mast : {0.0, 60.0, 90.0}) {
    SystemSwitches on{};
    on.governor = Governor::pi;
    Flight f = begun(mast, level(20 + mast), on);
    f.vehicle().commands.throttle[right] *= 1.2;
    f.vehicle().commands.throttle[left] *= 0.9;
    const double efficiency = aircraft().controls.transmission_efficiency, omega = f.state().rotor_speed;
    const auto found = [&] { return rates(f).of_system(kSystemIndex.rotor_speed); };
    double powers[2];
    for (const Side side : {right, left})
      powers[side] = demanded_power(aircraft(), f.c.air, f.vehicle().commands.throttle[side]);
    const double torque = torque_of(f);
    CHECK_REL(inertia(2) * omega * found(), efficiency * (powers[right] + powers[left]) - torque * omega,
              1e-9);
    f.vehicle().engine_failed[left] = true;
    CHECK_REL(inertia(1) * omega * found(), efficiency * powers[right] - torque * omega, 1e-9);
    CHECK_EQ(rates(f).flows.power, powers[right]);
    f.vehicle().engine_failed[right] = true;
    CHECK_REL(inertia(0) * omega * found(), -torque * omega, 1e-9);
  }
}

// The same over a flight: kinetic energy of what turns is what engines gave and rotors did not take. Simpson's rule
// over the steps.
TEST(drive_energy_is_kept_in_flight) {
  Flight f = begun(30, level(50), pi_and_engines(), 0.005, Integrator::rk4);
  for (double& throttle : f.vehicle().commands.throttle) throttle *= 1.15;
  const double efficiency = aircraft().controls.transmission_efficiency;
  const auto surplus = [&] {
    return efficiency * (f.state().power[right] + f.state().power[left]) -
           torque_of(f) * f.state().rotor_speed;
  };
  const auto energy = [&] { return 0.5 * inertia(2) * square(f.state().rotor_speed); };
  const double before = energy();
  double given = 0, fastest = 0;
  for (int k = 0; k < 200; ++k) {
    const double begin = surplus();
    CHECK(fly(f, 1) == Status::ok);
    const double middle = surplus();
    CHECK(fly(f, 1) == Status::ok);
    given += 0.01 / 6 * (begin + 4 * middle + surplus());
    fastest = std::max(fastest, energy() - before);
  }
  NOTE("given " << given << " J, gained " << energy() - before << " J, at most " << fastest << " J");
  CHECK_NEAR(energy() - before, given, 1e-4 * fastest);
}

// Burnt fuel is the integral of consumption times power, and is gone from the mass.
TEST(drive_burns_fuel_by_its_power) {
  Flight f = begun(60, level(80), with(Governor::pi), 0.01);
  const double mass = f.c.setup.mass;
  for (double& throttle : f.vehicle().commands.throttle) throttle *= 1.1;
  const auto flow = [&] {
    return drive().fuel_per_energy * (f.state().power[right] + f.state().power[left]);
  };
  double burnt = 0;
  for (int k = 0; k < 200; ++k) {
    const double begin = flow();
    CHECK(fly(f, 1) == Status::ok);
    const double middle = flow();
    CHECK(fly(f, 1) == Status::ok);
    burnt += 0.02 / 6 * (begin + 4 * middle + flow());
  }
  CHECK_REL(f.state().fuel, burnt, 1e-7);
  CHECK_NEAR(mass - f.c.setup.mass, f.state().fuel, 1e-9 * mass);
  CHECK_LT(0.1, burnt);
}

// An engine that fails runs down to nothing; its power is never negative.
TEST(drive_engine_that_fails_runs_down) {
  Flight f = begun(60, level(70), with(Governor::pi), 0.01);
  const double before = f.state().power[left];
  f.vehicle().engine_failed[left] = true;
  double lowest = before;
  for (int k = 0; k < 1000; ++k) {
    CHECK(fly(f, 1) == Status::ok);
    lowest = std::min(lowest, f.state().power[left]);
  }
  CHECK_LE(0, lowest);
  CHECK_NEAR(f.state().power[left], 0, 1e-3 * before * std::exp(-1));
  CHECK_REL(f.state().power[right], before, 1e-3);
  NOTE("left " << f.state().power[left] << " W after 10 s, rotor speed " << f.state().rotor_speed);
}

// Without fuel engines stop, and burn no more.
TEST(drive_engines_stop_without_fuel) {
  Flight f = begun(60, level(70), with(Governor::pi), 0.01);
  f.state().fuel = drive().fuel - 0.05;
  int stopped = -1;
  for (int k = 0; k < 1500; ++k) {
    CHECK(fly(f, 1) == Status::ok);
    if (stopped < 0 && f.vehicle().engine_failed[right] && f.vehicle().engine_failed[left]) stopped = k;
  }
  CHECK_LE(0, stopped);
  CHECK_NEAR(f.state().power[right], 0, 1e-2);
  CHECK_NEAR(f.state().power[left], 0, 1e-2);
  CHECK_NEAR(rates(f).of_system(kSystemIndex.fuel), 0, 1e-8);
  // Power of the moment of stopping, burnt while it runs down.
  CHECK_NEAR(f.state().fuel, drive().fuel, 0.5);
  NOTE("stopped after " << 0.01 * stopped << " s; " << f.state().fuel - drive().fuel
                        << " kg while running down");
}

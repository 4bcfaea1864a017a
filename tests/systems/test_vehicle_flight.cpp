// Flights of the whole vehicle: nothing on is the airframe alone, a steady flight stays, integrators keep their order,
// replays are exact, faults leave everything as it was.
#include <limits>

#include "vehicle_case.hpp"

using namespace vehicle_case;

namespace {

SimulationWorkspace<double, NumDiff> work;

// On the way: all commands away from what is.
Flight disturbed(const SystemSwitches& on, double dt, Integrator integrator) {
  Flight f = begun(30, level(50), on, dt, integrator);
  Commands<double>& to = f.vehicle().commands;
  to.mast += 8 * kDeg;
  to.flap -= 10 * kDeg;
  for (double& throttle : to.throttle) throttle *= 1.05;
  f.s.controls.long_stick += 0.4;
  f.s.controls.lat_stick += 0.3;
  f.s.controls.pedal -= 0.2;
  f.vehicle().air_follows = true;
  f.vehicle().altitude_origin = f.c.setup.altitude - f.s.state.position.z;
  return f;
}

}  // namespace

namespace vehicle_case {

Status fly(Flight& f, int steps, const double* xdot) {
  for (int k = 0; k < steps; ++k) {
    const Status status = advance_vehicle(f.c, f.systems, work, f.s, k == 0 ? xdot : nullptr);
    if (status != Status::ok) return status;
  }
  return Status::ok;
}

}  // namespace vehicle_case

// Every switch off: bits of advance(), with inputs, of each integrator and of single blades; and no state of a system
// moves.
TEST(vehicle_with_nothing_on_keeps_the_bits_of_the_airframe) {
  for (const AzimuthMode azimuth : {AzimuthMode::averaged, AzimuthMode::individual}) {
    for (const Integrator integrator : {Integrator::rk3, Integrator::rk4}) {
      Flight f = begun(30, level(50), kNone, 0.005, integrator);
      f.c.setup.options.azimuth = azimuth;
      CHECK(prepare(aircraft_data<double>(), FlightSetup<double>(f.c.setup), f.c) == Status::ok);
      CHECK(add_input(f.s, {InputShape::pulse, kControlIndex.long_stick, 0.3, 0.101, 0.2}) == Status::ok);
      Simulation<double> alone = f.s;
      const SystemState<double> before = f.state();
      CHECK(fly(f, 200) == Status::ok);
      for (int k = 0; k < 200; ++k) CHECK(advance(f.c, work, alone) == Status::ok);
      CHECK(same_bits(f.s.state, alone.state) && same_bits(f.s.travel, alone.travel));
      CHECK(same_bits(f.state(), before));
    }
  }
}

// Each switch alone makes a vehicle of the airframe.
TEST(vehicle_is_one_with_any_system) {
  CHECK(!any_system(kNone));
  SystemSwitches on = kNone;
  for (bool SystemSwitches::*const system :
       {&SystemSwitches::conversion, &SystemSwitches::engines, &SystemSwitches::actuators,
        &SystemSwitches::augmentation, &SystemSwitches::gear, &SystemSwitches::ground_effect,
        &SystemSwitches::turbulence}) {
    on.*system = true;
    CHECK(any_system(on));
    on.*system = false;
  }
  on.governor = Governor::ideal;
  CHECK(any_system(on));
  on = kNone;
  on.wind_shear = WindShear::terminal;
  CHECK(any_system(on));
}

// settle(): nothing moves in a steady flight but what moves in it without systems; what stays are a smoothing of the
// engines' power (1 kW wide: 1 W/s), burnt fuel, and that of the actuators' stops (0.02 deg: 3e-5 rad/s).
TEST(vehicle_settles_in_steady_flight) {
  struct Case {
    double mast;
    SteadyFlight<double> flight;
  };
  const double turn = 3 * kDeg;
  for (const Case& at :
       {Case{0, level(0)}, Case{0, level(30)}, Case{0, {30, 2 * kDeg, 0, 0}}, Case{15, {35, 0, turn, 0}},
        Case{30, level(60)}, Case{45, {60, 3 * kDeg, turn, 0}}, Case{60, level(70)}, Case{75, level(80)},
        Case{90, level(100)}, Case{90, {110, 2 * kDeg, turn, 0}}}) {
    for (const Governor governor : {Governor::off, Governor::ideal, Governor::pi}) {
      Flight f = begun(at.mast, at.flight, with(governor));
      const Rates r = rates(f);
      double worst = 0;
      const char* name = "";
      for (int i = 0; i < vehicle_state_count; ++i) {
        const VariableKind kind = vehicle_variable(i).kind;
        const bool moves =
            kind == VariableKind::position || kind == VariableKind::heading || kind == VariableKind::fuel;
        if (moves) continue;
        const double rate = std::fabs(r.of[i]) / vehicle_variable(i).facts().bend;
        if (rate > worst) name = vehicle_variable(i).name;
        worst = std::max(worst, rate);
      }
      if (worst > 1e-5)
        NOTE("mast " << at.mast << " V " << at.flight.speed << " governor " << static_cast<int>(governor)
                     << ": " << name << " " << worst);
      CHECK_LT(worst, 1e-4);
    }
  }
}

// And the flight stays there: 20 s, the augmentation holding what is unstable.
TEST(vehicle_stays_in_steady_flight) {
  const double turn = 2 * kDeg;
  for (const double mast : {0.0, 30.0, 60.0, 90.0}) {
    for (const double rate : {0.0, turn}) {
      const double speed = mast == 0 ? 25 : 40 + 0.6 * mast;
      Flight f = begun(mast, {speed, 0, rate, 0}, with(Governor::pi), 0.01);
      const Flight before = f;
      CHECK(fly(f, 2000) == Status::ok);
      const Vec3<double> changed = f.s.state.velocity - before.s.state.velocity;
      const double rotor = f.state().rotor_speed - before.state().rotor_speed;
      NOTE("mast " << mast << " turn " << rate << ": velocity " << changed.x << " " << changed.y << " "
                   << changed.z << " m/s, bank " << f.s.state.roll - before.s.state.roll << ", pitch "
                   << f.s.state.pitch - before.s.state.pitch << ", rotor " << rotor << " rad/s, sink "
                   << f.s.state.position.z - before.s.state.position.z << " m");
      CHECK_LT(std::sqrt(dot(changed, changed)), 0.1);
      CHECK_NEAR(f.s.state.roll, before.s.state.roll, 2e-3);
      CHECK_NEAR(f.s.state.pitch, before.s.state.pitch, 2e-3);
      CHECK_NEAR(rotor, 0, 0.01);
      CHECK_NEAR(f.s.state.position.z, before.s.state.position.z, 1);
    }
  }
}

// Order of the integrators with everything on and masts, flaps, rotor speed and air on their way: errors against steps
// of an eighth.
TEST(vehicle_keeps_the_order_of_the_integrators) {
  for (const Governor governor : {Governor::ideal, Governor::pi}) {
    const auto flown_by = [governor](Integrator integrator, double dt) {
      Flight f = disturbed(with(governor), dt, integrator);
      CHECK(fly(f, static_cast<int>(std::lround(0.24 / dt))) == Status::ok);
      f.state().governor =
          governor == Governor::ideal ? 0 : f.state().governor;  // where a search begins: no state
      return f;
    };
    const Flight exact = flown_by(Integrator::rk4, 0.0005);
    struct Case {
      Integrator integrator;
      double order;
    };
    for (const Case& at : {Case{Integrator::rk3, 3}, Case{Integrator::rk4, 4}}) {
      const double coarse = difference(flown_by(at.integrator, 0.006), exact);
      const double fine = difference(flown_by(at.integrator, 0.003), exact);
      NOTE("governor " << static_cast<int>(governor) << " order " << std::log2(coarse / fine) << ": "
                       << coarse << " then " << fine);
      CHECK_LT(at.order - 0.5, std::log2(coarse / fine));
    }
  }
}

// A step of any length is stable, actuators of a hundredth of a second included.
TEST(vehicle_long_steps_are_stable) {
  for (const double mast : {0.0, 90.0}) {
    for (const Integrator integrator : {Integrator::rk3, Integrator::rk4}) {
      for (const double dt : {0.02, 0.05, 0.2, 1.0}) {
        Flight f = begun(mast, level(mast == 0 ? 0 : 100), with(Governor::pi), dt, integrator);
        const Flight before = f;
        f.state().elevator += 0.01;
        f.state().collective[left] += 0.001;
        CHECK(fly(f, static_cast<int>(std::lround(4 / dt))) == Status::ok);
        CHECK_NEAR(f.state().elevator, before.state().elevator, 0.01);
        CHECK_NEAR(f.state().collective[left], before.state().collective[left], 0.01);
        CHECK_NEAR(f.s.state.rates.y, 0, 0.02);
      }
    }
  }
}

// A flight stopped and continued from copies gives the same bits.
TEST(vehicle_continued_from_copies_has_the_same_bits) {
  for (const Governor governor : {Governor::off, Governor::ideal, Governor::pi}) {
    Flight whole = disturbed(with(governor), 0.005, Integrator::rk3);
    CHECK(fly(whole, 137) == Status::ok);
    Flight copy{};
    CHECK(prepare(aircraft_data<double>(), FlightSetup<double>(whole.c.setup), copy.c) == Status::ok);
    copy.systems = whole.systems;
    copy.s = whole.s;
    CHECK(fly(whole, 150) == Status::ok);
    CHECK(fly(copy, 150) == Status::ok);
    CHECK(same_bits(whole.s.state, copy.s.state) && same_bits(whole.state(), copy.state()));
    CHECK(same_bits(static_cast<const ConfigurationSetting<double>&>(whole.c.setup),
                    static_cast<const ConfigurationSetting<double>&>(copy.c.setup)));
  }
}

// Rates that are known spare the first evaluation, and change nothing; an ideal governor's search begins elsewhere.
TEST(vehicle_takes_rates_that_are_known) {
  for (const Governor governor : {Governor::off, Governor::ideal, Governor::pi}) {
    Flight a = disturbed(with(governor), 0.005, Integrator::rk3);
    CHECK(fly(a, 10) == Status::ok);
    Flight b = a;
    const Rates r = rates(a);
    CHECK(fly(a, 1) == Status::ok);
    CHECK(fly(b, 1, r.of) == Status::ok);
    a.state().governor = governor == Governor::ideal ? b.state().governor : a.state().governor;
    if (governor == Governor::ideal) {
      CHECK_LT(difference(a, b), 1e-12);
    } else {
      CHECK(same_bits(a.s.state, b.s.state) && same_bits(a.state(), b.state()));
    }
  }
}

// A command past a stop ends at the stop, and there the drive rests: the airframe feels no acceleration of the masts.
TEST(vehicle_masts_end_at_their_stops) {
  const Bounds<double>& stops = aircraft_data<double>().limits.mast_deg;
  for (const bool up : {true, false}) {
    Flight f = begun(up ? 84 : 6, level(up ? 80 : 20), with(Governor::pi), 0.01);
    f.vehicle().commands.mast = (up ? stops.high + 20 : stops.low - 20) * kDeg;
    for (int k = 0; k < 300; ++k) {
      CHECK(fly(f, 1) == Status::ok);
      CHECK_LE(stops.low, f.c.setup.mast_deg);
      CHECK_LE(f.c.setup.mast_deg, stops.high);
    }
    CHECK_NEAR(f.c.setup.mast_deg, up ? stops.high : stops.low, 0.05);
    CHECK_NEAR(rates(f).demand.setting.mast_acceleration, 0, 0.02);
    CHECK_NEAR(rates(f).demand.setting.mast_rate, 0, 0.01);
  }
}

// Rotor speed that leaves its range, the rotors driven by nothing and dragged by blades of all their pitch.
TEST(vehicle_tells_of_a_lost_rotor_speed) {
  SystemSwitches on{};
  on.governor = Governor::pi;
  Flight f = begun(0, level(0), on, 0.01);
  f.vehicle().commands.throttle[right] = f.vehicle().commands.throttle[left] = 0;
  f.vehicle().commands.rotor_speed *= 0.1;  // the governor does not help
  for (int k = 0; k < 6000; ++k) {
    const Flight before = f;
    const Status status = fly(f, 1);
    if (status == Status::ok) continue;
    CHECK(status == Status::out_of_range);
    CHECK_EQ(f.s.fault_state, state_count + kSystemIndex.rotor_speed);
    CHECK_NEAR(f.s.fault_time, current_time(before.s) + f.s.dt, 1e-12);
    CHECK(same_bits(f.s.state, before.s.state) && same_bits(f.state(), before.state()));
    CHECK(same_bits(f.systems.vehicle, before.systems.vehicle));
    CHECK(same_bits(static_cast<const ConfigurationSetting<double>&>(f.c.setup),
                    static_cast<const ConfigurationSetting<double>&>(before.c.setup)));
    CHECK(same_bits(f.c.mass, before.c.mass) && same_bits(f.c.air, before.c.air));
    CHECK_EQ(f.c.tip_speed, before.c.tip_speed);
    CHECK_LT(before.state().rotor_speed, 1.05 * aircraft_data<double>().limits.rotor_speed.low);
    CHECK(fly(f, 1) == Status::out_of_range);  // it does not move again
    NOTE("lost after " << f.s.fault_time << " s");
    return;
  }
  CHECK(false);
}

// A number that is not finite in a system's state is refused, and nothing moves.
TEST(vehicle_refuses_systems_that_are_not_finite) {
  for (const int place :
       {kSystemIndex.mast, kSystemIndex.rotor_speed, kSystemIndex.elevator, kSystemIndex.series[1]}) {
    Flight f = begun(30, level(50), with(Governor::pi));
    double flat[system_state_count];
    flatten(f.state(), flat);
    flat[place] = std::numeric_limits<double>::quiet_NaN();
    unflatten(flat, f.state());
    const Flight before = f;
    CHECK(fly(f, 1) == Status::not_finite);
    CHECK(same_bits(f.s.state, before.s.state) && same_bits(f.state(), before.state()));
    CHECK(same_bits(static_cast<const ConfigurationSetting<double>&>(f.c.setup),
                    static_cast<const ConfigurationSetting<double>&>(before.c.setup)));
  }
}
TEST(vehicle_is_not_flown_by_rodas3) {
  Flight f = begun(30, level(50), with(Governor::pi), 0.005, Integrator::rodas3);
  CHECK(fly(f, 1) == Status::bad_argument);
}

// Left and right are alike: the mirrored flight has mirrored states, one engine out and all.
TEST(vehicle_in_the_mirror_flies_the_mirrored_flight) {
  const auto flown_with = [](const Side& out, double sign) {
    Flight f = begun(30, level(50), with(Governor::pi));
    f.vehicle().engine_failed[out] = true;
    f.s.controls.lat_stick += 0.3 * sign;
    f.s.controls.pedal -= 0.4 * sign;
    f.s.controls.gust.y += 3 * sign;
    CHECK(fly(f, 200) == Status::ok);
    return f;
  };
  const auto flat = [](const Flight& f, double* x) {
    flatten(f.s.state, x);
    flatten(f.systems.state, x + state_count);
  };
  double x[vehicle_state_count], mirrored[vehicle_state_count];
  flat(flown_with(left, 1), x);
  flat(flown_with(right, -1), mirrored);
  for (int i = 0; i < vehicle_state_count; ++i) {
    const Variable& variable = vehicle_variable(i);
    int partner = i;
    for (int j = 0; j < vehicle_state_count; ++j) {
      const Variable& other = vehicle_variable(j);
      const std::size_t length = std::strlen(variable.name);
      if (variable.side != kNoSide && other.side != kNoSide && other.side != variable.side &&
          std::strncmp(variable.name, other.name, length - 1) == 0)
        partner = j;
    }
    const double sign = variable.plane == Plane::lateral && variable.kind != VariableKind::flag ? -1 : 1;
    CHECK_NEAR(mirrored[partner], sign * x[i], 1e-10 * variable.facts().bend);
  }
}

// Single precision flies the same flight.
TEST(vehicle_flies_in_single_precision) {
  static SimulationWorkspace<float, NumDiff> single;
  for (const Governor governor : {Governor::ideal, Governor::pi}) {
    Flight f = disturbed(with(governor), 0.005, Integrator::rk3);
    f.vehicle().air_follows = false;
    FlightSetup<float> setup = flight_setup(aircraft_data<float>(), 30.0f);
    setup.options = realtime();
    setup.altitude = static_cast<float>(this_aircraft::altitude());
    Configuration<float> c;
    CHECK(prepare(aircraft_data<float>(), setup, c) == Status::ok);
    const auto narrow = [](const auto& from, auto& to) {
      double wide[vehicle_state_count];
      float flat[vehicle_state_count];
      flatten(from, wide);
      for (int i = 0; i < static_cast<int>(sizeof to / sizeof(float)); ++i)
        flat[i] = static_cast<float>(wide[i]);
      unflatten(flat, to);
    };
    SystemFlight<float> systems{};
    State<float> x;
    Controls<float> u;
    narrow(f.state(), systems.state);
    narrow(f.vehicle().commands, systems.vehicle.commands);
    narrow(f.s.state, x);
    narrow(f.s.controls, u);
    systems.vehicle.on = f.vehicle().on;
    systems.vehicle.loaded_mass = static_cast<float>(f.vehicle().loaded_mass);
    Simulation<float> s;
    CHECK(start(c, x, u, 0.005f, Integrator::rk3, s) == Status::ok);
    for (int k = 0; k < 400; ++k) CHECK(advance_vehicle(c, systems, single, s) == Status::ok);
    CHECK(fly(f, 400) == Status::ok);
    CHECK_NEAR(s.state.velocity.x, f.s.state.velocity.x, 0.01);
    CHECK_NEAR(s.state.velocity.z, f.s.state.velocity.z, 0.02);
    CHECK_NEAR(s.state.rates.y, f.s.state.rates.y, 1e-3);
    CHECK_NEAR(s.state.roll, f.s.state.roll, 2e-3);
    CHECK_NEAR(systems.state.mast, f.state().mast, 1e-5);
    CHECK_NEAR(systems.state.rotor_speed, f.state().rotor_speed, 0.01);
    CHECK_REL(systems.state.power[left], f.state().power[left], 1e-4);
  }
}

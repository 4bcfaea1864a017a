// `ok` means a pilot could fly it: power and torque, descent, vertical flight, inputs, floating-point
// exceptions.
// Expected: published ratings and tables of air, momentum theory by hand, Newton's law.
#include <algorithm>
#include <cfenv>
#include <cmath>

#include "analysis_case.hpp"

using namespace analysis_case;

namespace {

constexpr double kHorsepower = 745.69987158227;

Configuration<double> realtime(double mast_deg, double altitude = 0) {
  Options options;
  options.grid = BladeGrid::realtime;
  return flown_configuration(mast_deg, altitude, options);
}

// Of both rotors with the engines at take-off power: sea level's times pressure over the square root of temperature,
// both over those of sea level, in the standard troposphere.
double take_off_power(const Configuration<double>& c) {
  const ControlTables<double>& t = c.aircraft->controls;
  const double temperature = 1 - 0.0065 * c.setup.altitude / 288.15;
  return t.engines * t.engine_power * t.transmission_efficiency * std::pow(temperature, 5.25588 - 0.5);
}

double total_power(const TrimResult<double>& r) { return r.power[right] + r.power[left]; }

bool names(const TrimResult<double>& r, TrimLimit limit) {
  for (int k = 0; k < r.limits.count; ++k)
    if (r.limits.exceeded[k].limit == limit) return true;
  return false;
}

}  // namespace

// No flight within the limits needs more than the engines give, none with the status power_limit less.
TEST(trim_power_beyond_the_engines) {
  const Configuration<double> c = realtime(90);
  const double available = take_off_power(c);
  const std::string rating = std::to_string(available / 1000);  // kW
  int within = 0, beyond = 0;
  for (const double speed : {80.0, 100.0, 120.0, 130.0, 140.0, 150.0}) {
    const TrimResult<double> r = trimmed(c, flown(level(speed)));
    if (!CHECK(is_trimmed(r.status))) continue;
    const bool enough = total_power(r) <= available;
    ++(enough ? within : beyond);
    CHECK_EQ(names(r, TrimLimit::power), !enough);
    if (r.status == TrimStatus::ok) CHECK(enough);
    if (r.status == TrimStatus::power_limit)
      CHECK(contains(explanation(r),
                     ("is beyond take-off rating " + rating.substr(0, rating.find('.') + 2)).c_str()));
  }
  CHECK_LT(0, within);
  CHECK_LT(0, beyond);
}

// Two engines of 1550 hp for take-off, 93 % of it at the rotors (NASA SP-2000-4517, TM X-62407).
TEST_OF_XV15(trim_power_is_that_of_the_engines) {
  CHECK_REL(take_off_power(realtime(90)), 2 * 1550 * kHorsepower * 0.93, 1e-12);
}

// Power lapses with pressure over the square root of temperature: at 2331.7 m 0.7531 and 0.97337 by ISO 2533's tables.
TEST(trim_power_lapses_with_altitude) {
  const Configuration<double> c = configuration(0, {}, 2331.7);
  const ControlTables<double>& t = c.aircraft->controls;
  CHECK_REL(shaft_power(c, 1.0), t.engines * t.transmission_efficiency * 0.7531 / 0.97337, 1e-3);
}

// A level flight is trimmed on the engines that run as on any, and told where their power is not enough.
TEST_OF_XV15(trim_power_is_that_of_the_engines_that_run) {
  const Configuration<double> c = realtime(0);
  for (const double speed : {0.0, 20.0, 40.0}) {
    const TrimResult<double> all = trimmed(c, level(speed));
    const double needed = all.power[right] + all.power[left];
    for (const int engines : {0, 1, 2}) {
      TrimOptions options;
      options.engines = engines;
      const TrimResult<double> r = trimmed(c, level(speed), options);
      CHECK(r.status ==
            (needed > engines * 1550 * kHorsepower * 0.93 ? TrimStatus::power_limit : TrimStatus::ok));
      CHECK_EQ(r.power[right], all.power[right]);
    }
  }
}

// 2332 m (7650 ft) is the hover ceiling at take-off power of TM-81244 fig. 12.
TEST_OF_XV15(trim_power_has_a_hover_ceiling) {
  CHECK(!names(trimmed(realtime(0, 1500), level(0)), TrimLimit::power));
  CHECK(names(trimmed(realtime(0, 3600), level(0)), TrimLimit::power));
}

// A mast carries 163,000 in lbf steadily.
TEST_OF_XV15(trim_torque_beyond_the_mast) {
  const Configuration<double> c = realtime(0);
  RotorResponse<double> rotor[2] = {};
  rotor[left].loads.torque = 1.001 * 163000 * 0.0254 * 4.4482216152605;
  LimitCheck<double> check = check_limits(c, 0.0, 0.0, State<double>{}, {}, {}, rotor);
  CHECK(check.status == TrimStatus::torque_limit && is_trimmed(check.status));
  CHECK(check.count == 1 && check.exceeded[0].limit == TrimLimit::torque_left);
  rotor[left].loads.torque *= 0.998;
  CHECK(check_limits(c, 0.0, 0.0, State<double>{}, {}, {}, rotor).status == TrimStatus::ok);
}

// The boundaries by Johnson, NASA/TP-2005-213477, in axial flow and at their corners; the roots of
// v^2 |V + v| ... by hand: at V = -2.5 v_h they are 0.5, 2 and 2.85 v_h.
TEST(trim_momentum_range) {
  const DescentInflow alone = DescentInflow::momentum, measured = DescentInflow::vortex_ring;
  const auto at = [](double axial, double in_plane, double induced,
                     DescentInflow law = DescentInflow::momentum) {
    return momentum_range(AxialFlow<double>{16 * axial, 16 * in_plane, 16 * induced, 16}, law);
  };
  const MomentumRange holds = MomentumRange::holds, ring = MomentumRange::vortex_ring;
  for (const double v : {0.5, 0.0, -0.2, -0.44}) CHECK(at(v, 0, 1) == holds);
  for (const double v : {-0.46, -0.7, -1.0, -1.5, -1.99}) CHECK(at(v, 0, 1) == ring);
  CHECK(at(-2.01, 0, 0.9) == holds);
  CHECK(at(-0.975, 0.94, 1) == ring);
  CHECK(at(-0.975, 0.96, 1) == holds);
  CHECK(at(-1.5, 0.99, 1) == ring);
  CHECK(at(-1.5, 1.01, 0.5) == holds);
  CHECK(at(-2.5, 0, 0.5) == holds);
  CHECK(at(-2, 1, 3) == holds);  // V^2 < 8 Vx^2: the roots run into one another, there is no other branch
  CHECK(at(-2.5, 0, 2.0) == MomentumRange::other_branch);
  CHECK(at(-2.5, 0, 2.85) == MomentumRange::other_branch);
  // Idle, and with the thrust down the shaft: a climb is then a descent.
  CHECK(momentum_range(AxialFlow<double>{-40, 0, 0, 0}, alone) == holds);
  const AxialFlow<double> pushed = axial_flow(1.2, 3.8, -28000.0, 15.0, -1.0, -16.0);
  CHECK_EQ(pushed.axial, -15.0);
  CHECK_EQ(pushed.induced, 16.0);
  CHECK(momentum_range(pushed, alone) == ring);
  // With the inflow of measured rotors only the boundary of vortex ring counts.
  for (const double v : {-0.46, -1.0, -1.49}) CHECK(at(v, 0, 1, measured) == ring);
  for (const double v : {0.5, -0.44, -1.51, -1.99, -2.5}) CHECK(at(v, 0, 2, measured) == holds);
  CHECK(at(-0.975, 0.94, 1, measured) == ring && at(-0.975, 0.96, 1, measured) == holds);
  CHECK(momentum_range(pushed, measured) == ring);
}

// Vertical descent of a helicopter at 12 to 20 m/s is vortex ring; gentle and shallow descents are not.
TEST(trim_descent_in_its_own_wake) {
  const Configuration<double> c = realtime(0);
  for (const double speed : {12.0, 16.0, 20.0}) {
    const TrimResult<double> r = trimmed(c, flown({speed, -90 * kDeg, 0, 0}));
    if (!CHECK(r.status == TrimStatus::vortex_ring)) NOTE(speed << " m/s: " << trim_status_word(r.status));
    CHECK(names(r, TrimLimit::descent_right) && names(r, TrimLimit::descent_left));
    CHECK(contains(explanation(r), "v_h is beyond vortex ring from 0.45 v_h"));
  }
  CHECK(trimmed(c, flown({3, -90 * kDeg, 0, 0})).status == TrimStatus::ok);
  CHECK(trimmed(c, flown({40, -6 * kDeg, 0, 0})).status == TrimStatus::ok);
}

// Beyond the boundary, 1.5 v_h, the turbulent wake carries a vertical descent; by momentum theory alone it has
// no meaning. Power falls with descent and ends in autorotation. In vortex ring the rotors need more collective.
TEST(trim_descent_beyond_vortex_ring) {
  const Configuration<double> c = realtime(0);
  FlightSetup<double> setup = c.setup;
  setup.options.descent_inflow = DescentInflow::momentum;
  Configuration<double> by_momentum;
  CHECK(prepare(aircraft_data<double>(), setup, by_momentum) == Status::ok);
  double last = HUGE_VAL;
  for (const double speed : {26.0, 27.0, 28.0}) {
    const SteadyFlight<double> down = flown({speed, -90 * kDeg, 0, 0});
    const TrimResult<double> r = trimmed(c, down);
    if (!CHECK(r.status == TrimStatus::ok)) NOTE(speed << " m/s: " << explanation(r));
    CHECK(trimmed(by_momentum, down).status == TrimStatus::vortex_ring);
    CHECK_LT(total_power(r), last);
    last = total_power(r);
  }
  CHECK_LT(last, 0.3 * total_power(trimmed(c, level(0))));
  for (const double speed : {10.0, 16.0}) {
    const SteadyFlight<double> down = flown({speed, -90 * kDeg, 0, 0});
    CHECK_LT(trimmed(by_momentum, down).controls.collective + 0.5 * kDeg,
             trimmed(c, down).controls.collective);
  }
}

// Straight up and down: no turn, no bank, and the velocity is that of the flight path.
TEST(trim_vertical_flight) {
  const Configuration<double> c = realtime(0);
  for (const double climb : {-90.0, 90.0}) {
    const SteadyFlight<double> flight = flown({5, climb * kDeg, 0, 0});
    const TrimResult<double> r = trimmed(c, flight);
    if (!CHECK(r.status == TrimStatus::ok)) NOTE(explanation(r));
    const Vector earth = to_earth(r.state.velocity, r.state.roll, r.state.pitch);
    CHECK_NEAR(earth.x, 0, 1e-12);
    CHECK_NEAR(earth.y, 0, 1e-12);
    CHECK_NEAR(earth.z, climb > 0 ? -flight.speed : flight.speed, 1e-12);
    CHECK(is_trimmed(trimmed(c, flown({5, climb * kDeg, 0.2, 0})).status));
    CHECK(trimmed(c, flown({5, climb * kDeg, 0, 0.1})).invalid == SteadyFlightField::sideslip);
  }
  // Up takes the power of lifting the weight; nearly vertical flight is nearly the same.
  const TrimResult<double> up = trimmed(c, flown({5, 90 * kDeg, 0, 0}));
  const TrimResult<double> near = trimmed(c, flown({5, 89.99 * kDeg, 0, 0}));
  CHECK_LT(total_power(trimmed(c, level(0))), total_power(up));
  CHECK_REL(total_power(near), total_power(up), 1e-4);
}

// A flight path or a sideslip without speed has no meaning, also downwards.
TEST(trim_standing_still_has_no_flight_path) {
  const Configuration<double> c = realtime(0);
  CHECK(trimmed(c, {0, 0.1, 0, 0}).invalid == SteadyFlightField::climb);
  CHECK(trimmed(c, {0, -0.1, 0, 0}).status == TrimStatus::out_of_range);
  CHECK(trimmed(c, {0, 0, 0, 0.1}).invalid == SteadyFlightField::sideslip);
  CHECK(contains(explanation(trimmed(c, {0, 0.1, 0, 0})), "0 at speed 0"));
}

// NaN and infinity in any field are not_finite, and so at the isolated rotor.
TEST(trim_not_finite_input_of_each_field) {
  const Configuration<double> c = realtime(0);
  const SteadyFlightField fields[] = {SteadyFlightField::speed, SteadyFlightField::climb,
                                      SteadyFlightField::turn_rate, SteadyFlightField::sideslip};
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    for (int k = 0; k < 4; ++k) {
      double value[4] = {10, 0, 0, 0};
      value[k] = bad;
      const TrimResult<double> r = trimmed(c, {value[0], value[1], value[2], value[3]});
      CHECK(r.status == TrimStatus::not_finite && r.invalid == fields[k]);
      CHECK(contains(explanation(r), "not a finite number"));
    }
  }
}

// Every exceeded limit is named, the gimbals too, and counted where the text is short.
TEST(trim_names_every_limit) {
  const TrimResult<double> r = trimmed(realtime(0), flown({45, -60 * kDeg, 0, 0}));
  if (!CHECK(is_trimmed(r.status))) return;
  CHECK(names(r, TrimLimit::long_stick) && names(r, TrimLimit::gimbal_right) &&
        names(r, TrimLimit::gimbal_left));
  CHECK(contains(explanation(r), "longitudinal stick"));
  CHECK(contains(explanation(r), "gimbal tilt"));
  for (const int capacity : {1, 40, 60, 100, 160}) {
    char text[200];
    const int length = explain(r, text, capacity);
    CHECK(length < capacity && text[length] == '\0');
  }
}

// Counted from the rear stop, like the column of `trim`: neutral is 4.8.
TEST(trim_text_counts_the_stick_from_its_rear_stop) {
  TrimResult<double> r{};
  r.limits.add(TrimStatus::control_limit, TrimLimit::long_stick, 5.25, 4.8);
  r.status = r.limits.status;
  CHECK_EQ(explanation(r), std::string("trimmed, but longitudinal stick 10.05 in is beyond 9.60 in"));
  r.limits.exceeded[0].value = -5.25;
  r.limits.exceeded[0].bound = -4.8;
  CHECK_EQ(explanation(r), std::string("trimmed, but longitudinal stick -0.45 in is beyond 0.00 in"));
}

// A legal call never raises an invalid operation, a division by zero or an overflow: random climbs, turns,
// sideslips and gusts over the whole range, and what follows a trim. Only some look further than their first
// attempt, which takes long.
TEST(trim_raises_no_floating_point_exception) {
  constexpr int serious = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;
  std::uint32_t seed = 12345;
  const auto random = [&seed](double low, double high) {
    seed = seed * 1664525u + 1013904223u;
    return low + (high - low) * seed / 4294967296.0;
  };
  const LimitTables<double>& limits = aircraft_data<double>().limits;
  const double most = limits.altitude.high;
  for (int k = 0; k < 1500; ++k) {
    const double mast = random(0, 90), altitude = k % 3 == 0 ? random(-500, 6000) : 0;
    const Configuration<double> c = realtime(mast, std::min(altitude, most - this_aircraft::altitude()));
    const double part = k % 2 ? 0.3 : 1;
    SteadyFlight<double> flight = {random(0.1, limits.speed), part * random(-90, 90) * kDeg,
                                   part * random(-60, 60) * kDeg, part * random(-60, 60) * kDeg};
    const double gust = limits.gust;
    if (k % 5 == 0) flight.gust = {random(-gust, gust), random(-gust, gust), random(-gust, gust)};
    if (k % 7 == 0) flight.climb = (k % 2 ? 90 : -90) * kDeg, flight.sideslip = 0;
    TrimOptions options;
    options.continuation = k % 15 == 0;
    if (!options.continuation) options.max_iterations = 8;
    std::feclearexcept(FE_ALL_EXCEPT);
    const TrimResult<double> r = trimmed(c, flight, options);
    const int raised = std::fetestexcept(serious);
    CHECK(r.status != TrimStatus::not_finite && r.status != TrimStatus::out_of_range);
    if (!CHECK_EQ(raised, 0))
      NOTE("mast " << c.setup.mast_deg << ", " << flight.speed << " m/s, climb " << flight.climb / kDeg
                   << ", turn " << flight.turn_rate / kDeg << ", sideslip " << flight.sideslip / kDeg);
    if (!is_trimmed(r.status) || k % 10 != 0) continue;
    ModeSet<double> set;
    std::feclearexcept(FE_ALL_EXCEPT);
    modes_of(c, r.state, r.controls, set);
    CHECK_EQ(std::fetestexcept(serious), 0);
  }
}

// Every legal flight has an attitude: one where the path along the body's y axis is the sideslip asked for.
// By the velocity found, turned to earth axes; steep climbs with sideslip need a bank at little pitch.
TEST(trim_finds_an_attitude_for_every_flight) {
  for (double climb = -89.9; climb < 90; climb += 9.99) {
    for (double sideslip = -60; sideslip <= 60; sideslip += 7.5) {
      for (double pitch : {-80.0, -10.0, 0.0, 45.0, 89.0}) {
        const SteadyFlight<double> flight = {50, climb * kDeg, 0, sideslip * kDeg};
        double roll = 0.1, found = pitch * kDeg;
        find_attitude(flight, roll, found);
        if (!CHECK(has_attitude(flight, roll, found))) NOTE(climb << ", " << sideslip << ", " << pitch);
        const Vec3<double> v = steady_velocity(flight, roll, found);
        CHECK_NEAR(v.y, 50 * std::sin(sideslip * kDeg), 1e-9);
        CHECK_NEAR(to_earth(v, roll, found).z, -50 * std::sin(climb * kDeg), 1e-9);
      }
    }
  }
}

// Manoeuvres that no attitude allows, or only one on the back, end with a sentence that says so.
TEST(trim_says_that_no_attitude_is_left) {
  const Configuration<double> c = realtime(60);
  const SteadyFlight<double> impossible[] = {{40, -75 * kDeg, 50 * kDeg, -50 * kDeg},
                                             {50, -75 * kDeg, 30 * kDeg, 50 * kDeg},
                                             {100, 60 * kDeg, 30 * kDeg, 55 * kDeg}};
  for (const SteadyFlight<double>& flight : impossible) {
    const TrimResult<double> r = trimmed(c, flown(flight));
    CHECK(r.status == TrimStatus::not_converged && r.obstacle == TrimObstacle::attitude);
    CHECK(contains(explanation(r), "climb, turn and sideslip leave no attitude that balances the forces"));
    CHECK_LT(explanation(r).size(), 160u);
  }
  const TrimResult<double> dive = trimmed(realtime(78), flown({97, -90 * kDeg, 0, 0}));
  CHECK(dive.status == TrimStatus::not_converged && dive.obstacle == TrimObstacle::upside_down);
  CHECK(contains(explanation(dive), "on its back or past the vertical"));
}

// The same descents and hover in air that rises and sinks: what counts is the motion through the air.
TEST(trim_limits_are_those_of_still_air) {
  const Configuration<double> c = realtime(0);
  int descents = 0;
  for (const double climb : {0.0, -30.0, -60.0, -90.0}) {
    const SteadyFlight<double> still = flown({climb == 0 ? 0.0 : 10.0, climb * kDeg, 0, 0});
    const TrimStatus expected = trimmed(c, still).status;
    descents += expected == TrimStatus::vortex_ring;
    for (const double gust : {-15.0, 10.0, 15.0}) {
      SteadyFlight<double> moving = still;
      moving.gust = {0, 0, gust * this_aircraft::speed()};
      if (!CHECK(trimmed(c, moving).status == expected)) NOTE(climb << " deg, gust " << gust << " m/s");
    }
  }
  CHECK_LE(1, descents);
}

// Steep descents in airplane mode, where the rotors would drive the engines: by the sign of the shaft power
// and by the size of the torque, whatever its sign. At sea level, for which engines and masts are rated.
TEST(trim_windmilling_rotors_drive_nothing) {
  const Configuration<double> c = configuration(90);
  const ControlTables<double>& t = c.aircraft->controls;
  int driving = 0, twisted = 0, gentle = 0;
  for (const double speed : {100.0, 150.0}) {
    for (const double climb : {0.0, -6.0, -12.0, -20.0, -30.0, -45.0, -60.0}) {
      const TrimResult<double> r = trimmed(c, flown({speed, climb * kDeg, 0, 0}));
      if (!is_trimmed(r.status)) continue;
      const bool drives = total_power(r) < -0.07 * t.engines * t.engine_power;
      const bool twists = std::fabs(r.power[right]) / c.setup.rotor_speed > t.mast_torque;
      CHECK_EQ(names(r, TrimLimit::windmill_power), drives);
      CHECK_EQ(names(r, TrimLimit::torque_right), twists);
      CHECK_EQ(names(r, TrimLimit::torque_left), twists);
      if (drives || twists) CHECK(r.status != TrimStatus::ok);
      driving += drives;
      twisted += twists;
      gentle += !drives;
    }
  }
  NOTE(driving << " descents drive the engines, " << twisted << " twist the masts too far");
  CHECK(driving > 0 && gentle > 0);
}

// -0.07 of two engines of 1550 hp at 20 deg down; 163,000 in lbf in the dive.
TEST_OF_XV15(trim_windmilling_rotors_of_the_xv15) {
  const TrimResult<double> steep = trimmed(realtime(90), {100, -20 * kDeg, 0, 0});
  CHECK_LT(total_power(steep), -0.07 * 2 * 1550 * kHorsepower);
  CHECK(names(steep, TrimLimit::windmill_power));
  CHECK(steep.status != TrimStatus::ok);
  const TrimResult<double> dive = trimmed(realtime(90), {150, -45 * kDeg, 0, 0});
  CHECK_LT(dive.power[right] / realtime(90).setup.rotor_speed, -18416.5);
  CHECK(names(dive, TrimLimit::torque_right) && names(dive, TrimLimit::torque_left));
}

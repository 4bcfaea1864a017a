// Rotors that cannot carry the aircraft, because they turn slowly, the air is thin or the weight is large: the
// trim says so, and how much they carry. Expected: a rotor stalls at a thrust coefficient over solidity near
// that of the usual flight with the most weight, so what it carries goes with density, with the square of its
// speed, and against the weight.
#include "analysis_case.hpp"

using namespace analysis_case;

namespace {

TrimResult<double> hovering(double mast_deg, double rpm, double mass, double altitude, double speed = 0) {
  FlightSetup<double> setup = flight_setup(aircraft_data<double>(), mast_deg);
  setup.rotor_speed = rpm * kPi<double> / 30;
  setup.mass = mass;
  setup.altitude = altitude;
  setup.options.grid = BladeGrid::realtime;
  Configuration<double> c;
  CHECK(prepare(aircraft_data<double>(), setup, c) == Status::ok);
  return trimmed(c, level(speed));
}

}  // namespace

TEST_OF_XV15(trim_tells_rotor_stall_whatever_the_rotor_speed_altitude_and_weight) {
  double least = 1;
  double most = 0;
  for (const double mast : {0.0, 10.0, 20.0, 30.0}) {
    for (const double rpm : {200.0, 300.0, 400.0, 589.0}) {
      for (const double mass : {5896.7, 10000.0}) {
        for (const double altitude : {0.0, 6000.0, 11000.0}) {
          const TrimResult<double> r = hovering(mast, rpm, mass, altitude);
          if (is_trimmed(r.status)) continue;
          if (!CHECK(r.status == TrimStatus::rotor_stall))
            NOTE("mast " << mast << ", " << rpm << " rpm, " << mass << " kg, " << altitude
                         << " m: " << trim_status_word(r.status));
          CHECK(contains(explanation(r), "before its rotors stall"));
          const double density = standard_air(altitude).density / standard_air(0.0).density;
          const double loading = r.weight_carried * mass / (density * rpm * rpm);
          least = std::min(least, loading);
          most = std::max(most, loading);
        }
      }
    }
  }
  NOTE("blade loading at stall: largest over smallest " << most / least);
  CHECK_LT(most / least, 1.5);
}

TEST_OF_XV15(trim_tells_rotor_stall_in_slow_flight_too) {
  for (const double speed : {4.0, 8.0})
    for (const double mast : {0.0, 10.0, 20.0})
      for (const double rpm : {200.0, 300.0})
        CHECK(hovering(mast, rpm, 5896.7, 0, speed).status == TrimStatus::rotor_stall);
}

// Room for every unknown, and an unknown for every state that the flight does not set.
TEST(trim_unknowns_are_what_the_flight_does_not_set) {
  FlightSetup<double> setup = flight_setup(aircraft_data<double>(), 0.0);
  setup.options.coning_states = setup.options.position_states = true;
  Configuration<double> c;
  CHECK(prepare(aircraft_data<double>(), setup, c) == Status::ok);
  TrimEquations<double> equations;
  trim_equations(c, equations);
  CHECK_EQ(equations.count, kMaxTrimUnknowns);
  CHECK_EQ(count_trim_unknowns(), kMaxTrimUnknowns);
}

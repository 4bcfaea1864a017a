// Dimensional analysis of the whole model: an aircraft of another size in other air, scaled by the laws of
// Froude and Mach, flies the same flight. A forgotten power of a length, a constant with a hidden unit or a
// width of smoothing in the wrong dimension breaks it.
#include "analysis/analysis_case.hpp"
#include "check.hpp"
#include "model/flight_cases.hpp"
#include "properties/scaled_aircraft.hpp"

using namespace tiltrotor;
using flight_cases::flat;
using flight_cases::Generator;
using flight_cases::StateAndControls;
using scaled::Scale;
using scaled::ScaledAircraft;
using V = Vec3<double>;

namespace {

constexpr unsigned kSeed = 20260602;
constexpr Scale kScales[] = {{0.93, 1.25}, {1.04, 0.8}};  // within the ranges of mass and stations

// Every switch that selects another formula.
Options random_options(Generator& random) {
  Options o;
  o.tables = random.coin() ? Interpolation::c1 : Interpolation::linear;
  o.grid = random.coin() ? BladeGrid::specification : BladeGrid::realtime;
  o.flapping = random.coin() ? FlapOrder::second : FlapOrder::first;
  o.flap_angular_acceleration = random.coin();
  o.coning_states = random.coin();
  o.inflow = random.coin() ? InflowShape::pitt_peters : InflowShape::uniform;
  o.disk_plane_inflow = random.coin();
  o.side_by_side = random.coin();
  o.sideward_flight = random.coin();
  o.wake = random.coin() ? WakeModel::geometric : WakeModel::gtrs_empirical;
  o.wash = random.coin() ? WashFactor::constant : WashFactor::vortex_cylinder;
  o.wing_rate_velocity = random.coin();
  o.downwash_lag = random.coin();
  o.tail_pressure = random.coin() ? TailPressure::by_mast : TailPressure::constant;
  o.tail_sideslip_loss = random.coin();
  o.fin_area = random.coin() ? FinArea::drawings : FinArea::report;
  o.chord = random.coin() ? ChordSource::cutout : ChordSource::camrad;
  o.lateral_cyclic = random.coin();
  o.position_states = true;
  return o;
}

void check_vectors(const V& actual, const V& expected, double tolerance) {
  CHECK_NEAR(actual.x, expected.x, tolerance);
  CHECK_NEAR(actual.y, expected.y, tolerance);
  CHECK_NEAR(actual.z, expected.z, tolerance);
}

}  // namespace

TEST(property_scaled_aircraft_has_scaled_loads_and_rates) {
  NOTE("seed " << kSeed);
  for (const Scale& s : kScales) {
    Generator random(kSeed);
    const ScaledAircraft small(flight_cases::aircraft(), s);
    for (int k = 0; k < 150; ++k) {
      const double masts[] = {0, 90, random.between(0, 90)};
      FlightSetup<double> setup = flight_setup(flight_cases::aircraft(), masts[k % 3]);
      setup.options = random_options(random);
      setup.mast_rate = 0;
      Configuration<double> c;
      Configuration<double> d;
      if (!CHECK(prepare(flight_cases::aircraft(), setup, c) == Status::ok)) return;
      if (!CHECK(scaled::prepare_scaled(small, s, setup, d) == Status::ok)) return;
      const StateAndControls<double> x = flight_cases::random_case(random, c);

      Evaluation<double> a;
      Evaluation<double> b;
      evaluate_aircraft(c, x.x, x.u, a);
      evaluate_aircraft(d, scaled::scaled_state(x.x, s), scaled::scaled_controls(x.u, s), b);
      const double weight = c.mass.mass * kGravity<double>;
      for (int component = 0; component < component_count; ++component) {
        const Loads<double>& full = a.loads.component[component];
        const Loads<double>& model = b.loads.component[component];
        check_vectors(model.force, s.force() * full.force, 1e-9 * weight * s.force());
        check_vectors(model.moment, s.moment() * full.moment, 1e-8 * weight * s.moment());
      }
      const auto expected = flat(scaled::scaled_rates(a.rates, s));
      const auto actual = flat(b.rates);
      const auto scale = flight_cases::rate_scale(c);
      for (std::size_t i = 0; i < state_count; ++i)
        CHECK_NEAR(actual[i], expected[i], 1e-9 * scale[i] * (1 + std::fabs(expected[i])));
    }
  }
}

// The trim search meets constants of its own (first guess, step limits): the solution must not depend on
// them.
TEST(property_scaled_aircraft_has_the_scaled_trim) {
  for (const Scale& s : kScales) {
    const ScaledAircraft small(flight_cases::aircraft(), s);
    for (const double mast : {0.0, 45.0, 90.0}) {
      const FlightSetup<double> setup = flight_setup(flight_cases::aircraft(), mast);
      Configuration<double> c;
      Configuration<double> d;
      CHECK(prepare(flight_cases::aircraft(), setup, c) == Status::ok);
      CHECK(scaled::prepare_scaled(small, s, setup, d) == Status::ok);
      const SteadyFlight<double> flight = {mast > 0 ? 80.0 : 20.0, 0.03, 0.05, 0.02};
      SteadyFlight<double> scaled_flight = flight;
      scaled_flight.speed *= s.speed();
      scaled_flight.turn_rate /= s.time();
      const TrimResult<double> a = analysis_case::trimmed(c, flight);
      const TrimResult<double> b = analysis_case::trimmed(d, scaled_flight);
      if (!CHECK(is_trimmed(a.status) && is_trimmed(b.status))) continue;
      const auto x = flat(scaled::scaled_state(a.state, s));
      const auto y = flat(b.state);
      for (std::size_t i = 0; i < state_count; ++i) CHECK_NEAR(y[i], x[i], 1e-7 * (1 + std::fabs(x[i])));
      CHECK_REL(b.power[right], s.force() * s.speed() * a.power[right], 1e-7);
      CHECK_REL(b.thrust[left], s.force() * a.thrust[left], 1e-7);
    }
  }
}

// A second aircraft from files: tables/scaled_xv15/, the XV-15 at 0.8 times its size with four blades, in air of
// 0.8 times the temperature. Expected values are those of the XV-15 at sea level and the laws of Froude and Mach;
// they hold to rounding for every load, rate, trim, limit and eigenvalue, because blade elements summed over the
// azimuth know solidity and disk inertia, not the number of blades. Blades one by one (AzimuthMode::individual) are
// four instead of three at each instant: only their mean over a turn is that of the other rotor.
#include <cmath>

#include "analysis/analysis_case.hpp"
#include "check.hpp"
#include "model/flight_cases.hpp"
#include "properties/scaled_aircraft.hpp"

#include "scaled_xv15_tables.inc"

using namespace tiltrotor;
using analysis_case::trimmed;
using flight_cases::flat;
using flight_cases::Generator;
using flight_cases::StateAndControls;
using scaled::Scale;

namespace {

constexpr unsigned kSeed = 20261126;
constexpr double kSize = 0.8;
// Of the standard atmosphere: temperature 288.15 K - 0.0065 K/m, density to the power 4.2559 of it.
constexpr double kAltitude = (1 - kSize) * 288.15 / 0.0065;
const Scale kScale = {kSize, std::pow(kSize, 4.2559)};

const Aircraft<double>& xv15() { return aircraft_data<double>(); }
const Aircraft<double>& second() {
  static constexpr Aircraft<double> aircraft = tables_of_scaled_xv15::make_aircraft<double>();
  return aircraft;
}

struct Pair {
  Configuration<double> full, model;
};

// The setup of the XV-15 at sea level and of the other at its altitude.
bool prepare_both(double mast_deg, const Options& options, Pair& pair) {
  FlightSetup<double> full = flight_setup(xv15(), mast_deg);
  FlightSetup<double> model = flight_setup(second(), mast_deg);
  full.options = model.options = options;
  model.altitude = kAltitude;
  return CHECK(prepare(xv15(), full, pair.full) == Status::ok) &&
         CHECK(prepare(second(), model, pair.model) == Status::ok);
}

}  // namespace

TEST_OF_XV15(property_scaled_tables_are_another_aircraft) {
  CHECK_EQ(second().rotor.blades, 4);
  CHECK_EQ(xv15().rotor.blades, 3);
  CHECK_EQ(second().wing.flap_settings, 3);
  CHECK_EQ(xv15().wing.flap_settings, 4);
  CHECK_REL(second().rotor.radius, kSize * xv15().rotor.radius, 1e-14);
  CHECK_REL(second().rotor.speed_airplane, xv15().rotor.speed_airplane / std::sqrt(kSize), 1e-14);
  CHECK_EQ(second().htail.rotor_wash.linear[0].count, xv15().htail.rotor_wash.linear[0].count + 1);
  // Printed at 20 kt, and at Froude's 17.9 kt.
  CHECK_REL(second().htail.rotor_wash.smooth[1].knot[1], 20 * std::sqrt(kSize), 1e-14);
  // Solidity: blades times chord over radius.
  const auto solidity = [](const RotorTables<double>& rotor) {
    return rotor.blades * blade_chord(rotor, ChordSource::cutout, 0.75) / rotor.radius;
  };
  CHECK_REL(solidity(second().rotor), solidity(xv15().rotor), 1e-14);
  CHECK(tables_of_scaled_xv15::kAircraftFingerprint != aircraft_fingerprint());
}

TEST_OF_XV15(property_scaled_tables_have_scaled_air) {
  const Air<double> sea_level = standard_air(0.0);
  const Air<double> there = standard_air(kAltitude);
  CHECK_REL(there.density, kScale.density * sea_level.density, 1e-12);
  CHECK_REL(there.speed_of_sound, kScale.speed() * sea_level.speed_of_sound, 1e-12);
}

// Each range belongs to its aircraft: what one takes, the other refuses.
TEST_OF_XV15(property_scaled_tables_have_their_own_ranges) {
  FlightSetup<double> setup = flight_setup(second(), 0.0);
  CHECK(first_out_of_range(second(), setup).field == SetupField::none);
  const SetupFault<double> fault = first_out_of_range(xv15(), setup);
  CHECK(fault.field == SetupField::mass);
  CHECK_EQ(fault.value, setup.mass);
  CHECK_EQ(fault.range.low, xv15().limits.mass.low);
  setup = flight_setup(xv15(), 0.0);
  CHECK(first_out_of_range(second(), setup).field == SetupField::mass);
  setup = flight_setup(second(), 0.0);
  setup.flap_deg = 75;  // setting 4, which it has not
  CHECK(first_out_of_range(second(), setup).field == SetupField::flap_deg);
}

TEST_OF_XV15(property_scaled_tables_have_scaled_loads_and_rates) {
  NOTE("seed " << kSeed);
  Generator random(kSeed);
  double worst = 0;
  for (int k = 0; k < 200; ++k) {
    const double masts[] = {0, 90, random.between(0, 90)};
    Pair pair;
    if (!prepare_both(masts[k % 3], scaled::random_options(random), pair)) return;
    const StateAndControls<double> x = flight_cases::random_case(random, pair.full);
    Evaluation<double> full;
    Evaluation<double> model;
    evaluate_aircraft(pair.full, x.x, x.u, full);
    evaluate_aircraft(pair.model, scaled::scaled_state(x.x, kScale), scaled::scaled_controls(x.u, kScale),
                      model);
    const double weight = pair.full.mass.mass * kGravity<double>;
    for (int component = 0; component < component_count; ++component) {
      const Loads<double>& expected = full.loads.component[component];
      const Loads<double>& actual = model.loads.component[component];
      scaled::check_vectors(actual.force, kScale.force() * expected.force, 1e-9 * weight * kScale.force());
      scaled::check_vectors(actual.moment, kScale.moment() * expected.moment,
                            1e-8 * weight * kScale.moment());
    }
    const auto expected = flat(scaled::scaled_rates(full.rates, kScale));
    const auto actual = flat(model.rates);
    const auto scale = flight_cases::rate_scale(pair.full);
    for (std::size_t i = 0; i < state_count; ++i) {
      const double tolerance = 1e-9 * scale[i] * (1 + std::fabs(expected[i]));
      worst = std::fmax(worst, std::fabs(actual[i] - expected[i]) / tolerance * 1e-9);
      CHECK_NEAR(actual[i], expected[i], tolerance);
    }
  }
  NOTE("largest difference of a rate " << worst);
}

// Trim, what it says of limits, and the modes about it.
TEST_OF_XV15(property_scaled_tables_have_the_scaled_trim_and_modes) {
  struct Flight {
    double mast_deg, speed;
  };
  double worst = 0;
  for (const Flight& f :
       {Flight{0, 0}, Flight{0, 40}, Flight{30, 60}, Flight{60, 70}, Flight{90, 100}, Flight{90, 120}}) {
    Pair pair;
    if (!prepare_both(f.mast_deg, Options{}, pair)) return;
    const double climb = f.speed > 0 ? 0.03 : 0;
    const SteadyFlight<double> flight = {f.speed, climb, 0.02, 0};
    const SteadyFlight<double> same = {f.speed * kScale.speed(), climb, 0.02 / kScale.time(), 0};
    const TrimResult<double> full = trimmed(pair.full, flight);
    const TrimResult<double> model = trimmed(pair.model, same);
    CHECK(is_trimmed(full.status));
    CHECK_EQ(static_cast<int>(model.status), static_cast<int>(full.status));
    CHECK_EQ(model.limits.count, full.limits.count);
    const auto expected = flat(scaled::scaled_state(full.state, kScale));
    const auto actual = flat(model.state);
    for (std::size_t i = 0; i < state_count; ++i)
      CHECK_NEAR(actual[i], expected[i], 1e-7 * (1 + std::fabs(expected[i])));
    CHECK_NEAR(model.controls.collective, full.controls.collective, 1e-8);
    CHECK_NEAR(model.controls.long_stick, full.controls.long_stick, 1e-6);
    CHECK_REL(model.power[right], kScale.force() * kScale.speed() * full.power[right], 1e-7);
    const double available = shaft_power(pair.full, xv15().controls.engine_power);
    CHECK_REL(shaft_power(pair.model, second().controls.engine_power),
              kScale.force() * kScale.speed() * available, 1e-12);

    static LinearModel<double> a, b;
    analysis_case::linear_model(pair.full, full.state, full.controls, kInceptors, a);
    analysis_case::linear_model(pair.model, model.state, model.controls, kInceptors, b);
    if (!CHECK_EQ(a.states, b.states)) return;
    // An element of A: what its state is over what its cause is, over time.
    State<double> ones;
    double one[state_count];
    for (double& x : one) x = 1;
    unflatten(one, ones);
    const auto size = flat(scaled::scaled_state(ones, kScale));
    double largest = 0;
    for (int i = 0; i < a.states; ++i)
      for (int j = 0; j < a.states; ++j) largest = std::fmax(largest, std::fabs(a.a(i, j)));
    for (int i = 0; i < a.states; ++i) {
      for (int j = 0; j < a.states; ++j) {
        const double factor = size[static_cast<std::size_t>(a.state[i])] /
                              size[static_cast<std::size_t>(a.state[j])] / kScale.time();
        const double error = std::fabs(b.a(i, j) - factor * a.a(i, j)) / (factor * largest);
        worst = std::fmax(worst, error);
        CHECK_LE(error, 1e-6);
      }
    }
  }
  NOTE("largest difference of an element of A, over the largest element: " << worst);
}

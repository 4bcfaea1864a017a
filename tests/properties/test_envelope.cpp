// The quick version of `make envelope`.
// Expected: the contract.
#include "check.hpp"
#include "properties/missions.hpp"

namespace {

void check_kept(const envelope::Breaches& breaches) {
  CHECK_EQ(breaches.text.size(), 0u);
  for (std::size_t i = 0; i < breaches.text.size() && i < 5; ++i) NOTE(breaches.text[i]);
}

void check_states(std::uint64_t seed, long count) {
  NOTE("seed " << seed);
  envelope::Breaches breaches;
  const envelope::StateCounts counts = envelope::try_states(seed, count, breaches);
  check_kept(breaches);
  for (int k = 0; k < envelope::corner_count; ++k) {
    CHECK_LE(count / envelope::corner_count, counts.tried[k]);
    CHECK_EQ(counts.not_finite[k], 0);  // inside the ranges of the contract the model has no hole
  }
  CHECK_LT(0, counts.setups_refused);
}

}  // namespace

TEST(envelope_states_are_finite_or_refused) { check_states(20260604, 3200); }
TEST(slow_envelope_states_are_finite_or_refused) { check_states(20260614, 20000); }

// Altitudes without air: the formula for the density gives zero at 44330.77 m and no real number above.
TEST(envelope_air_without_density_is_refused) {
  using namespace tiltrotor;
  FlightSetup<double> setup = flight_setup(aircraft_data<double>(), 0.0);
  static Configuration<double> c;
  for (const double altitude :
       {11000.1, 44330.0, 44330.77, 44331.0, 1e6, -501.0, -1e9, std::nan(""), HUGE_VAL}) {
    setup.altitude = altitude;
    CHECK(prepare(aircraft_data<double>(), setup, c) == Status::out_of_range);
    CHECK(c.aircraft == nullptr);  // nothing can be flown with it
    static SimulationWorkspace<double> work;
    Simulation<double> s;
    CHECK(start(c, State<double>{}, Controls<double>{}, 0.01, Integrator::rk4, s) == Status::bad_argument);
    CHECK(advance(c, work, s) == Status::bad_argument);
  }
}

TEST(envelope_flights_end_or_are_reported) {
  envelope::Breaches breaches;
  envelope::FlightCounts counts;
  for (std::uint64_t index = 0; index < 12; ++index) envelope::fly(index, 20, counts, breaches);
  check_kept(breaches);
  CHECK_EQ(counts.to_the_end + counts.diverged, counts.flown);
  CHECK_LT(0, counts.to_the_end);
}

TEST(envelope_missions_end_or_are_reported) {
  envelope::Breaches breaches;
  envelope::MissionCounts counts;
  for (std::uint64_t index = 0; index < 5; ++index) envelope::Mission(index, counts, breaches).fly(8);
  check_kept(breaches);
  CHECK_EQ(counts.in_the_air + counts.on_wheels + counts.struck + counts.lost, counts.flown);
  CHECK_LT(0, counts.flown - counts.lost);
  CHECK_LT(0, counts.linear_models);
}

// Left and right exchanged in state and controls must exchange left and right in the rates: every sign of
// every lateral term, both rotors' mirrored frames, the cant of the masts and the gearing take part.
#include <algorithm>

#include "flight_cases.hpp"

using namespace flight_cases;

namespace {

constexpr double kMasts[] = {0, 15, 30, 45, 60, 75, 90};

void check_mirror(Interpolation tables, unsigned seed, int states) {
  Options options;
  options.tables = tables;
  options.position_states = true;
  NOTE("seed " << seed << ", " << states << " states");
  Generator random(seed);
  double largest = 0;
  for (int n = 0; n < states; ++n) {
    options.coning_states = random.coin();
    options.lateral_cyclic = random.coin();
    options.flap_angular_acceleration = random.coin();
    options.side_by_side = random.coin();
    options.sideward_flight = random.coin();
    options.disk_plane_inflow = random.coin();
    options.tail_sideslip_loss = random.coin();
    const Configuration<double> c = configuration(kMasts[n % 7], options);
    const StateAndControls<double> s = random_case(random, c);
    State<double> rates;
    State<double> mirror_rates;
    derivative(c, s.x, s.u, rates);
    derivative(c, mirrored(s.x), mirrored(s.u), mirror_rates);
    const auto expected = flat(mirrored(rates));
    const auto actual = flat(mirror_rates);
    const auto scale = rate_scale(c);
    for (std::size_t i = 0; i < state_count; ++i) {
      const double error = std::abs(actual[i] - expected[i]) / std::max(scale[i], std::abs(expected[i]));
      CHECK_LE(error, 1e-12);
      largest = std::max(largest, error);
    }
  }
  NOTE("largest difference " << largest);
}

}  // namespace

TEST(mirror_random_states_c1) { check_mirror(Interpolation::c1, 20240611, 1000); }
TEST(mirror_random_states_linear) { check_mirror(Interpolation::linear, 20240612, 1000); }

TEST(mirror_symmetric_flight) {
  const unsigned seed = 20240613;
  NOTE("seed " << seed);
  Generator random(seed);
  for (int n = 0; n < 140; ++n) {
    Options options;
    options.tables = n % 2 == 0 ? Interpolation::c1 : Interpolation::linear;
    const Configuration<double> c = configuration(kMasts[n % 7], options);
    StateAndControls<double> s = random_case(random, c);
    s.x.velocity.y = s.x.rates.x = s.x.rates.z = s.x.roll = s.x.yaw = 0;
    s.x.rotor[left] = s.x.rotor[right];
    s.x.coning[left] = s.x.coning[right];
    s.u.lat_stick = s.u.pedal = s.u.diff_collective = s.u.diff_long_cyclic = s.u.aileron = s.u.rudder = 0;
    s.u.gust.y = 0;
    Evaluation<double> out;
    evaluate_aircraft(c, s.x, s.u, out);
    CHECK_NEAR(out.rates.velocity.y, 0.0, 1e-12);
    CHECK_NEAR(out.rates.rates.x, 0.0, 1e-12);
    CHECK_NEAR(out.rates.rates.z, 0.0, 1e-12);
    CHECK_EQ(out.rates.roll, 0.0);
    CHECK_EQ(out.rates.yaw, 0.0);
    const auto r = flat(out.rotor[right]);
    const auto l = flat(out.rotor[left]);
    const double force = std::abs(out.rotor[right].loads.force_a.z);
    for (std::size_t i = 0; i < r.size(); ++i) CHECK_NEAR(l[i], r[i], 1e-12 * (force + std::abs(r[i])));
    // A symmetric aircraft flies up and forward, not nowhere: the loads themselves are there.
    CHECK_LT(1.0, std::abs(out.loads[Component::rotor_right].force.z) +
                      std::abs(out.loads[Component::rotor_right].force.x));
    CHECK_NEAR(out.loads[Component::rotor_right].force.y, -out.loads[Component::rotor_left].force.y,
               1e-9 * force);
  }
}

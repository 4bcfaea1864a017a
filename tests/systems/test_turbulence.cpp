// Turbulence against the law it is made from: MIL-F-8785C section 3.7 as printed, Dryden's spectra and correlations in
// closed form, isotropic turbulence between the rotors. Variances and spectra come from the filters' answers to one
// unit of noise, without chance (turbulence_response.hpp); one test flies 100,000 s and counts.
#include "tiltrotor/systems/turbulence.hpp"

#include <algorithm>

#include "check.hpp"
#include "systems/turbulence_response.hpp"

using namespace turbulence_response;

namespace {

constexpr Air kLow{50 * kFoot, 60, 15};
// The lowest height is a smooth one; what it changes at 50 ft: 0.3^2 / (4 * 12) m of 15 m.
constexpr double kSmoothing = 3e-4;

double hub_distance_ft() { return tiltrotor::hub_distance(aircraft().mast) / kFoot; }

}  // namespace

// Expected: MIL-F-8785C, by std::pow in feet; 1750 ft and 0.2 W20 above; half way between at 1500 ft.
TEST(turbulence_law_is_the_standard) {
  const double wind = 12;
  for (const double h : {30.0, 50.0, 200.0, 500.0, 900.0}) {
    const LowLaw expected = low_law(h, wind);
    const auto law = tiltrotor::dryden_law(Air{h * kFoot, 40, wind}, aircraft().gust);
    CHECK_REL(law.scale.x / kFoot, expected.level_scale, 8e-4);
    CHECK_REL(law.scale.z / kFoot, expected.vertical_scale, 8e-4);
    CHECK_REL(law.intensity.x, expected.level_intensity, 8e-4);
    CHECK_REL(law.intensity.z, expected.vertical_intensity, 1e-4);
    CHECK(law.scale.x == law.scale.y && law.intensity.x == law.intensity.y);
  }
  for (const double h : {2100.0, 5000.0, 30000.0}) {
    const auto law = tiltrotor::dryden_law(Air{h * kFoot, 40, wind}, aircraft().gust);
    for (const double scale : {law.scale.x, law.scale.y, law.scale.z}) CHECK_REL(scale, 1750 * kFoot, 1e-4);
    for (const double intensity : {law.intensity.x, law.intensity.y, law.intensity.z})
      CHECK_REL(intensity, 0.2 * wind, 1e-4);
  }
  const auto between = tiltrotor::dryden_law(Air{1500 * kFoot, 40, wind}, aircraft().gust);
  CHECK_REL(between.scale.x / kFoot, (1000 + 1750) / 2.0, 1e-3);
  CHECK_REL(between.intensity.z, (0.1 + 0.2) / 2 * wind, 1e-3);
  // Below the lowest height nothing changes, down to a helicopter in a pit.
  const auto lowest = tiltrotor::dryden_law(Air{0, 40, wind}, aircraft().gust);
  const auto below = tiltrotor::dryden_law(Air{-30, 40, wind}, aircraft().gust);
  CHECK_REL(lowest.scale.z, 10 * kFoot, 3e-3);
  CHECK_REL(below.scale.x, lowest.scale.x, 3e-3);
}

// Exactly, at any step: sigma^2 at rotors and tail; the wing's is that of the mean of two of this correlation.
TEST(turbulence_variance_is_the_law_at_any_step) {
  const LowLaw expected = low_law(50, kLow.wind_20_ft);
  const double d = hub_distance_ft();
  const double level = d / expected.level_scale;
  const double vertical = d / expected.vertical_scale;
  const double correlation[3] = {(1 - level / 2) * std::exp(-level), std::exp(-level),
                                 (1 - vertical / 2) * std::exp(-vertical)};
  double first[12] = {};
  for (const double dt : {0.01, 0.005, 0.02, 0.3}) {
    const Response response(kLow, dt, 60);
    for (int i = 0; i < 3; ++i) {
      const double sigma = i == 2 ? expected.vertical_intensity : expected.level_intensity;
      for (const int place : {right_rotor, left_rotor, tail})
        CHECK_REL(response.variance({place, i}), sigma * sigma, kSmoothing);
      CHECK_REL(response.variance({wing, i}), sigma * sigma * (1 + correlation[i]) / 2, kSmoothing);
      CHECK_REL(response.covariance({right_rotor, i}, {left_rotor, i}), sigma * sigma * correlation[i], 2e-3);
      for (int place = right_rotor; place <= tail; ++place) {
        double& reference = first[3 * place + i];
        if (dt == 0.01) reference = response.variance({place, i});
        CHECK_REL(response.variance({place, i}), reference, 1e-11);
      }
      for (int other = 0; other < i; ++other)
        for (const int place : {right_rotor, left_rotor, wing, tail})
          CHECK_EQ(response.covariance({place, i}, {place, other}), 0);
    }
  }
}

// Stationary covariance is that of any speed and step at once: it outlives every change of speed. Expected: F P F' +
// G G' = P with P of Lyapunov's equation in the path, A P + P A' + B B' = 0, solved by hand for one lag and two.
TEST(turbulence_variance_outlives_changes_of_speed) {
  constexpr int n = State::kCount;
  const auto place = [](State& s, int i) -> double& {
    double* found = nullptr;
    State::each(s, [&, k = 0](double& x) mutable {
      if (k++ == i) found = &x;
    });
    return *found;
  };
  // Tail: from one speed and step, by many steps.
  using Square = std::array<std::array<double, n>, n>;
  const auto stepped = [&](const Square& p, const Air& air, double dt) {
    Square f{};
    Square g{};
    Square next{};
    for (int j = 0; j < n; ++j) {
      State s{};
      place(s, j) = 1;
      State after = tiltrotor::turbulence_step(s, air, dt, Noise{}, aircraft());
      for (int i = 0; i < n; ++i) f[i][j] = place(after, i);
    }
    for (int j = 0; j < kChannels; ++j) {
      State after = tiltrotor::turbulence_step(State{}, air, dt, unit_noise(j), aircraft());
      for (int i = 0; i < n; ++i) g[i][j] = place(after, i);
    }
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        for (int k = 0; k < kChannels; ++k) next[i][j] += g[i][k] * g[j][k];
        for (int k = 0; k < n; ++k)
          for (int l = 0; l < n; ++l) next[i][j] += f[i][k] * p[k][l] * f[j][l];
      }
    return next;
  };
  Square p{};
  for (int i = 0; i < 2000; ++i) p = stepped(p, kLow, 0.05);
  for (int series = 0; series < 2; ++series) {
    CHECK_NEAR(p[5 * series][5 * series], 0.5, 1e-13);
    for (const int first : {5 * series + 1, 5 * series + 3}) {
      CHECK_NEAR(p[first][first], 0.5, 1e-13);
      CHECK_NEAR(p[first][first + 1], 0.25, 1e-13);
      CHECK_NEAR(p[first + 1][first + 1], 0.25, 1e-13);
    }
  }
  for (const double speed : {0.0, 5.0, 130.0})
    for (const double dt : {0.0, 0.001, 0.02, 2.0}) {
      const Square next = stepped(p, Air{kLow.height, speed, kLow.wind_20_ft}, dt);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) CHECK_NEAR(next[i][j], p[i][j], 1e-13);
    }
}

// Along the path: e^(-x/L); across it (1 - x/2L) e^(-x/L).
TEST(turbulence_correlation_along_the_path_is_drydens) {
  const double dt = 0.01;
  const Response response(kLow, dt, 60);
  const LowLaw law = low_law(50, kLow.wind_20_ft);
  for (const int lag : {1, 5, 20, 60, 150, 400})
    for (const int place : {right_rotor, left_rotor, wing, tail})
      for (int i = 0; i < 3; ++i) {
        const double scale = (i == 2 ? law.vertical_scale : law.level_scale) * kFoot;
        const double x = lag * dt * kLow.airspeed / scale;
        const double expected = (i == 0 ? 1 : 1 - x / 2) * std::exp(-x);
        // A lag of z lengths a step has ln((1 + z/2)/(1 - z/2)) = z + z^3/12 in place of z.
        const double z = dt * kLow.airspeed / scale;
        const double allowed = kSmoothing + x * z * z / 6;
        CHECK_NEAR(response.covariance({place, i}, {place, i}, lag) / response.variance({place, i}), expected,
                   allowed);
      }
}

// Dryden's spectra, one-sided, against w = V Omega.
TEST(turbulence_spectrum_is_drydens) {
  const double dt = 0.005;
  const Response response(kLow, dt, 60);
  const LowLaw law = low_law(50, kLow.wind_20_ft);
  double worst = 0;
  for (const double frequency : {0.05, 0.3, 1.0, 3.0, 8.0, 20.0})
    for (const int place : {right_rotor, left_rotor, tail})
      for (int i = 0; i < 3; ++i) {
        const double scale = (i == 2 ? law.vertical_scale : law.level_scale) * kFoot;
        const double sigma = i == 2 ? law.vertical_intensity : law.level_intensity;
        const double s = scale * frequency / kLow.airspeed;
        const double form = i == 0 ? 2 / (1 + s * s) : (1 + 3 * s * s) / ((1 + s * s) * (1 + s * s));
        const double expected = sigma * sigma * scale / kPi / kLow.airspeed * form;
        const std::complex<double> actual = response.spectrum({place, i}, {place, i}, frequency);
        worst = std::max(worst, std::abs(actual.real() / expected - 1));
        // Frequencies are bent by (w dt)^2 / 12, sampling folds what is beyond half the rate.
        CHECK_REL(actual.real(), expected, 1e-3 + std::pow(frequency * dt, 2) / 2);
      }
  NOTE("worst error of a spectrum " << worst);
}

// Printed with the law: 0.61 at L = 100 ft, 0.95 at 1000 ft, for a component across the line between the rotors; what
// blows along that line is alike over twice the distance.
TEST_OF_XV15(turbulence_rotors_are_as_alike_as_in_isotropic_air) {
  const auto correlation = [](double height_ft) {
    const auto law = tiltrotor::dryden_law(Air{height_ft * kFoot, 40, 10}, aircraft().gust);
    return tiltrotor::rotor_correlation(law, aircraft().mast);
  };
  CHECK_NEAR(correlation(100).z, 0.61, 0.005);
  CHECK_NEAR(correlation(1000).z, 0.95, 0.005);
  CHECK_NEAR(tiltrotor::hub_distance(aircraft().mast), 2 * 193.98 * 0.0254, 1e-3);
  const double x = 2 * 193.98 / 12 / low_law(100, 10).level_scale;
  CHECK_NEAR(correlation(100).x, (1 - x / 2) * std::exp(-x), 1e-4);
  CHECK_NEAR(correlation(100).y, std::exp(-x), 1e-4);
  for (double h = 0; h < 3000; h += 10)
    for (const double r : {correlation(h).x, correlation(h).y, correlation(h).z}) CHECK(r > -0.04 && r < 1);
}

// Phase of the tail behind the wing: that of the distance, w l/V, to the fifth order. Most alike are they where the
// answer of the all-pass to a step crosses 1/2, the median of its memory: 1 - 4 sqrt(3) e^-3t sin(sqrt(3) t) = 1/2, for
// gusts much longer than the aircraft.
TEST(turbulence_reaches_the_tail_later) {
  const double delay = tiltrotor::tail_distance(aircraft()) / kLow.airspeed;
  const double dt = delay / 50;
  const Response response({200 * kFoot, kLow.airspeed, 15}, dt, 300 * delay);
  double crossing = 0.5;
  while (4 * std::sqrt(3.0) * std::exp(-3 * crossing) * std::sin(std::sqrt(3.0) * crossing) > 0.5)
    crossing += 1e-4;
  for (int i = 0; i < 3; ++i) {
    for (const double turns : {0.1, 0.5, 1.0, 2.0}) {
      const double phase = std::arg(response.spectrum({tail, i}, {wing, i}, turns / delay));
      CHECK_NEAR(phase, -turns, 1.1 * std::pow(turns, 5) / 720 + 1e-3);
    }
    int peak = 0;
    double most = 0;
    for (int lag = 0; lag < 100; ++lag) {
      const double value = response.covariance({tail, i}, {wing, i}, lag);
      if (value > most) peak = lag;
      most = std::max(most, value);
    }
    CHECK_NEAR(peak / 50.0, crossing, 0.03);
    CHECK_LT(0.97, most / std::sqrt(response.variance({wing, i}) * response.variance({tail, i})));
  }
  CHECK_NEAR(crossing, 0.875, 0.001);
}

// Twice as fast at half the step reads the same air: every answer is the same.
TEST(turbulence_is_frozen) {
  State slow{};
  State fast{};
  for (int k = 0; k < 1000; ++k) {
    const Noise noise = tiltrotor::gust_noise<double>(5, k);
    slow = turbulence_step(slow, Air{40, 35, 10}, 0.02, noise, aircraft());
    fast = turbulence_step(fast, Air{40, 70, 10}, 0.01, noise, aircraft());
  }
  const auto a = all(gusts_at(slow, Air{40, 35, 10}, aircraft()));
  const auto b = all(gusts_at(fast, Air{40, 70, 10}, aircraft()));
  for (std::size_t i = 0; i < a.size(); ++i)
    CHECK_NEAR(a[i], b[i], 2e-3);  // the floor under the speed is smooth
}

// Ten times 10,000 s. The mean square of one such run scatters by sqrt(2 L/V / 10,000 s) of itself, 1.8 % for u; that
// of ten by 0.56 %: 3 % is five times as much.
TEST(turbulence_flown_has_the_variance_of_the_law) {
  constexpr int seeds = 10;
  constexpr int steps = 500000;
  constexpr double dt = 0.02;
  const Response response(kLow, dt, 60);
  std::array<double, 12> square{};
  double product[3] = {};
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    State state{};
    for (std::uint64_t k = 0; k < steps; ++k) {
      state = turbulence_step(state, kLow, dt, tiltrotor::gust_noise<double>(seed, k), aircraft());
      if (k % 4 != 0) continue;
      const auto gusts = all(gusts_at(state, kLow, aircraft()));
      for (std::size_t i = 0; i < 12; ++i) square[i] += gusts[i] * gusts[i];
      for (std::size_t i = 0; i < 3; ++i) product[i] += gusts[i] * gusts[i + 3];
    }
  }
  const LowLaw law = low_law(50, kLow.wind_20_ft);
  const double count = seeds * steps / 4.0;
  for (int i = 0; i < 3; ++i) {
    const double sigma = i == 2 ? law.vertical_intensity : law.level_intensity;
    for (const int place : {right_rotor, left_rotor, tail}) {
      const double ratio = square[static_cast<std::size_t>(3 * place + i)] / count / (sigma * sigma);
      CHECK_NEAR(ratio, 1, 0.03);
      NOTE("place " << place << ", component " << i << ": variance over that of the law " << ratio);
    }
    CHECK_REL(square[static_cast<std::size_t>(3 * wing + i)] / count, response.variance({wing, i}), 0.03);
    CHECK_NEAR(product[i] / count / (sigma * sigma),
               response.covariance({right_rotor, i}, {left_rotor, i}) / (sigma * sigma), 0.03);
  }
}

// Dynamic inflow: the angle-free gain matrix against the wind-axis matrix inverted and turned explicitly,
// momentum theory in hover, climb and edgewise flight, rotation of the wind, the switches.
#include "settled_rotor.hpp"

using namespace flight_cases;
using settled_rotor::solve;

namespace {

constexpr double kGain = 15 * kPi<double> / 64;

InflowRates<double> rates(const Configuration<double>& c, double lambda_0, double lambda_c, double lambda_s,
                          const InflowForcing<double>& f) {
  RotorState<double> x{};
  x.lambda_0 = lambda_0;
  x.lambda_c = lambda_c;
  x.lambda_s = lambda_s;
  return inflow_rates(c, x, f);
}

}  // namespace

TEST(inflow_gain_matrix_by_inversion_and_rotation) {
  NOTE("seed 6");
  Generator random(6);
  double worst = 0;
  for (int n = 0; n < 1000; ++n) {
    const double x = random.between(0, 1);
    const double direction = random.between(-kPi<double>, kPi<double>);
    const double kappa = n % 2 == 0 ? 1 : random.between(0.9, 1.2);
    const double gain = n % 3 == 0 ? random.between(0.4, 1.42) : kGain;
    const double cosine = std::cos(direction);
    const double sine = std::sin(direction);
    // Rows and columns (0, downstream, across) of Pitt and Peters.
    const double wind[3][3] = {
        {kappa / 2, -gain * x, 0}, {gain * x, 2 * (1 - x * x), 0}, {0, 0, 2 * (1 + x * x)}};
    const double turn[3][3] = {{1, 0, 0}, {0, cosine, sine}, {0, -sine, cosine}};  // hub -> wind
    std::array<std::array<double, 3>, 3> hub{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        for (int k = 0; k < 3; ++k) {
          for (int l = 0; l < 3; ++l) hub[i][j] += turn[k][i] * wind[k][l] * turn[l][j];
        }
      }
    }
    const InflowGainInverse<double> g = inflow_gain_inverse(x * cosine, x * sine, gain, kappa);
    const double actual[3][3] = {
        {g.inv_00, g.inv_0c, g.inv_0s}, {g.inv_c0, g.inv_cc, g.inv_cs}, {g.inv_s0, g.inv_cs, g.inv_ss}};
    for (std::size_t j = 0; j < 3; ++j) {
      std::array<double, 3> unit{};
      unit[j] = 1;
      const std::array<double, 3> column = solve(hub, unit);
      for (std::size_t i = 0; i < 3; ++i) {
        CHECK_NEAR(actual[i][j], column[i], 1e-13);
        worst = std::max(worst, std::abs(actual[i][j] - column[i]));
      }
    }
  }
  NOTE("largest difference " << worst);
}

TEST(inflow_steady_is_momentum_theory) {
  const Configuration<double> c = configuration(0);
  for (const double lambda_0 : {0.03, 0.0727, 0.1}) {
    // C_T = 2 lambda^2; the smoothed speed adds (1e-3)^2 under the root.
    const double thrust = 2 * lambda_0 * std::sqrt(lambda_0 * lambda_0 + 1e-6);
    const InflowRates<double> r = rates(c, lambda_0, 0, 0, {thrust, 0, 0, 0, 0, 0});
    CHECK_NEAR(r.lambda_0, 0.0, 1e-13);
    CHECK_EQ(r.lambda_c, 0.0);
    CHECK_EQ(r.lambda_s, 0.0);
  }
}

// Hover of the isolated rotor at 7334 lb: lambda_h = sqrt(C_T / 2) = 0.0727.
TEST_OF_XV15(inflow_hover_is_momentum_theory) {
  const Configuration<double> c = configuration(0);
  const double area = kPi<double> * 3.81 * 3.81;
  const double thrust = 7334 * settled_rotor::kPound;
  const RotorInput<double> in = settled_rotor::settled_at_thrust(c, settled_rotor::hover_input(c), thrust);
  CHECK_REL(in.state.lambda_0, std::sqrt(thrust / (2 * 1.225 * area)) / c.tip_speed, 2e-4);
  CHECK_NEAR(in.state.lambda_0, 0.0727, 5e-5);
  CHECK_LT(std::hypot(in.state.lambda_c, in.state.lambda_s),
           0.003);  // only what the coned, tilted disk makes
}

TEST(inflow_axial_climb_and_forward_flight) {
  const Configuration<double> c = configuration(0);
  for (const double climb : {0.02, 0.1, 0.4}) {
    const double thrust = 0.01;
    const double lambda_0 = -climb / 2 + std::sqrt(climb * climb / 4 + thrust / 2);  // momentum theory
    CHECK_NEAR(rates(c, lambda_0, 0, 0, {thrust, 0, 0, 0, 0, climb}).lambda_0, 0.0,
               1e-3 * thrust * c.setup.rotor_speed);
  }
  // Edgewise: thrust alone makes n_c/n_0 = 2 k X downstream; X -> 1 gives 1.47.
  const double mu = 0.3;
  const double lambda_0 = 0.01;
  const double vt = std::sqrt(mu * mu + lambda_0 * lambda_0 + 1e-6);
  const double plus = 0.5 * (lambda_0 + std::sqrt(lambda_0 * lambda_0 + 25e-6));
  const double x = mu / (vt + plus);
  for (const double direction : {0.0, 0.7, 2.5}) {
    const double cosine = std::cos(direction);
    const double sine = std::sin(direction);
    const double thrust = 2 * vt * lambda_0;
    const InflowRates<double> r =
        rates(c, lambda_0, 2 * kGain * x * lambda_0 * cosine, 2 * kGain * x * lambda_0 * sine,
              {thrust, 0, 0, mu * cosine, mu * sine, 0});
    CHECK_NEAR(r.lambda_0, 0.0, 1e-12);
    CHECK_NEAR(r.lambda_c, 0.0, 1e-12);
    CHECK_NEAR(r.lambda_s, 0.0, 1e-12);
  }
  CHECK_NEAR(2 * kGain, 1.47, 0.005);
}

TEST(inflow_turns_with_the_wind) {
  const Configuration<double> c = configuration(0);
  NOTE("seed 12");
  Generator random(12);
  for (int n = 0; n < 200; ++n) {
    const double angle = n % 2 == 0 ? kPi<double> / 2 : random.between(-3, 3);
    const double cosine = std::cos(angle);
    const double sine = std::sin(angle);
    const InflowForcing<double> f{random.between(0, 0.02),     random.between(-2e-3, 2e-3),
                                  random.between(-2e-3, 2e-3), random.between(-0.3, 0.3),
                                  random.between(-0.3, 0.3),   random.between(-0.1, 0.3)};
    const double lambda_0 = random.between(0, 0.1);
    const double lambda_c = random.between(-0.03, 0.03);
    const double lambda_s = random.between(-0.03, 0.03);
    const InflowRates<double> a = rates(c, lambda_0, lambda_c, lambda_s, f);
    const InflowRates<double> b =
        rates(c, lambda_0, cosine * lambda_c - sine * lambda_s, sine * lambda_c + cosine * lambda_s,
              {f.c0, cosine * f.cc - sine * f.cs, sine * f.cc + cosine * f.cs,
               cosine * f.mu_x - sine * f.mu_y, sine * f.mu_x + cosine * f.mu_y, f.mu_z});
    CHECK_NEAR(b.lambda_0, a.lambda_0, 1e-12);
    CHECK_NEAR(b.lambda_c, cosine * a.lambda_c - sine * a.lambda_s, 1e-12);
    CHECK_NEAR(b.lambda_s, sine * a.lambda_c + cosine * a.lambda_s, 1e-12);
  }
}

TEST(inflow_apparent_mass) {
  const double omega = aircraft().rotor.speed_helicopter;
  Options options;
  for (const ApparentMass mass : {ApparentMass::impermeable, ApparentMass::loaded}) {
    options.apparent_mass = mass;
    const Configuration<double> c = configuration(0, options);
    const InflowForcing<double> still{0, 0, 0, 0.1, 0, 0};
    const InflowForcing<double> pushed{0.01, 0.002, -0.001, 0.1, 0, 0};
    const InflowRates<double> a = rates(c, 0.05, 0.01, 0.01, still);
    const InflowRates<double> b = rates(c, 0.05, 0.01, 0.01, pushed);
    const double m0 = mass == ApparentMass::impermeable ? 8 / (3 * kPi<double>) : 128 / (75 * kPi<double>);
    const double m1 = 16 / (45 * kPi<double>);
    CHECK_NEAR(b.lambda_0 - a.lambda_0, omega * 0.01 / m0, 1e-12);
    CHECK_NEAR(b.lambda_c - a.lambda_c, omega * 0.002 / m1, 1e-12);
    CHECK_NEAR(b.lambda_s - a.lambda_s, -omega * 0.001 / m1, 1e-12);
  }
}

TEST(inflow_uniform_and_induced_power_factor) {
  Options options;
  options.inflow = InflowShape::uniform;
  options.induced_power_factor = 1.1;
  const Configuration<double> c = configuration(0, options);
  for (const double mu : {0.0, 0.15}) {
    const double lambda_0 = 0.05;
    const double vt = std::sqrt(lambda_0 * lambda_0 + mu * mu + 1e-6);
    const InflowRates<double> r =
        rates(c, lambda_0, 0.02, -0.01, {2 * vt * lambda_0 / 1.1, 0.001, 0.001, mu, 0, 0});
    CHECK_NEAR(r.lambda_0, 0.0, 1e-12);  // lambda_0 = kappa C0 / (2 V_T)
    CHECK_EQ(r.lambda_c, 0.0);
    CHECK_EQ(r.lambda_s, 0.0);
  }
  // In the three-state form the factor multiplies the mean gain alone: hover lambda_0 = sqrt(kappa C0 / 2).
  options.inflow = InflowShape::pitt_peters;
  const Configuration<double> three = configuration(0, options);
  const double lambda_0 = 0.07;
  CHECK_NEAR(rates(three, lambda_0, 0, 0,
                   {2 * lambda_0 * std::sqrt(lambda_0 * lambda_0 + 1e-6) / 1.1, 0, 0, 0, 0, 0})
                 .lambda_0,
             0.0, 1e-12);
}

// Exact hover and descent through the rotor's own wake: no division by nothing.
TEST(inflow_is_finite_everywhere) {
  using T = Dual<double, 5>;
  const Configuration<double> c = configuration(0);
  for (const double mz : {0.0, -0.03, -0.05, -0.0727, -0.1, -0.3}) {
    for (const double lambda_0 : {0.0, 0.0727}) {
      RotorState<T> x{};
      x.lambda_0 = T::variable(lambda_0, 0);
      x.lambda_c = T::variable(0, 1);
      const InflowForcing<T> f{T(0.01),           T(0.0), T(0.0), T::variable(0, 2), T::variable(0, 3),
                               T::variable(mz, 4)};
      const InflowRates<T> r = inflow_rates(c, x, f);
      for (const T& rate : {r.lambda_0, r.lambda_c, r.lambda_s}) {
        CHECK(std::isfinite(rate.v));
        for (int j = 0; j < 5; ++j) CHECK(std::isfinite(rate.d.get(j)));
      }
      // In-plane wind at hover drives lambda_c at once: the wake skew has a slope there.
      if (lambda_0 > 0 && mz == 0) CHECK_LT(0.1, r.lambda_c.d.get(2));
    }
  }
}

// lambda_c / lambda_0 that thrust alone makes edgewise, where the wake's skew is 90 deg: tan(45 deg) and sqrt(2) sin(90
// deg), NASA TM-102219; 15 pi / 32 of Pitt and Peters.
TEST(inflow_gradient_laws) {
  for (const auto& [law, gradient] :
       {std::pair{InflowGradient::pitt_peters, 15 * kPi<double> / 32},
        std::pair{InflowGradient::coleman, 1.0}, std::pair{InflowGradient::white_blake, std::sqrt(2.0)}}) {
    CHECK_NEAR(2 * inflow_gradient(law, 1.0), gradient, 1e-14);
    // At a skew of 60 deg: tan(30 deg) times the first two, sqrt(2) sin(60 deg).
    const double t = std::tan(30 * kRadPerDeg<double>);
    const double at_60 = law == InflowGradient::white_blake ? std::sqrt(1.5) : gradient * t;
    CHECK_NEAR(2 * inflow_gradient(law, t * t) * t, at_60, 1e-14);
  }
}

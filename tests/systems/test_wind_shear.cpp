// Wind that grows with height. Expected: logarithms of the standard library, kinematics over the ground, quadrature.
#include "tiltrotor/systems/wind_shear.hpp"

#include "tiltrotor/math/differentiation/dual.hpp"
#include "vehicle_case.hpp"

using namespace vehicle_case;

namespace {

const GustTables<double>& gust() { return aircraft_data<double>().gust; }

// In level flight 20 m above the ground, or climbing, in a wind from ahead and from the right.
Flight in_shear(WindShear shear, double climb_rad, double height = 20) {
  SystemSwitches on = kNone;
  on.conversion = true;
  on.wind_shear = shear;
  SteadyFlight<double> flight = level(40);
  flight.climb = climb_rad;
  Flight f = begun(30, flight, on);
  f.c.around.wind_n = {-8, 3, 0.5};
  f.vehicle().ground = {f.s.state.position.z + height, 0, 0};
  return f;
}
Vec3<double> over_earth(const State<double>& x, const Vec3<double>& in_body) {
  return earth_to_body(EulerAngles<double>{x.roll, x.pitch, x.yaw}).apply_inverse(in_body);
}
Vec3<double> wind_of(const Flight& f, double down) {
  return wind_at(mean_wind(f.systems.vehicle, gust(), f.c.around.wind_n), down);
}

}  // namespace

TEST(wind_shear_logarithm_is_that_of_the_library) {
  for (double x = 1.1e-30; x < 1e30; x *= 1.37)
    CHECK_NEAR(logarithm(x), std::log(x), 4e-16 * std::max(1.0, std::fabs(std::log(x))));
  CHECK_EQ(logarithm(1.0), 0.0);
  for (const double no_height : {0.0, HUGE_VAL})
    CHECK(!(std::fabs(logarithm(no_height)) < 60));  // and it ends
  CHECK_NEAR(logarithm(3.0f), std::log(3.0f), 2e-7f);
  using D = Dual<double, 2>;
  for (const double x : {0.03, 0.8, 1.0, 1.4142, 7.0, 6000.0}) {
    const D y = logarithm(D::variable(x, 0));
    CHECK_REL(y.d.get(0), 1 / x, 1e-15);
    CHECK_EQ(y.d.get(1), 0.0);
  }
}

// ln(h/z0)/ln(20/z0) with h in ft, z0 0.15 and 2 ft as printed; constant below 3 and above 1000 ft.
TEST(wind_shear_is_the_profile_of_the_standard) {
  constexpr double ft = 0.3048;
  const struct {
    WindShear shear;
    double roughness_ft;
  } grounds[] = {{WindShear::terminal, 0.15}, {WindShear::other, 2.0}};
  for (const auto& ground : grounds) {
    const auto expected = [&ground](double h_ft) {
      return std::log(h_ft / ground.roughness_ft) / std::log(20 / ground.roughness_ft);
    };
    for (const double h : {3.5, 10.0, 20.0, 100.0, 900.0}) {
      const WindProfile<double> p = wind_profile(gust(), ground.shear, h * ft);
      CHECK_REL(p.share, expected(h), 1e-14);
      CHECK_REL(p.slope * h * ft, 1 / std::log(20 / ground.roughness_ft), 1e-14);
    }
    for (const double h : {-5.0, 0.0, 2.5}) {
      CHECK_REL(wind_profile(gust(), ground.shear, h * ft).share, expected(3), 1e-13);
      CHECK_EQ(wind_profile(gust(), ground.shear, h * ft).slope, 0.0);
    }
    for (const double h : {1001.0, 3000.0}) {
      CHECK_REL(wind_profile(gust(), ground.shear, h * ft).share, expected(1000), 1e-13);
      CHECK_NEAR(wind_profile(gust(), ground.shear, h * ft).slope, 0, 1e-18);
    }
  }
}

// The slope is that of the share, within the widths too.
TEST(wind_shear_slope_is_exact) {
  using D = Dual<double, 1>;
  const double lowest = gust().shear_lowest, highest = gust().shear_highest, width = gust().shear_width;
  for (const double h : {lowest - 0.3 * width, lowest, lowest + 0.4 * width, 3 * lowest,
                         highest - 0.2 * width, highest + 0.3 * width})
    for (const WindShear shear : {WindShear::terminal, WindShear::other}) {
      const WindProfile<D> p = wind_profile(gust(), shear, D::variable(h, 0));
      CHECK_NEAR(p.share.d.get(0), p.slope.v, 1e-13 / lowest);
    }
}

// Forces and accelerations over the ground know no wind: d(R v + W(h))/dt is the same with shear and without.
TEST(wind_shear_leaves_the_acceleration_over_the_ground) {
  for (const WindShear shear : {WindShear::terminal, WindShear::other})
    for (const double climb : {0.2, -0.1}) {
      Flight f = in_shear(shear, climb);
      f.s.state.rates = {0.1, -0.05, 0.07};
      f.s.state.roll = 0.3;
      f.s.state.yaw = 0.8;
      const State<double>& x = f.s.state;
      const Rates with_shear = rates(f);
      Flight plain = f;
      plain.vehicle().on.wind_shear = WindShear::none;
      const Rates without = rates(plain);
      const auto acceleration = [&x](const Rates& r) {
        return over_earth(x, r.airframe.rates.velocity + cross(x.rates, x.velocity));
      };
      // The wind at the aircraft changes by its way up and down, here by a difference along it.
      const double sinking = with_shear.of[kStateIndex.position.z], step = 1e-3;
      const Vec3<double> changes =
          (sinking / (2 * step)) * (wind_of(f, x.position.z + step) - wind_of(f, x.position.z - step));
      const Vec3<double> left = acceleration(with_shear) + changes - acceleration(without);
      CHECK_LT(length(left), 1e-6 * length(changes));
      CHECK_LT(0.01, length(changes));
      // And over the ground it is carried by the wind of its height.
      const Vec3<double> way = over_earth(x, x.velocity) + wind_of(f, x.position.z);
      CHECK_NEAR(with_shear.of[kStateIndex.position.x], way.x, 1e-12 * (1 + std::fabs(way.x)));
      CHECK_NEAR(with_shear.of[kStateIndex.position.y], way.y, 1e-12 * (1 + std::fabs(way.y)));
      CHECK_NEAR(with_shear.of[kStateIndex.position.z], way.z, 1e-12 * (1 + std::fabs(way.z)));
    }
}

// Climbing into a wind from ahead that grows the aircraft gains airspeed, against the same climb in an even wind.
TEST(wind_shear_from_ahead_lends_airspeed_to_a_climb) {
  const auto gained = [](WindShear shear) {
    Flight f = in_shear(shear, 0.1);
    f.c.around.wind_n = {-8, 0, 0};
    const double before = f.s.state.velocity.x;
    CHECK(fly(f, 100) == Status::ok);
    return f.s.state.velocity.x - before;
  };
  const double rise = 0.5 * 40 * std::sin(0.1),
               share = wind_profile(gust(), WindShear::terminal, 20 + rise).share -
                       wind_profile(gust(), WindShear::terminal, 20.0).share;
  CHECK_NEAR(gained(WindShear::terminal) - gained(WindShear::none), 8 * share, 0.15 * 8 * share);
}

// Without a ground there is no height to grow with.
TEST(wind_shear_needs_a_ground) {
  Flight f = in_shear(WindShear::terminal, 0.1);
  Flight plain = f;
  plain.vehicle().on.wind_shear = WindShear::none;
  f.vehicle().ground.down = plain.vehicle().ground.down = 1e9;
  CHECK(fly(f, 20) == Status::ok && fly(plain, 20) == Status::ok);
  CHECK(same_bits(f.s.state, plain.s.state));
}

// In steep flight a step turns the attitude another way: here against the rates of Euler angles by the test's own
// Runge-Kutta of order 4, through 72 deg of pitch.
TEST(wind_shear_in_steep_flight_is_that_of_euler_angles) {
  Flight f = in_shear(WindShear::other, 0.2);
  f.s.integrator = Integrator::rk4;
  f.s.state.pitch = 1.1;
  f.s.state.roll = 0.2;
  f.s.state.yaw = 0.8;
  f.s.state.rates = {0.05, 0.4, 0.1};
  constexpr int n = vehicle_state_count;
  double x[n], stage[n], sum[n];
  flatten(f.s.state, x);
  flatten(f.state(), x + state_count);
  const auto rate_at = [&f](const double* at) {
    Flight there = f;
    unflatten(at, there.s.state);
    unflatten(at + state_count, there.state());
    return rates(there);
  };
  const double h = 0.005;
  const int steps = 40;
  for (int step = 0; step < steps; ++step) {
    for (double& part : sum) part = 0;
    std::copy(x, x + n, stage);
    const double share[] = {0.5, 0.5, 1.0, 0.0}, weight[] = {1 / 6.0, 1 / 3.0, 1 / 3.0, 1 / 6.0};
    for (int k = 0; k < 4; ++k) {
      const Rates r = rate_at(stage);
      for (int i = 0; i < n; ++i) {
        sum[i] += weight[k] * r.of[i];
        stage[i] = x[i] + share[k] * h * r.of[i];
      }
    }
    for (int i = 0; i < n; ++i) x[i] += h * sum[i];
  }
  CHECK(fly(f, steps) == Status::ok);
  double flown_to[state_count];
  flatten(f.s.state, flown_to);
  for (int i = 0; i < state_count; ++i)
    CHECK_NEAR(flown_to[i], x[i], 1e-6 * vehicle_variable(i).facts().bend);
  CHECK_LT(1.15, f.s.state.pitch);
  CHECK_LT(0.1,
           std::fabs(wind_of(f, x[kStateIndex.position.z]).x - wind_of(f, 0).x));  // it has felt the shear
}

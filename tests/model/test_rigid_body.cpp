// Rigid body: NASA NESC check cases (NASA/TM-2015-218675, trajectories of simulation 4), conservation laws,
// the moment equations as a matrix, Euler kinematics from the turning of a rotation matrix.
#include "tiltrotor/model/rigid_body.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "check.hpp"
#include "flight_cases.hpp"
#include "settled_rotor.hpp"

using namespace tiltrotor;
using flight_cases::Generator;

namespace {

using V = Vec3<double>;

struct Body {
  V velocity, rates;
  double roll, pitch, yaw;
  V position;
};

Body plus(const Body& a, double h, const RigidBodyRates<double>& d) {
  return {a.velocity + h * d.velocity, a.rates + h * d.rates, a.roll + h * d.roll,
          a.pitch + h * d.pitch,       a.yaw + h * d.yaw,     a.position + h * d.position};
}

// Classical Runge-Kutta of fourth order; `loads(body, time)`.
template <class LoadsAt>
Body step(const MassProperties<double>& mass, const Body& b, double t, double h, LoadsAt&& loads) {
  const auto rates = [&](const Body& x, double time) {
    return rigid_body(mass, x.velocity, x.rates, x.roll, x.pitch, x.yaw, loads(x, time));
  };
  const RigidBodyRates<double> k1 = rates(b, t);
  const RigidBodyRates<double> k2 = rates(plus(b, h / 2, k1), t + h / 2);
  const RigidBodyRates<double> k3 = rates(plus(b, h / 2, k2), t + h / 2);
  const RigidBodyRates<double> k4 = rates(plus(b, h, k3), t + h);
  return plus(plus(plus(plus(b, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
}

// Body axes -> north east down, the three turns one after the other: yaw, then pitch, then roll.
V to_earth(const V& a, double roll, double pitch, double yaw) {
  const V after_roll{a.x, std::cos(roll) * a.y - std::sin(roll) * a.z,
                     std::sin(roll) * a.y + std::cos(roll) * a.z};
  const V after_pitch{std::cos(pitch) * after_roll.x + std::sin(pitch) * after_roll.z, after_roll.y,
                      -std::sin(pitch) * after_roll.x + std::cos(pitch) * after_roll.z};
  return {std::cos(yaw) * after_pitch.x - std::sin(yaw) * after_pitch.y,
          std::sin(yaw) * after_pitch.x + std::cos(yaw) * after_pitch.y, after_pitch.z};
}

V angular_momentum(const Inertia<double>& i, const V& w) {
  return {i.xx * w.x - i.xz * w.z, i.yy * w.y, i.zz * w.z - i.xz * w.x};
}

struct Point {
  double time, roll_rate, pitch_rate, yaw_rate;  // s, deg/s
};

// The brick of the check cases, slug and feet.
MassProperties<double> brick() {
  MassProperties<double> mass{};
  mass.mass = 0.155404754;
  mass.inertia = {0.00189422, 0.006211019, 0.007194665, 0};
  return mass;
}
Body tumbling() {
  return {{0, 0, 0}, {10 * kRadPerDeg<double>, 20 * kRadPerDeg<double>, 30 * kRadPerDeg<double>}, 0, 0, 0,
          {0, 0, 0}};
}

template <std::size_t N, class LoadsAt>
void check_body_rates(const Point (&points)[N], double tolerance, LoadsAt&& loads) {
  Body body = tumbling();
  // Angles are not part of the comparison; held at zero they cannot meet the singularity at 90 deg.
  const double h = 0.005;
  int steps = 0;
  for (const Point& p : points) {
    for (; steps * h < p.time - h / 2; ++steps) {
      body = step(brick(), body, steps * h, h, loads);
      body.roll = body.pitch = body.yaw = 0;
    }
    CHECK_NEAR(body.rates.x * kDegPerRad<double>, p.roll_rate, tolerance);
    CHECK_NEAR(body.rates.y * kDegPerRad<double>, p.pitch_rate, tolerance);
    CHECK_NEAR(body.rates.z * kDegPerRad<double>, p.yaw_rate, tolerance);
  }
}

}  // namespace

// Atmos_02_TumblingBrickNoDamping, simulation 4, columns bodyAngularRateWrtEi_deg_s.
TEST(rigid_body_nesc_tumbling_brick) {
  const Point points[] = {{5, -16.9394851494, 9.63193937745, 33.4066280795},
                          {10, -2.41890222177, -23.5525695195, 28.12859263},
                          {15, 18.4372543136, 2.38688029893, 34.3107056116},
                          {20, -5.42273467991, 22.7159305765, 28.6082817473},
                          {25, -15.1840887012, -13.6177995003, 32.4167961985},
                          {30, 12.6183907757, -17.3974747619, 31.1195888868}};
  check_body_rates(points, 1e-9, [](const Body&, double) { return Loads<double>{}; });
}

// Atmos_03_TumblingBrickDamping, simulation 4: C_lp = C_mq = C_nr = -1, falling from 30000 ft without drag.
// Airspeed and altitude of the fall follow the same file (159.977557353 ft/s at 5 s, 960.293064507 ft/s at 30
// s).
TEST(rigid_body_nesc_tumbling_brick_damped) {
  const Point points[] = {{5, -4.13498073581, 3.19020857135, 21.7249722576},
                          {10, -0.119673377375, -0.0458085531177, 8.42554174543},
                          {15, -1.88093430034e-4, -4.54040460094e-5, 1.57032268452},
                          {20, 0, 0, 0.121116213812}};
  const double b = (960.293064507 / 30 - 159.977557353 / 5) / 25;
  const double a = 159.977557353 / 5 - 5 * b;
  const double foot = 0.3048;
  const double slug_per_cubic_foot = 14.593903 / (foot * foot * foot);
  const auto loads = [&](const Body& x, double t) {
    const double speed = std::max(0.5, a * t + b * t * t);
    const double altitude = (30000 - a * t * t / 2 - b * t * t * t / 3) * foot;
    const double geopotential = altitude * 6356766 / (6356766 + altitude);
    const double density = standard_air(geopotential).density / slug_per_cubic_foot;
    // q S b C, C = -w b / (2 V)
    const auto damping = [&](double rate, double length) {
      return -0.25 * density * speed * 0.22222 * length * length * rate;
    };
    return Loads<double>{
        {0, 0, 0}, {damping(x.rates.x, 0.33333), damping(x.rates.y, 0.66667), damping(x.rates.z, 0.33333)}};
  };
  check_body_rates(points, 3e-3, loads);
}

// An aircraft-like body with a product of inertia, no forces: energy and the angular momentum in space stay.
TEST(rigid_body_torque_free_conservation) {
  MassProperties<double> mass{};
  mass.mass = 5900;
  mass.inertia = {71580, 28960, 89940, 1673};
  Body body{{0, 0, 0}, {0.3, -0.2, 0.25}, 0.2, -0.3, 0.5, {0, 0, 0}};
  const auto momentum = [&] {
    return to_earth(angular_momentum(mass.inertia, body.rates), body.roll, body.pitch, body.yaw);
  };
  const auto energy = [&] { return 0.5 * dot(body.rates, angular_momentum(mass.inertia, body.rates)); };
  const V h0 = momentum();
  const double e0 = energy();
  double change = 0;
  for (int k = 0; k < 800; ++k) {
    const V before = body.rates;
    body = step(mass, body, 0.005 * k, 0.005, [](const Body&, double) { return Loads<double>{}; });
    change += std::abs(body.rates.x - before.x);
  }
  CHECK_LT(0.05, change);  // the rates did move
  CHECK_REL(energy(), e0, 1e-11);
  const V h1 = momentum();
  const double size = std::sqrt(dot(h0, h0));
  CHECK_NEAR(h1.x, h0.x, 1e-9 * size);
  CHECK_NEAR(h1.y, h0.y, 1e-9 * size);
  CHECK_NEAR(h1.z, h0.z, 1e-9 * size);
}

// I w' = M - w x (I w) with the inertia as a full matrix (off-diagonal -Ixz), solved by elimination.
TEST(rigid_body_moment_equations_as_a_matrix) {
  NOTE("seed 41");
  Generator random(41);
  for (int n = 0; n < 100; ++n) {
    MassProperties<double> mass{};
    mass.mass = random.between(4000, 8000);
    mass.inertia = {random.between(4e4, 8e4), random.between(2e4, 4e4), random.between(6e4, 9e4),
                    random.between(-5e3, 5e3)};
    const V v{random.between(-50, 100), random.between(-20, 20), random.between(-20, 20)};
    const V w{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const V force{random.between(-1e4, 1e4), random.between(-1e4, 1e4), random.between(-1e5, 1e5)};
    const V moment{random.between(-1e4, 1e4), random.between(-1e4, 1e4), random.between(-1e4, 1e4)};
    const double roll = random.between(-1, 1);
    const double pitch = random.between(-1, 1);
    const double yaw = random.between(-3, 3);
    const RigidBodyRates<double> d = rigid_body(mass, v, w, roll, pitch, yaw, Loads<double>{force, moment});
    const Inertia<double>& i = mass.inertia;
    const V right = moment - cross(w, angular_momentum(i, w));
    const std::array<double, 3> expected = settled_rotor::solve<3>(
        {{{i.xx, 0, -i.xz}, {0, i.yy, 0}, {-i.xz, 0, i.zz}}}, {right.x, right.y, right.z});
    CHECK_NEAR(d.rates.x, expected[0], 1e-12);
    CHECK_NEAR(d.rates.y, expected[1], 1e-12);
    CHECK_NEAR(d.rates.z, expected[2], 1e-12);

    // Translation seen from space: d/dt (R v) = R F/m + g down, by a small turn of the frame.
    const double h = 1e-6;
    const V later = to_earth(v + h * d.velocity, roll + h * d.roll, pitch + h * d.pitch, yaw + h * d.yaw);
    const V earlier = to_earth(v - h * d.velocity, roll - h * d.roll, pitch - h * d.pitch, yaw - h * d.yaw);
    const V acceleration = (1 / (2 * h)) * (later - earlier);
    const V by_force = (1 / mass.mass) * to_earth(force, roll, pitch, yaw);
    CHECK_NEAR(acceleration.x, by_force.x, 1e-6);
    CHECK_NEAR(acceleration.y, by_force.y, 1e-6);
    CHECK_NEAR(acceleration.z, by_force.z + 9.80665, 1e-6);
    const V ground_speed = to_earth(v, roll, pitch, yaw);
    CHECK_NEAR(d.position.x, ground_speed.x, 1e-12);
    CHECK_NEAR(d.position.y, ground_speed.y, 1e-12);
    CHECK_NEAR(d.position.z, ground_speed.z, 1e-12);

    // Kinematics: a direction fixed in the body moves in space as w x a.
    const V a{0.3, -0.7, 0.4};
    const V moved = (1 / (2 * h)) * (to_earth(a, roll + h * d.roll, pitch + h * d.pitch, yaw + h * d.yaw) -
                                     to_earth(a, roll - h * d.roll, pitch - h * d.pitch, yaw - h * d.yaw));
    const V turning = to_earth(cross(w, a), roll, pitch, yaw);
    CHECK_NEAR(moved.x, turning.x, 1e-8);
    CHECK_NEAR(moved.y, turning.y, 1e-8);
    CHECK_NEAR(moved.z, turning.z, 1e-8);
  }
}

TEST(rigid_body_level_at_rest) {
  MassProperties<double> mass{};
  mass.mass = 100;
  mass.inertia = {10, 20, 30, 1};
  // Weight balanced by a lift of m g: nothing moves.
  const RigidBodyRates<double> d =
      rigid_body(mass, V{0, 0, 0}, V{0, 0, 0}, 0.0, 0.0, 0.0, Loads<double>{{0, 0, -980.665}, {0, 0, 0}});
  CHECK_EQ(d.velocity.z, 0.0);
  // Nose up: gravity pulls backwards; right wing down: to the right.
  CHECK_NEAR(rigid_body(mass, V{0, 0, 0}, V{0, 0, 0}, 0.0, 0.1, 0.0, Loads<double>{}).velocity.x,
             -9.80665 * std::sin(0.1), 1e-14);
  CHECK_NEAR(rigid_body(mass, V{0, 0, 0}, V{0, 0, 0}, 0.1, 0.0, 0.0, Loads<double>{}).velocity.y,
             9.80665 * std::sin(0.1), 1e-14);
}

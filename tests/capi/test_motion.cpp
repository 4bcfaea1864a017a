// Mass, and motion of a station.
// Expected: rotations multiplied from elementary ones, differences along the flight (the path f(x) of the state,
// followed a little way both ways), Newton's law, the geometry of swinging nacelles.
#include <array>
#include <cmath>

#include "capi/flying.hpp"

using namespace capi;

namespace {

constexpr bool kDouble = sizeof(tr_real) == 8;
using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;

template <class Numbers>
Vector vector_of(const Numbers& x) {
  return {double(x[0]), double(x[1]), double(x[2])};
}
Vector times(const Matrix& m, const Vector& v) {
  Vector r{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) r[i] += m[i][k] * v[k];
  return r;
}
Matrix times(const Matrix& a, const Matrix& b) {
  Matrix r{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) r[i][j] += a[i][k] * b[k][j];
  return r;
}
// Earth's axes to those of the body: heading, then pitch, then bank.
Matrix earth_to_body(double roll, double pitch, double yaw) {
  const Matrix x = {{{1, 0, 0}, {0, std::cos(roll), std::sin(roll)}, {0, -std::sin(roll), std::cos(roll)}}};
  const Matrix y = {
      {{std::cos(pitch), 0, -std::sin(pitch)}, {0, 1, 0}, {std::sin(pitch), 0, std::cos(pitch)}}};
  const Matrix z = {{{std::cos(yaw), std::sin(yaw), 0}, {-std::sin(yaw), std::cos(yaw), 0}, {0, 0, 1}}};
  return times(x, times(y, z));
}
// The same of a unit quaternion, by its definition: v' = q* v q.
Matrix matrix_of(const tr_real (&q)[4]) {
  const double s = double(q[0]), x = double(q[1]), y = double(q[2]), z = double(q[3]);
  return {{{s * s + x * x - y * y - z * z, 2 * (x * y + s * z), 2 * (x * z - s * y)},
           {2 * (x * y - s * z), s * s - x * x + y * y - z * z, 2 * (y * z + s * x)},
           {2 * (x * z + s * y), 2 * (y * z - s * x), s * s - x * x - y * y + z * z}}};
}
Vector difference(const Vector& a, const Vector& b, double part = 1) {
  return {part * (a[0] - b[0]), part * (a[1] - b[1]), part * (a[2] - b[2])};
}
double distance(const Vector& a, const Vector& b) {
  const Vector d = difference(a, b);
  return std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
}

tr_motion motion_of(const tr_sim& sim, const tr_real (&station)[3]) {
  tr_motion m;
  CHECK_EQ(tr_motion_at(&sim, station, &m), TR_OK);
  return m;
}
tr_mass mass_of(const tr_sim& sim) {
  tr_mass m;
  CHECK_EQ(tr_get_mass(&sim, &m), TR_OK);
  return m;
}

// Turning, banked, off its trim, in a gust.
tr_sim unsteady(tr_real mast_deg) {
  tr_sim sim = trimmed_sim(mast_deg, mast_deg < 90 ? tr_real(35) : tr_real(95));
  tr_state s = state_of(sim);
  const tr_real rates[] = {tr_real(0.4), tr_real(-0.3), tr_real(0.5)};
  for (int k = 0; k < 3; ++k) s.x[TR_P + k] = rates[k];
  s.x[TR_ROLL] = s.roll_rad = tr_real(-0.75);
  s.x[TR_PITCH] += tr_real(0.25);
  s.x[TR_YAW] = s.yaw_rad = tr_real(2.5);
  s.x[TR_V] = 7;
  const tr_real place[] = {tr_real(120), tr_real(-45), tr_real(-300)};
  for (int k = 0; k < 3; ++k) s.x[TR_NORTH + k] = s.position_m[k] = place[k];
  const tr_real gust[] = {3, -2, tr_real(1.5)};
  for (int k = 0; k < 3; ++k) s.u[TR_GUST_U + k] = gust[k];
  CHECK_EQ(tr_set_state(&sim, &s), TR_OK);
  return sim;
}

// The aircraft `time` further along the tangent of its flight.
tr_sim along_the_flight(tr_sim sim, double time) {
  tr_state s = state_of(sim);
  tr_real rates[TR_STATES];
  CHECK_EQ(tr_derivative(&sim, rates, TR_STATES), TR_OK);
  for (int i = 0; i < TR_STATES; ++i) s.x[i] += tr_real(time * double(rates[i]));
  CHECK_EQ(tr_set_state(&sim, &s), TR_OK);
  return sim;
}

constexpr tr_real kStations[][3] = {
    {tr_real(7.6), 0, 2}, {tr_real(4.2), tr_real(-0.5), tr_real(1.1)}, {tr_real(14.1), 2, tr_real(3.3)}};

}  // namespace

TEST(capi_motion_of_the_centre_of_gravity_is_the_state) {
  for (const tr_real mast : {tr_real(0), tr_real(30), tr_real(90)}) {
    const tr_sim sim = unsteady(mast);
    const tr_state s = state_of(sim);
    const tr_mass mass = mass_of(sim);
    const tr_motion m = motion_of(sim, mass.cg_m);
    tr_outputs o;
    tr_real rates[TR_STATES];
    CHECK_EQ(tr_get_outputs(&sim, &o), TR_OK);
    CHECK_EQ(tr_derivative(&sim, rates, TR_STATES), TR_OK);
    const double tolerance = kDouble ? 1e-13 : 1e-5;
    for (int k = 0; k < 3; ++k) {
      CHECK_EQ(m.position_m[k], s.x[TR_NORTH + k]);
      CHECK_EQ(m.velocity_air_mps[k], s.x[TR_U + k] - s.u[TR_GUST_U + k]);
      CHECK_NEAR(m.velocity_ned_mps[k], rates[TR_NORTH + k], 100 * tolerance);
      CHECK_EQ(m.specific_force_mps2[k], o.specific_force_mps2[k]);
      CHECK_EQ(m.rates_radps[k], s.x[TR_P + k]);
      CHECK_EQ(m.acceleration_radps2[k], rates[TR_P + k]);
    }
    // What is left of Newton's law: v' + omega x v is the force and the weight.
    const Matrix to_body = earth_to_body(s.x[TR_ROLL], s.x[TR_PITCH], s.x[TR_YAW]);
    const Vector w = vector_of(s.x + TR_P), v = vector_of(s.x + TR_U);
    const Vector weight = times(to_body, Vector{0, 0, 9.80665});
    const Vector turning = {w[1] * v[2] - w[2] * v[1], w[2] * v[0] - w[0] * v[2], w[0] * v[1] - w[1] * v[0]};
    for (std::size_t k = 0; k < 3; ++k)
      CHECK_NEAR(m.specific_force_mps2[k], double(rates[TR_U + k]) + turning[k] - weight[k], 100 * tolerance);
  }
}

TEST(capi_motion_of_a_station_follows_the_flight) {
  double worst_velocity = 0, worst_force = 0;
  const double h = kDouble ? 1e-5 : 4e-3;
  for (const tr_real mast : {tr_real(0), tr_real(30), tr_real(90)}) {
    const tr_sim sim = unsteady(mast);
    const tr_sim ahead = along_the_flight(sim, h), behind = along_the_flight(sim, -h);
    const tr_state s = state_of(sim);
    const Matrix to_body = earth_to_body(s.x[TR_ROLL], s.x[TR_PITCH], s.x[TR_YAW]);
    for (const auto& station : kStations) {
      const tr_motion now = motion_of(sim, station);
      const tr_motion then = motion_of(ahead, station), before = motion_of(behind, station);
      // Velocity is the rate of position, specific force that of velocity without gravity.
      const Vector velocity =
          difference(vector_of(then.position_m), vector_of(before.position_m), 1 / (2 * h));
      Vector force =
          difference(vector_of(then.velocity_ned_mps), vector_of(before.velocity_ned_mps), 1 / (2 * h));
      force[2] -= 9.80665;
      worst_velocity = std::max(worst_velocity, distance(velocity, vector_of(now.velocity_ned_mps)));
      worst_force =
          std::max(worst_force, distance(times(to_body, force), vector_of(now.specific_force_mps2)));
      // The same velocity in body axes, and the air's taken off.
      Vector relative = times(to_body, vector_of(now.velocity_ned_mps));
      for (std::size_t k = 0; k < 3; ++k) relative[k] -= double(s.u[TR_GUST_U + k]);
      CHECK_LE(distance(relative, vector_of(now.velocity_air_mps)), kDouble ? 1e-12 : 1e-4);
    }
  }
  NOTE("velocity " << worst_velocity << " m/s, specific force " << worst_force << " m/s^2");
  CHECK_LE(worst_velocity, kDouble ? 1e-7 : 0.02);
  CHECK_LE(worst_force, kDouble ? 1e-7 : 0.05);
}

// Stations count aft, right and up: where a point lies that is 2 m ahead, 3 m to the right and 1 m above the CG.
TEST(capi_motion_at_a_station_ahead_right_and_above) {
  tr_sim sim = trimmed_sim(0, 20);
  tr_state s = state_of(sim);
  s.x[TR_ROLL] = 0, s.roll_rad = 0;
  s.x[TR_PITCH] = 0;
  s.x[TR_YAW] = tr_real(1.5707963267948966), s.yaw_rad = double(s.x[TR_YAW]);  // to the east
  s.x[TR_R] = tr_real(0.5);
  CHECK_EQ(tr_set_state(&sim, &s), TR_OK);
  const tr_mass mass = mass_of(sim);
  const tr_real station[3] = {mass.cg_m[0] - 2, mass.cg_m[1] + 3, mass.cg_m[2] + 1};
  const tr_motion m = motion_of(sim, station);
  const double expected[3] = {double(s.x[TR_NORTH]) - 3, double(s.x[TR_EAST]) + 2, double(s.x[TR_DOWN]) - 1};
  for (int k = 0; k < 3; ++k) CHECK_NEAR(m.position_m[k], expected[k], kDouble ? 1e-13 : 1e-5);
  CHECK_NEAR(m.velocity_air_mps[0], double(s.x[TR_U]) - 1.5, kDouble ? 1e-13 : 1e-5);
  CHECK_NEAR(m.velocity_air_mps[1], double(s.x[TR_V]) + 1.0, kDouble ? 1e-13 : 1e-5);
}

TEST(capi_motion_quaternion_is_the_attitude) {
  tr_sim sim = trimmed_sim(0, 20);
  double worst = 0;
  for (int k = 0; k < 300; ++k) {
    tr_state s = state_of(sim);
    s.x[TR_ROLL] = tr_real(k % 17 - 8) * tr_real(0.9);
    s.x[TR_PITCH] = tr_real(k % 13 - 6) * tr_real(0.25);
    s.x[TR_YAW] = tr_real(k % 19 - 9) * tr_real(0.85);
    s.roll_rad = double(s.x[TR_ROLL]);
    s.yaw_rad = double(s.x[TR_YAW]);
    CHECK_EQ(tr_set_state(&sim, &s), TR_OK);
    const tr_motion m = motion_of(sim, kStations[0]);
    const Matrix expected = earth_to_body(s.x[TR_ROLL], s.x[TR_PITCH], s.x[TR_YAW]);
    const Matrix found = matrix_of(m.quaternion);
    for (std::size_t i = 0; i < 3; ++i) worst = std::max(worst, distance(expected[i], found[i]));
    CHECK_LE(0, m.quaternion[0]);
  }
  NOTE("largest difference of a direction " << worst);
  CHECK_LE(worst, kDouble ? 3e-15 : 2e-6);
}

// The centre of gravity moves on an arc about a fixed point as the nacelles turn, and turns with them; mass and
// the CG at mast 0 are those of the setup.
TEST(capi_mass_follows_the_mast) {
  const double degree = 0.017453292519943295;
  std::vector<tr_mass> at;
  const tr_real station = setup_at(0).cg_station_m - tr_real(0.05);
  for (int mast = 0; mast <= 90; mast += 15) {
    tr_setup setup = setup_at(tr_real(mast));
    setup.mass_kg *= tr_real(0.9);
    setup.cg_station_m = station;
    tr_sim sim;
    CHECK_EQ(tr_init(&sim, TR_API_VERSION, &setup), TR_OK);
    at.push_back(mass_of(sim));
    CHECK_EQ(at.back().mass_kg, setup.mass_kg);
    CHECK_EQ(at.back().cg_m[1], 0);
  }
  CHECK_NEAR(at[0].cg_m[0], station, kDouble ? 1e-14 : 1e-6);
  // Chords of an arc: their length is that of half the angle between, their direction turns by half the mast angle.
  const double full =
      std::hypot(double(at[6].cg_m[0] - at[0].cg_m[0]), double(at[6].cg_m[2] - at[0].cg_m[2]));
  CHECK_LT(0.01, full);
  const double direction =
      std::atan2(double(at[6].cg_m[2] - at[0].cg_m[2]), double(at[6].cg_m[0] - at[0].cg_m[0]));
  for (std::size_t k = 1; k < at.size(); ++k) {
    const double x = double(at[k].cg_m[0] - at[0].cg_m[0]), z = double(at[k].cg_m[2] - at[0].cg_m[2]);
    const double half = 0.5 * 15 * double(k) * degree;
    CHECK_NEAR(std::hypot(x, z), full * std::sin(half) / std::sin(45 * degree), kDouble ? 1e-13 : 1e-5);
    CHECK_NEAR(std::remainder(std::atan2(z, x) - direction + (45 * degree - half), 6.283185307179586), 0,
               kDouble ? 1e-12 : 1e-4);
  }
  // Moments of a body: none is more than the sum of the others.
  for (const tr_mass& m : at) {
    const tr_real* i = m.inertia_kgm2;
    CHECK(i[0] < i[1] + i[2] && i[1] < i[0] + i[2] && i[2] < i[0] + i[1]);
    CHECK_LT(i[3] * i[3], i[0] * i[2]);
  }
}

// Printed: NASA CR-166537 (CG), CR-166536A (inertia in slug ft^2, with its slope per degree of mast angle).
TEST_OF_XV15(capi_mass_is_that_of_the_source) {
  const double slug_ft2 = 1.3558179483314;
  for (const int mast : {0, 40, 90}) {
    const tr_mass m = mass_of(sim_at(tr_real(mast)));
    CHECK_NEAR(m.mass_kg, 13000 * 0.45359237, 1e-3);
    const double at_0[4] = {52795, 21360, 66335, 1234}, slope[4] = {-20.5, -11.24, 9.26, -1.76};
    for (int k = 0; k < 4; ++k)
      CHECK_REL(double(m.inertia_kgm2[k]) / slug_ft2, at_0[k] + mast * slope[k], 1e-5);
    if (mast > 0) continue;
    CHECK_NEAR(m.cg_m[0], 301.2 * 0.0254, 1e-5);
    CHECK_NEAR(m.cg_m[2], 81.65 * 0.0254, 1e-5);
  }
}

TEST(capi_motion_refuses) {
  const tr_sim sim = trimmed_sim(0, 20);
  tr_motion motion;
  std::memset(&motion, 0x5a, sizeof motion);
  const tr_motion motion_before = motion;
  tr_mass mass;
  std::memset(&mass, 0x5a, sizeof mass);
  const tr_mass mass_before = mass;
  CHECK_EQ(tr_motion_at(nullptr, kStations[0], &motion), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_motion_at(&sim, nullptr, &motion), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_motion_at(&sim, kStations[0], nullptr), TR_BAD_ARGUMENT);
  for (int k = 0; k < 3; ++k) {
    tr_real station[3] = {7, 0, 2};
    for (const tr_real bad : {kNan, kInfinity, -kInfinity}) {
      station[k] = bad;
      CHECK_EQ(tr_motion_at(&sim, station, &motion), TR_NOT_FINITE);
    }
    for (const tr_real far : {tr_real(1001), tr_real(-1e30)}) {
      station[k] = far;
      CHECK_EQ(tr_motion_at(&sim, station, &motion), TR_OUT_OF_RANGE);
    }
  }
  CHECK_EQ(tr_get_mass(nullptr, &mass), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_get_mass(&sim, nullptr), TR_BAD_ARGUMENT);
  tr_sim raw;
  std::memset(&raw, 0xff, sizeof raw);
  CHECK_EQ(tr_motion_at(&raw, kStations[0], &motion), TR_NOT_INITIALIZED);
  CHECK_EQ(tr_get_mass(&raw, &mass), TR_NOT_INITIALIZED);
  CHECK(same_bits(motion, motion_before) && same_bits(mass, mass_before));
}

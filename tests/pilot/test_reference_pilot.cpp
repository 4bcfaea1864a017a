// The reference pilot around the aircraft's own linear models.
// Expected: every eigenvalue of the closed loop, sampled as the pilot acts, inside the unit circle; steps of what he is
// told settle where they were told; the law of a steady turn.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "pilot/linear_flight.hpp"
#include "tiltrotor/math/algebra/eigen.hpp"
#include "tiltrotor/model/rigid_body.hpp"

using namespace pilot_case;

namespace {

// Everything that a step carries on, as numbers. North and east count only where they are held.
constexpr int kMemory = 13, kMost = kMaxLinearStates + kSpace + kMemory;
template <class Visit>
int each_number(Flown& f, PilotMemory& m, int states, bool with_position, Visit&& visit) {
  int count = 0;
  const auto next = [&](double& x) { visit(count++, x); };
  for (int i = 0; i < states; ++i) next(f.x[i]);
  next(f.yaw), next(f.height);
  for (double& x : f.lever) next(x);
  if (with_position) next(f.north), next(f.east);
  for (double* const x :
       {&m.speed, &m.acceleration, &m.height, &m.climb, &m.climb_rate, &m.heading, &m.turn_rate, &m.forward,
        &m.upward, &m.sideward, &m.turning, &m.long_stick, &m.lat_stick})
    next(*x);
  return count;
}

// Eigenvalue with the largest magnitude of one step about the trim, as a growth rate per second.
double largest_growth(const LinearFlight& flight, double& frequency) {
  static Matrix<double, kMost, kMost> map;
  static EigenWorkspace<double, kMost> work;
  static Eigenvalues<double, kMost> values;
  set_zero(map);
  PilotMemory begun{};
  Flown rest = flight.at_rest();
  flight.step(rest, begun);
  const bool position = flight.aims.holds_position;
  const int n = each_number(rest, begun, flight.model.states, position, [](int, double&) {});
  constexpr double h = 1e-5;
  for (int j = 0; j < n; ++j) {
    for (const double sign : {1.0, -1.0}) {
      Flown f = flight.at_rest();
      PilotMemory m = begun;
      each_number(f, m, flight.model.states, position, [&](int i, double& x) { x += i == j ? sign * h : 0; });
      flight.step(f, m);
      each_number(f, m, flight.model.states, position,
                  [&](int i, double& x) { map(i, j) += sign * x / (2 * h); });
    }
  }
  CHECK(eigenvalues(map, n, work, values) == Status::ok);
  double most = -1e9;
  for (int i = 0; i < n; ++i) {
    const double size = std::hypot(values.real[i], values.imag[i]);
    if (std::log(size) / kDt < most) continue;
    most = std::log(size) / kDt;
    frequency = std::atan2(values.imag[i], values.real[i]) / kDt;
  }
  return most;
}

}  // namespace

TEST(pilot_closes_stable_loops_around_every_condition) {
  for (const bool is_augmented : {true, false}) {
    for (const Condition& condition : kConditions) {
      LinearFlight flight(condition, is_augmented);
      for (const double lag : {0.02, 0.15}) {
        for (const bool holds_position : {false, true}) {
          if (holds_position && condition.speed > 0) continue;
          flight.lag = lag;
          flight.aims.holds_position = holds_position;
          double frequency = 0;
          const double growth = largest_growth(flight, frequency);
          if (!CHECK_LT(growth, -0.02))
            NOTE(condition << (is_augmented ? ", augmented" : "") << (holds_position ? ", position held" : "")
                           << ", lag " << lag << " s: " << growth << " 1/s at " << frequency << " rad/s");
        }
      }
    }
  }
}

namespace {

// The largest and the last of a signal, in parts of a step that was told.
struct Way {
  double most = 0, last = 0;
  void add(double part) { last = part, most = std::max(most, part); }
};

// Flies for so long; visit(what he sees).
template <class Visit>
void fly(const LinearFlight& flight, double duration, Flown& f, PilotMemory& m, Visit&& visit) {
  for (int k = 0; k < duration / kDt; ++k) {
    flight.step(f, m);
    visit(flight.see(f));
  }
}

}  // namespace

TEST(pilot_reaches_height_and_speed_without_losing_the_other) {
  for (const Condition& condition : kConditions) {
    LinearFlight flight(condition, true);
    const double speed = flight.gains.speed;
    Way height, faster;
    double off_speed = 0, off_height = 0;
    Flown f = flight.at_rest();
    PilotMemory m{};
    flight.aims.height = flight.height + 10;
    fly(flight, 30, f, m, [&](const PilotSees& s) {
      height.add((s.height - flight.height) / 10);
      off_speed = std::max(off_speed, std::fabs(s.airspeed - speed));
    });
    flight.aims.speed = speed + 5;
    fly(flight, 40, f, m, [&](const PilotSees& s) {
      faster.add((s.airspeed - speed) / 5);
      off_height = std::max(off_height, std::fabs(s.height - flight.height - 10));
    });
    bool holds = CHECK_NEAR(height.last, 1, 0.02) & CHECK_NEAR(faster.last, 1, 0.02);
    holds = holds & CHECK_LT(height.most, 1.05) & CHECK_LT(faster.most, 1.17);
    holds = holds & CHECK_LT(off_speed, 0.5) & CHECK_LT(off_height, 2.5);
    if (!holds)
      NOTE(condition << ": height " << height.last << ", most " << height.most << ", speed off " << off_speed
                     << " m/s; speed " << faster.last << ", most " << faster.most << ", height off "
                     << off_height << " m");
  }
}

// A steady turn: tan(bank) = V psidot / g, without sideslip.
TEST(pilot_turns_with_the_bank_of_the_turn) {
  for (const Condition& condition : kConditions) {
    LinearFlight flight(condition, true);
    flight.aims.lateral = Lateral::turn;
    const double told =
        std::min(3 * kDeg, kGravity<double> * std::tan(15 * kDeg) / std::fmax(flight.gains.speed, 1));
    flight.aims.turn_rate = told;
    Flown f = flight.at_rest();
    PilotMemory m{};
    PilotSees s{};
    fly(flight, 60, f, m, [&](const PilotSees& seen) { s = seen; });
    const double turn = (s.rates.y * std::sin(s.roll) + s.rates.z * std::cos(s.roll)) / std::cos(s.pitch);
    bool holds = CHECK_NEAR(turn, told, 0.02 * told) & CHECK_NEAR(s.height, flight.height, 1);
    // The linear model has tan(bank) = bank, and side forces of pedal and yaw rate.
    if (condition.speed >= 40)
      holds = holds & CHECK_NEAR(s.roll, s.airspeed * turn / kGravity<double>, 2.5 * kDeg) &
              CHECK_NEAR(s.side_airspeed, 0, 0.5);
    if (!holds) NOTE(condition);
  }
}

TEST(pilot_comes_to_a_heading_the_short_way_and_to_a_track) {
  for (const Condition& condition : kConditions) {
    LinearFlight flight(condition, true);
    flight.aims.heading = 350 * kDeg;
    Flown f = flight.at_rest();
    PilotMemory m{};
    double most = 0, bank = 0;
    fly(flight, 40, f, m, [&](const PilotSees& s) {
      most = std::max(most, s.yaw);
      bank = std::max(bank, std::fabs(s.roll));
    });
    bool holds =
        CHECK_NEAR(f.yaw, -10 * kDeg, 0.5 * kDeg) & CHECK_LT(most, 2 * kDeg) & CHECK_LT(bank, 30 * kDeg);
    if (condition.speed >= 20) {
      flight.aims.lateral = Lateral::track;
      flight.aims.track = 0;
      flight.aims.east = f.east + 30;
      fly(flight, 90, f, m, [](const PilotSees&) {});
      holds = holds & CHECK_NEAR(f.east, flight.aims.east, 2) & CHECK_NEAR(f.yaw, 0, 1 * kDeg);
    }
    if (!holds) NOTE(condition << ": yaw " << f.yaw / kDeg << ", bank " << bank / kDeg << " deg");
  }
}

TEST(pilot_hovers_over_a_place) {
  LinearFlight flight({0, 0}, true);
  flight.aims.holds_position = true;
  flight.aims.north = 20;
  flight.aims.east = -10;
  Flown f = flight.at_rest();
  PilotMemory m{};
  fly(flight, 60, f, m, [](const PilotSees&) {});
  CHECK_NEAR(f.north, 20, 0.2);
  CHECK_NEAR(f.east, -10, 0.2);
  CHECK_NEAR(f.height, flight.height, 0.2);
  CHECK_NEAR(f.yaw, 0, 0.2 * kDeg);
}

// Half a degree of collective to climb with where two are needed: what is held meanwhile is not paid back later.
TEST(pilot_integrals_wait_at_the_end_of_a_lever) {
  LinearFlight flight({0, 0}, true);
  flight.reach.high.collective = flight.gains.collective + 0.5 * kDeg;
  flight.aims.vertical = Vertical::climb;
  flight.aims.climb = 4;
  Flown f = flight.at_rest();
  PilotMemory m{};
  double climb = 0;
  fly(flight, 60, f, m, [&](const PilotSees& s) {
    climb = -s.ground_velocity.z;
    CHECK_LE(m.last.collective, flight.reach.high.collective);
  });
  CHECK_LT(0.2, climb);
  CHECK_LT(climb, 3.5);
  flight.aims.climb = 0;
  fly(flight, 8, f, m, [&](const PilotSees& s) { climb = -s.ground_velocity.z; });
  CHECK_NEAR(climb, 0, 0.2);
}

// Random, violent wishes: hands stay within travel and rate, and answers are the same to the same question.
TEST(pilot_moves_hands_within_travel_and_rate) {
  std::mt19937 random(1);
  const auto anything = [&](double size) {
    return std::uniform_real_distribution<double>(-size, size)(random);
  };
  LinearFlight flight({30, 60}, true);
  const PilotReach& r = flight.reach;
  PilotMemory m{};
  PilotOutput before{};
  int count = 0;
  NOTE("seed 1");
  for (int k = 0; k < 2000; ++k) {
    PilotSees s = flight.see(flight.at_rest());
    s.airspeed += anything(60), s.height += anything(100), s.pitch += anything(1), s.roll += anything(1);
    s.rates = {anything(1), anything(1), anything(1)};
    s.ground_velocity.z = anything(20);
    flight.aims.lateral = static_cast<Lateral>(k % 4);
    flight.aims.vertical = static_cast<Vertical>(k % 3);
    PilotMemory copy = m;
    const Thrust thrust = k % 2 == 0 ? Thrust::collective : Thrust::throttle;
    const PilotOutput o = reference_pilot(flight.aims, s, flight.gains, thrust, r, kDt, m);
    const PilotOutput again = reference_pilot(flight.aims, s, flight.gains, thrust, r, kDt, copy);
    CHECK(std::memcmp(&o, &again, sizeof o) == 0 && std::memcmp(&m, &copy, sizeof m) == 0);
    const double PilotOutput::*hands[] = {&PilotOutput::collective, &PilotOutput::long_stick,
                                          &PilotOutput::lat_stick, &PilotOutput::pedal,
                                          &PilotOutput::throttle};
    for (const auto hand : hands) {
      CHECK_LE(r.low.*hand, o.*hand);
      CHECK_LE(o.*hand, r.high.*hand);
      if (k > 0) CHECK_LE(std::fabs(o.*hand - before.*hand), r.rate.*hand * kDt * (1 + 1e-9));
      count += k > 0 && o.*hand != before.*hand ? 1 : 0;
    }
    before = o;
  }
  CHECK_LT(1000, count);
}

#include "study/sideward_flight.hpp"

#include <algorithm>
#include <cmath>

#include "study/linear_models.hpp"
#include "study/missing.hpp"

namespace tiltrotor::study {

namespace {

constexpr int kStages = 5;       // of speed, each from the one before
constexpr int kIterations = 12;  // of a stage
constexpr double kAtRest = 1e-9;

struct Track {
  double north, east;  // m/s; the nose points north
};

Vec3<double> velocity_of(const Track& t, double roll, double pitch) {
  const double down = t.north * std::sin(pitch);
  return {t.north * std::cos(pitch), down * std::sin(roll) + t.east * std::cos(roll),
          down * std::cos(roll) - t.east * std::sin(roll)};
}

// Its derivatives by the angles.
Vec3<double> by_roll(const Vec3<double>& velocity) { return {0, velocity.z, -velocity.y}; }
Vec3<double> by_pitch(const Track& t, double roll, double pitch) {
  return {-t.north * std::sin(pitch), t.north * std::cos(pitch) * std::sin(roll),
          t.north * std::cos(pitch) * std::cos(roll)};
}

// Row and column of a rigid-body state, which stand first in a linear model.
constexpr int place(int state) {
  int i = 0;
  while (kRigidOrder[i] != state) ++i;
  return i;
}
constexpr int kU = place(kStateIndex.velocity.x);
constexpr int kV = place(kStateIndex.velocity.y);
constexpr int kW = place(kStateIndex.velocity.z);
constexpr int kRoll = place(kStateIndex.roll);
constexpr int kPitch = place(kStateIndex.pitch);

// Unknowns in their order: roll, pitch, states of rotors and wash, inceptors. The velocity follows from the
// angles, angular rates are zero.
template <class Visit>
void each_unknown(const Linear& m, SidewardFlight& f, Visit&& visit) {
  double x[state_count];
  double u[control_count];
  flatten(f.state, x);
  flatten(f.controls, u);
  visit(x[kStateIndex.roll]);
  visit(x[kStateIndex.pitch]);
  for (int j = kRigidStates; j < m.states; ++j) visit(x[m.state[j]]);
  for (int j = 0; j < m.controls; ++j) visit(u[m.control[j]]);
  unflatten(x, f.state);
  unflatten(u, f.controls);
}

// One step: the equations are the rates of every state but the two angles. Gives the largest rate before it;
// NaN when the equations are singular.
double newton_step(const Configured& c, const Track& track, SidewardFlight& f) {
  f.state.velocity = velocity_of(track, f.state.roll, f.state.pitch);
  f.state.rates = {};
  const Linear m = linear_model(c, f.state, f.controls, kInceptors);
  const Vec3<double> roll = by_roll(f.state.velocity);
  const Vec3<double> pitch = by_pitch(track, f.state.roll, f.state.pitch);
  Matrix<double, kMaxLinearStates, kMaxLinearStates> equations{};
  Matrix<double, kMaxLinearStates, 1> rates{};
  int row = 0;
  double largest = 0;
  for (int i = 0; i < m.states; ++i) {
    if (i == kRoll || i == kPitch) continue;
    const auto turned = [&](int angle, const Vec3<double>& by) {
      return m.a(i, angle) + m.a(i, kU) * by.x + m.a(i, kV) * by.y + m.a(i, kW) * by.z;
    };
    int column = 0;
    equations(row, column++) = turned(kRoll, roll);
    equations(row, column++) = turned(kPitch, pitch);
    for (int j = kRigidStates; j < m.states; ++j) equations(row, column++) = m.a(i, j);
    for (int j = 0; j < m.controls; ++j) equations(row, column++) = m.b(i, j);
    rates(row++, 0) = m.rates[i];
    largest = std::max(largest, std::fabs(m.rates[i]));
  }
  LU<double, kMaxLinearStates> lu;
  Matrix<double, kMaxLinearStates, 1> change;
  if (lu_factor(equations, row, lu) != Status::ok || lu_solve(lu, rates, 1, change) != Status::ok)
    return kMissing;
  int k = 0;
  each_unknown(m, f, [&](double& unknown) { unknown -= change(k++, 0); });
  return largest;
}

}  // namespace

SidewardFlight sideward_flight(const Configured& c, double speed_mps, double track_rad) {
  const Trimmed hover = trimmed_persistently(c, 0);
  SidewardFlight f{is_trimmed(hover.status), hover.state, hover.controls};
  for (int stage = 1; stage <= kStages && f.found; ++stage) {
    const double speed = speed_mps * stage / kStages;
    const Track track{speed * std::cos(track_rad), speed * std::sin(track_rad)};
    double rate = HUGE_VAL;
    for (int k = 0; k < kIterations && rate > kAtRest; ++k) rate = newton_step(c, track, f);
    f.found = rate <= kAtRest;
  }
  return f;
}

double travel_used(const Configured& c, const Controls<double>& u) {
  const ControlTables<double>& travel = c.aircraft->controls;
  return std::max({std::fabs(u.long_stick) / travel.long_travel, std::fabs(u.lat_stick) / travel.lat_travel,
                   std::fabs(u.pedal) / travel.pedal_travel});
}

}  // namespace tiltrotor::study

#include "study/sideward_flight.hpp"

#include <algorithm>
#include <cmath>

#include "study/linear_models.hpp"
#include "study/missing.hpp"

namespace tiltrotor::study {

namespace {

constexpr int kStages = 5;        // at least: of speed or azimuth, each from the one before
constexpr double kSpeedStep = 4;  // largest of a stage, m/s
constexpr double kAzimuthStep = 10 * kRadPerDeg<double>;
constexpr int kIterations = 12;  // of a stage
constexpr double kAtRest = 1e-9;

// Derivatives of a vector fixed to axes level with the ground by the angles.
Vec3<double> by_roll(const Vec3<double>& in_body) { return {0, in_body.z, -in_body.y}; }
Vec3<double> by_pitch(const Vec3<double>& in_body, double roll) {
  const double down = in_body.y * std::sin(roll) + in_body.z * std::cos(roll);
  return {-down, in_body.x * std::sin(roll), in_body.x * std::cos(roll)};
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
constexpr int kP = place(kStateIndex.rates.x);
constexpr int kQ = place(kStateIndex.rates.y);
constexpr int kR = place(kStateIndex.rates.z);
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
  const double roll = f.state.roll, pitch = f.state.pitch;
  const TrackMotion motion{track};
  f.state.velocity = motion.velocity(roll, pitch);
  f.state.rates = motion.rates(roll, pitch);
  const Linear m = linear_model(c, f.state, f.controls, kInceptors);
  const Vec3<double> velocity_by_pitch = by_pitch(f.state.velocity, roll);
  const Vec3<double> rates_by_pitch = by_pitch(f.state.rates, roll);
  Matrix<double, kMaxLinearStates, kMaxLinearStates> equations{};
  Matrix<double, kMaxLinearStates, 1> rates{};
  int row = 0;
  double largest = 0;
  for (int i = 0; i < m.states; ++i) {
    if (i == kRoll || i == kPitch) continue;
    const auto turned = [&](int angle, const Vec3<double>& v, const Vec3<double>& w) {
      return m.a(i, angle) + m.a(i, kU) * v.x + m.a(i, kV) * v.y + m.a(i, kW) * v.z + m.a(i, kP) * w.x +
             m.a(i, kQ) * w.y + m.a(i, kR) * w.z;
    };
    int column = 0;
    equations(row, column++) = turned(kRoll, by_roll(f.state.velocity), by_roll(f.state.rates));
    equations(row, column++) = turned(kPitch, velocity_by_pitch, rates_by_pitch);
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

// From one flight to another in stages; `at`: the track at a part of the way.
template <class At>
SidewardFlight in_stages(const Configured& c, int stages, const SidewardFlight& from, At&& at) {
  SidewardFlight f = from;
  for (int stage = 1; stage <= stages && f.found; ++stage) {
    const Track track = at(stage);
    f.rate = HUGE_VAL;
    for (int k = 0; k < kIterations && f.rate > kAtRest; ++k, ++f.iterations)
      f.rate = newton_step(c, track, f);
    f.found = f.rate <= kAtRest;
  }
  return f;
}

int stages_of(double way, double step) {
  return std::max(kStages, static_cast<int>(std::ceil(std::fabs(way) / step)));
}

}  // namespace

SidewardFlight flight_along(const Configured& c, const Track& track) {
  const Trimmed hover = trimmed_persistently(c, 0);
  const int stages = stages_of(std::hypot(track.speed, track.down), kSpeedStep);
  return in_stages(c, stages, {is_trimmed(hover.status), hover.state, hover.controls}, [&](int stage) {
    return Track{track.speed * stage / stages, track.azimuth, track.down * stage / stages,
                 track.turn_rate * stage / stages};
  });
}

SidewardFlight flight_aside(const Configured& c, const Track& track, const SidewardFlight& ahead) {
  const int stages = stages_of(track.azimuth, kAzimuthStep);
  return in_stages(c, stages, ahead, [&](int stage) {
    return Track{track.speed, track.azimuth * stage / stages, track.down, track.turn_rate};
  });
}

SidewardFlight sideward_flight(const Configured& c, double speed_mps, double track_rad) {
  return flight_along(c, {speed_mps, track_rad, 0, 0});
}

double travel_used(const Configured& c, const Controls<double>& u) {
  const ControlTables<double>& travel = c.aircraft->controls;
  return std::max({std::fabs(u.long_stick) / travel.long_travel, std::fabs(u.lat_stick) / travel.lat_travel,
                   std::fabs(u.pedal) / travel.pedal_travel});
}

}  // namespace tiltrotor::study

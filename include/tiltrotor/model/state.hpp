// State of the aircraft and its time derivative: one plain struct, trivially copyable.
//
// Body axes x forward, y right, z down, origin at the CG; velocity relative to the undisturbed air. Relative
// to the air at the aircraft, which all air loads follow, it is velocity - Controls::gust. Flapping and
// inflow of each rotor stand in its own mirrored frame (frames.hpp), so that symmetric flight has equal
// rotors.
#pragma once

#include "tiltrotor/math/vector.hpp"
#include "tiltrotor/model/options.hpp"

namespace tiltrotor {

enum Side { right = 0, left = 1 };

template <class T>
struct RotorState {
  T b1c, b1s;  // gimbal tilt, multiblade coordinates, rad: b1c > 0 disk forward, b1s > 0 advancing side up
  T b1c_rate, b1s_rate;  // rad/s
  T n0, nc, ns;          // inflow states over tip speed: mean, longitudinal, lateral harmonic at the tip
};

template <class T>
struct ConingState {
  T angle, rate;  // rad, rad/s
};

template <class T>
struct State {
  Vec3<T> velocity;          // u v w, m/s
  Vec3<T> rates;             // p q r, rad/s
  T roll, pitch, yaw;        // 3-2-1 Euler angles, rad
  RotorState<T> rotor[2];    // right, left
  T downwash;                // wing downwash at the tail, lagged, rad
  ConingState<T> coning[2];  // only with Options::coning_states
  Vec3<T>
      position;  // north, east, down relative to the undisturbed air, m; only with Options::position_states

  static constexpr int kCount = 31;

  template <class Self, class Visit>
  static void each(Self& s, Visit&& visit) {
    Vec3<T>::each(s.velocity, visit);
    Vec3<T>::each(s.rates, visit);
    visit(s.roll);
    visit(s.pitch);
    visit(s.yaw);
    for (int side = 0; side < 2; ++side) {
      visit(s.rotor[side].b1c);
      visit(s.rotor[side].b1s);
      visit(s.rotor[side].b1c_rate);
      visit(s.rotor[side].b1s_rate);
      visit(s.rotor[side].n0);
      visit(s.rotor[side].nc);
      visit(s.rotor[side].ns);
    }
    visit(s.downwash);
    for (int side = 0; side < 2; ++side) {
      visit(s.coning[side].angle);
      visit(s.coning[side].rate);
    }
    Vec3<T>::each(s.position, visit);
  }
};

// Places in the order of State::each, and in files.
enum StateIndex {
  ix_u,
  ix_v,
  ix_w,
  ix_p,
  ix_q,
  ix_r,
  ix_roll,
  ix_pitch,
  ix_yaw,
  ix_rotor_right,
  ix_rotor_left = 16,  // seven each: b1c b1s b1c_rate b1s_rate n0 nc ns
  ix_downwash = 23,
  ix_coning_right = 24,
  ix_coning_left = 26,  // angle, rate
  ix_position = 28,
  state_count = 31
};

struct StateName {
  const char* name;
  const char* unit;
};
inline constexpr StateName kStateNames[state_count] = {
    {"u", "m/s"},       {"v", "m/s"},        {"w", "m/s"},        {"p", "rad/s"},      {"q", "rad/s"},
    {"r", "rad/s"},     {"phi", "rad"},      {"theta", "rad"},    {"psi", "rad"},      {"b1c_R", "rad"},
    {"b1s_R", "rad"},   {"db1c_R", "rad/s"}, {"db1s_R", "rad/s"}, {"n0_R", "-"},       {"nc_R", "-"},
    {"ns_R", "-"},      {"b1c_L", "rad"},    {"b1s_L", "rad"},    {"db1c_L", "rad/s"}, {"db1s_L", "rad/s"},
    {"n0_L", "-"},      {"nc_L", "-"},       {"ns_L", "-"},       {"eps", "rad"},      {"b0_R", "rad"},
    {"db0_R", "rad/s"}, {"b0_L", "rad"},     {"db0_L", "rad/s"},  {"north", "m"},      {"east", "m"},
    {"down", "m"}};

// The states that are alive under a set of options, in order. The others stay constant.
struct ActiveStates {
  int count;
  int index[state_count];
};

// `with_yaw` false drops the heading, on which nothing depends: the set for trim and linear models.
inline ActiveStates active_states(const Options& options, bool with_yaw) {
  ActiveStates active{0, {}};
  for (int i = 0; i < state_count; ++i) {
    const bool rotor = i >= ix_rotor_right && i < ix_downwash;
    const int place = rotor ? (i - ix_rotor_right) % 7 : 0;
    if (i == ix_yaw && !with_yaw) continue;
    if (rotor && (place == 2 || place == 3) && options.flapping == FlapOrder::first) continue;
    if (rotor && place >= 5 && options.inflow == InflowShape::uniform) continue;
    if (i == ix_downwash && !options.downwash_lag) continue;
    if (i >= ix_coning_right && i < ix_position && !options.coning_states) continue;
    if (i >= ix_position && !options.position_states) continue;
    active.index[active.count++] = i;
  }
  return active;
}

}  // namespace tiltrotor

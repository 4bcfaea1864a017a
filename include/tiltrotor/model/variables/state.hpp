// State of the aircraft and its time derivative: one plain struct, trivially copyable.
//
// Body axes x forward, y right, z down, origin at the CG; velocity relative to the undisturbed air. Relative
// to the air at the aircraft, which all air loads follow, it is velocity - Controls::gust. Flapping and
// inflow of each rotor stand in its own mirrored frame (frames.hpp), so that symmetric flight has equal
// rotors.
//
// A new state is a member and its line in describe(); whatever is forgotten does not compile.
#pragma once

#include "tiltrotor/math/vector.hpp"
#include "tiltrotor/model/variables/options.hpp"
#include "tiltrotor/model/variables/variables.hpp"

namespace tiltrotor {

template <class T>
struct RotorState {
  T b1c, b1s;  // gimbal tilt, multiblade coordinates, rad: b1c > 0 disk forward, b1s > 0 advancing side up
  T b1c_rate, b1s_rate;            // rad/s
  T lambda_0, lambda_c, lambda_s;  // inflow over tip speed: mean, longitudinal, lateral harmonic at the tip
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
  // North, east, down over the ground, m: carried along by the wind (Surroundings::wind_n); only with
  // Options::position_states.
  Vec3<T> position;

  // Every state once, with what it is, in the order of files and arrays.
  template <class Self, class Visit>
  static constexpr void describe(Self& s, Visit&& visit) {
    using K = VariableKind;
    constexpr Plane lon = Plane::longitudinal;
    constexpr Plane lat = Plane::lateral;
    constexpr Plane rot = Plane::rotor;
    visit(s.velocity.x, Variable{"u", K::speed, lon});
    visit(s.velocity.y, Variable{"v", K::speed, lat});
    visit(s.velocity.z, Variable{"w", K::speed, lon});
    visit(s.rates.x, Variable{"p", K::body_rate, lat});
    visit(s.rates.y, Variable{"q", K::body_rate, lon});
    visit(s.rates.z, Variable{"r", K::body_rate, lat});
    visit(s.roll, Variable{"phi", K::bank, lat});
    visit(s.pitch, Variable{"theta", K::pitch, lon});
    visit(s.yaw, Variable{"psi", K::heading, lat});
    for (int side = 0; side < 2; ++side) {
      const bool r = side == right;
      visit(s.rotor[side].b1c, Variable{r ? "b1c_R" : "b1c_L", K::gimbal_tilt, rot, side});
      visit(s.rotor[side].b1s, Variable{r ? "b1s_R" : "b1s_L", K::gimbal_tilt, rot, side});
      visit(s.rotor[side].b1c_rate, Variable{r ? "db1c_R" : "db1c_L", K::gimbal_rate, rot, side});
      visit(s.rotor[side].b1s_rate, Variable{r ? "db1s_R" : "db1s_L", K::gimbal_rate, rot, side});
      visit(s.rotor[side].lambda_0, Variable{r ? "n0_R" : "n0_L", K::mean_inflow, rot, side});
      visit(s.rotor[side].lambda_c, Variable{r ? "nc_R" : "nc_L", K::cyclic_inflow, rot, side});
      visit(s.rotor[side].lambda_s, Variable{r ? "ns_R" : "ns_L", K::cyclic_inflow, rot, side});
    }
    visit(s.downwash, Variable{"eps", K::downwash, lon});
    for (int side = 0; side < 2; ++side) {
      const bool r = side == right;
      visit(s.coning[side].angle, Variable{r ? "b0_R" : "b0_L", K::coning, rot, side});
      visit(s.coning[side].rate, Variable{r ? "db0_R" : "db0_L", K::coning_rate, rot, side});
    }
    visit(s.position.x, Variable{"north", K::position, lon});
    visit(s.position.y, Variable{"east", K::position, lat});
    visit(s.position.z, Variable{"down", K::position, lon});
  }

  template <class Self, class Visit>
  static void each(Self& s, Visit&& visit) {
    describe(s, [&visit](auto& x, const Variable&) { visit(x); });
  }
};

inline constexpr int state_count = count_variables<State>();
static_assert(sizeof(State<int>) == state_count * sizeof(int), "every member of State is described");

// Place of each state: kStateIndex.pitch, kStateIndex.rotor[right].lambda_0.
inline constexpr State<int> kStateIndex = places<State>();
inline constexpr auto kStateVariables = variable_table<State>();
static_assert(is_complete(kStateVariables), "names are unlike, sides have the same states");

// Beyond this a flight has diverged; in the unit of the state.
template <class R>
constexpr R state_bound(int state) {
  return static_cast<R>(kStateVariables[state].facts().bound);
}

// The states that are alive under a set of options, in order. The others stay constant.
struct ActiveStates {
  int count;
  int index[state_count];
};

constexpr bool is_active(const Variable& state, const Options& options) {
  switch (state.kind) {
    case VariableKind::gimbal_rate:
      return options.flapping != FlapOrder::first;
    case VariableKind::cyclic_inflow:
      return options.inflow != InflowShape::uniform;
    case VariableKind::downwash:
      return options.downwash_lag;
    case VariableKind::coning:
    case VariableKind::coning_rate:
      return options.coning_states;
    case VariableKind::position:
      return options.position_states;
    default:
      return true;
  }
}

// `with_yaw` false drops the heading, on which nothing depends: the set for trim and linear models.
inline ActiveStates active_states(const Options& options, bool with_yaw) {
  ActiveStates active{0, {}};
  for (int i = 0; i < state_count; ++i) {
    if (i == kStateIndex.yaw && !with_yaw) continue;
    if (is_active(kStateVariables[i], options)) active.index[active.count++] = i;
  }
  return active;
}

}  // namespace tiltrotor

// What a rotor sees of the aircraft.
#pragma once

#include "tiltrotor/math/differentiation/preaccumulate.hpp"
#include "tiltrotor/math/vector.hpp"
#include "tiltrotor/model/variables/state.hpp"

namespace tiltrotor {

template <class T>
struct RotorInput {
  Vec3<T> velocity_a;  // hub relative to the air, m/s
  Vec3<T> rates_a;     // of the hub frame, rad/s
  RotorState<T> state;
  ConingState<T> coning;
  T collective;      // blade pitch at the reference radius, rad
  T lateral_cyclic;  // A1: pitch = ... - A1 cos psi - B1 sin psi, rad
  T long_cyclic;     // B1

  static constexpr int kCount = 18;
  static constexpr int kFirstOwn = 6, kOwn = 9;  // state and coning: as they stand in State, or constant
  template <class Self, class Visit>
  static constexpr void each(Self& s, Visit&& visit) {
    Vec3<T>::each(s.velocity_a, visit);
    Vec3<T>::each(s.rates_a, visit);
    visit(s.state.b1c);
    visit(s.state.b1s);
    visit(s.state.b1c_rate);
    visit(s.state.b1s_rate);
    visit(s.state.lambda_0);
    visit(s.state.lambda_c);
    visit(s.state.lambda_s);
    visit(s.coning.angle);
    visit(s.coning.rate);
    visit(s.collective);
    visit(s.lateral_cyclic);
    visit(s.long_cyclic);
  }
};
static_assert(lists_its_members<RotorInput>(), "each member of RotorInput is listed and counted");

// Directions of a pass that are the rotors' own states: of both, in the order of RotorInput. `direction`: of each state of
// the aircraft, -1 for none.
struct RotorDirections {
  using Own = OwnDirections<RotorInput<double>::kFirstOwn, RotorInput<double>::kOwn>;
  Own rotor[2];
};
inline RotorDirections rotor_directions(const int (&direction)[state_count]) {
  using In = RotorInput<int>;
  RotorDirections own;
  for (const Side side : {right, left}) {
    const RotorState<int>& s = kStateIndex.rotor[side];
    const ConingState<int>& coning = kStateIndex.coning[side];
    In in{};
    in.state = {direction[s.b1c],      direction[s.b1s],      direction[s.b1c_rate], direction[s.b1s_rate],
                direction[s.lambda_0], direction[s.lambda_c], direction[s.lambda_s]};
    in.coning = {direction[coning.angle], direction[coning.rate]};
    int place[In::kCount];
    flatten(in, place);
    for (int j = 0; j < In::kOwn; ++j) own.rotor[side].of[j] = place[In::kFirstOwn + j];
  }
  return own;
}
constexpr bool own_stand_in_a_row() {
  RotorInput<int> in{};
  in.state = {1, 1, 1, 1, 1, 1, 1};
  in.coning = {1, 1};
  int place = 0, right_ones = 0;
  RotorInput<int>::each(in, [&](int own) {
    const bool expected =
        place >= RotorInput<int>::kFirstOwn && place < RotorInput<int>::kFirstOwn + RotorInput<int>::kOwn;
    right_ones += (own == 1) == expected ? 1 : 0;
    ++place;
  });
  return right_ones == RotorInput<int>::kCount;
}
static_assert(own_stand_in_a_row(), "kFirstOwn and kOwn say where a rotor's own states stand");

// A rotor's input, and its conditions.
template <class T>
struct PlacedRotorInput {
  RotorInput<T> in;
  T speed, ground_wash, density, speed_of_sound;  // RotorConditions

  static constexpr int kCount = RotorInput<T>::kCount + 4;
  template <class Self, class Visit>
  static constexpr void each(Self& s, Visit&& visit) {
    RotorInput<T>::each(s.in, visit);
    visit(s.speed);
    visit(s.ground_wash);
    visit(s.density);
    visit(s.speed_of_sound);
  }
};
static_assert(lists_its_members<PlacedRotorInput>(), "each member of PlacedRotorInput is listed and counted");

// Mean inflow as the blades feel it, m/s: felt_inflow().
template <class T>
struct FeltInflow {
  T even;    // over the disk
  T shaped;  // part of it that follows the radial shape
};

}  // namespace tiltrotor

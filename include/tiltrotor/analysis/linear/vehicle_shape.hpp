// What rows and columns of the vehicle's linear model stand for.
#pragma once

#include "tiltrotor/analysis/linear/linear_model.hpp"
#include "tiltrotor/systems/vehicle.hpp"

namespace tiltrotor {

// Systems' states that a linear model has: not those on which nothing depends.
constexpr int count_linear_system_states() {
  int count = 0;
  for (int i = 0; i < system_state_count; ++i) count += !kSystemVariables[i].facts().ignorable;
  return count;
}
// With the position down, where ground or air make it count.
inline constexpr int kMaxVehicleStates = kMaxLinearStates + 1 + count_linear_system_states();

// Places of vehicle_variable() and vehicle_input() by row and column.
struct VehicleShape {
  int states, inputs;
  int state[kMaxVehicleStates];
  int input[vehicle_input_count];
};

// States of the airframe's linear model, the position down where something depends on it, then the systems'.
template <class R>
void vehicle_states(const Vehicle<R>& v, const Options& options, VehicleShape& shape) {
  LinearPoint<R> point;
  linear_states(options, point);
  shape.states = 0;
  for (int i = 0; i < point.states; ++i) shape.state[shape.states++] = point.state[i];
  if (v.air_follows || v.on.gear || v.on.ground_effect || shear_in_force(v) != WindShear::none)
    shape.state[shape.states++] = kStateIndex.position.z;
  const ActiveSystems active = active_systems(v.on);
  for (int k = 0; k < active.count; ++k)
    if (!kSystemVariables[active.index[k]].facts().ignorable)
      shape.state[shape.states++] = state_count + active.index[k];
}

}  // namespace tiltrotor

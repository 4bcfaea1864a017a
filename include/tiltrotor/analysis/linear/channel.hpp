// One input to one output of a linear model, as a transfer function needs it: what takes no part is left out.
//
// Rotors stand as mean and difference, so that in symmetric flight the longitudinal and the lateral half fall apart, and
// what cannot be told from rounding is zero. Of the states those remain that the input reaches and the output sees:
// poles and zeros are then those of the response, not of the other half.
#pragma once

#include "tiltrotor/analysis/linear/vehicle_modes.hpp"
#include "tiltrotor/math/algebra/transfer_function.hpp"

namespace tiltrotor {

template <class R>
using VehicleChannel = Channel<R, kMaxVehicleStates>;
template <class R>
using VehicleTransfer = TransferFunction<R, kMaxVehicleStates>;

namespace channel_detail {

// Zero what is less than rounding beside the others of its row, each over the distance at which the model bends.
template <class R>
void drop_rounding(const VehicleShape& shape, R input_bend, VehicleChannel<R>& s) {
  constexpr R kRounding = R(64) * std::numeric_limits<R>::epsilon();
  const auto bend = [&shape](int j) { return static_cast<R>(vehicle_variable(shape.state[j]).facts().bend); };
  const auto clean = [](R& entry, R least) {
    if (std::fabs(entry) < least) entry = R(0);
  };
  R seen = R(0);
  for (int j = 0; j < s.states; ++j) seen += std::fabs(s.c[j]) * bend(j);
  clean(s.d, kRounding * seen / input_bend);
  for (int i = 0; i < s.states; ++i) {
    R terms = std::fabs(s.b[i]) * input_bend;
    for (int j = 0; j < s.states; ++j) terms += std::fabs(s.a(i, j)) * bend(j);
    for (int j = 0; j < s.states; ++j) clean(s.a(i, j), kRounding * terms / bend(j));
    clean(s.b[i], kRounding * terms / input_bend);
    clean(s.c[i], kRounding * seen / bend(i));
  }
}

// Keeps the states that the input reaches and the output sees, in their order.
template <class R>
void keep_what_takes_part(VehicleChannel<R>& s) {
  bool reached[kMaxVehicleStates], seen[kMaxVehicleStates];
  const int n = s.states;
  for (int i = 0; i < n; ++i) {
    reached[i] = s.b[i] != R(0);
    seen[i] = s.c[i] != R(0);
  }
  for (int pass = 0; pass < n; ++pass)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        if (s.a(i, j) == R(0)) continue;
        reached[i] = reached[i] || reached[j];
        seen[j] = seen[j] || seen[i];
      }
  int kept[kMaxVehicleStates];
  s.states = 0;
  for (int i = 0; i < n; ++i)
    if (reached[i] && seen[i]) kept[s.states++] = i;
  for (int i = 0; i < s.states; ++i) {
    s.b[i] = s.b[kept[i]];
    s.c[i] = s.c[kept[i]];
    for (int j = 0; j < s.states; ++j) s.a(i, j) = s.a(kept[i], kept[j]);
  }
}

}  // namespace channel_detail

// From the rows and columns of a model: a(i, j), b(i) of the input, c(j) and d of the output. `shape.state` says what
// the states are, `input` is a place in vehicle_input(). Cost: n^3 comparisons.
template <class R, class A, class B, class C>
void set_channel(const VehicleShape& shape, int input, A&& a, B&& b, C&& c, R d, VehicleChannel<R>& s) {
  const int n = s.states = shape.states;
  s.d = d;
  for (int i = 0; i < n; ++i) {
    s.b[i] = b(i);
    s.c[i] = c(i);
    for (int j = 0; j < n; ++j) s.a(i, j) = a(i, j);
  }
  Symmetry symmetry[kMaxVehicleStates];
  split_rotors(shape, s.a, symmetry);
  for (int r = 0; r < n; ++r) {
    if (symmetry[r] != Symmetry::mean) continue;
    int l = 0;
    while (shape.state[l] != kStateVariables.partner[shape.state[r]]) ++l;
    const R b_right = s.b[r], b_left = s.b[l], c_right = s.c[r], c_left = s.c[l];
    s.b[r] = R(0.5) * (b_right + b_left);
    s.b[l] = R(0.5) * (b_right - b_left);
    s.c[r] = c_right + c_left;
    s.c[l] = c_right - c_left;
  }
  channel_detail::drop_rounding(shape, static_cast<R>(vehicle_input(input).facts().bend), s);
  channel_detail::keep_what_takes_part(s);
}

// The same of the airframe's model: its states i and control j.
template <class R>
void set_channel(const LinearModel<R>& model, int output, int control, VehicleChannel<R>& s) {
  VehicleShape shape{};
  shape.states = model.states;
  for (int i = 0; i < model.states; ++i) shape.state[i] = model.state[i];
  set_channel(
      shape, model.control[control], [&](int i, int j) { return model.a(i, j); },
      [&](int i) { return model.b(i, control); }, [output](int j) { return R(j == output); }, R(0), s);
}

}  // namespace tiltrotor

// The rigid body with its systems: rotors, inflow and wash follow by the formulas of rigid_model.hpp, in which r counts
// the states of the systems and the position down among the slow ones, however fast they are.
#pragma once

#include "tiltrotor/analysis/linear/rigid_model.hpp"
#include "tiltrotor/analysis/linear/vehicle_model.hpp"

namespace tiltrotor {

inline constexpr int kMaxKeptStates = kMaxVehicleStates - kMaxFastStates;

// Whether a state stays, by its place in vehicle_variable(). North, east and yaw are in no linear model.
constexpr bool stays_in_reduction(int state) {
  return state >= state_count || state == kStateIndex.position.z || is_rigid(state);
}

// The states that stay of a model's, in their order.
inline void keep_slow_states(VehicleShape& shape) {
  int count = 0;
  for (int i = 0; i < shape.states; ++i)
    if (stays_in_reduction(shape.state[i])) shape.state[count++] = shape.state[i];
  shape.states = count;
}

template <class R>
struct VehicleReductionWorkspace {
  static constexpr int kColumns = kMaxKeptStates + vehicle_input_count;
  int kept_count, fast_count;
  int kept[kMaxVehicleStates], fast[kMaxVehicleStates];  // rows of the full model
  Matrix<R, kMaxFastStates, kMaxFastStates> a_ff;
  LU<R, kMaxFastStates> fast_lu;
  Matrix<R, kMaxFastStates, kColumns> drive;          // [A_fr B_f]
  Matrix<R, kMaxFastStates, kColumns> response;       // A_ff^-1 [A_fr B_f]
  Matrix<R, kMaxFastStates, kColumns> lag;            // A_ff^-1 X, columns of states alone
  Matrix<R, kMaxKeptStates, kMaxKeptStates> inertia;  // I + A_rf A_ff^-1 X
  LU<R, kMaxKeptStates> inertia_lu;
  Matrix<R, kMaxKeptStates, kColumns> slow, solved;  // [A B] of the reduced model
};

namespace vehicle_reduction_detail {

template <class R>
void list_states(const VehicleShape& shape, VehicleReductionWorkspace<R>& work) {
  work.kept_count = work.fast_count = 0;
  for (int i = 0; i < shape.states; ++i)
    (stays_in_reduction(shape.state[i]) ? work.kept[work.kept_count++] : work.fast[work.fast_count++]) = i;
}

// [A_rr - A_rf X, B_r - A_rf A_ff^-1 B_f]
template <class R, class A, class B>
Status balance_fast(const A& a, const B& b, int m, VehicleReductionWorkspace<R>& work) {
  const int r = work.kept_count, f = work.fast_count;
  for (int i = 0; i < f; ++i) {
    for (int j = 0; j < f; ++j) work.a_ff(i, j) = a(work.fast[i], work.fast[j]);
    for (int j = 0; j < r; ++j) work.drive(i, j) = a(work.fast[i], work.kept[j]);
    for (int j = 0; j < m; ++j) work.drive(i, r + j) = b(work.fast[i], j);
  }
  Status status = f > 0 ? lu_factor(work.a_ff, f, work.fast_lu) : Status::ok;
  if (status == Status::ok && f > 0) status = lu_solve(work.fast_lu, work.drive, r + m, work.response);
  for (int i = 0; i < r && status == Status::ok; ++i) {
    for (int j = 0; j < r; ++j) work.slow(i, j) = a(work.kept[i], work.kept[j]);
    for (int j = 0; j < m; ++j) work.slow(i, r + j) = b(work.kept[i], j);
    for (int j = r + m; j < lane_ceil<R>(r + m); ++j) work.slow.row(i)[j] = R(0);
    for (int k = 0; k < f; ++k)
      padded::add_scaled(-a(work.kept[i], work.fast[k]), work.response.row(k), work.slow.row(i), 0,
                         lane_ceil<R>(r + m));
    for (int j = 0; j < r + m; ++j)
      if (!is_finite(work.slow(i, j))) status = Status::not_finite;
  }
  return status;
}

// The same over I + A_rf A_ff^-1 X.
template <class R, class A>
Status delay_fast(const A& a, int m, VehicleReductionWorkspace<R>& work) {
  const int r = work.kept_count, f = work.fast_count;
  Status status = lu_solve(work.fast_lu, work.response, r, work.lag);
  for (int i = 0; i < r && status == Status::ok; ++i) {
    for (int j = 0; j < lane_ceil<R>(r); ++j) work.inertia.row(i)[j] = R(i == j ? 1 : 0);
    for (int k = 0; k < f; ++k)
      padded::add_scaled(a(work.kept[i], work.fast[k]), work.lag.row(k), work.inertia.row(i), 0,
                         lane_ceil<R>(r));
  }
  if (status == Status::ok) status = lu_factor(work.inertia, r, work.inertia_lu);
  if (status == Status::ok) status = lu_solve(work.inertia_lu, work.slow, r + m, work.solved);
  for (int i = 0; i < r && status == Status::ok; ++i)
    for (int j = 0; j < r + m; ++j) work.slow(i, j) = work.solved(i, j);
  return status;
}

}  // namespace vehicle_reduction_detail

// The model of the slow states in their order, work.slow = [A B], from one with systems: a(i, j) and b(i, j) with the rows
// and columns of `shape`, 1/s times units of states and inputs. Without systems the bits of rigid_model().
// Status: ok; singular (the fast states or the slow ones have no balance), not_finite, bad_argument (more states than a
// vehicle has of a kind, or inputs). Cost: about n^3 multiplications.
template <class R, class A, class B>
Status find_slow_model(Reduction order, const VehicleShape& shape, const A& a, const B& b,
                       VehicleReductionWorkspace<R>& work) {
  namespace d = vehicle_reduction_detail;
  const int m = shape.inputs;
  const bool fits =
      shape.states >= 0 && shape.states <= kMaxVehicleStates && m >= 0 && m <= vehicle_input_count;
  if (fits) d::list_states(shape, work);
  const bool usable =
      fits && work.kept_count > 0 && work.kept_count <= kMaxKeptStates && work.fast_count <= kMaxFastStates;
  Status status = usable ? d::balance_fast(a, b, m, work) : Status::bad_argument;
  if (status == Status::ok && order == Reduction::first_order && work.fast_count > 0)
    status = d::delay_fast(a, m, work);
  return status;
}

// The same in the place of all; where it fails `shape` is empty.
template <class R, class A, class B>
Status reduce_vehicle(Reduction order, VehicleShape& shape, A& a, B& b, VehicleReductionWorkspace<R>& work) {
  const Status status = find_slow_model(order, shape, a, b, work);
  if (status != Status::ok) {
    shape.states = shape.inputs = 0;
    return status;
  }
  keep_slow_states(shape);
  for (int i = 0; i < work.kept_count; ++i) {
    for (int j = 0; j < work.kept_count; ++j) a(i, j) = work.slow(i, j);
    for (int j = 0; j < shape.inputs; ++j) b(i, j) = work.slow(i, work.kept_count + j);
  }
  return Status::ok;
}

// Rows of C and D of the full model become those of the reduced one, as in rigid_outputs.hpp; `work` as reduce_vehicle() left
// it. Cost: rows (fast states)(slow states + inputs) multiplications.
template <class R, class C, class D>
void reduce_vehicle_outputs(Reduction order, int inputs, VehicleReductionWorkspace<R>& work, int rows, C& c,
                            D& d) {
  const int r = work.kept_count;
  const bool lags = order == Reduction::first_order;
  for (int f = 0; f < work.fast_count; ++f) {
    R by[VehicleReductionWorkspace<R>::kColumns];  // x_f = -by [x_r u]
    for (int j = 0; j < r + inputs; ++j) {
      by[j] = work.response(f, j);
      for (int l = 0; lags && l < r; ++l) by[j] += work.lag(f, l) * work.slow(l, j);
    }
    for (int i = 0; i < rows; ++i) {
      const R reads = c(i, work.fast[f]);
      for (int j = 0; j < r; ++j) c(i, work.kept[j]) -= reads * by[j];
      for (int j = 0; j < inputs; ++j) d(i, j) -= reads * by[r + j];
    }
  }
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < r; ++j) c(i, j) = c(i, work.kept[j]);
}

}  // namespace tiltrotor

// Smaller and clearer linear models: residualised rotors, and symmetric and antisymmetric halves.
#pragma once

#include "tiltrotor/analysis/linear/linear_model.hpp"
#include "tiltrotor/math/algebra/lu.hpp"

namespace tiltrotor {

inline constexpr int kMaxFastStates = kMaxLinearStates - kRigidStates;

template <class R>
struct ResidualisationWorkspace {
  Matrix<R, kMaxFastStates, kMaxFastStates> fast;  // A_ff
  LU<R, kMaxFastStates> lu;
  Matrix<R, kMaxFastStates, kRigidStates + kMaxLinearControls> drive;     // [A_fr B_f]
  Matrix<R, kMaxFastStates, kRigidStates + kMaxLinearControls> response;  // A_ff^-1 [A_fr B_f]
};

// The 8 rigid-body states with every other state in its quasi-steady balance:
//   A_qs = A_rr - A_rf A_ff^-1 A_fr,  B_qs = B_r - A_rf A_ff^-1 B_f.
// Its entries are the quasi-steady stability derivatives. `reduced` is another object than `full`.
// Status: ok; singular or not_finite (then `reduced` is empty).
template <class R>
Status residualise(const LinearModel<R>& full, ResidualisationWorkspace<R>& work, LinearModel<R>& reduced) {
  clear(reduced);
  const int r = kRigidStates;
  const int f = full.states - r;
  const int m = full.controls;
  if (f < 0) return Status::bad_argument;
  if (f > 0) {
    for (int i = 0; i < f; ++i) {
      for (int j = 0; j < f; ++j) work.fast(i, j) = full.a(r + i, r + j);
      for (int j = 0; j < r; ++j) work.drive(i, j) = full.a(r + i, j);
      for (int j = 0; j < m; ++j) work.drive(i, r + j) = full.b(r + i, j);
    }
    const Status factored = lu_factor(work.fast, f, work.lu);
    if (factored != Status::ok) return factored;
    const Status solved = lu_solve(work.lu, work.drive, r + m, work.response);
    if (solved != Status::ok) return solved;
  }
  reduced.states = r;
  reduced.controls = m;
  bool finite = true;
  for (int i = 0; i < r; ++i) {
    reduced.state[i] = full.state[i];
    reduced.x[i] = full.x[i];
    reduced.rates[i] = full.rates[i];
    alignas(64) R row[decltype(work.response)::kStride] = {};  // of [A_rr B_r]
    for (int j = 0; j < r; ++j) row[j] = full.a(i, j);
    for (int j = 0; j < m; ++j) row[r + j] = full.b(i, j);
    for (int k = 0; k < f; ++k)
      padded::add_scaled(-full.a(i, r + k), work.response.row(k), row, 0, lane_ceil<R>(r + m));
    for (int j = 0; j < r + m; ++j) finite &= is_finite(row[j]);
    for (int j = 0; j < r; ++j) reduced.a(i, j) = row[j];
    for (int j = 0; j < m; ++j) reduced.b(i, j) = row[r + j];
  }
  if (!finite) {
    clear(reduced);
    return Status::not_finite;
  }
  for (int j = 0; j < m; ++j) {
    reduced.control[j] = full.control[j];
    reduced.u[j] = full.u[j];
  }
  return Status::ok;
}

// What a coordinate of the split model is.
enum class Symmetry : unsigned char {
  none,
  mean,
  difference
};  // a state itself; (right + left)/2; (right - left)/2

struct SplitCoordinate {
  int state;  // place in kStateVariables; the right rotor's for mean and difference
  Symmetry symmetry;
};

// The linear model in coordinates s = (right + left)/2, a = (right - left)/2 of the rotors, longitudinal ones
// first:
//   u w q theta, means, downwash | v p phi r, differences.
// In symmetric flight the blocks decouple exactly.
template <class R>
struct SplitModel {
  int states;
  int longitudinal;  // size of the first block
  int controls;
  SplitCoordinate coordinate[kMaxLinearStates];
  int control[kMaxLinearControls];
  Matrix<R, kMaxLinearStates, kMaxLinearStates> a;
  Matrix<R, kMaxLinearStates, kMaxLinearControls> b;
  R coupling;  // largest entry of A outside the two blocks
  R largest;   // and inside
};

namespace reduction_detail {

template <class R>
int find(const LinearModel<R>& model, int state) {
  for (int i = 0; i < model.states; ++i)
    if (model.state[i] == state) return i;
  return 0;
}

// Rows or columns of the full model that make a coordinate: first + sign second.
struct Parts {
  int first, second;
  int sign;  // +1 mean, -1 difference, 0 one state
};
template <class R>
Parts parts(const LinearModel<R>& model, const SplitCoordinate& coordinate) {
  const int first = find(model, coordinate.state);
  if (coordinate.symmetry == Symmetry::none) return {first, first, 0};
  return {first, find(model, kStateVariables.partner[coordinate.state]),
          coordinate.symmetry == Symmetry::mean ? 1 : -1};
}

}  // namespace reduction_detail

// Works on full and residualised models.
template <class R>
void split(const LinearModel<R>& model, SplitModel<R>& out) {
  namespace d = reduction_detail;
  out.states = out.longitudinal = 0;
  out.coupling = out.largest = R(0);
  set_zero(out.a);
  set_zero(out.b);
  for (int pass = 0; pass < 2; ++pass) {  // longitudinal, lateral
    for (int i = 0; i < model.states; ++i) {
      const int state = model.state[i];
      const Variable& variable = kStateVariables[state];
      if (variable.side == right) {
        out.coordinate[out.states++] = {state, pass == 0 ? Symmetry::mean : Symmetry::difference};
      } else if (variable.side == kNoSide && (variable.plane == Plane::lateral) == (pass == 1)) {
        out.coordinate[out.states++] = {state, Symmetry::none};
      }
    }
    if (pass == 0) out.longitudinal = out.states;
  }
  out.controls = model.controls;
  for (int j = 0; j < model.controls; ++j) out.control[j] = model.control[j];

  d::Parts place[kMaxLinearStates];
  for (int i = 0; i < out.states; ++i) place[i] = d::parts(model, out.coordinate[i]);
  for (int i = 0; i < out.states; ++i) {
    const d::Parts& row = place[i];
    // (row of right +- row of left) / 2
    const auto rows = [&row](const auto& matrix, int column) {
      const R first = matrix(row.first, column);
      if (row.sign == 0) return first;
      const R second = matrix(row.second, column);
      return R(0.5) * (row.sign > 0 ? first + second : first - second);
    };
    for (int j = 0; j < out.states; ++j) {
      const d::Parts& column = place[j];
      R entry = rows(model.a, column.first);
      if (column.sign > 0) entry += rows(model.a, column.second);
      if (column.sign < 0) entry -= rows(model.a, column.second);
      out.a(i, j) = entry;
      const bool outside = (i < out.longitudinal) != (j < out.longitudinal);
      R& bound = outside ? out.coupling : out.largest;
      if (!(std::fabs(entry) <= bound)) bound = std::fabs(entry);
    }
    for (int j = 0; j < out.controls; ++j) out.b(i, j) = rows(model.b, j);
  }
}

}  // namespace tiltrotor

// The rigid body alone: which order of the rotors' and the wash's lag stays in it, and how far its roots are off.
//
// Fast states f beside the rigid body r. With X = A_ff^-1 A_fr they follow it as x_f = -X x_r - A_ff^-1 X x_r' + ...
//   quasi_steady  drops the second term: A = A_rr - A_rf X (reduction.hpp);
//   first_order   keeps it: (I + A_rf A_ff^-1 X) x_r' = (A_rr - A_rf X) x_r + (B_r - A_rf A_ff^-1 B_f) u.
// Both have the steady response of the full model; only the second the lag of the downwash, which damps the short period.
#pragma once

#include "tiltrotor/analysis/linear/modes.hpp"

namespace tiltrotor {

enum class Reduction : unsigned char { first_order, quasi_steady };

template <class R>
struct RigidModelWorkspace {
  ResidualisationWorkspace<R> residual;
  Matrix<R, kRigidStates, kRigidStates> inertia;  // I + A_rf A_ff^-1 X
  LU<R, kRigidStates> lu;
  Matrix<R, kRigidStates, kRigidStates + kMaxLinearControls> right, solved;
};

// The 8 rigid-body states of a full model. `reduced` is another object than `full`.
// Status: as residualise(). Cost: about n^3 multiplications.
template <class R>
Status rigid_model(const LinearModel<R>& full, Reduction order, RigidModelWorkspace<R>& work,
                   LinearModel<R>& reduced) {
  constexpr int r = kRigidStates;
  const Status quasi_steady = residualise(full, work.residual, reduced);
  const int fast = full.states - r;
  if (quasi_steady != Status::ok || order == Reduction::quasi_steady || fast == 0) return quasi_steady;
  auto& lag = work.residual.drive;  // A_ff^-1 X
  Status status = lu_solve(work.residual.lu, work.residual.response, r, lag);
  const int m = reduced.controls;
  for (int i = 0; i < r; ++i) {
    alignas(64) R row[decltype(work.residual.drive)::kStride] = {};
    row[i] = R(1);
    for (int k = 0; k < fast; ++k) padded::add_scaled(full.a(i, r + k), lag.row(k), row, 0, lane_ceil<R>(r));
    for (int j = 0; j < r; ++j) {
      work.inertia(i, j) = row[j];
      work.right(i, j) = reduced.a(i, j);
    }
    for (int j = 0; j < m; ++j) work.right(i, r + j) = reduced.b(i, j);
  }
  if (status == Status::ok) status = lu_factor(work.inertia, r, work.lu);
  if (status == Status::ok) status = lu_solve(work.lu, work.right, r + m, work.solved);
  if (status != Status::ok) {
    clear(reduced);
    return status;
  }
  for (int i = 0; i < r; ++i) {
    for (int j = 0; j < r; ++j) reduced.a(i, j) = work.solved(i, j);
    for (int j = 0; j < m; ++j) reduced.b(i, j) = work.solved(i, r + j);
  }
  return Status::ok;
}

// The root of the full model that a root of a reduced one stands for.
template <class R>
struct FullRoot {
  R real, imag;  // 1/s
  R error;       // |root - full| / |full|; infinite beside a root at zero
};

// of[k]: of eigenvalue k of a reduced model, among those of the full one. Nearest ones belong together, the surest first;
// each serves once. NaN where `known` has too few. Cost: states of both, times those of the reduced one.
template <class R, int N, int kRoots>
void find_full_roots(const Eigenvalues<R, N>& known, const Eigenvalues<R, N>& root,
                     FullRoot<R> (&of)[kRoots]) {
  bool used[N] = {}, found[N] = {};
  const R nan = std::numeric_limits<R>::quiet_NaN();
  for (FullRoot<R>& none : of) none = {nan, nan, nan};
  const auto distance = [&](int k, int i) {
    const R x = root.real[k] - known.real[i], y = root.imag[k] - known.imag[i];
    return tiltrotor::sqrt(x * x + y * y);
  };
  for (int pass = 0; pass < root.size; ++pass) {
    int best = -1, its = -1;
    for (int k = 0; k < root.size; ++k)
      for (int i = 0; i < known.size; ++i)
        if (!found[k] && !used[i] && (best < 0 || distance(k, i) < distance(best, its))) best = k, its = i;
    if (best < 0) return;
    found[best] = used[its] = true;
    const R x = known.real[its], y = known.imag[its];
    of[best] = {x, y, distance(best, its) / tiltrotor::sqrt(x * x + y * y)};
  }
}
template <class R>
void find_full_roots(const ModeSet<R>& full, const ModeSet<R>& reduced, FullRoot<R> (&of)[kMaxLinearStates]) {
  find_full_roots(full.system.values, reduced.system.values, of);
}

}  // namespace tiltrotor

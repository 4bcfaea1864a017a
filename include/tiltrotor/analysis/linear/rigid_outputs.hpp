// Outputs of the rigid body alone: the fast states that y = C x + D u reads follow as in rigid_model.hpp,
//   x_f = -X x_r - A_ff^-1 B_f u - A_ff^-1 X x_r',   the last term to first order alone.
#pragma once

#include "tiltrotor/analysis/linear/rigid_model.hpp"

namespace tiltrotor {

// Rows of C and D of the full model become those of the reduced one; `work` and `reduced` as rigid_model() left them.
// Cost: rows (states - 8)(8 + controls) multiplications.
template <class R, class C, class D>
void reduce_outputs(const LinearModel<R>& full, Reduction order, const RigidModelWorkspace<R>& work,
                    const LinearModel<R>& reduced, int rows, C& c, D& d) {
  constexpr int r = kRigidStates;
  const bool lags = order == Reduction::first_order;
  const auto& lag = work.residual.drive;  // A_ff^-1 X
  for (int f = 0; f < full.states - r; ++f) {
    R by_state[r], by_control[kMaxLinearControls];
    for (int j = 0; j < r; ++j) by_state[j] = work.residual.response(f, j);
    for (int v = 0; v < reduced.controls; ++v) by_control[v] = work.residual.response(f, r + v);
    for (int l = 0; lags && l < r; ++l) {
      for (int j = 0; j < r; ++j) by_state[j] += lag(f, l) * reduced.a(l, j);
      for (int v = 0; v < reduced.controls; ++v) by_control[v] += lag(f, l) * reduced.b(l, v);
    }
    for (int i = 0; i < rows; ++i) {
      const R reads = c(i, r + f);
      for (int j = 0; j < r; ++j) c(i, j) -= reads * by_state[j];
      for (int v = 0; v < reduced.controls; ++v) d(i, v) -= reads * by_control[v];
    }
  }
}

}  // namespace tiltrotor

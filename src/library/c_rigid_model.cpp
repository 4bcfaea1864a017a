// The C interface: the linear model of the rigid body alone, whose modes are cheap.
#include "library/c_linear.hpp"
#include "library/c_words.hpp"
#include "tiltrotor/analysis/linear/rigid_model.hpp"

namespace tiltrotor::c_interface {

namespace {

struct RigidCallWorkspace {
  RigidModelWorkspace<R> workspace;
  LinearModel<R> full, reduced;
};
static_assert(sizeof(RigidCallWorkspace) <= kWorkBytes);

}  // namespace

}  // namespace tiltrotor::c_interface

namespace tiltrotor::c_interface::checked {

tr_status tr_rigid_model(tr_work* work, const tr_linear_shape* shape, const tr_real* a, size_t a_length,
                         const tr_real* b, size_t b_length, tr_linear_shape* reduced_shape,
                         tr_real* reduced_a, size_t reduced_a_length, tr_real* reduced_b,
                         size_t reduced_b_length) {
  if (work == nullptr || shape == nullptr || a == nullptr || reduced_shape == nullptr) return TR_BAD_ARGUMENT;
  if (!plausible(*shape) || shape->states > kMaxLinearStates) return TR_BAD_ARGUMENT;
  for (int i = 0; i < kRigidStates; ++i)
    if (shape->state[i] != kRigidOrder[i]) return TR_BAD_ARGUMENT;
  const bool wants_b = b != nullptr || b_length > 0 || reduced_b != nullptr || reduced_b_length > 0;
  if (wants_b && (b == nullptr || shape->controls < 0 || shape->controls > kMaxLinearControls))
    return TR_BAD_ARGUMENT;
  const auto n = static_cast<std::size_t>(shape->states);
  const std::size_t m = wants_b ? static_cast<std::size_t>(shape->controls) : 0;
  if (a_length < n * n || b_length < n * m) return TR_SHORT_BUFFER;
  if (!is_ieee_arithmetic<R>()) return TR_BAD_ARITHMETIC;
  RigidCallWorkspace& call = workspace_in<RigidCallWorkspace>(work);
  LinearModel<R>& full = call.full;
  clear(full);
  full.states = shape->states;
  full.controls = static_cast<int>(m);
  for (int i = 0; i < full.states; ++i) {
    full.state[i] = shape->state[i];
    for (int j = 0; j < full.states; ++j) full.a(i, j) = *a++;
    for (int j = 0; j < full.controls; ++j) full.b(i, j) = *b++;
  }
  for (int j = 0; j < full.controls; ++j) full.control[j] = shape->control[j];
  put_shape(kRigidStates, full.state, full.controls, full.control, *reduced_shape);
  const LinearArrays to = {reduced_a, reduced_a_length, reduced_b, reduced_b_length};
  const tr_status fits = check_arrays(kRigidStates, full.controls, to);
  if (fits != TR_OK) return fits;
  const Status status = rigid_model(full, Reduction::first_order, call.workspace, call.reduced);
  if (status != Status::ok) return translated(status);
  for (int i = 0; i < kRigidStates; ++i) {
    for (int j = 0; j < kRigidStates; ++j) *reduced_a++ = call.reduced.a(i, j);
    for (int j = 0; j < full.controls; ++j) *reduced_b++ = call.reduced.b(i, j);
  }
  return TR_OK;
}

}  // namespace tiltrotor::c_interface::checked

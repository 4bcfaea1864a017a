// The C interface: the linear model of the rigid body, with the systems where there are any, whose modes are cheap.
#include "library/c_linear.hpp"
#include "library/c_words.hpp"
#include "tiltrotor/analysis/linear/vehicle_reduction.hpp"

namespace tiltrotor::c_interface {

namespace {

using RigidCallWorkspace = VehicleReductionWorkspace<R>;
static_assert(kWorkBytes<RigidCallWorkspace> <= sizeof(tr_work));

// A matrix of the caller, by rows without gaps.
struct GivenMatrix {
  const R* entry;
  int columns;
  R operator()(int i, int j) const { return entry[i * columns + j]; }
};

}  // namespace

const std::size_t kRigidModelWorkBytes = kWorkBytes<RigidCallWorkspace>;

}  // namespace tiltrotor::c_interface

namespace tiltrotor::c_interface::checked {

tr_status tr_rigid_model(tr_work* work, const tr_linear_shape* shape, const tr_real* a, size_t a_length,
                         const tr_real* b, size_t b_length, tr_linear_shape* reduced_shape,
                         tr_real* reduced_a, size_t reduced_a_length, tr_real* reduced_b,
                         size_t reduced_b_length) {
  if (work == nullptr || shape == nullptr || a == nullptr || reduced_shape == nullptr) return TR_BAD_ARGUMENT;
  if (!plausible(*shape)) return TR_BAD_ARGUMENT;
  for (int i = 0; i < kRigidStates; ++i)
    if (shape->state[i] != kRigidOrder[i]) return TR_BAD_ARGUMENT;
  const bool wants_b = b != nullptr || b_length > 0 || reduced_b != nullptr || reduced_b_length > 0;
  if (wants_b && (b == nullptr || shape->controls < 0 || shape->controls > TR_INPUTS)) return TR_BAD_ARGUMENT;
  VehicleShape of;
  of.states = shape->states;
  of.inputs = wants_b ? shape->controls : 0;
  for (int i = 0; i < of.states; ++i) of.state[i] = shape->state[i];
  for (int j = 0; j < of.inputs; ++j) of.input[j] = shape->control[j];
  const auto n = static_cast<std::size_t>(of.states), m = static_cast<std::size_t>(of.inputs);
  if (a_length < n * n || b_length < n * m) return TR_SHORT_BUFFER;
  if (!is_ieee_arithmetic<R>()) return TR_BAD_ARITHMETIC;
  VehicleShape slow = of;
  keep_slow_states(slow);
  put_shape(slow.states, slow.state, slow.inputs, slow.input, *reduced_shape);
  const LinearArrays to = {reduced_a, reduced_a_length, reduced_b, reduced_b_length};
  const tr_status fits = check_arrays(slow.states, slow.inputs, to);
  if (fits != TR_OK) return fits;
  RigidCallWorkspace& call = workspace_in<RigidCallWorkspace>(work);
  const Status status =
      find_slow_model(Reduction::first_order, of, GivenMatrix{a, of.states}, GivenMatrix{b, of.inputs}, call);
  if (status != Status::ok) return translated(status);
  for (int i = 0; i < slow.states; ++i) {
    for (int j = 0; j < slow.states; ++j) *reduced_a++ = call.slow(i, j);
    for (int j = 0; j < slow.inputs; ++j) *reduced_b++ = call.slow(i, slow.states + j);
  }
  return TR_OK;
}

}  // namespace tiltrotor::c_interface::checked

// The C interface: linear model, eigenvalues and modes.
#include "library/c_linear.hpp"

#include <cstring>

#include "library/c_fault.hpp"
#include "library/c_systems.hpp"
#include "library/c_words.hpp"

namespace tiltrotor::c_interface {

namespace {

bool has_systems(const tr_linear_shape& shape) {
  for (int i = 0; i < shape.states; ++i)
    if (shape.state[i] >= TR_DOWN) return true;
  return false;
}

constexpr std::size_t entries(int rows, int columns) {
  return static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
}

}  // namespace

bool plausible(const tr_linear_shape& shape) {
  if (shape.states < kRigidStates || shape.states > TR_MAX_LINEAR_STATES) return false;
  bool seen[vehicle_state_count] = {};
  for (int i = 0; i < shape.states; ++i) {
    const int state = shape.state[i];
    if (state < 0 || state >= TR_STATES || seen[state]) return false;
    if (vehicle_variable(state).facts().ignorable && state != TR_DOWN) return false;
    seen[state] = true;
  }
  for (const int state : kRigidOrder)
    if (!seen[state]) return false;
  for (int i = 0; i < state_count; ++i)
    if (seen[i] != seen[kStateVariables.partner[i]]) return false;
  return true;
}

const ControlSet* control_set(std::int32_t columns) {
  switch (columns) {
    case TR_INCEPTORS:
      return &kInceptors;
    case TR_BLADE_CONTROLS:
      return &kBladeControls;
    case TR_ALL_CONTROLS:
      return &kAllControls;
    default:
      return nullptr;
  }
}

void put_shape(int states, const int* state, int controls, const int* control, tr_linear_shape& shape) {
  shape.states = states;
  shape.controls = controls;
  for (int i = 0; i < TR_MAX_LINEAR_STATES; ++i) shape.state[i] = i < states ? state[i] : kNone;
  for (int j = 0; j < TR_INPUTS; ++j) shape.control[j] = j < controls ? control[j] : kNone;
}

tr_status check_arrays(int states, int controls, const LinearArrays& to) {
  const bool wants_b = to.b != nullptr || to.b_length > 0;
  const bool b_fits = !wants_b || to.b_length >= entries(states, controls);
  if (to.a_length < entries(states, states) || !b_fits) return TR_SHORT_BUFFER;
  return to.a == nullptr || (wants_b && to.b == nullptr) ? TR_BAD_ARGUMENT : TR_OK;
}

tr_status linearize_here(const Sim& s, tr_work* work, std::int32_t columns, tr_linear_shape* shape,
                         const LinearArrays& to, R* xdot) {
  const ControlSet* set = control_set(columns);
  const bool known = set != nullptr || columns == TR_ALL_INPUTS;
  if (work == nullptr || shape == nullptr || !known) return TR_BAD_ARGUMENT;
  if (has_systems(s)) return linearize_systems(s, work, columns, shape, to, xdot);
  // Without systems nothing follows a command: its columns are zero.
  const int commands = set == nullptr ? command_count : 0;
  if (set == nullptr) set = &kAllControls;
  const int inputs = set->count + commands;
  LinearCallWorkspace& call = workspace_in<LinearCallWorkspace>(work);
  LinearModel<R>& model = call.model;
  linear_states(s.configuration.setup.options, model);
  int input[vehicle_input_count];
  for (int j = 0; j < inputs; ++j) input[j] = j < set->count ? set->index[j] : j;
  put_shape(model.states, model.state, inputs, input, *shape);
  const tr_status fits = check_arrays(model.states, inputs, to);
  if (fits != TR_OK) return fits;
  const bool wants_b = to.b != nullptr;

  const Configuration<R>& c = equipped(s, call.configuration);
  const Status status = linearize(c, evaluated_state(s), s.u, *set, call.workspace, model);
  if (status != Status::ok && status != Status::not_finite) return translated(status);
  R* a = to.a;
  R* b = to.b;
  for (int i = 0; i < model.states; ++i) {
    for (int j = 0; j < model.states; ++j) *a++ = model.a(i, j);
    for (int j = 0; wants_b && j < inputs; ++j) *b++ = j < set->count ? model.b(i, j) : R(0);
  }
  for (int i = 0; i < TR_STATES; ++i) xdot[i] = i < state_count ? model.xdot[i] : R(0);
  return translated(status);
}

}  // namespace tiltrotor::c_interface

namespace tiltrotor::c_interface::checked {

tr_status tr_linearize(const tr_sim* sim, tr_work* work, int32_t columns, tr_linear_shape* shape, tr_real* a,
                       size_t a_length, tr_real* b, size_t b_length) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  R xdot[TR_STATES];
  return linearize_here(*opened(sim), work, columns, shape, {a, a_length, b, b_length}, xdot);
}

tr_status tr_eigenvalues(tr_work* work, const tr_real* a, size_t n, tr_real* real, tr_real* imag,
                         size_t length) {
  if (work == nullptr || a == nullptr || real == nullptr || imag == nullptr) return TR_BAD_ARGUMENT;
  if (n < 1 || n > TR_MAX_LINEAR_STATES) return TR_BAD_ARGUMENT;
  if (length < n) return TR_SHORT_BUFFER;
  if (!is_ieee_arithmetic<R>()) return TR_BAD_ARITHMETIC;
  EigenCallWorkspace& call = workspace_in<EigenCallWorkspace>(work);
  const int order = static_cast<int>(n);
  for (int i = 0; i < order; ++i)
    for (int j = 0; j < order; ++j) call.a(i, j) = *a++;
  const Status status = eigenvalues(call.a, order, call.workspace, call.values);
  if (status != Status::ok && status != Status::not_converged) return translated(status);
  for (int i = 0; i < order; ++i) {
    real[i] = call.values.real[i];
    imag[i] = call.values.imag[i];
  }
  return translated(status);
}

tr_status tr_modes(tr_work* work, const tr_linear_shape* shape, const tr_real* a, size_t a_length,
                   tr_mode* modes, size_t capacity, size_t* count) {
  if (work == nullptr || shape == nullptr || a == nullptr || modes == nullptr || count == nullptr)
    return TR_BAD_ARGUMENT;
  if (!plausible(*shape)) return TR_BAD_ARGUMENT;
  if (a_length < entries(shape->states, shape->states)) return TR_SHORT_BUFFER;
  if (!is_ieee_arithmetic<R>()) return TR_BAD_ARITHMETIC;
  if (has_systems(*shape)) return modes_of_systems(work, *shape, a, modes, capacity, count);
  ModesCallWorkspace& call = workspace_in<ModesCallWorkspace>(work);
  LinearModel<R>& model = call.model;
  clear(model);
  model.states = shape->states;
  for (int i = 0; i < model.states; ++i) {
    model.state[i] = shape->state[i];
    for (int j = 0; j < model.states; ++j) model.a(i, j) = *a++;
  }
  const Status status = tiltrotor::modes(model, call.workspace, call.set);
  if (status != Status::ok) return translated(status);
  *count = static_cast<std::size_t>(call.set.count);
  if (capacity < *count) return TR_SHORT_BUFFER;
  for (int i = 0; i < call.set.count; ++i) {
    const Mode<R>& mode = call.set.mode[i];
    static_assert(sizeof(modes->name) == sizeof(mode.name));
    modes[i].real = mode.real;
    modes[i].imag = mode.imag;
    modes[i].frequency_radps = mode.frequency;
    modes[i].damping_ratio = mode.damping_ratio;
    modes[i].time_to_half_s = mode.time_to_half;
    std::memcpy(modes[i].name, mode.name, sizeof mode.name);
  }
  return TR_OK;
}

}  // namespace tiltrotor::c_interface::checked

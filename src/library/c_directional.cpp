// The C interface: rates and outputs along a direction, and the outputs of the linear model.
#include "library/c_linear.hpp"
#include "library/c_outputs.hpp"
#include "library/c_systems.hpp"
#include "library/c_words.hpp"

namespace tiltrotor::c_interface {

namespace {

// Rates and outputs along dx and du, of which `inputs` are given.
tr_status direction(const tr_sim* sim, tr_work* work, const R* dx, const R* du, int inputs, R* dxdot,
                    tr_outputs* doutputs) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  if (work == nullptr || dx == nullptr || du == nullptr || dxdot == nullptr || doutputs == nullptr)
    return TR_BAD_ARGUMENT;
  const Sim& s = *opened(sim);
  if (!all_finite(dx, TR_STATES) || !all_finite(du, static_cast<std::size_t>(inputs))) return TR_NOT_FINITE;
  R readings[kReadings];
  tr_status status;
  if (has_systems(s)) {
    R all[TR_INPUTS] = {};
    for (int j = 0; j < inputs; ++j) all[j] = du[j];
    status = direction_of_systems(s, work, dx, all, dxdot, readings);
    if (status != TR_OK && status != TR_NOT_FINITE) return status;
  } else {
    // Without systems nothing follows a command.
    DirectionalCallWorkspace& call = workspace_in<DirectionalCallWorkspace>(work);
    const Configuration<R>& c = equipped(s, call.configuration);
    for (int i = state_count; i < TR_STATES; ++i) dxdot[i] = R(0);
    status = translated(directional(c, evaluated_state(s), s.u, dx, du, call.workspace, dxdot, readings));
  }
  put_outputs(0, readings, *doutputs);
  return status;
}

}  // namespace

}  // namespace tiltrotor::c_interface

namespace tiltrotor::c_interface::checked {

tr_status tr_directional(const tr_sim* sim, tr_work* work, const tr_real* dx, const tr_real* du,
                         tr_real* dxdot, tr_outputs* doutputs) {
  return direction(sim, work, dx, du, TR_CONTROLS, dxdot, doutputs);
}

tr_status tr_directional_inputs(const tr_sim* sim, tr_work* work, const tr_real* dx, const tr_real* du,
                                tr_real* dxdot, tr_outputs* doutputs) {
  return direction(sim, work, dx, du, TR_INPUTS, dxdot, doutputs);
}

tr_status tr_linearize_outputs(const tr_sim* sim, tr_work* work, int32_t columns, tr_real* c, size_t c_length,
                               tr_real* d, size_t d_length) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  const ControlSet* set = control_set(columns);
  const bool known = set != nullptr || columns == TR_ALL_INPUTS;
  if (work == nullptr || !known) return TR_BAD_ARGUMENT;
  const Sim& s = *opened(sim);
  if (has_systems(s)) return outputs_of_systems(s, work, columns, {c, c_length, d, d_length});
  // Without systems nothing follows a command: its columns are zero.
  const int commands = set == nullptr ? command_count : 0;
  if (set == nullptr) set = &kAllControls;
  OutputsCallWorkspace& call = workspace_in<OutputsCallWorkspace>(work);
  linear_states(s.configuration.setup.options, call.point);
  const auto states = static_cast<std::size_t>(call.point.states);
  const auto inputs = static_cast<std::size_t>(set->count + commands);
  const tr_status fits = check_output_arrays(states, inputs, {c, c_length, d, d_length});
  if (fits != TR_OK) return fits;

  bool finite = true;
  const auto put = [&finite](R* to, int row, int column, std::size_t width, R slope) {
    if (to == nullptr) return;
    finite = finite && is_finite(slope);
    to[static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column)] = slope;
  };
  for (int i = 0; i < static_cast<int>(kReadings); ++i)
    for (int j = set->count; j < set->count + commands; ++j) put(d, i, j, inputs, R(0));
  const Status status = linearize_outputs(
      equipped(s, call.configuration), evaluated_state(s), s.u, *set, call.workspace, call.point,
      [&](int i, int j, R slope) { put(c, i, j, states, slope); },
      [&](int i, int j, R slope) { put(d, i, j, inputs, slope); });
  if (status != Status::ok) return translated(status);
  return finite ? TR_OK : TR_NOT_FINITE;
}

}  // namespace tiltrotor::c_interface::checked

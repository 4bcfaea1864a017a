// The C interface: rates and outputs along a direction, and the outputs of the linear model.
#include "library/c_linear.hpp"
#include "library/c_outputs.hpp"
#include "library/c_systems.hpp"
#include "library/c_words.hpp"

namespace tiltrotor::c_interface::checked {

tr_status tr_directional(const tr_sim* sim, tr_work* work, const tr_real* dx, const tr_real* du,
                         tr_real* dxdot, tr_outputs* doutputs) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  if (work == nullptr || dx == nullptr || du == nullptr || dxdot == nullptr || doutputs == nullptr)
    return TR_BAD_ARGUMENT;
  if (has_systems(*opened(sim))) return TR_BAD_ARGUMENT;
  if (!all_finite(dx, TR_STATES) || !all_finite(du, TR_CONTROLS)) return TR_NOT_FINITE;
  const Sim& s = *opened(sim);
  DirectionalCallWorkspace& call = workspace_in<DirectionalCallWorkspace>(work);
  const Configuration<R>& c = equipped(s, call.configuration);
  R readings[kReadings];
  for (int i = state_count; i < TR_STATES; ++i) dxdot[i] = R(0);
  const Status status = directional(c, evaluated_state(s), s.u, dx, du, call.workspace, dxdot, readings);
  put_outputs(0, readings, *doutputs);
  return translated(status);
}

tr_status tr_linearize_outputs(const tr_sim* sim, tr_work* work, int32_t columns, tr_real* c, size_t c_length,
                               tr_real* d, size_t d_length) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  const ControlSet* set = control_set(columns);
  if (work == nullptr || set == nullptr) return TR_BAD_ARGUMENT;
  const Sim& s = *opened(sim);
  if (has_systems(s)) return TR_BAD_ARGUMENT;
  OutputsCallWorkspace& call = workspace_in<OutputsCallWorkspace>(work);
  linear_states(s.configuration.setup.options, call.point);
  const auto states = static_cast<std::size_t>(call.point.states);
  const auto controls = static_cast<std::size_t>(set->count);
  const bool wants_d = d != nullptr || d_length > 0;
  if (c_length < kReadings * states || (wants_d && d_length < kReadings * controls)) return TR_SHORT_BUFFER;
  if (c == nullptr || (wants_d && d == nullptr)) return TR_BAD_ARGUMENT;

  const auto place = [](int row, int column, std::size_t width) {
    return static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column);
  };
  bool finite = true;
  const auto put_c = [&](int i, int j, R slope) {
    finite = finite && is_finite(slope);
    c[place(i, j, states)] = slope;
  };
  const auto put_d = [&](int i, int j, R slope) {
    if (!wants_d) return;
    finite = finite && is_finite(slope);
    d[place(i, j, controls)] = slope;
  };
  const Status status = linearize_outputs(equipped(s, call.configuration), evaluated_state(s), s.u, *set,
                                          call.workspace, call.point, put_c, put_d);
  if (status != Status::ok) return translated(status);
  return finite ? TR_OK : TR_NOT_FINITE;
}

}  // namespace tiltrotor::c_interface::checked

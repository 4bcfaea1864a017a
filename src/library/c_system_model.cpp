// The C interface: linear model and modes of the aircraft with its systems.
#include <cstring>

#include "library/c_linear.hpp"
#include "library/c_system_model.hpp"
#include "library/c_words.hpp"
#include "tiltrotor/analysis/linear/vehicle_modes.hpp"

namespace tiltrotor {
TILTROTOR_SYSTEM_INSTANCES()
}  // namespace tiltrotor

namespace tiltrotor::c_interface {

namespace {

static_assert(int{TR_MAX_LINEAR_STATES} == kMaxVehicleStates);

struct VehicleCallWorkspace {
  Configuration<R> configuration;
  VehicleModelWorkspace<R> model;
};
struct VehicleModesCallWorkspace {
  VehicleModesWorkspace<R> modes;
  VehicleModes<R> found;
};
// Eigenvectors of all states need more than a microcontroller's work area.
constexpr bool kModesFit = kWorkBytes<VehicleModesCallWorkspace> <= sizeof(tr_work);
static_assert(kWorkBytes<VehicleCallWorkspace> <= sizeof(tr_work));

}  // namespace

const std::size_t kSystemModelWorkBytes = kModesFit
                                              ? kWorkBytes<VehicleCallWorkspace, VehicleModesCallWorkspace>
                                              : kWorkBytes<VehicleCallWorkspace>;

void shape_of_systems(const Sim& s, std::int32_t columns, VehicleShape& of) {
  vehicle_states(s.systems.vehicle, s.configuration.setup.options, of);
  of.inputs = columns == TR_ALL_INPUTS ? int{TR_INPUTS} : control_set(columns)->count;
  for (int j = 0; j < of.inputs; ++j)
    of.input[j] = columns == TR_ALL_INPUTS ? j : control_set(columns)->index[j];
}

Configuration<R>& equipped_in_air(const Sim& s, Configuration<R>& c) {
  equipped(s, c);
  c.around = with_turbulence(c, evaluated_state(s), s.u, s.systems.vehicle, s.systems.state);
  return c;
}

tr_status linearize_systems(const Sim& s, tr_work* work, std::int32_t columns, tr_linear_shape* shape,
                            const LinearArrays& to, R* xdot) {
  VehicleCallWorkspace& call = workspace_in<VehicleCallWorkspace>(work);
  const Vehicle<R>& v = s.systems.vehicle;
  VehicleShape of;
  shape_of_systems(s, columns, of);
  put_shape(of.states, of.state, of.inputs, of.input, *shape);
  const tr_status fits = check_arrays(of.states, of.inputs, to);
  if (fits != TR_OK) return fits;

  const auto at = [](int row, int column, int width) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  };
  const bool wants_b = to.b != nullptr;
  State<R> rates{};
  SystemState<R> system_rates{};
  const Status status = linearize_vehicle(
      v, equipped_in_air(s, call.configuration), evaluated_state(s), s.systems.state, s.u, of, call.model,
      rates, system_rates,
      [&](int i, int j, int count, const R* slope) { copy_row(slope, count, to.a + at(i, j, of.states)); },
      [&](int i, int j, int count, const R* slope) {
        if (wants_b) copy_row(slope, count, to.b + at(i, j, of.inputs));
      });
  flatten(rates, xdot);
  flatten(system_rates, xdot + state_count);
  return translated(status);
}

tr_status modes_of_systems(tr_work* work, const tr_linear_shape& shape, const R* a, tr_mode* modes,
                           std::size_t capacity, std::size_t* count) {
  if constexpr (kModesFit) {
    VehicleModesCallWorkspace& call = workspace_in<VehicleModesCallWorkspace>(work);
    VehicleShape of{};
    of.states = shape.states;
    set_zero(call.modes.a);
    for (int i = 0; i < of.states; ++i) {
      of.state[i] = shape.state[i];
      for (int j = 0; j < of.states; ++j) call.modes.a(i, j) = *a++;
    }
    const Status status = vehicle_modes(of, call.modes, call.found);
    if (status != Status::ok) return translated(status);
    *count = static_cast<std::size_t>(call.found.count);
    if (capacity < *count) return TR_SHORT_BUFFER;
    for (int i = 0; i < call.found.count; ++i) {
      const VehicleMode<R>& mode = call.found.mode[i];
      modes[i] = {mode.real, mode.imag, mode.frequency, mode.damping_ratio, mode.time_to_half, {}};
      std::memcpy(modes[i].name, mode.name, sizeof mode.name);
    }
    return TR_OK;
  }
  return TR_BAD_ARGUMENT;
}

}  // namespace tiltrotor::c_interface

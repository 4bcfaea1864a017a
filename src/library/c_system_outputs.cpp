// The C interface: rates and outputs of the aircraft with its systems along a direction, and C and D.
#include "library/c_outputs.hpp"
#include "library/c_system_model.hpp"
#include "library/c_words.hpp"
#include "tiltrotor/analysis/linear/vehicle_direction.hpp"

namespace tiltrotor::c_interface {

namespace {

struct VehicleDirectionCallWorkspace {
  Configuration<R> configuration;
  VehicleDirectionWorkspace<R> direction;
  VehicleShape shape;
};
static_assert(kWorkBytes<VehicleDirectionCallWorkspace> <= sizeof(tr_work));

}  // namespace

const std::size_t kSystemOutputsWorkBytes = kWorkBytes<VehicleDirectionCallWorkspace>;

tr_status direction_of_systems(const Sim& s, tr_work* work, const R* dx, const R* du, R* dxdot,
                               R* dreadings) {
  VehicleDirectionCallWorkspace& call = workspace_in<VehicleDirectionCallWorkspace>(work);
  return translated(vehicle_direction(s.systems.vehicle, equipped_in_air(s, call.configuration),
                                      evaluated_state(s), s.systems.state, s.u, dx, du, call.direction, dxdot,
                                      dreadings));
}

tr_status outputs_of_systems(const Sim& s, tr_work* work, std::int32_t columns, const OutputArrays& to) {
  VehicleDirectionCallWorkspace& call = workspace_in<VehicleDirectionCallWorkspace>(work);
  VehicleShape& of = call.shape;
  shape_of_systems(s, columns, of);
  const auto states = static_cast<std::size_t>(of.states), inputs = static_cast<std::size_t>(of.inputs);
  const tr_status fits = check_output_arrays(states, inputs, to);
  if (fits != TR_OK) return fits;
  if (to.d == nullptr) of.inputs = 0;
  const auto at = [](int row, int column, std::size_t width) {
    return static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column);
  };
  return translated(linearize_vehicle_outputs(
      s.systems.vehicle, equipped_in_air(s, call.configuration), evaluated_state(s), s.systems.state, s.u, of,
      call.direction, [&](int i, int j, R slope) { to.c[at(i, j, states)] = slope; },
      [&](int i, int j, R slope) { to.d[at(i, j, inputs)] = slope; }));
}

}  // namespace tiltrotor::c_interface

// The C interface: steps of time.
#include "library/c_fault.hpp"
#include "library/c_linear.hpp"
#include "library/c_outputs.hpp"
#include "library/c_state.hpp"
#include "library/c_systems.hpp"
#include "library/c_words.hpp"

namespace tiltrotor::c_interface {

namespace {

constexpr R kLongestFrame = R(0.02);  // s
constexpr R kLongestOfRk3 = R(0.01);  // s; beyond, RK4 does with fewer parts of a step

tr_status check_step(Sim& s, const tr_work* work, R dt) {
  if (work == nullptr) return noted(s, TR_BAD_ARGUMENT);
  if (!is_finite(dt)) return noted(s, TR_NOT_FINITE);
  return dt > R(0) && dt <= kLongestFrame ? TR_OK : noted(s, TR_OUT_OF_RANGE);
}

// One step; `xdot`: the rates at its beginning, or nullptr.
tr_status step(Sim& s, tr_work* work, R dt, const R* xdot) {
  StepCallWorkspace& call = workspace_in<StepCallWorkspace>(work);
  const Configuration<R>& c = equipped(s, call.configuration);
  const bool systems = has_systems(s);
  MovingConfiguration<R> moving{&call.configuration, s.air.follows, s.air.altitude, {}, 0};
  const Integrator integrator = dt <= kLongestOfRk3 ? Integrator::rk3 : Integrator::rk4;
  const double time = s.time + static_cast<double>(dt);
  if (time > kLongestFlight || s.steps >= kMostSteps) return noted(s, TR_OUT_OF_RANGE);
  // The model depends on time by its setting alone, which is kept: every step begins a simulation of its own, and time
  // is counted here.
  const Status started = start(c, s.x, s.u, dt, integrator, call.simulation);
  if (started != Status::ok) return noted(s, translated(started));
  call.simulation.travel = s.travel;
  SystemFlight<R> flight = s.systems;
  flight.steps = s.steps;
  const Status advanced =
      systems ? advance_vehicle(call.configuration, flight, call.workspace, call.simulation, xdot)
              : advance_moving(moving, call.workspace, call.simulation, xdot);
  if (advanced != Status::ok) return noted(s, translated(advanced), call.simulation.fault_state);
  if (systems || is_moving<R>(s.configuration.setup) || s.air.follows) keep(call.configuration, s);
  s.systems = flight;
  s.x = call.simulation.state;
  s.travel = call.simulation.travel;
  s.time = time;
  ++s.steps;
  return TR_OK;
}

}  // namespace

}  // namespace tiltrotor::c_interface

namespace tiltrotor::c_interface::checked {

tr_status tr_step(tr_sim* sim, tr_work* work, tr_real dt) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  Sim& s = *opened(sim);
  const tr_status possible = check_step(s, work, dt);
  return possible == TR_OK ? step(s, work, dt, nullptr) : possible;
}

tr_status tr_step_with_outputs(tr_sim* sim, tr_work* work, tr_real dt, tr_outputs* outputs) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  Sim& s = *opened(sim);
  const tr_status possible = check_step(s, work, dt);
  if (possible != TR_OK) return possible;
  if (outputs == nullptr) return noted(s, TR_BAD_ARGUMENT);
  Found found;
  const tr_status read =
      outputs_here(workspace_in<StepCallWorkspace>(work).configuration, s, *outputs, found);
  R xdot[TR_STATES];
  flatten_rates(found, xdot);
  return read == TR_OK ? step(s, work, dt, xdot) : noted(s, read, first_not_finite(xdot, TR_STATES));
}

tr_status tr_linearize_and_step(tr_sim* sim, tr_work* work, tr_real dt, int32_t columns,
                                tr_linear_shape* shape, tr_real* a, size_t a_length, tr_real* b,
                                size_t b_length) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  Sim& s = *opened(sim);
  const tr_status possible = check_step(s, work, dt);
  if (possible != TR_OK) return possible;
  R xdot[TR_STATES];
  const tr_status linear = linearize_here(s, work, columns, shape, {a, a_length, b, b_length}, xdot);
  if (linear == TR_OK) return step(s, work, dt, xdot);
  return noted(s, linear, linear == TR_NOT_FINITE ? first_not_finite(xdot, TR_STATES) : kNone);
}

}  // namespace tiltrotor::c_interface::checked

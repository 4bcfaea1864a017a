// The C interface: a step by the exponential of A, which is at hand.
#include "library/c_fault.hpp"
#include "library/c_linear.hpp"
#include "library/c_state.hpp"
#include "library/c_systems.hpp"
#include "library/c_words.hpp"
#include "tiltrotor/model/variables/control_range.hpp"

namespace tiltrotor::c_interface {

namespace {

constexpr R kLongestFrame = R(0.04);  // s

struct ExponentialCallWorkspace {
  Configuration<R> configuration;
  SimulationWorkspace<R, KnownJacobian> workspace;
  Simulation<R> simulation;
};
static_assert(kWorkBytes<ExponentialCallWorkspace> <= kOwnWorkBytes);

// Rows of heading and position, on which nothing else depends: the kinematics of the rigid body. Their columns are
// those of velocity, rates, bank, pitch and heading, the first nine states.
void add_kinematics(const Configuration<R>& c, const State<R>& x, const ActiveStates& active,
                    Matrix<R, state_count, state_count>& jacobian) {
  constexpr int kColumns = flight_step::kYaw + 1;
  using T = Dual<R, kColumns>;
  R flat[state_count];
  flatten(x, flat);
  T at[kColumns];
  for (int j = 0; j < kColumns; ++j) at[j] = T::variable(flat[j], j);
  const Vec3<T> velocity = {at[0], at[1], at[2]}, rates = {at[3], at[4], at[5]};
  const RigidBodyRates<T> body = rigid_body(c.mass, velocity, rates, at[6], at[7], at[8], Loads<T>{});
  for (int k = 0; k < active.count; ++k) {
    const int state = active.index[k];
    const T* row = state == kStateIndex.yaw          ? &body.yaw
                   : state == kStateIndex.position.x ? &body.position.x
                   : state == kStateIndex.position.y ? &body.position.y
                   : state == kStateIndex.position.z ? &body.position.z
                                                     : nullptr;
    for (int j = 0; row != nullptr && j < kColumns; ++j) jacobian(k, j) = row->d.get(j);
  }
}

// A and B by rows into the Jacobian of the states that are alive, and into what ramping controls add.
void place_model(const tr_linear_shape& shape, const R* a, const R* b, const R* control_rates,
                 SimulationWorkspace<R, KnownJacobian>& work) {
  int place[state_count];
  for (int k = 0; k < work.active.count; ++k) place[work.active.index[k]] = k;
  set_zero(work.jacobian);
  for (R& ramp : work.differentiation.ramp) ramp = R(0);
  for (int i = 0; i < shape.states; ++i) {
    const int row = place[shape.state[i]];
    for (int j = 0; j < shape.states; ++j) work.jacobian(row, place[shape.state[j]]) = *a++;
    for (int j = 0; control_rates != nullptr && j < shape.controls; ++j)
      work.differentiation.ramp[row] += *b++ * control_rates[j];
  }
}

// Where ramping controls are at the end of the step.
tr_status ramped(const tr_linear_shape& shape, const R* control_rates, R dt, R* u, int& bad) {
  for (int j = 0; j < shape.controls; ++j) {
    const int control = shape.control[j];
    if (control >= control_count) {
      if (control_rates[j] != R(0)) return TR_BAD_ARGUMENT;
      continue;
    }
    bad = control;
    u[control] += dt * control_rates[j];
    if (!is_finite(u[control])) return TR_NOT_FINITE;
    const Bounds<R> range = control_range(aircraft_data<R>(), control);
    if (u[control] < range.low || u[control] > range.high) return TR_OUT_OF_RANGE;
  }
  bad = kNone;
  return TR_OK;
}

tr_status step(Sim& s, tr_work* work, R dt, const R* control_rates, const tr_linear_shape& shape, const R* a,
               const R* b, const R* xdot) {
  ExponentialCallWorkspace& call = workspace_in<ExponentialCallWorkspace>(work);
  const double time = s.time + static_cast<double>(dt);
  if (time > kLongestFlight || s.steps >= kMostSteps) return noted(s, TR_OUT_OF_RANGE);
  R u[control_count];
  flatten(s.u, u);
  if (control_rates != nullptr) {
    int bad = kNone;
    const tr_status possible = ramped(shape, control_rates, dt, u, bad);
    if (possible != TR_OK) return noted(s, possible, kNone, bad);
  }
  const Configuration<R>& c = equipped(s, call.configuration);
  MovingConfiguration<R> moving{&call.configuration, s.air.follows, s.air.altitude, {}, 0};
  const Status started = start(c, s.x, s.u, dt, Integrator::exponential, call.simulation);
  if (started != Status::ok) return noted(s, translated(started));
  call.simulation.travel = s.travel;
  call.workspace.active = active_states(c.setup.options, true);
  place_model(shape, a, b, control_rates, call.workspace);
  add_kinematics(c, evaluated_state(s), call.workspace.active, call.workspace.jacobian);
  const Status advanced = advance_moving(moving, call.workspace, call.simulation, xdot);
  if (advanced != Status::ok) return noted(s, translated(advanced), call.simulation.fault_state);
  if (is_moving<R>(s.configuration.setup) || s.air.follows) keep(call.configuration, s);
  s.x = call.simulation.state;
  s.travel = call.simulation.travel;
  unflatten(u, s.u);
  s.time = time;
  ++s.steps;
  return TR_OK;
}

}  // namespace

}  // namespace tiltrotor::c_interface

namespace tiltrotor::c_interface::checked {

tr_status tr_linearize_and_step_exponential(tr_sim* sim, tr_work* work, tr_real dt,
                                            const tr_real* control_rates, int32_t columns,
                                            tr_linear_shape* shape, tr_real* a, size_t a_length, tr_real* b,
                                            size_t b_length) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  Sim& s = *opened(sim);
  if (work == nullptr || has_systems(s) || (control_rates != nullptr && b == nullptr))
    return noted(s, TR_BAD_ARGUMENT);
  if (!is_finite(dt)) return noted(s, TR_NOT_FINITE);
  if (!(dt > R(0) && dt <= kLongestFrame)) return noted(s, TR_OUT_OF_RANGE);
  R xdot[TR_STATES];
  const tr_status linear = linearize_here(s, work, columns, shape, {a, a_length, b, b_length}, xdot);
  if (linear != TR_OK)
    return noted(s, linear, linear == TR_NOT_FINITE ? first_not_finite(xdot, TR_STATES) : kNone);
  tr_status stepped = TR_OK;
  out_of_line([&] { stepped = step(s, work, dt, control_rates, *shape, a, b, xdot); });
  return stepped;
}

}  // namespace tiltrotor::c_interface::checked

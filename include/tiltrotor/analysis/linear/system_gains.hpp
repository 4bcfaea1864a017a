// Gains of augmentation and governor by rule, from the linear model of a trimmed flight: what the tables hold.
#pragma once

#include "tiltrotor/analysis/linear/vehicle_model.hpp"
#include "tiltrotor/math/algebra/lu.hpp"

namespace tiltrotor {

template <class R>
struct SystemGains {
  R pitch, roll, yaw;        // in s/rad
  R proportional, integral;  // rad, rad/s
  R damping[3];              // of the bare aircraft in pitch, roll, yaw, rotors in their balance, 1/s
  R sensitivity[3];          // rad/s^2/in
};

template <class R>
struct SystemGainsWorkspace {
  VehicleModelWorkspace<R> model;
  Matrix<R, kMaxVehicleStates, kMaxVehicleStates> a;
  Matrix<R, kMaxVehicleStates, vehicle_input_count> b;
  Matrix<R, kMaxVehicleStates, kMaxVehicleStates> fast;
  LU<R, kMaxVehicleStates> lu;
};

// K = (1/tau - damping)/sensitivity for the rates; for the rotor speed, governor_gains(). Body and rotor speed are slow;
// rotors, wake and downwash are in their balance: A_ss - A_sf A_ff^-1 A_fs. Power of the engines is held.
// Status: ok; singular; those of linearize_vehicle().
template <class R>
Status system_gains(Configuration<R> c, const State<R>& x, const Controls<R>& u,
                    SystemGainsWorkspace<R>& work, SystemGains<R>& out) {
  Vehicle<R> v{};
  v.on.governor = Governor::pi;
  v.commands.rotor_speed = c.setup.rotor_speed;
  SystemState<R> s{};
  s.rotor_speed = c.setup.rotor_speed;
  VehicleShape shape;
  vehicle_states(v, c.setup.options, shape);
  shape.inputs = 3;
  shape.input[0] = kControlIndex.long_stick;
  shape.input[1] = kControlIndex.lat_stick;
  shape.input[2] = kControlIndex.pedal;
  // The power that the flight takes, so that its slope over the rotor speed is right.
  AirframeAnswer<R> bare;
  DerivativeSteps<R>& steps = *::new (static_cast<void*>(&work.model.stage)) DerivativeSteps<R>;
  VehicleAirframe<R>{c, x, steps, R(0)}({u, c.setup, {{R(1), R(1)}, R(1)}, {}}, bare);
  const R torque = bare.torque[right] + bare.torque[left];
  const R full = demanded_power(*c.aircraft, c.air, R(1));
  const R share = torque * c.setup.rotor_speed / (R(2) * c.aircraft->controls.transmission_efficiency * full);
  for (R& throttle : v.commands.throttle) throttle = share;
  State<R> rates;
  SystemState<R> system_rates;
  const Status status = linearize_vehicle(
      v, c, x, s, u, shape, work.model, rates, system_rates,
      [&](int i, int j, int count, const R* slope) { copy_row(slope, count, work.a.row(i) + j); },
      [&](int i, int j, int count, const R* slope) { copy_row(slope, count, work.b.row(i) + j); });
  if (status != Status::ok) return status;

  int row[vehicle_state_count];
  int fast[kMaxVehicleStates], fast_count = 0;
  for (int i = 0; i < shape.states; ++i) {
    row[shape.state[i]] = i;
    if (shape.state[i] < state_count && !is_rigid(shape.state[i])) fast[fast_count++] = i;
  }
  for (int i = 0; i < fast_count; ++i)
    for (int j = 0; j < fast_count; ++j) work.fast(i, j) = work.a(fast[i], fast[j]);
  const Status factored = lu_factor(work.fast, fast_count, work.lu);
  if (factored != Status::ok) return factored;
  // A row against a column, given by its entries, with the fast states in their balance.
  const auto settled = [&](int i, auto&& column) {
    R drive[kMaxVehicleStates];
    for (int k = 0; k < fast_count; ++k) drive[k] = column(fast[k]);
    if (lu_solve(work.lu, drive) != Status::ok) return std::numeric_limits<R>::quiet_NaN();
    R sum = column(i);
    for (int k = 0; k < fast_count; ++k) sum -= work.a(i, fast[k]) * drive[k];
    return sum;
  };
  const auto of_state = [&](int state, int by) {
    return settled(row[state], [&](int i) { return work.a(i, row[by]); });
  };
  const AugmentationTables<R>& t = c.aircraft->systems.augmentation;
  const int axis[3] = {kStateIndex.rates.y, kStateIndex.rates.x, kStateIndex.rates.z};
  const R time[3] = {t.pitch_time, t.roll_time, t.yaw_time};
  R* const gain[3] = {&out.pitch, &out.roll, &out.yaw};
  for (int k = 0; k < 3; ++k) {
    out.damping[k] = -of_state(axis[k], axis[k]);
    out.sensitivity[k] = std::fabs(settled(row[axis[k]], [&](int i) { return work.b(i, k); }));
    *gain[k] = (R(1) / time[k] - out.damping[k]) / out.sensitivity[k];
  }
  const int speed = state_count + kSystemIndex.rotor_speed, governor = state_count + kSystemIndex.governor;
  const R inertia = drive_inertia(*c.aircraft, 2);
  const GovernorGains<R> g =
      governor_gains(c.aircraft->systems.governor, inertia, c.setup.rotor_speed,
                     -inertia * of_state(speed, governor), -inertia * of_state(speed, speed));
  out.proportional = g.proportional;
  out.integral = g.integral;
  return Status::ok;
}

}  // namespace tiltrotor

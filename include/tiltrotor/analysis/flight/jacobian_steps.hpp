// Steps by the methods that use the Jacobian of the states that are alive: RODAS3 and the exponential.
#pragma once

#include "tiltrotor/analysis/flight/right_side.hpp"

namespace tiltrotor {

namespace flight_step {

// f and its Jacobian at the beginning of a step.
template <class R, class Policy>
void place_jacobian(const RightSide<R, Policy>& f, R time) {
  SimulationWorkspace<R, Policy>& work = f.work;
  const int n = work.active.count;
  const R azimuth = f.azimuth(time);
  f.place_configuration(time, work.x);
  for (int k = 0; k < n; ++k) work.scale[k] = state_scale<R>(work.active.index[k]);
  Policy::jacobian(
      [&f, azimuth](const auto& x, auto&& output) { f.evaluate(x, output, azimuth); },
      {n, n, work.x, work.scale, work.rates}, work.differentiation,
      [&work](int i, int j, int count, const R* slope) { copy_row(slope, count, work.jacobian.row(i) + j); });
}

// Blades that turn and masts that move make f depend on time; they carry no partials, so a central difference.
// nullptr where nothing does.
template <class R, class Policy>
const R* time_slope(const RightSide<R, Policy>& f, R time) {
  const Configuration<R>& c = f.c;
  if (c.setup.options.azimuth == AzimuthMode::averaged && f.moving == nullptr) return nullptr;
  SimulationWorkspace<R, Policy>& work = f.work;
  const int n = work.active.count;
  const R azimuth = f.azimuth(time);
  const R step = std::cbrt(std::numeric_limits<R>::epsilon());
  const R rotor_speed = c.setup.rotor_speed;
  f.place_configuration(time + step / rotor_speed, work.x);
  f.evaluate(PlainInputs<R>{work.x}, PlainOutputs<R>{work.ahead}, azimuth + step);
  f.place_configuration(time - step / rotor_speed, work.x);
  f.evaluate(PlainInputs<R>{work.x}, PlainOutputs<R>{work.behind}, azimuth - step);
  for (int k = 0; k < n; ++k) work.ahead[k] = rotor_speed * (work.ahead[k] - work.behind[k]) / (R(2) * step);
  return work.ahead;
}

template <class R, class Policy>
Status rodas3(const RightSide<R, Policy>& f, R time, R dt) {
  SimulationWorkspace<R, Policy>& work = f.work;
  place_jacobian(f, time);
  const R* slope = time_slope(f, time);
  return rodas3_step(f, work.jacobian, {time, dt, work.x, work.active.count, work.rates, slope},
                     work.method.rosenbrock);
}

// `known`: f at the beginning, where the Jacobian is known.
template <class R, class Policy>
Status exponential(const RightSide<R, Policy>& f, R time, R dt, const R* known) {
  SimulationWorkspace<R, Policy>& work = f.work;
  const int n = work.active.count;
  const R* slope = nullptr;
  if constexpr (std::is_same_v<Policy, KnownJacobian>) {
    if (known == nullptr) return Status::bad_argument;
    slope = time_slope(f, time);
    for (int k = 0; k < n; ++k) {
      work.scale[k] = state_scale<R>(work.active.index[k]);
      work.ahead[k] = work.differentiation.ramp[k] + (slope == nullptr ? R(0) : slope[k]);
    }
    slope = work.ahead;
  } else {
    place_jacobian(f, time);
    known = work.rates;
    slope = time_slope(f, time);
  }
  for (int k = 0; k < n; ++k)
    for (int l = n; l < work.jacobian.kStride; ++l) work.jacobian.row(k)[l] = R(0);
  return exponential_step(work.jacobian, work.scale, {time, dt, work.x, n, known, slope},
                          work.method.exponential);
}

}  // namespace flight_step

}  // namespace tiltrotor

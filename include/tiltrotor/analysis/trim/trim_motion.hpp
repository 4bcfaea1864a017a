// How a trim moves with a parameter: d state / dp and d controls / dp, exact.
//
// Along a trim f(z, p) = 0, z the unknowns: dz/dp = -(df/dz)^-1 df/dp. df/dz follows from A and B and from how velocity and
// body rates follow the attitude; df/dp, with state and controls held, is the caller's: of a parameter of the
// configuration a column of configuration_sensitivity().
#pragma once

#include "tiltrotor/analysis/linear/linear_model.hpp"
#include "tiltrotor/analysis/trim/trim_equations.hpp"
#include "tiltrotor/math/algebra/lu.hpp"

namespace tiltrotor {

// Per unit of the parameter.
template <class R>
struct TrimMotion {
  State<R> x;
  Controls<R> u;
};

template <class R>
struct TrimMotionWorkspace {
  TrimEquations<R> equations;
  Matrix<R, kMaxTrimUnknowns, kMaxTrimUnknowns> by_unknown;  // df/dz
  LU<R, kMaxTrimUnknowns> lu;
  R state[kMaxTrimUnknowns][state_count];  // d state / d unknown
};

// How velocity relative to the air, m/s, and body rates, rad/s, follow the attitude, rad; templates on the scalar.
template <class R>
struct SteadyMotion {
  const SteadyFlight<R>& flight;

  template <class T>
  Vec3<T> velocity(const T& roll, const T& pitch) const {
    return steady_velocity(flight, roll, pitch);
  }
  template <class T>
  Vec3<T> rates(const T& roll, const T& pitch) const {
    return steady_rates(flight, roll, pitch);
  }
};

namespace trim_motion_detail {

// The unknown itself, and what follows from roll and pitch.
template <class R, class Motion>
void state_slopes(const Motion& motion, const State<R>& x, int unknown, R* slope) {
  for (int i = 0; i < state_count; ++i) slope[i] = R(0);
  if (unknown < 0) return;
  slope[unknown] = R(1);
  if (unknown != kStateIndex.roll && unknown != kStateIndex.pitch) return;
  using D = Dual<R, 1>;
  D roll(x.roll), pitch(x.pitch);
  (unknown == kStateIndex.roll ? roll : pitch).d.set(0, R(1));
  const Vec3<D> velocity = motion.velocity(roll, pitch);
  const Vec3<D> rates = motion.rates(roll, pitch);
  slope[kStateIndex.velocity.x] = velocity.x.d.get(0);
  slope[kStateIndex.velocity.y] = velocity.y.d.get(0);
  slope[kStateIndex.velocity.z] = velocity.z.d.get(0);
  slope[kStateIndex.rates.x] = rates.x.d.get(0);
  slope[kStateIndex.rates.y] = rates.y.d.get(0);
  slope[kStateIndex.rates.z] = rates.z.d.get(0);
}

}  // namespace trim_motion_detail

// Of the flight that was trimmed to x, whose `motion` is as that of SteadyMotion; `model`: A and B there, with the columns
// of the inceptors at least.
// Status: ok; bad_argument (c is not prepared, or a column or row is missing); singular; not_finite.
template <class R, class Motion>
Status prepare_motion(const Configuration<R>& c, const Motion& motion, const State<R>& x,
                      const LinearModel<R>& model, TrimMotionWorkspace<R>& work) {
  if (c.aircraft == nullptr) return Status::bad_argument;
  trim_equations(c, work.equations);
  const int n = work.equations.count;
  const auto place_of = [](const int* list, int count, int wanted) {
    for (int i = 0; i < count; ++i)
      if (list[i] == wanted) return i;
    return -1;
  };
  for (int j = 0; j < n; ++j) {
    const TrimEquation<R>& unknown = work.equations.row[j];
    trim_motion_detail::state_slopes(motion, x, unknown.state, work.state[j]);
    const int column = place_of(model.control, model.controls, unknown.control);
    if (unknown.state < 0 && column < 0) return Status::bad_argument;
    for (int i = 0; i < n; ++i) {
      const int row = place_of(model.state, model.states, work.equations.row[i].rate);
      if (row < 0) return Status::bad_argument;
      R sum = column >= 0 ? model.b(row, column) : R(0);
      for (int k = 0; k < model.states; ++k) sum += model.a(row, k) * work.state[j][model.state[k]];
      work.by_unknown(i, j) = work.equations.row[i].rate_scale * sum;
    }
  }
  return lu_factor(work.by_unknown, n, work.lu);
}

// The same of a flight of trim().
template <class R>
Status prepare_trim_motion(const Configuration<R>& c, const SteadyFlight<R>& flight, const State<R>& x,
                           const LinearModel<R>& model, TrimMotionWorkspace<R>& work) {
  return prepare_motion(c, SteadyMotion<R>{flight}, x, model, work);
}

// rates[state_count]: d xdot / dp with state and controls held.
// Status: ok; those of lu_solve().
template <class R>
Status trim_motion(const R* rates, const TrimMotionWorkspace<R>& work, TrimMotion<R>& out) {
  const int n = work.equations.count;
  R z[kMaxTrimUnknowns];
  R x[state_count] = {};
  R u[control_count] = {};
  for (int i = 0; i < n; ++i) z[i] = -(work.equations.row[i].rate_scale * rates[work.equations.row[i].rate]);
  const Status status = lu_solve(work.lu, z);
  for (int j = 0; j < n; ++j) {
    const int control = work.equations.row[j].control;
    if (control >= 0) u[control] = z[j];
    for (int i = 0; i < state_count; ++i) x[i] += work.state[j][i] * z[j];
  }
  unflatten(x, out.x);
  unflatten(u, out.u);
  return status;
}

}  // namespace tiltrotor

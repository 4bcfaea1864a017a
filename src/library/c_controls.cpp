// The C interface: controls as commanded.
#include "library/c_fault.hpp"
#include "tiltrotor/model/variables/control_range.hpp"

namespace tiltrotor::c_interface {

namespace {

void put_controls(Sim& s, const R* controls, std::size_t length) {
  R u[control_count];
  flatten(s.u, u);
  for (std::size_t j = 0; j < length; ++j) u[j] = controls[j];
  unflatten(u, s.u);
}

tr_status check_controls(Sim& s, const R* controls, std::size_t length) {
  if (controls == nullptr || length < 1 || length > TR_CONTROLS) return noted(s, TR_BAD_ARGUMENT);
  const int bad = first_not_finite(controls, length);
  return bad == kNone ? TR_OK : noted(s, TR_NOT_FINITE, kNone, bad);
}

Bounds<R> range_of(std::size_t control) {
  return control_range(aircraft_data<R>(), static_cast<int>(control));
}

}  // namespace

}  // namespace tiltrotor::c_interface

namespace tiltrotor::c_interface::checked {

tr_status tr_set_controls(tr_sim* sim, const tr_real* controls, size_t length) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  Sim& s = *opened(sim);
  const tr_status possible = check_controls(s, controls, length);
  if (possible != TR_OK) return possible;
  for (std::size_t j = 0; j < length; ++j) {
    const Bounds<R> range = range_of(j);
    if (!is_within(controls[j], range.low, range.high))
      return noted(s, TR_OUT_OF_RANGE, kNone, static_cast<int>(j));
  }
  put_controls(s, controls, length);
  return TR_OK;
}

tr_status tr_saturate_controls(tr_sim* sim, const tr_real* controls, size_t length, uint32_t* clipped) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  Sim& s = *opened(sim);
  if (clipped == nullptr) return noted(s, TR_BAD_ARGUMENT);
  const tr_status possible = check_controls(s, controls, length);
  if (possible != TR_OK) return possible;
  R held[control_count];
  std::uint32_t mask = 0;
  for (std::size_t j = 0; j < length; ++j) {
    const Bounds<R> range = range_of(j);
    held[j] = controls[j] < range.low ? range.low : controls[j] > range.high ? range.high : controls[j];
    if (!is_within(controls[j], range.low, range.high)) mask |= std::uint32_t{1} << j;
  }
  put_controls(s, held, length);
  *clipped = mask;
  return TR_OK;
}

}  // namespace tiltrotor::c_interface::checked

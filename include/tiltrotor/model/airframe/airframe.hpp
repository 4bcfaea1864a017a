// The airframe: every component but the rotors, in the order in which the flow passes through them.
#pragma once

#include "tiltrotor/model/airframe/airframe_workspace.hpp"
#include "tiltrotor/model/airframe/fin.hpp"
#include "tiltrotor/model/airframe/fuselage.hpp"
#include "tiltrotor/model/airframe/horizontal_tail.hpp"
#include "tiltrotor/model/airframe/pylon.hpp"

namespace tiltrotor {

template <class T>
struct AirframeResponse {
  Loads<T> total;
  T wing_alpha;  // rad
  T downwash;    // of the wing at the tail, not lagged, rad

  static constexpr int kCount = 8;
  template <class Self, class Visit>
  static constexpr void each(Self& s, Visit&& visit) {
    Loads<T>::each(s.total, visit);
    visit(s.wing_alpha);
    visit(s.downwash);
  }
};
static_assert(lists_its_members<AirframeResponse>(), "each member of AirframeResponse is listed and counted");

// `record(component, loads)` sees every component as it is added.
template <class T, class C, class Record>
void airframe_response(const Configuration<C>& c, const AirframeInput<T>& in, AirframeWorkspace<T>& work,
                       AirframeResponse<T>& out, Record&& record) {
  const FreeStream<T>& stream = work.stream = free_stream(c, in.velocity_b);

  for (const Side side : {right, left}) wing_in_wake(c, in, stream, side, work.wake[side]);
  out.total = work.wake[right].loads + work.wake[left].loads;
  record(Component::wing_wake_right, work.wake[right].loads);
  record(Component::wing_wake_left, work.wake[left].loads);

  const auto add = [&](Component component) {
    out.total = out.total + work.loads;
    record(component, static_cast<const Loads<T>&>(work.loads));
  };
  free_wing(c, in, stream, work.wake, work.wing);
  work.loads = work.wing.loads;
  add(Component::wing_free);
  out.wing_alpha = work.wing.alpha;
  out.downwash = work.wing.downwash;

  work.loads = pylon_interference_loads(c, work.wake);
  add(Component::pylon);
  work.loads = spinner_loads(c, in);
  add(Component::spinners);
  work.loads = pylon_side_loads(c, in);
  add(Component::pylon_side);
  work.loads = fuselage_loads(c, in, stream);
  add(Component::fuselage);

  work.tail = tail_flow(c, stream);
  work.downwash = c.setup.options.downwash_lag ? in.downwash : work.wing.downwash;
  work.loads = horizontal_tail_loads(c, in, stream, work.tail, work.downwash);
  add(Component::htail);
  work.fins = fin_flow(c, in, stream);
  work.loads = fin_loads(c, in, stream, work.tail, work.fins, right);
  add(Component::fin_right);
  work.loads = fin_loads(c, in, stream, work.tail, work.fins, left);
  add(Component::fin_left);
}

}  // namespace tiltrotor

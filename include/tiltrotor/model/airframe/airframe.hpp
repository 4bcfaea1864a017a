// The airframe: every component but the rotors, in the order in which the flow passes through them.
#pragma once

#include "tiltrotor/model/airframe/fin.hpp"
#include "tiltrotor/model/airframe/fuselage.hpp"
#include "tiltrotor/model/airframe/horizontal_tail.hpp"
#include "tiltrotor/model/airframe/pylon.hpp"
#include "tiltrotor/model/airframe/wing.hpp"

namespace tiltrotor {

template <class T>
struct AirframeResponse {
  Loads<T> total;
  T wing_alpha;  // rad
  T downwash;    // of the wing at the tail, not lagged, rad

  static constexpr int kCount = 8;
  template <class Self, class Visit>
  static void each(Self& s, Visit&& visit) {
    Loads<T>::each(s.total, visit);
    visit(s.wing_alpha);
    visit(s.downwash);
  }
};

// Memory of an evaluation of the airframe.
template <class T>
struct AirframeWorkspace {
  FreeStream<T> stream;
  WingInWake<T> wake[2];
  FreeWing<T> wing;
  Loads<T> loads;  // of one component
  T wash_ratio, downwash;
};

// `record(component, loads)` sees every component as it is added.
template <class T, class Record>
void airframe_response(const Configuration<Real<T>>& c, const AirframeInput<T>& in,
                       AirframeWorkspace<T>& room, AirframeResponse<T>& out, Record&& record) {
  const FreeStream<T>& stream = room.stream = free_stream(c, in.velocity);

  for (const Side side : {right, left}) wing_in_wake(c, in, stream, side, room.wake[side]);
  out.total = room.wake[right].loads + room.wake[left].loads;
  record(wing_wake_right, room.wake[right].loads);
  record(wing_wake_left, room.wake[left].loads);

  const auto add = [&](Component component) {
    out.total = out.total + room.loads;
    record(component, static_cast<const Loads<T>&>(room.loads));
  };
  free_wing(c, in, stream, room.wake, room.wing);
  room.loads = room.wing.loads;
  add(wing_free);
  out.wing_alpha = room.wing.alpha;
  out.downwash = room.wing.downwash;

  room.loads = pylon_interference_loads(c, room.wake);
  add(pylon);
  room.loads = spinner_loads(c, in);
  add(spinners);
  room.loads = pylon_side_loads(c, in);
  add(pylon_side);
  room.loads = fuselage_loads(c, in, stream);
  add(fuselage);

  room.wash_ratio = tail_wash_ratio(c, stream);
  room.downwash = c.setup.options.downwash_lag ? in.downwash : room.wing.downwash;
  room.loads = horizontal_tail_loads(c, in, stream, room.wash_ratio, room.downwash);
  add(htail);
  room.loads = fin_loads(c, in, stream, room.wash_ratio, right);
  add(fin_right);
  room.loads = fin_loads(c, in, stream, room.wash_ratio, left);
  add(fin_left);
}

}  // namespace tiltrotor

// The airframe: every component but the rotors, in the order in which the flow passes through them.
#pragma once

#include "tiltrotor/model/fin.hpp"
#include "tiltrotor/model/fuselage.hpp"
#include "tiltrotor/model/horizontal_tail.hpp"
#include "tiltrotor/model/pylon.hpp"
#include "tiltrotor/model/wing.hpp"

namespace tiltrotor {

template <class T>
struct AirframeResponse {
  Loads<T> total;
  T wing_alpha;     // rad
  T downwash;       // of the wing at the tail, not lagged, rad

  static constexpr int kCount = 8;
  template <class Self, class Visit>
  static void each(Self& s, Visit&& visit) {
    Loads<T>::each(s.total, visit);
    visit(s.wing_alpha);
    visit(s.downwash);
  }
};

// `record(component, loads)` sees every component as it is added.
template <class T, class Record>
AirframeResponse<T> airframe_response(const Configuration<Real<T>>& c, const AirframeInput<T>& in, Record&& record) {
  const FreeStream<T> stream = free_stream(c, in.velocity);
  AirframeResponse<T> out;

  const WingInWake<T> wake[2] = {wing_in_wake(c, in, stream, right), wing_in_wake(c, in, stream, left)};
  out.total = wake[right].loads + wake[left].loads;
  record(wing_wake_right, wake[right].loads);
  record(wing_wake_left, wake[left].loads);

  const auto add = [&](Component component, const Loads<T>& loads) {
    out.total = out.total + loads;
    record(component, loads);
  };
  const FreeWing<T> wing = free_wing(c, in, stream, wake);
  add(wing_free, wing.loads);
  out.wing_alpha = wing.alpha;
  out.downwash = wing.downwash;

  add(pylon, pylon_interference_loads(c, wake));
  add(spinners, spinner_loads(c, in));
  add(pylon_side, pylon_side_loads(c, in));
  add(fuselage, fuselage_loads(c, in, stream));

  const T wash_ratio = tail_wash_ratio(c, stream);
  const T downwash = c.setup.options.downwash_lag ? in.downwash : wing.downwash;
  add(htail, horizontal_tail_loads(c, in, stream, wash_ratio, downwash));
  add(fin_right, fin_loads(c, in, stream, wash_ratio, right));
  add(fin_left, fin_loads(c, in, stream, wash_ratio, left));
  return out;
}

}  // namespace tiltrotor

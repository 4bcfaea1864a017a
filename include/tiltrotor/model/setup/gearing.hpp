// Gearing of the inceptors and rigging of the disks at one mast angle (NASA CR-166536 tables 8a-I, 8a-III,
// 8a-VII).
#pragma once

#include "tiltrotor/model/aircraft/aircraft.hpp"
#include "tiltrotor/model/variables/options.hpp"

namespace tiltrotor {

// rad/in, but as noted
template <class C>
struct Gearing {
  C long_cyclic;
  C rigging;  // longitudinal cyclic with the stick at neutral, + disks forward, rad
  C lateral_collective;
  C lateral_cyclic_gain;
  Real<C> elevator, aileron, rudder;
};

// `mast_cosine`: of the same angle.
template <class C>
Gearing<C> gearing(const Aircraft<Real<C>>& aircraft, const Options& options, const C& mast_deg,
                   const C& mast_cosine) {
  using R = Real<C>;
  const ControlTables<R>& t = aircraft.controls;
  const auto at = [&mast_deg](const Table<R, 1>& table) {
    return lookup(table, Interpolation::linear, mast_deg);
  };
  Gearing<C> g;
  g.long_cyclic = at(t.long_cyclic);
  // A bias of theta1s = -1.5 deg (1 - cos mast): Kleinhesselink 2007, app. B p. 164.
  g.rigging = options.cyclic_rigging ? t.cyclic_rigging * (R(1) - mast_cosine) : C(R(0));
  g.lateral_collective = at(t.lateral_collective);
  g.lateral_cyclic_gain = options.lateral_cyclic ? at(t.lateral_cyclic_gain) : C(R(0));
  g.elevator = options.elevator_gearing == ElevatorGearing::aircraft ? t.elevator : t.elevator_replay;
  g.aileron = t.aileron;
  g.rudder = t.rudder;
  return g;
}

}  // namespace tiltrotor

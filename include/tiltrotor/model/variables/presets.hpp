// Named sets of switches. Each changes only the switches it names.
#pragma once

#include "tiltrotor/model/variables/options.hpp"

namespace tiltrotor {

// Two aircraft of one name, which published numbers tell apart: a number of the one says nothing about a model of
// the other.
//
// As simulated (the default): inertia as printed for the reference simulation; no K_HNU at the horizontal tail,
// which its printed tail loads and its pitch response do not contain (Kleinhesselink 2007 app. C, NASA TM-89428).
// As flown: inertia that the measured responses ask for, K_HNU in airplane mode (NASA TM-89428 pp. 126-134).
enum class DataSet : unsigned char { as_simulated, as_flown };

inline void choose(DataSet set, Options& o) {
  const bool flown = set == DataSet::as_flown;
  o.inertia = flown ? InertiaSet::flown : InertiaSet::simulation;
  o.tail_pressure = flown ? TailPressure::by_mast : TailPressure::none;
}

// The model of the independent second implementation, whose outputs are the expected values of
// tests/model/test_reference.cpp and tests/analysis/: what has been found missing or wrong since is left out.
inline void choose_reference(Options& o) {
  o.radial_inflow = RadialInflow::constant;
  o.descent_inflow = DescentInflow::momentum;
  o.cyclic_rigging = false;
  o.wake_fade_airplane = false;
  o.mast_drag = MastDrag::cross_flow;
  o.rotor_lift_flaps = RotorLiftFlaps::any;
  o.nacelle_mass = NacelleMass::quoted;
  o.inertia = InertiaSet::simulation;
  o.tail_pressure = TailPressure::by_mast;
}
inline Options reference_options() {
  Options o;
  choose_reference(o);
  return o;
}

}  // namespace tiltrotor

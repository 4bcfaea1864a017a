// Setup and state of an aircraft of the C interface, checked, set and read.
#pragma once

#include "library/c_memory.hpp"

namespace tiltrotor::c_interface {

// What a state may show, and a step may reach.
inline constexpr double kLongestFlight = 1e9;  // s
inline constexpr std::uint64_t kMostSteps = 1000000000000000;

// The choices of a setup; its numbers are checked by make().
tr_status wanted_setup(const tr_setup& setup, FlightSetup<R>& wanted);
tr_setup setup_of(const FlightSetup<R>& setup);
// An aircraft at rest; `sim` is touched with TR_OK alone.
tr_status make(const FlightSetup<R>& setup, tr_sim* sim);

// What tr_set_state accepts; otherwise why not, and the first place in x or u that is to blame.
struct StateCheck {
  tr_status status;
  int state, control;
};
StateCheck check_state(const tr_state& state);
void get_state(const Sim& s, tr_state& state);
void put_state(const tr_state& state, Sim& s);

}  // namespace tiltrotor::c_interface

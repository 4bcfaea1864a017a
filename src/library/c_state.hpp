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

// The configuration of a call, kept: stored bytes hold no address.
void keep(const Configuration<R>& c, Sim& s);
// What may change in flight, checked and set; unless TR_OK, nothing is changed. `follows`: whether the air follows the
// altitude. The velocity of the state stays as it is.
bool within_limits(const Loads<R>& outside);
void get_environment(const Sim& s, tr_environment& environment);
tr_status put_environment(const tr_environment& environment, bool follows, Sim& s);
tr_status put_loads(const Loads<R>& total, Sim& s);
// Air of the altitude that a new position is at.
tr_status follow_air(Sim& s);

}  // namespace tiltrotor::c_interface

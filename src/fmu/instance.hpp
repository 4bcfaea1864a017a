// An instance of the FMU: one block, placed once; nothing else is allocated.
#pragma once

#include <cstdarg>
#include <cstdio>

#include "fmu/fmi3.h"
#include "fmu/variables.hpp"

namespace tiltrotor_fmu {

// Modes of the standard, as bits, so that a call may name those it is allowed in.
constexpr unsigned kInstantiated = 1, kInitialization = 2, kEvent = 4, kContinuous = 8, kStep = 16,
                   kTerminated = 32, kAlive = 63;

// What a copy keeps and restores.
struct Flight {
  std::uint32_t mode;
  std::uint8_t changed;  // a parameter, since the aircraft was made
  std::uint8_t jumped;   // states, by the wind, since the last event
  double time;
  double setting[kSettings];
  std::uint8_t state_given[kContinuousStates], input_given[TR_INPUTS];
  double state[kContinuousStates];  // begun with
  double input[TR_INPUTS];          // as they are
  tr_sim sim;
};

// Copies that an importer may hold at a time.
constexpr int kSlots = 16;
struct Slot {
  bool used;
  Flight flight;
};

struct Instance {
  std::uint64_t mark;
  bool co_simulation, logging;
  std::uint32_t categories;  // bit a fmi3Status; fmi3OK: events
  std::uint32_t told;        // inputs of what is off, bit by bit, once a flight
  fmi3LogMessageCallback log_message;
  fmi3InstanceEnvironment environment;
  double stop_time;
  Flight flight, before;  // a step that fails leads back
  double start_state[kContinuousStates], start_input[TR_INPUTS], start_setting[kSettings];
  tr_work work;
  Slot slot[kSlots];
};
constexpr std::uint64_t kMark = UINT64_C(0x74696c74726f746f);

/// The instance when it is one and in one of the modes; else nullptr, and a line in its log.
Instance* opened(fmi3Instance instance, unsigned modes, const char* call);

/// Says it to the importer and hands `status` back.
fmi3Status say(Instance& i, fmi3Status status, const char* format, ...)
#if defined(__GNUC__) && !defined(_WIN32)
    __attribute__((format(printf, 3, 4)))
#endif
    ;
/// Of the library; `refused`: what anything but TR_OK is.
fmi3Status answer(Instance& i, tr_status status, const char* call, fmi3Status refused);

/// As after instantiation.
fmi3Status begin(Instance& i);
/// The aircraft that settings, start states and inputs ask for, when they have changed since.
fmi3Status make(Instance& i);

/// "event mode"
const char* mode_name(unsigned mode);

// What is refused, in words.
fmi3Status check_range(Instance& i, Place place, double value);
/// Whatever was set to other than its start value has what it needs.
fmi3Status check_given(Instance& i);
/// In flight: a warning, once, that an input acts on what is off.
fmi3Status warn_idle(Instance& i, Place place);
/// Of tr_set_state with these states: which one, its value, its range.
fmi3Status refuse_states(Instance& i, tr_status status, const double* x, const char* call,
                         fmi3Status refused);
fmi3Status refuse_step(Instance& i, tr_status status, double time);

// Outputs up to those of components, and event indicators; `dx`: a direction of TR_STATES states, `found`: tr_directional_inputs
// of it.
tr_status read_outputs(const Flight& f, double (&y)[kOutputs]);
void slopes_of_outputs(const Flight& f, const double* dx, const tr_outputs& found, double (&dy)[kOutputs]);
tr_status read_indicators(const Flight& f, double (&height)[kWheels]);
tr_status slopes_of_indicators(const Flight& f, const double* dx, double (&slope)[kWheels]);
/// Outputs of components, in their places; `du`: a direction of TR_INPUTS inputs.
tr_status read_component_outputs(Instance& i, double (&y)[kOutputs]);
tr_status slopes_of_component_outputs(Instance& i, const double* dx, const double* du,
                                      double (&dy)[kOutputs]);
inline bool is_of_components(Place p) { return p.role == Role::output && p.index >= kFirstOfComponents; }

fmi3Status put_states(Instance& i, const double* x);
/// One continuous input, in the units of tr_control_unit.
fmi3Status put_input(Instance& i, int index, double value);
fmi3Status put_setting(Instance& i, int index, double value);

}  // namespace tiltrotor_fmu

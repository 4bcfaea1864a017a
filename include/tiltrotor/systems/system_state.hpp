// States of the systems around the airframe, and what is commanded of them: plain structs, one line a variable.
//
// A new state is a member and its line in describe(); whatever is forgotten does not compile. Places count after
// those of State.
#pragma once

#include "tiltrotor/math/vector.hpp"
#include "tiltrotor/model/variables/controls.hpp"
#include "tiltrotor/model/variables/state.hpp"
#include "tiltrotor/systems/turbulence.hpp"

namespace tiltrotor {

template <class T>
struct SystemState {
  T mast, mast_rate;                // rad, rad/s
  T flap;                           // rad
  T rotor_speed;                    // mean of the two, rad/s
  T shaft_twist, twist_rate;        // of the interconnect: right rotor ahead of the left one, rad, rad/s
  T power[2];                       // of the engines at their shafts, right and left, W
  T governor;                       // collective that the governor adds, rad
  T fuel;                           // burnt, kg
  T collective[2], long_cyclic[2];  // actuators: pitch at 0.75 R and B1 without rigging, right and left, rad
  T elevator, aileron, rudder;      // actuators, rad
  T series[3];                      // series actuators of the augmentation, longitudinal lateral yaw, in
  T washout;                        // yaw rate that the augmentation has become used to, rad/s
  T held_pitch, held_roll;          // attitude that is held, rad
  T holds_pitch, holds_roll;        // 1 while it is, else 0
  T rest_long, rest_lat;            // where the stick stands when it is let go, in
  T gear;                           // extension, 0 retracted .. 1 locked down, moved on between steps
  TurbulenceState<T> gusts;         // filters of the turbulence, moved on between steps

  template <class Self, class Visit>
  static constexpr void describe(Self& s, Visit&& visit) {
    using K = VariableKind;
    constexpr Plane lon = Plane::longitudinal;
    constexpr Plane lat = Plane::lateral;
    constexpr Plane rot = Plane::rotor;
    visit(s.mast, Variable{"mast", K::mast_angle, lon});
    visit(s.mast_rate, Variable{"dmast", K::mast_rate, lon});
    visit(s.flap, Variable{"flap", K::flap_angle, lon});
    visit(s.rotor_speed, Variable{"rotor_speed", K::rotor_speed, lon});
    visit(s.shaft_twist, Variable{"shaft_twist", K::shaft_twist, lat});
    visit(s.twist_rate, Variable{"twist_rate", K::twist_rate, lat});
    visit(s.power[right], Variable{"power_R", K::power, rot, right});
    visit(s.power[left], Variable{"power_L", K::power, rot, left});
    visit(s.governor, Variable{"governor", K::actuator, lon});
    visit(s.fuel, Variable{"fuel", K::fuel, lon});
    visit(s.collective[right], Variable{"collective_R", K::actuator, rot, right});
    visit(s.collective[left], Variable{"collective_L", K::actuator, rot, left});
    visit(s.long_cyclic[right], Variable{"cyclic_R", K::actuator, rot, right});
    visit(s.long_cyclic[left], Variable{"cyclic_L", K::actuator, rot, left});
    visit(s.elevator, Variable{"elevator_angle", K::actuator, lon});
    visit(s.aileron, Variable{"aileron_angle", K::actuator, lat});
    visit(s.rudder, Variable{"rudder_angle", K::actuator, lat});
    visit(s.series[0], Variable{"scas_pitch", K::series_actuator, lon});
    visit(s.series[1], Variable{"scas_roll", K::series_actuator, lat});
    visit(s.series[2], Variable{"scas_yaw", K::series_actuator, lat});
    visit(s.washout, Variable{"washout", K::washout, lat});
    visit(s.held_pitch, Variable{"held_pitch", K::held_angle, lon});
    visit(s.held_roll, Variable{"held_roll", K::held_angle, lat});
    visit(s.holds_pitch, Variable{"holds_pitch", K::flag, lon});
    visit(s.holds_roll, Variable{"holds_roll", K::flag, lat});
    visit(s.rest_long, Variable{"rest_long", K::held_stick, lon});
    visit(s.rest_lat, Variable{"rest_lat", K::held_stick, lat});
    visit(s.gear, Variable{"gear", K::gear_extension, lon});
    TurbulenceState<T>::describe(s.gusts, [&visit](auto& x, const char* name) {
      visit(x, Variable{name, K::gust_filter, Plane::longitudinal});
    });
  }
  template <class Self, class Visit>
  static constexpr void each(Self& s, Visit&& visit) {
    describe(s, [&visit](auto& x, const Variable&) { visit(x); });
  }
};

inline constexpr int system_state_count = count_variables<SystemState>();
static_assert(sizeof(SystemState<int>) == system_state_count * sizeof(int),
              "every member of SystemState is described");
inline constexpr SystemState<int> kSystemIndex = places<SystemState>();
inline constexpr auto kSystemVariables = variable_table<SystemState>();
static_assert(is_complete(kSystemVariables), "names are unlike, sides have the same states");

// Of airframe and systems.
inline constexpr int vehicle_state_count = state_count + system_state_count;

constexpr const Variable& vehicle_variable(int state) {
  return state < state_count ? kStateVariables[state] : kSystemVariables[state - state_count];
}

// What crew and displays command beside the controls.
template <class T>
struct Commands {
  T mast, flap;   // rad
  T rotor_speed;  // of the governor, rad/s
  T throttle[2];  // power of an engine over its take-off power here

  template <class Self, class Visit>
  static constexpr void describe(Self& s, Visit&& visit) {
    using K = VariableKind;
    constexpr Plane lon = Plane::longitudinal;
    visit(s.mast, Variable{"mast_command", K::mast_angle, lon});
    visit(s.flap, Variable{"flap_command", K::flap_angle, lon});
    visit(s.rotor_speed, Variable{"rotor_command", K::rotor_speed, lon});
    visit(s.throttle[right], Variable{"throttle_R", K::throttle, Plane::rotor, right});
    visit(s.throttle[left], Variable{"throttle_L", K::throttle, Plane::rotor, left});
  }
  template <class Self, class Visit>
  static constexpr void each(Self& s, Visit&& visit) {
    describe(s, [&visit](auto& x, const Variable&) { visit(x); });
  }
};

inline constexpr int command_count = count_variables<Commands>();
static_assert(sizeof(Commands<int>) == command_count * sizeof(int), "every member of Commands is described");
inline constexpr Commands<int> kCommandIndex = places<Commands>();
inline constexpr auto kCommandVariables = variable_table<Commands>();
static_assert(is_complete(kCommandVariables), "names are unlike, sides have the same commands");

// Inputs of the vehicle: controls, then commands.
inline constexpr int vehicle_input_count = control_count + command_count;

constexpr const Variable& vehicle_input(int input) {
  return input < control_count ? kControlVariables[input] : kCommandVariables[input - control_count];
}

}  // namespace tiltrotor

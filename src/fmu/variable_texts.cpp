// What the variables are, in a few words, for those who meet them in an importer.
#include "fmu/variables.hpp"

namespace tiltrotor_fmu {

namespace {

#define OF_A_ROTOR(side)                                                                               \
  "longitudinal flapping of the " side " gimbal, mirrored frame of the rotor", "its lateral flapping", \
      "rate of its longitudinal flapping", "rate of its lateral flapping",                             \
      "mean inflow of the " side " rotor over tip speed", "its fore-and-aft inflow over tip speed",    \
      "its sideways inflow over tip speed"
#define CONING(side) "coning of the " side " rotor; needs coning", "its rate; needs coning"

constexpr const char* kStateTexts[] = {
    "velocity of the CG along body x, relative to the undisturbed air",
    "velocity of the CG along body y, relative to the undisturbed air",
    "velocity of the CG along body z, relative to the undisturbed air",
    "roll rate, body axes",
    "pitch rate, body axes",
    "yaw rate, body axes",
    "bank angle, right wing down",
    "pitch angle, nose up",
    "heading",
    OF_A_ROTOR("right"),  // NOLINT(bugprone-suspicious-missing-comma): a side within a text
    OF_A_ROTOR("left"),
    "downwash angle at the tail",
    CONING("right"),
    CONING("left"),
    "position over the ground, north",
    "position over the ground, east",
    "position over the ground, down",
    "mast angle; 0 while conversion is off: output.mast is always there",
    "its rate; 0 while conversion is off",
    "flaps; 0 while conversion is off: output.flap is always there",
    "rotor speed; 0 unless governor is pi: output.rotor_speed is always there",
    "right rotor ahead of the left one; 0 without interconnect",
    "its rate; 0 without interconnect",
    "power of the right engine at its shaft; 0 while engines is off",
    "power of the left engine at its shaft; 0 while engines is off",
    "collective that the governor adds; 0 while it is off",
    "fuel burnt, by which the mass falls; 0 while engines is off",
    "actuator: right collective at 0.75 radius; 0 while actuators is off",
    "actuator: left collective at 0.75 radius; 0 while actuators is off",
    "actuator: right longitudinal cyclic; 0 while actuators is off",
    "actuator: left longitudinal cyclic; 0 while actuators is off",
    "actuator: elevator; 0 while actuators is off",
    "actuator: aileron; 0 while actuators is off",
    "actuator: rudder; 0 while actuators is off",
    "series actuator of the augmentation, longitudinal stick",
    "series actuator of the augmentation, lateral stick",
    "series actuator of the augmentation, pedal",
    "yaw rate that the augmentation has become used to",
    "pitch angle that the augmentation holds",
    "bank angle that the augmentation holds",
    "1 while the pitch angle is held",
    "1 while the bank angle is held",
    "where the longitudinal stick rests",
    "where the lateral stick rests",
    "extension of the landing gear: 0 retracted, 1 locked down; 0 while gear is off",
};
constexpr int kNamedStates = sizeof kStateTexts / sizeof kStateTexts[0];
static_assert(kNamedStates == TR_GUST_FILTERS, "one text a state before those of the turbulence");

constexpr const char* kInputTexts[] = {
    "mean blade pitch of both rotors at 0.75 radius; the ideal governor finds it",
    "longitudinal stick from neutral, forward",
    "lateral stick from neutral, to the right",
    "pedals from neutral, right",
    "longitudinal cyclic of both rotors, increment",
    "differential collective, increment",
    "differential longitudinal cyclic, increment",
    "elevator, increment",
    "aileron, increment",
    "rudder, increment",
    "lateral cyclic of both rotors, increment",
    "air at the aircraft relative to the undisturbed air, body x",
    "air at the aircraft relative to the undisturbed air, body y",
    "air at the aircraft relative to the undisturbed air, body z",
    "mast angle to go to; needs conversion",
    "flaps to go to; needs conversion",
    "rotor speed that the governor holds; needs governor pi",
    "power of the right engine over its take-off power; needs a governor or engines",
    "power of the left engine over its take-off power; needs a governor or engines",
};
static_assert(sizeof kInputTexts / sizeof kInputTexts[0] == TR_INPUTS, "one text an input");

constexpr const char* kWheelTexts[] = {
    "lowest point of the extended nose wheel over the ground; 1 without gear and ground",
    "lowest point of the extended right main wheel over the ground; 1 without gear and ground",
    "lowest point of the extended left main wheel over the ground; 1 without gear and ground",
};
static_assert(sizeof kWheelTexts / sizeof kWheelTexts[0] == kWheels, "one text a wheel");

}  // namespace

const char* text_of(Place place) {
  switch (place.role) {
    case Role::state:
      return place.index < kNamedStates ? kStateTexts[place.index] : "filter of the turbulence";
    case Role::input:
      return kInputTexts[place.index];
    case Role::output:
      return output_facts(place.index).text;
    case Role::setting:
      return facts_of(place.index).text;
    case Role::indicator:
      return kWheelTexts[place.index];
    default:
      return "";
  }
}

}  // namespace tiltrotor_fmu

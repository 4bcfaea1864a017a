// What is refused, in words: what, its value, the range or what is missing.
#include <cmath>

#include "fmu/instance.hpp"

namespace tiltrotor_fmu {

namespace {

const char* unless(bool there, const char* what) { return there ? nullptr : what; }

const char* missing_of_setting(const Flight& f, int setting) {
  const auto on = [&f](int k) { return f.setting[k] != 0; };
  switch (setting) {
    case kTrimSpeed:
    case kTrimClimb:
    case kTrimTurnRate:
    case kTrimSideslip:
      return unless(on(kTrim), "parameter.trim = true");
    case kTemperatureOffset:
    case kPressureRatio:
    case kGear:
    case kGroundEffect:
    case kWindShear:
    case kWindNorth:
    case kWindEast:
    case kWindDown:
      return unless(on(kEnvironment), "parameter.environment = true");
    case kGroundDown:
      if (!on(kEnvironment)) return "parameter.environment = true";
      return unless(on(kGear) || on(kGroundEffect) || on(kWindShear),
                    "parameter.gear, ground_effect or wind_shear");
    case kInterconnect:
      return unless(f.setting[kGovernor] == int{TR_GOVERNOR_PI}, "parameter.governor = 2, pi");
    case kTurbulenceSeed:
    case kTurbulenceW20:
      return unless(on(kTurbulence), "parameter.turbulence = true");
    case kBrakeRight:
    case kBrakeLeft:
    case kGearDown:
      return unless(on(kGear), "parameter.gear = true");
    case kEngineFailedRight:
    case kEngineFailedLeft:
      return unless(on(kGovernor) || on(kEngines), "parameter.governor or parameter.engines");
    default:
      return nullptr;
  }
}

const char* missing_of_input(const Flight& f, int input) {
  const double governor = f.setting[kGovernor];
  if (input == TR_COLLECTIVE)
    return unless(governor != int{TR_GOVERNOR_IDEAL},
                  "parameter.governor = 0, off, or 2, pi: ideal finds it");
  switch (input - TR_CONTROLS) {
    case 0:
    case 1:
      return unless(f.setting[kConversion] != 0, "parameter.conversion = true");
    case 2:
      return unless(governor == int{TR_GOVERNOR_PI}, "parameter.governor = 2, pi");
    case 3:
    case 4:
      return unless(governor != 0 || f.setting[kEngines] != 0, "parameter.governor or parameter.engines");
    default:
      return nullptr;
  }
}

const char* missing_of_state(const Flight& f, int state) {
  const auto on = [&f](int k) { return f.setting[k] != 0; };
  if (state >= TR_CONING_RIGHT && state < TR_NORTH) return unless(on(kConing), "parameter.coning = true");
  if (state < TR_MAST) return nullptr;
  if (state <= TR_FLAP) return unless(on(kConversion), "parameter.conversion = true");
  if (state == TR_ROTOR_SPEED)
    return unless(f.setting[kGovernor] == int{TR_GOVERNOR_PI}, "parameter.governor = 2, pi");
  if (state <= TR_TWIST_RATE) return unless(on(kInterconnect), "parameter.interconnect = true");
  if (state == TR_GOVERNOR) return unless(on(kGovernor), "parameter.governor");
  if (state <= TR_FUEL) return unless(on(kEngines), "parameter.engines = true");
  return unless(on(kActuators), "parameter.actuators = true");
}

const char* missing(const Instance& i, Place p) {
  const Flight& f = i.flight;
  if (p.role == Role::setting && p.index == kLongestStep) return unless(i.co_simulation, "Co-Simulation");
  return p.role == Role::setting ? missing_of_setting(f, p.index)
         : p.role == Role::input ? missing_of_input(f, p.index)
                                 : missing_of_state(f, p.index);
}

fmi3Status say_outside(Instance& i, fmi3Status status, const char* call, Place place, double value,
                       const Range& range) {
  const char* const unit = unit_of(place);
  return say(i, status, "%s%s = %.10g lies outside %.10g..%.10g%s%s", call, full_name(place).text, value,
             range.low, range.high, unit[0] != 0 ? " " : "", unit);
}

}  // namespace

const char* mode_name(unsigned mode) {
  return mode == kInstantiated     ? "the mode after instantiation"
         : mode == kInitialization ? "initialization mode"
         : mode == kEvent          ? "event mode"
         : mode == kContinuous     ? "continuous-time mode"
         : mode == kStep           ? "step mode"
                                   : "the mode after termination";
}

fmi3Status check_range(Instance& i, Place place, double value) {
  const Range range = range_of(place);
  return range.holds(value) ? fmi3OK : say_outside(i, fmi3Error, "", place, value, range);
}

fmi3Status check_given(Instance& i) {
  const Flight& f = i.flight;
  const auto check = [&i](Role role, int index, bool given) {
    const Place place = {role, index};
    const char* const needed = given ? missing(i, place) : nullptr;
    if (needed == nullptr) return fmi3OK;
    return say(i, fmi3Error, "%s is set and changes nothing: it needs %s", full_name(place).text, needed);
  };
  for (int k = 0; k < kSettings; ++k)
    if (check(Role::setting, k, f.setting[k] != i.start_setting[k]) != fmi3OK) return fmi3Error;
  for (int k = 0; k < TR_INPUTS; ++k)
    if (check(Role::input, k, f.input_given[k]) != fmi3OK) return fmi3Error;
  for (int k = 0; k < kContinuousStates; ++k)
    if (check(Role::state, k, f.state_given[k]) != fmi3OK) return fmi3Error;
  return fmi3OK;
}

fmi3Status warn_idle(Instance& i, Place place) {
  const bool in_flight = place.role == Role::input || place.index >= kFirstInputSetting;
  const char* const needed = in_flight ? missing(i, place) : nullptr;
  if (needed == nullptr) return fmi3OK;
  const int bit = place.role == Role::input ? place.index : TR_INPUTS + place.index - kFirstInputSetting;
  const std::uint32_t told = std::uint32_t{1} << bit;
  if ((i.told & told) != 0) return fmi3OK;
  i.told |= told;
  return say(i, fmi3Warning, "%s changes nothing: it needs %s", full_name(place).text, needed);
}
static_assert(TR_INPUTS + kSettings - kFirstInputSetting <= 32, "one bit an input");

fmi3Status refuse_states(Instance& i, tr_status status, const double* x, const char* call,
                         fmi3Status refused) {
  tr_fault fault;
  const bool known =
      tr_last_fault(&i.flight.sim, &fault) == TR_OK && fault.status == status && fault.state >= 0;
  if (status == TR_OK || !known) return answer(i, status, call, refused);
  const Place place = {Role::state, fault.state};
  const double value = x[fault.state];
  char before[64];
  std::snprintf(before, sizeof before, "%s: ", call);
  const Range range = range_of(place);
  if (!range.holds(value)) return say_outside(i, refused, before, place, value, range);
  Range altitude = {0, 0};
  if (fault.state == TR_DOWN && tr_get_range("altitude_m", &altitude.low, &altitude.high) == TR_OK)
    return say(i, refused, "%s%s = %.10g m is an altitude of %.10g m, outside %.10g..%.10g m", before,
               full_name(place).text, value, i.flight.setting[kAltitude] - value, altitude.low,
               altitude.high);
  return say(i, refused, "%s%s = %.10g: %s", before, full_name(place).text, value, tr_status_text(status));
}

fmi3Status refuse_step(Instance& i, tr_status status, double time) {
  tr_fault fault;
  const bool known = tr_last_fault(&i.flight.sim, &fault) == TR_OK && fault.state >= 0;
  if (!known) return say(i, fmi3Discard, "step at %g s: %s", time, tr_status_text(status));
  const Place place = {Role::state, fault.state};
  const Range range = range_of(place);
  return say(i, fmi3Discard, "step at %g s: %s: %s, which lies in %.10g..%.10g %s", time,
             tr_status_text(status), full_name(place).text, range.low, range.high, unit_of(place));
}

}  // namespace tiltrotor_fmu

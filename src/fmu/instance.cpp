#include "fmu/instance.hpp"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <initializer_list>

namespace tiltrotor_fmu {

namespace {

constexpr unsigned kBeforeFlight = kInstantiated | kInitialization;

bool is_on(const Flight& f, int setting) { return f.setting[setting] != 0; }

bool has_systems(const Flight& f) {
  for (int k = kGovernor; k <= kTurbulence; ++k)
    if (is_on(f, k)) return true;
  return false;
}

// The setup: flap and rotor speed, unless set, are those of the mast angle.
fmi3Status make_setup(Instance& i, tr_setup& setup) {
  Flight& f = i.flight;
  const tr_status status =
      tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0), degrees(f.setting[kMast]));
  if (status != TR_OK) return answer(i, status, "mast", fmi3Error);
  const auto is_set = [&](int k) { return f.setting[k] != i.start_setting[k]; };
  if (is_set(kFlap)) setup.flap_deg = degrees(f.setting[kFlap]);
  if (is_set(kRotorSpeed)) setup.rotor_radps = f.setting[kRotorSpeed];
  if (is_set(kMass)) setup.mass_kg = f.setting[kMass];
  if (is_set(kCgStation)) setup.cg_station_m = f.setting[kCgStation];
  setup.altitude_m = f.setting[kAltitude];
  setup.grid = static_cast<std::int32_t>(f.setting[kGrid]);
  setup.tables = static_cast<std::int32_t>(f.setting[kTables]);
  setup.coning_states = is_on(f, kConing);
  return fmi3OK;
}

fmi3Status put_environment(Instance& i) {
  const Flight& f = i.flight;
  if (!is_on(f, kEnvironment)) return fmi3OK;
  tr_environment e;
  tr_default_environment(&e);
  for (int k = 0; k < 3; ++k) e.wind_mps[k] = f.setting[kWindNorth + k];
  e.altitude_origin_m = f.setting[kAltitude];
  e.temperature_offset_k = f.setting[kTemperatureOffset];
  e.pressure_ratio = f.setting[kPressureRatio];
  if (is_on(f, kGear) || is_on(f, kGroundEffect) || is_on(f, kWindShear))
    e.ground_down_m = f.setting[kGroundDown];
  char text[120];
  if (tr_check_environment(&e, TR_API_VERSION, text, sizeof text) != TR_OK)
    return say(i, fmi3Error, "environment: %s", text);
  return answer(i, tr_set_environment(&i.flight.sim, &e), "environment", fmi3Error);
}

// Switches and commands as they are in the flight.
fmi3Status put_systems(Instance& i, bool with_commands) {
  const Flight& f = i.flight;
  if (!has_systems(f)) return fmi3OK;
  if (!i.co_simulation && (is_on(f, kScas) || is_on(f, kTurbulence)))
    return say(i, fmi3Error, "%s moves on between steps: Co-Simulation has it",
               full_name({Role::setting, is_on(f, kScas) ? kScas : kTurbulence}).text);
  tr_systems s;
  tr_get_systems(&f.sim, &s);
  s.governor = static_cast<std::int32_t>(f.setting[kGovernor]);
  s.conversion = is_on(f, kConversion);
  s.engines = is_on(f, kEngines);
  s.actuators = is_on(f, kActuators);
  s.scas = is_on(f, kScas);
  s.gear = is_on(f, kGear);
  s.ground_effect = is_on(f, kGroundEffect);
  s.turbulence = is_on(f, kTurbulence);
  s.wind_shear = static_cast<std::int32_t>(f.setting[kWindShear]);
  s.interconnect = is_on(f, kInterconnect);
  s.turbulence_seed = static_cast<std::uint64_t>(f.setting[kTurbulenceSeed]);
  s.turbulence_w20_mps = f.setting[kTurbulenceW20];
  s.gear_down = is_on(f, kGearDown);
  for (int k = 0; k < 2; ++k) {
    s.brake[k] = f.setting[kBrakeRight + k];
    s.engine_failed[k] = is_on(f, kEngineFailedRight + k);
  }
  if (with_commands) {
    const double* command = f.input + TR_CONTROLS;
    s.mast_command_deg = degrees(command[0]);
    s.flap_command_deg = degrees(command[1]);
    s.rotor_command_radps = command[2];
    s.throttle[0] = command[3];
    s.throttle[1] = command[4];
  }
  char text[120];
  if (tr_check_systems(&s, TR_API_VERSION, text, sizeof text) != TR_OK)
    return say(i, fmi3Error, "systems: %s", text);
  const fmi3Status status = answer(i, tr_set_systems(&i.flight.sim, &s), "systems", fmi3Error);
  if (status != fmi3OK || i.co_simulation || !is_on(f, kGear)) return status;
  // No step moves it there.
  tr_state state;
  tr_get_state(&i.flight.sim, &state);
  state.x[TR_GEAR] = is_on(f, kGearDown);
  return answer(i, tr_set_state(&i.flight.sim, &state), "gear", fmi3Error);
}

// Controls and commands that the flight has by itself.
void read_inputs(const tr_sim& sim, double* input) {
  tr_state state;
  tr_systems s;
  if (tr_get_state(&sim, &state) != TR_OK || tr_get_systems(&sim, &s) != TR_OK) return;
  for (int j = 0; j < TR_CONTROLS; ++j) input[j] = state.u[j];
  const double command[] = {s.mast_command_deg * kRadians, s.flap_command_deg * kRadians,
                            s.rotor_command_radps, s.throttle[0], s.throttle[1]};
  for (int k = 0; k < TR_INPUTS - TR_CONTROLS; ++k) input[TR_CONTROLS + k] = command[k];
}

bool is_steady(tr_status status) {
  return status == TR_OK || status == TR_WING_STALL || status == TR_CONTROL_LIMIT ||
         status == TR_FLAP_LIMIT || status == TR_VORTEX_RING_STATE || status == TR_POWER_LIMIT ||
         status == TR_TORQUE_LIMIT;
}

fmi3Status trim(Instance& i) {
  Flight& f = i.flight;
  if (!is_on(f, kTrim)) return fmi3OK;
  const double* s = f.setting;
  const tr_flight flight = {s[kTrimSpeed], s[kTrimClimb], s[kTrimTurnRate], s[kTrimSideslip]};
  tr_trim_result result;
  const tr_status status = tr_trim(&f.sim, &i.work, &flight, &result);
  if (status == TR_OK) return fmi3OK;
  return say(i, is_steady(status) ? fmi3Warning : fmi3Error, "trim: %s: %s", tr_status_text(status),
             result.text);
}

fmi3Status worse(fmi3Status a, fmi3Status b) { return a > b ? a : b; }

// States and inputs that were set to other than their start values.
fmi3Status put_given(Instance& i, const double* wanted) {
  Flight& f = i.flight;
  tr_state state;
  tr_get_state(&f.sim, &state);
  for (int k = 0; k < kContinuousStates; ++k)
    if (f.state_given[k]) state.x[k] = f.state[k];
  const fmi3Status status =
      refuse_states(i, tr_set_state(&f.sim, &state), state.x, "start states", fmi3Error);
  if (status != fmi3OK) return status;
  read_inputs(f.sim, f.input);
  f.changed = false;
  for (int j = 0; j < TR_INPUTS; ++j) {
    const fmi3Status put = f.input_given[j] ? put_input(i, j, wanted[j]) : fmi3OK;
    if (put != fmi3OK) return put;
  }
  return fmi3OK;
}

}  // namespace

Instance* opened(fmi3Instance instance, unsigned modes, const char* call) {
  auto* const i = static_cast<Instance*>(instance);
  if (i == nullptr || i->mark != kMark) return nullptr;
  if ((i->flight.mode & modes) != 0) return i;
  say(*i, fmi3Error, "%s is not allowed in %s", call, mode_name(i->flight.mode));
  return nullptr;
}

fmi3Status say(Instance& i, fmi3Status status, const char* format, ...) {
  if (i.log_message == nullptr || !i.logging || (i.categories >> status & 1u) == 0) return status;
  constexpr const char* kCategories[] = {"logEvents", "logStatusWarning", "logStatusDiscard",
                                         "logStatusError", "logStatusFatal"};
  char text[400];
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  i.log_message(i.environment, status, kCategories[status], text);
  return status;
}

fmi3Status answer(Instance& i, tr_status status, const char* call, fmi3Status refused) {
  if (status == TR_OK) return fmi3OK;
  return say(i, refused, "%s: %s: %s", call, tr_status_word(status), tr_status_text(status));
}

fmi3Status begin(Instance& i) {
  Flight& f = i.flight;
  std::memset(&f, 0, sizeof f);
  f.mode = kInstantiated;
  f.changed = true;
  i.told = 0;
  tr_setup setup;
  const tr_status found = tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0), 0.0);
  if (found != TR_OK) return answer(i, found, "instantiate", fmi3Error);
  for (int k = 0; k < kSettings; ++k) f.setting[k] = facts_of(k).start;
  f.setting[kRotorSpeed] = setup.rotor_radps;
  f.setting[kMass] = setup.mass_kg;
  f.setting[kCgStation] = setup.cg_station_m;
  f.setting[kFlap] = setup.flap_deg * kRadians;
  std::memcpy(i.start_setting, f.setting, sizeof f.setting);
  const fmi3Status made = make(i);
  if (made > fmi3Warning) return made;
  tr_state state;
  tr_get_state(&f.sim, &state);
  std::memcpy(i.start_state, state.x, sizeof i.start_state);
  std::memcpy(i.start_input, f.input, sizeof f.input);
  return fmi3OK;
}

fmi3Status make(Instance& i) {
  Flight& f = i.flight;
  if (!f.changed) return fmi3OK;
  tr_setup setup;
  fmi3Status status = make_setup(i, setup);
  if (status > fmi3Warning) return status;
  const tr_status made = tr_init(&f.sim, TR_API_VERSION, &setup);
  if (made != TR_OK) {
    char text[160] = "";
    tr_check_setup(&setup, TR_API_VERSION, text, sizeof text);
    return say(i, fmi3Error, "parameters: %s", text[0] != 0 ? text : tr_status_text(made));
  }
  // A trim holds the gust.
  double held[TR_CONTROLS] = {};
  for (int j = TR_GUST_U; j <= TR_GUST_W; ++j)
    if (f.input_given[j]) held[j] = f.input[j];
  double wanted[TR_INPUTS];
  std::memcpy(wanted, f.input, sizeof wanted);
  status = worse(status, put_environment(i));
  if (status <= fmi3Warning) status = worse(status, put_systems(i, false));
  if (status <= fmi3Warning)
    status = worse(status, answer(i, tr_set_controls(&f.sim, held, TR_CONTROLS), "gust", fmi3Error));
  if (status <= fmi3Warning) status = worse(status, trim(i));
  if (status <= fmi3Warning) status = worse(status, put_given(i, wanted));
  if (status > fmi3Warning) std::memcpy(f.input, wanted, sizeof wanted);
  f.changed = status > fmi3Warning;
  return status;
}

fmi3Status put_states(Instance& i, const double* x) {
  Flight& f = i.flight;
  tr_state state;
  tr_status status = tr_get_state(&f.sim, &state);
  std::memcpy(state.x, x, sizeof(double) * kContinuousStates);
  if (status == TR_OK) status = tr_set_state(&f.sim, &state);
  return refuse_states(i, status, state.x, "continuous states", fmi3Discard);
}

fmi3Status put_input(Instance& i, int index, double value) {
  Flight& f = i.flight;
  const Place place = {Role::input, index};
  if (check_range(i, place, value) != fmi3OK) return fmi3Error;
  const double before = f.input[index];
  if ((f.mode & kBeforeFlight) != 0) {
    f.input_given[index] = value != i.start_input[index];
    if (f.changed) {  // acts when the aircraft is made
      f.input[index] = value;
      return fmi3OK;
    }
  }
  f.input[index] = value;
  if (value == before) return fmi3OK;
  fmi3Status status = fmi3OK;
  if (index < TR_CONTROLS) {
    status = answer(i, tr_set_controls(&f.sim, f.input, TR_CONTROLS), full_name(place).text, fmi3Error);
  } else {
    status = put_systems(i, true);
  }
  if (status != fmi3OK) f.input[index] = before;
  return status == fmi3OK && (f.mode & kBeforeFlight) == 0 ? warn_idle(i, place) : status;
}

fmi3Status put_setting(Instance& i, int index, double value) {
  Flight& f = i.flight;
  const Place place = {Role::setting, index};
  if (check_range(i, place, value) != fmi3OK) return fmi3Error;
  const double before = f.setting[index];
  f.setting[index] = value;
  if ((f.mode & kBeforeFlight) != 0) {
    if (value != before) f.changed = true;
    return fmi3OK;
  }
  if (value == before) return fmi3OK;
  const bool is_wind = index <= kWindDown;
  const fmi3Status status = is_wind ? put_environment(i) : put_systems(i, true);
  if (status != fmi3OK) {
    f.setting[index] = before;
    return status;
  }
  if (is_wind && is_on(f, kEnvironment)) f.jumped = true;
  say(i, fmi3OK, "%s = %.10g from %.10g s on", full_name(place).text, value, f.time);
  return warn_idle(i, place);
}

}  // namespace tiltrotor_fmu

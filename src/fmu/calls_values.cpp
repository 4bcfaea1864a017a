// Calls of the standard: values of variables. Everything is checked before anything is written.
#include <cmath>
#include <cstring>

#include "fmu/instance.hpp"

using namespace tiltrotor_fmu;

namespace {

// What a call has computed once.
struct Reading {
  bool state_read, rates_read, outputs_read, components_read, indicators_read;
  tr_state state;
  double rates[TR_STATES], outputs[kOutputs], indicators[kWheels];
};

fmi3Status read(Instance& i, Place place, Reading& r, double& value) {
  Flight& f = i.flight;
  tr_status status = TR_OK;
  switch (place.role) {
    case Role::time:
      value = f.time;
      return fmi3OK;
    case Role::setting:
      value = f.setting[place.index];
      return fmi3OK;
    case Role::input:
      value = f.input[place.index];
      return fmi3OK;
    case Role::state:
      if (!r.state_read) status = tr_get_state(&f.sim, &r.state);
      r.state_read = true;
      value = r.state.x[place.index];
      break;
    case Role::rate:
      if (!r.rates_read) status = tr_derivative(&f.sim, r.rates, TR_STATES);
      r.rates_read = true;
      value = r.rates[place.index];
      break;
    case Role::indicator:
      if (!r.indicators_read) status = read_indicators(f, r.indicators);
      r.indicators_read = true;
      value = r.indicators[place.index];
      break;
    default: {
      const bool of_components = is_of_components(place);
      bool& done = of_components ? r.components_read : r.outputs_read;
      if (!done) status = of_components ? read_component_outputs(i, r.outputs) : read_outputs(f, r.outputs);
      done = true;
      value = r.outputs[place.index];
    }
  }
  return answer(i, status, full_name(place).text, fmi3Discard);
}

// The instance when the arrays are there and every reference is of the type.
Instance* with_values(fmi3Instance instance, const fmi3ValueReference reference[], size_t references,
                      const void* value, size_t values, Type type, unsigned modes) {
  Instance* const i = opened(instance, modes, "a value");
  if (i == nullptr) return nullptr;
  if (references != values || (references > 0 && (reference == nullptr || value == nullptr))) {
    say(*i, fmi3Error, "%zu references for %zu values, or a null pointer", references, values);
    return nullptr;
  }
  for (size_t k = 0; k < references; ++k) {
    const Place place = place_of(reference[k]);
    if (place.role != Role::none && type_of(place) == type) continue;
    say(*i, fmi3Error, "value reference %u is no variable of this type", static_cast<unsigned>(reference[k]));
    return nullptr;
  }
  return i;
}

template <class T>
fmi3Status get(fmi3Instance instance, const fmi3ValueReference reference[], size_t references, T value[],
               size_t values, Type type) {
  Instance* const i = with_values(instance, reference, references, value, values, type, kAlive);
  if (i == nullptr) return fmi3Error;
  const fmi3Status made = make(*i);
  if (made > fmi3Warning) return made;
  Reading r;
  r.state_read = r.rates_read = r.outputs_read = r.components_read = r.indicators_read = false;
  for (size_t k = 0; k < references; ++k) {
    double number = 0;
    const fmi3Status status = read(*i, place_of(reference[k]), r, number);
    if (status != fmi3OK) return status;
    value[k] = static_cast<T>(number);
  }
  return made;
}

// Whether a variable may be set now.
bool is_settable(const Instance& i, Place place) {
  const bool before = (i.flight.mode & (kInstantiated | kInitialization)) != 0;
  switch (place.role) {
    case Role::state:
      return place.index < kContinuousStates && before;
    case Role::input:
      return true;
    case Role::setting:
      return before || (place.index >= kFirstInputSetting && (i.co_simulation || i.flight.mode == kEvent));
    default:
      return false;
  }
}

// When it may, in words.
const char* when_settable(const Instance& i, Place place) {
  if (place.role == Role::state && place.index < kContinuousStates)
    return i.co_simulation ? "before the end of initialization it can"
                           : "before the end of initialization it can, then by fmi3SetContinuousStates";
  if (place.role != Role::setting) return "it is computed";
  if (place.index < kFirstInputSetting) return "it is fixed from the end of initialization on";
  return "it jumps, in event mode";
}

fmi3Status put(Instance& i, Place place, double value) {
  if (place.role == Role::setting) return put_setting(i, place.index, value);
  if (place.role == Role::input) return put_input(i, place.index, value);
  if (check_range(i, place, value) != fmi3OK) return fmi3Error;
  Flight& f = i.flight;
  f.state_given[place.index] = value != i.start_state[place.index];
  f.state[place.index] = value;
  f.changed = true;
  return fmi3OK;
}

template <class T>
fmi3Status set(fmi3Instance instance, const fmi3ValueReference reference[], size_t references,
               const T value[], size_t values, Type type) {
  Instance* const i = with_values(instance, reference, references, value, values, type,
                                  kInstantiated | kInitialization | kEvent | kContinuous | kStep);
  if (i == nullptr) return fmi3Error;
  for (size_t k = 0; k < references; ++k) {
    const Place place = place_of(reference[k]);
    if (!is_settable(*i, place))
      return say(*i, fmi3Error, "%s cannot be set in %s: %s", full_name(place).text,
                 mode_name(i->flight.mode), when_settable(*i, place));
    const double number = static_cast<double>(value[k]);
    const Range range = range_of(place);
    if (!std::isfinite(number))
      return say(*i, fmi3Error, "%s is no finite number, which lies in %.10g..%.10g", full_name(place).text,
                 range.low, range.high);
  }
  // One bad value and none is set.
  i->before = i->flight;
  fmi3Status worst = fmi3OK;
  for (size_t k = 0; k < references; ++k) {
    const fmi3Status status = put(*i, place_of(reference[k]), static_cast<double>(value[k]));
    if (status > fmi3Warning) {
      i->flight = i->before;
      return status;
    }
    if (status > worst) worst = status;
  }
  return worst;
}

}  // namespace

#define VALUES(name, type)                                                                                 \
  fmi3Status fmi3Get##name(fmi3Instance instance, const fmi3ValueReference reference[], size_t references, \
                           fmi3##name value[], size_t values) {                                            \
    return get(instance, reference, references, value, values, type);                                      \
  }                                                                                                        \
  fmi3Status fmi3Set##name(fmi3Instance instance, const fmi3ValueReference reference[], size_t references, \
                           const fmi3##name value[], size_t values) {                                      \
    return set(instance, reference, references, value, values, type);                                      \
  }
VALUES(Float64, Type::float64)
VALUES(Boolean, Type::boolean)
VALUES(Int64, Type::enumeration)
VALUES(UInt32, Type::uint32)

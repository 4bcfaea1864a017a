// Calls of the standard: the equations for an importer's own integrator.
#include <cmath>
#include <cstring>

#include "fmu/instance.hpp"

using namespace tiltrotor_fmu;

namespace {

constexpr unsigned kEquations = kInitialization | kEvent | kContinuous | kTerminated;

// The instance of a call that takes one number a state, with its aircraft made.
Instance* with_states(fmi3Instance instance, unsigned modes, const void* numbers, size_t count,
                      size_t expected, const char* call) {
  Instance* const i = opened(instance, modes, call);
  if (i == nullptr) return nullptr;
  if (i->co_simulation) {
    say(*i, fmi3Error, "%s is of Model Exchange", call);
  } else if (count != expected || (numbers == nullptr && expected > 0)) {
    say(*i, fmi3Error, "%s takes %zu numbers", call, expected);
  } else if (make(*i) <= fmi3Warning) {
    return i;
  }
  return nullptr;
}

}  // namespace

fmi3Status fmi3CompletedIntegratorStep(fmi3Instance instance, fmi3Boolean, fmi3Boolean* enter_event_mode,
                                       fmi3Boolean* terminate) {
  Instance* const i = opened(instance, kContinuous, "fmi3CompletedIntegratorStep");
  if (i == nullptr) return fmi3Error;
  if (enter_event_mode == nullptr || terminate == nullptr)
    return say(*i, fmi3Error, "fmi3CompletedIntegratorStep: a null pointer");
  *enter_event_mode = *terminate = false;
  return fmi3OK;
}

fmi3Status fmi3SetTime(fmi3Instance instance, fmi3Float64 time) {
  Instance* const i = opened(instance, kEvent | kContinuous, "fmi3SetTime");
  if (i == nullptr) return fmi3Error;
  if (i->co_simulation || !std::isfinite(time))
    return say(*i, fmi3Error, "fmi3SetTime: no time of an integrator");
  i->flight.time = time;
  return fmi3OK;
}

fmi3Status fmi3SetContinuousStates(fmi3Instance instance, const fmi3Float64 states[], size_t count) {
  Instance* const i =
      with_states(instance, kContinuous, states, count, kContinuousStates, "fmi3SetContinuousStates");
  if (i == nullptr) return fmi3Error;
  for (int k = 0; k < kContinuousStates; ++k)
    if (!std::isfinite(states[k]))
      return say(*i, fmi3Error, "continuous states: %s is no finite number",
                 full_name({Role::state, k}).text);
  return put_states(*i, states);
}

fmi3Status fmi3GetContinuousStates(fmi3Instance instance, fmi3Float64 states[], size_t count) {
  Instance* const i =
      with_states(instance, kEquations, states, count, kContinuousStates, "fmi3GetContinuousStates");
  if (i == nullptr) return fmi3Error;
  tr_state state;
  const tr_status status = tr_get_state(&i->flight.sim, &state);
  if (status == TR_OK) std::memcpy(states, state.x, count * sizeof *states);
  return answer(*i, status, "continuous states", fmi3Error);
}

fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance instance, fmi3Float64 derivatives[], size_t count) {
  Instance* const i = with_states(instance, kEquations, derivatives, count, kContinuousStates,
                                  "fmi3GetContinuousStateDerivatives");
  if (i == nullptr) return fmi3Error;
  double rates[TR_STATES];
  const tr_status status = tr_derivative(&i->flight.sim, rates, TR_STATES);
  if (status == TR_OK) std::memcpy(derivatives, rates, count * sizeof *derivatives);
  return answer(*i, status, "derivatives", fmi3Discard);
}

fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance instance, fmi3Float64 nominals[], size_t count) {
  Instance* const i = with_states(instance, kEquations, nominals, count, kContinuousStates,
                                  "fmi3GetNominalsOfContinuousStates");
  if (i == nullptr) return fmi3Error;
  for (int k = 0; k < kContinuousStates; ++k) nominals[k] = nominal_of(unit_of({Role::state, k}));
  return fmi3OK;
}

fmi3Status fmi3GetEventIndicators(fmi3Instance instance, fmi3Float64 indicators[], size_t count) {
  Instance* const i = with_states(instance, kEquations, indicators, count, kWheels, "fmi3GetEventIndicators");
  if (i == nullptr) return fmi3Error;
  double height[kWheels];
  const tr_status status = read_indicators(i->flight, height);
  if (status == TR_OK) std::memcpy(indicators, height, sizeof height);
  return answer(*i, status, "event indicators", fmi3Discard);
}

fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance instance, size_t* count) {
  Instance* const i = opened(instance, kAlive, "fmi3GetNumberOfEventIndicators");
  if (i == nullptr || count == nullptr) return fmi3Error;
  *count = kWheels;
  return fmi3OK;
}

fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance instance, size_t* count) {
  Instance* const i = opened(instance, kAlive, "fmi3GetNumberOfContinuousStates");
  if (i == nullptr || count == nullptr) return fmi3Error;
  *count = kContinuousStates;
  return fmi3OK;
}

// Calls of the standard: life of an instance, modes, steps.
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "fmu/instance.hpp"

using namespace tiltrotor_fmu;

namespace {

constexpr unsigned kFlying = kEvent | kContinuous | kStep;

fmi3Instance instantiate(bool co_simulation, fmi3String name, fmi3String token, bool logging,
                         fmi3InstanceEnvironment environment, fmi3LogMessageCallback log_message) {
  const auto refuse = [&](const char* why) -> fmi3Instance {
    if (log_message != nullptr) log_message(environment, fmi3Error, "logStatusError", why);
    return nullptr;
  };
  if (name == nullptr || name[0] == 0) return refuse("an instance needs a name");
  char own[64];
  instantiation_token(own);
  if (token == nullptr || std::strcmp(token, own) != 0)
    return refuse("the instantiation token is that of another FMU");
  void* const block = std::calloc(1, sizeof(Instance));
  if (block == nullptr) return refuse("no memory for an instance");
  Instance& i = *static_cast<Instance*>(block);
  i.mark = kMark;
  i.co_simulation = co_simulation;
  // What went wrong is told to importers that do not ask for a log, too; events are not.
  i.logging = true;
  i.categories = logging ? ~0u : ~(1u << fmi3OK);
  i.log_message = log_message;
  i.environment = environment;
  i.stop_time = HUGE_VAL;
  if (begin(i) != fmi3OK) {
    std::free(block);
    return refuse("the aircraft of the library cannot be made");
  }
  return block;
}

// Into another mode, from one of `from`.
fmi3Status enter(fmi3Instance instance, unsigned from, bool of_co_simulation, bool of_model_exchange,
                 unsigned to, const char* call) {
  Instance* const i = opened(instance, from, call);
  if (i == nullptr) return fmi3Error;
  if (i->co_simulation ? !of_co_simulation : !of_model_exchange)
    return say(*i, fmi3Error, "%s is of the other interface type", call);
  i->flight.mode = to;
  return fmi3OK;
}

}  // namespace

const char* fmi3GetVersion(void) { return "3.0"; }

fmi3Status fmi3SetDebugLogging(fmi3Instance instance, fmi3Boolean on, size_t categories,
                               const fmi3String category[]) {
  Instance* const i = opened(instance, kAlive, "fmi3SetDebugLogging");
  if (i == nullptr) return fmi3Error;
  if (categories > 0 && category == nullptr) return say(*i, fmi3Error, "categories are missing");
  constexpr const char* kNames[] = {"logEvents", "logStatusWarning", "logStatusDiscard", "logStatusError"};
  std::uint32_t chosen = categories == 0 ? ~0u : 0;
  for (size_t k = 0; k < categories; ++k) {
    std::uint32_t bit = 0;
    for (unsigned n = 0; n < 4; ++n)
      if (category[k] != nullptr && std::strcmp(category[k], kNames[n]) == 0) bit = 1u << n;
    if (bit == 0) return say(*i, fmi3Error, "no such category of the log");
    chosen |= bit;
  }
  i->logging = on;
  i->categories = chosen;
  return fmi3OK;
}

fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String, fmi3Boolean,
                                          fmi3Boolean logging_on, fmi3InstanceEnvironment environment,
                                          fmi3LogMessageCallback log_message) {
  return instantiate(false, name, token, logging_on, environment, log_message);
}

fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String, fmi3Boolean,
                                         fmi3Boolean logging_on, fmi3Boolean event_mode_used, fmi3Boolean,
                                         const fmi3ValueReference[], size_t intermediates,
                                         fmi3InstanceEnvironment environment,
                                         fmi3LogMessageCallback log_message, fmi3IntermediateUpdateCallback) {
  if (event_mode_used || intermediates > 0) {
    if (log_message != nullptr)
      log_message(environment, fmi3Error, "logStatusError",
                  "Co-Simulation here has neither event mode nor intermediate variables");
    return nullptr;
  }
  return instantiate(true, name, token, logging_on, environment, log_message);
}

fmi3Instance fmi3InstantiateScheduledExecution(fmi3String, fmi3String, fmi3String, fmi3Boolean, fmi3Boolean,
                                               fmi3InstanceEnvironment environment,
                                               fmi3LogMessageCallback log_message, fmi3ClockUpdateCallback,
                                               fmi3LockPreemptionCallback, fmi3UnlockPreemptionCallback) {
  if (log_message != nullptr)
    log_message(environment, fmi3Error, "logStatusError", "no Scheduled Execution in this FMU");
  return nullptr;
}

void fmi3FreeInstance(fmi3Instance instance) {
  auto* const i = static_cast<Instance*>(instance);
  if (i == nullptr || i->mark != kMark) return;
  i->mark = 0;
  std::free(i);
}

fmi3Status fmi3EnterInitializationMode(fmi3Instance instance, fmi3Boolean, fmi3Float64,
                                       fmi3Float64 start_time, fmi3Boolean stop_time_defined,
                                       fmi3Float64 stop_time) {
  Instance* const i = opened(instance, kInstantiated, "fmi3EnterInitializationMode");
  if (i == nullptr) return fmi3Error;
  if (!std::isfinite(start_time) || (stop_time_defined && !(stop_time >= start_time)))
    return say(*i, fmi3Error, "start %g and stop %g are no times in order", start_time, stop_time);
  i->flight.time = start_time;
  i->stop_time = stop_time_defined ? stop_time : HUGE_VAL;
  i->flight.mode = kInitialization;
  return fmi3OK;
}

fmi3Status fmi3ExitInitializationMode(fmi3Instance instance) {
  Instance* const i = opened(instance, kInitialization, "fmi3ExitInitializationMode");
  if (i == nullptr) return fmi3Error;
  if (check_given(*i) != fmi3OK) return fmi3Error;
  const fmi3Status status = make(*i);
  if (status > fmi3Warning) return status;
  i->flight.mode = i->co_simulation ? kStep : kEvent;
  say(*i, fmi3OK, "the flight begins at %.10g s", i->flight.time);
  return status;
}

fmi3Status fmi3EnterEventMode(fmi3Instance instance) {
  return enter(instance, kContinuous, false, true, kEvent, "fmi3EnterEventMode");
}
fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance instance) {
  return enter(instance, kEvent, false, true, kContinuous, "fmi3EnterContinuousTimeMode");
}
fmi3Status fmi3Terminate(fmi3Instance instance) {
  const fmi3Status status = enter(instance, kFlying, true, true, kTerminated, "fmi3Terminate");
  if (status != fmi3OK) return status;
  Instance& i = *static_cast<Instance*>(instance);
  return say(i, fmi3OK, "the flight ends at %.10g s", i.flight.time);
}

fmi3Status fmi3Reset(fmi3Instance instance) {
  Instance* const i = opened(instance, kAlive, "fmi3Reset");
  return i == nullptr ? fmi3Error : begin(*i);
}

fmi3Status fmi3UpdateDiscreteStates(fmi3Instance instance, fmi3Boolean* need_update, fmi3Boolean* terminate,
                                    fmi3Boolean* nominals_changed, fmi3Boolean* states_changed,
                                    fmi3Boolean* next_time_defined, fmi3Float64* next_time) {
  Instance* const i = opened(instance, kEvent, "fmi3UpdateDiscreteStates");
  if (i == nullptr) return fmi3Error;
  if (need_update == nullptr || terminate == nullptr || nominals_changed == nullptr ||
      states_changed == nullptr || next_time_defined == nullptr || next_time == nullptr)
    return say(*i, fmi3Error, "fmi3UpdateDiscreteStates: a null pointer");
  *need_update = *terminate = *nominals_changed = *next_time_defined = false;
  *next_time = 0;
  *states_changed = i->flight.jumped;
  i->flight.jumped = false;
  if (*states_changed) say(*i, fmi3OK, "at %.10g s the wind makes the states jump", i->flight.time);
  return fmi3OK;
}

fmi3Status fmi3DoStep(fmi3Instance instance, fmi3Float64 time, fmi3Float64 step, fmi3Boolean,
                      fmi3Boolean* event_handling_needed, fmi3Boolean* terminate, fmi3Boolean* early_return,
                      fmi3Float64* last_successful_time) {
  Instance* const i = opened(instance, kStep, "fmi3DoStep");
  if (i == nullptr) return fmi3Error;
  if (event_handling_needed == nullptr || terminate == nullptr || early_return == nullptr ||
      last_successful_time == nullptr)
    return say(*i, fmi3Error, "fmi3DoStep: a null pointer");
  Flight& f = i->flight;
  constexpr double kLongest = 1e6;  // s
  if (!std::isfinite(time) || !(step > 0 && step <= kLongest))
    return say(*i, fmi3Error, "a step of %g s at %g s: both must be finite, the step 0..%g s", step, time,
               kLongest);
  if (std::abs(time - f.time) > 1e-9 * (1 + std::abs(f.time)))
    return say(*i, fmi3Error, "the step begins at %.17g s, the aircraft is at %.17g s", time, f.time);
  if (time + step > i->stop_time + 1e-9 * (1 + std::abs(i->stop_time)))
    return say(*i, fmi3Error, "the step ends at %.17g s, after the stop time %.17g s", time + step,
               i->stop_time);
  *event_handling_needed = *terminate = *early_return = false;
  *last_successful_time = time;
  i->before = f;
  // A step as long as the longest but for rounding is one.
  const double parts = std::ceil(step / f.setting[kLongestStep] * (1 - 1e-12));
  for (double k = 0; k < parts; ++k) {
    const tr_status status = tr_step(&f.sim, &i->work, step / parts);
    if (status != TR_OK) {
      refuse_step(*i, status, time);
      f = i->before;
      return fmi3Discard;
    }
  }
  f.time = *last_successful_time = time + step;
  return fmi3OK;
}

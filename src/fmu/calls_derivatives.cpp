// Calls of the standard: exact partial derivatives, and what depends on what.
#include <cmath>
#include <cstring>
#include <initializer_list>

#include "fmu/instance.hpp"

using namespace tiltrotor_fmu;

namespace {

constexpr unsigned kEquations = kInitialization | kEvent | kContinuous | kStep | kTerminated;

bool is_known(Place p) {
  return (p.role == Role::state && p.index < kContinuousStates) || p.role == Role::input;
}
bool is_unknown(Place p) {
  return p.role == Role::rate || p.role == Role::output || p.role == Role::indicator ||
         (p.role == Role::state && p.index < kContinuousStates);
}

// One column: everything along dx and du.
struct Direction {
  double dx[TR_STATES], du[TR_INPUTS], dxdot[TR_STATES], doutput[kOutputs], dindicator[kWheels];
};

// Where the air follows the altitude and no system is on, tr_directional holds the air. With ground effect and no
// ground, which change no number, it knows the air as well.
const tr_sim& with_air(Instance& i) {
  tr_sim& copy = i.before.sim;
  tr_systems s;
  if (tr_get_systems(&i.flight.sim, &s) != TR_OK) return i.flight.sim;
  const bool any = s.governor != 0 || s.conversion != 0 || s.engines != 0 || s.actuators != 0 ||
                   s.scas != 0 || s.gear != 0 || s.ground_effect != 0 || s.wind_shear != 0 ||
                   s.turbulence != 0;
  if (any || i.flight.setting[kEnvironment] == 0) return i.flight.sim;
  copy = i.flight.sim;
  s.ground_effect = 1;
  return tr_set_systems(&copy, &s) == TR_OK ? copy : i.flight.sim;
}

fmi3Status along(Instance& i, const tr_sim& sim, bool components, Direction& d) {
  tr_outputs outputs;
  tr_status status = tr_directional_inputs(&sim, &i.work, d.dx, d.du, d.dxdot, &outputs);
  if (status == TR_OK) slopes_of_outputs(i.flight, d.dx, outputs, d.doutput);
  if (status == TR_OK) status = slopes_of_indicators(i.flight, d.dx, d.dindicator);
  if (status == TR_OK && components) status = slopes_of_component_outputs(i, d.dx, d.du, d.doutput);
  return answer(i, status, "derivative along a direction", fmi3Discard);
}

bool any_of_components(const fmi3ValueReference unknown[], size_t unknowns) {
  for (size_t k = 0; k < unknowns; ++k)
    if (is_of_components(place_of(unknown[k]))) return true;
  return false;
}

double& seed_of(Direction& d, Place p) { return p.role == Role::state ? d.dx[p.index] : d.du[p.index]; }
double result_of(const Direction& d, Place p) {
  return p.role == Role::rate        ? d.dxdot[p.index]
         : p.role == Role::output    ? d.doutput[p.index]
         : p.role == Role::indicator ? d.dindicator[p.index]
                                     : d.dx[p.index];
}

Instance* with_directions(fmi3Instance instance, const fmi3ValueReference unknown[], size_t unknowns,
                          const fmi3ValueReference known[], size_t knowns, const fmi3Float64 seed[],
                          size_t seeds, size_t expected_seeds, const fmi3Float64 sensitivity[],
                          size_t sensitivities, size_t expected) {
  Instance* const i = opened(instance, kEquations, "a partial derivative");
  if (i == nullptr) return nullptr;
  if ((unknowns > 0 && unknown == nullptr) || (knowns > 0 && known == nullptr) || seeds != expected_seeds ||
      (seeds > 0 && seed == nullptr) || sensitivities != expected ||
      (expected > 0 && sensitivity == nullptr)) {
    say(*i, fmi3Error,
        "a partial derivative: %zu seeds for %zu, %zu sensitivities for %zu, or a null pointer", seeds,
        expected_seeds, sensitivities, expected);
    return nullptr;
  }
  const auto refuse = [&](fmi3ValueReference reference, const char* what) {
    say(*i, fmi3Error, "value reference %u: %s", static_cast<unsigned>(reference), what);
    return nullptr;
  };
  for (size_t k = 0; k < unknowns; ++k)
    if (!is_unknown(place_of(unknown[k])))
      return refuse(unknown[k], "no derivative, output, event indicator or continuous state");
  for (size_t k = 0; k < knowns; ++k)
    if (!is_known(place_of(known[k]))) return refuse(known[k], "no continuous state or continuous input");
  for (size_t k = 0; k < seeds; ++k)
    if (!std::isfinite(seed[k])) {
      say(*i, fmi3Error, "a partial derivative: seed %zu is no finite number", k);
      return nullptr;
    }
  return make(*i) <= fmi3Warning ? i : nullptr;
}

// Dependencies of rates and outputs, one after another; how many.
template <class Each>
size_t each_dependency(Place unknown, Each&& each) {
  size_t count = 0;
  for (const Role role : {Role::state, Role::input})
    for (int k = 0; k < (role == Role::state ? kContinuousStates : static_cast<int>(TR_INPUTS)); ++k)
      if (depends(unknown, {role, k})) each(count++, reference_of(role, k));
  return count;
}

}  // namespace

fmi3Status fmi3GetDirectionalDerivative(fmi3Instance instance, const fmi3ValueReference unknown[],
                                        size_t unknowns, const fmi3ValueReference known[], size_t knowns,
                                        const fmi3Float64 seed[], size_t seeds, fmi3Float64 sensitivity[],
                                        size_t sensitivities) {
  Instance* const i = with_directions(instance, unknown, unknowns, known, knowns, seed, seeds, knowns,
                                      sensitivity, sensitivities, unknowns);
  if (i == nullptr) return fmi3Error;
  Direction d;
  std::memset(&d, 0, sizeof d);
  for (size_t k = 0; k < knowns; ++k) seed_of(d, place_of(known[k])) += seed[k];
  const fmi3Status status = along(*i, with_air(*i), any_of_components(unknown, unknowns), d);
  if (status != fmi3OK) return status;
  for (size_t k = 0; k < unknowns; ++k) sensitivity[k] = result_of(d, place_of(unknown[k]));
  return fmi3OK;
}

// By columns: a direction for every known.
fmi3Status fmi3GetAdjointDerivative(fmi3Instance instance, const fmi3ValueReference unknown[],
                                    size_t unknowns, const fmi3ValueReference known[], size_t knowns,
                                    const fmi3Float64 seed[], size_t seeds, fmi3Float64 sensitivity[],
                                    size_t sensitivities) {
  Instance* const i = with_directions(instance, unknown, unknowns, known, knowns, seed, seeds, unknowns,
                                      sensitivity, sensitivities, knowns);
  if (i == nullptr) return fmi3Error;
  const tr_sim& sim = with_air(*i);
  const bool components = any_of_components(unknown, unknowns);
  for (size_t k = 0; k < knowns; ++k) {
    Direction d;
    std::memset(&d, 0, sizeof d);
    seed_of(d, place_of(known[k])) = 1;
    const fmi3Status status = along(*i, sim, components, d);
    if (status != fmi3OK) return status;
    double sum = 0;
    for (size_t n = 0; n < unknowns; ++n) sum += seed[n] * result_of(d, place_of(unknown[n]));
    sensitivity[k] = sum;
  }
  return fmi3OK;
}

fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance instance, fmi3ValueReference reference,
                                               size_t* count) {
  Instance* const i = opened(instance, kAlive, "fmi3GetNumberOfVariableDependencies");
  if (i == nullptr || count == nullptr) return fmi3Error;
  if (!is_unknown(place_of(reference)))
    return say(*i, fmi3Error, "value reference %u has no dependencies", static_cast<unsigned>(reference));
  *count = each_dependency(place_of(reference), [](size_t, fmi3ValueReference) {});
  return fmi3OK;
}

fmi3Status fmi3GetVariableDependencies(fmi3Instance instance, fmi3ValueReference dependent,
                                       size_t dependent_element[], fmi3ValueReference independent[],
                                       size_t independent_element[], fmi3DependencyKind kind[],
                                       size_t count) {
  size_t found = 0;
  if (fmi3GetNumberOfVariableDependencies(instance, dependent, &found) != fmi3OK) return fmi3Error;
  Instance& i = *static_cast<Instance*>(instance);
  if (count != found || (found > 0 && (dependent_element == nullptr || independent == nullptr ||
                                       independent_element == nullptr || kind == nullptr)))
    return say(i, fmi3Error, "%zu dependencies, not %zu, or a null pointer", found, count);
  each_dependency(place_of(dependent), [&](size_t k, fmi3ValueReference reference) {
    dependent_element[k] = independent_element[k] = 0;
    independent[k] = reference;
    kind[k] = fmi3Dependent;
  });
  return fmi3OK;
}

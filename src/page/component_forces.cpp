#include "page/component_forces.h"

#include "library/c_memory.hpp"
#include "tiltrotor/model/derivative.hpp"

static_assert(COMPONENTS == tiltrotor::component_count);

tr_status component_forces(const tr_sim* sim, tr_real* forces) {
  using namespace tiltrotor::c_interface;
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  const Sim& s = *opened(sim);
  tiltrotor::Configuration<R> c;
  tiltrotor::Evaluation<R> found;
  evaluate_aircraft(equipped(s, c), evaluated_state(s), s.u, found);
  for (int k = 0; k < COMPONENTS; ++k) flatten(found.loads.component[k].force, forces + 3 * k);
  return all_finite(forces, 3 * COMPONENTS) ? TR_OK : TR_NOT_FINITE;
}

const char* component_name(int32_t component) {
  return component >= 0 && component < COMPONENTS ? tiltrotor::kComponentNames[component] : "";
}

/* What the C interface has only the sum of: the force of every component, body axes, N, three numbers a component in the
 * order of kComponentNames. Of the state as it is, systems at rest; TR_NOT_FINITE: as computed. */
#ifndef TILTROTOR_PAGE_COMPONENT_FORCES_H
#define TILTROTOR_PAGE_COMPONENT_FORCES_H

#include "tiltrotor/tiltrotor.h"

enum { COMPONENTS = 13 };

#ifdef __cplusplus
extern "C" {
#endif
tr_status component_forces(const tr_sim* sim, tr_real* forces);
const char* component_name(int32_t component); /* or "" */
#ifdef __cplusplus
}
#endif

#endif

// Masses, inertia and masts of the aircraft.
#pragma once

#include "tiltrotor/model/aircraft/mast_range.hpp"

namespace tiltrotor {

template <class R>
struct Inertia {  // moments and product of inertia about the CG, kg m^2; xz = integral of x z dm
  R xx, yy, zz, xz;
};

template <class R>
struct MassTables {
  R gross;                   // weight_gross, kg
  R nacelles;                // weight_pylons_printed_cg, kg: the part that tilts
  R nacelles_quoted;         // weight_pylons_both, kg, the alternative
  R sl_cg, wl_cg;            // SL_CG_aft_helicopter, WL_CG_helicopter: CG at mast 0, m
  R sl_nacelle, wl_nacelle;  // SL_pylon_CG, WL_pylon_CG: CG of the tilting part at mast 0, m
  R nacelle_gyration;        // choices: nacelle_gyration, of the tilting part about its own CG in pitch, m
  Inertia<R> inertia;        // Ixx_0 .. Ixz_0 at mast 0, for the gross weight
  Inertia<R> inertia_slope;  // dIxx_dbm .. dIxz_dbm, kg m^2 per degree of mast angle
  R flown_pitch, flown_yaw;  // choices: flown_inertia_pitch, flown_inertia_yaw, over the inertia above
  Inertia<R> design_0;       // I.._helicopter_1975: 1975 design estimate (xz of the set above)
  Inertia<R> design_90;      // I.._airplane_1975
};

template <class R>
struct MastTables {
  R sl_pivot, bl_pivot, wl_pivot;  // conversion axis, m
  R length;                        // mast_length, pivot to hub, m
  R cant;                          // mast_outboard_tilt_phi_m, outboard tilt at mast 0, rad
};

}  // namespace tiltrotor

// Where the inflow law gives the inflow of a descending rotor, and where it does not.
//
// Over v_h = sqrt(T / 2 rho A), descent negative. Around axial descent between -0.45 and -2 a rotor flies in
// its own wake (vortex ring, turbulent wake) and there is no stream tube to balance: Johnson, Model for
// Vortex Ring State Influence on Rotorcraft Flight Dynamics, NASA/TP-2005-213477. Two of its curves bound the
// region:
//
//   the ellipse outside of which momentum theory is used     (2 Vz + 3)^2 + Vx^2 < 1
//   the stability boundary from Vz = -0.45 to -1.50          Vx < 0.95, between
//       -0.975 + 0.525 (1 - (Vx/0.95)^2)^0.2 and -0.975 - 0.525 (1 - (Vx/0.95)^2)^1.5
//
// With the inflow of measured rotors there (descent_inflow=vortex_ring, model/rotor/vortex_ring.hpp) only the
// second counts: inside, heave is unstable and thrust unsteady, which no mean inflow shows.
//
// By momentum theory alone, in faster descent the equation v sqrt(Vx^2 + (Vz + v)^2) = v_h^2 has up to three roots. The least is that
// of the windmill; in the others the wake goes down, against the air that comes up and carries it away.
#pragma once

#include <cmath>

#include "tiltrotor/model/rotor/vortex_ring.hpp"
#include "tiltrotor/model/variables/options.hpp"

namespace tiltrotor {

enum class MomentumRange : unsigned char { holds, vortex_ring, other_branch };

// Speeds of the air's relative motion at one rotor, m/s.
template <class R>
struct AxialFlow {
  R axial;     // climb speed along the thrust: negative where the rotor moves against its thrust
  R in_plane;  // >= 0
  R induced;   // mean, + against the thrust
  R hover;     // v_h, >= 0
};

// Axial, in-plane and induced speed counted along the thrust, which may point down the shaft.
template <class R>
AxialFlow<R> axial_flow(R density, R radius, R thrust, R axial, R in_plane, R induced) {
  const R sign = thrust < R(0) ? R(-1) : R(1);
  const R disk = kPi<R> * radius * radius;
  return {sign * axial, std::fabs(in_plane), sign * induced,
          std::sqrt(std::fabs(thrust) / (R(2) * density * disk))};
}

// Nothing is divided by v_h: an idle rotor has none.
template <class R>
MomentumRange momentum_range(const AxialFlow<R>& f, DescentInflow law) {
  using Ring = VortexRing<R>;
  const R h = f.hover;
  const R spread = f.in_plane / Ring::kInPlane;
  const R middle = R(0.5) * (Ring::kEnd + Ring::kOnset), half = R(0.5) * (Ring::kEnd - Ring::kOnset);
  const R room = h * h - spread * spread;  // 1 - (Vx/0.95)^2
  const R above = (f.axial + middle * h) / half;
  const R above2 = above * above;
  const bool unstable = room > R(0) && (above > R(0) ? above2 * above2 * above < room * h * h * h
                                                     : above2 * h * h * h * h < room * room * room);
  if (unstable) return MomentumRange::vortex_ring;
  if (law == DescentInflow::vortex_ring) return MomentumRange::holds;
  const R centre = R(2) * f.axial + R(3) * h;
  if (centre * centre + f.in_plane * f.in_plane < h * h) return MomentumRange::vortex_ring;

  const R discriminant = f.axial * f.axial - R(8) * f.in_plane * f.in_plane;
  const bool has_branches = f.axial < R(-1.5) * h && discriminant > R(0);
  const bool beyond = has_branches && f.induced > (R(-3) * f.axial - std::sqrt(discriminant)) / R(4);
  return beyond ? MomentumRange::other_branch : MomentumRange::holds;
}

}  // namespace tiltrotor

// Mean inflow of a rotor in its own wake: vortex ring and turbulent wake, from gentle descent to the windmill.
//
// There is no stream tube to balance; measured rotors decide. With the descent d and the total inflow, both over
// v_h = sqrt(T / 2 rho A), in axial flow the curve goes through
//
//   D  d = 0.20   momentum theory
//   N      0.45   0.85 } no slope; between them more descent draws more air down through the disk: less
//   X      1.50   1.25 } thrust, unstable in heave
//   W      2.30   momentum theory, windmill
//
// D, N, X: Johnson, Model for Vortex Ring State Influence on Rotorcraft Flight Dynamics, NASA/TP-2005-213477,
// with his cubic from N to X. His curve ends with a kink at d = 2.1; here each piece is the quintic whose value,
// slope and curvature agree with its neighbours', and the windmill's momentum theory begins at W (choice
// windmill_descent): within 0.2 v_h of his curve.
//
// The law of the inflow states asks the other way round: mass flow through the disk for a given inflow. Along
// the curve the ratio t of descent to induced velocity grows with d, so each t belongs to one d, where
// V_T / lambda_0 is (v_h / v)^2 and V_m = d(V_T lambda_0) / d(lambda_0), as in momentum theory. Thrust does not
// enter; for each thrust and descent there is one equilibrium, and it is stable. Speed in the plane of the disk
// adds nothing to the mass flow of the ring, which fades until that speed reaches ring_in_plane (choice) times
// the induced velocity.
#pragma once

#include <cmath>
#include <limits>

#include "tiltrotor/math/scalar.hpp"

namespace tiltrotor {

// The curve between two branches of momentum theory: NASA/TP-2005-213477. Speeds over v_h.
template <class R>
struct VortexRing {
  static constexpr R kStart = R(0.2);                           // D
  static constexpr R kOnset = R(0.45), kOnsetInflow = R(0.85);  // N
  static constexpr R kEnd = R(1.5), kEndInflow = R(1.25);       // X
  static constexpr R kInPlane = R(0.95);                        // the boundary from N to X closes here
};

namespace vortex_ring_curve {

// Total inflow over v_h at a descent, and its derivatives.
template <class R>
struct CurvePoint {
  R descent, inflow, slope, curvature;
};

// v^2 |v - d| = 1. `branch`: 1 wake below the disk, -1 windmill (d > 2).
template <class R>
CurvePoint<R> momentum_theory(R descent, R branch) {
  const R root = ScalarTraits<R>::sqrt(R(0.25) * descent * descent + branch);
  return {descent, R(-0.5) * descent + branch * root, R(-0.5) + R(0.25) * branch * descent / root,
          R(0.25) / (root * root * root)};
}

// The quintic from a to b.
template <class R>
CurvePoint<R> between(const CurvePoint<R>& a, const CurvePoint<R>& b, R descent) {
  const R h = b.descent - a.descent;
  const R s = (descent - a.descent) / h;
  const R a1 = h * a.slope, a2 = R(0.5) * h * h * a.curvature;
  const R rise = b.inflow - a.inflow - a1 - a2;
  const R turn = h * b.slope - a1 - R(2) * a2;
  const R bend = R(0.5) * h * h * b.curvature - a2;
  const R a3 = R(10) * rise - R(4) * turn + bend;
  const R a4 = R(-15) * rise + R(7) * turn - R(2) * bend;
  const R a5 = R(6) * rise - R(3) * turn + bend;
  return {descent, a.inflow + s * (a1 + s * (a2 + s * (a3 + s * (a4 + s * a5)))),
          (a1 + s * (R(2) * a2 + s * (R(3) * a3 + s * (R(4) * a4 + s * R(5) * a5)))) / h,
          (R(2) * a2 + s * (R(6) * a3 + s * (R(12) * a4 + s * R(20) * a5))) / (h * h)};
}

// A place on the curve, and the part of the ring there: 0 at D, 1 from N to X, 0 at W; slope along descent.
template <class R>
struct RingPlace {
  CurvePoint<R> at;
  R part, part_slope;
};

// Where the descent is t times the induced velocity; false, and nothing written, where momentum theory holds.
// Newton's method on a ratio that falls throughout: 8 steps are enough.
template <class R>
bool find_ring_place(R t, R windmill_descent, RingPlace<R>& out) {
  using Curve = VortexRing<R>;
  const R span = Curve::kEnd - Curve::kOnset;
  const R bend =
      R(6) * (Curve::kEndInflow - Curve::kOnsetInflow) / (span * span);  // of the cubic from N to X
  const CurvePoint<R> point[4] = {momentum_theory(Curve::kStart, R(1)),
                                  {Curve::kOnset, Curve::kOnsetInflow, R(0), bend},
                                  {Curve::kEnd, Curve::kEndInflow, R(0), -bend},
                                  momentum_theory(windmill_descent, R(-1))};
  int piece = -1;
  while (piece < 3 && t * (point[piece + 1].inflow + point[piece + 1].descent) > point[piece + 1].descent)
    ++piece;
  if (piece < 0 || piece > 2) return false;
  const R ratio = R(1) / t - R(1);  // total inflow over descent
  const R low = point[piece].descent, high = point[piece + 1].descent;
  CurvePoint<R> at{R(0.5) * (low + high), R(0), R(0), R(0)};
  for (int k = 0; k < 12; ++k) {
    at = between(point[piece], point[piece + 1], at.descent);
    const R wanted =
        at.descent + (at.inflow - ratio * at.descent) * at.descent / (at.inflow - at.descent * at.slope);
    const R next = wanted < low ? low : wanted > high ? high : wanted;
    using std::fabs;
    const bool found = fabs(next - at.descent) <= R(4) * std::numeric_limits<R>::epsilon();
    at.descent = next;
    if (found) break;
  }
  const R s = (at.descent - low) / (high - low);
  const R step = s * s * s * (R(10) + s * (R(-15) + R(6) * s));
  const R step_slope = R(30) * square(s * (R(1) - s)) / (high - low);
  const R sign = static_cast<R>(1 - piece);
  out = {at, piece == 0 ? step : piece == 1 ? R(1) : R(1) - step, sign * step_slope};
  return true;
}

// What the ring adds to V_T^2 and V_T V_m, and its slopes along mu_z, lambda_0 and in_plane2.
template <class R>
struct RingTerms {
  R mass_flow, mass_flow_slope[3];
  R harmonics, harmonics_slope[3];
};

// For axial speed z, mean inflow v and square of the in-plane speed p; false where momentum theory holds.
template <class R>
bool ring_terms(R z, R v, R p, R windmill_descent, R ring_in_plane, RingTerms<R>& out) {
  const R inverse = R(1) / square(ring_in_plane);
  if (!(z * v < R(0) && p * inverse < square(v))) return false;
  const R t = -z / v;
  RingPlace<R> ring;
  if (!find_ring_place(t, windmill_descent, ring)) return false;
  const CurvePoint<R>& at = ring.at;
  const R fall = at.inflow - at.descent * at.slope;  // positive: d^2 times the fall of the ratio
  const R induced = at.inflow + at.descent, i2 = square(induced);
  const R rise = R(1) + at.slope;
  const R part_slope = ring.part_slope * i2 / fall;
  const R q = p / square(v);
  const R rest = R(1) - q * inverse;
  const R weight = square(rest), weight_slope = R(-2) * inverse * rest;
  // lambda_0^2 weight (f(t) - part(t) q)
  const auto term = [&](R f, R f_slope, R(&slope)[3]) {
    const R net = f - ring.part * q;
    const R by_t = weight * (f_slope - part_slope * q);
    const R by_q = weight_slope * net - weight * ring.part;
    slope[0] = -v * by_t;
    slope[1] = R(2) * v * (weight * net - q * by_q) + z * by_t;
    slope[2] = by_q;
    return square(v) * weight * net;
  };
  out.mass_flow = term(R(1) / square(i2) - square(R(1) - t),
                       R(2) * (R(1) - t) - R(4) * rise / (i2 * induced * fall), out.mass_flow_slope);
  out.harmonics =
      term(R(2) / (i2 * induced * fall) - (R(1) - t) * (R(2) - t),
           R(2) * (at.descent * at.curvature / (induced * fall) - R(3) * rise / i2) / square(fall) + R(3) -
               R(2) * t,
           out.harmonics_slope);
  return true;
}

// A number with its slopes along three arguments.
template <class T>
T extended(Real<T> f, const Real<T> (&slope)[3], const T* const (&x)[3]) {
  if constexpr (ScalarTraits<T>::kTakesSlopes) {
    return ScalarTraits<T>::template from_slopes<3>(f, slope, x);
  } else {
    T sum = f;
    for (int a = 0; a < 3; ++a) sum = sum + slope[a] * (*x[a] - value(*x[a]));
    return sum;
  }
}

}  // namespace vortex_ring_curve

// Adds to V_T^2 (`mass_flow`) and V_T V_m (`harmonics`) of the inflow law; false, and nothing added, where
// momentum theory holds. The choice of the branch is safe: value and slope agree at every end, D, W and the
// speed in the plane where the ring has faded.
template <class T>
bool add_vortex_ring(const T& mu_z, const T& lambda_0, const T& in_plane2, Real<T> windmill_descent,
                     Real<T> ring_in_plane, T& mass_flow, T& harmonics) {
  using namespace vortex_ring_curve;
  RingTerms<Real<T>> ring;
  if (!ring_terms(value(mu_z), value(lambda_0), value(in_plane2), windmill_descent, ring_in_plane, ring))
    return false;
  const T* const x[3] = {&mu_z, &lambda_0, &in_plane2};
  mass_flow = mass_flow + extended(ring.mass_flow, ring.mass_flow_slope, x);
  harmonics = harmonics + extended(ring.harmonics, ring.harmonics_slope, x);
  return true;
}

}  // namespace tiltrotor

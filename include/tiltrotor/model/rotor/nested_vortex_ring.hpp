// The law of vortex_ring.hpp on nested dual numbers, whose second derivatives its slopes do not give: the same formulas
// in their arithmetic. The place on the curve is found on plain numbers; each step of Newton's method in the arithmetic of
// the derivatives then makes one more order of them exact.
#pragma once

#include "tiltrotor/math/differentiation/nested_dual.hpp"
#include "tiltrotor/model/rotor/vortex_ring.hpp"

namespace tiltrotor {

namespace nested_vortex_ring {

template <class T>
vortex_ring_curve::CurvePoint<T> constant(const vortex_ring_curve::CurvePoint<Real<T>>& p) {
  return {T(p.descent), T(p.inflow), T(p.slope), T(p.curvature)};
}

}  // namespace nested_vortex_ring

template <class D>
bool add_vortex_ring(const Nested<D>& mu_z, const Nested<D>& lambda_0, const Nested<D>& in_plane2,
                     Real<D> windmill_descent, Real<D> ring_in_plane, Nested<D>& mass_flow,
                     Nested<D>& harmonics) {
  using namespace vortex_ring_curve;
  using T = Nested<D>;
  using R = Real<D>;
  RingTerms<R> plain;
  RingPlace<R> place;
  if (!ring_terms(value(mu_z), value(lambda_0), value(in_plane2), windmill_descent, ring_in_plane, plain))
    return false;
  const T t = -mu_z / lambda_0;
  if (!find_ring_place(value(t), windmill_descent, place)) return false;

  // As find_ring_place() has them.
  using Curve = VortexRing<R>;
  const R bend = R(6) * (Curve::kEndInflow - Curve::kOnsetInflow) / square(Curve::kEnd - Curve::kOnset);
  const CurvePoint<R> point[4] = {momentum_theory(Curve::kStart, R(1)),
                                  {Curve::kOnset, Curve::kOnsetInflow, R(0), bend},
                                  {Curve::kEnd, Curve::kEndInflow, R(0), -bend},
                                  momentum_theory(windmill_descent, R(-1))};
  const int piece = place.at.descent < Curve::kOnset ? 0 : place.at.descent < Curve::kEnd ? 1 : 2;
  const CurvePoint<T> low = nested_vortex_ring::constant<T>(point[piece]);
  const CurvePoint<T> high = nested_vortex_ring::constant<T>(point[piece + 1]);
  const T ratio = R(1) / t - R(1);
  CurvePoint<T> at = between(low, high, T(place.at.descent));
  for (int order = 1; order <= 2; ++order)
    at = between(
        low, high,
        T(at.descent + (at.inflow - ratio * at.descent) * at.descent / (at.inflow - at.descent * at.slope)));

  const T fall = at.inflow - at.descent * at.slope;
  const T induced = at.inflow + at.descent, i2 = square(induced);
  const T s = (at.descent - low.descent) / (high.descent - low.descent);
  const T step = s * s * s * (R(10) + s * (R(-15) + R(6) * s));
  const T part = piece == 0 ? step : piece == 1 ? T(R(1)) : T(R(1) - step);
  const T q = in_plane2 / square(lambda_0);
  const T weight = square(T(R(1) - q * (R(1) / square(ring_in_plane))));
  const auto term = [&](const T& f) { return square(lambda_0) * weight * (f - part * q); };
  const T left = R(1) - t;
  mass_flow = mass_flow + term(R(1) / square(i2) - square(left));
  harmonics = harmonics + term(R(2) / (i2 * induced * fall) - left * (R(2) - t));
  return true;
}

}  // namespace tiltrotor

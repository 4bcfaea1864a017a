// Place on the earth of an aircraft whose position counts over a plane.
//
// The plane touches the ellipsoid WGS-84 (NIMA TR 8350.2) below its origin. From there to earth-centred coordinates
// exactly, in axes turned by the longitude of the origin: x in its meridian, y east, z along the axis; and back by
// Bowring's iteration (Survey Review 23, 1976) on the reduced latitude beta, p = sqrt(x^2 + y^2):
//   tan(phi) = (z + e'^2 b sin^3(beta)) / (p - e^2 a cos^3(beta)),   tan(beta) = (1 - f) tan(phi)
// Each turn takes the error times 1e-5 or less near the earth: two are enough from 1000 km below its surface on, three
// are made. Sines and cosines are carried on as they are, without an angle between.
#pragma once

#include "tiltrotor/math/vector.hpp"

namespace tiltrotor {

template <class R>
struct GeodeticPlace {
  R latitude, longitude;  // rad, + north and east
  R height;               // over the ellipsoid, m
};

namespace geodetic_detail {

template <class R>
inline constexpr R kEquator = R(6378137);  // m
template <class R>
inline constexpr R kFlattening = R(1) / R(298.257223563);
template <class R>
inline constexpr R kPolar = kEquator<R>*(R(1) - kFlattening<R>);  // b, m
template <class R>
inline constexpr R kEccentricity2 = kFlattening<R>*(R(2) - kFlattening<R>);  // e^2
template <class R>
inline constexpr R kSecondEccentricity2 = kEccentricity2<R> / (R(1) - kEccentricity2<R>);  // e'^2

template <class R>
SineCosine<R> direction(R along_sine, R along_cosine) {
  const R unit = R(1) / length_of(along_cosine, along_sine);
  return {along_sine * unit, along_cosine * unit};
}

// Of the geodetic latitude of a point of the meridian, not at the centre of the earth.
template <class R>
SineCosine<R> latitude_of(R p, R z) {
  SineCosine<R> latitude{};
  SineCosine<R> reduced = direction(kEquator<R> * z, kPolar<R> * p);
  for (int turn = 0; turn < 3; ++turn) {
    const R s3 = reduced.sine * square(reduced.sine), c3 = reduced.cosine * square(reduced.cosine);
    latitude =
        direction(z + kSecondEccentricity2<R> * kPolar<R> * s3, p - kEccentricity2<R> * kEquator<R> * c3);
    reduced = direction((R(1) - kFlattening<R>)*latitude.sine, latitude.cosine);
  }
  return latitude;
}

}  // namespace geodetic_detail

// `position`: north, east, down of the plane, m.
template <class R>
GeodeticPlace<R> geodetic_place(const GeodeticPlace<R>& origin, const Vec3<R>& position) {
  using namespace geodetic_detail;
  const SineCosine<R> o = sine_cosine(origin.latitude);
  const R curvature =
      kEquator<R> / std::sqrt(R(1) - kEccentricity2<R> * square(o.sine));  // radius, east and west
  const R up = origin.height - position.z;
  const R x = (curvature + up) * o.cosine - position.x * o.sine;
  const R z = (curvature * (R(1) - kEccentricity2<R>)+up) * o.sine + position.x * o.cosine;
  const R p = length_of(x, position.y);

  const SineCosine<R> l = latitude_of(p, z);
  const R east = origin.longitude + arctangent2(position.y, x);
  const R whole = R(2) * kPi<R>;
  GeodeticPlace<R> place;
  place.latitude = arctangent2(l.sine, l.cosine);
  place.longitude = east > kPi<R> ? east - whole : east < -kPi<R> ? east + whole : east;
  place.height =
      p * l.cosine + z * l.sine - kEquator<R> * std::sqrt(R(1) - kEccentricity2<R> * square(l.sine));
  return place;
}

}  // namespace tiltrotor

// Place on the earth.
// Expected: the worked example of IOGP Geomatics Guidance Note 7-2 (topocentric conversion, methods 9836 and 9837); the
// forward formula from geodetic to earth-centred coordinates in long double; radii of curvature.
#include <cmath>
#include <random>

#include "capi/conditions.hpp"
#include "tiltrotor/sensors.h"

using namespace capi;

namespace {

class Generator {
 public:
  explicit Generator(unsigned seed) : bits_(seed) {}
  double between(double low, double high) { return low + (high - low) * 0x1p-53 * double(bits_() >> 11); }

 private:
  std::mt19937_64 bits_;
};

using L = long double;
constexpr L kA = 6378137.0L, kF = 1 / 298.257223563L, kE2 = kF * (2 - kF);

L exactly(double number) { return static_cast<L>(number); }

struct Point {
  L x, y, z;
};

Point earth_centred(L latitude, L longitude, L height) {
  const L n = kA / std::sqrt(1 - kE2 * std::sin(latitude) * std::sin(latitude));
  return {(n + height) * std::cos(latitude) * std::cos(longitude),
          (n + height) * std::cos(latitude) * std::sin(longitude),
          (n * (1 - kE2) + height) * std::sin(latitude)};
}

tr_geodetic place_of(const tr_geodetic& origin, const double (&position)[3]) {
  tr_geodetic place = {9, 9, 9};
  CHECK_EQ(tr_geodetic_at(&origin, position, &place), TR_OK);
  return place;
}

double degrees(double d, double m, double s) { return (d + m / 60 + s / 3600) * kDegree; }

// How far a place lies from where the axes of the plane lead, m.
double error_of(const tr_geodetic& origin, const double (&position)[3], const tr_geodetic& place) {
  const L f = exactly(origin.latitude_rad), l = exactly(origin.longitude_rad);
  const L north[3] = {-std::sin(f) * std::cos(l), -std::sin(f) * std::sin(l), std::cos(f)};
  const L east[3] = {-std::sin(l), std::cos(l), 0};
  const L down[3] = {-std::cos(f) * std::cos(l), -std::cos(f) * std::sin(l), -std::sin(f)};
  const Point o = earth_centred(f, l, exactly(origin.height_m));
  const Point p =
      earth_centred(exactly(place.latitude_rad), exactly(place.longitude_rad), exactly(place.height_m));
  const L from[3] = {o.x, o.y, o.z}, to[3] = {p.x, p.y, p.z};
  L square = 0;
  for (int k = 0; k < 3; ++k) {
    const L off = from[k] + north[k] * exactly(position[0]) + east[k] * exactly(position[1]) +
                  down[k] * exactly(position[2]) - to[k];
    square += off * off;
  }
  return double(std::sqrt(square));
}

}  // namespace

// Printed to 0.001" and 1 mm: 31 mm north and 18 mm east.
TEST(capi_geodetic_is_the_published_example) {
  const tr_geodetic origin = {degrees(55, 0, 0), degrees(5, 0, 0), 200};
  const tr_geodetic place = place_of(origin, {-128642.040, -189013.869, 4220.171});
  CHECK_NEAR(place.latitude_rad, degrees(53, 48, 33.82), 0.002 / 6.37e6);
  CHECK_NEAR(place.longitude_rad, degrees(2, 7, 46.38), 0.002 / 3.77e6);
  CHECK_NEAR(place.height_m, 73, 0.002);
}

TEST(capi_geodetic_is_exact) {
  constexpr unsigned seed = 84;
  NOTE("seed " << seed);
  Generator random(seed);
  double worst = 0;
  for (int n = 0; n < 20000; ++n) {
    const double far = std::pow(10, random.between(0, 6));
    const bool special = n % 5 == 0;
    tr_geodetic origin = {random.between(-0.5, 0.5) * kPi, random.between(-1, 1) * kPi,
                          random.between(-1e4, 1e5)};
    if (special) origin.latitude_rad = 0.5 * kPi * (n / 5 % 3 - 1);  // poles and equator
    const double position[3] = {random.between(-far, far), random.between(-far, far),
                                random.between(-far, far)};
    const tr_geodetic place = place_of(origin, position);
    worst = std::max(worst, error_of(origin, position, place));
    CHECK(std::abs(place.latitude_rad) <= 0.5 * kPi && std::abs(place.longitude_rad) <= kPi);
  }
  NOTE("worst of 20000 places: " << worst << " m");
  CHECK_LE(worst, 1e-8);
}

TEST(capi_geodetic_at_the_origin_the_poles_and_the_date_line) {
  const tr_geodetic origins[] = {{0, 0, 0}, {0.9, -1.2, 100}, {-0.5 * kPi, 0.3, 5}, {0.5 * kPi, -3, 0}};
  for (const tr_geodetic& origin : origins) {
    const tr_geodetic same = place_of(origin, {0, 0, 0});
    CHECK_NEAR(same.latitude_rad, origin.latitude_rad, 2e-16);
    CHECK_EQ(same.longitude_rad, origin.longitude_rad);
    CHECK_NEAR(same.height_m, origin.height_m, 3e-9);
  }
  // Over the pole the longitude turns round; eastward over the date line it begins at -pi.
  const tr_geodetic beyond = place_of({0.5 * kPi - 1e-3, 0.4, 0}, {12000, 0, 0});
  CHECK_NEAR(beyond.longitude_rad, 0.4 - kPi, 1e-9);
  CHECK_LT(beyond.latitude_rad, 0.5 * kPi);
  CHECK_LT(place_of({0.2, kPi - 1e-6, 0}, {0, 100, 0}).longitude_rad, -3);
  CHECK_LT(3.0, place_of({0.2, 1e-6 - kPi, 0}, {0, -100, 0}).longitude_rad);
}

// One metre north, east and down moves by the radii of curvature of meridian and prime vertical.
TEST(capi_geodetic_follows_the_radii_of_curvature) {
  for (const double latitude : {-1.2, -0.3, 0.0, 0.7, 1.4}) {
    const tr_geodetic origin = {latitude, 1, 500};
    const double w2 = 1 - double(kE2) * std::sin(latitude) * std::sin(latitude);
    const double east_radius = double(kA) / std::sqrt(w2);
    const double north_radius = east_radius * (1 - double(kE2)) / w2;
    CHECK_NEAR((place_of(origin, {1, 0, 0}).latitude_rad - latitude) * (north_radius + 500), 1, 1e-6);
    CHECK_NEAR((place_of(origin, {0, 1, 0}).longitude_rad - 1) * (east_radius + 500) * std::cos(latitude), 1,
               1e-6);
    CHECK_NEAR(place_of(origin, {0, 0, 1}).height_m, 499, 1e-8);
  }
  // The plane leaves the earth, as the header says.
  CHECK_NEAR(place_of({0.7, 0, 0}, {1e4, 0, 0}).height_m, 8, 0.5);
  CHECK_NEAR(place_of({0.7, 0, 0}, {0, 1e5, 0}).height_m, 785, 5);
}

TEST(capi_geodetic_refuses) {
  const tr_geodetic good = {0.7, 0.1, 100};
  const double here[3] = {1, 2, 3};
  tr_geodetic place = {1, 2, 3};
  const tr_geodetic before = place;
  CHECK_EQ(tr_geodetic_at(nullptr, here, &place), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_geodetic_at(&good, nullptr, &place), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_geodetic_at(&good, here, nullptr), TR_BAD_ARGUMENT);
  double tr_geodetic::*const fields[] = {&tr_geodetic::latitude_rad, &tr_geodetic::longitude_rad,
                                         &tr_geodetic::height_m};
  const double high[] = {1.5709, 3.1417, 100001}, low[] = {-1.5709, -3.1417, -10001};
  for (int k = 0; k < 3; ++k) {
    const auto refused = [&](double number, tr_status of_origin, tr_status of_position, double at) {
      tr_geodetic origin = good;
      origin.*fields[k] = number;
      CHECK_EQ(tr_geodetic_at(&origin, here, &place), of_origin);
      double position[3] = {1, 2, 3};
      position[k] = at;
      CHECK_EQ(tr_geodetic_at(&good, position, &place), of_position);
    };
    for (const double bad : {double(kNan), double(kInfinity), -double(kInfinity)})
      refused(bad, TR_NOT_FINITE, TR_NOT_FINITE, bad);
    refused(high[k], TR_OUT_OF_RANGE, TR_OUT_OF_RANGE, 1000001);
    refused(low[k], TR_OUT_OF_RANGE, TR_OUT_OF_RANGE, -1000001);
  }
  CHECK(same_bits(place, before));
  CHECK_EQ(tr_geodetic_at(&good, here, &place), TR_OK);
  // The place may be the origin itself.
  tr_geodetic moved = good;
  CHECK_EQ(tr_geodetic_at(&moved, here, &moved), TR_OK);
  CHECK(same_bits(moved, place));
}

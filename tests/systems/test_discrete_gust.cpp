// The gust that rises as 1 - cosine: MIL-F-8785C section 3.7.3 by the C library's cosine, places by geometry.
#include "tiltrotor/math/differentiation/complex_step.hpp"
#include "tiltrotor/math/differentiation/dual.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/systems/local_gusts.hpp"

#include <cmath>

#include "check.hpp"

using namespace tiltrotor;

TEST(discrete_gust_is_the_standards) {
  const double length = 40;
  for (double x = -20; x <= 80; x += 0.37) {
    const double expected = x < 0        ? 0
                            : x > length ? 1
                                         : (1 - std::cos(3.14159265358979323846 * x / length)) / 2;
    CHECK_NEAR(one_minus_cosine(x, length), expected, 4e-16);
  }
  CHECK_EQ(one_minus_cosine(0.0, length), 0.0);
  CHECK_EQ(one_minus_cosine(length, length), 1.0);
  CHECK_NEAR(one_minus_cosine(length / 2, length), 0.5, 1e-16);
}

// Slope pi/2 of the rise over the length in the middle, none at the ends and beyond.
TEST(discrete_gust_has_exact_derivatives) {
  using One = Dual<double, 1>;
  const double length = 40;
  for (const double x : {-5.0, 0.0, 10.0, 20.0, 40.0, 50.0}) {
    const double slope = one_minus_cosine(One::variable(x, 0), length).d.get(0);
    const double inside = x < 0 || x > length ? 0 : 1;
    CHECK_NEAR(slope, inside * std::sin(kPi<double> * x / length) * kPi<double> / (2 * length), 1e-16);
    CHECK_NEAR(slope, one_minus_cosine(std::complex<double>(x, 1e-30), length).imag() / 1e-30, 1e-16);
  }
}

// Rotors and wing at once, the tail when it has flown as far.
TEST(discrete_gust_reaches_the_tail_later) {
  const Aircraft<double>& a = aircraft_data<double>();
  const double length = 25;
  const Vec3<double> amplitude{1, -3, 9};
  for (double x = -10; x < 60; x += 1.3) {
    const LocalGusts<double> now = discrete_gust(x, length, amplitude, a);
    const LocalGusts<double> later = discrete_gust(x + tail_distance(a), length, amplitude, a);
    for (const Vec3<double>* at : {&now.rotor[0], &now.rotor[1], &now.wing}) {
      CHECK_NEAR(at->x, one_minus_cosine(x, length), 1e-15);
      CHECK_NEAR(at->y, -3 * at->x, 1e-14);
      CHECK_NEAR(at->z, 9 * at->x, 1e-14);
    }
    CHECK_NEAR(later.tail.z, now.wing.z, 1e-13);
  }
}

// Stations 560 and 301.2 in.
TEST_OF_XV15(discrete_gust_knows_where_the_tail_is) {
  CHECK_NEAR(tail_distance(aircraft_data<double>()), (560 - 301.2) * 0.0254, 1e-9);
}

// Numbers with a slope in the place of plain ones: against complex steps, and second derivatives by hand.
#include "tiltrotor/math/differentiation/along.hpp"

#include <complex>

#include "check.hpp"
#include "tiltrotor/math/differentiation/complex_step.hpp"
#include "tiltrotor/math/differentiation/dual.hpp"
#include "tiltrotor/math/smooth.hpp"

using namespace tiltrotor;
using Complex = std::complex<double>;

namespace {

// Every operation once; without a branch at the place it is asked for.
template <class T>
T every_operation(const T& x, const T& y) {
  const SineCosine<T> turned = sine_and_cosine(x * y);
  T z = turned.sine * x - y / turned.cosine + sqrt(x * x + y * y);
  z += atan2(y, x);
  z -= sin(x) * cos(y);
  z *= T(2) + x / (T(1) + y * y);
  return z + wrapped(T(x + T(9))) - smooth_ramp(x, Real<T>(0.5)) * tan(y);
}

}  // namespace

TEST(along_slopes_equal_complex_steps) {
  constexpr double tiny = 1e-30;
  for (const double x : {0.3, 1.7, -2.2})
    for (const double y : {-0.9, 0.4, 3.1}) {
      const Along by_x = every_operation(Along(x, 1), Along(y)),
                  by_y = every_operation(Along(x), Along(y, 1));
      const double value = every_operation(x, y);
      CHECK_NEAR(by_x.v, value, 1e-15 * (1 + std::abs(value)));
      CHECK_NEAR(by_y.v, value, 1e-15 * (1 + std::abs(value)));
      const double along_x = every_operation(Complex(x, tiny), Complex(y)).imag() / tiny;
      const double along_y = every_operation(Complex(x), Complex(y, tiny)).imag() / tiny;
      CHECK_NEAR(by_x.d, along_x, 1e-14 * (1 + std::abs(along_x)));
      CHECK_NEAR(by_y.d, along_y, 1e-14 * (1 + std::abs(along_y)));
      // Any direction.
      const Along both = every_operation(Along(x, 3), Along(y, -2));
      CHECK_NEAR(both.d, 3 * along_x - 2 * along_y, 1e-13 * (1 + std::abs(along_x) + std::abs(along_y)));
    }
}

// d2/dx dy of sin(x y) / y = -x sin(x y): partials of duals have slopes.
TEST(along_duals_have_second_derivatives) {
  using D = Dual<Along, 1>;
  for (const double x : {0.3, -1.1})
    for (const double y : {0.7, 2.9}) {
      const D at = D::variable(Along(x), 0);
      const D f = sin(D(at * Along(y, 1))) / Along(y, 1);
      CHECK_NEAR(f.d.get(0).v, std::cos(x * y), 1e-15);
      CHECK_NEAR(f.d.get(0).d, -x * std::sin(x * y), 1e-15);
    }
}

// Order and places in tables look at the value, equality at the slope too: what is zero and moves is not left out.
TEST(along_order_looks_at_values) {
  const Along low(1, 100), high(2, -100);
  CHECK(low < high && high > low && low <= Along(1) && low >= Along(1) && low != Along(1, 5) &&
        low == Along(1, 100));
  CHECK(Along(0, 1) != Along(0));
  CHECK_EQ(static_cast<int>(Along(3.9, 1)), 3);
  CHECK_EQ(fabs(Along(-2, 3)).d, -3.0);
  CHECK_EQ(floor(Along(2.5, 3)).d, 0.0);
}

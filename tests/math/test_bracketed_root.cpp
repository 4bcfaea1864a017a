// Roots known in closed form, an end that is kept many times, ends of one sign.
#include "tiltrotor/math/bracketed_root.hpp"

#include "check.hpp"

using namespace tiltrotor;

TEST(bracketed_root_finds_known_roots) {
  const double exact = 1e-15;
  int calls = 0;
  const auto counted = [&calls](auto f) {
    return [&calls, f](double x) {
      ++calls;
      return f(x);
    };
  };
  CHECK_NEAR(bracketed_root(counted([](double x) { return x * x - 2; }), 0.0, 2.0, exact), std::sqrt(2.0),
             1e-14);
  CHECK_NEAR(bracketed_root(counted([](double x) { return 2 - x * x; }), 2.0, 0.0, exact), std::sqrt(2.0),
             1e-14);
  CHECK_NEAR(bracketed_root(counted([](double x) { return std::sin(x); }), 2.0, 5.0, exact),
             3.14159265358979324, 1e-14);
  // Plain regula falsi keeps the far end for ever here: thousands of steps.
  calls = 0;
  CHECK_NEAR(bracketed_root(counted([](double x) { return std::pow(x, 9) - 1e-3; }), 0.0, 10.0, exact),
             std::pow(1e-3, 1.0 / 9), 1e-12);
  CHECK_LE(calls, 62);
  CHECK_EQ(bracketed_root([](double x) { return x - 1; }, 0.0, 1.0, exact), 1.0);
  CHECK_NEAR(bracketed_root([](float x) { return x * x * x - 8; }, 0.0F, 5.0F, 1e-6F), 2.0F, 1e-5F);
}

// No root between: the end that is nearer to one.
TEST(bracketed_root_without_a_root_gives_the_better_end) {
  CHECK_EQ(bracketed_root([](double x) { return 1 + x; }, 0.0, 3.0, 1e-9), 0.0);
  CHECK_EQ(bracketed_root([](double x) { return x - 5; }, 0.0, 3.0, 1e-9), 3.0);
}

// Vectors of three components against the determinants and identities of vector algebra.
#include "tiltrotor/math/vector.hpp"

#include <random>

#include "check.hpp"
#include "tiltrotor/math/differentiation/dual.hpp"

using namespace tiltrotor;

namespace {

using V = Vec3<double>;

class Random {
 public:
  double number() { return uniform_(engine_); }
  V vector() { return {number(), number(), number()}; }

 private:
  std::mt19937 engine_{4711};
  std::uniform_real_distribution<double> uniform_{-2, 2};
};

void check_vector(const V& a, const V& b, double tolerance) {
  CHECK_NEAR(a.x, b.x, tolerance);
  CHECK_NEAR(a.y, b.y, tolerance);
  CHECK_NEAR(a.z, b.z, tolerance);
}

}  // namespace

TEST(vector_products) {
  check_vector(cross(V{1, 0, 0}, V{0, 1, 0}), V{0, 0, 1}, 0);
  check_vector(cross(V{0, 1, 0}, V{0, 0, 1}), V{1, 0, 0}, 0);
  check_vector(cross(V{0, 0, 1}, V{1, 0, 0}), V{0, 1, 0}, 0);
  NOTE("seed 4711");
  Random random;
  for (int n = 0; n < 100; ++n) {
    const V a = random.vector();
    const V b = random.vector();
    const V c = random.vector();
    CHECK_NEAR(dot(a, b), a.x * b.x + a.y * b.y + a.z * b.z, 1e-15);
    const double determinant =
        a.x * (b.y * c.z - b.z * c.y) - a.y * (b.x * c.z - b.z * c.x) + a.z * (b.x * c.y - b.y * c.x);
    CHECK_NEAR(dot(a, cross(b, c)), determinant, 1e-14);
    check_vector(cross(a, b), -1.0 * cross(b, a), 0);
    // a x (b x c) = b (a c) - c (a b)
    check_vector(cross(a, cross(b, c)), dot(a, c) * b - dot(a, b) * c, 1e-13);
    // Mixed forms with one plain argument.
    check_vector(rate_cross_arm(a, b), cross(a, b), 1e-15);
    check_vector(arm_cross_force(a, b), cross(a, b), 1e-15);
    CHECK_NEAR(component(a, b), dot(a, b), 1e-15);
    check_vector(along(2.5, a), V{2.5 * a.x, 2.5 * a.y, 2.5 * a.z}, 0);
    check_vector((a + b) - b, a, 1e-15);
  }
}

// Velocity of a point on a turning body: out of the motion itself, positions a short time apart.
TEST(vector_rate_cross_arm_is_a_velocity) {
  const double rate = 0.8;
  const double h = 1e-6;
  const V arm{1.5, -0.4, 0.3};
  const auto turned = [&](double angle) {  // about z
    return V{arm.x * std::cos(angle) - arm.y * std::sin(angle),
             arm.x * std::sin(angle) + arm.y * std::cos(angle), arm.z};
  };
  const V velocity = (1 / (2 * h)) * (turned(rate * h) - turned(-rate * h));
  check_vector(rate_cross_arm(V{0, 0, rate}, arm), velocity, 1e-9);
}

TEST(vector_rotation) {
  const double angle = 0.6;
  // Frame turned by `angle` about z: its x axis is (cos, sin, 0).
  const Rotation<double> r{
      {std::cos(angle), std::sin(angle), 0}, {-std::sin(angle), std::cos(angle), 0}, {0, 0, 1}};
  check_vector(r.apply(V{std::cos(angle), std::sin(angle), 0}), V{1, 0, 0}, 1e-15);
  Random random;
  for (int n = 0; n < 20; ++n) {
    const V a = random.vector();
    const V b = random.vector();
    check_vector(r.apply_inverse(r.apply(a)), a, 1e-15);
    CHECK_NEAR(dot(r.apply(a), r.apply(b)), dot(a, b), 1e-14);
    check_vector(r.apply(cross(a, b)), cross(r.apply(a), r.apply(b)), 1e-14);
  }
}

TEST(vector_of_duals) {
  using D = Dual<double, 3>;
  const Vec3<D> a{D::variable(1, 0), D::variable(2, 1), D::variable(3, 2)};
  const D square_length = dot(a, a);
  CHECK_EQ(square_length.v, 14.0);
  CHECK_EQ(square_length.d.get(0), 2.0);
  CHECK_EQ(square_length.d.get(2), 6.0);
  const Vec3<D> moment = arm_cross_force(V{1, 0, 0}, a);
  CHECK_EQ(moment.y.d.get(2), -1.0);
  CHECK_EQ(moment.z.d.get(1), 1.0);
  int count = 0;
  Vec3<D>::each(a, [&](const D& x) { CHECK_EQ(x.v, static_cast<double>(++count)); });
  CHECK_EQ(count, 3);
}

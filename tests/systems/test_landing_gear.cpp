// Landing gear as a function. Expected: geometry, the friction law of the standard library, complex steps, the mirror
// image, and laws of scale.
#include "tiltrotor/systems/landing_gear.hpp"

#include <algorithm>

#include "on_gear.hpp"
#include "properties/scaled_aircraft.hpp"
#include "tiltrotor/math/differentiation/dual.hpp"

using namespace on_gear;

namespace {

constexpr unsigned kSeed = 1107;

}  // namespace

// The rotation from Earth to body axes, which the analyses use, and the distance of a point from a plane.
TEST(gear_ground_plane_by_geometry) {
  Generator random(kSeed);
  for (int n = 0; n < 100; ++n) {
    const GroundPlane<double> ground = {random.between(-50, 50), random.between(-2, 2),
                                        random.between(-2, 2)};
    const EulerAngles<double> a = {random.between(-3, 3), random.between(-1.5, 1.5), random.between(-3, 3)};
    const V p = {random.between(-90, 90), random.between(-90, 90), random.between(-90, 90)};
    const V arm = {random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)};
    const V up = {ground.slope_north, ground.slope_east, -1};
    const AboveGround<double> above = above_ground(ground, a.roll, a.pitch, a.yaw, p);
    const V expected = (1 / length(up)) * earth_to_body(a).apply(up);
    CHECK_NEAR(length(above.up_b - expected), 0.0, 1e-15);
    // From a point of the plane, the one below the origin.
    const V point = p + earth_to_body(a).apply_inverse(arm) - V{0, 0, ground.down};
    CHECK_NEAR(height_of(above, arm), dot(point, up) / length(up), 1e-12);
  }
}

// In the air nothing, and no derivative; from there it grows without a step.
TEST(gear_off_the_ground_carries_nothing) {
  using D = Dual<double, kStates>;
  const Configuration<double> c = configuration(20);
  const double width = c.aircraft->smooth.gear_contact;
  Generator random(kSeed + 1);
  const auto number = [](const D& x) {
    double size = std::abs(x.v);
    for (int k = 0; k < kStates; ++k) size = std::max(size, std::abs(x.d.get(k)));
    return size;
  };
  for (const double above : {0.0, 1e-6, 0.1, 30.0, 12000.0}) {
    Motion<double> m = at_height(touching_height(c) + above + 0.51 * width);
    m.velocity = {random.between(-60, 60), random.between(-3, 3), random.between(-9, 9)};
    Motion<D> seeded = converted<D>(m);
    int k = 0;
    Motion<D>::each(seeded, [&k](D& x) { x.d.set(k++, 1.0); });
    GearLoads<D> loads = loads_of(c, {}, seeded);
    if (above > 0.05) GearLoads<D>::each(loads, [&](const D& x) { CHECK_EQ(number(x), 0.0); });
    CHECK_EQ(number(loads.strut[1].force), 0.0);
    GearCommand<D> up{};
    landing_gear(c, above_ground({}, seeded.roll, seeded.pitch, seeded.yaw, seeded.position), seeded.velocity,
                 seeded.rates, up, loads);
    GearLoads<D>::each(loads, [&](const D& x) { CHECK_EQ(number(x), 0.0); });
  }
  // Lowered through the contact: each 20 um a change that belongs to it.
  const GearTables<double>& g = c.aircraft->gear;
  const double most = 2 * (g.main.oleo_stiffness + g.main.oleo_damping * 3 * 2 / width);
  double before = 0;
  for (double depth = -width; depth < width; depth += 2e-5) {
    Motion<double> m = at_height(touching_height(c) - depth);
    m.velocity.z = 3;
    const double force = of(loads_of(c, {}, m), Strut::main_right).force;
    CHECK_LE(std::abs(force - before), most * 2e-5);
    before = force;
  }
  CHECK_LE(0.1 * weight(c), before);
}

TEST(gear_never_pulls) {
  const Configuration<double> c = configuration(0);
  Generator random(kSeed + 2);
  int released = 0;
  for (int n = 0; n < 2000; ++n) {
    Motion<double> m = random_motion(random, c);
    m.velocity.z = random.between(-9, 9);
    const GearLoads<double> loads = loads_of(c, random_ground(random), m);
    for (const StrutLoad<double>& s : loads.strut) {
      CHECK(s.force >= 0 && s.stroke >= 0);
      released += s.stroke > 0.02 && s.force == 0 ? 1 : 0;
    }
    CHECK_LE(of(loads, Strut::nose).stroke, c.aircraft->gear.nose.stroke + 1e-15);
    CHECK_LE(of(loads, Strut::main_left).stroke, c.aircraft->gear.main.stroke + 1e-15);
  }
  CHECK_LE(100, released);  // struts that cannot follow the wheels
}

// Complex steps share nothing with dual numbers. Forces against the weight, moments against it at 1 m.
TEST(gear_derivatives_equal_complex_step) {
  using D = Dual<double, kStates>;
  using Z = std::complex<double>;
  Generator random(kSeed + 3);
  double worst = 0;
  int contacts = 0, stops = 0;
  for (int n = 0; n < 1000; ++n) {
    const Configuration<double> c = configuration(random.between(0, 90));
    const GroundPlane<double> ground = random_ground(random);
    Motion<double> m = random_motion(random, c);
    if (n % 4 == 0) m.velocity = m.rates = V{};
    const bool locked = random.coin();
    Motion<D> seeded = converted<D>(m);
    int k = 0;
    Motion<D>::each(seeded, [&k](D& x) { x.d.set(k++, 1.0); });
    const GearLoads<D> exact = loads_of(c, ground, seeded, locked);
    contacts += exact.weight_on_wheels.v > 0 ? 1 : 0;
    stops += exact.strut[1].stroke.v > 0.999 * c.aircraft->gear.main.stroke ? 1 : 0;
    for (k = 0; k < kStates; ++k) {
      Motion<Z> stepped = converted<Z>(m);
      int j = 0;
      Motion<Z>::each(stepped, [&](Z& x) { x += j++ == k ? Z(0, 1e-30) : Z(0); });
      const auto complex = flat(loads_of(c, ground, stepped, locked));
      std::size_t i = 0;
      GearLoads<D>::each(exact, [&](const D& x) {
        const double expected = complex[i].imag() / 1e-30;
        const bool of_force = i < 6 || (i < 12 && i % 2 == 0);
        const double scale = std::max(std::abs(expected), of_force ? weight(c) : 1);
        const double error = std::abs(x.d.get(k) - expected) / scale;
        if (!(error <= worst)) worst = error;
        CHECK_REL(complex[i].real(), x.v, 1e-11);
        ++i;
      });
    }
  }
  NOTE("largest difference " << worst << ", on the ground " << contacts << ", at the stop " << stops);
  CHECK_LE(worst, 1e-11);
  CHECK_LE(300, contacts);
  CHECK_LE(30, stops);
}

// The same where the configuration carries partials: against differences of a remade one.
TEST(gear_follows_the_cg_of_the_configuration) {
  const Configuration<double> c = configuration(30);
  Generator random(kSeed + 4);
  Motion<double> m = random_motion(random, c);
  m.position.z = -rest_height(c) + 0.05;
  const double step = 1e-6;
  double moment[2];
  for (const int k : {0, 1}) {
    ConfigurationSetting<double> setting = c.setup;
    setting.sl_cg += k == 0 ? -step : step;
    Configuration<double> other = c;
    CHECK(reconfigure(setting, other) == Status::ok);
    moment[k] = loads_of(other, {}, m).total.moment.y;
  }
  using D = Dual<double, 1>;
  Configuration<D> moving{};
  static_cast<FixedSetup<double>&>(moving) = c;
  moving.mass = {D(c.mass.mass), D::variable(c.mass.sl_cg, 0), D(c.mass.wl_cg), {}, {}};
  const GearLoads<D> exact = loads_of(moving, {}, converted<D>(m));
  CHECK_REL(exact.total.moment.y.d.get(0), (moment[1] - moment[0]) / (2 * step), 1e-6);
}

// Friction does work on the ground alone, of the sign it must have, and stays in its circle.
TEST(gear_friction_opposes_the_motion) {
  const Configuration<double> c = configuration(0);
  const GearTables<double>& g = c.aircraft->gear;
  Generator random(kSeed + 5);
  for (int n = 0; n < 1000; ++n) {
    const V up = earth_to_body(EulerAngles<double>{random.between(-0.3, 0.3), random.between(-0.3, 0.3), 0})
                     .apply(V{0, 0, -1});
    const double size = std::pow(10, random.between(-6, 2));
    const V v = {random.between(-size, size), random.between(-size, size), random.between(-size, size)};
    const V slip = v - dot(v, up) * up;
    const V wheel = wheel_friction(*c.aircraft, up, v, random.between(0, 1));
    const V castor = castor_friction(g, up, v);
    for (const V& friction : {wheel, castor}) {
      CHECK(dot(friction, slip) < 0);
      CHECK_NEAR(dot(friction, up), 0.0, 1e-14);
      CHECK_LE(length(friction), g.side_friction * (1 + 1e-14));
    }
    CHECK_LE(length(castor), g.rolling * (1 + 1e-14));
  }
  // mu tanh(v/v_s) of the standard library, level and across, with and without brakes.
  const V up = {0, 0, -1};
  for (const double v : {1e-9, 0.01, 0.3, 1.0, 5.0, 6.5, 40.0}) {
    const double part = std::tanh(v / g.slip_speed);
    CHECK_REL(wheel_friction(*c.aircraft, up, V{v, 0, 0}, 0.0).x, -g.rolling * part, 1e-14);
    CHECK_REL(wheel_friction(*c.aircraft, up, V{-v, 0, 0}, 0.0).x, g.rolling * part, 1e-14);
    CHECK_REL(wheel_friction(*c.aircraft, up, V{v, 0, 0}, 1.0).x, -g.braking * part, 1e-14);
    CHECK_REL(wheel_friction(*c.aircraft, up, V{0, v, 0}, 0.0).y, -g.side_friction * part, 1e-14);
    CHECK_REL(castor_friction(g, up, V{0.6 * v, 0.8 * v, 0}).y, -0.8 * g.rolling * part, 1e-14);
  }
  CHECK_EQ(length(wheel_friction(*c.aircraft, up, V{}, 1.0)), 0.0);
}

// Left and right exchanged.
TEST(gear_is_alike_left_and_right) {
  const Configuration<double> c = configuration(10);
  Generator random(kSeed + 6);
  for (int n = 0; n < 200; ++n) {
    const GroundPlane<double> ground = random_ground(random);
    const Motion<double> m = random_motion(random, c);
    Motion<double> mirror = m;
    for (double* x : {&mirror.velocity.y, &mirror.rates.x, &mirror.rates.z, &mirror.roll, &mirror.yaw,
                      &mirror.position.y})
      *x = -*x;
    std::swap(mirror.brake[right], mirror.brake[left]);
    const GearLoads<double> a = loads_of(c, ground, m);
    const GearLoads<double> b = loads_of(c, {ground.down, ground.slope_north, -ground.slope_east}, mirror);
    const double size = 1e-12 * weight(c);
    CHECK_NEAR(length(a.total.force - V{b.total.force.x, -b.total.force.y, b.total.force.z}), 0.0, size);
    CHECK_NEAR(length(a.total.moment - V{-b.total.moment.x, b.total.moment.y, -b.total.moment.z}), 0.0, size);
    CHECK_NEAR(of(a, Strut::main_right).force, of(b, Strut::main_left).force, size);
    CHECK_NEAR(of(a, Strut::nose).stroke, of(b, Strut::nose).stroke, 1e-12);
  }
}

// Every width is harmless: nothing of it is left on the ground, in the air, or beyond the stop.
TEST(gear_widths_are_harmless) {
  const Configuration<double> c = configuration(0);
  Aircraft<double> other = aircraft();
  SmoothingWidths<double>& e = other.smooth;
  for (double* width : {&e.gear_contact, &e.gear_stop, &e.gear_force, &e.gear_cosine}) *width *= 0.5;
  Configuration<double> narrow = c;
  narrow.aircraft = &other;
  const double full = c.aircraft->gear.main.stroke;
  for (const double part : {-0.5, -0.3, 0.0, 0.15, 0.8, 1.0}) {
    Motion<double> m = at_height(rest_height(c) - part * full);
    m.roll = 0.02;
    m.velocity = {3, 0.1, 0.2};
    const GearLoads<double> a = loads_of(c, {}, m);
    CHECK(flat(a) == flat(loads_of(narrow, {}, m)));
    CHECK_LE(0.1, a.weight_on_wheels);
  }
}

// Froude: the same landing in another size.
TEST(gear_scales_with_the_aircraft) {
  const scaled::Scale s{0.7, 1.3};
  const scaled::ScaledAircraft small(aircraft(), s);
  const Configuration<double> c = configuration(0);
  Configuration<double> there;
  CHECK(scaled::prepare_scaled(small, s, c.setup, there) == Status::ok);
  Generator random(kSeed + 8);
  for (int n = 0; n < 50; ++n) {
    const Motion<double> m = random_motion(random, c);
    Motion<double> scaled_motion = m;
    scaled_motion.velocity = s.speed() * m.velocity;
    scaled_motion.rates = (1 / s.time()) * m.rates;
    scaled_motion.position = s.length * m.position;
    const GearLoads<double> a = loads_of(c, {}, m), b = loads_of(there, {}, scaled_motion);
    CHECK_NEAR(length(s.force() * a.total.force - b.total.force), 0.0, 1e-12 * s.force() * weight(c));
    CHECK_NEAR(length(s.moment() * a.total.moment - b.total.moment), 0.0, 1e-12 * s.moment() * weight(c));
    CHECK_NEAR(a.weight_on_wheels, b.weight_on_wheels, 1e-12);
  }
}

// Area times dynamic pressure against the flow, at its place; nothing, and finite derivatives, at rest.
TEST(gear_drag_is_area_times_pressure) {
  const Configuration<double> c = configuration(0);
  const GearTables<double>& g = c.aircraft->gear;
  const V v = {40, 3, -2};
  const Loads<double> drag = gear_drag(c, 1.0, v, V{});
  const double expected = 0.5 * c.air.density * dot(v, v) * g.drag_area;
  CHECK_REL(length(drag.force), expected, 1e-6);
  CHECK_REL(dot(drag.force, v), -expected * length(v), 1e-6);
  const double sl = (g.nose.sl + g.main.sl + g.main.sl) / 3;
  const V moment = cross(V{c.mass.sl_cg - sl, 0, c.mass.wl_cg - g.drag_wl}, drag.force);
  CHECK_NEAR(length(drag.moment - moment), 0.0, 1e-12 * expected);
  CHECK_REL(length(gear_drag(c, 0.25, v, V{}).force), 0.25 * expected, 1e-6);
  CHECK_REL(gear_drag(c, 1.0, V{}, V{0, 1, 0}).force.x,
            -0.5 * c.air.density * g.drag_area * (c.mass.wl_cg - g.drag_wl) *
                std::hypot(c.mass.wl_cg - g.drag_wl, c.mass.sl_cg - sl),
            1e-3);
  using D = Dual<double, 3>;
  const Vec3<D> rest = {D::variable(0, 0), D::variable(0, 1), D::variable(0, 2)};
  const Loads<D> still = gear_drag(c, D(1), rest, Vec3<D>{D(0.0), D(0.0), D(0.0)});
  CHECK_EQ(still.force.x.v, 0.0);
  CHECK_NEAR(still.force.x.d.get(0), -0.5 * c.air.density * g.drag_area * c.aircraft->smooth.drag_speed,
             1e-12);
}

// Landing gear. Expected: statics and dynamics of a rigid body by hand, energy, the friction law solved for the speed of
// a creep, complex steps, the mirror image, and laws of scale.
#include "tiltrotor/systems/landing_gear.hpp"

#include <algorithm>

#include "model/flight_cases.hpp"
#include "properties/scaled_aircraft.hpp"
#include "tiltrotor/analysis/flight/attitude.hpp"
#include "tiltrotor/math/differentiation/dual.hpp"
#include "tiltrotor/math/integrate.hpp"

using namespace flight_cases;

namespace {

using V = Vec3<double>;
constexpr unsigned kSeed = 1107;

// An aircraft on or above the ground, and its brakes.
template <class T>
struct Motion {
  Vec3<T> velocity, rates;
  T roll, pitch, yaw;
  Vec3<T> position;
  T brake[2];

  static constexpr int kCount = 14;
  template <class Self, class Visit>
  static constexpr void each(Self& s, Visit&& visit) {
    Vec3<T>::each(s.velocity, visit);
    Vec3<T>::each(s.rates, visit);
    visit(s.roll);
    visit(s.pitch);
    visit(s.yaw);
    Vec3<T>::each(s.position, visit);
    visit(s.brake[right]);
    visit(s.brake[left]);
  }
};

template <class T, class C>
GearLoads<T> loads_of(const Configuration<C>& c, const GroundPlane<double>& ground, const Motion<T>& m,
                      bool nose_locked = false) {
  GearLoads<T> out;
  const GearCommand<T> command = {true, nose_locked, {m.brake[right], m.brake[left]}};
  landing_gear(c, above_ground(ground, m.roll, m.pitch, m.yaw, m.position), m.velocity, m.rates, command,
               out);
  return out;
}

const StrutTables<double>& strut(const Configuration<double>& c, Strut which) {
  return which == Strut::nose ? c.aircraft->gear.nose : c.aircraft->gear.main;
}
StrutLoad<double> of(const GearLoads<double>& loads, Strut which) {
  return loads.strut[static_cast<int>(which)];
}
double weight(const Configuration<double>& c) { return c.mass.mass * kGravity<double>; }
// Of the CG over level ground with the aircraft at rest as the drawing has it, m.
double rest_height(const Configuration<double>& c) { return c.mass.wl_cg - c.aircraft->gear.ground_wl; }
// Of the CG where the main wheels of a level aircraft touch, m.
double touching_height(const Configuration<double>& c) {
  return c.mass.wl_cg - extended_waterline(c.aircraft->gear, c.aircraft->gear.main);
}

Motion<double> at_height(double height) {
  Motion<double> m{};
  m.position.z = -height;
  return m;
}

// From the air to beyond the stops, in any heading.
Motion<double> random_motion(Generator& random, const Configuration<double>& c) {
  Motion<double> m = at_height(rest_height(c) + random.between(-0.5, 0.5));
  m.velocity = {random.between(-2, 20), random.between(-3, 3), random.between(-3, 3)};
  m.rates = {random.between(-0.4, 0.4), random.between(-0.4, 0.4), random.between(-0.4, 0.4)};
  m.roll = random.between(-0.15, 0.15);
  m.pitch = random.between(-0.15, 0.15);
  m.yaw = random.between(-3, 3);
  m.position.x = random.between(-2, 2);
  m.position.y = random.between(-2, 2);
  m.brake[right] = random.between(0, 1);
  m.brake[left] = random.between(0, 1);
  return m;
}
GroundPlane<double> random_ground(Generator& random) {
  return {random.between(-0.2, 0.2), random.between(-0.1, 0.1), random.between(-0.1, 0.1)};
}

// A rigid aircraft on its gear, its weight carried to a part by a lift that stays upright.
struct OnGear {
  const Configuration<double>& c;
  GroundPlane<double> ground{};
  double lift = 0;
  bool nose_locked = false;
  double brake = 0;

  Status operator()(double, const double* x, double* xdot) const {
    const Motion<double> m = motion(x);
    GearLoads<double> loads = loads_of(c, ground, m, nose_locked);
    const EulerAngles<double> attitude = {m.roll, m.pitch, m.yaw};
    loads.total.force = loads.total.force + earth_to_body(attitude).apply(V{0, 0, -lift * weight(c)});
    const RigidBodyRates<double> d =
        rigid_body(c.mass, m.velocity, m.rates, m.roll, m.pitch, m.yaw, loads.total);
    Motion<double> rates{};
    rates.velocity = d.velocity;
    rates.rates = d.rates;
    rates.roll = d.roll;
    rates.pitch = d.pitch;
    rates.yaw = d.yaw;
    rates.position = d.position;
    flatten(rates, xdot);
    return Status::ok;
  }
  Motion<double> motion(const double* x) const {
    Motion<double> m;
    unflatten(x, m);
    m.brake[right] = m.brake[left] = brake;
    return m;
  }
  double energy(const Motion<double>& m) const {
    const Inertia<double>& i = c.mass.inertia;
    const V& w = m.rates;
    const double turning = i.xx * w.x * w.x + i.yy * w.y * w.y + i.zz * w.z * w.z - 2 * i.xz * w.x * w.z;
    return 0.5 * (c.mass.mass * dot(m.velocity, m.velocity) + turning) -
           (1 - lift) * weight(c) * (m.position.z - ground.down);
  }
};

constexpr int kStates = Motion<double>::kCount;
template <class Watch>
Motion<double> moved(const OnGear& body, const Motion<double>& from, double duration, double dt,
                     Watch&& watch) {
  double x[kStates];
  flatten(from, x);
  RungeKuttaWorkspace<double, kStates> work;
  const int steps = static_cast<int>(std::lround(duration / dt));
  for (int n = 0; n < steps; ++n) {
    CHECK(rk4_step<double, kStates>(body, {n * dt, dt, x, kStates}, work) == Status::ok);
    watch(body.motion(x));
  }
  return body.motion(x);
}
Motion<double> settled(const OnGear& body, const Motion<double>& from, double duration = 20) {
  return moved(body, from, duration, 0.002, [](const Motion<double>&) {});
}

// Of the springs of a strut, J: oleo and, by the geometry of the wheel under the ground, tyre.
double stored(const OnGear& body, const Motion<double>& m, Strut which, double stroke) {
  const StrutTables<double>& s = strut(body.c, which);
  const double side = which == Strut::main_left ? -1 : 1;
  const double wl = extended_waterline(body.c.aircraft->gear, s);
  const V wheel = earth_to_body(EulerAngles<double>{m.roll, m.pitch, m.yaw})
                      .apply_inverse(station_arm(body.c.mass, s.sl, side * s.bl, wl));
  const double depth = m.position.z + wheel.z - body.ground.down;  // level ground
  const double tyre = std::max(depth, 0.0) / (std::cos(m.roll) * std::cos(m.pitch)) - stroke;
  return 0.5 * (s.oleo_stiffness * stroke * stroke + s.tyre_stiffness * tyre * tyre);
}

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

// Moments about the wheels: W (SL_main - SL_CG)/(SL_main - SL_nose) on the nose, 12 % of the weight. At the static part of
// the stroke, on the ground of the drawing. N and fraction: sized from the published strokes, wheels and CG.
TEST_OF_XV15(gear_at_rest_carries_the_weight) {
  const Configuration<double> c = configuration(0);
  const OnGear body{c};
  const Motion<double> m = settled(body, at_height(rest_height(c)));
  const GearLoads<double> loads = loads_of(c, body.ground, m);
  // 1e-3: stiffnesses have three digits, so that it stands at 0.01 deg of pitch.
  CHECK_REL(of(loads, Strut::nose).force, 6974.81, 1e-3);
  CHECK_REL(of(loads, Strut::main_right).force, 25426.0, 1e-3);
  CHECK_REL(of(loads, Strut::main_left).force, 25426.0, 1e-3);
  CHECK_NEAR(of(loads, Strut::nose).force / weight(c), 0.12, 0.001);
  CHECK_NEAR(loads.weight_on_wheels, 1.0, 1e-9);
  CHECK_NEAR(of(loads, Strut::nose).stroke, 0.6 * 0.3683, 0.0005);
  CHECK_NEAR(of(loads, Strut::main_right).stroke, 0.6 * 0.3429, 0.0005);
  CHECK_NEAR(-m.position.z, c.mass.wl_cg - 11 * 0.0254, 0.0005);
  CHECK_NEAR(m.pitch, 0.0, 2e-4);
  // The drawing's hub stands 12 ft 1 in above the ground.
  const AboveGround<double> above = above_ground(body.ground, m.roll, m.pitch, m.yaw, m.position);
  CHECK_NEAR(height_of(above, c.hub[right].arm_b), 145 * 0.0254, 0.01);
}

// Any aircraft, wherever its CG, at any mast angle: forces and moments of the struts balance the weight.
TEST(gear_at_rest_is_in_balance) {
  for (const double mast : {0.0, 40.0, 90.0}) {
    const Configuration<double> c = configuration(mast);
    const OnGear body{c};
    const Motion<double> m = settled(body, at_height(rest_height(c)));
    const GearLoads<double> loads = loads_of(c, body.ground, m);
    const GearTables<double>& g = c.aircraft->gear;
    const double arm =
        (g.main.sl - c.mass.sl_cg) / (g.main.sl - g.nose.sl);  // level; pitch moves it by CG height
    CHECK_NEAR(of(loads, Strut::nose).force / weight(c), arm, std::abs(m.pitch) + 1e-3);
    CHECK_NEAR(length(loads.total.moment), 0.0, 1e-6 * weight(c));
    CHECK_NEAR(length(loads.total.force), weight(c), 1e-9 * weight(c));
    CHECK_EQ(of(loads, Strut::main_right).force, of(loads, Strut::main_left).force);
  }
}

// Touch-down at the sink rate of the design, 10 ft/s at 13000 lb with lift equal to weight (NASA TM X-62407 pp. 21-22):
// most of the stroke and no stop. By hand, for 8700 ft lbf on a main strut: at the part f of the stroke the oleo holds 5400
// f^2, its damper has taken 4800 f, the tyre holds 1040 f^2, which is all of it at f = 0.85; with the nose's share of the
// blow, and a damper that takes more while the speed is highest, less. Energy: what springs store and dampers take is what
// the aircraft had.
TEST_OF_XV15(gear_drop_at_ten_feet_per_second) {
  const Configuration<double> c = configuration(0);
  OnGear body{c};
  body.lift = 1;
  Motion<double> m = at_height(touching_height(c));
  m.velocity.z = 10 * 0.3048;
  const double before = body.energy(m);
  const double dt = 0.0005;
  double largest = 0, taken = 0, worst = 0;
  double last[strut_count] = {};
  moved(body, m, 0.6, dt, [&](const Motion<double>& at) {
    const GearLoads<double> loads = loads_of(c, body.ground, at);
    double held = 0;
    for (int k = 0; k < strut_count; ++k) {
      const StrutTables<double>& s = strut(c, static_cast<Strut>(k));
      const double stroke = loads.strut[k].stroke;
      const double rate = (stroke - last[k]) / dt;
      const double share = s.tyre_stiffness / (s.tyre_stiffness + s.oleo_stiffness);
      taken += s.oleo_damping * rate * (rate / share) * dt;  // c s' x'
      held += stored(body, at, static_cast<Strut>(k), stroke);
      last[k] = stroke;
    }
    largest = std::max(largest, of(loads, Strut::main_right).stroke);
    if (loads.weight_on_wheels > 0.1 && largest == of(loads, Strut::main_right).stroke)
      worst = std::max(worst, std::abs(body.energy(at) + held + taken - before) / before);
  });
  const double full = c.aircraft->gear.main.stroke;
  NOTE("main stroke used " << largest / full << ", energy " << worst);
  CHECK_LE(0.75 * full, largest);
  CHECK_LE(largest, full - 0.5 * c.aircraft->smooth.gear_stop);
  CHECK_LE(worst, 0.02);  // the blend at contact, 20 mm, and the sum's steps
}

// 12.25 ft/s, the design's reserve, may reach the stop; the stroke never exceeds it, and the aircraft bounces.
TEST_OF_XV15(gear_drop_with_the_reserve_ends_at_the_stop) {
  const Configuration<double> c = configuration(0);
  OnGear body{c};
  for (const double lift : {1.0, 0.0}) {
    body.lift = lift;
    Motion<double> m = at_height(touching_height(c));
    m.velocity.z = 12.25 * 0.3048;
    double largest = 0;
    const Motion<double> end = moved(body, m, 2, 0.001, [&](const Motion<double>& at) {
      largest = std::max(largest, of(loads_of(c, body.ground, at), Strut::main_right).stroke);
    });
    const double full = c.aircraft->gear.main.stroke;
    NOTE("lift " << lift << ": main stroke used " << largest / full);
    CHECK_LE(0.9 * full, largest);
    CHECK_LE(largest, full + 1e-15);
    CHECK_LE(end.velocity.z, 1.0);
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
  CHECK_LE(1e4, before);
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

// Ten minutes on a slope of 3 deg, parked. Without stiction wheels creep at the speed at which mu N tanh(v/v_s) holds the
// weight's part along the slope: v = v_s atanh(W sin / sum mu N).
TEST(gear_parked_on_a_slope_creeps_as_its_law_says) {
  const Configuration<double> c = configuration(0);
  const GearTables<double>& g = c.aircraft->gear;
  const double slope = std::tan(3 * kRadPerDeg<double>);
  for (const bool across : {false, true}) {
    OnGear body{c};
    body.ground = {0, across ? 0 : slope, across ? slope : 0};
    body.nose_locked = true;
    body.brake = across ? 0 : 1;
    Motion<double> start = at_height(rest_height(c));
    (across ? start.roll : start.pitch) = (across ? 1 : -1) * std::atan(slope);
    start = settled(body, start);
    const GearLoads<double> loads = loads_of(c, body.ground, start, true);
    const double nose = of(loads, Strut::nose).force;
    const double main = of(loads, Strut::main_right).force + of(loads, Strut::main_left).force;
    CHECK_NEAR(nose + main, weight(c) * std::cos(std::atan(slope)), 0.002 * weight(c));
    const double holds = across ? g.side_friction * (nose + main) : g.rolling * nose + g.braking * main;
    const double expected = g.slip_speed * std::atanh(weight(c) * std::sin(std::atan(slope)) / holds);
    const Motion<double> end = moved(body, start, 600, 0.005, [](const Motion<double>&) {});
    const double north = end.position.x - start.position.x, east = end.position.y - start.position.y;
    const double way = std::hypot(across ? east : north, end.position.z - start.position.z);
    NOTE((across ? "across: " : "down: ") << way << " m, " << expected << " m/s");
    CHECK_REL(way, 600 * expected, 1e-3);
    CHECK_NEAR(across ? north : east, 0.0, 0.01);
    CHECK_NEAR(end.yaw, 0.0, 1e-4);
  }
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

// Dropped askew, the aircraft with its springs never gains energy, and ends at rest or rolling.
TEST(gear_bounce_gains_no_energy) {
  const Configuration<double> c = configuration(0);
  Generator random(kSeed + 7);
  double worst = 0;
  for (int n = 0; n < 20; ++n) {
    OnGear body{c};
    body.lift = random.between(0, 0.9);
    Motion<double> m = at_height(touching_height(c) + random.between(0.3, 0.5));
    m.velocity = {random.between(-3, 20), random.between(-1, 1), random.between(0, 1.5)};
    m.roll = random.between(-0.08, 0.08);
    m.pitch = random.between(-0.05, 0.05);
    m.rates = {random.between(-0.1, 0.1), random.between(-0.05, 0.05), random.between(-0.1, 0.1)};
    double least = body.energy(m);
    const Motion<double> end = moved(body, m, 15, 0.001, [&](const Motion<double>& at) {
      const GearLoads<double> loads = loads_of(c, body.ground, at);
      double has = body.energy(at);
      for (int k = 0; k < strut_count; ++k)
        has += stored(body, at, static_cast<Strut>(k), loads.strut[k].stroke);
      worst = std::max(worst, has - least);
      least = std::min(least, has);
    });
    double rates[kStates], x[kStates];
    flatten(end, x);
    CHECK(body(0, x, rates) == Status::ok);
    CHECK_NEAR(body.motion(rates).position.z, 0.0, 0.01);
    CHECK_NEAR(loads_of(c, body.ground, end).weight_on_wheels, 1 - body.lift, 0.01);
  }
  NOTE("most gained " << worst << " J");
  CHECK_LE(worst, 1e-3);  // of some 20 kJ, by the integrator
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
  for (const double deeper : {-0.2, -0.1, 0.0, 0.05, 0.8 * full, full}) {
    Motion<double> m = at_height(rest_height(c) - deeper);
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

// An aircraft on its landing gear: at rest, dropped, parked on a slope. Expected: statics of a rigid body by hand, energy,
// and the friction law solved for the speed of a creep.
#include <algorithm>

#include "on_gear.hpp"

using namespace on_gear;

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

// Dropped askew, the aircraft with its springs never gains energy, and ends at rest or rolling.
TEST(gear_bounce_gains_no_energy) {
  const Configuration<double> c = configuration(0);
  Generator random(1114);
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

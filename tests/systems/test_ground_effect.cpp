// Ground effect. Expected: the law of Cheeseman and Bennett evaluated by hand, trims of the complete model at equal
// power, complex steps, and which way an aircraft near the ground must turn.
#include "tiltrotor/systems/ground_effect.hpp"

#include <algorithm>

#include "analysis/analysis_case.hpp"
#include "model/flight_cases.hpp"
#include "tiltrotor/math/differentiation/dual.hpp"

using namespace flight_cases;

namespace {

using V = Vec3<double>;
constexpr unsigned kSeed = 1108;

// A level aircraft whose hubs stand at a height, m, over level ground.
AboveGround<double> with_hubs_at(const Configuration<double>& c, double height) {
  return above_ground<double>({}, 0, 0, 0, {0, 0, -(height + c.hub[right].arm_b.z)});
}

// In still air with the inflow of hover.
GroundEffect<double> hovering_at(const Configuration<double>& c, double height, const V& velocity = {},
                                 double roll = 0) {
  const double inflow[2] = {0.07, 0.07};
  AboveGround<double> above = with_hubs_at(c, height);
  above.up_b = above_ground<double>({}, roll, 0, 0, {}).up_b;
  return ground_effect(c, above, velocity, V{}, inflow);
}

double thrust_ratio(double wash) { return std::pow(wash, -2.0 / 3); }  // T/T_free at equal power

// Height of a hub on the gear over the radius in the printed table.
double on_gear() { return aircraft().ground.hub_height_on_gear / aircraft().rotor.radius; }

struct Hover {
  double thrust, power, mass;
};
// The hover of this configuration at another mass.
Hover hover(Configuration<double> c, double mass) {
  ConfigurationSetting<double> setting = c.setup;
  setting.mass = mass;
  CHECK(reconfigure(setting, c) == Status::ok);
  const TrimResult<double> t = analysis_case::trimmed(c, analysis_case::level(0));
  CHECK(is_trimmed(t.status));
  return {t.thrust[right] + t.thrust[left], t.power[right] + t.power[left], mass};
}
// The hover that takes a power: the mass by the secant through two trims, until it changes no more.
Hover hover_at_power(const Configuration<double>& c, double power) {
  Hover a = hover(c, c.setup.mass), b = hover(c, 1.05 * c.setup.mass);
  for (int n = 0; n < 8 && std::abs(b.power / power - 1) > 1e-9; ++n) {
    const double mass = b.mass + (power - b.power) * (b.mass - a.mass) / (b.power - a.power);
    a = b;
    b = hover(c, mass);
  }
  CHECK_REL(b.power, power, 1e-8);
  return b;
}

}  // namespace

// 1/(1 - (R/4z)^2) by hand.
TEST(ground_effect_is_that_of_cheeseman_and_bennett) {
  const Configuration<double> c = configuration(0);
  const double radius = aircraft().rotor.radius;
  const double table[4][2] = {{on_gear(), 1.0717}, {1.5, 1.0286}, {2.0, 1.0159}, {3.0, 1.0070}};
  for (const auto& [height, ratio] : table) {
    const GroundEffect<double> e = hovering_at(c, height * radius);
    CHECK_NEAR(thrust_ratio(e.wash[right]), ratio, 1e-4);
    CHECK_EQ(e.wash[right], e.wash[left]);
  }
}

// Half of the download on the gear and below, all of it from z = 2 R on, ever more between.
TEST(ground_effect_relieves_the_download) {
  const Configuration<double> c = configuration(0);
  const double radius = aircraft().rotor.radius;
  CHECK_NEAR(hovering_at(c, on_gear() * radius).download, 0.5, 1e-15);
  CHECK_NEAR(hovering_at(c, 0.6 * radius).download, 0.5, 1e-15);
  CHECK_EQ(hovering_at(c, 2 * radius).download, 1.0);
  CHECK_NEAR(hovering_at(c, 0.5 * (2 + on_gear()) * radius).download, 0.75, 1e-12);  // half way by symmetry
  double before = 0.5;
  for (double z = on_gear() + 0.02; z < 2; z += 0.02) {
    const double download = hovering_at(c, z * radius).download;
    CHECK_LT(before, download);
    before = download;
  }
}

// Exactly none from 8 R on, and in airplane mode; at z = R below a third of that of hover at 1.5 times the induced speed.
TEST(ground_effect_ends_with_height_speed_and_mast) {
  const Configuration<double> c = configuration(0);
  const double radius = aircraft().rotor.radius;
  for (const double height : {8.0, 9.0, 50.0, 3000.0}) {
    const GroundEffect<double> e = hovering_at(c, height * radius);
    CHECK(e.wash[right] == 1 && e.wash[left] == 1 && e.download == 1);
  }
  double before = 0;
  for (double height = 0.4; height <= 8; height += 0.05) {
    const double wash = hovering_at(c, height * radius).wash[right];
    CHECK(wash > before && wash <= 1);
    before = wash;
  }
  const auto image = [](const GroundEffect<double>& e) { return 1 - std::pow(e.wash[right], 2.0 / 3); };
  const double at_rest = image(hovering_at(c, radius));
  CHECK_REL(at_rest, 1.0 / 16, 1e-3);
  const double induced = 0.07 * c.tip_speed;
  for (const double times : {0.5, 1.0, 1.5, 3.0})
    for (const V& v : {V{times * induced, 0, 0}, V{0, times * induced, 0}})
      CHECK_REL(image(hovering_at(c, radius, v)), at_rest / (1 + times * times), 0.005);  // width of 1 m/s
  CHECK_LT(image(hovering_at(c, radius, V{1.5 * induced, 0, 0})), at_rest / 3);
  for (const double mast : {30.0, 60.0, 90.0}) {
    const Configuration<double> tilted = configuration(mast);
    const double share = std::pow(std::cos(mast * kRadPerDeg<double>), 2);
    CHECK_NEAR(image(hovering_at(tilted, radius)), share * at_rest, 1e-12);
  }
  const GroundEffect<double> airplane = hovering_at(configuration(90), radius);
  CHECK(airplane.wash[right] == 1 && airplane.download == 1);
}

// Wherever the aircraft is: on its side, under the ground, with rotors that carry nothing or push down.
TEST(ground_effect_is_bounded_everywhere) {
  Generator random(kSeed);
  const GroundTables<double>& g = aircraft().ground;
  const double least = std::pow(1 - 1 / (16 * square(g.least_height)), 1.5);
  for (int n = 0; n < 2000; ++n) {
    const Configuration<double> c = configuration(n % 2 == 0 ? 0 : random.between(0, 90));
    const AboveGround<double> above = above_ground<double>(
        {0, random.between(-1, 1), random.between(-1, 1)}, random.between(-3, 3), random.between(-1.5, 1.5),
        random.between(-3, 3), {0, 0, random.between(-20, 20)});
    const double inflow[2] = {random.between(-0.05, 0.1), n % 3 == 0 ? 0 : random.between(-0.05, 0.1)};
    const double size = n % 5 == 0 ? 0 : 30;
    const GroundEffect<double> e =
        ground_effect(c, above, V{random.between(-size, size), random.between(-size, size), 0}, V{}, inflow);
    for (const double wash : e.wash) CHECK(wash >= least && wash <= 1);
    CHECK(e.download >= g.download_on_gear - 1e-15 && e.download <= 1);
  }
}

// Trims of the complete model: thrust at the power of a hover away from the ground. The law is of induced power; of all
// power it moves the induced part i, and the gain is spent on power that grows with thrust as P ~ T^e: to first order
// d ln T = (law - 1) 3/2 i/e. i by momentum theory, e from two hovers away from the ground.
TEST(ground_effect_in_hover_at_equal_power) {
  const Configuration<double> free = analysis_case::flown_configuration(0);
  const Hover away = hover(free, 0.9 * free.setup.mass), more = hover(free, 0.93 * free.setup.mass);
  const double exponent = std::log(more.power / away.power) / std::log(more.thrust / away.thrust);
  const double disks = 2 * kPi<double> * square(aircraft().rotor.radius);
  const double ideal = away.thrust * std::sqrt(away.thrust / (2 * free.air.density * disks));
  const double share = 1.5 * ideal / away.power / exponent;
  NOTE("power grows with thrust as T^" << exponent << ", induced part at least " << ideal / away.power);
  for (const double height : {on_gear(), 1.5, 2.0}) {
    const double law = 1 / (1 - 1 / square(4 * height));
    Configuration<double> near = free;
    near.rotor[right].ground_wash = near.rotor[left].ground_wash =
        hovering_at(free, height * aircraft().rotor.radius).wash[right];
    const double found = hover_at_power(near, away.power).thrust / away.thrust;
    NOTE("z/R " << height << ": thrust ratio at equal power " << found << ", law " << law
                << ", with profile power " << 1 + share * (law - 1));
    CHECK_NEAR(found, law, 0.02);
    CHECK_REL(found - 1, share * (law - 1),
              0.1);  // i: an inflow that is not even takes more than momentum's least
  }
  // With half the download: what the sources expect of rotor and download together, 10 to 15 % of weight.
  const GroundEffect<double> e = hovering_at(free, on_gear() * aircraft().rotor.radius);
  Configuration<double> near = free;
  near.rotor[right].ground_wash = near.rotor[left].ground_wash = e.wash[right];
  near.download = e.download;
  const double weight = hover_at_power(near, away.power).mass / away.mass;
  NOTE("on the gear: weight ratio at equal power " << weight);
  CHECK(weight > 1.10 && weight < 1.15);
}

// Through the model: the loads of the wing in the wakes and nothing else; blades that see less inflow carry more.
TEST(ground_effect_acts_where_it_should) {
  Generator random(kSeed + 1);
  for (const double mast : {0.0, 30.0}) {
    const Configuration<double> c = configuration(mast);
    const StateAndControls<double> s = random_case(random, c);
    Configuration<double> near = c;
    near.download = 0.5;
    Evaluation<double> a, b;
    evaluate_aircraft(c, s.x, s.u, a);
    evaluate_aircraft(near, s.x, s.u, b);
    for (int k = 0; k < component_count; ++k) {
      const auto which = static_cast<Component>(k);
      const bool wake = which == Component::wing_wake_right || which == Component::wing_wake_left;
      const Loads<double>& was = a.loads[which];
      CHECK_NEAR(length(b.loads[which].force - (wake ? 0.5 : 1) * was.force), 0.0, 1e-12 * length(was.force));
      CHECK_NEAR(length(b.loads[which].moment - (wake ? 0.5 : 1) * was.moment), 0.0,
                 1e-12 * length(was.moment));
    }
    near = c;
    near.rotor[left].ground_wash = 0.9;
    evaluate_aircraft(near, s.x, s.u, b);
    CHECK(flat(b.rotor[right]) == flat(a.rotor[right]));
    CHECK_LT(a.rotor[left].loads.force_a.z, b.rotor[left].loads.force_a.z);
    CHECK(flat(b.loads[Component::wing_wake_left]) == flat(a.loads[Component::wing_wake_left]));
    // Blades in the ground's effect at an inflow are blades away from it at the smaller one.
    StateAndControls<double> less = s;
    less.x.rotor[left].lambda_0 *= 0.9;
    Options options;
    options.radial_inflow = RadialInflow::constant;
    Configuration<double> even = configuration(mast, options);
    evaluate_aircraft(even, less.x, less.u, a);
    even.rotor[left].ground_wash = 0.9;
    evaluate_aircraft(even, s.x, s.u, b);
    CHECK_REL(b.rotor[left].loads.force_a.z, a.rotor[left].loads.force_a.z, 1e-13);
    CHECK_REL(b.rotor[left].loads.torque, a.rotor[left].loads.torque, 1e-13);
  }
}

// A new configuration has none; one remade in flight keeps what was set.
TEST(ground_effect_stays_when_a_configuration_is_remade) {
  Configuration<double> c = configuration(0);
  CHECK(c.rotor[right].ground_wash == 1 && c.rotor[left].ground_wash == 1 && c.download == 1);
  c.rotor[right].ground_wash = 0.9;
  c.rotor[left].ground_wash = 0.8;
  c.download = 0.7;
  ConfigurationSetting<double> setting = c.setup;
  setting.mast_deg = 10;
  CHECK(reconfigure(setting, c) == Status::ok);
  CHECK(c.rotor[right].ground_wash == 0.9 && c.rotor[left].ground_wash == 0.8 && c.download == 0.7);
}

// The lower hub, and the one downhill of it, carries more: bank to the right rolls back to the left.
TEST(ground_effect_levels_a_banked_aircraft) {
  const Configuration<double> c = configuration(0);
  const double height = 1.2 * aircraft().rotor.radius;
  const TrimResult<double> t = analysis_case::trimmed(c, analysis_case::level(0));
  const auto roll_moment = [&](double roll) {
    const GroundEffect<double> e = hovering_at(c, height, {}, roll);
    Configuration<double> near = c;
    for (const Side side : {right, left}) near.rotor[side].ground_wash = e.wash[side];
    Evaluation<double> found;
    evaluate_aircraft(near, t.state, t.controls, found);
    return found.loads[Component::rotor_right].moment.x + found.loads[Component::rotor_left].moment.x;
  };
  const GroundEffect<double> e = hovering_at(c, height, {}, 0.05);
  CHECK_LT(e.wash[right], e.wash[left]);
  CHECK_LT(roll_moment(0.05), roll_moment(0.0) - 100);
  CHECK_LT(roll_moment(0.0) + 100, roll_moment(-0.05));
  // Each at its own height.
  const double up = std::sin(0.05) * c.hub[right].arm_b.y;
  const double level = std::cos(0.05) * c.hub[right].arm_b.z - c.hub[right].arm_b.z;
  CHECK_REL(e.wash[right], hovering_at(c, height - up - level).wash[right], 1e-12);
  CHECK_REL(e.wash[left], hovering_at(c, height + up - level).wash[right], 1e-12);
}

// Complex steps share nothing with dual numbers.
TEST(ground_effect_derivatives_equal_complex_step) {
  constexpr int kInputs = 12;
  using D = Dual<double, kInputs>;
  using Z = std::complex<double>;
  const auto evaluated = [](const auto& c, auto* in) {
    using T = std::decay_t<decltype(*in)>;
    const AboveGround<T> above = {{in[0], in[1], in[2]}, in[3]};
    const T inflow[2] = {in[10], in[11]};
    return ground_effect(c, above, Vec3<T>{in[4], in[5], in[6]}, Vec3<T>{in[7], in[8], in[9]}, inflow);
  };
  Generator random(kSeed + 2);
  double worst = 0;
  int felt = 0;
  for (int n = 0; n < 1000; ++n) {
    const Configuration<double> c = configuration(random.between(0, 90));
    const AboveGround<double> above = above_ground<double>(
        {0, random.between(-0.3, 0.3), 0}, random.between(-0.5, 0.5), random.between(-0.5, 0.5),
        random.between(-3, 3), {0, 0, -random.between(-1, 35)});
    double in[kInputs] = {above.up_b.x, above.up_b.y, above.up_b.z, above.height};
    for (int k = 4; k < 10; ++k)
      in[k] = n % 4 == 0 ? 0 : random.between(k < 7 ? -20 : -0.4, k < 7 ? 20 : 0.4);
    for (int k = 10; k < kInputs; ++k) in[k] = n % 8 == 0 ? 0 : random.between(-0.02, 0.08);
    D seeded[kInputs];
    for (int k = 0; k < kInputs; ++k) seeded[k] = D::variable(in[k], k);
    const GroundEffect<D> exact = evaluated(c, seeded);
    felt += exact.wash[right].v < 0.999 ? 1 : 0;
    for (int k = 0; k < kInputs; ++k) {
      Z stepped[kInputs];
      for (int j = 0; j < kInputs; ++j) stepped[j] = {in[j], j == k ? 1e-30 : 0};
      const GroundEffect<Z> complex = evaluated(c, stepped);
      const auto compare = [&](const D& a, const Z& b) {
        const double expected = b.imag() / 1e-30;
        const double error = std::abs(a.d.get(k) - expected) / std::max(1.0, std::abs(expected));
        if (!(error <= worst)) worst = error;
      };
      compare(exact.wash[right], complex.wash[right]);
      compare(exact.wash[left], complex.wash[left]);
      compare(exact.download, complex.download);
    }
  }
  NOTE("largest difference " << worst << ", near the ground " << felt);
  CHECK_LE(worst, 1e-11);
  CHECK_LE(200, felt);
}

// Widths: of the floor under the height nothing on the gear, of the wash nothing in a hover.
TEST(ground_effect_widths_are_harmless) {
  const Configuration<double> c = configuration(0);
  Aircraft<double> other = aircraft();
  other.smooth.ground_height = other.smooth.ground_wash = 0;
  Configuration<double> sharp = c;
  sharp.aircraft = &other;
  const double height = on_gear() * aircraft().rotor.radius;
  CHECK_NEAR(hovering_at(c, height).wash[right], hovering_at(sharp, height).wash[right], 1e-4);
  for (const double v : {3.0, 10.0, 30.0})
    CHECK_NEAR(hovering_at(c, height, V{v, 0, 0}).wash[right],
               hovering_at(sharp, height, V{v, 0, 0}).wash[right], 5e-4);
}

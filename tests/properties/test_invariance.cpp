// What must not matter: a steady wind, the heading, the place; and what must balance at any state: power.
// Expected values come from Newton's laws and from energy, not from the model.
#include "analysis/analysis_case.hpp"
#include "check.hpp"
#include "model/flight_cases.hpp"
#include "tiltrotor/math/integrate.hpp"

using namespace tiltrotor;
using flight_cases::flat;
using flight_cases::Generator;
using flight_cases::random_case;
using flight_cases::rate_scale;
using flight_cases::StateAndControls;
using V = Vec3<double>;

namespace {

constexpr unsigned kSeed = 20260601;

// Earth to body, as the product of the three elementary rotations.
V to_body(const V& earth, double roll, double pitch, double yaw) {
  const V heading = {std::cos(yaw) * earth.x + std::sin(yaw) * earth.y,
                     std::cos(yaw) * earth.y - std::sin(yaw) * earth.x, earth.z};
  const V level = {std::cos(pitch) * heading.x - std::sin(pitch) * heading.z, heading.y,
                   std::sin(pitch) * heading.x + std::cos(pitch) * heading.z};
  return {level.x, std::cos(roll) * level.y + std::sin(roll) * level.z,
          std::cos(roll) * level.z - std::sin(roll) * level.y};
}

V random_vector(Generator& random, double size) {
  return {random.between(-size, size), random.between(-size, size), random.between(-size, size)};
}

Configuration<double> random_configuration(Generator& random) {
  Options options;
  options.position_states = true;
  options.coning_states = random.coin();
  options.tables = random.coin() ? Interpolation::c1 : Interpolation::linear;
  const double masts[] = {0, 30, 75, 90, random.between(0, 90)};
  return flight_cases::configuration(masts[static_cast<int>(random.between(0, 5))], options);
}

void check_near(const V& actual, const V& expected, double tolerance) {
  CHECK_NEAR(actual.x, expected.x, tolerance);
  CHECK_NEAR(actual.y, expected.y, tolerance);
  CHECK_NEAR(actual.z, expected.z, tolerance);
}

void check_same_loads(const Evaluation<double>& a, const Evaluation<double>& b, double weight) {
  for (int k = 0; k < component_count; ++k) {
    check_near(a.loads.component[k].force, b.loads.component[k].force, 1e-10 * weight);
    check_near(a.loads.component[k].moment, b.loads.component[k].moment, 1e-9 * weight);
  }
}

// Right side of a flight in a wind that is steady in Earth axes.
struct InWind {
  const Configuration<double>& c;
  const Controls<double>& u;
  V wind;

  Status operator()(double, const double* numbers, double* rates) const {
    State<double> x;
    State<double> xdot;
    unflatten(numbers, x);
    Controls<double> in_wind = u;
    in_wind.gust = to_body(wind, x.roll, x.pitch, x.yaw);
    derivative(c, x, in_wind, xdot);
    flatten(xdot, rates);
    return Status::ok;
  }
};

State<double> flown(const Configuration<double>& c, const State<double>& start, const Controls<double>& u,
                    const V& wind, double dt, int steps) {
  static RungeKuttaWorkspace<double, state_count> work;
  State<double> x = start;
  x.velocity = x.velocity + to_body(wind, x.roll, x.pitch, x.yaw);
  double numbers[state_count];
  flatten(x, numbers);
  const InWind f{c, u, wind};
  for (int k = 0; k < steps; ++k) CHECK(rk4_step(f, {0.0, dt, numbers, state_count}, work) == Status::ok);
  unflatten(numbers, x);
  x.velocity = x.velocity - to_body(wind, x.roll, x.pitch, x.yaw);
  return x;
}

}  // namespace

// In a steady wind w every load is as in still air; the velocity gains the term -omega x (R w) of rotating
// axes, the position drifts by w, and nothing else changes.
TEST(property_steady_wind_changes_no_load) {
  NOTE("seed " << kSeed);
  Generator random(kSeed);
  for (int k = 0; k < 300; ++k) {
    const Configuration<double> c = random_configuration(random);
    const StateAndControls<double> still = random_case(random, c);
    StateAndControls<double> windy = still;
    const V wind = random_vector(random, 20);
    const V body_wind = to_body(wind, still.x.roll, still.x.pitch, still.x.yaw);
    windy.x.velocity = still.x.velocity + body_wind;
    windy.u.gust = still.u.gust + body_wind;

    Evaluation<double> a;
    Evaluation<double> b;
    evaluate_aircraft(c, still.x, still.u, a);
    evaluate_aircraft(c, windy.x, windy.u, b);
    check_same_loads(a, b, c.mass.mass * kGravity<double>);
    check_near(b.rates.velocity, a.rates.velocity - cross(still.x.rates, body_wind), 1e-8);
    check_near(b.rates.position, a.rates.position + wind, 1e-11);
    const auto ra = flat(a.rates);
    const auto rb = flat(b.rates);
    const auto scale = rate_scale(c);
    for (std::size_t i = 3; i < kStateIndex.position.x; ++i)
      CHECK_NEAR(rb[i], ra[i], 1e-9 * scale[i] * (1 + std::fabs(ra[i])));
  }
}

// A trim holds in any wind, and a manoeuvre flown through the wind is the manoeuvre in still air, carried
// along.
TEST(property_flight_is_carried_by_the_wind) {
  Options options;
  options.position_states = true;
  for (const double mast : {0.0, 60.0, 90.0}) {
    const Configuration<double> c = flight_cases::configuration(mast, options);
    const TrimResult<double> trim = analysis_case::trimmed(c, analysis_case::level(mast < 90 ? 40 : 80));
    if (!CHECK(is_trimmed(trim.status))) continue;
    const V wind = {9, -6, 2};

    StateAndControls<double> windy{trim.state, trim.controls};
    windy.u.gust = to_body(wind, windy.x.roll, windy.x.pitch, windy.x.yaw);
    windy.x.velocity = windy.x.velocity + windy.u.gust;
    State<double> rates;
    derivative(c, windy.x, windy.u, rates);
    check_near(rates.velocity, V{0, 0, 0}, 1e-8);
    check_near(rates.rates, V{0, 0, 0}, 1e-8);

    Controls<double> u = trim.controls;
    u.lat_stick += 0.3;
    u.long_stick -= 0.2;
    constexpr int steps = 500;
    constexpr double dt = 0.002;
    const State<double> in_still_air = flown(c, trim.state, u, V{0, 0, 0}, dt, steps);
    const State<double> in_wind = flown(c, trim.state, u, wind, dt, steps);
    CHECK_LT(0.01, std::fabs(in_still_air.roll));  // it is a manoeuvre
    const auto a = flat(in_still_air);
    const auto b = flat(in_wind);
    for (std::size_t i = 0; i < kStateIndex.position.x; ++i) CHECK_NEAR(b[i], a[i], 1e-6);
    check_near(in_wind.position, in_still_air.position + (dt * steps) * wind, 1e-6);
  }
}

// North is where the map says: heading and place leave everything bit for bit, and the track turns with the
// heading.
TEST(property_heading_and_place_do_not_matter) {
  NOTE("seed " << kSeed + 1);
  Generator random(kSeed + 1);
  for (int k = 0; k < 100; ++k) {
    const Configuration<double> c = random_configuration(random);
    const StateAndControls<double> s = random_case(random, c);
    State<double> turned = s.x;
    const double angle = random.between(-3, 3);
    turned.yaw += angle;
    turned.position = random_vector(random, 1e5);
    State<double> a;
    State<double> b;
    derivative(c, s.x, s.u, a);
    derivative(c, turned, s.u, b);
    const V track = a.position;
    const V expected = {std::cos(angle) * track.x - std::sin(angle) * track.y,
                        std::sin(angle) * track.x + std::cos(angle) * track.y, track.z};
    check_near(b.position, expected, 1e-11);
    a.position = b.position = V{};
    CHECK(flat(a) == flat(b));
  }
}

// d/dt (kinetic + potential energy) = force . velocity + moment . rates, with the loads summed by component.
TEST(property_energy_changes_by_the_power_of_the_loads) {
  NOTE("seed " << kSeed + 2);
  Generator random(kSeed + 2);
  for (int k = 0; k < 300; ++k) {
    const Configuration<double> c = random_configuration(random);
    const StateAndControls<double> s = random_case(random, c);
    Evaluation<double> e;
    evaluate_aircraft(c, s.x, s.u, e);
    V force{};
    V moment{};
    for (const Loads<double>& loads : e.loads.component) {
      force = force + loads.force;
      moment = moment + loads.moment;
    }
    const Inertia<double>& i = c.mass.inertia;
    const V& w = e.rates.rates;
    const V momentum_rate = {i.xx * w.x - i.xz * w.z, i.yy * w.y, i.zz * w.z - i.xz * w.x};
    const double energy_rate = c.mass.mass * dot(s.x.velocity, e.rates.velocity) +
                               dot(s.x.rates, momentum_rate) -
                               c.mass.mass * kGravity<double> * e.rates.position.z;
    const double power = dot(force, s.x.velocity) + dot(moment, s.x.rates);
    const double size = std::sqrt(dot(force, force) * dot(s.x.velocity, s.x.velocity)) +
                        c.mass.mass * kGravity<double> * std::sqrt(dot(s.x.velocity, s.x.velocity)) +
                        std::sqrt(dot(moment, moment) * dot(s.x.rates, s.x.rates));
    CHECK_NEAR(energy_rate, power, 1e-11 * size);
  }
}

// Shaft power = thrust times the speed of the hub and of the inflow + work on flapping and coning + profile
// power, at any state of a rotor whose hub does not turn. Section drag and the work on the harmonics of the
// inflow are summed here; everything else is what the rotor reports.
TEST(property_rotor_power_balance) {
  NOTE("seed " << kSeed + 3);
  Generator random(kSeed + 3);
  for (int k = 0; k < 100; ++k) {
    const Configuration<double> c = random_configuration(random);
    RotorInput<double> in{};
    in.velocity_a = {random.between(-90, 60), random.between(-50, 50), random.between(-40, 120)};
    in.collective = random.between(-0.1, 0.9);
    in.long_cyclic = random.between(-0.2, 0.2);
    in.lateral_cyclic = random.between(-0.2, 0.2);
    in.state = {random.between(-0.2, 0.2),  random.between(-0.2, 0.2),  random.between(-2, 2),
                random.between(-2, 2),      random.between(-0.05, 0.1), random.between(-0.05, 0.05),
                random.between(-0.05, 0.05)};
    in.coning = {random.between(-0.05, 0.15), random.between(-1, 1)};
    const RotorLoads<double> loads = rotor_loads(c, in, c.azimuth);
    const RotorState<double>& x = in.state;
    const double omega = c.setup.rotor_speed;

    double profile = 0;
    double harmonics = 0;
    double shape = 0;  // induced power of what the mean inflow departs from its mean
    double gross = 0;
    for (int j = 0; j < c.azimuth.count; ++j) {
      const double cosine = c.azimuth.cosine[j];
      const double sine = c.azimuth.sine[j];
      const double flap = in.coning.angle + x.b1c * cosine + x.b1s * sine;
      const BladeFlow<double> flow = blade_flow(c, in, cosine, sine);
      const BladeLoads<double> blade = blade_loads(c, element_air(rotor_conditions(c, right)), flow);
      harmonics += c.azimuth.weight * std::cos(flap) * omega * (x.lambda_c * cosine + x.lambda_s * sine) *
                   blade.normal_moment;
      int region = 0;
      for (int i = 0; i < c.blade.count; ++i) {
        while (i >= c.blade.region_end[region]) ++region;
        const BladeStation<double>& s = c.blade.station[i];
        const double ut = flow.tangential_0 + s.radius * flow.tangential_r;
        const double up = flow.normal_0 + s.radius * flow.normal_r + s.inflow_shape * flow.shaped;
        const double speed = std::hypot(std::hypot(ut, up), c.aircraft->smooth.section_speed);
        const double alpha = std::remainder(flow.pitch + s.twist - std::atan2(up, ut), 2 * kPi<double>);
        const SectionCoefficients<double> section = section_coefficients(
            c.aircraft->rotor, c.setup.options.tables, region, alpha, speed / c.air.speed_of_sound);
        const double element =
            c.azimuth.weight * c.air.density * s.half_chord_dr * speed * (ut * ut + up * up);
        profile += element * section.drag;
        shape += element / (ut * ut + up * up) * (s.lift_weight * section.lift * ut - section.drag * up) *
                 s.inflow_shape * flow.shaped;
        gross += element;
      }
    }
    const double induced = loads.force_a.z * c.tip_speed * x.lambda_0 + harmonics + shape;
    const double flapping = in.coning.rate * loads.m0 + x.b1c_rate * loads.mc + x.b1s_rate * loads.ms +
                            omega * (x.b1s * loads.mc - x.b1c * loads.ms);
    CHECK_NEAR(loads.torque * omega, dot(loads.force_a, in.velocity_a) + induced + flapping + profile,
               1e-10 * gross);
    CHECK_LT(0.0, profile);
  }
}

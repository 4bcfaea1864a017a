// Gimbal and coning equations: a single rigid blade followed through space by finite differences, closed
// forms of the textbook rotor, the first-order limit, the coning balance.
#include "settled_rotor.hpp"
#include "tiltrotor/model/variables/presets.hpp"

using namespace flight_cases;
using namespace settled_rotor;

namespace {

// Acceleration normal to a blade element at radius 1, by differences of its position in space. The hub frame
// turns with the constant rate w; the blade turns with omega in it and flaps as b(t).
template <class Flap>
double normal_acceleration(const Vec3<double>& w, double omega, double azimuth, Flap&& b) {
  using L = long double;
  const L wx = w.x;
  const L wy = w.y;
  const L wz = w.z;
  const L turn = std::sqrt(wx * wx + wy * wy + wz * wz);
  struct Place {
    L x, y, z;
  };
  const auto position = [&](L t) {
    const L psi = static_cast<L>(azimuth) + static_cast<L>(omega) * t;
    const L flap = static_cast<L>(b(static_cast<double>(t)));
    const Place p{std::cos(flap) * std::cos(psi), std::cos(flap) * std::sin(psi), std::sin(flap)};
    if (turn == 0) return p;
    // Turned about w by |w| t.
    const L s = std::sin(turn * t);
    const L v = 1 - std::cos(turn * t);
    const L kx = wx / turn;
    const L ky = wy / turn;
    const L kz = wz / turn;
    const L d = kx * p.x + ky * p.y + kz * p.z;
    return Place{p.x + s * (ky * p.z - kz * p.y) + v * (kx * d - p.x),
                 p.y + s * (kz * p.x - kx * p.z) + v * (ky * d - p.y),
                 p.z + s * (kx * p.y - ky * p.x) + v * (kz * d - p.z)};
  };
  const L h = 1e-5L;
  const Place a = position(-h);
  const Place m = position(0);
  const Place e = position(h);
  const L flap = static_cast<L>(b(0.0));
  const L ax = (a.x - 2 * m.x + e.x) / (h * h);
  const L ay = (a.y - 2 * m.y + e.y) / (h * h);
  const L az = (a.z - 2 * m.z + e.z) / (h * h);
  const L psi = static_cast<L>(azimuth);
  return static_cast<double>(-std::sin(flap) * (ax * std::cos(psi) + ay * std::sin(psi)) +
                             std::cos(flap) * az);
}

}  // namespace

// The tilt accelerations, put back into every blade: inertia of the blade against air and spring moment.
TEST_OF_XV15(flapping_single_blade_in_space) {
  NOTE("seed 21");
  Generator random(21);
  FlightSetup<double> setup = flight_setup(aircraft(), 0.0);
  Configuration<double> c;
  if (!CHECK(prepare(aircraft(), setup, c) == Status::ok)) return;
  const double omega = setup.rotor_speed;
  const double inertia = 102.5 * 1.3558180;  // one blade, kg m^2
  for (int n = 0; n < 50; ++n) {
    RotorState<double> x{};
    x.b1c = random.between(-1e-3, 1e-3);
    x.b1s = random.between(-1e-3, 1e-3);
    x.b1c_rate = random.between(-0.05, 0.05);
    x.b1s_rate = random.between(-0.05, 0.05);
    const Vec3<double> w{random.between(-0.05, 0.05), random.between(-0.05, 0.05), 0};
    const double mc = random.between(-3000, 3000);
    const double ms = random.between(-3000, 3000);
    const FlapRates<double> f = flap_rates(c, x, w, mc, ms);
    CHECK_EQ(f.b1c_rate, x.b1c_rate);
    CHECK_EQ(f.b1s_rate, x.b1s_rate);
    for (double azimuth = 0; azimuth < 6; azimuth += 0.5) {
      const auto flap = [&](double t) {
        const double psi = azimuth + omega * t;
        return (x.b1c + t * x.b1c_rate + 0.5 * t * t * f.b1c_acceleration) * std::cos(psi) +
               (x.b1s + t * x.b1s_rate + 0.5 * t * t * f.b1s_acceleration) * std::sin(psi);
      };
      const double blade_inertia = inertia * normal_acceleration(w, omega, azimuth, flap);
      // Hub moment K b of the whole gimbal is shared by three blades: 2/3 K b each, and so are the air loads.
      const double air = 2.0 / 3 * (mc * std::cos(azimuth) + ms * std::sin(azimuth));
      const double spring = 2.0 / 3 * c.hub_spring * flap(0);
      CHECK_NEAR(blade_inertia, air - spring, 1.5);  // of 2000; second order in rates and tilt is left out
    }
  }
}

TEST_OF_XV15(flapping_hub_spring_and_damping) {
  Options options;
  const Configuration<double> c = configuration(0);
  // 225 ft lb a degree: nu^2 - 1 = K/(J Omega^2) = 0.0220.
  const double j = 1.5 * 102.5 * 1.3558180;
  const double omega = c.setup.rotor_speed;
  CHECK_NEAR(c.hub_spring / (j * omega * omega), 0.0220, 1e-4);
  RotorState<double> x{};
  x.b1c = 0.01;
  x.b1s = -0.02;
  const FlapRates<double> f = flap_rates(c, x, Vec3<double>{0, 0, 0}, 0.0, 0.0);
  CHECK_REL(f.b1c_acceleration, -c.hub_spring / j * 0.01, 1e-6);
  CHECK_REL(f.b1s_acceleration, c.hub_spring / j * 0.02, 1e-6);
  options.hub_spring_factor = 2;
  CHECK_REL(configuration(0, options).hub_spring, 2 * c.hub_spring, 1e-15);
}

// The hub of this aircraft has no damping; with one, moments C b1c' and C b1s' act on the gimbal against its
// motion.
TEST_OF_XV15(flapping_damping_of_a_hub_that_has_it) {
  Aircraft<double> damped = aircraft();
  damped.rotor.hub_damping = 250;  // N m s/rad, about 1 % of critical
  Configuration<double> c, d;
  if (!CHECK(prepare(aircraft(), flight_setup(aircraft(), 0.0), c) == Status::ok)) return;
  if (!CHECK(prepare(damped, flight_setup(damped, 0.0), d) == Status::ok)) return;
  CHECK_EQ(aircraft().rotor.hub_damping, 0.0);
  const Vec3<double> w{0.1, -0.2, 0};
  for (double direction : {0.0, 1.0, 2.5}) {
    RotorState<double> x{};
    x.b1c = 0.02;
    x.b1c_rate = 0.7 * std::cos(direction);
    x.b1s_rate = 0.7 * std::sin(direction);
    const FlapRates<double> with = flap_rates(d, x, w, 900.0, -400.0);
    const FlapRates<double> moments = flap_rates(c, x, w, 900 - 250 * x.b1c_rate, -400 - 250 * x.b1s_rate);
    CHECK_NEAR(with.b1c_acceleration, moments.b1c_acceleration, 1e-10);
    CHECK_NEAR(with.b1s_acceleration, moments.b1s_acceleration, 1e-10);
    // It takes energy, C |rate|^2, in whatever direction: power = J (acceleration . rate).
    const FlapRates<double> without = flap_rates(c, x, w, 900.0, -400.0);
    const double j = 1.5 * 102.5 * 1.3558180;
    const double power = j * ((with.b1c_acceleration - without.b1c_acceleration) * x.b1c_rate +
                              (with.b1s_acceleration - without.b1s_acceleration) * x.b1s_rate);
    CHECK_REL(power, -250 * 0.7 * 0.7, 1e-6);
  }
}

// First-order tilt rates put back into the complete equations: with the moment J Omega gamma / 8 that the air
// has against them, and the damping of a hub that has it, nothing accelerates.
TEST(flapping_first_order_rates_balance_the_moments) {
  for (double damping : {0.0, 250.0}) {
    Aircraft<double> changed = aircraft();
    changed.rotor.hub_damping = damping;
    Configuration<double> c;
    if (!CHECK(prepare(changed, flight_setup(changed, 30.0), c) == Status::ok)) return;
    const RotorTables<double>& rotor = changed.rotor;
    const double j = rotor.blades * rotor.flap_inertia / 2;
    const double chord = blade_chord(rotor, c.setup.options.chord, rotor.twist_reference);
    const double gamma =
        c.air.density * rotor.lift_slope * chord * std::pow(rotor.radius, 4) / rotor.flap_inertia;
    const double air = j * c.setup.rotor_speed * gamma / 8;
    for (double mc : {-1500.0, 0.0, 700.0}) {
      for (double ms : {-300.0, 1200.0}) {
        RotorState<double> x{};
        x.b1c = 0.03;
        x.b1s = -0.01;
        const Vec3<double> w{0.1, -0.2, 0};
        const FlapRates<double> first = quasi_static_flap_rates(c, x, w, mc, ms);
        x.b1c_rate = first.b1c_rate;
        x.b1s_rate = first.b1s_rate;
        const FlapRates<double> left = flap_rates(c, x, w, mc - air * x.b1c_rate, ms - air * x.b1s_rate);
        CHECK_NEAR(left.b1c_acceleration, 0.0, 1e-9);
        CHECK_NEAR(left.b1s_acceleration, 0.0, 1e-9);
        CHECK(first.b1c_acceleration == 0.0 && first.b1s_acceleration == 0.0);
      }
    }
  }
}

// Closed form for the uniform blade in hover with the inflow held: cyclic pitch becomes tilt 90 deg later,
// rates lag by 16/(gamma Omega).
TEST(flapping_textbook_limit) {
  const TextbookRotor rotor;
  const Configuration<double> c = rotor.configuration();
  const double omega = c.setup.rotor_speed;
  const double gamma = rotor.lock_number(c);
  RotorInput<double> in{};
  in.collective = 0.03;
  in.state.lambda_0 = 0.01;  // small inflow angles, as the closed form assumes
  const auto tilt = [&](double a1, double b1, double wx, double wy) {
    RotorInput<double> moved = in;
    moved.lateral_cyclic = a1;
    moved.long_cyclic = b1;
    moved.rates_a = {wx, wy, 0};
    return settled(c, moved, true).state;
  };
  const double small = 1e-3;
  const RotorState<double> lateral = tilt(-small, 0, 0, 0);       // th1c
  const RotorState<double> longitudinal = tilt(0, -small, 0, 0);  // th1s
  const RotorState<double> roll = tilt(0, 0, small, 0);
  const RotorState<double> pitch = tilt(0, 0, 0, small);
  CHECK_NEAR(lateral.b1s / small, 1.0, 3e-3);
  CHECK_NEAR(lateral.b1c / small, 0.0, 3e-3);
  CHECK_NEAR(longitudinal.b1c / small, -1.0, 3e-3);
  CHECK_NEAR(longitudinal.b1s / small, 0.0, 3e-3);
  CHECK_NEAR(roll.b1s / small * gamma * omega / 16, -1.0, 0.01);
  CHECK_NEAR(roll.b1c / small * omega, 1.0, 0.02);
  CHECK_NEAR(pitch.b1c / small * gamma * omega / 16, 1.0, 0.01);
  CHECK_NEAR(pitch.b1s / small * omega, 1.0, 0.02);
}

// The complete rotor in hover at 7334 lb: tilt per cyclic with and without spring and coupling, and per pitch
// rate (values of an independent second program).
TEST_OF_XV15(flapping_steady_tilt_in_hover) {
  const double small = 1e-4;
  const auto answer = [&](const Configuration<double>& c, const char* what) {
    const RotorInput<double> in = settled_at_thrust(c, hover_input(c), 7334 * kPound);
    RotorInput<double> moved = in;
    if (*what == 's') moved.long_cyclic -= small;  // th1s = -B1
    if (*what == 'c') moved.lateral_cyclic -= small;
    if (*what == 'q') moved.rates_a.y += small;
    const RotorState<double> a = settled(c, in).state;
    const RotorState<double> b = settled(c, moved).state;
    return std::pair<double, double>{(b.b1c - a.b1c) / small, (b.b1s - a.b1s) / small};
  };
  const Configuration<double> c = configuration(0, reference_options());
  const auto cyclic = answer(c, "s");
  CHECK_NEAR(cyclic.first, -0.983, 0.004);
  CHECK_NEAR(cyclic.second, -0.188, 0.004);
  const auto pitch_rate = answer(c, "q");
  CHECK_NEAR(pitch_rate.first, 0.0962, 0.001);
  CHECK_NEAR(pitch_rate.second, 0.0346, 0.001);
  Aircraft<double> free = aircraft();
  free.rotor.delta3 = 0;
  free.rotor.hub_spring = 0;
  Configuration<double> f;
  if (!CHECK(prepare(free, flight_setup(free, 0.0), f) == Status::ok)) return;
  CHECK_NEAR(answer(f, "c").second, 1.019, 0.004);
  CHECK_NEAR(answer(f, "s").first, -1.019, 0.004);
}

// delta3 = -15 deg: flap up raises pitch by 0.268 of the flap angle.
TEST(flapping_pitch_coupling) {
  const Configuration<double> c = configuration(0);
  RotorInput<double> in = hover_input(c);
  const auto pitch = [&](double cosine, double sine) { return blade_view(c, in, cosine, sine).pitch; };
  const double flat = pitch(1, 0);
  in.state.b1c = 0.1;
  CHECK_NEAR(pitch(1, 0) - flat, 0.0268, 1e-4);
  CHECK_NEAR(pitch(0, 1) - flat, 0.0, 1e-15);
  in.coning.angle += 0.1;  // coning does not couple
  CHECK_NEAR(pitch(1, 0) - flat, 0.0268, 1e-4);
}

TEST_OF_XV15(flapping_first_order_limit) {
  Options options;
  options.flapping = FlapOrder::first;
  for (const double axial : {0.0, 5.0}) {
    const Configuration<double> second = configuration(0);
    const Configuration<double> first = configuration(0, options);
    RotorInput<double> in = hover_input(second);
    in.velocity_a = {-25, 1, axial};
    in.long_cyclic = 0.03;
    in.rates_a = {0.1, -0.05, 0.02};
    in = settled(second, in);
    // At the equilibrium of the second-order equations the first-order rates vanish too, and the loads agree.
    const RotorResponse<double> a = rotor_response(second, in, second.azimuth);
    const RotorResponse<double> b = rotor_response(first, in, first.azimuth);
    CHECK_NEAR(b.flapping.b1c_rate, 0.0, 1e-9);
    CHECK_NEAR(b.flapping.b1s_rate, 0.0, 1e-9);
    CHECK_NEAR(b.loads.force_a.x, a.loads.force_a.x, 1e-6);
    CHECK_NEAR(b.loads.force_a.z, a.loads.force_a.z, 1e-6);
    // Away from it the tilt returns: the rate is that of the slow mode, gamma Omega / 16 = 15 1/s within a
    // third.
    const double away = 0.01;
    RotorInput<double> tilted = in;
    tilted.state.b1c += away;
    const FlapRates<double> r = rotor_response(first, tilted, first.azimuth).flapping;
    const double speed = std::hypot(r.b1c_rate, r.b1s_rate) / away;
    CHECK_LT(r.b1c_rate, 0.0);
    CHECK_NEAR(speed, 15, 5);
    CHECK_EQ(r.b1c_acceleration, 0.0);
    // Tilt rates in the state are not read.
    tilted.state.b1c_rate = 5;
    CHECK_EQ(rotor_response(first, tilted, first.azimuth).flapping.b1c_rate, r.b1c_rate);
  }
}

// b0 = (M0/(N_b I_b) + w0^2 precone)/(Omega^2 + w0^2): 2.7 deg in hover at 7334 lb, 1.9 deg in airplane mode.
TEST_OF_XV15(flapping_coning_balance) {
  Options options;
  options.coning_states = true;
  const Configuration<double> c = configuration(0, options);
  RotorInput<double> in = settled_at_thrust(c, hover_input(c), 7334 * kPound);
  double angle = in.coning.angle;
  const double omega2 = c.setup.rotor_speed * c.setup.rotor_speed;
  const double w2 = (1.85 * 1.85 - 1) * omega2;
  for (int k = 0; k < 30; ++k) {
    in.coning.angle = angle;
    in = settled(c, in);
    const double m0 = rotor_loads(c, in, c.azimuth).m0;
    angle = (m0 / (3 * 102.5 * 1.3558180) + w2 * 2.5 * kRadPerDeg<double>) / (omega2 + w2);
  }
  in.coning.angle = angle;
  CHECK_NEAR(rotor_response(c, in, c.azimuth).coning_acceleration, 0.0, 1e-6 * omega2);
  CHECK_NEAR(angle * kDegPerRad<double>, 2.7, 0.06);
  CHECK_NEAR(configuration(0).coning * kDegPerRad<double>, 2.7, 1e-9);
  CHECK_NEAR(configuration(90).coning * kDegPerRad<double>, 1.9, 1e-9);
  // Free vibration at 1.85 per rev.
  const double still = coning_acceleration(c, ConingState<double>{0.05, 0}, 0.0);
  const double moved = coning_acceleration(c, ConingState<double>{0.06, 0}, 0.0);
  CHECK_REL(-(moved - still) / 0.01, 1.85 * 1.85 * omega2, 1e-12);
}

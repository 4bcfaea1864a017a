// Moving nacelles: two rigid bodies summed by hand (positions, velocities and momenta of nacelles and rest), free
// flight without forces, where momentum stays whatever the masts do, and work of the conversion drive against kinetic
// energy.
#include "tiltrotor/model/setup/nacelle_motion.hpp"

#include <array>
#include <cmath>

#include "flight_cases.hpp"
#include "settled_rotor.hpp"
#include "tiltrotor/model/rigid_body.hpp"

using namespace flight_cases;

namespace {

using V = Vec3<double>;

Configuration<double> at(double mast_deg, double rate, double acceleration, const Options& options = {}) {
  FlightSetup<double> setup = flight_setup(aircraft(), mast_deg);
  setup.mast_rate = rate;
  setup.mast_acceleration = acceleration;
  setup.options = options;
  Configuration<double> c;
  CHECK(prepare(aircraft(), setup, c) == Status::ok);
  return c;
}

V of_inertia(const Inertia<double>& i, const V& w) {
  return {i.xx * w.x - i.xz * w.z, i.yy * w.y, i.zz * w.z - i.xz * w.x};
}

// The two bodies at a mast angle, in axes fixed in the airframe with the origin at the conversion axis.
struct TwoBodies {
  double nacelles, rest;  // kg
  V nacelle_cg, rest_cg, cg;
};
TwoBodies two_bodies(double mast_deg, const Options& options = {}) {
  const MassTables<double>& m = aircraft().mass;
  const MastTables<double>& mast = aircraft().mast;
  TwoBodies b;
  b.nacelles = options.nacelle_mass == NacelleMass::quoted ? m.nacelles_quoted : m.nacelles;
  b.rest = m.gross - b.nacelles;
  const double angle = mast_deg * kPi<double> / 180;
  const auto from_axis = [&mast](double sl, double wl) {
    return V{mast.sl_pivot - sl, 0, mast.wl_pivot - wl};
  };
  const V up = from_axis(m.sl_nacelle, m.wl_nacelle);
  // Nose down about y.
  b.nacelle_cg = {std::cos(angle) * up.x - std::sin(angle) * up.z, 0,
                  std::sin(angle) * up.x + std::cos(angle) * up.z};
  const V cg_0 = from_axis(m.sl_cg, m.wl_cg);
  b.rest_cg = (1 / b.rest) * (m.gross * cg_0 - b.nacelles * up);
  b.cg = (1 / m.gross) * (b.rest * b.rest_cg + b.nacelles * b.nacelle_cg);
  return b;
}

// Angular momentum about the CG that moving nacelles have in an airframe at rest: orbits of both bodies, and the
// nacelles' own turning.
double relative_momentum(double mast_deg, double rate, const Options& options = {}) {
  const double h = 1e-4;  // deg
  const TwoBodies before = two_bodies(mast_deg - h, options), after = two_bodies(mast_deg + h, options);
  const TwoBodies now = two_bodies(mast_deg, options);
  const double per_second = rate / (2 * h * kPi<double> / 180);
  const V nacelle_velocity = per_second * (after.nacelle_cg - before.nacelle_cg);
  const V cg_velocity = per_second * (after.cg - before.cg);
  const V of_nacelles = now.nacelles * cross(now.nacelle_cg - now.cg, nacelle_velocity - cg_velocity);
  const V of_rest = now.rest * cross(now.rest_cg - now.cg, V{0, 0, 0} - cg_velocity);
  const double gyration = aircraft().mass.nacelle_gyration;
  return of_nacelles.y + of_rest.y - now.nacelles * gyration * gyration * rate;
}

struct Attitude {
  V rates;
  double roll, pitch, yaw;
};

V to_earth(const V& a, const Attitude& b) {
  const V after_roll{a.x, std::cos(b.roll) * a.y - std::sin(b.roll) * a.z,
                     std::sin(b.roll) * a.y + std::cos(b.roll) * a.z};
  const V after_pitch{std::cos(b.pitch) * after_roll.x + std::sin(b.pitch) * after_roll.z, after_roll.y,
                      -std::sin(b.pitch) * after_roll.x + std::cos(b.pitch) * after_roll.z};
  return {std::cos(b.yaw) * after_pitch.x - std::sin(b.yaw) * after_pitch.y,
          std::sin(b.yaw) * after_pitch.x + std::cos(b.yaw) * after_pitch.y, after_pitch.z};
}

// Masts from 0 to 90 deg and back in 24 s, smooth: half a cosine each way.
double mast_at(double t) { return 45 * (1 - std::cos(2 * kPi<double> * t / 24)); }
Configuration<double> flown(double t) {
  const double s = 2 * kPi<double> / 24, amplitude = kPi<double> / 4;
  const double mast = std::fmin(90, std::fmax(0, mast_at(t)));
  return at(mast, amplitude * s * std::sin(s * t), amplitude * s * s * std::cos(s * t));
}

// Free flight without forces: classical Runge-Kutta.
Attitude step(const Attitude& x, double t, double h) {
  const auto rates = [](const Attitude& a, double time) {
    const MassProperties<double> mass = flown(time).mass;
    return rigid_body(mass, V{0, 0, 0}, a.rates, a.roll, a.pitch, a.yaw,
                      Loads<double>{{0, 0, 0}, nacelle_moment(mass.nacelles, a.rates)});
  };
  const auto plus = [](const Attitude& a, double by, const RigidBodyRates<double>& d) {
    return Attitude{a.rates + by * d.rates, a.roll + by * d.roll, a.pitch + by * d.pitch, a.yaw + by * d.yaw};
  };
  const auto k1 = rates(x, t);
  const auto k2 = rates(plus(x, h / 2, k1), t + h / 2);
  const auto k3 = rates(plus(x, h / 2, k2), t + h / 2);
  const auto k4 = rates(plus(x, h, k3), t + h);
  return plus(plus(plus(plus(x, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
}

V momentum(const Attitude& x, double t) {
  const Configuration<double> c = flown(t);
  const V body =
      of_inertia(c.mass.inertia, x.rates) + V{0, relative_momentum(c.setup.mast_deg, c.setup.mast_rate), 0};
  return to_earth(body, x);
}

}  // namespace

TEST(nacelles_move_the_cg_as_two_bodies_do) {
  for (const NacelleMass mass : {NacelleMass::printed_cg, NacelleMass::quoted}) {
    Options options;
    options.nacelle_mass = mass;
    for (const double mast : {3.0, 30.0, 61.0, 88.0}) {
      const double rate = 0.13, h = 1e-4;
      const V moved = (rate / (2 * h * kPi<double> / 180)) *
                      (two_bodies(mast + h, options).cg - two_bodies(mast - h, options).cg);
      const NacelleMotion<double> n = at(mast, rate, 0, options).mass.nacelles;
      CHECK_NEAR(n.cg_rate_x, moved.x, 1e-9);
      CHECK_NEAR(n.cg_rate_z, moved.z, 1e-9);
      CHECK_NEAR(n.momentum, relative_momentum(mast, rate, options), 1e-6);
      // The rate of the momentum along the motion, by central differences over time.
      const double acceleration = 0.3, dt = 1e-4;
      const auto later = [&](double t) {
        const double way = (rate + acceleration * t / 2) * t * 180 / kPi<double>;
        return at(mast + way, rate + acceleration * t, 0, options).mass;
      };
      const MassProperties<double> now = at(mast, rate, acceleration, options).mass;
      CHECK_NEAR(now.nacelles.momentum_rate,
                 (later(dt).nacelles.momentum - later(-dt).nacelles.momentum) / (2 * dt), 1e-5);
      const Inertia<double> up = later(dt).inertia, down = later(-dt).inertia;
      CHECK_NEAR(now.nacelles.inertia_rate.xx, (up.xx - down.xx) / (2 * dt), 1e-5);
      CHECK_NEAR(now.nacelles.inertia_rate.yy, (up.yy - down.yy) / (2 * dt), 1e-5);
      CHECK_NEAR(now.nacelles.inertia_rate.zz, (up.zz - down.zz) / (2 * dt), 1e-5);
      CHECK_NEAR(now.nacelles.inertia_rate.xz, (up.xz - down.xz) / (2 * dt), 1e-5);
    }
  }
}

// No force: whatever the masts do, the angular momentum in space stays; without any, the way there and back leads
// to where it began, and on the way pitch follows from the momentum alone.
TEST(nacelles_leave_the_momentum_of_free_flight) {
  Attitude x{{0.05, -0.03, 0.04}, 0.2, -0.3, 0.5};
  const V before = momentum(x, 0);
  const double h = 0.02, size = std::sqrt(dot(before, before));
  double changed = 0;
  for (int k = 0; k < 1200; ++k) {
    x = step(x, k * h, h);
    const V now = momentum(x, (k + 1) * h);
    const V error = now - before;
    // The reference's own momentum comes from a central difference over 2e-4 deg.
    CHECK_LT(std::sqrt(dot(error, error)), 1e-8 * size);
    changed = std::fmax(changed, std::fabs(x.rates.y + 0.03));
  }
  CHECK_LT(0.005, changed);
}

TEST(nacelles_forth_and_back_return_the_attitude) {
  Attitude x{{0, 0, 0}, 0, 0.1, 0};
  const double h = 0.02;
  double by_momentum = 0.1, largest = 0;
  const auto pitch_rate = [](double t) {
    const Configuration<double> c = flown(t);
    return -relative_momentum(c.setup.mast_deg, c.setup.mast_rate) / c.mass.inertia.yy;
  };
  for (int k = 0; k < 1200; ++k) {
    by_momentum += h / 6 * (pitch_rate(k * h) + 4 * pitch_rate((k + 0.5) * h) + pitch_rate((k + 1) * h));
    x = step(x, k * h, h);
    CHECK_NEAR(x.pitch, by_momentum, 1e-9);
    largest = std::fmax(largest, std::fabs(x.pitch - 0.1));
  }
  CHECK_NEAR(x.pitch, 0.1, 1e-11);
  CHECK_NEAR(x.rates.y, 0, 1e-11);
  CHECK_LT(0.03, largest);  // nacelles nose down, airframe nose up
}

// The drive's work is the kinetic energy: in the plane of symmetry, with the inertia of two rigid bodies. Moment of
// the drive from the nacelles' own balance about the conversion axis.
TEST(nacelles_kinetic_energy_is_the_work_of_the_drive) {
  const double gyration2 = square(aircraft().mass.nacelle_gyration);
  const double rest_inertia = 20000;  // kg m^2; any
  struct Motion {
    double q, rate, mast_deg;
  };
  const auto inertia = [&](double mast_deg) {
    const TwoBodies b = two_bodies(mast_deg);
    const V apart = b.nacelle_cg - b.rest_cg;
    return rest_inertia + b.nacelles * gyration2 +
           b.nacelles * b.rest / (b.nacelles + b.rest) * dot(apart, apart);
  };
  const auto energy = [&](const Motion& m) {
    // Both bodies in a frame at the CG: own turning and orbits.
    const double h = 1e-4;
    const V turn = (1 / (2 * h * kPi<double> / 180)) *
                   (two_bodies(m.mast_deg + h).nacelle_cg - two_bodies(m.mast_deg - h).nacelle_cg);
    const TwoBodies b = two_bodies(m.mast_deg);
    const V apart = b.nacelle_cg - b.rest_cg;
    const V speed = m.rate * turn + cross(V{0, m.q, 0}, apart);
    return 0.5 * rest_inertia * m.q * m.q + 0.5 * b.nacelles * gyration2 * square(m.q - m.rate) +
           0.5 * b.nacelles * b.rest / (b.nacelles + b.rest) * dot(speed, speed);
  };
  const double acceleration = 0.2;
  for (const Motion& m : {Motion{0.1, 0.13, 20}, Motion{-0.2, -0.1, 70}}) {
    MassProperties<double> mass = at(m.mast_deg, m.rate, acceleration).mass;
    const double h = 1e-3;
    mass.inertia.yy = inertia(m.mast_deg);
    mass.nacelles.inertia_rate.yy =
        m.rate * (inertia(m.mast_deg + h) - inertia(m.mast_deg - h)) / (2 * h) * 180 / kPi<double>;
    const double q_rate = rigid_body(mass, V{0, 0, 0}, V{0, m.q, 0}, 0.0, 0.0, 0.0,
                                     Loads<double>{{0, 0, 0}, nacelle_moment(mass.nacelles, V{0, m.q, 0})})
                              .rates.y;
    // dE/dt along the motion.
    const double dt = 1e-5;
    const auto later = [&](double t) {
      return energy({m.q + q_rate * t, m.rate + acceleration * t,
                     m.mast_deg + (m.rate + acceleration * t / 2) * t * 180 / kPi<double>});
    };
    const double power = (later(dt) - later(-dt)) / (2 * dt);
    // Acceleration of the nacelles' CG seen from the CG of the aircraft, which no force moves: both turn.
    const TwoBodies b = two_bodies(m.mast_deg);
    const auto place = [&](double t) {
      const double pitch = m.q * t + q_rate * t * t / 2;
      const TwoBodies now = two_bodies(m.mast_deg + (m.rate + acceleration * t / 2) * t * 180 / kPi<double>);
      const V a = now.nacelle_cg - now.cg;
      return V{std::cos(pitch) * a.x + std::sin(pitch) * a.z, 0,
               -std::sin(pitch) * a.x + std::cos(pitch) * a.z};
    };
    const double ds = 1e-3;
    const V pull = (b.nacelles / (ds * ds)) * (place(ds) - 2.0 * place(0) + place(-ds));
    const double own = b.nacelles * gyration2 * (q_rate - acceleration);
    const double drive = own + cross(b.nacelle_cg, pull).y;  // about the conversion axis, on the nacelles
    CHECK_NEAR(power, -drive * m.rate, 2e-3 + 1e-4 * std::fabs(power));
    CHECK_LT(1, std::fabs(power));
  }
}

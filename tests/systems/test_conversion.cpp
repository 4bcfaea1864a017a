// Conversion drive and flaps: against closed forms of the linear follower and of the limits.
#include "vehicle_case.hpp"

using namespace vehicle_case;

namespace {

const SystemTables<double>& tables() { return aircraft_data<double>().systems; }

// Two states by the classical Runge-Kutta method, steps of a millisecond; `command` of time.
struct Mast {
  double angle, rate, fastest = 0, hardest = 0, highest = 0;

  template <class Command>
  void go(double seconds, Command&& command) {
    const double h = 0.001;
    const int steps = static_cast<int>(std::lround(seconds / h));
    for (int k = 0; k < steps; ++k) {
      double da[4], dr[4];
      for (int i = 0; i < 4; ++i) {
        const double part = i == 0 ? 0 : i == 3 ? h : h / 2;
        const double a = angle + (i == 0 ? 0 : part * da[i - 1]), r = rate + (i == 0 ? 0 : part * dr[i - 1]);
        const MastMotion<double> m = mast_motion(tables(), command(k * h + part), a, r);
        da[i] = m.rate;
        dr[i] = m.acceleration;
        hardest = std::max(hardest, std::fabs(m.acceleration));
      }
      angle += h / 6 * (da[0] + 2 * da[1] + 2 * da[2] + da[3]);
      rate += h / 6 * (dr[0] + 2 * dr[1] + 2 * dr[2] + dr[3]);
      fastest = std::max(fastest, std::fabs(rate));
      highest = std::max(highest, angle);
    }
  }
};

}  // namespace

// The longest way: at the drive's rate, reached by its acceleration; as long as that takes, and half a second each of
// the two lags; and no further than it was told.
TEST(conversion_is_limited_and_arrives_without_overshoot) {
  const ConversionTables<double>& drive = tables().conversion;
  const double way = 90 * kDeg;
  Mast mast{0, 0};
  mast.go(drive.rate / drive.acceleration + 1, [=](double) { return way; });
  CHECK_REL(mast.rate, drive.rate, 1e-3);
  mast.go(way / drive.rate + 4 - 1, [=](double) { return way; });
  CHECK_NEAR(mast.angle, way, 1e-4);
  CHECK_LE(mast.highest, way + 1e-9);
  CHECK_LE(mast.fastest, drive.rate);
  CHECK_LE(mast.hardest, drive.acceleration);
  CHECK_LT(0.99 * drive.acceleration, mast.hardest);
  NOTE("fastest " << mast.fastest / kDeg << " deg/s, hardest " << mast.hardest / kDeg
                  << " deg/s^2, highest less command " << (mast.highest - way) / kDeg << " deg");
  Mast back{way, 0};
  back.go(way / drive.rate + 4, [](double) { return 0.0; });
  CHECK_NEAR(back.angle, 0, 1e-4);
  CHECK_NEAR(back.fastest, mast.fastest, 1e-6);
}

// A small command: x'' = k2 (k1 (c - x) - x'), critically damped with k2 = 4 k1: c (1 - (1 + k2 t/2) exp(-k2 t/2)).
// Of any gains the eigenvalues of [0 1; -k1 k2, -k2].
TEST(conversion_follows_small_commands_as_a_linear_system) {
  const ConversionTables<double>& drive = tables().conversion;
  const double k1 = drive.position_gain, k2 = drive.rate_gain;
  const double half = k2 / 2, under = half * half - k1 * k2, command = 0.02 * kDeg;
  CHECK_LE(0, under);  // no overshoot
  Mast mast{0, 0};
  for (int k = 1; k <= 10; ++k) {
    mast.go(0.1, [=](double) { return command; });
    const double t = 0.1 * k, w = std::sqrt(under);
    const double bulge = w * t > 1e-6 ? std::cosh(w * t) + half / w * std::sinh(w * t) : 1 + half * t;
    CHECK_NEAR(mast.angle, command * (1 - bulge * std::exp(-half * t)), 1e-4 * command);
  }
}

// A command that moves slowly: the same rate, behind by rate/k1.
TEST(conversion_follows_a_slow_command_at_its_rate) {
  const double rate = 1 * kDeg;
  Mast mast{0, 0};
  mast.go(8, [=](double t) { return rate * t; });
  CHECK_REL(mast.rate, rate, 1e-6);
  CHECK_NEAR(mast.angle, rate * (8 - 1 / tables().conversion.position_gain), 2e-4 * kDeg);
}

// Law of the flaps: their rate far away, exponential near by.
TEST(conversion_flaps_have_their_rate_and_lag) {
  const ConversionTables<double>& drive = tables().conversion;
  CHECK_REL(flap_rate(tables(), 40 * kDeg, 0.0), drive.flap_rate, 1e-3);
  CHECK_REL(flap_rate(tables(), 0.0, 40 * kDeg), -drive.flap_rate, 1e-3);
  CHECK_LE(flap_rate(tables(), 75 * kDeg, 0.0), drive.flap_rate);
  const double near = 0.01 * kDeg;
  CHECK_REL(flap_rate(tables(), near, 0.0), drive.flap_gain * near, 1e-4);
  CHECK_NEAR(flap_rate(tables(), near, near), 0, 1e-15);
}

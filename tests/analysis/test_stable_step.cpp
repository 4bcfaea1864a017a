// How long a step may be, held against eigenvalues: those of A over the settings and flights that are
// accepted, in and out of trim, and the stability functions of the methods, the exponential series to their
// order.
#include <algorithm>
#include <complex>
#include <memory>
#include <random>

#include "analysis_case.hpp"
#include "tiltrotor/analysis/flight/stable_step.hpp"
#include "tiltrotor/math/algebra/eigen.hpp"

using namespace analysis_case;

namespace {

using Complex = std::complex<double>;

constexpr int kOrders[] = {3, 4};
constexpr StabilityLimits kLimits[] = {kRungeKutta3Limits, kRungeKutta4Limits};
constexpr Integrator kMethods[] = {Integrator::rk3, Integrator::rk4};

double amplification(Complex z, int order) {
  Complex sum = 1, term = 1;
  for (int k = 1; k <= order; ++k) {
    term *= z / static_cast<double>(k);
    sum += term;
  }
  return std::abs(sum);
}

struct Settings {
  double mast_deg, rotor_speed, altitude;
  bool coning;
  Options options = {};
};
bool prepared(const Settings& settings, Configuration<double>& c) {
  FlightSetup<double> setup = flight_setup(aircraft_data<double>(), settings.mast_deg);
  setup.rotor_speed = settings.rotor_speed;
  setup.altitude = settings.altitude;
  setup.options = settings.options;
  setup.options.grid = BladeGrid::realtime;
  setup.options.coning_states = settings.coning;
  return CHECK(prepare(aircraft_data<double>(), setup, c) == Status::ok);
}

struct Extremes {
  double decaying = 0;  // largest |R| of a mode that decays
  double growth = 0;    // largest relative error of the growth of one that does not, below 3 1/s
};

// At the longest step that is allowed, and at shorter ones.
void hold_against_eigenvalues(const Configuration<double>& c, const State<double>& x,
                              const Controls<double>& u, Extremes& found) {
  static LinearizationWorkspace<double> work;
  static LinearModel<double> model;
  static EigenWorkspace<double, kMaxLinearStates> eigen;
  static Eigenvalues<double, kMaxLinearStates> values;
  if (!CHECK(linearize(c, x, u, ControlSet{0, {}}, work, model) == Status::ok)) return;
  if (!CHECK(eigenvalues(model.a, model.states, eigen, values) == Status::ok)) return;
  const FastestRates<double> fastest = fastest_rates(c, x, u);
  for (int method = 0; method < 2; ++method) {
    const double longest = longest_stable_step(fastest, kLimits[method]);
    for (double part : {0.4, 0.7, 1.0}) {
      for (int i = 0; i < model.states; ++i) {
        const Complex z = part * longest * Complex(values.real[i], values.imag[i]);
        const double size = amplification(z, kOrders[method]);
        if (values.real[i] < -1e-9) found.decaying = std::max(found.decaying, size);
        if (std::hypot(values.real[i], values.imag[i]) < 3)
          found.growth = std::max(found.growth, std::abs(size / std::exp(z.real()) - 1));
      }
    }
  }
}

}  // namespace

// The limits are those of the stability functions: from 10 deg off the imaginary axis on, and on it.
TEST(response_stability_limits_are_those_of_the_methods) {
  for (int method = 0; method < 2; ++method) {
    const auto stable = [&](double size, double degrees) {
      return amplification(std::polar(size, degrees * kDeg), kOrders[method]) <= 1 + 1e-12;
    };
    for (double size = 0.01; size <= kLimits[method].decay; size += 0.01)
      for (double degrees = 100; degrees <= 180; degrees += 1) CHECK(stable(size, degrees));
    for (double size = 0.01; size <= kLimits[method].oscillation; size += 0.01)
      for (double degrees = 90; degrees <= 100; degrees += 1) CHECK(stable(size, degrees));
    CHECK(!stable(kLimits[method].oscillation + 0.001, 90));
  }
}

namespace {
// Trims over the settings and flights that are accepted.
template <class See>
int over_trims(See&& see) {
  static TrimWorkspace<double> work;
  static TrimResult<double> r;
  static Configuration<double> c;
  const LimitTables<double>& limits = aircraft_data<double>().limits;
  const double slow = limits.rotor_speed.low, fast = limits.rotor_speed.high;
  TrimOptions cold;
  cold.continuation = false;
  int trims = 0;
  for (double mast : {0.0, 45.0, 75.0, 90.0})
    for (double rotor_speed : {slow, 0.5 * fast, 0.675 * fast, 0.775 * fast, fast})
      for (double altitude : {limits.altitude.low, limits.altitude.high})
        for (double climb : {-0.6, 0.0, 0.6})
          for (double part : {0.0, 4.0 / 15, 0.5, 11.0 / 15, 1.0}) {
            const SteadyFlight<double> flight = {part * limits.speed, climb, 0, 0};
            if (!prepared({mast, rotor_speed, altitude, part < 0.7}, c)) continue;
            if (!is_trimmed(trim(c, flight, work, r, cold))) continue;
            ++trims;
            see(c, r);
          }
  return trims;
}
}  // namespace

TEST(response_longest_step_is_stable_in_trim) {
  Extremes found;
  const int trims = over_trims([&](const Configuration<double>& c, const TrimResult<double>& r) {
    hold_against_eigenvalues(c, r.state, r.controls, found);
  });
  CHECK_LT(150, trims);
  CHECK_LE(found.decaying, 1.0);
  CHECK_LT(found.growth, 1e-3);
  NOTE(trims << " trims: largest |R| " << found.decaying << ", growth of slow modes within " << found.growth);
}

// What tiltrotor.h promises of tr_step, which takes RK4 beyond 0.01 s.
TEST_OF_XV15(response_parts_of_usual_steps) {
  int most[3] = {0, 0, 0};
  const int trims = over_trims([&](const Configuration<double>& c, const TrimResult<double>& r) {
    const FastestRates<double> fastest = fastest_rates(c, r.state, r.controls);
    const double frames[] = {0.005, 0.01, 0.02};
    for (int k = 0; k < 3; ++k)
      most[k] = std::max(most[k], flight_step::parts(kMethods[k / 2], frames[k], fastest));
  });
  CHECK_LT(150, trims);
  CHECK_EQ(most[0], 1);
  CHECK_LE(most[1], 2);
  CHECK_EQ(most[2], 2);
  NOTE("parts of 5, 10, 20 ms " << most[0] << " " << most[1] << " " << most[2]);
}

// Any direction of flight up to 200 m/s and gusts, stalled blades, gimbal and inflow far from balance.
TEST(response_longest_step_is_stable_out_of_trim) {
  const LimitTables<double>& limits = aircraft_data<double>().limits;
  static Configuration<double> c;
  std::mt19937_64 random(20);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) / 9007199254740992.0;
  };
  Extremes found;
  for (int k = 0; k < 2000; ++k) {
    Settings settings = {k % 3 == 0   ? 0
                         : k % 3 == 1 ? 90
                                      : between(0, 90),
                         between(limits.rotor_speed.low, limits.rotor_speed.high),
                         k % 2 == 0 ? limits.altitude.low : limits.altitude.high, k % 4 < 2};
    if (k % 4 == 3) {  // the model's choices that make modes faster
      settings.options.apparent_mass = random() % 2 == 0 ? ApparentMass::loaded : ApparentMass::impermeable;
      settings.options.induced_power_factor = between(0.5, 2);
      settings.options.hub_spring_factor = between(0, 10);
      settings.options.inflow = random() % 3 == 0 ? InflowShape::uniform : InflowShape::pitt_peters;
      settings.options.flapping = random() % 3 == 0 ? FlapOrder::first : FlapOrder::second;
      settings.options.flap_angular_acceleration = random() % 3 == 0;
    }
    if (!prepared(settings, c)) continue;
    State<double> x{};
    Controls<double> u{};
    const double speed = between(0, 200), z = between(-1, 1), azimuth = between(-3.15, 3.15);
    const double level = std::sqrt(1 - z * z);
    x.velocity = {speed * level * std::cos(azimuth), speed * level * std::sin(azimuth), speed * z};
    if (k % 5 < 3) x.velocity = {k % 5 < 2 ? speed : -speed, between(-5, 5), between(-5, 5)};
    const bool wild = k % 10 == 9;
    const double rate = wild ? 10 : 0.3, tilt = wild ? 1 : 0.1, inflow = wild ? 1 : 0.05;
    x.rates = {between(-rate, rate), between(-rate, rate), between(-rate, rate)};
    x.roll = between(-1, 1);
    x.pitch = between(-1, 1);
    for (int side = 0; side < 2; ++side) {
      RotorState<double>& rotor = x.rotor[side];
      rotor.b1c = between(-tilt, tilt);
      rotor.b1s = between(-tilt, tilt);
      rotor.b1c_rate = between(-10 * tilt, 10 * tilt);
      rotor.b1s_rate = between(-10 * tilt, 10 * tilt);
      rotor.lambda_0 = between(-inflow, inflow);
      rotor.lambda_c = between(-inflow, inflow);
      rotor.lambda_s = between(-inflow, inflow);
      x.coning[side].angle = between(0, 0.1);
    }
    u.collective = between(-0.35, 1.4);
    u.long_stick = between(-4.8, 4.8);
    u.lat_stick = between(-4.8, 4.8);
    u.pedal = between(-2.5, 2.5);
    u.gust = {between(-30, 30), between(-30, 30), between(-30, 30)};
    Extremes here;
    hold_against_eigenvalues(c, x, u, here);
    if (!CHECK_LE(here.decaying, 1.0)) NOTE("state " << k << ", " << speed << " m/s");
    found.decaying = std::max(found.decaying, here.decaying);
  }
  NOTE("largest |R| " << found.decaying);
}

TEST_OF_XV15(response_parts_are_few_in_any_state) {
  const auto parts_at = [](const Configuration<double>& c, const State<double>& x, const Controls<double>& u,
                           Integrator integrator,
                           double dt) { return flight_step::parts(integrator, dt, fastest_rates(c, x, u)); };
  Configuration<double> c;
  if (!prepared({90, 80, 0, true}, c)) return;
  State<double> x{};
  Controls<double> u{};
  x.velocity = {300, 0, 0};
  CHECK_EQ(parts_at(c, x, u, Integrator::rk3, 0.005), 1);
  CHECK_EQ(parts_at(c, x, u, Integrator::rodas3, 0.02), 1);
  // The largest numbers tr_set_state and tr_set_controls accept.
  x.velocity = {300, 300, 300};
  x.rates = {20, 20, 20};
  u.gust = {-50, -50, -50};
  for (RotorState<double>& rotor : x.rotor) rotor.lambda_0 = rotor.lambda_c = rotor.lambda_s = 2;
  CHECK_LE(parts_at(c, x, u, Integrator::rk4, 0.02), 45);
  CHECK_LE(parts_at(c, x, u, Integrator::rk3, 0.01), 45);
  CHECK_LT(20, parts_at(c, x, u, Integrator::rk4, 0.02));
  // What no flight reaches ends too.
  x.velocity = {1e300, 0, 0};
  CHECK_EQ(parts_at(c, x, u, Integrator::rk4, 0.02), flight_step::kMaxParts);
}

// Long steps, begun off trim, end where short ones do.
TEST_OF_XV15(response_long_steps_follow_short_ones) {
  static SimulationWorkspace<double> work;
  static TrimWorkspace<double> trim_work;
  static TrimResult<double> r;
  struct Case {
    Settings settings;
    double speed;
  };
  for (const Case& flight : {Case{{90, 54, 0, false}, 150}, Case{{90, 80, -500, true}, 150},
                             Case{{75, 80, 0, true}, 75}, Case{{0, 62, 0, true}, 0}}) {
    Configuration<double> c;
    if (!prepared(flight.settings, c)) return;
    if (!CHECK(is_trimmed(trim(c, level(flight.speed), trim_work, r)))) continue;
    State<double> begin = r.state;
    begin.rotor[right].lambda_c += 0.002;
    begin.rotor[left].b1c_rate += 0.1;
    const auto flown = [&](Integrator integrator, double dt) {
      Simulation<double> s;
      CHECK(start(c, begin, r.controls, dt, integrator, s) == Status::ok);
      for (int k = 0; k < std::lround(2 / dt); ++k) CHECK(advance(c, work, s) == Status::ok);
      return s.state;
    };
    double fine[state_count], found[state_count];
    flatten(flown(Integrator::rk4, 0.002), fine);
    double worst = 0;
    for (Integrator integrator : {Integrator::rk3, Integrator::rk4}) {
      for (double dt : {0.01, 0.02, 0.1, 1.0}) {
        flatten(flown(integrator, dt), found);
        for (int i = 0; i < state_count; ++i) worst = std::max(worst, std::abs(found[i] - fine[i]));
      }
    }
    CHECK_LT(worst, 2e-3);
    NOTE(flight.settings.mast_deg << " deg, " << flight.speed << " m/s: " << worst);
  }
}

// A gust at one rotor counts as motion through air at rest does.
TEST(response_stability_counts_gusts_at_the_rotors) {
  Configuration<double> c = configuration(0);
  State<double> x{};
  const Controls<double> u{};
  x.velocity = {30, -10, 20};
  const double moving = fastest_rates(c, x, u).decay;
  x.velocity = {0, 0, 0};
  CHECK_LT(fastest_rates(c, x, u).decay, 0.7 * moving);
  for (const Side side : {right, left}) {
    c.around = {};
    c.around.rotor_gust_b[side] = {-30, 10, -20};
    CHECK_REL(fastest_rates(c, x, u).decay, moving, 1e-14);
  }
}

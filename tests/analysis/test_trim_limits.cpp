// Trim: where none exists or a limit is exceeded, and what it says then.
// Expected: bounds of the tables, another program's corridor, sentences as their header words them.
#include <algorithm>
#include <cstring>
#include <limits>

#include "analysis_case.hpp"

using namespace analysis_case;

// Lower ends of the conversion corridor and the end of helicopter mode: computed with another
// program.
TEST(trim_tells_why_there_is_none) {
  const TrimResult<double> stalled = trimmed(flown_configuration(30), flown(level(24)));
  CHECK(stalled.status == TrimStatus::wing_stall);
  CHECK(stalled.limits.exceeded[0].limit == TrimLimit::wing_angle);
  CHECK(contains(explanation(stalled), "wing angle of attack"));
  CHECK(trimmed(flown_configuration(30), flown(level(29))).status == TrimStatus::ok);

  const TrimResult<double> slow = trimmed(flown_configuration(90), flown(level(45)));
  CHECK(slow.status == TrimStatus::not_converged);
  CHECK_LT(1e-3, slow.residual);
  CHECK(contains(explanation(slow), "left in the rate of"));
  CHECK(contains(explanation(slow), "wing angle of attack"));

  const TrimResult<double> stalls = trimmed(flown_configuration(0), flown(level(60)));
  CHECK(stalls.status == TrimStatus::rotor_stall);
  CHECK(contains(explanation(stalls), "before its rotors stall"));

  const TrimResult<double> fast = trimmed(flown_configuration(0), flown(level(75)));
  CHECK(fast.status == TrimStatus::not_converged);
  CHECK(contains(explanation(fast), "no trim found"));

  CHECK_EQ(slow.weight_carried, 1.0);
  CHECK_EQ(fast.weight_carried, 1.0);

  const TrimResult<double> sideways = trimmed(flown_configuration(0), flown({40, 0, 0, 20 * kDeg}));
  CHECK(sideways.status == TrimStatus::control_limit);
  CHECK(sideways.limits.exceeded[0].limit == TrimLimit::pedal);
  const double travel = aircraft_data<double>().controls.pedal_travel;
  CHECK_LT(travel, std::abs(sideways.limits.exceeded[0].value));
  CHECK_NEAR(std::abs(sideways.limits.exceeded[0].bound), travel, 1e-12);
  CHECK(contains(explanation(sideways), "pedal"));

  CHECK(explanation(trimmed(flown_configuration(0), flown(level(20)))) == "trimmed in 4 Newton steps");
  char tiny[8];
  CHECK_EQ(explain(fast, tiny, 8), 7);
  CHECK_EQ(std::strlen(tiny), 7u);
  CHECK_EQ(explain(fast, tiny, 0), 0);
}

TEST(trim_refuses_bad_input) {
  const Configuration<double> c = configuration(0);
  const double nan = std::nan("");
  struct Case {
    SteadyFlight<double> flight;
    SteadyFlightField field;
  };
  const Case cases[] = {{{nan, 0, 0, 0}, SteadyFlightField::speed},
                        {{-1, 0, 0, 0}, SteadyFlightField::speed},
                        {{c.aircraft->limits.speed + 1, 0, 0, 0}, SteadyFlightField::speed},
                        {{std::numeric_limits<double>::infinity(), 0, 0, 0}, SteadyFlightField::speed},
                        {{10, 1.6, 0, 0}, SteadyFlightField::climb},
                        {{10, nan, 0, 0}, SteadyFlightField::climb},
                        {{10, 0, nan, 0}, SteadyFlightField::turn_rate},
                        {{10, 0, 0, nan}, SteadyFlightField::sideslip},
                        {{10, 0, 0, 0, {nan, 0, 0}}, SteadyFlightField::gust},
                        {{10, 0, 0, 0, {0, nan, 0}}, SteadyFlightField::gust},
                        {{10, 0, 0, 0, {0, 0, nan}}, SteadyFlightField::gust},
                        {{10, 0, 1.1, 0}, SteadyFlightField::turn_rate},
                        {{10, 0, 0, -1.1}, SteadyFlightField::sideslip}};
  for (const Case& k : cases) {
    const TrimResult<double> r = trimmed(c, k.flight);
    const bool finite = all_finite(k.flight);
    CHECK(r.status == (finite ? TrimStatus::out_of_range : TrimStatus::not_finite));
    CHECK(r.invalid == k.field);
    CHECK_EQ(r.iterations, 0);
    CHECK_EQ(r.state.pitch, 0.0);
    CHECK(contains(explanation(r), "bad input"));
  }
  TrimOptions options;
  for (const int bad : {0, kMaxTrimIterations + 1}) {
    options.max_iterations = bad;
    CHECK(trimmed(c, level(10), options).status == TrimStatus::out_of_range);
    CHECK(explanation(trimmed(c, level(10), options)) == "bad input: configuration or options");
  }
  options = {};
  for (const int bad : {kAllEngines - 1, c.aircraft->controls.engines + 1}) {
    options.engines = bad;
    CHECK(trimmed(c, level(10), options).status == TrimStatus::out_of_range);
  }
  const Configuration<double> unprepared{};
  CHECK(trimmed(unprepared, level(10)).status == TrimStatus::out_of_range);
}

// Each limit alone, a tenth beyond on either side and just within.
TEST(trim_limits_are_found_one_by_one) {
  const Configuration<double> c = configuration(0);
  const ControlTables<double>& t = c.aircraft->controls;
  const RotorResponse<double> idle[2] = {};
  struct Case {
    TrimLimit limit;
    double bound;
    double Controls<double>::*control;
    double BladeControls<double>::*surface;
  };
  using U = Controls<double>;
  using S = BladeControls<double>;
  const Case cases[] = {{TrimLimit::long_stick, t.long_travel, &U::long_stick, nullptr},
                        {TrimLimit::lat_stick, t.lat_travel, &U::lat_stick, nullptr},
                        {TrimLimit::pedal, t.pedal_travel, &U::pedal, nullptr},
                        {TrimLimit::elevator, t.elevator_limit, nullptr, &S::elevator},
                        {TrimLimit::aileron, t.aileron_limit, nullptr, &S::aileron},
                        {TrimLimit::rudder, t.rudder_limit, nullptr, &S::rudder}};
  for (const Case& k : cases) {
    for (const double part : {-1.1, -1.0, 1.0, 1.1}) {
      Controls<double> u{};
      BladeControls<double> surfaces{};
      (k.control != nullptr ? u.*k.control : surfaces.*k.surface) = part * k.bound;
      const LimitCheck<double> check = check_limits(c, 0.0, 0.0, State<double>{}, u, surfaces, idle);
      const bool beyond = std::abs(part) > 1;
      CHECK(check.exceeded[0].limit == (beyond ? k.limit : TrimLimit::none));
      CHECK(check.status == (beyond ? TrimStatus::control_limit : TrimStatus::ok));
      CHECK_EQ(check.exceeded[0].value, beyond ? part * k.bound : 0.0);
      CHECK_EQ(check.exceeded[0].bound, beyond ? std::copysign(k.bound, part) : 0.0);
    }
  }
  for (const int side : {right, left}) {
    State<double> x{};
    x.rotor[side].b1c = -0.8 * t.flap_limit;
    CHECK(check_limits(c, 0.0, 0.0, x, {}, {}, idle).status == TrimStatus::ok);
    x.rotor[side].b1s = 0.8 * t.flap_limit;
    const LimitCheck<double> check = check_limits(c, 0.0, 0.0, x, {}, {}, idle);
    CHECK(check.status == TrimStatus::flap_limit && is_trimmed(check.status));
    CHECK(check.exceeded[0].limit == (side == right ? TrimLimit::gimbal_right : TrimLimit::gimbal_left));
    CHECK_NEAR(check.exceeded[0].value, std::sqrt(1.28) * t.flap_limit, 1e-15);
  }
}

TEST(trim_explanations_of_every_outcome) {
  TrimResult<double> r{};
  r.status = TrimStatus::not_finite;
  r.residual_state = kStateIndex.velocity.z;
  CHECK(explanation(r) == "the rate of w is not a number at the first guess");
  r.status = TrimStatus::singular;
  r.iterations = 12;
  const std::string begin = "no trim found in 12 Newton steps: scaled residual ";
  const auto residual = [&](double value, const char* words) {
    r.residual = value;
    if (!CHECK(explanation(r) == begin + words + " left in the rate of w")) NOTE(explanation(r));
  };
  residual(0, "0");
  residual(7654, "7e3");
  residual(2.5e-4, "2e-4");
  residual(HUGE_VAL, "no number");
  residual(std::nan(""), "no number");
  residual(-1, "no number");
  residual(std::numeric_limits<double>::denorm_min(), "4e-324");
  r.status = TrimStatus::flap_limit;
  const auto limit = [&](TrimLimit which, double value, double bound, const std::string& words) {
    r.limits = {};
    if (which != TrimLimit::none) r.limits.add(r.status, which, value, bound);
    if (!CHECK(explanation(r) == "trimmed, but " + words)) NOTE(explanation(r));
  };
  limit(TrimLimit::gimbal_left, 12.345 * kDeg, 12 * kDeg, "left gimbal tilt 12.35 deg is beyond 12.00 deg");
  limit(TrimLimit::lat_stick, -4.904, -4.8, "lateral stick -4.90 in is beyond -4.80 in");
  limit(TrimLimit::pedal, -0.001, std::nan(""), "pedal 0.00 in is beyond no number in");
  limit(TrimLimit::pedal, -1e9, HUGE_VAL, "pedal very large in is beyond very large in");
  r.status = TrimStatus::count;
  CHECK(explanation(r) == "bad input: configuration or options");
  CHECK(std::string(trim_status_word(TrimStatus::count)) == "unknown");
  r.status = static_cast<TrimStatus>(250);
  CHECK(explanation(r).empty());
}

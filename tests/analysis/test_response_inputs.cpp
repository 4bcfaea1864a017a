// Inputs whose edges are anywhere: the impulse over steps of any length is that of the formula, and a flight
// is that of steps fine enough to have every edge on a boundary.
// Expected: integrals in closed form, and fine steps.
#include <algorithm>
#include <random>
#include <vector>

#include "analysis_case.hpp"

using namespace analysis_case;

namespace {

SimulationWorkspace<double> work;

// Amplitude times time between 0 and `end`.
double impulse(const InputSignal<double>& s, double end) {
  const auto within = [end](double from, double to) {
    return std::max(0.0, std::min(end, to) - std::max(0.0, from));
  };
  if (s.shape == InputShape::step) return s.amplitude * within(s.start, end);
  const double half = s.start + s.duration;
  const double first = s.amplitude * within(s.start, half);
  return s.shape == InputShape::pulse ? first : first - s.amplitude * within(half, half + s.duration);
}

Simulation<double> simulation_of(double dt, const std::vector<InputSignal<double>>& inputs) {
  Simulation<double> s;
  static const Configuration<double> c = configuration(0);
  CHECK(start(c, State<double>{}, Controls<double>{}, dt, Integrator::rk4, s) == Status::ok);
  for (const InputSignal<double>& input : inputs) CHECK(add_input(s, input) == Status::ok);
  return s;
}

// As advance() does.
template <class Visit>
int visit_stretches(const Simulation<double>& s, Visit&& visit) {
  int stretches = 0;
  for (double since = 0; since < s.dt; ++stretches) {
    const double until = next_change(s, since);
    visit(until - since, controls_at(s, current_time(s) + 0.5 * (since + until)));
    since = until;
  }
  return stretches;
}

}  // namespace

TEST(response_inputs_have_their_impulse_whatever_the_step) {
  std::mt19937_64 random(3);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) / 9007199254740992.0;
  };
  for (int k = 0; k < 500; ++k) {
    std::vector<InputSignal<double>> inputs;
    for (int i = 0; i <= k % kMaxInputs; ++i)
      inputs.push_back({static_cast<InputShape>(random() % 3), kControlIndex.pedal, between(-2, 2),
                        between(-0.5, 1.5), std::pow(10, between(-9, 0))});
    Simulation<double> s = simulation_of(std::pow(10, between(-3, -0.3)), inputs);
    double found = 0, covered = 0, expected = 0;
    while (current_time(s) < 2) {
      const int stretches = visit_stretches(s, [&](double length, const Controls<double>& u) {
        found += length * u.pedal;
        covered += length;
      });
      CHECK_LE(stretches, kMaxStretches);
      ++s.steps;
    }
    for (const InputSignal<double>& input : inputs) expected += impulse(input, current_time(s));
    CHECK_NEAR(covered, current_time(s), 1e-12);
    CHECK_NEAR(found, expected, 1e-12);
  }
}

// Times written in decimals are those of the steps, however they were computed; then a step stays whole and
// its bits are those of a step without edges.
TEST(response_edges_on_step_times_do_not_cut_steps) {
  for (int per_second : {1000, 200, 100, 64, 30, 7}) {
    const double dt = 1.0 / per_second;
    for (int k = 1; k < 40 * per_second; k += 1 + k / 9) {
      const double decimal = static_cast<double>(k) / per_second;
      for (double from : {decimal, 0.1 + (decimal - 0.1), k * dt}) {
        const double to = static_cast<double>(3 * k) / per_second;
        for (InputShape shape : {InputShape::step, InputShape::pulse, InputShape::doublet}) {
          const double duration = shape == InputShape::doublet ? (to - from) / 2 : to - from;
          Simulation<double> s = simulation_of(dt, {{shape, kControlIndex.pedal, 1, from, duration}});
          for (int edge : {k, 2 * k, 3 * k}) {
            for (int step = edge - 1; step <= edge; ++step) {
              s.steps = static_cast<unsigned>(step);
              CHECK_EQ(next_change(s, 0.0), dt);
            }
          }
          s.steps = static_cast<unsigned>(k - 1);
          CHECK_EQ(current_controls(s).pedal, 0.0);
          s.steps = static_cast<unsigned>(k);
          CHECK_EQ(current_controls(s).pedal, 1.0);
        }
      }
    }
  }
}

// What acts now is what acts until the first edge inside the step.
TEST(response_current_controls_hold_to_the_next_edge) {
  Simulation<double> s = simulation_of(0.01, {{InputShape::pulse, kControlIndex.pedal, 1, 0.001, 0.002}});
  CHECK_EQ(current_controls(s).pedal, 0.0);
  std::vector<double> lengths, values;
  CHECK_EQ(visit_stretches(s,
                           [&](double length, const Controls<double>& u) {
                             lengths.push_back(length);
                             values.push_back(u.pedal);
                           }),
           3);
  const double expected[] = {0.001, 0.002, 0.007};
  for (std::size_t i = 0; i < lengths.size() && i < 3; ++i) CHECK_NEAR(lengths[i], expected[i], 1e-17);
  CHECK(values == (std::vector<double>{0, 1, 0}));
}

TEST(response_to_inputs_between_steps_is_that_of_fine_steps) {
  FlightSetup<double> setup = flight_setup(aircraft_data<double>(), 0.0);
  setup.options.grid = BladeGrid::realtime;
  Configuration<double> c;
  CHECK(prepare(aircraft_data<double>(), setup, c) == Status::ok);
  const TrimResult<double> r = trimmed(c, level(40));
  double base[state_count];
  flatten(r.state, base);
  using Inputs = std::vector<InputSignal<double>>;
  const auto flown = [&](Integrator integrator, double dt, const Inputs& inputs, double* x) {
    Simulation<double> s;
    CHECK(start(c, r.state, r.controls, dt, integrator, s) == Status::ok);
    for (const InputSignal<double>& input : inputs) CHECK(add_input(s, input) == Status::ok);
    for (int k = 0; k < std::lround(0.2 / dt); ++k) CHECK(advance(c, work, s) == Status::ok);
    flatten(s.state, x);
  };
  const double deg = kDeg;
  const Inputs cases[] = {
      {{InputShape::pulse, kControlIndex.collective, 5 * deg, 0.1005, 0.001}},   // between two steps
      {{InputShape::pulse, kControlIndex.collective, 5 * deg, 0.102, 0.001}},    // over the middle of a step
      {{InputShape::pulse, kControlIndex.collective, 5 * deg, 0.0995, 0.001}},   // across a boundary
      {{InputShape::step, kControlIndex.collective, deg, 0.1035, 0}},            // from inside a step on
      {{InputShape::doublet, kControlIndex.collective, 5 * deg, 0.101, 0.001}},  // inside one step
      {{InputShape::doublet, kControlIndex.lat_stick, 1, 0.0985, 0.003}},        // over two
      {{InputShape::pulse, kControlIndex.gust.z, 5, 0.1005, 0.0115},
       {InputShape::step, kControlIndex.pedal, 1, 0.1015, 0},
       {InputShape::pulse, kControlIndex.long_stick, -1, 0.1005, 0.001},
       {InputShape::doublet, kControlIndex.lat_stick, 1, -0.001, 0.002}},
  };
  for (const Inputs& inputs : cases) {
    double fine[state_count], found[state_count];
    flown(Integrator::rk4, 0.0005, inputs, fine);  // every edge on a boundary
    for (Integrator integrator : {Integrator::rk3, Integrator::rk4, Integrator::rodas3}) {
      for (double dt : {0.005, 0.01}) {
        flown(integrator, dt, inputs, found);
        double response = 0, worst = 0;
        for (int i = kStateIndex.velocity.x; i <= kStateIndex.rates.z; ++i) {
          response = std::max(response, std::abs(fine[i] - base[i]));
          worst = std::max(worst, std::abs(found[i] - fine[i]));
        }
        CHECK_LT(1e-5, response);
        CHECK_LT(worst, (integrator == Integrator::rodas3 ? 0.05 : 0.01) * response);
        if (&inputs == &cases[0]) NOTE(dt << ": " << worst / response);
      }
    }
  }
}

// 2.5 steps: the last one is shorter, and inputs go on at their times.
TEST(response_ends_between_steps) {
  const Configuration<double> c = configuration(0);
  const TrimResult<double> r = trimmed(c, level(40));
  const auto flown = [&](double dt, int whole, double rest) {
    Simulation<double> s;
    CHECK(start(c, r.state, r.controls, dt, Integrator::rk4, s) == Status::ok);
    CHECK(add_input(s, {InputShape::pulse, kControlIndex.collective, kDeg, 0.0075, 0.004}) == Status::ok);
    for (int k = 0; k < whole; ++k) CHECK(advance(c, work, s) == Status::ok);
    if (rest > 0) {
      CHECK(change_step(s, rest) == Status::ok);
      CHECK_NEAR(current_time(s), whole * dt, 1e-15);
      CHECK(advance(c, work, s) == Status::ok);
    }
    return s;
  };
  const Simulation<double> s = flown(0.005, 2, 0.0025);
  CHECK_EQ(current_time(s), 0.0125);
  double found[state_count], fine[state_count];
  flatten(s.state, found);
  flatten(flown(0.0005, 25, 0).state, fine);
  for (int i = kStateIndex.velocity.x; i <= kStateIndex.rates.z; ++i) CHECK_NEAR(found[i], fine[i], 1e-6);
  Simulation<double> refused = s;
  for (double dt : {0.0, -0.01, 1.001, std::nan("")}) CHECK(change_step(refused, dt) == Status::out_of_range);
  CHECK_EQ(refused.dt, s.dt);
  CHECK_EQ(current_time(refused), current_time(s));
}

// C and D, and rates and outputs along a direction.
// Expected: central differences of tr_get_outputs and tr_derivative; complex steps of the formulas; A and B.
#include <algorithm>
#include <cmath>
#include <complex>
#include <random>

#include "capi/flying.hpp"
#include "tiltrotor/analysis/linear/output_model.hpp"
#include "tiltrotor/math/differentiation/complex_step.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/model/preparation.hpp"

using namespace capi;

namespace {

constexpr bool kDouble = sizeof(tr_real) == 8;
constexpr std::size_t kOutputs = TR_OUTPUTS;
using Numbers = std::vector<tr_real>;

Numbers numbers_of(const tr_outputs& o) {
  const tr_real* first = &o.airspeed_mps;
  return {first, first + kOutputs};
}

tr_sim disturbed(tr_real mast_deg) {
  tr_sim sim = trimmed_sim(mast_deg, mast_deg < 90 ? tr_real(40) : tr_real(100));
  tr_state s = state_of(sim);
  s.x[TR_V] = 3;
  s.x[TR_Q] = tr_real(0.1);
  s.x[TR_R] = tr_real(-0.15);
  s.x[TR_ROLL] = s.roll_rad = tr_real(0.3);
  s.x[TR_YAW] = s.yaw_rad = tr_real(1.1);
  s.u[TR_GUST_U] = 4;
  s.u[TR_LAT_STICK] = tr_real(0.7);
  CHECK_EQ(tr_set_state(&sim, &s), TR_OK);
  return sim;
}

struct Model {
  tr_linear_shape shape;
  Numbers a, b, c, d;
  std::size_t states() const { return static_cast<std::size_t>(shape.states); }
  std::size_t controls() const { return static_cast<std::size_t>(shape.controls); }
};
Model model_of(const tr_sim& sim, std::int32_t columns) {
  const auto work = new_work();
  Model m;
  CHECK_EQ(tr_linearize(&sim, work.get(), columns, &m.shape, nullptr, 0, nullptr, 0), TR_SHORT_BUFFER);
  const std::size_t n = m.states(), k = m.controls();
  m.a.resize(n * n), m.b.resize(n * k), m.c.resize(kOutputs * n), m.d.resize(kOutputs * k);
  CHECK_EQ(tr_linearize(&sim, work.get(), columns, &m.shape, m.a.data(), m.a.size(), m.b.data(), m.b.size()),
           TR_OK);
  CHECK_EQ(tr_linearize_outputs(&sim, work.get(), columns, m.c.data(), m.c.size(), m.d.data(), m.d.size()),
           TR_OK);
  return m;
}

struct Way {
  Numbers dx = Numbers(TR_STATES), du = Numbers(TR_CONTROLS);
};
struct Change {
  Numbers dxdot = Numbers(TR_STATES, kNan), outputs;
};
Change along(const tr_sim& sim, const Way& way) {
  const auto work = new_work();
  Change change;
  tr_outputs o;
  CHECK_EQ(tr_directional(&sim, work.get(), way.dx.data(), way.du.data(), change.dxdot.data(), &o), TR_OK);
  CHECK_EQ(o.time_s, 0);
  change.outputs = numbers_of(o);
  return change;
}

// By central differences through the interface.
Change differences(const tr_sim& sim, const Way& way, double h) {
  const tr_state here = state_of(sim);
  Numbers rates[2] = {Numbers(TR_STATES), Numbers(TR_STATES)};
  tr_outputs outputs[2];
  for (int side = 0; side < 2; ++side) {
    tr_state s = here;
    const double step = side == 0 ? -h : h;
    for (std::size_t i = 0; i < TR_STATES; ++i) s.x[i] += tr_real(step * double(way.dx[i]));
    for (std::size_t j = 0; j < TR_CONTROLS; ++j) s.u[j] += tr_real(step * double(way.du[j]));
    tr_sim moved = sim;
    CHECK_EQ(tr_set_state(&moved, &s), TR_OK);
    CHECK_EQ(tr_derivative(&moved, rates[side].data(), TR_STATES), TR_OK);
    CHECK_EQ(tr_get_outputs(&moved, &outputs[side]), TR_OK);
  }
  Change change;
  const Numbers low = numbers_of(outputs[0]), high = numbers_of(outputs[1]);
  for (std::size_t i = 0; i < TR_STATES; ++i)
    change.dxdot[i] = tr_real((double(rates[1][i]) - double(rates[0][i])) / (2 * h));
  for (std::size_t i = 0; i < kOutputs; ++i)
    change.outputs.push_back(tr_real((double(high[i]) - double(low[i])) / (2 * h)));
  return change;
}

// How far two columns lie apart, over the largest of each row's own kind.
double apart(const Numbers& a, const Numbers& b, double least) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    worst = std::max(worst, std::abs(double(a[i]) - double(b[i])) / std::max(least, std::abs(double(b[i]))));
  return worst;
}

Way random_way(std::mt19937& random) {
  const auto between = [&random](double size) {
    return tr_real(size * (2.0 * double(random()) / 4294967295.0 - 1));
  };
  Way way;
  for (std::size_t i = 0; i < TR_MAST; ++i) way.dx[i] = between(i < TR_P || i >= TR_NORTH ? 1 : 0.05);
  for (std::size_t j = 0; j < TR_CONTROLS; ++j) way.du[j] = between(j >= TR_GUST_U ? 1 : 0.05);
  return way;
}

}  // namespace

TEST(capi_outputs_of_the_linear_model_equal_differences) {
  double worst = 0;
  for (const tr_real mast : {tr_real(0), tr_real(30), tr_real(90)}) {
    const tr_sim sim = disturbed(mast);
    const Model m = model_of(sim, TR_ALL_CONTROLS);
    for (std::size_t j = 0; j < m.states() + m.controls(); ++j) {
      Way way;
      const bool state = j < m.states();
      const std::size_t place = state ? j : j - m.states();
      (state ? way.dx[std::size_t(m.shape.state[place])] : way.du[std::size_t(m.shape.control[place])]) = 1;
      Numbers column(kOutputs);
      for (std::size_t i = 0; i < kOutputs; ++i)
        column[i] = state ? m.c[i * m.states() + place] : m.d[i * m.controls() + place];
      const double error = apart(column, differences(sim, way, kDouble ? 1e-6 : 1e-3).outputs, 10);
      worst = std::max(worst, error);
      if (!CHECK_LE(error, kDouble ? 2e-5 : 0.1)) NOTE("mast " << mast << ", column " << j);
    }
  }
  NOTE("largest difference " << worst);
}

// Every column of every choice is one direction.
TEST(capi_direction_along_one_variable_is_its_column) {
  const tr_sim sim = disturbed(30);
  for (const std::int32_t columns : {TR_INCEPTORS, TR_BLADE_CONTROLS, TR_ALL_CONTROLS}) {
    const Model m = model_of(sim, columns);
    for (std::size_t j = 0; j < m.states() + m.controls(); ++j) {
      Way way;
      const bool state = j < m.states();
      const std::size_t place = state ? j : j - m.states();
      (state ? way.dx[std::size_t(m.shape.state[place])] : way.du[std::size_t(m.shape.control[place])]) = 1;
      const Change found = along(sim, way);
      bool same = true;
      for (std::size_t i = 0; i < m.states(); ++i) {
        const tr_real slope = state ? m.a[i * m.states() + place] : m.b[i * m.controls() + place];
        same &= std::abs(double(found.dxdot[std::size_t(m.shape.state[i])]) - double(slope)) <=
                (kDouble ? 1e-12 : 1e-4) * (1 + std::abs(double(slope)));
      }
      for (std::size_t i = 0; i < kOutputs; ++i) {
        const tr_real slope = state ? m.c[i * m.states() + place] : m.d[i * m.controls() + place];
        same &= std::abs(double(found.outputs[i]) - double(slope)) <=
                (kDouble ? 1e-12 : 1e-4) * (1 + std::abs(double(slope)));
      }
      if (!CHECK(same)) NOTE("columns " << columns << ", column " << j);
    }
  }
}

TEST(capi_directions_equal_differences) {
  std::mt19937 random(20261126);
  NOTE("seed 20261126");
  double worst = 0;
  for (const tr_real mast : {tr_real(0), tr_real(30), tr_real(90)}) {
    const tr_sim sim = disturbed(mast);
    for (int k = 0; k < 20; ++k) {
      const Way way = random_way(random);
      const Change found = along(sim, way), expected = differences(sim, way, kDouble ? 1e-6 : 1e-3);
      worst = std::max(
          {worst, apart(found.dxdot, expected.dxdot, 10), apart(found.outputs, expected.outputs, 10)});
    }
  }
  NOTE("largest difference " << worst);
  CHECK_LE(worst, kDouble ? 1e-6 : 0.1);
}

#ifndef TR_SINGLE_PRECISION
// Complex steps share no arithmetic with dual numbers: to rounding, over every reading and rate.
TEST(capi_directions_equal_complex_steps) {
  using namespace tiltrotor;
  using Complex = std::complex<double>;
  std::mt19937 random(20261127);
  NOTE("seed 20261127");
  double worst = 0;
  for (const double mast : {0.0, 30.0, 90.0}) {
    const tr_sim sim = disturbed(mast);
    const tr_state s = state_of(sim);
    FlightSetup<double> setup = flight_setup(aircraft_data<double>(), mast);
    setup.options.grid = BladeGrid::realtime;
    setup.options.position_states = true;
    const auto c = std::make_unique<Configuration<double>>();
    CHECK(prepare(aircraft_data<double>(), setup, *c) == Status::ok);
    for (int k = 0; k < 10; ++k) {
      const Way way = random_way(random);
      Complex x[state_count], u[control_count];
      const double step = 1e-30;
      for (int i = 0; i < state_count; ++i) x[i] = Complex(s.x[i], step * way.dx[std::size_t(i)]);
      for (int j = 0; j < control_count; ++j) u[j] = Complex(s.u[j], step * way.du[std::size_t(j)]);
      State<Complex> state, rates;
      Controls<Complex> controls;
      unflatten(x, state);
      unflatten(u, controls);
      const auto steps = std::make_unique<DerivativeSteps<Complex>>();
      derivative(*c, state, controls, *steps, rates);
      Instruments<Complex> read;
      read_instruments(*c, state, *steps, rates, read);
      Complex rate[state_count], reading[kOutputs];
      flatten(rates, rate);
      flatten(read, reading);
      Change expected;
      for (std::size_t i = 0; i < TR_MAST; ++i) expected.dxdot[i] = rate[i].imag() / step;
      for (const Complex& r : reading) expected.outputs.push_back(r.imag() / step);
      const Change found = along(sim, way);
      worst =
          std::max({worst, apart(found.dxdot, expected.dxdot, 1), apart(found.outputs, expected.outputs, 1)});
    }
  }
  NOTE("largest relative difference " << worst);
  CHECK_LE(worst, 1e-11);
}
#endif

// In hover airspeed has no direction: its derivative is none instead of none at all.
TEST(capi_outputs_have_derivatives_at_rest) {
  const tr_sim hover = trimmed_sim(0, 0);
  const Model m = model_of(hover, TR_INCEPTORS);
  for (std::size_t j = 0; j < m.states(); ++j)
    for (std::size_t i = 0; i < 3; ++i)
      if (state_of(hover).x[TR_U] == 0) CHECK_EQ(m.c[i * m.states() + j], 0);
  const tr_sim rest = sim_at(30);  // gimbals are not tilted, and rotors do not lift
  Way way;
  way.dx[TR_U] = 1, way.dx[TR_ROTOR_RIGHT + TR_B1C] = 1;
  const Change found = along(rest, way);
  for (const tr_real number : found.outputs) CHECK(std::isfinite(number));
}

TEST(capi_output_model_refuses) {
  const tr_sim sim = trimmed_sim(0, 20);
  const auto work = new_work();
  Numbers c(kOutputs * max_states, 7), d(kOutputs * TR_CONTROLS, 7);
  const auto linearize = [&](std::int32_t columns, tr_real* to_c, std::size_t c_length, tr_real* to_d,
                             std::size_t d_length) {
    return tr_linearize_outputs(&sim, work.get(), columns, to_c, c_length, to_d, d_length);
  };
  const std::size_t n = 23, m = 4;  // without coning; inceptors
  CHECK_EQ(linearize(TR_INCEPTORS, c.data(), kOutputs * n - 1, d.data(), d.size()), TR_SHORT_BUFFER);
  CHECK_EQ(linearize(TR_INCEPTORS, c.data(), c.size(), d.data(), kOutputs * m - 1), TR_SHORT_BUFFER);
  CHECK_EQ(linearize(TR_INCEPTORS, nullptr, c.size(), d.data(), d.size()), TR_BAD_ARGUMENT);
  CHECK_EQ(linearize(TR_INCEPTORS, c.data(), c.size(), nullptr, d.size()), TR_BAD_ARGUMENT);
  CHECK_EQ(linearize(0, c.data(), c.size(), d.data(), d.size()), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_linearize_outputs(nullptr, work.get(), 1, c.data(), c.size(), nullptr, 0), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_linearize_outputs(&sim, nullptr, 1, c.data(), c.size(), nullptr, 0), TR_BAD_ARGUMENT);
  Way way;
  Change change;
  tr_outputs o;
  std::memset(&o, 0x5a, sizeof o);
  const tr_outputs before = o;
  const auto directional = [&](const tr_sim* s, tr_work* w, const tr_real* dx, const tr_real* du,
                               tr_real* dxdot,
                               tr_outputs* outputs) { return tr_directional(s, w, dx, du, dxdot, outputs); };
  const tr_real *dx = way.dx.data(), *du = way.du.data();
  tr_real* const to = change.dxdot.data();
  CHECK_EQ(directional(nullptr, work.get(), dx, du, to, &o), TR_BAD_ARGUMENT);
  CHECK_EQ(directional(&sim, nullptr, dx, du, to, &o), TR_BAD_ARGUMENT);
  CHECK_EQ(directional(&sim, work.get(), nullptr, du, to, &o), TR_BAD_ARGUMENT);
  CHECK_EQ(directional(&sim, work.get(), dx, nullptr, to, &o), TR_BAD_ARGUMENT);
  CHECK_EQ(directional(&sim, work.get(), dx, du, nullptr, &o), TR_BAD_ARGUMENT);
  CHECK_EQ(directional(&sim, work.get(), dx, du, to, nullptr), TR_BAD_ARGUMENT);
  for (std::size_t i = 0; i < TR_STATES; ++i) {
    Way bad;
    bad.dx[i] = i % 2 ? kNan : kInfinity;
    CHECK_EQ(directional(&sim, work.get(), bad.dx.data(), du, to, &o), TR_NOT_FINITE);
  }
  for (std::size_t j = 0; j < TR_CONTROLS; ++j) {
    Way bad;
    bad.du[j] = j % 2 ? kNan : kInfinity;
    CHECK_EQ(directional(&sim, work.get(), dx, bad.du.data(), to, &o), TR_NOT_FINITE);
  }
  tr_sim raw;
  std::memset(&raw, 0, sizeof raw);
  CHECK_EQ(directional(&raw, work.get(), dx, du, to, &o), TR_NOT_INITIALIZED);
  CHECK_EQ(tr_linearize_outputs(&raw, work.get(), 1, c.data(), c.size(), nullptr, 0), TR_NOT_INITIALIZED);
  CHECK(c == Numbers(c.size(), 7) && d == Numbers(d.size(), 7));
  CHECK(same_bits(o, before) && std::isnan(change.dxdot[0]));
  // C alone, and along no direction: nothing.
  CHECK_EQ(linearize(TR_INCEPTORS, c.data(), kOutputs * n, nullptr, 0), TR_OK);
  const Change none = along(sim, way);
  CHECK(none.dxdot == Numbers(TR_STATES) && none.outputs == Numbers(kOutputs));
}

// Derivatives of the aircraft with its systems along directions, and of its outputs. Expected values: A and B of
// tr_linearize, which come by another way (the expansion of the airframe), and central differences of what the outputs
// read.
#include <algorithm>
#include <random>

#include "capi/conditions.hpp"

using namespace capi;

namespace {

constexpr bool kDouble = sizeof(tr_real) == 8;
constexpr std::size_t kOutputs = TR_OUTPUTS;
using Numbers = std::vector<tr_real>;

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) / 4294967296.0;
  }
  std::int32_t flip() { return random_() % 2 == 0 ? 1 : 0; }

 private:
  std::mt19937 random_;
};

// Under way, not trimmed: each system on or off, masts and flaps between the knots of their tables.
tr_sim under_way(Dice& dice, int governor, bool everything) {
  tr_sim sim = sim_at(37);
  const auto work = new_work();
  tr_systems systems;
  CHECK_EQ(tr_get_systems(&sim, &systems), TR_OK);
  std::int32_t* const on[] = {&systems.conversion, &systems.engines, &systems.actuators,
                              &systems.scas,       &systems.gear,    &systems.ground_effect};
  for (std::int32_t* const one : on) *one = everything ? 1 : dice.flip();
  if (governor == TR_GOVERNOR_OFF && !everything) systems.conversion = 1;  // something is on
  systems.governor = governor;
  tr_environment environment = calm();
  environment.altitude_origin_m = 500;
  environment.ground_down_m = 5;
  environment.wind_mps[0] = 2;
  CHECK_EQ(tr_set_environment(&sim, &environment), TR_OK);
  CHECK_EQ(tr_set_systems(&sim, &systems), TR_OK);
  const tr_flight flight = {50, 0, 0, 0};
  CHECK_EQ(tr_trim(&sim, work.get(), &flight, nullptr), TR_OK);
  tr_configuration configuration = configuration_of(sim);
  configuration.flap_deg = 27;
  CHECK_EQ(tr_set_configuration(&sim, &configuration), TR_OK);
  tr_state s = state_of(sim);
  s.x[TR_V] = 1;
  s.x[TR_P] = tr_real(0.05);
  s.x[TR_Q] = tr_real(-0.03);
  s.x[TR_ROLL] = s.roll_rad = tr_real(0.1);
  s.x[TR_YAW] = s.yaw_rad = tr_real(0.4);
  s.u[TR_LAT_STICK] += tr_real(0.1);
  s.u[TR_GUST_V] = 1;
  CHECK_EQ(tr_set_state(&sim, &s), TR_OK);
  return sim;
}

struct Model {
  tr_linear_shape shape;
  std::size_t n, m;
  Numbers a, b, c, d;
};
Model model_of(const tr_sim& sim, std::int32_t columns) {
  const auto work = new_work();
  Model k;
  CHECK_EQ(tr_linearize(&sim, work.get(), columns, &k.shape, nullptr, 0, nullptr, 0), TR_SHORT_BUFFER);
  k.n = static_cast<std::size_t>(k.shape.states), k.m = static_cast<std::size_t>(k.shape.controls);
  k.a.resize(k.n * k.n), k.b.resize(k.n * k.m), k.c.resize(kOutputs * k.n), k.d.resize(kOutputs * k.m);
  CHECK_EQ(tr_linearize(&sim, work.get(), columns, &k.shape, k.a.data(), k.a.size(), k.b.data(), k.b.size()),
           TR_OK);
  CHECK_EQ(tr_linearize_outputs(&sim, work.get(), columns, k.c.data(), k.c.size(), k.d.data(), k.d.size()),
           TR_OK);
  return k;
}

struct Change {
  Numbers dxdot = Numbers(TR_STATES), outputs = Numbers(kOutputs);
};
Change along(const tr_sim& sim, const Numbers& dx, const Numbers& du) {
  const auto work = new_work();
  Change change;
  tr_outputs o;
  CHECK_EQ(tr_directional_inputs(&sim, work.get(), dx.data(), du.data(), change.dxdot.data(), &o), TR_OK);
  CHECK_EQ(o.time_s, 0);
  std::memcpy(change.outputs.data(), &o.airspeed_mps, kOutputs * sizeof(tr_real));
  return change;
}

// By central differences of the outputs; steps of `dx` and `du` are small already.
Numbers differences(const tr_sim& sim, const Numbers& dx, const Numbers& du) {
  Numbers side[2] = {Numbers(kOutputs), Numbers(kOutputs)};
  for (const int k : {0, 1}) {
    const double way = k == 0 ? -1 : 1;
    tr_sim moved = sim;
    tr_systems y;
    CHECK_EQ(tr_get_systems(&moved, &y), TR_OK);
    tr_real* const command[] = {&y.mast_command_deg, &y.flap_command_deg, &y.rotor_command_radps,
                                &y.throttle[0], &y.throttle[1]};
    for (std::size_t j = TR_CONTROLS; j < TR_INPUTS; ++j)
      *command[j - TR_CONTROLS] += tr_real(way * double(du[j]) * (j < TR_CONTROLS + 2 ? 1 / kDegree : 1));
    CHECK_EQ(tr_set_systems(&moved, &y), TR_OK);
    tr_state s = state_of(moved);
    for (std::size_t i = 0; i < TR_STATES; ++i) s.x[i] += tr_real(way * double(dx[i]));
    for (std::size_t j = 0; j < TR_CONTROLS; ++j) s.u[j] += tr_real(way * double(du[j]));
    s.roll_rad = s.x[TR_ROLL];
    s.yaw_rad = s.x[TR_YAW];
    CHECK_EQ(tr_set_state(&moved, &s), TR_OK);
    tr_outputs o;
    CHECK_EQ(tr_get_outputs(&moved, &o), TR_OK);
    std::memcpy(side[k].data(), &o.airspeed_mps, kOutputs * sizeof(tr_real));
  }
  for (std::size_t i = 0; i < kOutputs; ++i) side[1][i] = (side[1][i] - side[0][i]) / 2;
  return side[1];
}

double usual_step(int state) { return state == TR_POWER_RIGHT || state == TR_POWER_LEFT ? 1e4 : 1; }

}  // namespace

// Every governor, every system on, and any of them: a direction is A dx + B du, its outputs C dx + D du.
TEST(capi_directions_with_systems_are_those_of_the_linear_model) {
  NOTE("seed 11");
  Dice dice(11);
  double worst = 0, worst_outputs = 0;
  for (int k = 0; k < 15; ++k) {
    const tr_sim sim = under_way(dice, k % 3, k < 3);
    const Model m = model_of(sim, TR_ALL_INPUTS);
    Numbers dx(TR_STATES), du(TR_INPUTS);
    for (std::size_t i = 0; i < m.n; ++i)
      dx[std::size_t(m.shape.state[i])] = tr_real(dice.between(-0.1, 0.1) * usual_step(m.shape.state[i]));
    for (tr_real& u : du) u = tr_real(dice.between(-0.1, 0.1));
    const Change found = along(sim, dx, du);
    const auto compare = [&](const Numbers& of_x, const Numbers& of_u, std::size_t row, double is,
                             double& most) {
      double expected = 0, size = 0.1;
      for (std::size_t j = 0; j < m.n + m.m; ++j) {
        const double term = j < m.n ? double(of_x[row * m.n + j]) * double(dx[std::size_t(m.shape.state[j])])
                                    : double(of_u[row * m.m + j - m.n]) * double(du[j - m.n]);
        expected += term;
        size += std::abs(term);
      }
      most = std::max(most, std::abs(is - expected) / size);
    };
    for (std::size_t i = 0; i < m.n; ++i)
      compare(m.a, m.b, i, double(found.dxdot[std::size_t(m.shape.state[i])]), worst);
    for (std::size_t i = 0; i < kOutputs; ++i) compare(m.c, m.d, i, double(found.outputs[i]), worst_outputs);
  }
  NOTE("A and B: " << worst << ", C and D: " << worst_outputs << " of the terms");
  CHECK_LE(worst, kDouble ? 1e-11 : 1e-3);
  CHECK_LE(worst_outputs, kDouble ? 1e-11 : 1e-3);
}

TEST(capi_outputs_with_systems_equal_differences) {
  if (!kDouble) {
    NOTE("differences in single precision say nothing");
    return;
  }
  NOTE("seed 12");
  Dice dice(12);
  double worst = 0;
  for (int k = 0; k < 6; ++k) {
    const tr_sim sim = under_way(dice, k % 3, k < 3);
    const Model m = model_of(sim, TR_ALL_INPUTS);
    for (std::size_t j = 0; j < m.n + m.m; ++j) {
      const bool state = j < m.n;
      const auto place = std::size_t(state ? m.shape.state[j] : m.shape.control[j - m.n]);
      const double step = 1e-5 * (state ? usual_step(int(place)) : 1);
      Numbers dx(TR_STATES), du(TR_INPUTS);
      (state ? dx : du)[place] = tr_real(step);
      const Numbers by = differences(sim, dx, du);
      double size = 1;
      for (std::size_t i = 0; i < kOutputs; ++i) size = std::max(size, std::abs(double(by[i])) / step);
      for (std::size_t i = 0; i < kOutputs; ++i) {
        const double slope = double(state ? m.c[i * m.n + j] : m.d[i * m.m + j - m.n]);
        const double error = std::abs(slope - double(by[i]) / step) / std::max(1e-3 * size, std::abs(slope));
        if (error > 1e-4)
          NOTE((state ? tr_state_name(int(place)) : tr_control_name(int(place)))
               << ", output " << i << ": " << slope << " not " << double(by[i]) / step << ", flight " << k);
        worst = std::max(worst, error);
      }
    }
  }
  NOTE("largest difference " << worst);
  CHECK_LE(worst, 1e-4);
}

// Those that no linear model has, too: burnt fuel makes lighter, heading turns the wind over the ground, a held attitude
// is what the augmentation compares with.
TEST(capi_directions_know_every_state) {
  if (!kDouble) return;
  Dice dice(13);
  const tr_sim sim = under_way(dice, TR_GOVERNOR_PI, true);
  for (const int place : {int{TR_FUEL}, int{TR_YAW}, int{TR_NORTH}, int{TR_DOWN}, int{TR_HELD_PITCH}}) {
    const double step = 1e-3;
    Numbers dx(TR_STATES), du(TR_INPUTS);
    dx[std::size_t(place)] = 1;
    const Change found = along(sim, dx, du);
    Numbers side[2] = {Numbers(TR_STATES), Numbers(TR_STATES)};
    for (const int k : {0, 1}) {
      tr_sim moved = sim;
      tr_state s = state_of(moved);
      s.x[place] += tr_real(k == 0 ? -step : step);
      s.yaw_rad = s.x[TR_YAW];
      CHECK_EQ(tr_set_state(&moved, &s), TR_OK);
      CHECK_EQ(tr_derivative(&moved, side[k].data(), TR_STATES), TR_OK);
    }
    for (std::size_t i = 0; i < TR_STATES; ++i) {
      const double slope = (double(side[1][i]) - double(side[0][i])) / (2 * step);
      if (!CHECK_NEAR(double(found.dxdot[i]), slope, 1e-5 * (1 + std::abs(slope))))
        NOTE(tr_state_name(place) << " on " << tr_state_name(int(i)));
    }
  }
}

// Commands alone lead to other columns than the controls do; without commands both calls are one.
TEST(capi_directional_takes_controls_and_its_sibling_commands_too) {
  Dice dice(14);
  for (const bool systems : {false, true}) {
    const tr_sim sim = systems ? under_way(dice, TR_GOVERNOR_PI, true) : trimmed_sim(30, 50);
    const auto work = new_work();
    Numbers dx(TR_STATES), du(TR_INPUTS);
    dx[TR_U] = 1;
    du[TR_LAT_STICK] = 1;
    const Change with = along(sim, dx, du);
    Change without;
    tr_outputs o;
    CHECK_EQ(tr_directional(&sim, work.get(), dx.data(), du.data(), without.dxdot.data(), &o), TR_OK);
    CHECK(with.dxdot == without.dxdot);
    CHECK(std::memcmp(&o.airspeed_mps, with.outputs.data(), kOutputs * sizeof(tr_real)) == 0);
    Numbers none(TR_STATES), throttle(TR_INPUTS);
    throttle[TR_CONTROLS + 3] = 1;
    CHECK_EQ(along(sim, none, throttle).dxdot[TR_POWER_RIGHT] > 0, systems);
  }
}

TEST(capi_output_model_with_systems_refuses) {
  Dice dice(15);
  const tr_sim sim = under_way(dice, TR_GOVERNOR_PI, true);
  const auto work = new_work();
  tr_linear_shape shape;
  CHECK_EQ(tr_linearize(&sim, work.get(), TR_ALL_INPUTS, &shape, nullptr, 0, nullptr, 0), TR_SHORT_BUFFER);
  const auto n = std::size_t(shape.states), m = std::size_t(shape.controls);
  Numbers c(kOutputs * n, 7), d(kOutputs * m, 7);
  const auto outputs = [&](std::int32_t columns, tr_real* to_c, std::size_t c_length, tr_real* to_d,
                           std::size_t d_length) {
    return tr_linearize_outputs(&sim, work.get(), columns, to_c, c_length, to_d, d_length);
  };
  CHECK_EQ(outputs(TR_ALL_INPUTS, c.data(), c.size() - 1, nullptr, 0), TR_SHORT_BUFFER);
  CHECK_EQ(outputs(TR_ALL_INPUTS, c.data(), c.size(), d.data(), d.size() - 1), TR_SHORT_BUFFER);
  CHECK_EQ(outputs(TR_ALL_INPUTS, nullptr, c.size(), d.data(), d.size()), TR_BAD_ARGUMENT);
  CHECK_EQ(outputs(TR_ALL_INPUTS, c.data(), c.size(), nullptr, d.size()), TR_BAD_ARGUMENT);
  CHECK_EQ(outputs(0, c.data(), c.size(), d.data(), d.size()), TR_BAD_ARGUMENT);
  CHECK_EQ(outputs(5, c.data(), c.size(), d.data(), d.size()), TR_BAD_ARGUMENT);
  Numbers dx(TR_STATES), du(TR_INPUTS), rates(TR_STATES, 7);
  du[TR_INPUTS - 1] = kNan;
  tr_outputs o;
  CHECK_EQ(tr_directional_inputs(&sim, work.get(), dx.data(), du.data(), rates.data(), &o), TR_NOT_FINITE);
  CHECK(c == Numbers(c.size(), 7) && d == Numbers(d.size(), 7) && rates == Numbers(TR_STATES, 7));
  CHECK_EQ(tr_directional_inputs(&sim, work.get(), dx.data(), nullptr, rates.data(), &o), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_directional_inputs(nullptr, work.get(), dx.data(), du.data(), rates.data(), &o),
           TR_BAD_ARGUMENT);
  // C alone.
  CHECK_EQ(outputs(TR_ALL_INPUTS, c.data(), c.size(), nullptr, 0), TR_OK);
  // Where an ideal governor finds no collective nothing is written.
  tr_sim blocked = under_way(dice, TR_GOVERNOR_IDEAL, true);
  tr_state s = state_of(blocked);
  s.x[TR_POWER_RIGHT] = s.x[TR_POWER_LEFT] = 0;
  s.x[TR_U] = s.x[TR_W] = 0;
  CHECK_EQ(tr_set_state(&blocked, &s), TR_OK);
  du[TR_INPUTS - 1] = 0;
  rates.assign(TR_STATES, 7);
  const tr_status status =
      tr_directional_inputs(&blocked, work.get(), dx.data(), du.data(), rates.data(), &o);
  CHECK_EQ(status, TR_NOT_CONVERGED);
  CHECK(rates == Numbers(TR_STATES, 7));
}

// With the commands' columns where nothing follows them: zero.
TEST(capi_output_model_without_systems_knows_every_input) {
  const Model all = model_of(trimmed_sim(30, 50), TR_ALL_INPUTS);
  const Model controls = model_of(trimmed_sim(30, 50), TR_ALL_CONTROLS);
  CHECK(all.c == controls.c);
  for (std::size_t i = 0; i < kOutputs; ++i)
    for (std::size_t j = 0; j < all.m; ++j)
      CHECK_EQ(all.d[i * all.m + j], j < controls.m ? controls.d[i * controls.m + j] : 0);
}

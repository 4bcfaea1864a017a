// Systems through the C interface. Expected values: the flight without them, differences along flights, the same
// aircraft saved and loaded, closed forms named in the test.
#include <algorithm>
#include <string>

#include "capi/conditions.hpp"

using namespace capi;

namespace {

tr_systems everything(tr_systems systems, int governor = TR_GOVERNOR_PI) {
  systems.governor = governor;
  systems.conversion = systems.engines = systems.actuators = systems.scas = 1;
  return systems;
}

// With everything on, in steady flight.
tr_sim equipped(tr_real mast_deg, tr_real speed, int governor = TR_GOVERNOR_PI) {
  tr_sim sim = sim_at(mast_deg);
  set_systems(sim, everything(systems_of(sim), governor));
  const auto work = new_work();
  const tr_flight flight = {speed, 0, 0, 0};
  CHECK_EQ(tr_trim(&sim, work.get(), &flight, nullptr), TR_OK);
  return sim;
}

double rate_of(const tr_sim& sim, int state) { return rates_of(sim)[static_cast<std::size_t>(state)]; }

}  // namespace

TEST(capi_systems_off_are_not_there) {
  tr_sim plain = trimmed_sim(30, 50);
  tr_sim sim = plain;
  tr_systems systems = systems_of(sim);
  CHECK_EQ(systems.governor, int{TR_GOVERNOR_OFF});
  CHECK_NEAR(systems.mast_command_deg, 30, 1e-5);
  CHECK_EQ(systems.gear_down, 1);
  // On and off again leaves nothing.
  set_systems(sim, everything(systems));
  set_systems(sim, systems);
  const auto work = new_work();
  tr_state state = state_of(sim);
  for (int i = TR_MAST; i < TR_STATES; ++i) CHECK_EQ(state.x[i], 0);
  for (int k = 0; k < 20; ++k) {
    CHECK_EQ(tr_step(&plain, work.get(), dt), TR_OK);
    CHECK_EQ(tr_step(&sim, work.get(), dt), TR_OK);
  }
  const tr_state a = state_of(plain), b = state_of(sim);
  CHECK(same_bits(a, b));
  // A state of a system that is off is not read.
  state.x[TR_ROTOR_SPEED] = 50;
  set_state(sim, state);
  CHECK_EQ(state_of(sim).x[TR_ROTOR_SPEED], 0);
}

// Every rate of a trimmed aircraft is zero but for the way and the fuel.
TEST(capi_systems_stand_still_in_a_trim) {
  for (const int governor : {int{TR_GOVERNOR_OFF}, int{TR_GOVERNOR_IDEAL}, int{TR_GOVERNOR_PI}}) {
    tr_sim sim = equipped(60, 70, governor);
    const std::vector<double> rates = rates_of(sim);
    for (int i = 0; i < TR_STATES; ++i) {
      if (i == TR_NORTH || i == TR_FUEL) continue;
      // The smooth limits of power leave 1 W/s or so (choices.csv).
      const double tolerance = i == TR_POWER_RIGHT || i == TR_POWER_LEFT ? 5
                               : sizeof(tr_real) == 8                    ? 2e-5
                                                                         : 2e-2;
      CHECK_NEAR(rates[static_cast<std::size_t>(i)], 0, tolerance);
    }
    // Fuel by the power of the engines: 0.584 lb an hour and horsepower, TM X-62407.
    tr_outputs outputs;
    CHECK_EQ(tr_get_outputs(&sim, &outputs), TR_OK);
    const double power = (outputs.power_w[0] + outputs.power_w[1]) / 0.93;
    CHECK_NEAR(rates[TR_FUEL], power / 745.69987 * 0.584 * 0.45359237 / 3600, 1e-3 * rates[TR_FUEL]);
    fly(sim, 200);
    CHECK_NEAR(state_of(sim).x[TR_PITCH], state_of(equipped(60, 70, governor)).x[TR_PITCH], 1e-4);
  }
}

// 7.5 deg/s both ways, and no further than the command.
TEST(capi_masts_follow_their_command) {
  tr_sim sim = equipped(0, 30);
  tr_systems systems = systems_of(sim);
  systems.mast_command_deg = 15;
  set_systems(sim, systems);
  double most = 0, fastest = 0;
  const auto work = new_work();
  for (int k = 0; k < 1000; ++k) {
    CHECK_EQ(tr_step(&sim, work.get(), dt), TR_OK);
    const tr_configuration c = configuration_of(sim);
    most = std::max(most, double(c.mast_deg));
    fastest = std::max(fastest, double(c.mast_rate_radps));
  }
  CHECK_NEAR(fastest, 7.5 * kDegree, 0.02 * 7.5 * kDegree);
  CHECK_NEAR(configuration_of(sim).mast_deg, 15, 1e-2);
  CHECK_LT(most, 15.001);
  CHECK_NEAR(state_of(sim).x[TR_MAST], 15 * kDegree, 1e-3);
}

// The linear model against central differences of tr_derivative over every state and input.
TEST(capi_linear_model_covers_the_systems) {
  if (sizeof(tr_real) < 8) {
    NOTE("differences in single precision say nothing");
    return;
  }
  for (const int governor : {int{TR_GOVERNOR_OFF}, int{TR_GOVERNOR_IDEAL}, int{TR_GOVERNOR_PI}}) {
    tr_sim sim = equipped(37, 50, governor);  // mast and flaps between the knots of their tables
    tr_configuration between = configuration_of(sim);
    between.flap_deg = 27;
    CHECK_EQ(tr_set_configuration(&sim, &between), TR_OK);
    tr_environment environment = calm();
    environment.altitude_origin_m = 500;
    CHECK_EQ(tr_set_environment(&sim, &environment), TR_OK);
    tr_state state = state_of(sim);
    state.x[TR_P] = 0.05;
    state.x[TR_Q] = -0.03;
    state.u[TR_LAT_STICK] += 0.1;
    set_state(sim, state);
    const auto work = new_work();
    tr_linear_shape shape;
    CHECK_EQ(tr_linearize(&sim, work.get(), TR_ALL_INPUTS, &shape, nullptr, 0, nullptr, 0), TR_SHORT_BUFFER);
    CHECK_EQ(shape.controls, int{TR_INPUTS});
    const auto n = static_cast<std::size_t>(shape.states), m = static_cast<std::size_t>(shape.controls);
    std::vector<tr_real> a(n * n), b(n * m);
    CHECK_EQ(tr_linearize(&sim, work.get(), TR_ALL_INPUTS, &shape, a.data(), a.size(), b.data(), b.size()),
             TR_OK);
    const auto column = [&](auto&& move) {
      std::vector<double> side[2];
      for (const int k : {0, 1}) {
        tr_sim moved = sim;
        move(moved, k == 0 ? -1.0 : 1.0);
        side[k] = rates_of(moved);
      }
      std::vector<double> found;
      for (std::size_t i = 0; i < n; ++i) {
        const auto row = static_cast<std::size_t>(shape.state[i]);
        found.push_back((side[1][row] - side[0][row]) / 2);
      }
      return found;
    };
    double worst = 0;
    const auto compare = [&](const std::vector<double>& differences, auto&& entry, double step,
                             const char* name) {
      double size = 1e-3;
      for (std::size_t i = 0; i < n; ++i) size = std::max(size, std::abs(entry(i)));
      for (std::size_t i = 0; i < n; ++i) {
        const double error = std::abs(differences[i] / step - entry(i)) / size;
        if (error > 1e-5)
          NOTE(name << ": " << tr_state_name(shape.state[i]) << " " << entry(i) << " not "
                    << differences[i] / step);
        worst = std::max(worst, error);
      }
    };
    for (std::size_t j = 0; j < n; ++j) {
      const int place = shape.state[j];
      const double step = place == TR_POWER_RIGHT || place == TR_POWER_LEFT ? 10 : 1e-5;
      compare(
          column([&](tr_sim& moved, double by) {
            tr_state s = state_of(moved);
            s.x[place] += by * step;
            set_state(moved, s);
          }),
          [&](std::size_t i) { return a[i * n + j]; }, step, tr_state_name(place));
    }
    for (std::size_t j = 0; j < m; ++j) {
      const int place = shape.control[j];
      const double step = 1e-5;
      compare(
          column([&](tr_sim& moved, double by) {
            if (place < TR_CONTROLS) {
              tr_state s = state_of(moved);
              s.u[place] += by * step;
              set_state(moved, s);
              return;
            }
            tr_systems y = systems_of(moved);
            tr_real* const command[] = {&y.mast_command_deg, &y.flap_command_deg, &y.rotor_command_radps,
                                        &y.throttle[0], &y.throttle[1]};
            *command[place - TR_CONTROLS] += by * step * (place < TR_CONTROLS + 2 ? 1 / kDegree : 1);
            set_systems(moved, y);
          }),
          [&](std::size_t i) { return b[i * m + j]; }, step, tr_control_name(place));
    }
    CHECK_LT(worst, 1e-5);
    NOTE("governor " << governor << ": " << n << " states, differences agree to " << worst);
    // And the modes of it: as many roots as states.
    std::vector<tr_mode> modes(n);
    std::size_t count = 0, roots = 0;
    CHECK_EQ(tr_modes(work.get(), &shape, a.data(), a.size(), modes.data(), n, &count), TR_OK);
    for (std::size_t k = 0; k < count; ++k) roots += modes[k].imag > 0 ? 2 : 1;
    CHECK_EQ(roots, n);
    const auto has = [&](const std::string& name) {
      return std::any_of(modes.begin(), modes.begin() + long(count),
                         [&](const tr_mode& k) { return name == k.name; });
    };
    CHECK(has("phugoid") && has("elevator_angle") && has("flap"));
  }
}

// Another process goes on with the same bits, in the middle of a conversion.
TEST(capi_systems_are_saved) {
  for (const int governor : {int{TR_GOVERNOR_IDEAL}, int{TR_GOVERNOR_PI}}) {
    tr_sim sim = equipped(15, 40, governor);
    tr_systems systems = systems_of(sim);
    systems.mast_command_deg = 60;
    systems.throttle[1] += tr_real(0.05);
    set_systems(sim, systems);
    fly(sim, 100);
    std::vector<unsigned char> bytes(TR_SAVED_SIZE);
    std::size_t used = 0;
    CHECK_EQ(tr_save(&sim, bytes.data(), bytes.size(), &used), TR_OK);
    tr_sim other;
    std::memset(&other, 0xff, sizeof other);
    CHECK_EQ(tr_load_saved(&other, TR_API_VERSION, bytes.data(), used), TR_OK);
    CHECK(same_bits(systems_of(sim), systems_of(other)));
    fly(sim, 100);
    fly(other, 100);
    CHECK(same_bits(state_of(sim), state_of(other)));
    // Restoring the state alone replays it too.
    const tr_state middle = state_of(sim);
    fly(sim, 50);
    const tr_state end = state_of(sim);
    set_state(sim, middle);
    fly(sim, 50);
    CHECK(same_bits(state_of(sim), end));
  }
}

TEST(capi_linearize_and_step_with_systems_is_the_two_calls) {
  for (const int governor : {int{TR_GOVERNOR_OFF}, int{TR_GOVERNOR_IDEAL}, int{TR_GOVERNOR_PI}}) {
    tr_sim one = equipped(0, 20, governor), two = one, three = one;
    const auto work = new_work();
    tr_linear_shape shape;
    std::vector<tr_real> a(max_states * max_states);
    tr_outputs outputs;
    for (int k = 0; k < 20; ++k) {
      tr_real u[4];
      std::memcpy(u, state_of(one).u, sizeof u);
      u[TR_LONG_STICK] += tr_real(k % 7 - 3) / 10;  // holds are given up and taken
      for (tr_sim* sim : {&one, &two, &three}) CHECK_EQ(tr_set_controls(sim, u, 4), TR_OK);
      CHECK_EQ(
          tr_linearize_and_step(&one, work.get(), dt, TR_INCEPTORS, &shape, a.data(), a.size(), nullptr, 0),
          TR_OK);
      CHECK_EQ(tr_step(&two, work.get(), dt), TR_OK);
      CHECK_EQ(tr_step_with_outputs(&three, work.get(), dt, &outputs), TR_OK);
    }
    CHECK(same_bits(state_of(one), state_of(two)) && same_bits(state_of(three), state_of(two)));
  }
}

TEST(capi_an_engine_out_halves_the_power) {
  tr_sim sim = equipped(90, 80);
  tr_systems systems = systems_of(sim);
  systems.engine_failed[0] = 1;
  set_systems(sim, systems);
  const double before = state_of(sim).x[TR_POWER_RIGHT];
  // A first-order lag of 0.7 s (choices.csv), its rate limited to 400 hp/s.
  fly(sim, 1000);
  CHECK_LT(state_of(sim).x[TR_POWER_RIGHT], 0.01 * before);
  CHECK_NEAR(state_of(sim).x[TR_POWER_LEFT], before, 0.01 * before);
  CHECK_LT(rate_of(sim, TR_U), 0);
}

TEST(capi_systems_refuse_what_they_cannot_do) {
  tr_sim sim = trimmed_sim(0, 20);
  const tr_systems good = systems_of(sim);
  const auto refused = [&](auto&& change, tr_status expected) {
    tr_systems bad = good;
    change(bad);
    CHECK_EQ(tr_set_systems(&sim, &bad), expected);
    CHECK(same_bits(systems_of(sim), good));
  };
  refused([](tr_systems& s) { s.governor = 3; }, TR_BAD_ARGUMENT);
  refused([](tr_systems& s) { s.governor = -1; }, TR_BAD_ARGUMENT);
  refused([](tr_systems& s) { s.scas = 2; }, TR_BAD_ARGUMENT);
  refused([](tr_systems& s) { s.engine_failed[1] = -1; }, TR_BAD_ARGUMENT);
  refused([](tr_systems& s) { s.mast_command_deg = 91; }, TR_OUT_OF_RANGE);
  refused([](tr_systems& s) { s.flap_command_deg = 76; }, TR_OUT_OF_RANGE);
  refused([](tr_systems& s) { s.rotor_command_radps = 10; }, TR_OUT_OF_RANGE);
  refused([](tr_systems& s) { s.throttle[0] = tr_real(1.3); }, TR_OUT_OF_RANGE);
  refused([](tr_systems& s) { s.throttle[1] = kNan; }, TR_NOT_FINITE);
  CHECK_EQ(tr_set_systems(&sim, nullptr), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_get_systems(&sim, nullptr), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_default_systems(nullptr), TR_BAD_ARGUMENT);
  // A state beyond what a system can be at.
  set_systems(sim, everything(good));
  for (const int place : {int{TR_MAST}, int{TR_ROTOR_SPEED}, int{TR_FLAP}}) {
    tr_state state = state_of(sim);
    state.x[place] = place == TR_ROTOR_SPEED ? 90 : tr_real(1.7);
    const tr_state before = state_of(sim);
    CHECK_EQ(tr_set_state(&sim, &state), TR_OUT_OF_RANGE);
    CHECK(same_bits(state_of(sim), before));
  }
}

// Rotors turning slowly at flat pitch, all wheels on the ground: it stands, and an accelerometer reads one g.
TEST(capi_stands_on_its_gear) {
  tr_setup setup = setup_at(0);
  setup.rotor_radps = 30;
  tr_sim sim;
  CHECK_EQ(tr_init(&sim, TR_API_VERSION, &setup), TR_OK);
  tr_environment environment = calm();
  environment.ground_down_m = 0;
  CHECK_EQ(tr_set_environment(&sim, &environment), TR_OK);
  tr_systems systems = systems_of(sim);
  systems.gear = systems.ground_effect = 1;
  systems.brake[0] = systems.brake[1] = 1;
  set_systems(sim, systems);
  tr_state state = state_of(sim);
  state.x[TR_DOWN] = tr_real(-2.3);
  set_state(sim, state);
  std::uint32_t flags = 0;
  CHECK_EQ(tr_get_flags(&sim, &flags), TR_OK);
  CHECK_EQ(flags & TR_ON_GROUND, 0u);
  const tr_real collective = tr_real(-0.03);
  CHECK_EQ(tr_set_controls(&sim, &collective, 1), TR_OK);
  fly(sim, 2000);
  CHECK_EQ(tr_get_flags(&sim, &flags), TR_OK);
  CHECK_EQ(flags & TR_ON_GROUND, std::uint32_t{TR_ON_GROUND});
  tr_outputs outputs;
  CHECK_EQ(tr_get_outputs(&sim, &outputs), TR_OK);
  CHECK_NEAR(outputs.specific_force_mps2[2], -9.80665, 0.05);
  const std::vector<double> rates = rates_of(sim);
  for (const int state_of_body : {TR_U, TR_V, TR_W, TR_P, TR_Q, TR_R})
    CHECK_NEAR(rates[static_cast<std::size_t>(state_of_body)], 0, 0.05);
  // The ground bears on its wheels alone: CG 82.1 in above the stations' origin less the 11 in of the ground at rest.
  CHECK_NEAR(state_of(sim).x[TR_DOWN], -(82.1 - 11) * 0.0254, 0.12);
}

// Height that a given power holds: more weight is carried near the ground.
TEST(capi_ground_effect_saves_power) {
  const auto power = [](tr_real ground_down) {
    tr_sim sim = sim_at(0);
    tr_environment environment = calm();
    environment.ground_down_m = ground_down;
    CHECK_EQ(tr_set_environment(&sim, &environment), TR_OK);
    tr_systems systems = systems_of(sim);
    systems.ground_effect = 1;
    set_systems(sim, systems);
    const auto work = new_work();
    const tr_flight hover = {0, 0, 0, 0};
    CHECK_EQ(tr_trim(&sim, work.get(), &hover, nullptr), TR_OK);
    tr_outputs outputs;
    CHECK_EQ(tr_get_outputs(&sim, &outputs), TR_OK);
    const std::vector<double> rates = rates_of(sim);
    for (int i = 0; i < TR_NORTH; ++i)
      CHECK_NEAR(rates[static_cast<std::size_t>(i)], 0, sizeof(tr_real) == 8 ? 1e-6 : 1e-2);
    return double(outputs.power_w[0] + outputs.power_w[1]);
  };
  const double free = power(kInfinity), high = power(200), low = power(3);
  CHECK_NEAR(high, free, 1e-6 * free);
  // Cheeseman and Bennett at z/R of about 1.2, and the download: some 15 % less.
  CHECK_LT(low, 0.92 * free);
  CHECK_LT(0.75 * free, low);
  NOTE("power at 3 m over that far away: " << low / free);
}

TEST(capi_turbulence_is_a_function_of_seed_and_steps) {
  tr_sim sim = equipped(0, 30);
  tr_systems systems = systems_of(sim);
  systems.turbulence = 1;
  systems.turbulence_seed = 7;
  systems.turbulence_w20_mps = tr_real(15.4);
  set_systems(sim, systems);
  tr_sim twin = sim, other = sim;
  systems.turbulence_seed = 8;
  set_systems(other, systems);
  fly(sim, 300);
  fly(twin, 150);
  std::vector<unsigned char> bytes(TR_SAVED_SIZE);
  std::size_t used = 0;
  CHECK_EQ(tr_save(&twin, bytes.data(), bytes.size(), &used), TR_OK);
  CHECK_EQ(tr_load_saved(&twin, TR_API_VERSION, bytes.data(), used), TR_OK);
  fly(twin, 150);
  fly(other, 300);
  CHECK(same_bits(state_of(sim), state_of(twin)));
  CHECK(!same_bits(state_of(sim), state_of(other)));
  CHECK_LT(0.05, std::abs(state_of(sim).x[TR_W] - state_of(other).x[TR_W]));
}

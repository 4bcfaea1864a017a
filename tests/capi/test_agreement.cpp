// The C interface: results are those of the C++ analyses bit for bit.
// Expected: the templates, called directly.
#include <string>

#include "capi/flying.hpp"
#include "tiltrotor/analysis/instances.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

using namespace capi;

// The same numbers by the C++ analyses.
TEST(capi_agrees_with_the_analyses) {
  using namespace tiltrotor;
  const Aircraft<tr_real>& aircraft = aircraft_data<tr_real>();
  for (const tr_real mast : {tr_real(0), tr_real(30), tr_real(90)}) {
    const tr_real speed = mast < 90 ? tr_real(40) : tr_real(100);
    FlightSetup<tr_real> setup = flight_setup(aircraft, mast);
    setup.options.grid = BladeGrid::realtime;
    setup.options.position_states = true;
    const auto c = std::make_unique<Configuration<tr_real>>();
    CHECK(prepare(aircraft, setup, *c) == Status::ok);
    const auto trim_work = std::make_unique<TrimWorkspace<tr_real>>();
    const auto trimmed = std::make_unique<TrimResult<tr_real>>();
    CHECK(trim(*c, SteadyFlight<tr_real>{speed, 0, 0, 0}, *trim_work, *trimmed) == TrimStatus::ok);
    tr_sim sim = trimmed_sim(mast, speed);
    tr_real x[state_count];
    tr_real u[control_count];
    flatten(trimmed->state, x);
    flatten(trimmed->controls, u);
    tr_state state = state_of(sim);
    CHECK(std::memcmp(state.x, x, sizeof x) == 0);
    CHECK(std::memcmp(state.u, u, sizeof u) == 0);

    const auto linear_work = std::make_unique<LinearizationWorkspace<tr_real>>();
    const auto model = std::make_unique<LinearModel<tr_real>>();
    CHECK(linearize(*c, trimmed->state, trimmed->controls, kAllControls, *linear_work, *model) == Status::ok);
    const auto work = new_work();
    tr_linear_shape shape;
    std::vector<tr_real> a(max_states * max_states);
    std::vector<tr_real> b(max_states * TR_CONTROLS);
    CHECK_EQ(tr_linearize(&sim, work.get(), TR_ALL_CONTROLS, &shape, a.data(), a.size(), b.data(), b.size()),
             TR_OK);
    CHECK_EQ(shape.states, model->states);
    bool same = true;
    const auto n = static_cast<std::size_t>(model->states);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) same = same && a[i * n + j] == model->a(int(i), int(j));
      for (std::size_t j = 0; j < 14; ++j) same = same && b[i * 14 + j] == model->b(int(i), int(j));
    }
    CHECK(same);
    // The blade controls are some of all controls: the same columns.
    std::vector<tr_real> b_blades(b.size());
    tr_linear_shape blades;
    CHECK_EQ(tr_linearize(&sim, work.get(), TR_BLADE_CONTROLS, &blades, a.data(), a.size(), b_blades.data(),
                          b_blades.size()),
             TR_OK);
    const auto columns = static_cast<std::size_t>(blades.controls);
    CHECK_EQ(columns, static_cast<std::size_t>(kBladeControls.count));
    for (std::size_t j = 0; j < columns; ++j) {
      const auto all = static_cast<std::size_t>(kBladeControls.index[j]);
      for (std::size_t i = 0; i < n; ++i)
        CHECK_REL(b_blades[i * columns + j], b[i * 14 + all], sizeof(tr_real) > 4 ? 1e-12 : 1e-4);
    }
    const auto modes_work = std::make_unique<ModesWorkspace<tr_real>>();
    const auto set = std::make_unique<ModeSet<tr_real>>();
    CHECK(modes(*model, *modes_work, *set) == Status::ok);
    std::vector<tr_mode> found(max_states);
    std::size_t count = 0;
    CHECK_EQ(tr_modes(work.get(), &shape, a.data(), a.size(), found.data(), found.size(), &count), TR_OK);
    CHECK_EQ(count, static_cast<std::size_t>(set->count));
    for (std::size_t i = 0; i < count; ++i) {
      CHECK_EQ(std::string(found[i].name), std::string(set->mode[i].name));
      CHECK_EQ(found[i].real, set->mode[i].real);
    }
    tr_real real[TR_MAX_LINEAR_STATES];
    tr_real imag[TR_MAX_LINEAR_STATES];
    CHECK_EQ(tr_eigenvalues(work.get(), a.data(), n, real, imag, max_states), TR_OK);
    tr_real trace = 0;
    tr_real sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      trace += a[i * n + i];
      sum += real[i];
    }
    CHECK_NEAR(sum, trace, (sizeof(tr_real) == 8 ? 1e-9 : 1e-2) * double(std::abs(trace)));

    tr_outputs outputs;
    CHECK_EQ(tr_get_outputs(&sim, &outputs), TR_OK);
    CHECK_EQ(outputs.thrust_n[0], trimmed->thrust[0]);
    CHECK_EQ(outputs.power_w[1], trimmed->power[1]);
    CHECK_NEAR(outputs.load_factor, trimmed->load_factor, 1e-5);
    CHECK_NEAR(outputs.climb_rate_mps, 0, 1e-3);
    CHECK_NEAR(outputs.airspeed_mps, speed, 1e-4);

    const auto step_work = std::make_unique<SimulationWorkspace<tr_real>>();
    const auto simulation = std::make_unique<Simulation<tr_real>>();
    CHECK(start(*c, trimmed->state, trimmed->controls, dt, Integrator::rk3, *simulation) == Status::ok);
    for (int k = 0; k < 50; ++k) {
      CHECK(advance(*c, *step_work, *simulation) == Status::ok);
      CHECK_EQ(tr_step(&sim, work.get(), dt), TR_OK);
    }
    flatten(simulation->state, x);
    state = state_of(sim);
    CHECK(std::memcmp(state.x, x, sizeof x) == 0);
    CHECK_NEAR(state.time_s, 0.25, 1e-7);
    CHECK_EQ(state.steps, 50);
  }
}

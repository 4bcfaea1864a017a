// No legal call raises a floating-point exception for an invalid operation, a division by zero or an
// overflow: a program that traps them flies on. Underflow and rounding are no faults.
// Expected: the flags of the C library's fenv.h.
#include <cfenv>
#include <cmath>

#include "flying.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

using namespace capi;

namespace {

constexpr int kSerious = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;

class Random {
 public:
  tr_real between(double low, double high) {
    seed_ = seed_ * 1664525u + 1013904223u;
    return static_cast<tr_real>(low + (high - low) * seed_ / 4294967296.0);
  }

 private:
  std::uint32_t seed_ = 20261125;
};

// What the call raised.
template <class Call>
int raised(Call&& call) {
  std::feclearexcept(FE_ALL_EXCEPT);
  call();
  return std::fetestexcept(kSerious);
}

// Legal and as wild as `part` says: 1 for the whole range of tr_set_state.
tr_state state_within(Random& random, double part) {
  tr_state s;
  std::memset(&s, 0, sizeof s);
  for (int i = 0; i < TR_CONING_LEFT + 2; ++i) s.x[i] = random.between(-2 * part, 2 * part);
  for (int i = TR_U; i <= TR_W; ++i) s.x[i] = random.between(-170 * part, 170 * part);
  for (int i = TR_P; i <= TR_R; ++i) s.x[i] = random.between(-11 * part, 11 * part);
  s.x[TR_PITCH] = random.between(-1.55 * part, 1.55 * part);
  for (int rotor : {TR_ROTOR_RIGHT, TR_ROTOR_LEFT})
    for (int i : {2, 3}) s.x[rotor + i] = random.between(-200 * part, 200 * part);
  for (int i = 0; i < TR_CONTROLS; ++i) s.u[i] = random.between(-0.3 * part, 0.3 * part);
  const double gust = tiltrotor::aircraft_data<double>().limits.gust;
  for (int i = TR_GUST_U; i <= TR_GUST_W; ++i) s.u[i] = random.between(-gust * part, gust * part);
  return s;
}

struct Workspace {
  tr_work work;
  tr_real a[max_states * max_states], b[max_states * TR_CONTROLS];
  tr_real c[TR_OUTPUTS * max_states], d[TR_OUTPUTS * TR_CONTROLS];
  tr_real real[max_states], imag[max_states];
  tr_mode modes[TR_MAX_LINEAR_STATES];
};

}  // namespace

// From at rest to the ends of the ranges, also with numbers that are 0 and states that are alike.
TEST(capi_states_raise_no_floating_point_exception) {
  Random random;
  const tiltrotor::LimitTables<double>& limits = tiltrotor::aircraft_data<double>().limits;
  const auto workspace = std::make_unique<Workspace>();
  std::memset(workspace.get(), 0xff, sizeof *workspace);
  int calls = 0;
  for (int k = 0; k < 600; ++k) {
    tr_setup setup = setup_at(k % 4 == 0 ? random.between(0, 90) : tr_real(k % 7 * 15));
    setup.coning_states = k % 2;
    setup.tables = k % 3 == 0 ? TR_TABLES_LINEAR : TR_TABLES_SMOOTH;
    if (k % 5 == 0) setup.rotor_radps = random.between(limits.rotor_speed.low, limits.rotor_speed.high);
    if (k % 5 == 1) setup.altitude_m = random.between(limits.altitude.low, limits.altitude.high);
    const double parts[] = {0, 1e-9, 1e-3, 0.1, 0.3, 1};
    const tr_state state = state_within(random, parts[k % 6]);
    const tr_real dt_now = random.between(1e-5, 0.02);
    tr_sim sim;
    tr_real rates[TR_STATES];
    tr_outputs outputs;
    tr_linear_shape shape;
    size_t count = 0;
    const auto check = [&](const char* what, int exceptions) {
      ++calls;
      if (!CHECK_EQ(exceptions, 0)) NOTE(what << ", case " << k << ", part " << parts[k % 6]);
    };
    check("init", raised([&] { CHECK_EQ(tr_init(&sim, TR_API_VERSION, &setup), TR_OK); }));
    check("set_state", raised([&] { CHECK_EQ(tr_set_state(&sim, &state), TR_OK); }));
    check("derivative", raised([&] { CHECK_EQ(tr_derivative(&sim, rates, TR_STATES), TR_OK); }));
    check("outputs", raised([&] { CHECK_EQ(tr_get_outputs(&sim, &outputs), TR_OK); }));
    std::uint32_t flags;
    tr_motion motion;
    tr_air_data air;
    const tr_real nose[3] = {2, 0, 2};
    check("flags", raised([&] { CHECK_EQ(tr_get_flags(&sim, &flags), TR_OK); }));
    check("motion", raised([&] { CHECK_EQ(tr_motion_at(&sim, nose, &motion), TR_OK); }));
    check("air data", raised([&] { CHECK_EQ(tr_air_data_at(&sim, nose, &air), TR_OK); }));
    if (k % 3 == 0) {
      check("directional", raised([&] {
              CHECK_EQ(tr_directional(&sim, &workspace->work, state.x, state.u, rates, &outputs), TR_OK);
            }));
      check("outputs of the linear model", raised([&] {
              CHECK_EQ(tr_linearize_outputs(&sim, &workspace->work, TR_ALL_CONTROLS, workspace->c,
                                            TR_OUTPUTS * max_states, workspace->d, TR_OUTPUTS * TR_CONTROLS),
                       TR_OK);
            }));
      check("linearize", raised([&] {
              CHECK_EQ(
                  tr_linearize(&sim, &workspace->work, k % 2 ? TR_INCEPTORS : TR_ALL_CONTROLS, &shape,
                               workspace->a, max_states * max_states, workspace->b, max_states * TR_CONTROLS),
                  TR_OK);
            }));
      const auto n = static_cast<size_t>(shape.states);
      check("eigenvalues", raised([&] {
              (void)tr_eigenvalues(&workspace->work, workspace->a, n, workspace->real, workspace->imag,
                                   max_states);
            }));
      check("modes", raised([&] {
              (void)tr_modes(&workspace->work, &shape, workspace->a, n * n, workspace->modes, max_states,
                             &count);
            }));
    }
    tr_sim again = sim;
    check("step", raised([&] { (void)tr_step(&sim, &workspace->work, dt_now); }));
    check("step with outputs",
          raised([&] { (void)tr_step_with_outputs(&again, &workspace->work, dt_now, &outputs); }));
  }
  CHECK_LT(3000, calls);
}

// With systems, in every setting of the governor; the work area holds signalling NaNs.
TEST(capi_systems_raise_no_floating_point_exception) {
  const auto workspace = std::make_unique<Workspace>();
  const std::uint64_t trap = sizeof(tr_real) == 8 ? 0x7ff4000000000001u : 0x7fa000017fa00001u;
  for (std::uint64_t& word : workspace->work.reserved) word = trap;
  const tr_work untouched = workspace->work;
  static tr_real b[max_states * TR_INPUTS], d[TR_OUTPUTS * TR_INPUTS];
  tr_real dx[TR_STATES] = {1}, du[TR_INPUTS] = {0, 1}, rates[TR_STATES];
  tr_outputs outputs;
  tr_linear_shape shape;
  std::size_t count = 0;
  int calls = 0;
  for (int k = 0; k < 24; ++k) {
    tr_sim sim = sim_at(k % 4 * 30);
    const tr_flight flight = {tr_real(30 + k % 4 * 20), 0, 0, 0};
    tr_environment air;
    tr_systems systems;
    CHECK_EQ(tr_default_environment(&air), TR_OK);
    air.wind_mps[0] = -4;
    air.ground_down_m = k % 2 == 0 ? 5 : 300;
    CHECK_EQ(tr_set_environment(&sim, &air), TR_OK);
    CHECK_EQ(tr_get_systems(&sim, &systems), TR_OK);
    systems.governor = k / 4 % 3;
    systems.conversion = systems.engines = systems.actuators = systems.scas = 1;
    systems.gear = systems.ground_effect = k % 2;
    systems.interconnect = systems.governor == TR_GOVERNOR_PI;
    systems.turbulence = k / 12;
    systems.turbulence_w20_mps = 5;
    const auto check = [&](const char* what, auto&& call) {
      ++calls;
      workspace->work = untouched;
      tr_status status = TR_OK;
      const int exceptions = raised([&] { status = call(); });
      if (!CHECK_EQ(exceptions, 0) || !CHECK_EQ(status, TR_OK)) NOTE(what << ", case " << k);
    };
    tr_work* const work = &workspace->work;
    check("set_systems", [&] { return tr_set_systems(&sim, &systems); });
    check("trim", [&] { return tr_trim(&sim, work, &flight, nullptr); });
    for (int step = 0; step < 3; ++step) check("step", [&] { return tr_step(&sim, work, dt); });
    check("step with outputs", [&] { return tr_step_with_outputs(&sim, work, dt, &outputs); });
    check("outputs", [&] { return tr_get_outputs(&sim, &outputs); });
    check("directional", [&] { return tr_directional(&sim, work, dx, du, rates, &outputs); });
    check("directional inputs", [&] { return tr_directional_inputs(&sim, work, dx, du, rates, &outputs); });
    check("outputs of the linear model", [&] {
      return tr_linearize_outputs(&sim, work, TR_ALL_INPUTS, workspace->c, TR_OUTPUTS * max_states, d,
                                  TR_OUTPUTS * TR_INPUTS);
    });
    check("linearize and step", [&] {
      return tr_linearize_and_step(&sim, work, dt, TR_INCEPTORS, &shape, workspace->a,
                                   max_states * max_states, nullptr, 0);
    });
    check("linearize", [&] {
      return tr_linearize(&sim, work, TR_ALL_INPUTS, &shape, workspace->a, max_states * max_states, b,
                          max_states * TR_INPUTS);
    });
    const auto n = static_cast<std::size_t>(shape.states);
    check("eigenvalues", [&] {
      return tr_eigenvalues(work, workspace->a, n, workspace->real, workspace->imag, max_states);
    });
    check("modes",
          [&] { return tr_modes(work, &shape, workspace->a, n * n, workspace->modes, max_states, &count); });
    check("rigid model", [&] {
      return tr_rigid_model(work, &shape, workspace->a, n * n, b, max_states * TR_INPUTS, &shape,
                            workspace->a, n * n, b, max_states * TR_INPUTS);
    });
  }
  CHECK_LT(300, calls);
}

// Matrices of every order, of whole numbers and of numbers far apart, singular ones and that of zeros.
TEST(capi_matrices_raise_no_floating_point_exception) {
  Random random;
  const auto workspace = std::make_unique<Workspace>();
  const int reach = sizeof(tr_real) == 4 ? 10 : 80;
  for (int k = 0; k < 2000; ++k) {
    const auto n = static_cast<size_t>(1 + k % TR_MAX_LINEAR_STATES);
    const int kind = k % 5;
    for (size_t i = 0; i < n * n; ++i) {
      tr_real x = kind == 0 ? 0 : random.between(-1, 1);
      if (kind == 1) x = std::floor(tr_real(2) * x);
      if (kind == 2) x *= std::pow(tr_real(10), std::floor(random.between(-reach, reach)));
      if (kind == 3) x = i % n > i / n ? x : 0;
      if (kind == 4) x = i % 3 == 0 ? x * std::numeric_limits<tr_real>::min() : 0;
      workspace->a[i] = x;
    }
    const int exceptions = raised([&] {
      (void)tr_eigenvalues(&workspace->work, workspace->a, n, workspace->real, workspace->imag, max_states);
    });
    if (!CHECK_EQ(exceptions, 0)) NOTE("order " << n << ", kind " << kind);
  }
}

// Trims of the whole range, found or not, and the flight on from there.
TEST(capi_trim_raises_no_floating_point_exception) {
  Random random;
  const double most = tiltrotor::aircraft_data<double>().limits.speed;
  const auto work = new_work();
  for (int k = 0; k < 60; ++k) {
    tr_sim sim = sim_at(random.between(0, 90));
    const double part = k % 2 ? 0.2 : 1;
    const tr_flight flight = {random.between(0.1, most), random.between(-1.57 * part, 1.57 * part),
                              random.between(-part, part), random.between(-part, part)};
    tr_trim_result result;
    tr_status status = TR_OK;
    const int exceptions = raised([&] { status = tr_trim(&sim, work.get(), &flight, &result); });
    if (!CHECK_EQ(exceptions, 0)) NOTE(flight.speed_mps << " m/s, climb " << flight.climb_rad);
    CHECK(status != TR_NOT_FINITE && status != TR_OUT_OF_RANGE);
    CHECK_EQ(raised([&] { (void)tr_step(&sim, work.get(), dt); }), 0);
  }
}

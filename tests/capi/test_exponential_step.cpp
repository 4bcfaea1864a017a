// The C interface: steps by the exponential of A. Expected: tr_step in short steps, order 2, and the header's text.
#include "capi/flying.hpp"

using namespace capi;

namespace {

struct Model {
  tr_linear_shape shape;
  std::vector<tr_real> a = std::vector<tr_real>(max_states * max_states);
  std::vector<tr_real> b = std::vector<tr_real>(max_states * TR_INPUTS);
};

tr_status leap(tr_sim& sim, tr_work* work, tr_real step, Model& m, const tr_real* control_rates = nullptr,
               int32_t columns = TR_INCEPTORS) {
  return tr_linearize_and_step_exponential(&sim, work, step, control_rates, columns, &m.shape, m.a.data(),
                                           m.a.size(), m.b.data(), m.b.size());
}

// The largest of velocities in m/s, rates in rad/s and angles in rad, to heading.
tr_real apart(const tr_sim& one, const tr_sim& other) {
  const tr_state x = state_of(one), y = state_of(other);
  tr_real worst = 0;
  for (int i = TR_U; i <= TR_YAW; ++i) worst = std::max(worst, std::abs(x.x[i] - y.x[i]));
  return worst;
}

}  // namespace

// Two seconds with the collective raised, in a turn of the heading: 40 ms, four times the error of 20 ms; heading and
// way flown, which A leaves out, too.
TEST(capi_exponential_step_follows_tr_step) {
  for (const tr_real mast : {tr_real(0), tr_real(90)}) {
    const tr_sim begun = trimmed_sim(mast, mast < 90 ? 40 : 90);
    const auto work = new_work();
    const tr_state x = state_of(begun);
    const tr_real u[] = {x.u[0] + tr_real(0.01), x.u[1], x.u[2] + tr_real(0.3), x.u[3] + tr_real(0.2)};
    tr_sim fine = begun;
    CHECK_EQ(tr_set_controls(&fine, u, 4), TR_OK);
    for (int k = 0; k < 1000; ++k) CHECK_EQ(tr_step(&fine, work.get(), tr_real(0.002)), TR_OK);
    tr_real error[2];
    for (int pass = 0; pass < 2; ++pass) {
      const int steps = pass == 0 ? 50 : 100;
      tr_sim sim = begun;
      Model m;
      CHECK_EQ(tr_set_controls(&sim, u, 4), TR_OK);
      for (int k = 0; k < steps; ++k) CHECK_EQ(leap(sim, work.get(), tr_real(2) / tr_real(steps), m), TR_OK);
      error[pass] = apart(sim, fine);
      CHECK_NEAR(state_of(sim).time_s, 2, 1e-5);
      CHECK_NEAR(state_of(sim).x[TR_NORTH], state_of(fine).x[TR_NORTH], 0.02);
      CHECK_NEAR(state_of(sim).x[TR_DOWN], state_of(fine).x[TR_DOWN], 0.02);
    }
    NOTE("mast " << mast << ": 40 and 20 ms " << error[0] << " " << error[1]);
    CHECK_LT(error[1], 3e-4);
    if (sizeof(tr_real) == sizeof(double)) CHECK_NEAR(error[0] / error[1], 4, 1.5);
    CHECK_LT(tr_real(0.01), std::abs(state_of(fine).x[TR_YAW]));
  }
}

// A control that ramps in frames of 40 ms, against the same in steps of 2 ms at the middle of each; it stays moved.
TEST(capi_exponential_step_with_a_ramp) {
  const tr_sim begun = trimmed_sim(30, 50);
  const auto work = new_work();
  const tr_real rate = tr_real(0.5);  // in/s of the longitudinal stick
  const tr_real rates[] = {0, rate, 0, 0};
  const tr_real stick = state_of(begun).u[1];
  tr_sim fine = begun, sim = begun, held = begun;
  for (int k = 0; k < 500; ++k) {
    tr_state x = state_of(fine);
    x.u[1] = stick + rate * (tr_real(k) + tr_real(0.5)) * tr_real(0.002);
    CHECK_EQ(tr_set_controls(&fine, x.u, 2), TR_OK);
    CHECK_EQ(tr_step(&fine, work.get(), tr_real(0.002)), TR_OK);
  }
  Model m;
  for (int k = 0; k < 25; ++k) {
    CHECK_EQ(leap(sim, work.get(), tr_real(0.04), m, rates), TR_OK);
    CHECK_EQ(leap(held, work.get(), tr_real(0.04), m), TR_OK);
    tr_state x = state_of(held);
    x.u[1] += rate * tr_real(0.04);
    CHECK_EQ(tr_set_controls(&held, x.u, 2), TR_OK);
  }
  CHECK_NEAR(state_of(sim).u[1], stick + rate, 1e-5);
  NOTE("ramp " << apart(sim, fine) << ", held in each frame " << apart(held, fine));
  CHECK_LT(apart(sim, fine), 1e-3);
  CHECK_LT(5 * apart(sim, fine), apart(held, fine));
}

TEST(capi_exponential_step_refuses) {
  tr_sim sim = trimmed_sim(30, 50);
  const tr_state before = state_of(sim);
  const auto work = new_work();
  Model m;
  for (const tr_real step : {tr_real(0), tr_real(-0.01), tr_real(0.041), tr_real(1)})
    CHECK_EQ(leap(sim, work.get(), step, m), TR_OUT_OF_RANGE);
  CHECK_EQ(leap(sim, work.get(), kNan, m), TR_NOT_FINITE);
  CHECK_EQ(leap(sim, nullptr, dt, m), TR_BAD_ARGUMENT);
  CHECK_EQ(leap(sim, work.get(), dt, m, nullptr, 0), TR_BAD_ARGUMENT);
  tr_real rates[TR_INPUTS] = {0, 0, 0, 1000};
  CHECK_EQ(leap(sim, work.get(), dt, m, rates), TR_OUT_OF_RANGE);
  tr_fault fault;
  CHECK_EQ(tr_last_fault(&sim, &fault), TR_OK);
  CHECK_EQ(fault.control, TR_PEDAL);
  rates[3] = kNan;
  CHECK_EQ(leap(sim, work.get(), dt, m, rates), TR_NOT_FINITE);
  rates[3] = 0;
  rates[TR_CONTROLS] = 1;  // a command, which nothing follows without systems
  CHECK_EQ(leap(sim, work.get(), dt, m, rates, TR_ALL_INPUTS), TR_BAD_ARGUMENT);
  rates[TR_CONTROLS] = 0;
  CHECK_EQ(tr_linearize_and_step_exponential(&sim, work.get(), dt, rates, TR_INCEPTORS, &m.shape, m.a.data(),
                                             m.a.size(), nullptr, 0),
           TR_BAD_ARGUMENT);
  CHECK(same_bits(before, state_of(sim)));
  CHECK_EQ(leap(sim, work.get(), tr_real(0.04), m, rates, TR_ALL_INPUTS), TR_OK);
  tr_systems systems;
  CHECK_EQ(tr_get_systems(&sim, &systems), TR_OK);
  systems.scas = 1;
  CHECK_EQ(tr_set_systems(&sim, &systems), TR_OK);
  CHECK_EQ(leap(sim, work.get(), dt, m), TR_BAD_ARGUMENT);
}

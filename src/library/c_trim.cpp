// The C interface: trim.
#include <cmath>
#include <limits>

#include "library/c_state.hpp"
#include "library/c_systems.hpp"
#include "library/c_words.hpp"

namespace tiltrotor {
TILTROTOR_C_TRIM()
}  // namespace tiltrotor

namespace tiltrotor::c_interface {

namespace {

constexpr int kGroundRounds = 6;

// To the tolerance of a trim.
bool is_near(const State<R>& a, const State<R>& b) {
  R one[state_count], other[state_count];
  flatten(a, one);
  flatten(b, other);
  for (int i = 0; i < state_count; ++i)
    if (!(std::fabs(one[i] - other[i]) <
          R(64) * std::numeric_limits<R>::epsilon() * (R(1) + std::fabs(one[i]))))
      return false;
  return true;
}

}  // namespace

}  // namespace tiltrotor::c_interface

namespace tiltrotor::c_interface::checked {

tr_status tr_trim(tr_sim* sim, tr_work* work, const tr_flight* flight, tr_trim_result* result) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  if (work == nullptr || flight == nullptr) return TR_BAD_ARGUMENT;
  Sim& s = *opened(sim);
  TrimCallWorkspace& call = workspace_in<TrimCallWorkspace>(work);
  const SteadyFlight<R> wanted = {flight->speed_mps, flight->climb_rad, flight->turn_rate_radps,
                                  flight->sideslip_rad, s.u.gust};
  // A driven mast stands while a trim is looked for, and the rotors turn alike.
  equipped(s, call.configuration);
  FlightSetup<R>& setup = call.configuration.setup;
  const bool driven = s.systems.vehicle.on.conversion && is_moving<R>(setup);
  if (driven) setup.mast_rate = setup.mast_acceleration = R(0);
  const bool apart = setup.rotor_difference != R(0);
  setup.rotor_difference = R(0);
  if (driven || apart) configure(call.configuration);
  // Gear and ground depend on what is found: a few rounds, each a trim from its beginning.
  TrimStatus status = TrimStatus::ok;
  TrimOptions options;
  options.engines = engines_that_run(s);
  for (int round = 0; round < kGroundRounds; ++round) {
    const State<R> before = call.result.state;
    status = trim(call.configuration, wanted, call.workspace, call.result, options);
    if (!is_trimmed(status) || (round > 0 && is_near(before, call.result.state))) break;
    if (!meet_ground_in_flight(s, call.result.state, call.result.controls, call.configuration)) break;
  }
  if (result != nullptr) {
    result->iterations = call.result.iterations;
    result->attempts = call.result.attempts;
    result->residual = call.result.residual;
    explain(call.result, result->text, static_cast<int>(sizeof result->text));
  }
  if (is_trimmed(status)) {
    const R heading = s.x.yaw;
    const Vec3<R> position = s.x.position;
    keep(call.configuration, s);
    s.x = call.result.state;
    s.x.yaw = heading;
    s.x.position = position;
    s.u = call.result.controls;
    follow(s.x, s.travel);
    settle_systems(s);
    s.time = 0;
    s.steps = 0;
  }
  return translated(status);
}

}  // namespace tiltrotor::c_interface::checked

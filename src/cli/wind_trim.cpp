#include "cli/wind_trim.hpp"

#include <cmath>

namespace tiltrotor::cli {

namespace {

constexpr double widest_sideslip = 60 * kRadPerDeg<double>;  // of a flight that begins straight ahead

// Everything in the result that follows from state and controls.
void describe(const Configuration<double>& c, const State<double>& x, const Controls<double>& u,
              TrimResult<double>& result) {
  result.state = x;
  result.controls = u;
  const Vec3<double>& v = x.velocity;
  const double speed = length(v);
  const bool moves = speed >= kLeastSpeed<double>;
  const Evaluation<double> e = study::evaluated(c, x, u);
  result.blades = mix_controls(c, u, v);
  result.angle_of_attack = moves ? std::atan2(v.z, v.x) : 0;
  result.sideslip = moves ? std::asin(v.y / speed) : 0;
  result.wing_angle_of_attack = e.wing_alpha;
  result.collective_root = u.collective + blade_root_twist(c);
  Vec3<double> force{};
  for (const Loads<double>& loads : e.loads.component) force = force + loads.force;
  result.load_factor = load_factor((1 / c.mass.mass) * force, v);
  double download = 0;
  for (const Side side : {right, left}) {
    const MastLoads<double>& rotor = e.rotor[side].loads;
    result.thrust[side] = length(rotor.force_a);
    result.power[side] = rotor.torque * c.setup.rotor_speed;
    const Loads<double>& wake =
        e.loads[side == right ? Component::wing_wake_right : Component::wing_wake_left];
    download -= dot(wake.force, c.hub[side].thrust_axis_b);
  }
  const double thrust = result.thrust[right] + result.thrust[left];
  result.download_fraction = std::max(download, 0.0) / std::max(thrust, c.mass.mass * kGravity<double> / 10);
  result.limits = check_limits(c, speed, e.wing_alpha, x, u, result.blades, e.rotor);
  result.status = result.limits.status;
}

}  // namespace

study::Track track_in_wind(const SteadyFlight<double>& flight, double azimuth) {
  return {flight.speed * std::cos(flight.climb), std::remainder(azimuth, 2 * kPi<double>),
          -flight.speed * std::sin(flight.climb), flight.turn_rate};
}

void trim_in_wind(const Configuration<double>& c, const SteadyFlight<double>& flight, double azimuth,
                  Analyses& work, TrimResult<double>& result) {
  SteadyFlight<double> ahead = flight;
  // In vertical flight the wind has no side: refused, as a sideslip is.
  ahead.sideslip = is_vertical(flight) ? widest_sideslip : 0;
  const bool at_rest = flight.speed < kLeastSpeed<double>;
  // Also where the flight cannot be asked for.
  if (trim(c, ahead, work, result) == TrimStatus::out_of_range || at_rest) return;
  const TrimResult<double> straight = result;
  const study::Track track = track_in_wind(flight, azimuth);
  study::SidewardFlight found{};
  const bool turns_aside = is_trimmed(straight.status) && std::fabs(track.azimuth) <= widest_sideslip;
  if (turns_aside) found = study::flight_aside(c, track, {true, straight.state, straight.controls});
  if (!found.found) found = study::flight_along(c, track);
  result = TrimResult<double>{};
  result.weight_carried = 1;
  result.attempts = turns_aside ? 2 : 1;
  result.iterations = found.iterations;
  result.residual = found.rate;
  result.residual_state = kStateIndex.velocity.y;
  if (found.found) {
    describe(c, found.state, found.controls, result);
  } else {
    result.status = TrimStatus::not_converged;
  }
}

}  // namespace tiltrotor::cli

// Outputs and event indicators, and how they change along a direction.
#include <cmath>
#include <cstring>

#include "fmu/instance.hpp"
#include "tiltrotor/sensors.h"

namespace tiltrotor_fmu {

namespace {

constexpr double kAtRest = 1e-15;  // m/s

// Of the airframe through the undisturbed air: ahead and aside along the horizon, and down; and their changes.
struct Path {
  double ahead, aside, down, d_ahead, d_aside, d_down;
};

Path path_of(const double* x, const double* dx) {
  const double sr = std::sin(x[TR_ROLL]), cr = std::cos(x[TR_ROLL]);
  const double sp = std::sin(x[TR_PITCH]), cp = std::cos(x[TR_PITCH]);
  // Turned back by the bank angle, then by the pitch angle.
  const double below = x[TR_V] * sr + x[TR_W] * cr, aside = x[TR_V] * cr - x[TR_W] * sr;
  const double d_below = dx[TR_V] * sr + dx[TR_W] * cr + aside * dx[TR_ROLL];
  const double d_aside = dx[TR_V] * cr - dx[TR_W] * sr - below * dx[TR_ROLL];
  const double ahead = x[TR_U] * cp + below * sp, down = below * cp - x[TR_U] * sp;
  return {ahead,   aside,
          down,    dx[TR_U] * cp + d_below * sp + down * dx[TR_PITCH],
          d_aside, d_below * cp - dx[TR_U] * sp - ahead * dx[TR_PITCH]};
}

// Angle of the path above the horizon, and its change: none where it has no direction over the ground.
void flight_path_angle(const Path& p, double& angle, double& slope) {
  const double level = std::hypot(p.ahead, p.aside), speed = std::hypot(level, p.down);
  angle = speed < kAtRest ? 0 : std::atan2(-p.down, level);
  slope = 0;
  if (level < kAtRest) return;
  const double d_level = (p.ahead * p.d_ahead + p.aside * p.d_aside) / level;
  slope = (p.down * d_level - level * p.d_down) / (speed * speed);
}

// Of the numbers of tr_outputs.
void put_load_factors(double (&y)[kOutputs]) {
  constexpr int kForce = 3;
  for (int axis = 0; axis < 3; ++axis)
    y[kOutputNx + axis] = (axis == 2 ? -1 : 1) * y[kForce + axis] / kGravity;
}

bool is_a_state(const Flight& f, int output) {
  return output == kOutputRotorSpeed ? f.setting[kGovernor] == int{TR_GOVERNOR_PI}
                                     : f.setting[kConversion] != 0;
}

bool has_wheels(const Flight& f) { return f.setting[kEnvironment] != 0 && f.setting[kGear] != 0; }

}  // namespace

tr_status read_outputs(const Flight& f, double (&y)[kOutputs]) {
  tr_outputs outputs;
  const tr_status status = tr_get_outputs(&f.sim, &outputs);
  if (status != TR_OK) return status;
  std::memcpy(y, &outputs.airspeed_mps, sizeof(double) * TR_OUTPUTS);
  put_load_factors(y);
  tr_state now;
  tr_configuration c;
  tr_get_state(&f.sim, &now);
  tr_get_configuration(&f.sim, &c);
  constexpr double kStill[TR_STATES] = {};
  double slope = 0;
  flight_path_angle(path_of(now.x, kStill), y[kOutputFlightPath], slope);
  y[kOutputMast] = c.mast_deg * kRadians;
  y[kOutputFlap] = c.flap_deg * kRadians;
  y[kOutputRotorSpeed] = c.rotor_radps;
  for (int k = kOutputMast; k <= kOutputRotorSpeed; ++k)
    if (is_a_state(f, k)) y[k] = now.x[state_of_output(k)];
  return TR_OK;
}

void slopes_of_outputs(const Flight& f, const double* dx, const tr_outputs& found, double (&dy)[kOutputs]) {
  std::memcpy(dy, &found.airspeed_mps, sizeof(double) * TR_OUTPUTS);
  put_load_factors(dy);
  tr_state now;
  tr_get_state(&f.sim, &now);
  double angle = 0;
  flight_path_angle(path_of(now.x, dx), angle, dy[kOutputFlightPath]);
  for (int k = kOutputMast; k <= kOutputRotorSpeed; ++k)
    dy[k] = is_a_state(f, k) ? dx[state_of_output(k)] : 0;
}

tr_status read_indicators(const Flight& f, double (&height)[kWheels]) {
  for (double& each : height) each = 1;
  return has_wheels(f) ? tr_wheel_heights(&f.sim, nullptr, height, nullptr) : TR_OK;
}

tr_status slopes_of_indicators(const Flight& f, const double* dx, double (&slope)[kWheels]) {
  double height[kWheels];
  for (double& each : slope) each = 0;
  return has_wheels(f) ? tr_wheel_heights(&f.sim, dx, height, slope) : TR_OK;
}

}  // namespace tiltrotor_fmu

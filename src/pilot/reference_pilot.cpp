#include "pilot/reference_pilot.hpp"

#include <algorithm>
#include <cmath>

#include "tiltrotor/math/smooth.hpp"
#include "tiltrotor/model/rigid_body.hpp"
#include "tiltrotor/model/variables/control_range.hpp"

namespace tiltrotor::pilot {

namespace {

constexpr double kDegree = kRadPerDeg<double>;

// How references move: bandwidths in rad/s, and ends.
constexpr double kSpeedReference = 0.5, kHeightReference = 0.4, kClimbReference = 1.0,
                 kHeadingReference = 0.6;
constexpr double kTurnReference = 1.5;
constexpr double kAcceleration = 1.5, kVerticalAcceleration = 1.5;  // m/s^2
constexpr double kAccelerationLag = 1;                              // s
constexpr double kAheadSpeed = 6, kAheadHeight = 10;  // m/s, m: they wait for an aircraft that cannot follow
constexpr double kClimb = 6;                          // m/s, on the way to a height
constexpr double kBank = 20 * kDegree, kRolling = 8 * kDegree;  // rad, rad/s
constexpr double kTurn = 12 * kDegree;                          // rad/s; rad/s^2 as well
constexpr double kPositionSpeed = 5, kTrackSpeed = 5;           // m/s, on the way to a place
// How they are followed, rad/s.
constexpr double kSpeed = 0.4, kClimbing = 0.6, kHeight = 0.2, kHeading = 0.3, kPosition = 0.2;
constexpr double kSideOverGround = 0.5, kSideThroughAir = 0.1;  // in forward flight the fins look after it
constexpr double kYawOverGround = 1.0, kYawThroughAir = 0.2;    // there a turn is a matter of bank
constexpr double kIntegral = 0.1, kLateralIntegral = 0.5;
// Attitudes about those of the trim, rad.
constexpr double kPitchRange = 15 * kDegree, kBankRange = 30 * kDegree;
constexpr double kGroundSpeed = 10, kAirSpeed = 30;  // m/s: below, the ground counts, above the air
constexpr double kLeastSpeed = 5;                    // m/s, where a speed divides
constexpr double kLowering = 2;                      // m/s^2: thrust is taken off on the ground

double within(double x, double size) { return std::clamp(x, -size, size); }

// Two outputs, or how fast they change.
struct Pair {
  double first, second;
};
double times(const double (&gain)[2], const Pair& y) { return gain[0] * y.first + gain[1] * y.second; }

struct Seen {
  double forward, side;  // m/s, of what counts at this speed
  double climb, pitch_rate, roll_rate, turn_rate;
  double over_ground, course;
  double air;  // 0: it is the ground that counts, 1: the air
};

Seen look(const PilotSees& sees, double reference_speed) {
  const double cosine = std::cos(sees.yaw), sine = std::sin(sees.yaw);
  const double north = sees.ground_velocity.x, east = sees.ground_velocity.y;
  const double forward = cosine * north + sine * east, side = -sine * north + cosine * east;
  const double air = smooth_step((std::fabs(reference_speed) - kGroundSpeed) / (kAirSpeed - kGroundSpeed));
  const double q = sees.rates.y, r = sees.rates.z;
  const double turn = (q * std::sin(sees.roll) + r * std::cos(sees.roll)) / std::cos(sees.pitch);
  return {forward + air * (sees.airspeed - forward),
          side + air * (sees.side_airspeed - side),
          -sees.ground_velocity.z,
          q * std::cos(sees.roll) - r * std::sin(sees.roll),
          sees.rates.x + std::sin(sees.pitch) * turn,
          turn,
          std::hypot(north, east),
          std::atan2(east, north),
          air};
}

void begin(const PilotSees& sees, const PilotGains& gains, PilotMemory& m) {
  m = {};
  m.has_begun = true;
  const Seen seen = look(sees, sees.airspeed);
  m.speed = seen.forward;
  m.height = sees.height;
  m.climb = seen.climb;
  m.heading = sees.yaw;
  m.turn_rate = seen.turn_rate;
  m.last = {gains.collective, gains.long_stick, 0, 0, gains.throttle};
}

void move_longitudinal_reference(const PilotAims& aims, const PilotSees& sees, const Seen& seen, double speed,
                                 double dt, PilotMemory& m) {
  if (aims.holds_speed || aims.holds_position) {
    const double wanted = within(kSpeedReference * (speed - m.speed), kAcceleration);
    m.acceleration += std::min(dt / kAccelerationLag, 1.0) * (wanted - m.acceleration);
    m.speed = seen.forward + within(m.speed + dt * m.acceleration - seen.forward, kAheadSpeed);
  } else {
    m.speed = seen.forward;
    m.acceleration = 0;
  }
  if (aims.vertical == Vertical::released) {
    m.climb = seen.climb;
    m.climb_rate = 0;
  } else {
    const double climb = aims.vertical == Vertical::climb
                             ? aims.climb
                             : within(kHeightReference * (aims.height - m.height), kClimb);
    m.climb_rate = within(kClimbReference * (climb - m.climb), kVerticalAcceleration);
    m.climb += dt * m.climb_rate;
  }
  const double above = m.height + dt * m.climb - sees.height;
  m.height = sees.height + (aims.vertical == Vertical::height ? within(above, kAheadHeight) : 0);
}

// Acceleration of the reference's turn.
double move_lateral_reference(const PilotAims& aims, const PilotSees& sees, const Seen& seen, double dt,
                              PilotMemory& m) {
  const double most =
      std::min(kTurn, kGravity<double> * std::tan(kBank) / std::fmax(seen.forward, kLeastSpeed));
  double turn = seen.turn_rate;
  switch (aims.lateral) {
    case Lateral::heading:
      turn = within(kHeadingReference * wrapped(aims.heading - m.heading), most);
      break;
    case Lateral::turn:
      turn = within(aims.turn_rate, most);
      break;
    case Lateral::track: {
      const double off =
          -std::sin(aims.track) * (sees.north - aims.north) + std::cos(aims.track) * (sees.east - aims.east);
      const double back =
          std::atan2(within(kPosition * off, kTrackSpeed), std::fmax(seen.over_ground, kLeastSpeed));
      turn = within(kHeadingReference * wrapped(aims.track - back - seen.course), most);
      break;
    }
    case Lateral::released:
      m.turn_rate = seen.turn_rate;
      m.heading = sees.yaw;
      return 0;
  }
  const double fastest = std::min(kTurn, kGravity<double> * kRolling / std::fmax(seen.forward, kLeastSpeed));
  const double acceleration = within(kTurnReference * (turn - m.turn_rate), fastest);
  m.turn_rate += dt * acceleration;
  m.heading = aims.lateral == Lateral::heading ? wrapped(m.heading + dt * m.turn_rate) : sees.yaw;
  return acceleration;
}

// The hand on its way to `wanted`; tells whether it gets there.
bool reach_for(double wanted, double low, double high, double step, double& hand) {
  const double target = std::clamp(wanted, low, high);
  hand = std::clamp(target, hand - step, hand + step);
  hand = std::clamp(hand, low, high);
  return target == wanted;
}

// An integral waits while what it moves is at its end, and then forgets slowly.
void integrate(double rate, bool is_free, double dt, double& integral) {
  constexpr double forgetting = 0.1;  // 1/s
  integral += dt * (is_free ? rate : -forgetting * integral);
}

}  // namespace

PilotReach pilot_reach(const Aircraft<double>& aircraft) {
  const auto range = [&](int control) { return control_range(aircraft, control); };
  const Bounds<double> collective = range(kControlIndex.collective), lon = range(kControlIndex.long_stick),
                       lat = range(kControlIndex.lat_stick), pedal = range(kControlIndex.pedal);
  constexpr double collective_rate = 15 * kDegree, travels = 1, throttle_rate = 0.3;  // rad/s, 1/s, 1/s
  return {{collective.low, lon.low, lat.low, pedal.low, 0},
          {collective.high, lon.high, lat.high, pedal.high, 1},
          {collective_rate, travels * (lon.high - lon.low), travels * (lat.high - lat.low),
           travels * (pedal.high - pedal.low), throttle_rate}};
}

PilotOutput reference_pilot(const PilotAims& aims, const PilotSees& sees, const PilotGains& gains,
                            Thrust thrust, const PilotReach& reach, double dt, PilotMemory& m) {
  if (!m.has_begun) begin(sees, gains, m);
  const Seen seen = look(sees, m.speed);

  // Position becomes speeds over the ground.
  double speed = aims.speed, side_speed = 0;
  if (aims.holds_position) {
    const double north = aims.north - sees.north, east = aims.east - sees.east;
    const double cosine = std::cos(sees.yaw), sine = std::sin(sees.yaw);
    speed = within(kPosition * (cosine * north + sine * east), kPositionSpeed);
    side_speed = within(kPosition * (-sine * north + cosine * east), kPositionSpeed);
  }
  move_longitudinal_reference(aims, sees, seen, speed, dt, m);
  const double turn_acceleration = move_lateral_reference(aims, sees, seen, dt, m);

  // What is to stay, and what is to change: references, errors, and what is left of them over time.
  const double height_error = aims.vertical == Vertical::height ? m.height - sees.height : 0;
  const double yaw_error = aims.lateral == Lateral::heading ? wrapped(m.heading - sees.yaw) : 0;
  const bool turns = aims.lateral != Lateral::released;
  const double turn = turns ? m.turn_rate + kHeading * yaw_error : 0;
  const double side_gain = kSideOverGround + seen.air * (kSideThroughAir - kSideOverGround);
  const double yaw_gain = kYawOverGround + seen.air * (kYawThroughAir - kYawOverGround);
  const double forward_error = kSpeed * (m.speed - seen.forward);
  const double upward_error = kClimbing * (m.climb + kHeight * height_error - seen.climb);
  const double side_error = side_gain * (side_speed - seen.side);
  const double turn_error = turns ? yaw_gain * (turn - seen.turn_rate) : 0;
  const double load = kGravity<double> * (1 / std::cos(within(sees.roll, kBankRange)) - 1);
  const Pair forward_upward{m.speed - gains.speed + m.forward, m.climb + m.upward};
  const Pair faster{m.acceleration + forward_error + kIntegral * m.forward,
                    m.climb_rate + load + upward_error + kIntegral * m.upward};
  const Pair sideward_turning{side_speed + m.sideward, turn + m.turning};
  const Pair more{side_error + kLateralIntegral * m.sideward,
                  turn_acceleration + turn_error + kLateralIntegral * m.turning};

  // They need attitudes and levers.
  const Needs &lon = gains.longitudinal, &lat = gains.lateral;
  const double pitch_change =
      times(lon.steady.attitude, forward_upward) + times(lon.changing.attitude, faster);
  const double pitch = gains.pitch + within(pitch_change, kPitchRange);
  const double lever_change = times(lon.steady.lever, forward_upward) + times(lon.changing.lever, faster);
  const double bank_wanted =
      std::atan(times(lat.steady.attitude, sideward_turning)) + times(lat.changing.attitude, more);
  const double bank = within(bank_wanted, kBankRange);
  const double pedal = times(lat.steady.lever, sideward_turning) + times(lat.changing.lever, more) +
                       gains.yaw_damping * (turn - seen.turn_rate);

  // Attitudes become sticks.
  const AttitudeGains &by_long = gains.pitch_by_stick, &by_lat = gains.roll_by_stick;
  const double pitch_error = pitch - sees.pitch, bank_error = bank - sees.roll;
  const double long_stick = gains.long_stick + times(lon.steady.stick, forward_upward) +
                            times(lon.changing.stick, faster) + by_long.angle * pitch_error -
                            by_long.rate * seen.pitch_rate + m.long_stick;
  const double lat_stick = times(lat.steady.stick, sideward_turning) + times(lat.changing.stick, more) +
                           by_lat.angle * bank_error - by_lat.rate * seen.roll_rate + m.lat_stick;

  const bool by_collective = thrust == Thrust::collective;
  const double collective =
      gains.collective + (by_collective ? lever_change : gains.following * lever_change);
  const double throttle = gains.throttle + (by_collective ? gains.following * lever_change : lever_change);
  const PilotOutput &low = reach.low, &high = reach.high, &rate = reach.rate;
  const bool has_collective =
      reach_for(collective, low.collective, high.collective, dt * rate.collective, m.last.collective);
  const bool has_throttle =
      reach_for(throttle, low.throttle, high.throttle, dt * rate.throttle, m.last.throttle);
  const bool has_long =
      reach_for(long_stick, low.long_stick, high.long_stick, dt * rate.long_stick, m.last.long_stick);
  const bool has_lat =
      reach_for(lat_stick, low.lat_stick, high.lat_stick, dt * rate.lat_stick, m.last.lat_stick);
  const bool has_pedal = reach_for(pedal, low.pedal, high.pedal, dt * rate.pedal, m.last.pedal);

  // Integrals move while everything they move is free.
  const bool flies = !sees.is_on_ground;
  const bool lon_free = flies && has_long && !aims.taken.long_stick && !aims.taken.thrust &&
                        (by_collective ? has_collective : has_throttle) &&
                        pitch == gains.pitch + pitch_change;
  const bool lat_free =
      flies && has_lat && has_pedal && !aims.taken.lat_stick && !aims.taken.pedal && bank == bank_wanted;
  const bool lowers = sees.is_on_ground && aims.vertical == Vertical::climb && aims.climb < 0;
  integrate(forward_error, lon_free, dt, m.forward);
  integrate(lowers ? -kLowering : upward_error, lon_free || lowers, dt, m.upward);
  integrate(side_error, lat_free, dt, m.sideward);
  integrate(turn_error, lat_free, dt, m.turning);
  integrate(by_long.integral * pitch_error, flies && has_long && !aims.taken.long_stick, dt, m.long_stick);
  integrate(by_lat.integral * bank_error, flies && has_lat && !aims.taken.lat_stick, dt, m.lat_stick);
  return m.last;
}

}  // namespace tiltrotor::pilot

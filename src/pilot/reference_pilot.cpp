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
constexpr double kVerticalAcceleration = 1.5;         // m/s^2
constexpr double kAccelerationLag = 1;                // s
constexpr double kAheadSpeed = 6, kAheadHeight = 10;  // m/s, m: they wait for an aircraft that cannot follow
constexpr double kBank = 20 * kDegree, kRolling = 8 * kDegree;  // rad, rad/s
constexpr double kTurn = 12 * kDegree;                          // rad/s; rad/s^2 as well
constexpr double kPositionSpeed = 5, kTrackSpeed = 5;           // m/s, on the way to a place
// How they are followed, rad/s.
constexpr double kSpeed = 0.4, kClimbing = 0.93, kHeight = 0.13, kHeading = 0.3, kPosition = 0.2;
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
    const double wanted = within(kSpeedReference * (speed - m.speed), aims.acceleration);
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
                             : within(kHeightReference * (aims.height - m.height), aims.most_climb);
    m.climb_rate = within(kClimbReference * (climb - m.climb), kVerticalAcceleration);
    m.climb += dt * m.climb_rate;
  }
  const double above = m.height + dt * m.climb - sees.height;
  m.height = sees.height + (aims.vertical == Vertical::height ? within(above, kAheadHeight) : 0);
}

// Turn rate that leads to what is told.
double turn_told(const PilotAims& aims, const PilotSees& sees, const Seen& seen, double heading) {
  switch (aims.lateral) {
    case Lateral::heading:
      return kHeadingReference * wrapped(aims.heading - heading);
    case Lateral::turn:
      return aims.turn_rate;
    case Lateral::track: {
      const double off =
          -std::sin(aims.track) * (sees.north - aims.north) + std::cos(aims.track) * (sees.east - aims.east);
      const double back =
          std::atan2(within(kPosition * off, kTrackSpeed), std::fmax(seen.over_ground, kLeastSpeed));
      return kHeadingReference * wrapped(aims.track - back - seen.course);
    }
    case Lateral::released:
      break;
  }
  return seen.turn_rate;
}

// Acceleration of the reference's turn.
double move_lateral_reference(const PilotAims& aims, const PilotSees& sees, const Seen& seen, double dt,
                              PilotMemory& m) {
  const double speed = std::fmax(seen.forward, kLeastSpeed);
  const double most = std::min(kTurn, kGravity<double> * std::tan(kBank) / speed);
  const double fastest = std::min(kTurn, kGravity<double> * kRolling / speed);
  const double told = within(turn_told(aims, sees, seen, m.heading), most);
  const bool is_released = aims.lateral == Lateral::released;
  const double acceleration = is_released ? 0 : within(kTurnReference * (told - m.turn_rate), fastest);
  m.turn_rate = is_released ? seen.turn_rate : m.turn_rate + dt * acceleration;
  m.heading = aims.lateral == Lateral::heading ? wrapped(m.heading + dt * m.turn_rate) : sees.yaw;
  return acceleration;
}

// Speeds to stay at and accelerations to make, of the two halves: forward and upward, sideward and turning. `error`: the
// part of the accelerations that the present errors ask for, which are integrated.
struct Wishes {
  Pair stay[2], change[2], error[2];
  double turn;  // rad/s
};
enum Half { longitudinal, lateral };

Wishes wish(const PilotAims& aims, const PilotSees& sees, const Seen& seen, const PilotGains& gains,
            double dt, PilotMemory& m) {
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

  const double height_error = aims.vertical == Vertical::height ? m.height - sees.height : 0;
  const double yaw_error = aims.lateral == Lateral::heading ? wrapped(m.heading - sees.yaw) : 0;
  const bool turns = aims.lateral != Lateral::released;
  const double turn = turns ? m.turn_rate + kHeading * yaw_error : 0;
  const double side_gain = kSideOverGround + seen.air * (kSideThroughAir - kSideOverGround);
  const double yaw_gain = kYawOverGround + seen.air * (kYawThroughAir - kYawOverGround);
  const Pair lon{kSpeed * (m.speed - seen.forward),
                 kClimbing * (m.climb + kHeight * height_error - seen.climb)};
  const Pair lat{side_gain * (side_speed - seen.side), turns ? yaw_gain * (turn - seen.turn_rate) : 0};
  const double load = kGravity<double> * (1 / std::cos(within(sees.roll, kBankRange)) - 1);
  return {
      {{m.speed - gains.speed + m.forward, m.climb + m.upward}, {side_speed + m.sideward, turn + m.turning}},
      {{m.acceleration + lon.first + kIntegral * m.forward,
        m.climb_rate + load + lon.second + kIntegral * m.upward},
       {lat.first + kLateralIntegral * m.sideward,
        turn_acceleration + lat.second + kLateralIntegral * m.turning}},
      {lon, lat},
      turn};
}

// The hand on its way to `wanted`; tells whether that lies within its travel.
bool reach_for(double wanted, double PilotOutput::*hand, const PilotReach& reach, double dt,
               PilotOutput& at) {
  const double step = dt * reach.rate.*hand;
  const double target = std::clamp(wanted, reach.low.*hand, reach.high.*hand);
  at.*hand =
      std::clamp(std::clamp(target, at.*hand - step, at.*hand + step), reach.low.*hand, reach.high.*hand);
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
  const Wishes wishes = wish(aims, sees, seen, gains, dt, m);

  // Wishes need attitudes and levers.
  const Needs &lon = gains.longitudinal, &lat = gains.lateral;
  const Pair &stay_lon = wishes.stay[longitudinal], &change_lon = wishes.change[longitudinal];
  const Pair &stay_lat = wishes.stay[lateral], &change_lat = wishes.change[lateral];
  const double pitch_change = times(lon.steady.attitude, stay_lon) + times(lon.changing.attitude, change_lon);
  const double pitch = gains.pitch + within(pitch_change, kPitchRange);
  const double lever_change = times(lon.steady.lever, stay_lon) + times(lon.changing.lever, change_lon);
  const double bank_wanted =
      std::atan(times(lat.steady.attitude, stay_lat)) + times(lat.changing.attitude, change_lat);
  const double bank = within(bank_wanted, kBankRange);

  // Attitudes need sticks.
  const AttitudeGains &by_long = gains.pitch_by_stick, &by_lat = gains.roll_by_stick;
  const double pitch_error = pitch - sees.pitch, bank_error = bank - sees.roll;
  const bool by_collective = thrust == Thrust::collective;
  const double following = gains.following * lever_change;
  const PilotOutput wanted = {gains.collective + (by_collective ? lever_change : following),
                              gains.long_stick + times(lon.steady.stick, stay_lon) +
                                  times(lon.changing.stick, change_lon) + by_long.angle * pitch_error -
                                  by_long.rate * seen.pitch_rate + m.long_stick,
                              times(lat.steady.stick, stay_lat) + times(lat.changing.stick, change_lat) +
                                  by_lat.angle * bank_error - by_lat.rate * seen.roll_rate + m.lat_stick,
                              times(lat.steady.lever, stay_lat) + times(lat.changing.lever, change_lat) +
                                  gains.yaw_damping * (wishes.turn - seen.turn_rate),
                              gains.throttle + (by_collective ? following : lever_change)};
  const auto has = [&](double PilotOutput::*hand) {
    return reach_for(wanted.*hand, hand, reach, dt, m.last);
  };
  const bool has_collective = has(&PilotOutput::collective), has_throttle = has(&PilotOutput::throttle);
  const bool has_long = has(&PilotOutput::long_stick), has_lat = has(&PilotOutput::lat_stick);
  const bool has_pedal = has(&PilotOutput::pedal);

  // Integrals move while everything they move is free.
  const Taken& taken = aims.taken;
  const bool flies = !sees.is_on_ground;
  const bool lon_free = flies && has_long && (by_collective ? has_collective : has_throttle) &&
                        pitch == gains.pitch + pitch_change && !taken.long_stick && !taken.thrust;
  const bool lat_free =
      flies && has_lat && has_pedal && bank == bank_wanted && !taken.lat_stick && !taken.pedal;
  const bool lowers = sees.is_on_ground && aims.vertical == Vertical::climb && aims.climb < 0;
  integrate(wishes.error[longitudinal].first, lon_free, dt, m.forward);
  integrate(lowers ? -kLowering : wishes.error[longitudinal].second, lon_free || lowers, dt, m.upward);
  integrate(wishes.error[lateral].first, lat_free, dt, m.sideward);
  integrate(wishes.error[lateral].second, lat_free, dt, m.turning);
  integrate(by_long.integral * pitch_error, flies && has_long && !taken.long_stick, dt, m.long_stick);
  integrate(by_lat.integral * bank_error, flies && has_lat && !taken.lat_stick, dt, m.lat_stick);
  return m.last;
}

}  // namespace tiltrotor::pilot

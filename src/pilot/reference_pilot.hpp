// A pilot who flies what he is told, to fly missions the same way every time: speed, height or climb, heading, turn or
// track, and position, from hover to airplane mode. No part of the aircraft and no autopilot to copy.
//
// What is told becomes a smooth reference with limited acceleration, climb and bank. The reference and its errors are
// speeds to stay at and accelerations to make; these need pitch, bank, thrust and pedal (pilot_gains.hpp); attitudes need
// sticks. A pure function of its arguments: what it carries on stands in PilotMemory.
#pragma once

#include "pilot/pilot_gains.hpp"
#include "tiltrotor/model/aircraft/aircraft.hpp"

namespace tiltrotor::pilot {

enum class Vertical : unsigned char { released, height, climb };
enum class Lateral : unsigned char { released, heading, turn, track };

// Inceptors that someone else moves: what they are for is not integrated meanwhile.
struct Taken {
  bool thrust, long_stick, lat_stick, pedal;
};

// The loops that are on, and what they hold.
struct PilotAims {
  bool holds_speed;
  double speed;               // m/s, forward: over the ground below 10 m/s, through the air above 30 m/s
  double acceleration = 1.5;  // m/s^2, on the way there
  Vertical vertical;
  double height;          // m above the ground
  double most_climb = 6;  // m/s, on the way there
  double climb;           // m/s, + up
  Lateral lateral;
  double heading;       // rad
  double turn_rate;     // rad/s, + right
  double track;         // rad, direction of a line through `north`, `east`
  bool holds_position;  // at `north`, `east`; instead of `speed`, at low speed
  double north, east;   // m
  Taken taken;
};

struct PilotSees {
  double mast_deg;
  double airspeed;               // m/s, forward component, level
  double side_airspeed;          // m/s, to the right, level
  double north, east, height;    // m, height above the ground
  Vec3<double> ground_velocity;  // north, east, down, m/s
  double roll, pitch, yaw;       // rad
  Vec3<double> rates;            // p q r, rad/s
  bool is_on_ground;             // weight on a wheel
};

struct PilotOutput {
  double collective;                    // rad
  double long_stick, lat_stick, pedal;  // in
  double throttle;                      // of every engine, 0..1
};

// Where inceptors end and how fast a hand moves them.
struct PilotReach {
  PilotOutput low, high;
  PilotOutput rate;  // per second
};
PilotReach pilot_reach(const Aircraft<double>& aircraft);

// Which lever leads; the other follows by PilotGains::following.
enum class Thrust : unsigned char { collective, throttle };

// Begins as PilotMemory{}: references start where the aircraft is, hands at the trim of the gains.
struct PilotMemory {
  bool has_begun;
  // References: m/s, m/s^2, m, rad, rad/s.
  double speed, acceleration, height, climb, climb_rate, heading, turn_rate;
  // Integrals: m/s, rad/s; in.
  double forward, upward, sideward, turning, long_stick, lat_stick;
  PilotOutput last;
};

// What the pilot does for the next dt (s, up to 0.05). `gains`: at the mast angle and, where speed is held, at
// memory.speed, which needs nothing of the speed that is flown. Integrals wait where an inceptor or an attitude is at its
// end, on the ground and while inceptors are taken. Cost: some hundred operations.
PilotOutput reference_pilot(const PilotAims& aims, const PilotSees& sees, const PilotGains& gains,
                            Thrust thrust, const PilotReach& reach, double dt, PilotMemory& memory);

}  // namespace tiltrotor::pilot

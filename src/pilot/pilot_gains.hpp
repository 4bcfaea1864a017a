// Gains of the reference pilot at one flight condition, by rule from the linear model there.
//
// Two halves, longitudinal and lateral, of one pattern. Within: an attitude held by its stick. Around it, two outputs
// held by that attitude and a lever:
//
//   forward speed and height        by  pitch and thrust (collective or throttle),
//   sideward speed and yaw rate     by  bank and pedal.
//
// Which of the two does what changes with the masts: at mast 0 pitch is for speed and thrust for height, at mast 90 the
// other way round, and between both do both. The rule needs to know nothing of that: it inverts the two by two response
// of the aircraft whose attitude is held, at the bandwidth of the outer loops.
#pragma once

#include "tiltrotor/analysis/linear/reduction.hpp"

namespace tiltrotor::pilot {

// Stick in inches from angle and rate of an attitude.
struct AttitudeGains {
  double angle;     // in/rad
  double rate;      // in/(rad/s)
  double integral;  // in/(rad s)
};

// Attitude (rad), the stick that holds it (in), and lever (rad, in or part of the throttle) per unit of two outputs.
struct Inverse {
  double attitude[2], stick[2], lever[2];
};

// What two outputs need: steady to stay at a value, changing besides while they change (per unit a second).
// attitude, lever = steady y + changing dy/dt, the response inverted at zero and at the bandwidth of the loops.
struct Needs {
  Inverse steady, changing;
};

struct PilotGains {
  // The condition, and what the pilot holds there: m/s, rad, rad, 0..1, in.
  double mast_deg, speed;
  double pitch, collective, throttle, long_stick;
  AttitudeGains pitch_by_stick, roll_by_stick;
  double yaw_damping;  // in/(rad/s), pedal
  Needs longitudinal;  // forward speed and climb, by pitch and the leading lever of thrust
  Needs lateral;       // sideward speed and turn rate, by bank and pedal
  double following;    // the other lever of thrust per unit of the leading one

  template <class Self, class Visit>
  static void each(Self& g, Visit&& visit) {
    for (auto* part : {&g.mast_deg, &g.speed, &g.pitch, &g.collective, &g.throttle, &g.long_stick,
                       &g.following, &g.yaw_damping})
      visit(*part);
    for (auto* part : {&g.pitch_by_stick, &g.roll_by_stick}) {
      visit(part->angle), visit(part->rate), visit(part->integral);
    }
    for (auto* half : {&g.longitudinal, &g.lateral}) {
      for (auto* part : {&half->steady, &half->changing})
        for (int i = 0; i < 2; ++i) visit(part->attitude[i]), visit(part->stick[i]), visit(part->lever[i]);
    }
  }
};

// Augmentation that flies along: what it adds to the sticks and the pedal, in/(rad/s), signs included.
struct RateFeedback {
  double long_stick_per_q, lat_stick_per_p, pedal_per_r;
};

// What the pilot wants, rad/s; the augmentation of the XV-15 has rate time constants of 0.4 to 0.6 s.
struct PilotRule {
  double attitude = 2.2;      // bandwidth of the attitudes
  double damping = 0.8;       // and their damping ratio
  double attitude_lag = 0.2;  // integral of the attitude error over its proportional part, 1/s
  double yaw_rate = 1 / 0.6;  // of the rate of the heading
  double outer = 0.5;         // where the response of speed, height, side and yaw is inverted
};

// Gains from A and B at a trim in level flight: `model` has the columns of kInceptors. Where another lever than
// collective leads (throttle, of a governed rotor), its column stands in place of that of collective. `following`
// and the trim of the throttle are left 0. Status: ok; bad_argument: other columns, or fewer than the eight states of
// the body; singular: a stick, or a lever, without effect. Cost: a residualisation.
Status pilot_gains(const LinearModel<double>& model, const RateFeedback& augmentation, const PilotRule& rule,
                   PilotGains& gains);

// Part of the way from a to b, 0..1.
PilotGains between(const PilotGains& a, const PilotGains& b, double part);

}  // namespace tiltrotor::pilot

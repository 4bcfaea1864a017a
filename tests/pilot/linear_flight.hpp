// The reference pilot around a linear model of the aircraft: actuators, rate augmentation, motion in space.
#pragma once

#include <cmath>
#include <ostream>

#include "analysis/analysis_case.hpp"
#include "pilot/reference_pilot.hpp"

namespace pilot_case {

using namespace analysis_case;
using namespace tiltrotor::pilot;

struct Condition {
  double mast_deg, speed;
};
inline std::ostream& operator<<(std::ostream& out, const Condition& c) {
  return out << "mast " << c.mast_deg << " deg, " << c.speed << " m/s";
}
inline constexpr Condition kConditions[] = {{0, 0},   {0, 20},  {0, 40},  {30, 50}, {30, 60},
                                            {60, 70}, {75, 75}, {90, 90}, {90, 110}};

inline constexpr double kDt = 0.02;  // s, of the pilot
inline constexpr int kParts = 8;     // steps of the aircraft within

// Motion of a linear model in space.
struct Flown {
  double x[kMaxLinearStates];  // about the trim
  double yaw, north, east, height;
  double lever[4];  // of the controls, about the trim, behind their lag
};
inline constexpr int kSpace = 8;

// Rate augmentation with the time constants 0.4, 0.4 and 0.6 s, as the aircraft's.
inline RateFeedback augmentation(const LinearModel<double>& model) {
  static ResidualisationWorkspace<double> work;
  static LinearModel<double> body;
  CHECK(residualise(model, work, body) == Status::ok);
  const auto feedback = [](double own, double effect, double time) { return (-1 / time - own) / effect; };
  return {feedback(body.a(2, 2), body.b(2, 1), 0.4), feedback(body.a(5, 5), body.b(5, 2), 0.4),
          feedback(body.a(7, 7), body.b(7, 3), 0.6)};
}

class LinearFlight {
 public:
  LinearFlight(const Condition& condition, bool is_augmented) {
    const Configuration<double> c = flown_configuration(condition.mast_deg);
    const TrimResult<double> r = trimmed(c, flown(level(condition.speed)));
    CHECK(is_trimmed(r.status));
    linear_model(c, r.state, r.controls, kInceptors, model);
    if (is_augmented) help = augmentation(model);
    CHECK(pilot_gains(model, help, PilotRule{}, gains) == Status::ok);
    gains.mast_deg = condition.mast_deg;
    reach = pilot_reach(aircraft_data<double>());
    CHECK_NEAR(gains.speed, this_aircraft::speed() * condition.speed, 1e-9);
    aims = {};
    aims.holds_speed = true;
    aims.speed = gains.speed;
    aims.vertical = Vertical::height;
    aims.height = height;
    aims.lateral = Lateral::heading;
  }

  PilotSees see(const Flown& f) const {
    const double* const d = f.x;
    double x[kRigidStates];
    for (int i = 0; i < kRigidStates; ++i) x[i] = model.x[i] + d[i];
    const double u = x[0], w = x[1], v = x[4], roll = x[6], pitch = x[3];
    const double across = v * std::cos(roll) - w * std::sin(roll),
                 down = v * std::sin(roll) + w * std::cos(roll);
    const double forward = u * std::cos(pitch) + down * std::sin(pitch);
    PilotSees s{};
    s.mast_deg = gains.mast_deg;
    s.airspeed = forward;
    s.side_airspeed = across;
    s.north = f.north, s.east = f.east, s.height = f.height;
    s.ground_velocity = {forward * std::cos(f.yaw) - across * std::sin(f.yaw),
                         forward * std::sin(f.yaw) + across * std::cos(f.yaw),
                         -u * std::sin(pitch) + down * std::cos(pitch)};
    s.roll = roll, s.pitch = pitch, s.yaw = f.yaw;
    s.rates = {x[5], x[2], x[7]};
    return s;
  }

  // One step of pilot and aircraft.
  void step(Flown& f, PilotMemory& memory) const {
    const PilotOutput o = reference_pilot(aims, see(f), gains, Thrust::collective, reach, kDt, memory);
    const double pilot_input[4] = {o.collective, o.long_stick, o.lat_stick, o.pedal};
    const double dt = kDt / kParts;
    for (int part = 0; part < kParts; ++part) {  // classical Runge-Kutta of fourth order
      const Flown k1 = rates(f, pilot_input), k2 = rates(moved(f, k1, dt / 2), pilot_input),
                  k3 = rates(moved(f, k2, dt / 2), pilot_input), k4 = rates(moved(f, k3, dt), pilot_input);
      f = moved(moved(moved(moved(f, k1, dt / 6), k2, dt / 3), k3, dt / 3), k4, dt / 6);
    }
  }

  Flown at_rest() const {
    Flown f{};
    f.height = height;
    return f;
  }

  LinearModel<double> model;
  RateFeedback help{};
  PilotGains gains;
  PilotReach reach;
  PilotAims aims;
  double height = 50;  // m
  double lag = 0.02;   // s, of every control

 private:
  static Flown moved(const Flown& f, const Flown& rate, double dt) {
    Flown g = f;
    for (int i = 0; i < kMaxLinearStates; ++i) g.x[i] += dt * rate.x[i];
    g.yaw += dt * rate.yaw, g.north += dt * rate.north, g.east += dt * rate.east,
        g.height += dt * rate.height;
    for (int j = 0; j < 4; ++j) g.lever[j] += dt * rate.lever[j];
    return g;
  }
  Flown rates(const Flown& f, const double* pilot_input) const {
    const double feedback[4] = {0, help.long_stick_per_q * f.x[2], help.lat_stick_per_p * f.x[5],
                                help.pedal_per_r * f.x[7]};
    Flown rate{};
    for (int i = 0; i < model.states; ++i) {
      for (int j = 0; j < model.states; ++j) rate.x[i] += model.a(i, j) * f.x[j];
      for (int j = 0; j < 4; ++j) rate.x[i] += model.b(i, j) * (f.lever[j] + feedback[j]);
    }
    for (int j = 0; j < 4; ++j) rate.lever[j] = (pilot_input[j] - model.u[j] - f.lever[j]) / lag;
    const PilotSees s = see(f);
    rate.yaw = (s.rates.y * std::sin(s.roll) + s.rates.z * std::cos(s.roll)) / std::cos(s.pitch);
    rate.north = s.ground_velocity.x, rate.east = s.ground_velocity.y, rate.height = -s.ground_velocity.z;
    return rate;
  }
};

}  // namespace pilot_case

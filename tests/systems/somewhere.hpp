// Points anywhere in the envelope for tests of derivatives of the whole vehicle.
#pragma once

#include <random>

#include "tiltrotor/analysis/flight/instruments.hpp"
#include "vehicle_case.hpp"

namespace vehicle_case {

// A point somewhere in the envelope: not trimmed, not symmetric, its systems under way.
struct Somewhere {
  Configuration<double> c;
  Vehicle<double> v;
  State<double> x;
  SystemState<double> s;
  Controls<double> u;
  double azimuth = 0;  // of the first blade, rad
};

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) / 4294967296.0;
  }
  bool flip() { return random_() % 2 == 0; }

 private:
  std::mt19937 random_;
};

inline Somewhere somewhere(Dice& dice, Governor governor, const Options& options = realtime()) {
  const Aircraft<double>& aircraft = aircraft_data<double>();
  const double size = this_aircraft::speed();
  Somewhere at{};
  // Not at a knot of a table.
  const double mast = dice.between(0.3, 89.7), forward = dice.between(3, 30 + mast) * size;
  FlightSetup<double> setup = flight_setup(aircraft, mast);
  setup.options = options;
  setup.altitude = this_aircraft::altitude();
  setup.options.coning_states = dice.flip();
  CHECK(prepare(aircraft, setup, at.c) == Status::ok);

  const double tilt = mast * kDeg;
  at.x.velocity = {forward, dice.between(-4, 4) * size, dice.between(-4, 4) * size};
  at.x.rates = {dice.between(-0.3, 0.3), dice.between(-0.3, 0.3), dice.between(-0.3, 0.3)};
  at.x.roll = dice.between(-0.6, 0.6);
  at.x.pitch = dice.between(-0.3, 0.3);
  at.x.downwash = dice.between(0, 0.1);
  at.x.position.z = -dice.between(10, 500);
  for (const Side side : {right, left}) {
    RotorState<double>& rotor = at.x.rotor[side];
    rotor = {dice.between(-0.05, 0.05), dice.between(-0.05, 0.05), dice.between(-0.5, 0.5),
             dice.between(-0.5, 0.5),   dice.between(0.01, 0.06),  dice.between(-0.01, 0.01),
             dice.between(-0.01, 0.01)};
    at.x.coning[side] = {dice.between(0.02, 0.06), dice.between(-0.5, 0.5)};
  }
  // Blades at four degrees to the air that comes.
  const double axial = forward * std::sin(tilt) / (0.75 * at.c.tip_speed);
  at.u.collective = std::atan(axial) + dice.between(4, 10) * kDeg;
  at.u.long_stick = dice.between(-2, 2);
  at.u.lat_stick = dice.between(-2, 2);
  at.u.pedal = dice.between(-1, 1);
  at.u.gust = {dice.between(-2, 2), dice.between(-2, 2), dice.between(-2, 2)};

  Vehicle<double>& v = at.v;
  v.on = {governor, dice.flip(), dice.flip(), dice.flip(), dice.flip(), dice.flip(), dice.flip(), false};
  v.loaded_mass = at.c.setup.mass;
  v.gear_down = dice.flip();
  // Wheels a foot in the ground, or some metres above it.
  v.ground = {at.x.position.z + (dice.flip() ? 1.5 : 6) * this_aircraft::length(), 0.03, -0.02};
  v.brake[right] = 0.3;
  v.air_follows = dice.flip();
  v.altitude_origin = this_aircraft::altitude() + 100;
  v.engine_failed[left] = dice.between(0, 1) < 0.2;
  SystemState<double>& s = at.s;
  s.mast = tilt;
  s.mast_rate = dice.between(-0.1, 0.1);
  s.flap = at.c.setup.flap_deg * kDeg + dice.between(-0.2, -0.05);
  s.rotor_speed = at.c.setup.rotor_speed * dice.between(0.95, 1.05);
  v.on.interconnect = dice.flip();
  s.shaft_twist = dice.between(-0.02, 0.02);
  s.twist_rate = dice.between(-0.5, 0.5);
  s.governor = governor == Governor::pi ? dice.between(-0.1, 0.1) : 0;
  const Rates at_first = rates(v, at.c, at.x, s, at.u);  // for the engines to give about what the rotors take
  const double power = std::max(
      2e5, (at_first.airframe.torque[right] + at_first.airframe.torque[left]) * at.c.setup.rotor_speed);
  const double engines = v.engine_failed[left] && !v.on.engines ? 1 : 2;
  for (const Side side : {right, left}) {
    const double full = demanded_power(aircraft, at.c.air, 1.0);
    s.power[side] = std::min(power / engines, full) * dice.between(0.9, 1.1);
    v.commands.throttle[side] = s.power[side] / full;
  }
  for (double& way : s.series) way = dice.between(-0.8, 0.8);
  s.washout = dice.between(-0.1, 0.1);
  // Actuators as they follow, within their largest rate or beyond it.
  Controls<double> asked = at.u;
  asked.collective += s.governor;
  if (v.on.augmentation) {
    asked.long_stick += s.series[0];
    asked.lat_stick += s.series[1];
    asked.pedal += s.series[2];
  }
  const BladeControls<double> angles = vehicle_parts::wanted_angles(aircraft, at.c.setup.options, mast, asked,
                                                                    Vec3<double>(at.x.velocity - at.u.gust));
  const double away = dice.flip() ? 0.05 : 0.003;
  for (const Side side : {right, left}) {
    s.collective[side] = angles.collective[side] + dice.between(-away, away);
    s.long_cyclic[side] = angles.long_cyclic[side] + dice.between(-away, away);
  }
  s.elevator = angles.elevator + dice.between(-away, away);
  s.aileron = angles.aileron + dice.between(-away, away);
  s.rudder = angles.rudder + dice.between(-away, away);
  s.held_pitch = at.x.pitch + dice.between(-0.05, 0.05);
  s.held_roll = at.x.roll + dice.between(-0.05, 0.05);
  s.holds_pitch = dice.flip() ? 1 : 0;
  s.holds_roll = dice.flip() ? 1 : 0;
  v.commands.mast = tilt + dice.between(-0.2, 0.2);
  v.commands.flap = s.flap + dice.between(-0.1, 0.1);
  v.commands.rotor_speed = at.c.setup.rotor_speed;
  s.gear = v.gear_down && dice.between(0, 1) < 0.9 ? 1 : dice.between(0, 0.99);
  v.on.wind_shear = static_cast<WindShear>(static_cast<int>(dice.between(0, 3)));
  at.c.around.wind_n = {dice.between(-10, 10) * size, dice.between(-10, 10) * size, 0};
  // The search for its collective begins where it will end.
  for (int k = 0; k < 3 && governor == Governor::ideal; ++k)
    s.governor = rates(v, at.c, at.x, s, at.u).flows.governed;
  return at;
}

// Whether an ideal governor has found its collective there, and the power depends on it enough: a fifth of a rad for
// the power of an engine. Far from it no derivative has a meaning.
inline bool is_governed(const Somewhere& at) {
  const double engine = at.c.aircraft->controls.engine_power;
  const double efficiency = at.c.aircraft->controls.transmission_efficiency;
  const Rates r = rates(at.v, at.c, at.x, at.s, at.u);
  const auto excess = [&](double more) {
    Evaluation<double> e;
    Controls<double> u = r.demand.controls;
    u.collective += more;
    Configuration<double> c = at.c;
    put_into(r.demand, c);
    evaluate_aircraft(c, at.x, u, e);
    return (e.rotor[right].loads.torque + e.rotor[left].loads.torque) * c.setup.rotor_speed -
           efficiency * r.flows.power;
  };
  const double step = 1e-4;
  return std::fabs(r.flows.governed) < 0.3 && std::fabs(excess(0)) < 1e-9 * engine &&
         excess(step) - excess(0) > step * engine / 0.2;
}

// Rates and readings along a direction by a step along the imaginary axis.
struct Change {
  double of[vehicle_state_count], readings[Instruments<double>::kCount];
};
// Compiled once, in test_vehicle_linear.cpp.
Change complex_step(const Somewhere& at, const double* dx, const double* du);

}  // namespace vehicle_case

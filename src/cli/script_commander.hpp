// What the lines of a script do to a flight.
#pragma once

#include "cli/script_flight_state.hpp"
#include "tiltrotor/systems/vehicle_events.hpp"

namespace tiltrotor::cli {

struct ScriptCommander : ScriptFlightState {
  using ScriptFlightState::ScriptFlightState;

  void take_off() {
    if (!parked) return;
    parked = false;
    remarks.leaves_wheels();
    memory = {};
    const pilot::PilotSees sees = look();
    const SystemSwitches& on = flight.vehicle.on;
    reference_pilot(aims, sees, gains(), PilotTraining::thrust(on.governor), reach, 0, memory);
    memory.last = ground.hands;
  }

  void hold_thrust() {
    aims.taken.thrust = false;
    inputs.release({kControlIndex.collective, kFirstThrottle, kFirstThrottle + 1});
  }
  void hold_long_stick() {
    aims.taken.long_stick = false;
    inputs.release({kControlIndex.long_stick});
  }
  void hold_lateral() {
    aims.taken.lat_stick = aims.taken.pedal = false;
    inputs.release({kControlIndex.lat_stick, kControlIndex.pedal});
  }
  void aim_lateral(pilot::Lateral how) {
    aims.lateral = how;
    hold_lateral();
  }

  void engine(const ScriptEvent& e) {
    const int side = e.number[0] == 1 ? right : left;
    flight.vehicle.engine_failed[side] = e.word == 0;
  }

  // The switch on the legs keeps a gear that carries.
  void move_gear(bool down) {
    if (!down && moment.weight_on_wheels > 0) {
      remarks.ignored("gear up", time(), "with weight on the wheels");
      return;
    }
    flight.vehicle.gear_down = down;
  }

  void change_governor(Governor to) {
    Vehicle<double>& v = flight.vehicle;
    SystemState<double>& s = flight.state;
    if (v.on.governor == to) return;
    // The lever takes over what a governor had added that is off now, and the rotors turn as they do.
    const double left_over = hand_over(v, s, to);
    (parked ? ground.hands : memory.last).collective += left_over;
    inputs.shift(kControlIndex.collective, left_over);
    s.rotor_speed = v.commands.rotor_speed = c.setup.rotor_speed;
    c.setup.rotor_acceleration = 0;
  }

  // From the flight as it is, unless it is still on its way out.
  void engage_augmentation() {
    Vehicle<double>& v = flight.vehicle;
    SystemState<double>& s = flight.state;
    if (!v.on.augmentation) {
      const State<double> x = current_state(simulation);
      const Controls<double>& u = simulation.controls;
      const double airspeed = total_speed(x.velocity - u.gust, aircraft.smooth.airspeed);
      s.washout = x.rates.z - turn_rate_wanted(aircraft.systems.augmentation, airspeed, x.roll);
      s.rest_long = u.long_stick;
      s.rest_lat = u.lat_stick;
    }
    v.on.augmentation = true;
    v.disengages = false;
  }

  // The velocity over the ground stays.
  void change_wind(const Vec3<double>& told_n, WindShear shear) {
    const Vec3<double> before = wind();
    c.around.wind_n = told_n;
    flight.vehicle.on.wind_shear = shear;
    simulation.state.velocity = simulation.state.velocity - wind_in_body(wind() - before, simulation.state);
  }

  void release(std::size_t loop) {
    const bool all = loop == 4;
    if (all || loop == 0) aims.holds_speed = false;
    if (all || loop == 1) aims.vertical = pilot::Vertical::released;
    if (all || loop == 2) aims.lateral = pilot::Lateral::released;
    if (all || loop == 3) aims.holds_position = false;
    lands = lands && !(all || loop == 1);
  }

  void remark_on_wheels(const ScriptEvent& e) {
    using C = ScriptCommand;
    constexpr C climbs = C::hold_climb;
    const bool never = e.command == C::land || (e.command == climbs && e.number[0] <= 0);
    const bool later = e.command == C::hold_speed || e.command == C::hold_heading ||
                       e.command == C::hold_track || e.command == C::hold_position || e.command == C::turn;
    if (never) remarks.ignored(rule_of(e).name, time(), "on the wheels");
    if (later) remarks.waits(rule_of(e).name, time());
  }

  void obey(const ScriptEvent& e) {
    using C = ScriptCommand;
    if (parked) remark_on_wheels(e);
    Vehicle<double>& v = flight.vehicle;
    const double first = e.number[0];
    switch (e.command) {
      case C::mast:
        v.commands.mast = first * kRadPerDeg<double>;
        return;
      case C::flap:
        v.commands.flap = first * kRadPerDeg<double>;
        return;
      case C::rotor_speed:
        rotor_target = first;
        return;
      case C::spool:
        rotor_target = aircraft.rotor.speed_helicopter;
        return;
      case C::throttle:
        aims.taken.thrust = true;
        inputs.take(kFirstThrottle, first);
        inputs.take(kFirstThrottle + 1, e.count > 1 ? e.number[1] : first);
        return;
      case C::hold_speed:
        aims.holds_speed = true;
        aims.holds_position = false;
        aims.speed = first;
        aims.acceleration = e.count > 1 ? e.number[1] : pilot::PilotAims{}.acceleration;
        hold_thrust();
        hold_long_stick();
        return;
      case C::hold_height:
        aims.vertical = pilot::Vertical::height;
        aims.height = first;
        aims.most_climb = e.count > 1 ? e.number[1] : pilot::PilotAims{}.most_climb;
        lands = false;
        hold_thrust();
        hold_long_stick();
        take_off();
        return;
      case C::hold_climb:
        aims.vertical = pilot::Vertical::climb;
        aims.climb = first;
        lands = false;
        hold_thrust();
        hold_long_stick();
        if (first > 0) take_off();
        return;
      case C::hold_heading:
        aims.heading = first;
        aim_lateral(pilot::Lateral::heading);
        return;
      case C::hold_track:
        aims.track = first;
        aims.north = simulation.state.position.x;
        aims.east = simulation.state.position.y;
        aim_lateral(pilot::Lateral::track);
        return;
      case C::hold_position:
        aims.holds_position = true;
        aims.holds_speed = false;
        aims.north = simulation.state.position.x;
        aims.east = simulation.state.position.y;
        hold_thrust();
        hold_long_stick();
        hold_lateral();
        return;
      case C::turn:
        aims.turn_rate = first;
        aim_lateral(pilot::Lateral::turn);
        return;
      case C::release:
        release(e.word);
        return;
      case C::inceptor:
        inputs.take(e.control, first);
        note_taken(e.control);
        return;
      case C::step:
      case C::doublet:
        inputs.add(e);
        return;
      case C::series:
        for (const int input : script.series[e.series].input) note_taken(input);
        inputs.play(e);
        return;
      case C::scas:
        if (e.word == 0) {
          engage_augmentation();
        } else {
          v.disengages = v.on.augmentation;
        }
        return;
      case C::governor:
        change_governor(static_cast<Governor>(e.word));
        return;
      case C::interconnect:
        v.on.interconnect = e.word == 1;
        return;
      case C::gear:
        move_gear(e.word == 1);
        return;
      case C::brakes:
        v.brake[right] = v.brake[left] = first;
        return;
      case C::engine:
        engine(e);
        return;
      case C::gust:
        inputs.blow(e);
        return;
      case C::wind:
        change_wind({e.number[0], e.number[1], e.number[2]}, v.on.wind_shear);
        return;
      case C::shear:
        change_wind(c.around.wind_n, static_cast<WindShear>(e.word));
        return;
      case C::turbulence:
        v.on.turbulence = first > 0;
        if (!v.on.turbulence) flight.state.gusts = {};
        v.wind_20_ft = first;
        v.turbulence_seed = e.count > 1 ? static_cast<std::uint64_t>(e.number[1]) : 1;
        return;
      case C::land:
        lands = !parked;
        if (parked) return;
        aims.vertical = pilot::Vertical::climb;
        aims.climb = -first;
        hold_thrust();
        hold_long_stick();
        return;
      case C::end:
        return;
    }
  }

  void note_taken(int input) {
    const Controls<int>& u = kControlIndex;
    aims.taken.thrust |= input == u.collective || input >= kFirstThrottle;
    aims.taken.long_stick |= input == u.long_stick;
    aims.taken.lat_stick |= input == u.lat_stick;
    aims.taken.pedal |= input == u.pedal;
  }
};

}  // namespace tiltrotor::cli

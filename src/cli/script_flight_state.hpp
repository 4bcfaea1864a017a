// A flight by a script as it stands: vehicle, pilot, what he aims at and sees.
#pragma once

#include <cmath>

#include "cli/analyses_workspace.hpp"
#include "cli/flight_fault.hpp"
#include "cli/flight_remarks.hpp"
#include "cli/ground_handling.hpp"
#include "cli/pilot_training.hpp"
#include "cli/script_flight.hpp"
#include "cli/script_inputs.hpp"
#include "text/number.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

namespace tiltrotor::cli {

inline constexpr double kTouched = 0.02;  // weight on wheels, of the weight
// How far ahead the pilot looks where masts move: further forward, where thrust for the acceleration must build up.
inline constexpr double kAheadForward = 2.2, kAheadBack = 0.2;  // s

// Velocity relative to the air in axes along the heading: forward, to the right, down.
inline Vec3<double> levelled(const State<double>& x) {
  const Vec3<double>& v = x.velocity;
  const double across = v.y * std::cos(x.roll) - v.z * std::sin(x.roll);
  const double below = v.y * std::sin(x.roll) + v.z * std::cos(x.roll);
  return {v.x * std::cos(x.pitch) + below * std::sin(x.pitch), across,
          -v.x * std::sin(x.pitch) + below * std::cos(x.pitch)};
}

inline Vec3<double> over_ground(const State<double>& x, const Vec3<double>& wind_n) {
  const Vec3<double> v = levelled(x);
  const double cosine = std::cos(x.yaw), sine = std::sin(x.yaw);
  return wind_n + Vec3<double>{v.x * cosine - v.y * sine, v.x * sine + v.y * cosine, v.z};
}

// The pilot has learnt where the flight begins.
inline FlightSetup<double> where_trained(const FlightStart& start) {
  FlightSetup<double> setup = start.setup;
  if (!start.on_ground) setup.altitude += start.height;
  return setup;
}

struct ScriptFlightState {
  const FlightScript& script;
  const FlightStart start;
  const Aircraft<double>& aircraft = *start.aircraft;
  PilotTraining training;
  Configuration<double> c{};
  SystemFlight<double> flight{};
  Simulation<double> simulation{};
  AnalysesWorkspace work;
  FeedbackFlight closed;
  pilot::PilotAims aims{};
  pilot::PilotMemory memory{};
  pilot::PilotReach reach = pilot::pilot_reach(aircraft);
  GroundHandling ground{};
  ScriptInputs inputs;
  bool parked = false, lands = false, struck = false;
  FlightRemarks remarks;
  bool is_there = false;    // once at the height that is held
  double settled_at = 0;    // that height, m
  double followed = 0;      // by the engines, of the throttle
  double rotor_target = 0;  // rad/s
  std::size_t next = 0;     // event
  FlightMoment moment{};
  double rates[vehicle_state_count] = {};
  Evaluation<double> evaluation{};
  DerivativeSteps<double> steps{};
  AirframeDemand<double> demand{};
  AirframeAnswer<double> answer{};

  ScriptFlightState(const FlightScript& s, const FlightStart& at, const Feedback& feedback)
      : script(s),
        start(at),
        training(where_trained(at), at.warmer),
        closed(feedback, &flight, *work),
        inputs(s) {}

  double time() const { return current_time(simulation); }
  double rest_height() const { return c.setup.wl_cg - aircraft.gear.ground_wl; }
  double height() const { return -current_state(simulation).position.z - rest_height(); }  // of the wheels
  double full_power() const { return demanded_power(aircraft, c.air, 1.0); }
  double throttle_share() const {
    const int running = vehicle_parts::engines_running(flight.vehicle.engine_failed);
    return running == 0 ? 0 : 2.0 / running;
  }

  // Over the ground, at the aircraft's height.
  Vec3<double> wind() const {
    return wind_at(mean_wind(flight.vehicle, aircraft.gust, c.around.wind_n),
                   current_state(simulation).position.z);
  }

  pilot::PilotSees look() const {
    const State<double> x = current_state(simulation);
    const Vec3<double> air = levelled(x);
    pilot::PilotSees sees{};
    sees.mast_deg = c.setup.mast_deg;
    sees.airspeed = air.x;
    sees.side_airspeed = air.y;
    sees.north = x.position.x;
    sees.east = x.position.y;
    sees.height = height();
    sees.ground_velocity = over_ground(x, wind());
    sees.roll = x.roll;
    sees.pitch = x.pitch;
    sees.yaw = x.yaw;
    sees.rates = x.rates;
    sees.is_on_ground = moment.weight_on_wheels > kTouched;
    return sees;
  }

  pilot::PilotGains gains() const {
    const bool holds = memory.has_begun && (aims.holds_speed || aims.holds_position);
    const double speed = holds ? memory.speed : levelled(simulation.state).x;
    const double turning = flight.vehicle.commands.rotor_speed, mast_deg = c.setup.mast_deg;
    const SystemSwitches& on = flight.vehicle.on;
    const double rate = c.setup.mast_rate * kDegPerRad<double>;
    const double ahead = rate > 0 ? kAheadForward : kAheadBack;
    return training.at(mast_deg + ahead * rate, speed + ahead * memory.acceleration, turning, on);
  }

  std::string fault() const {
    const Vehicle<double>& v = flight.vehicle;
    const char* const gear = is_locked_down(v, flight.state.gear) ? ""
                             : v.gear_down                        ? " before the gear was down"
                                                                  : " with the gear up";
    return "at " + number_text(simulation.fault_time, 6) + " s" +
           (struck ? std::string(", down: the aircraft has met the ground") + gear
                   : flight_fault_text(c, flight, simulation));
  }
};

}  // namespace tiltrotor::cli

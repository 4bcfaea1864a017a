// Outputs of the airframe beside what instruments read: load factors at any station, loads of any component, angles of the
// path and of the flow at wing and tail, and states, with exact derivatives.
#pragma once

#include <vector>

#include "library/vehicle_outputs.hpp"
#include "tiltrotor/math/differentiation/along.hpp"

namespace tiltrotor::cli {

struct AirframeOutput {
  enum class Kind : unsigned char {
    load_factor,  // at a station
    load_factor_at_cg,
    force,
    moment,
    flight_path_angle,      // of the path through the undisturbed air above the horizon, rad; 0 at rest
    wing_angle_of_attack,   // of the part that no wake covers, rad
    htail_angle_of_attack,  // with incidence, wash and downwash, rad
    state
  };
  Kind kind;
  int axis;           // x, y, z of the body
  int component;      // of a load; component_count: of all, as total_aero of `loads`. Of a state its place
  double station[3];  // of a load factor: SL aft, BL right, WL up, m
};

// Specific force over g at a station: nx forward, ny to the right, nz up, 1 in level flight; force on the aircraft, N,
// and moment about the CG, N m, body axes. From one evaluation; `c` as it was put into what systems ask for.
std::vector<double> airframe_readings(const Configuration<double>& c, const State<double>& x,
                                      const DerivativeSteps<double>& steps, const State<double>& rates,
                                      const std::vector<AirframeOutput>& outputs);

// The same of numbers that carry a slope.
std::vector<Along> airframe_readings(const Configuration<Along>& c, const State<Along>& x,
                                     const DerivativeSteps<Along>& steps, const State<Along>& rates,
                                     const std::vector<AirframeOutput>& outputs);

// y, C and D of these outputs in a flight with systems, which may all be off: columns as `shape` says. By dual numbers
// whatever the program differentiates by. Status as that of linearize_vehicle_outputs().
Status linearize_airframe_outputs(const SystemFlight<double>& flight, const Configuration<double>& c,
                                  const State<double>& x, const Controls<double>& u,
                                  const VehicleShape& shape, const std::vector<AirframeOutput>& outputs,
                                  VehicleRows& found);

}  // namespace tiltrotor::cli

// The whole library for a C++ program. It compiles the templates itself, with its own flags, the same in all of
// its files: of functions that several files compile the linker keeps one copy, from any of them, for all. Link
// with libtiltrotor-aircraft.a, which holds the tables.
//
//   const Aircraft<double>& aircraft = aircraft_data<double>();
//   static Configuration<double> c;      // mast angle, mass, altitude, switches; reconfigure() moves it
//   static TrimWorkspace<double> work;   // memory is the caller's; these structs are too large for small stacks
//   static TrimResult<double> trimmed;
//   if (prepare(aircraft, flight_setup(aircraft, 30.0), c) != Status::ok) ...      // mast angle 30 deg
//   if (is_trimmed(trim(c, SteadyFlight<double>{40, 0, 0, 0}, work, trimmed))) ... // 40 m/s, level
//
// From there: linearize() and modes() give exact A, B and eigenvalues, start() and advance() fly, derivative() is
// xdot = f(x, u) on double, float, Dual<double, N> or std::complex<double>, isolated_rotor() a rotor on a stand.
#pragma once

#include "tiltrotor/analysis/flight/air_data.hpp"
#include "tiltrotor/analysis/flight/closed_loop.hpp"
#include "tiltrotor/analysis/flight/geodetic.hpp"
#include "tiltrotor/analysis/flight/input_signal.hpp"
#include "tiltrotor/analysis/flight/sensor_lag.hpp"
#include "tiltrotor/analysis/flight/station_motion.hpp"
#include "tiltrotor/analysis/flight/table_edge.hpp"
#include "tiltrotor/analysis/flight/vehicle_readings.hpp"
#include "tiltrotor/analysis/instances.hpp"
#include "tiltrotor/analysis/isolated_rotor.hpp"
#include "tiltrotor/analysis/linear/channel.hpp"
#include "tiltrotor/analysis/linear/configuration_sensitivity.hpp"
#include "tiltrotor/analysis/linear/feedback.hpp"
#include "tiltrotor/analysis/linear/frequency_measures.hpp"
#include "tiltrotor/analysis/linear/linear_eigenvalues.hpp"
#include "tiltrotor/analysis/linear/mode_shape.hpp"
#include "tiltrotor/analysis/linear/mode_tracker.hpp"
#include "tiltrotor/analysis/linear/model_motion.hpp"
#include "tiltrotor/analysis/linear/output_model.hpp"
#include "tiltrotor/analysis/linear/rigid_model.hpp"
#include "tiltrotor/analysis/linear/rigid_outputs.hpp"
#include "tiltrotor/analysis/linear/root_sensitivity.hpp"
#include "tiltrotor/analysis/linear/system_gains.hpp"
#include "tiltrotor/analysis/linear/vehicle_direction.hpp"
#include "tiltrotor/analysis/linear/vehicle_modes.hpp"
#include "tiltrotor/analysis/linear/vehicle_reduction.hpp"
#include "tiltrotor/math/differentiation/along.hpp"
#include "tiltrotor/math/differentiation/complex_step.hpp"
#include "tiltrotor/math/tables/table_slopes.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/model/aircraft/c2_aircraft.hpp"
#include "tiltrotor/model/setup/setup_explanation.hpp"
#include "tiltrotor/model/variables/control_range.hpp"
#include "tiltrotor/model/variables/presets.hpp"
#include "tiltrotor/systems/ground_effect.hpp"
#include "tiltrotor/systems/landing_gear.hpp"
#include "tiltrotor/systems/turbulence.hpp"

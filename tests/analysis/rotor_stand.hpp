// One rotor on a test stand.
#pragma once

#include "check.hpp"
#include "tiltrotor/analysis/isolated_rotor.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/model/variables/presets.hpp"

namespace rotor_stand {

using namespace tiltrotor;

// With a copy of the aircraft, which a test may change before it prepares the configuration again.
struct Stand {
  Aircraft<double> aircraft = aircraft_data<double>();
  Configuration<double> configuration;
  IsolatedRotorWorkspace<double> work;
  IsolatedRotor<double> rotor;

  explicit Stand(double mast_deg = 0, const Options& options = {}) {
    FlightSetup<double> setup = flight_setup(aircraft, mast_deg);
    setup.options = options;
    CHECK(prepare(aircraft, setup, configuration) == Status::ok);
  }
  Stand(const Stand&) = delete;
  Stand& operator=(const Stand&) = delete;
  Status run(const RotorFlow<double>& flow) { return isolated_rotor(configuration, flow, work, rotor); }
};

inline RotorFlow<double> flow(double collective_deg, double axial = 0, double in_plane = 0) {
  RotorFlow<double> f{};
  f.collective = collective_deg * kRadPerDeg<double>;
  f.axial = axial;
  f.in_plane = in_plane;
  return f;
}

}  // namespace rotor_stand

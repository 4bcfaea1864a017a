// From an aircraft and what the user chooses to a configuration.
#pragma once

#include "tiltrotor/math/arithmetic.hpp"
#include "tiltrotor/model/rotor/radial_inflow.hpp"
#include "tiltrotor/model/setup/configuration.hpp"

namespace tiltrotor {

// Prepare a configuration. Status out_of_range (and `c` unusable) when a setting lies outside its range, which
// first_out_of_range() names; bad_arithmetic when this code or the processor does not compute as
// arithmetic.hpp says.
// Cost: a few derivatives of the real-time grid, some forty with the radial shape of the inflow.
template <class R>
Status prepare(const Aircraft<R>& aircraft, const FlightSetup<R>& setup, Configuration<R>& c) {
  c = Configuration<R>{};
  if (!is_ieee_arithmetic<R>()) return Status::bad_arithmetic;
  if (first_out_of_range(aircraft, setup).field != SetupField::none) return Status::out_of_range;
  const Options& o = setup.options;
  c.aircraft = &aircraft;
  c.pitch_flap = tan(aircraft.rotor.delta3);
  c.induced_power_factor =
      o.induced_power_factor > 0 ? static_cast<R>(o.induced_power_factor) : aircraft.inflow.induced_power;
  c.apparent_mass_0 = o.apparent_mass == ApparentMass::impermeable ? aircraft.inflow.apparent_mass_uniform
                                                                   : aircraft.inflow.apparent_mass_loaded;
  c.blade = blade_stations(aircraft.rotor, o);
  c.azimuth = averaged_azimuth<R>(aircraft.rotor.blades, azimuth_count(o));
  c.setup = setup;
  c.rotor[right].ground_wash = c.rotor[left].ground_wash = c.download = R(1);
  if (o.radial_inflow == RadialInflow::annular) shape_mean_inflow(c);
  configure(c);
  return Status::ok;
}

}  // namespace tiltrotor

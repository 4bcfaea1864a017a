// Ranges of a setup, which are the aircraft's: the one place that says what prepare() takes, and what of a
// setup it refuses.
#pragma once

#include "tiltrotor/model/aircraft/aircraft.hpp"
#include "tiltrotor/model/setup/blade_grid.hpp"

namespace tiltrotor {

template <class R>
struct FlightSetup;

enum class SetupField : unsigned char {
  none,
  mast_deg,
  mast_rate,
  mast_acceleration,
  flap_deg,
  rotor_speed,
  rotor_acceleration,
  altitude,
  mass,
  sl_cg,
  wl_cg,
  grid_refinement,
  azimuth_stations,
  hub_spring_factor,
  induced_power_factor,
  count
};

namespace setup_range_detail {

struct FieldName {
  const char* name;
  const char* unit;
};
inline constexpr FieldName kFieldNames[] = {{"", ""},
                                            {"mast angle", "deg"},
                                            {"mast rate", "rad/s"},
                                            {"mast acceleration", "rad/s^2"},
                                            {"flap", "deg"},
                                            {"rotor speed", "rad/s"},
                                            {"rotor acceleration", "rad/s^2"},
                                            {"altitude", "m"},
                                            {"mass", "kg"},
                                            {"CG station", "m"},
                                            {"CG waterline", "m"},
                                            {"grid_refinement", ""},
                                            {"azimuth_stations", ""},
                                            {"hub_spring_factor", ""},
                                            {"induced_power_factor", ""}};
static_assert(sizeof(kFieldNames) / sizeof(kFieldNames[0]) == static_cast<unsigned>(SetupField::count),
              "one name per field");

}  // namespace setup_range_detail

constexpr const char* setup_field_name(SetupField field) {
  return field < SetupField::count ? setup_range_detail::kFieldNames[static_cast<unsigned>(field)].name : "";
}
constexpr const char* setup_field_unit(SetupField field) {
  return field < SetupField::count ? setup_range_detail::kFieldNames[static_cast<unsigned>(field)].unit : "";
}

// Range of one field, ends included, in the unit of the field. `azimuth_stations` may be 0, too.
template <class R>
Bounds<R> setup_range(const Aircraft<R>& aircraft, SetupField field) {
  const LimitTables<R>& limits = aircraft.limits;
  switch (field) {
    case SetupField::mast_deg:
      return limits.mast_deg;
    case SetupField::mast_rate:
      return limits.mast_rate;
    case SetupField::mast_acceleration:
      return limits.mast_acceleration;
    case SetupField::flap_deg:
      return limits.flap_deg;
    case SetupField::rotor_speed:
      return limits.rotor_speed;
    case SetupField::rotor_acceleration:
      return limits.rotor_acceleration;
    case SetupField::altitude:
      return limits.altitude;
    case SetupField::mass:
      return limits.mass;
    case SetupField::sl_cg:
      return limits.sl_cg;
    case SetupField::wl_cg:
      return limits.wl_cg;
    case SetupField::grid_refinement:
      return {R(1), R(4)};
    case SetupField::azimuth_stations:
      return {R(3), R(kMaxAzimuthStations)};
    case SetupField::hub_spring_factor:
      return {R(0), R(10)};
    case SetupField::induced_power_factor:
      return {R(0), R(2)};
    case SetupField::none:
    case SetupField::count:
      break;
  }
  return {R(0), R(0)};
}

template <class R>
struct SetupFault {
  SetupField field;  // none: prepare() takes the setup
  R value;
  Bounds<R> range;  // in the unit of the field
};

// The first field of a setup that is outside its range. Cost: a few comparisons.
template <class R>
SetupFault<R> first_out_of_range(const Aircraft<R>& aircraft, const FlightSetup<R>& setup) {
  const auto& o = setup.options;
  const struct {
    SetupField field;
    R value;
  } given[] = {{SetupField::mast_deg, setup.mast_deg},
               {SetupField::mast_rate, setup.mast_rate},
               {SetupField::mast_acceleration, setup.mast_acceleration},
               {SetupField::flap_deg, setup.flap_deg},
               {SetupField::rotor_speed, setup.rotor_speed - R(0.5) * setup.rotor_difference},
               {SetupField::rotor_speed, setup.rotor_speed + R(0.5) * setup.rotor_difference},
               {SetupField::rotor_acceleration, setup.rotor_acceleration},
               {SetupField::altitude, setup.altitude},
               {SetupField::mass, setup.mass},
               {SetupField::sl_cg, setup.sl_cg},
               {SetupField::wl_cg, setup.wl_cg},
               {SetupField::grid_refinement, static_cast<R>(o.grid_refinement)},
               {SetupField::azimuth_stations, static_cast<R>(o.azimuth_stations)},
               {SetupField::hub_spring_factor, static_cast<R>(o.hub_spring_factor)},
               {SetupField::induced_power_factor, static_cast<R>(o.induced_power_factor)}};
  for (const auto& [field, value] : given) {
    const Bounds<R> range = setup_range(aircraft, field);
    const bool grid_default = field == SetupField::azimuth_stations && value == R(0);
    if (!is_within(value, range.low, range.high) && !grid_default) return {field, value, range};
  }
  return {SetupField::none, R(0), {R(0), R(0)}};
}

}  // namespace tiltrotor

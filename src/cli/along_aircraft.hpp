// An aircraft whose numbers and tables may move along a direction.
#pragma once

#include "study/copied_tables.hpp"
#include "tiltrotor/math/differentiation/along.hpp"
#include "tiltrotor/model/aircraft/aircraft.hpp"

namespace tiltrotor::cli {

class AlongAircraft : public study::CopiedTables<Along> {
 public:
  // The one that is compiled in, with the tables of `base`.
  explicit AlongAircraft(const Aircraft<double>& base);
  AlongAircraft(const AlongAircraft&) = delete;
  AlongAircraft& operator=(const AlongAircraft&) = delete;

  Aircraft<Along> aircraft;
};

// The aircraft of c2_aircraft_data().
const Aircraft<Along>& c2_along_aircraft();

}  // namespace tiltrotor::cli

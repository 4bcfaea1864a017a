// The smoothest table that print allows: of all curves and surfaces with two continuous derivatives, made of cubics
// between the knots, the one of least roughness whose nodes differ from the printed ones by half a unit of the last
// printed digit at most.
//
//   one axis   integral of f''^2
//   two axes   sum over the lines of knots along each axis, of the integral along the line times the width that the
//              line stands for; each axis measured in its mean interval, so that angles and speeds weigh alike
//
// Along Mach number, second axis of some, it is C1 and monotone as the default: through few columns that rise late a
// curve with two derivatives swings below zero drag.
//
// Of equally smooth ones it is the nearest to the print. A value between printed ones, where columns of unlike knots
// stand side by side, is free. What is symmetric in the print stays so to the last bit. Linear axes, mast angle and
// flap, stay linear: every block is fitted alone.
#pragma once

#include <vector>

#include "tablegen/aircraft_tables.hpp"

namespace tablegen {

// Fitted: what the loads of the air are read from. Not: blade geometry, gearings, schedules and gains, which are what
// they are.
bool is_fitted(const TableArray& table);

struct C2Fit {
  std::vector<double> node;  // as Table stores them: values and slopes
  double deviation = 0;      // the largest, in half units of the last printed digit
  double roughness = 0;      // over that of the nodes as printed; 1 where these are straight
};
C2Fit c2_fit(const TableArray& table);

}  // namespace tablegen

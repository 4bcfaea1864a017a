// The aircraft as plain numbers, SI units and radians, filled from tables/<aircraft>/ by the table generator.
//
// Table ordinates are SI; table abscissae keep the unit of the source (degrees, knots, Mach number), so that
// they can be compared with it. Stations: SL aft, BL right, WL up, here in metres. Mast angle 0 is
// helicopter, 90 deg airplane. Every field names the entry of aircraft.csv or choices.csv (or the table) it
// comes from.
#pragma once

#include "tiltrotor/model/aircraft/airframe_tables.hpp"
#include "tiltrotor/model/aircraft/control_tables.hpp"
#include "tiltrotor/model/aircraft/ground_tables.hpp"
#include "tiltrotor/model/aircraft/gust_tables.hpp"
#include "tiltrotor/model/aircraft/mass_tables.hpp"
#include "tiltrotor/model/aircraft/rotor_tables.hpp"
#include "tiltrotor/model/aircraft/smoothing_widths.hpp"
#include "tiltrotor/model/aircraft/system_tables.hpp"

namespace tiltrotor {

// Which aircraft: identity.csv of its folder.
struct AircraftIdentity {
  const char* folder;       // below tables/, as make's AIRCRAFT: "xv15"
  const char* name;         // "XV-15"
  const char* description;  // a sentence without its point
  int id;                   // in the C interface: tr_aircraft; from 1000 on an aircraft of your own
};

template <class R>
struct Aircraft {
  MassTables<R> mass;
  MastTables<R> mast;
  RotorTables<R> rotor;
  InflowTables<R> inflow;
  WakeTables<R> wake;
  WingTables<R> wing;
  PylonTables<R> pylon;
  EngineJetTables<R> jet;
  FuselageTables<R> fuselage;
  HorizontalTailTables<R> htail;
  FinTables<R> fin;
  TailSharedTables<R> tail;
  ControlTables<R> controls;
  LimitTables<R> limits;
  DefaultTables<R> defaults;
  TrimGuessTables<R> guess;
  GearTables<R> gear;
  GroundTables<R> ground;
  SmoothingWidths<R> smooth;
  SystemTables<R> systems;
  GustTables<R> gust;
};

}  // namespace tiltrotor

// A flight beyond the data is told: the end value of a table is held where its source says nothing.
// Expected: tables cut short, so that a flight within the data lies beyond one of them.
#include "analysis_case.hpp"
#include "tiltrotor/analysis/flight/table_edge.hpp"

using namespace analysis_case;

namespace {

bool beyond(const Aircraft<double>& aircraft, double elevator = 0) {
  Configuration<double> c;
  CHECK(prepare(aircraft, flight_setup(aircraft_data<double>(), 90.0), c) == Status::ok);
  State<double> x{};
  x.velocity = {0.3 * c.air.speed_of_sound, 0, 0};
  BladeControls<double> blades{};
  blades.elevator = elevator;
  return is_beyond_tables(c, x, x.velocity, blades);
}

// At Mach 0.3; a knot alone is no axis.
void ends_below(Axis<double>& axis, Aircraft<double>& aircraft) {
  static const double low[] = {0, 0.1, 0.2}, high[] = {0, 0.2, 0.6};
  const Axis<double> whole = axis;
  axis = {3, low};
  CHECK(beyond(aircraft));
  axis = {1, low};
  CHECK(!beyond(aircraft));
  axis = {3, high};
  CHECK(!beyond(aircraft));
  axis = whole;
}

}  // namespace

TEST(table_edge_of_each_table_along_mach_number_is_told) {
  static Aircraft<double> aircraft = aircraft_data<double>();
  CHECK(!beyond(aircraft));
  ends_below(aircraft.wing.drag_90[0].smooth[1], aircraft);
  ends_below(aircraft.htail.drag.smooth[1], aircraft);
  ends_below(aircraft.fin.drag.smooth[1], aircraft);
}

TEST(table_edge_of_each_angle_is_told_where_the_wing_carries) {
  static Aircraft<double> aircraft = aircraft_data<double>();
  static const double aside[] = {10, 20};
  for (Axis<double>* const axis :
       {&aircraft.fin.sidewash.smooth[0], &aircraft.fin.sidewash.smooth[1],
        &aircraft.htail.lift_elevator.smooth[1], &aircraft.fin.side_rudder.smooth[1]}) {
    const Axis<double> whole = *axis;
    *axis = {2, aside};
    CHECK(beyond(aircraft));
    *axis = whole;
  }
  CHECK(!beyond(aircraft));
  CHECK(beyond(aircraft, 89 * kDeg));
}

// Level flight of the GTRS reference simulation in helicopter mode, as printed in NASA CR-166537 (run output
// pages; thrust from Kleinhesselink 2007, table C-1): states and component loads. 13000 lb, flap
// 40/25, 589 rpm.
#pragma once

#include "flight_cases.hpp"

namespace printed_runs {

using namespace tiltrotor;

constexpr double kFoot = 0.3048;
constexpr double kPound = 0.45359237 * 9.80665;  // N

struct Printed {  // lb, lb, ft lb
  double x, z, m;
};

struct Point {
  double speed_kt;
  double u_fps, w_fps;  // body axes
  double wash_fps;      // mean induced velocity of each rotor
  double advance_ratio;
  double rotor_force_lb;  // each
  double elevator_deg;
  Printed fuselage, free_wing, pylons, horizontal_tail, spinners;
};

constexpr Point kPoints[] = {{40,
                              67.45,
                              -2.967,
                              35.4892,
                              0.0875,
                              6097.19,
                              1.2741,
                              {-15.850, -26.143, -598.516},
                              {-350.068, -719.309, 451.962},
                              {-97.506, 86.379, 140.465},
                              {-3.860, -75.388, -1618.995},
                              {-57.326, 32.686, 351.934}},
                             {60,
                              100.8,
                              -10.04,
                              24.0344,
                              0.1307,
                              5935.89,
                              2.3398,
                              {-42.616, -21.253, -2107.491},
                              {-743.880, -1035.987, 478.278},
                              {-180.801, 87.006, 267.775},
                              {-9.946, -78.060, -1665.795},
                              {-144.608, 48.895, 891.124}},
                             {100,
                              164.7,
                              -36.86,
                              16.6955,
                              0.2136,
                              6900.68,
                              10.1255,
                              {-229.311, 196.522, -10466.281},
                              {-1523.955, 368.162, -2026.303},
                              {-466.540, 180.068, 695.411},
                              {26.079, 320.059, 6856.203},
                              {-388.541, 126.332, 2394.830}}};

/// What the airframe sees at a printed point; tables linear, as in the source.
struct Replay {
  Configuration<double> c;
  AirframeInput<double> in;
  FreeStream<double> stream;
  WingInWake<double> wake[2];
};

inline Replay replay(const Point& p) {
  Replay r{};
  r.c = flight_cases::configuration(0, flight_cases::linear_tables());
  r.in.velocity_b = {p.u_fps * kFoot, 0, p.w_fps * kFoot};
  r.in.mean_wash[right] = r.in.mean_wash[left] = p.wash_fps * kFoot;
  const double tip = r.c.tip_speed;
  const double radius = 12.5 * kFoot;
  r.in.rotor_force =
      2 * p.rotor_force_lb * kPound / (r.c.air.density * kPi<double> * tip * tip * radius * radius);
  r.in.advance_ratio = p.advance_ratio;
  r.in.elevator = p.elevator_deg * kRadPerDeg<double>;
  r.stream = free_stream(r.c, r.in.velocity_b);
  for (const int side : {right, left}) r.wake[side] = wing_in_wake(r.c, r.in, r.stream, side);
  return r;
}

inline Printed in_pounds(const Loads<double>& loads) {
  return {loads.force.x / kPound, loads.force.z / kPound, loads.moment.y / (kPound * kFoot)};
}

}  // namespace printed_runs

// What the tests of the systems share: flights of the whole vehicle, its rates and its matrices.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>

#include "../analysis/analysis_case.hpp"
#include "tiltrotor/analysis/linear/vehicle_model.hpp"
#include "tiltrotor/math/algebra/lu.hpp"

namespace vehicle_case {

using namespace analysis_case;

inline constexpr SystemSwitches kNone{};
inline constexpr SystemSwitches with(Governor governor) {
  return {governor, true, true, true, true, false, false, false};
}

inline Options realtime() {
  Options options;
  options.grid = BladeGrid::realtime;
  options.position_states = true;
  return options;
}

struct Flight {
  Configuration<double> c;
  SystemFlight<double> systems;
  Simulation<double> s;

  SystemState<double>& state() { return systems.state; }
  const SystemState<double>& state() const { return systems.state; }
  Vehicle<double>& vehicle() { return systems.vehicle; }
};

// In a steady flight of the XV-15, as this aircraft flies it, the systems settled there.
inline Flight begun(double mast_deg, const SteadyFlight<double>& flight, const SystemSwitches& on,
                    double dt = 0.005, Integrator integrator = Integrator::rk3) {
  Flight f{};
  f.c = flown_configuration(mast_deg, 0, realtime());
  const TrimResult<double> r = trimmed(f.c, flown(flight));
  CHECK(is_trimmed(r.status));
  f.vehicle().on = on;
  Evaluation<double> at;
  evaluate_aircraft(f.c, r.state, r.controls, at);
  Controls<double> u = r.controls;
  settle(f.c, r.state, {at.rotor[right].loads.torque, at.rotor[left].loads.torque}, f.vehicle(), f.state(),
         u);
  CHECK(start(f.c, r.state, u, dt, integrator, f.s) == Status::ok);
  return f;
}

// advance_vehicle(); compiled once, in test_vehicle_flight.cpp.
Status fly(Flight& f, int steps, const double* xdot = nullptr);

// As vehicle_variable() counts.
struct Rates {
  double of[vehicle_state_count];
  AirframeAnswer<double> airframe;
  AirframeDemand<double> demand;
  VehicleFlows<double> flows;
  double of_system(int place) const { return of[state_count + place]; }
};
inline Rates rates(const Vehicle<double>& v, Configuration<double> c, const State<double>& x,
                   const SystemState<double>& s, const Controls<double>& u) {
  static DerivativeSteps<double> steps;
  Rates r;
  const ConfigurationSetting<double> base = c.setup;
  SystemState<double> of_systems;
  vehicle_rates(v, c, base, c, x, s, v.commands, u, VehicleAirframe<double>{c, x, steps, 0.0}, r.demand,
                r.airframe, r.flows, of_systems);
  flatten(r.airframe.rates, r.of);
  flatten(of_systems, r.of + state_count);
  return r;
}
inline Rates rates(const Flight& f) {
  return rates(f.systems.vehicle, f.c, f.s.state, f.systems.state, current_controls(f.s));
}

struct Matrices {
  VehicleShape shape;
  Status status;
  State<double> xdot;
  SystemState<double> sdot;
  double a[kMaxVehicleStates][kMaxVehicleStates];
  double b[kMaxVehicleStates][vehicle_input_count];

  // Row and column of a place in vehicle_variable(), or -1.
  int row(int place) const {
    for (int i = 0; i < shape.states; ++i)
      if (shape.state[i] == place) return i;
    return -1;
  }
  int system_row(int place) const { return row(state_count + place); }
};
enum class Inputs { all, sticks };
// Compiled once, in test_vehicle_linear.cpp.
const Matrices& matrices(const Vehicle<double>& v, const Configuration<double>& c, const State<double>& x,
                         const SystemState<double>& s, const Controls<double>& u, double azimuth = 0,
                         Inputs inputs = Inputs::all);
inline const Matrices& matrices(const Flight& f) {
  return matrices(f.systems.vehicle, f.c, f.s.state, f.systems.state, current_controls(f.s));
}

// The entry of a row against a column, rotors, wake and downwash in their balance: a_ij - A_if A_ff^-1 a_fj.
// `column`(i): its entries.
template <class Column>
double settled(const Matrices& m, int row, Column&& column) {
  static Matrix<double, kMaxVehicleStates, kMaxVehicleStates> fast;
  static LU<double, kMaxVehicleStates> lu;
  int place[kMaxVehicleStates], n = 0;
  for (int i = 0; i < m.shape.states; ++i)
    if (m.shape.state[i] < state_count && !is_rigid(m.shape.state[i])) place[n++] = i;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) fast(i, j) = m.a[place[i]][place[j]];
  double way[kMaxVehicleStates];
  for (int k = 0; k < n; ++k) way[k] = column(place[k]);
  CHECK(lu_factor(fast, n, lu) == Status::ok);
  CHECK(lu_solve(lu, way) == Status::ok);
  double entry = column(row);
  for (int k = 0; k < n; ++k) entry -= m.a[row][place[k]] * way[k];
  return entry;
}

template <class S>
bool same_bits(const S& a, const S& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

// Largest difference of two flights, each state over the bend of its kind.
inline double difference(const Flight& a, const Flight& b) {
  double x[vehicle_state_count], y[vehicle_state_count];
  flatten(a.s.state, x);
  flatten(a.systems.state, x + state_count);
  flatten(b.s.state, y);
  flatten(b.systems.state, y + state_count);
  double worst = 0;
  for (int i = 0; i < vehicle_state_count; ++i)
    worst = std::max(worst, std::fabs(x[i] - y[i]) / vehicle_variable(i).facts().bend);
  return worst;
}

}  // namespace vehicle_case

// The aircraft in another size: every length times L, every density times D, gravity unchanged.
//
// Froude's law keeps speed^2 / (gravity length): speeds and times go with sqrt(L), masses and forces with D
// L^3. With a speed of sound times sqrt(L) the Mach numbers stay as well, so the scaled aircraft flies the
// same flight, scaled. Speeds on table axes and widths of the smoothing are lengths over times like any
// other.
#pragma once

#include <array>
#include <cmath>
#include <deque>
#include <vector>

#include "check.hpp"
#include "model/flight_cases.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/model/preparation.hpp"

namespace scaled {

using namespace tiltrotor;

struct Scale {
  double length;
  double density;
  double time() const { return std::sqrt(length); }
  double speed() const { return std::sqrt(length); }
  double mass() const { return density * std::pow(length, 3); }
  double force() const { return mass(); }
  double moment() const { return force() * length; }
  double inertia() const { return mass() * length * length; }
};

/// A copy of an aircraft in another size, with the memory of its tables.
class ScaledAircraft {
 public:
  ScaledAircraft(const Aircraft<double>& original, const Scale& scale) : aircraft_(original), s_(scale) {
    scale_masses();
    scale_rotor();
    scale_wing_and_wake();
    scale_fuselage_and_pylons();
    scale_tail();
    scale_controls();
    scale_smoothing();
    scale_limits();
    scale_gear();
  }
  ScaledAircraft(const ScaledAircraft&) = delete;
  ScaledAircraft& operator=(const ScaledAircraft&) = delete;

  const Aircraft<double>& operator*() const { return aircraft_; }

 private:
  template <class... Numbers>
  static void times(double factor, Numbers&... number) {
    ((number *= factor), ...);
  }
  void times(double factor, Inertia<double>& i) { times(factor, i.xx, i.yy, i.zz, i.xz); }

  // Ordinates times `factor`, the abscissae of the smooth axes each times its own.
  template <int Smooth, int Linear>
  void times(double factor, Table<double, Smooth, Linear>& table, const std::array<double, Smooth>& along) {
    constexpr int per_node = 1 << Smooth;
    int nodes = 1;
    for (int a = 0; a < Smooth; ++a) nodes *= table.smooth[a].count;
    for (int a = 0; a < Linear; ++a) nodes *= table.linear[a].count;
    std::vector<double>& node = memory_.emplace_back(table.node, table.node + nodes * per_node);
    for (int i = 0; i < nodes * per_node; ++i) {
      double per = factor;
      for (int a = 0; a < Smooth; ++a)
        if ((i % per_node >> a & 1) == 1) per /= along[static_cast<std::size_t>(a)];
      node[static_cast<std::size_t>(i)] *= per;
    }
    table.node = node.data();
    for (int a = 0; a < Smooth; ++a) {
      Axis<double>& axis = table.smooth[a];
      const double width = along[static_cast<std::size_t>(a)];
      std::vector<double>& knot = memory_.emplace_back(axis.knot, axis.knot + axis.count);
      for (double& x : knot) x *= width;
      axis.knot = knot.data();
      axis.per_width /= width;
      axis.end_width *= width;
    }
  }
  template <class... Tables>
  void curves(double factor, Tables&... table) {
    (times(factor, table, {1.0}), ...);
  }

  void scale_masses() {
    MassTables<double>& m = aircraft_.mass;
    times(s_.mass(), m.gross, m.nacelles);
    times(s_.length, m.sl_cg, m.wl_cg, m.sl_nacelle, m.wl_nacelle, m.nacelle_gyration);
    for (Inertia<double>* i : {&m.inertia, &m.inertia_slope, &m.design_0, &m.design_90})
      times(s_.inertia(), *i);
    MastTables<double>& mast = aircraft_.mast;
    times(s_.length, mast.sl_pivot, mast.bl_pivot, mast.wl_pivot, mast.length);
  }
  void scale_rotor() {
    RotorTables<double>& r = aircraft_.rotor;
    times(s_.length, r.radius);
    times(s_.inertia(), r.flap_inertia);
    times(1 / s_.time(), r.speed_helicopter, r.speed_airplane);
    times(s_.moment(), r.hub_spring);
    times(s_.moment() * s_.time(), r.hub_damping);
    curves(s_.length, r.chord_cutout, r.chord_text, r.chord_camrad);
  }
  void scale_wing_and_wake() {
    WingTables<double>& w = aircraft_.wing;
    times(s_.length * s_.length, w.area);
    times(s_.length, w.span, w.chord, w.sl, w.bl, w.wl, w.downwash_arm);
    times(s_.speed(), w.downwash_speed_floor);
    WakeTables<double>& k = aircraft_.wake;
    times(s_.length, k.fuselage_side);
    times(s_.length * s_.length, k.gtrs_area);
    times(s_.speed(), k.fade_start, k.fade_end, k.gtrs_end_speed);
  }
  void scale_fuselage_and_pylons() {
    const double area = s_.length * s_.length;
    const double volume = area * s_.length;
    PylonTables<double>& p = aircraft_.pylon;
    curves(area, p.interference);
    times(area, p.side_area, p.spinner_base, p.spinner_cross);
    EngineJetTables<double>& j = aircraft_.jet;  // referred to the air of sea level, which is not scaled
    times(volume, j.thrust);
    times(1 / s_.speed(), j.thrust_per_power);
    times(volume / s_.time(), j.airflow);
    times(1 / s_.length, j.airflow_per_power);
    FuselageTables<double>& f = aircraft_.fuselage;
    times(s_.length, f.sl, f.wl);
    curves(area, f.lift_alpha, f.drag_alpha, f.lift_beta, f.drag_beta, f.side_beta);
    curves(volume, f.moment_alpha, f.moment_beta, f.roll_beta, f.yaw_beta);
    times(area, f.lift_zero, f.drag_zero, f.extra_drag);
    times(volume, f.moment_zero);
  }
  void scale_tail() {
    HorizontalTailTables<double>& h = aircraft_.htail;
    FinTables<double>& f = aircraft_.fin;
    for (TailSurface<double>* surface : {&h.surface, &f.surface}) {
      times(s_.length * s_.length, surface->area);
      times(s_.length, surface->sl, surface->bl, surface->wl);
    }
    times(s_.length * s_.length, f.area_report);
    times(s_.speed(), f.speed_floor, h.wash_fit_speed, h.wash_fit[4]);
    times(1, h.rotor_wash, {1, s_.speed()});
    times(1, h.pressure_ratio, {1, s_.speed()});
    times(1, f.rotor_sidewash, {s_.speed(), 1});
  }
  void scale_controls() {
    ControlTables<double>& c = aircraft_.controls;
    times(1, c.pedal_cyclic, {s_.speed()});
    times(1, c.lateral_cyclic, {s_.speed()});
    times(s_.force() * s_.speed(), c.power_limit, c.engine_power, c.engine_power_continuous);
    times(s_.moment(), c.mast_torque);
  }
  void scale_smoothing() {
    SmoothingWidths<double>& e = aircraft_.smooth;
    times(s_.speed(), e.section_speed, e.forward_speed, e.lateral_plane_speed, e.airspeed, e.rate_speed,
          e.wake_axis, e.wake_radius, e.drag_speed, e.side_plate_speed, e.side_plate_axial);
    times(s_.mass() * s_.speed(), e.engine_power);
  }

  void scale_limits() {
    const auto ranges = [](double factor, Bounds<double>& range) { times(factor, range.low, range.high); };
    LimitTables<double>& l = aircraft_.limits;
    ranges(1 / s_.time(), l.mast_rate);
    ranges(1 / (s_.time() * s_.time()), l.mast_acceleration);
    ranges(1 / (s_.time() * s_.time()), l.rotor_acceleration);
    ranges(1 / s_.time(), l.rotor_speed);
    ranges(s_.mass(), l.mass);
    ranges(s_.length, l.sl_cg);
    ranges(s_.length, l.wl_cg);
    times(s_.force(), l.outside_force);
    times(s_.moment(), l.outside_moment);
    times(1 / s_.time(), l.gust_rate);
    times(s_.speed(), l.speed, l.gust, l.wind, aircraft_.guess.wing_speed);
  }
  void scale_gear() {
    GearTables<double>& g = aircraft_.gear;
    const double stiffness = s_.force() / s_.length;
    for (StrutTables<double>* strut : {&g.nose, &g.main}) {
      times(s_.length, strut->sl, strut->bl, strut->stroke);
      times(stiffness, strut->oleo_stiffness, strut->tyre_stiffness);
      times(stiffness * s_.time(), strut->oleo_damping);
    }
    SmoothingWidths<double>& e = aircraft_.smooth;
    times(s_.length, g.ground_wl, g.drag_wl, aircraft_.ground.hub_height_on_gear, e.gear_contact,
          e.gear_stop);
    times(s_.length * s_.length, g.drag_area);
    times(s_.time(), g.transit);
    times(s_.speed(), g.slip_speed, e.ground_wash);
    times(s_.force(), e.gear_force);
  }

  Aircraft<double> aircraft_;
  Scale s_;
  std::deque<std::vector<double>> memory_;
};

/// The setup of the scaled aircraft, and its configuration in the scaled air.
inline Status prepare_scaled(const ScaledAircraft& aircraft, const Scale& s, FlightSetup<double> setup,
                             Configuration<double>& c) {
  setup.rotor_speed /= s.time();
  setup.mass *= s.mass();
  setup.sl_cg *= s.length;
  setup.wl_cg *= s.length;
  const Status status = prepare(*aircraft, setup, c);
  c.air.density *= s.density;
  c.air.speed_of_sound *= s.speed();
  return status;
}

template <class V3>
V3 product(double factor, const V3& v) {
  return {factor * v.x, factor * v.y, factor * v.z};
}

/// State of the scaled flight. Angles and inflow over tip speed stay.
inline State<double> scaled_state(State<double> x, const Scale& s) {
  x.velocity = product(s.speed(), x.velocity);
  x.rates = product(1 / s.time(), x.rates);
  x.position = product(s.length, x.position);
  for (int side = 0; side < 2; ++side) {
    x.rotor[side].b1c_rate /= s.time();
    x.rotor[side].b1s_rate /= s.time();
    x.coning[side].rate /= s.time();
  }
  return x;
}
/// What the rates of the state become.
inline State<double> scaled_rates(State<double> rates, const Scale& s) {
  State<double> r = scaled_state(rates, s);
  double flat[state_count];
  flatten(r, flat);
  for (double& x : flat) x /= s.time();
  unflatten(flat, r);
  return r;
}
inline Controls<double> scaled_controls(Controls<double> u, const Scale& s) {
  u.gust = product(s.speed(), u.gust);
  return u;
}

// Every switch that selects another formula.
inline Options random_options(flight_cases::Generator& random) {
  Options o;
  o.tables = random.coin() ? Interpolation::c1 : Interpolation::linear;
  o.grid = random.coin() ? BladeGrid::specification : BladeGrid::realtime;
  o.flapping = random.coin() ? FlapOrder::second : FlapOrder::first;
  o.flap_angular_acceleration = random.coin();
  o.coning_states = random.coin();
  o.inflow = random.coin() ? InflowShape::pitt_peters : InflowShape::uniform;
  o.disk_plane_inflow = random.coin();
  o.side_by_side = random.coin();
  o.sideward_flight = random.coin();
  o.wake = random.coin() ? WakeModel::geometric : WakeModel::gtrs_empirical;
  o.wash = random.coin() ? WashFactor::constant : WashFactor::vortex_cylinder;
  o.wing_rate_velocity = random.coin();
  o.downwash_lag = random.coin();
  o.tail_pressure = random.coin() ? TailPressure::by_mast : TailPressure::constant;
  o.tail_sideslip_loss = random.coin();
  o.fin_area = random.coin() ? FinArea::drawings : FinArea::report;
  o.chord = random.coin() ? ChordSource::cutout : ChordSource::camrad;
  o.lateral_cyclic = random.coin();
  o.position_states = true;
  return o;
}

inline void check_vectors(const Vec3<double>& actual, const Vec3<double>& expected, double tolerance) {
  CHECK_NEAR(actual.x, expected.x, tolerance);
  CHECK_NEAR(actual.y, expected.y, tolerance);
  CHECK_NEAR(actual.z, expected.z, tolerance);
}

}  // namespace scaled

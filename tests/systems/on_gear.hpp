// An aircraft on its landing gear: its motion as one struct, its loads, and a rigid body that flies and lands.
#pragma once

#include "model/flight_cases.hpp"
#include "tiltrotor/analysis/flight/attitude.hpp"
#include "tiltrotor/math/integrate.hpp"
#include "tiltrotor/systems/landing_gear.hpp"

namespace on_gear {

using namespace flight_cases;
using V = Vec3<double>;

// An aircraft on or above the ground, and its brakes.
template <class T>
struct Motion {
  Vec3<T> velocity, rates;
  T roll, pitch, yaw;
  Vec3<T> position;
  T brake[2];

  static constexpr int kCount = 14;
  template <class Self, class Visit>
  static constexpr void each(Self& s, Visit&& visit) {
    Vec3<T>::each(s.velocity, visit);
    Vec3<T>::each(s.rates, visit);
    visit(s.roll);
    visit(s.pitch);
    visit(s.yaw);
    Vec3<T>::each(s.position, visit);
    visit(s.brake[right]);
    visit(s.brake[left]);
  }
};

template <class T, class C>
GearLoads<T> loads_of(const Configuration<C>& c, const GroundPlane<double>& ground, const Motion<T>& m,
                      bool nose_locked = false) {
  GearLoads<T> out;
  const GearCommand<T> command = {true, nose_locked, {m.brake[right], m.brake[left]}};
  landing_gear(c, above_ground(ground, m.roll, m.pitch, m.yaw, m.position), m.velocity, m.rates, command,
               out);
  return out;
}

inline const StrutTables<double>& strut(const Configuration<double>& c, Strut which) {
  return which == Strut::nose ? c.aircraft->gear.nose : c.aircraft->gear.main;
}
inline StrutLoad<double> of(const GearLoads<double>& loads, Strut which) {
  return loads.strut[static_cast<int>(which)];
}
inline double weight(const Configuration<double>& c) { return c.mass.mass * kGravity<double>; }
// Of the CG over level ground with the aircraft at rest as the drawing has it, m.
inline double rest_height(const Configuration<double>& c) {
  return c.mass.wl_cg - c.aircraft->gear.ground_wl;
}
// Of the CG where the main wheels of a level aircraft touch, m.
inline double touching_height(const Configuration<double>& c) {
  return c.mass.wl_cg - extended_waterline(c.aircraft->gear, c.aircraft->gear.main);
}

inline Motion<double> at_height(double height) {
  Motion<double> m{};
  m.position.z = -height;
  return m;
}

// From the air to beyond the stops, in any heading.
inline Motion<double> random_motion(Generator& random, const Configuration<double>& c) {
  Motion<double> m = at_height(rest_height(c) + random.between(-0.5, 0.5));
  m.velocity = {random.between(-2, 20), random.between(-3, 3), random.between(-3, 3)};
  m.rates = {random.between(-0.4, 0.4), random.between(-0.4, 0.4), random.between(-0.4, 0.4)};
  m.roll = random.between(-0.15, 0.15);
  m.pitch = random.between(-0.15, 0.15);
  m.yaw = random.between(-3, 3);
  m.position.x = random.between(-2, 2);
  m.position.y = random.between(-2, 2);
  m.brake[right] = random.between(0, 1);
  m.brake[left] = random.between(0, 1);
  return m;
}
inline GroundPlane<double> random_ground(Generator& random) {
  return {random.between(-0.2, 0.2), random.between(-0.1, 0.1), random.between(-0.1, 0.1)};
}

// A rigid aircraft on its gear, its weight carried to a part by a lift that stays upright.
struct OnGear {
  const Configuration<double>& c;
  GroundPlane<double> ground{};
  double lift = 0;
  bool nose_locked = false;
  double brake = 0;

  Status operator()(double, const double* x, double* xdot) const {
    const Motion<double> m = motion(x);
    GearLoads<double> loads = loads_of(c, ground, m, nose_locked);
    const EulerAngles<double> attitude = {m.roll, m.pitch, m.yaw};
    loads.total.force = loads.total.force + earth_to_body(attitude).apply(V{0, 0, -lift * weight(c)});
    const RigidBodyRates<double> d =
        rigid_body(c.mass, m.velocity, m.rates, m.roll, m.pitch, m.yaw, loads.total);
    Motion<double> rates{};
    rates.velocity = d.velocity;
    rates.rates = d.rates;
    rates.roll = d.roll;
    rates.pitch = d.pitch;
    rates.yaw = d.yaw;
    rates.position = d.position;
    flatten(rates, xdot);
    return Status::ok;
  }
  Motion<double> motion(const double* x) const {
    Motion<double> m;
    unflatten(x, m);
    m.brake[right] = m.brake[left] = brake;
    return m;
  }
  double energy(const Motion<double>& m) const {
    const Inertia<double>& i = c.mass.inertia;
    const V& w = m.rates;
    const double turning = i.xx * w.x * w.x + i.yy * w.y * w.y + i.zz * w.z * w.z - 2 * i.xz * w.x * w.z;
    return 0.5 * (c.mass.mass * dot(m.velocity, m.velocity) + turning) -
           (1 - lift) * weight(c) * (m.position.z - ground.down);
  }
};

inline constexpr int kStates = Motion<double>::kCount;
template <class Watch>
Motion<double> moved(const OnGear& body, const Motion<double>& from, double duration, double dt,
                     Watch&& watch) {
  double x[kStates];
  flatten(from, x);
  RungeKuttaWorkspace<double, kStates> work;
  const int steps = static_cast<int>(std::lround(duration / dt));
  for (int n = 0; n < steps; ++n) {
    CHECK(rk4_step<double, kStates>(body, {n * dt, dt, x, kStates}, work) == Status::ok);
    watch(body.motion(x));
  }
  return body.motion(x);
}
inline Motion<double> settled(const OnGear& body, const Motion<double>& from, double duration = 20) {
  return moved(body, from, duration, 0.002, [](const Motion<double>&) {});
}

// Of the springs of a strut, J: oleo and, by the geometry of the wheel under the ground, tyre.
inline double stored(const OnGear& body, const Motion<double>& m, Strut which, double stroke) {
  const StrutTables<double>& s = strut(body.c, which);
  const double side = which == Strut::main_left ? -1 : 1;
  const double wl = extended_waterline(body.c.aircraft->gear, s);
  const V wheel = earth_to_body(EulerAngles<double>{m.roll, m.pitch, m.yaw})
                      .apply_inverse(station_arm(body.c.mass, s.sl, side * s.bl, wl));
  const double depth = m.position.z + wheel.z - body.ground.down;  // level ground
  const double tyre = std::max(depth, 0.0) / (std::cos(m.roll) * std::cos(m.pitch)) - stroke;
  return 0.5 * (s.oleo_stiffness * stroke * stroke + s.tyre_stiffness * tyre * tyre);
}

}  // namespace on_gear

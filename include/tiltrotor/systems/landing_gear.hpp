// Landing gear: three struts, nose and main, on a plane. Each is an oleo along body z with its tyres in series.
//
// Quasi-static: springs of oleo and tyre share the compression x at once, so that there is no state. With t = k_t/(k_t +
// k_o), exactly but for the widths of smooth_ramp() at contact and stop:
//   s = t x, at most the stroke;  F = k_t (x - s) + c s',  never below 0      x = depth/cos of the strut's tilt
//   N = F/cos, so that along the strut F acts; its power on the airframe is -F x'
// At the stop the tyre alone gives way. Left out: the 0.015 s in which the tyre takes up a blow of the damper.
//
// Friction on the wheels, no stiction: mu N tanh(v/v_s), against the motion of the point of contact over the ground. Main
// wheels keep their heading; brakes add to their rolling friction, and side force has what brakes leave of a circle of
// radius mu_side N. The nose wheel castors: it only rolls, along its own way, unless it is locked straight ahead.
#pragma once

#include "tiltrotor/math/hyperbolic_tangent.hpp"
#include "tiltrotor/model/airframe/airflow.hpp"
#include "tiltrotor/model/rigid_body.hpp"
#include "tiltrotor/systems/ground_plane.hpp"

namespace tiltrotor {

enum class Strut : unsigned char { nose, main_right, main_left, count };
inline constexpr int strut_count = static_cast<int>(Strut::count);

template <class T>
struct GearCommand {
  bool down;         // extended and locked; in transit and retracted it carries nothing
  bool nose_locked;  // straight ahead, for parking
  T brake[2];        // of the main wheels, right and left: 0 rolling .. 1 full
};

template <class T>
struct StrutLoad {
  T force;   // normal to the ground, N
  T stroke;  // of the oleo, m
};

template <class T>
struct GearLoads {
  Loads<T> total;
  StrutLoad<T> strut[strut_count];  // in the order of Strut
  T weight_on_wheels;               // normal forces over the weight: 0 in the air, 1 at rest on level ground

  static constexpr int kCount = 13;
  template <class Self, class Visit>
  static constexpr void each(Self& s, Visit&& visit) {
    Loads<T>::each(s.total, visit);
    for (auto& strut : s.strut) {
      visit(strut.force);
      visit(strut.stroke);
    }
    visit(s.weight_on_wheels);
  }
};
static_assert(lists_its_members<GearLoads>(), "each member of GearLoads is listed and counted");

// Waterline of the wheels' lowest point with the strut extended, m: below the ground under the aircraft at rest by what
// oleo and tyre give there.
template <class R>
R extended_waterline(const GearTables<R>& gear, const StrutTables<R>& strut) {
  return gear.ground_wl -
         gear.static_stroke * strut.stroke * (R(1) + strut.oleo_stiffness / strut.tyre_stiffness);
}

// Friction over normal force and speed, 1/(m/s): mu tanh(v/v_s)/v, finite at rest.
template <class R, class T>
T friction_slope(const GearTables<R>& gear, const T& mu, const T& speed2) {
  const R inverse = R(1) / gear.slip_speed;
  return inverse * mu * hyperbolic_tangent_over(T(square(inverse) * speed2));
}

// Friction of wheels with a heading, over their normal force. `up`: normal of the ground; `v`: of the point of contact.
template <class R, class T>
Vec3<T> wheel_friction(const Aircraft<R>& aircraft, const Vec3<T>& up, const Vec3<T>& v, const T& brake) {
  const GearTables<R>& g = aircraft.gear;
  // Body x along the ground, unit length below 45 deg of pitch.
  const T in_ground =
      g.least_cosine + smooth_ramp(T(R(1) - square(up.x) - g.least_cosine), aircraft.smooth.gear_cosine);
  const T unit = R(1) / sqrt(in_ground);
  const Vec3<T> ahead = unit * Vec3<T>{R(1) - square(up.x), -(up.x * up.y), -(up.x * up.z)};
  const Vec3<T> aside = cross(ahead, up);
  const T along = dot(v, ahead), across = dot(v, aside);
  const T mu = g.rolling + brake * (g.braking - g.rolling);
  const T rolling = friction_slope(g, mu, T(square(along))) * along;
  const T left_over = sqrt(T(square(g.side_friction) - square(rolling)));
  const T side = friction_slope(g, left_over, T(square(across))) * across;
  return -rolling * ahead - side * aside;
}
// Of wheels that castor.
template <class R, class T>
Vec3<T> castor_friction(const GearTables<R>& gear, const Vec3<T>& up, const Vec3<T>& v) {
  const Vec3<T> slip = v - dot(v, up) * up;
  return -friction_slope(gear, T(gear.rolling), T(dot(slip, slip))) * slip;
}

// One strut at buttock line `bl`: adds its loads. `velocity_b`: of the airframe at the CG over the ground.
template <class T, class C>
StrutLoad<T> add_strut(const Configuration<C>& c, const StrutTables<Real<T>>& strut, Real<T> bl, bool castors,
                       const AboveGround<T>& above, const Vec3<T>& velocity_b, const Vec3<T>& rates_b,
                       const T& brake, Loads<T>& total) {
  using R = Real<T>;
  const GearTables<R>& g = c.aircraft->gear;
  const SmoothingWidths<R>& e = c.aircraft->smooth;
  const Vec3<T>& up = above.up_b;
  const Vec3<C> extended = station_arm(c.mass, strut.sl, bl, extended_waterline(g, strut));
  const T upright = g.least_cosine + smooth_ramp(T(-up.z - g.least_cosine), e.gear_cosine);
  const T x = -height_of(above, extended) / upright;
  if (value(x) <= R(-0.5) * e.gear_contact) return {T(R(0)), T(R(0))};  // where all that follows is zero

  const R share = strut.tyre_stiffness / (strut.tyre_stiffness + strut.oleo_stiffness);
  const T compression = smooth_ramp(x, e.gear_contact);
  const T touches = smooth_step(T(x * (R(1) / e.gear_contact) + R(0.5)));  // its slope along x
  const T beyond = share * compression - strut.stroke;
  const T stroke = share * compression - smooth_ramp(beyond, e.gear_stop);
  const T stroke_slope = share * touches * (R(1) - smooth_step(T(beyond * (R(1) / e.gear_stop) + R(0.5))));

  const Vec3<T> arm = {T(extended.x), T(extended.y), extended.z - compression};
  const Vec3<T> v = velocity_b + cross(rates_b, arm);
  const T closing = -dot(v, up) / upright;
  const T along =
      strut.tyre_stiffness * (compression - stroke) + strut.oleo_damping * (stroke_slope * closing);
  const T normal = touches * smooth_ramp(along, e.gear_force) / upright;
  const Vec3<T> friction = castors ? castor_friction(g, up, v) : wheel_friction(*c.aircraft, up, v, brake);
  total = total + force_at(arm, normal * (up + friction));
  return {normal, stroke};
}

// Loads about the CG, body axes. `velocity_b`: of the CG over the ground, m/s; `rates_b` rad/s. Defined and smooth
// everywhere; exactly zero, with all derivatives, from half of smooth_gear_contact above the ground.
template <class T, class C>
void landing_gear(const Configuration<C>& c, const AboveGround<T>& above, const Vec3<T>& velocity_b,
                  const Vec3<T>& rates_b, const GearCommand<T>& command, GearLoads<T>& out) {
  using R = Real<T>;
  GearLoads<T>::each(out, [](T& number) { number = T(R(0)); });
  if (!command.down) return;
  const GearTables<R>& g = c.aircraft->gear;
  const Vec3<T> v = airframe_velocity(velocity_b, c.mass.nacelles);
  out.strut[0] = add_strut(c, g.nose, g.nose.bl, !command.nose_locked, above, v, rates_b, T(R(0)), out.total);
  for (const Side side : {right, left})
    out.strut[1 + side] = add_strut(c, g.main, side_sign<R>(side) * g.main.bl, false, above, v, rates_b,
                                    command.brake[side], out.total);
  const T normal = out.strut[0].force + out.strut[1].force + out.strut[2].force;
  out.weight_on_wheels = normal * (R(1) / (c.mass.mass * kGravity<R>));
}

// Drag of the gear, `extension` 0 retracted .. 1 extended of its area, at the struts' mean station. `velocity_b`,
// `rates_b`: of the airframe at the CG relative to the air, m/s and rad/s.
template <class T, class C>
Loads<T> gear_drag(const Configuration<C>& c, const T& extension, const Vec3<T>& velocity_b,
                   const Vec3<T>& rates_b) {
  using R = Real<T>;
  const GearTables<R>& g = c.aircraft->gear;
  const Vec3<C> arm = station_arm(c.mass, (g.nose.sl + R(2) * g.main.sl) / R(3), R(0), g.drag_wl);
  const Vec3<T> v = velocity_b + rate_cross_arm(rates_b, arm);
  const T scale =
      R(-0.5) * c.air.density * g.drag_area * extension * total_speed(v, c.aircraft->smooth.drag_speed);
  return force_at(arm, scale * v);
}

}  // namespace tiltrotor

// Radial shape of the mean inflow. Momentum balanced ring by ring makes an optimum rotor's inflow uniform and
// every other one's stronger outboard: Gessow and Myers, Aerodynamics of the Helicopter (1952), ch. 4;
// Leishman, Principles of Helicopter Aerodynamics (2006), sec. 3.3.
//
//   v(r, psi) = Omega R { lambda_0 [1 + c (s(x) - 1)] + x (lambda_c cos psi + lambda_s sin psi) },  x = r/R
//
// s(x), the shape in hover, hardly changes with thrust; it is found once, from the rotor's own blade, at the
// thrust and tip Mach number of a design hover. c, the cosine of the wake's skew, is 1 in axial flow and fades the shape out in
// forward flight, to which ring by ring balance does not apply (derived here).
#pragma once

#include <limits>

#include "tiltrotor/math/bracketed_root.hpp"
#include "tiltrotor/model/rotor/blade_element.hpp"
#include "tiltrotor/model/rotor/rotor_input.hpp"

namespace tiltrotor {

// Part of the mean inflow that follows the shape: c = lambda_+ / V_T of the inflow law. In descent it fades out from the
// end of momentum theory to the descent at which no air passes the disk. Choosing there is safe: the fade begins and
// ends with two zero derivatives. `even`: mean inflow, m/s.
template <class T, class C, class S>
T radial_inflow(const Configuration<C>& c, const RotorConditions<S>& turn, const RotorInput<T>& in,
                const T& even) {
  using R = Real<T>;
  const SmoothingWidths<R>& e = c.aircraft->smooth;
  const S inverse_tip = R(1) / turn.tip_speed;
  const T mu_x = in.velocity_a.x * inverse_tip;
  const T mu_y = in.velocity_a.y * inverse_tip;
  const T mu_z = in.velocity_a.z * inverse_tip;
  const T through = mu_z + in.state.lambda_0;
  const T vt = sqrt(T(mu_x * mu_x + mu_y * mu_y + through * through + square(e.inflow_speed)));
  T shaped = even * (smooth_positive(through, e.through_flow) / vt);
  if (value(mu_z) >= R(0)) return shaped;
  if (value(through) <= R(0)) return T(R(0) * shaped);
  const R start = c.aircraft->inflow.shape_descent;
  const T descent = -mu_z / in.state.lambda_0;  // below 1, since air passes down
  return T(shaped * (R(1) - smooth_step(T((descent - start) * (R(1) / (R(1) - start))))));
}

template <class T, class C, class S>
FeltInflow<T> felt_inflow(const Configuration<C>& c, const RotorConditions<S>& turn,
                          const RotorInput<T>& in) {
  const T even = (turn.tip_speed * turn.ground_wash) * in.state.lambda_0;
  return {even, radial_inflow(c, turn, in, even)};
}

// A blade in hover, each ring in balance with its own momentum.
template <class R>
struct AnnularHover {
  const Configuration<R>& c;  // its fixed setup and its air
  R omega;                    // rad/s
  R collective;               // rad, at the reference radius

  static constexpr R resolution() { return R(8) * std::numeric_limits<R>::epsilon(); }  // relative

  // Of one blade element at the induced speed v, N.
  R lift(int region, const BladeStation<R>& s, R v) const {
    return element_loads<R>(c, region, s, element_air(c.air.density, c.air.speed_of_sound),
                            {omega * s.radius, v, collective + s.twist})
        .normal;
  }
  // Where the lift of all blades is the change of momentum, dT = 4 pi rho r v^2 dr.
  R induced_speed(int region, const BladeStation<R>& s) const {
    const RotorTables<R>& rotor = c.aircraft->rotor;
    const R chord = blade_chord(rotor, c.setup.options.chord, s.radius / rotor.radius);
    const R ring = R(4) * kPi<R> * c.air.density * s.radius * (R(2) * s.half_chord_dr / chord);
    const R tip_speed = omega * rotor.radius;
    return bracketed_root(
        [&](R v) { return static_cast<R>(rotor.blades) * lift(region, s, v) - ring * v * v; }, R(0),
        tip_speed, resolution() * tip_speed);
  }
};

// Induced speed at every station in m/s, outside the tip-loss radius that of the last station inside; the result
// is the thrust coefficient.
template <class R>
R annular_inflow(const AnnularHover<R>& hover, R* speed) {
  const RotorTables<R>& rotor = hover.c.aircraft->rotor;
  R thrust = R(0);
  R v = R(0);
  int i = 0;
  for (int region = 0; region < kSectionRegions; ++region) {
    for (; i < hover.c.blade.region_end[region]; ++i) {
      const BladeStation<R>& s = hover.c.blade.station[i];
      if (s.lift_weight > R(0)) v = hover.induced_speed(region, s);
      thrust += static_cast<R>(rotor.blades) * hover.lift(region, s, v);
      speed[i] = v;
    }
  }
  const R tip_speed = hover.omega * rotor.radius;
  return thrust / (hover.c.air.density * kPi<R> * square(rotor.radius * tip_speed));
}

// Sets the inflow shape of every station, s(x) - 1, and leaves in c.air the air of the design hover. `c`: its
// fixed setup and its options are set.
// Cost: some forty derivatives of the real-time grid.
template <class R>
void shape_mean_inflow(Configuration<R>& c) {
  const RotorTables<R>& rotor = c.aircraft->rotor;
  const R thrust = c.aircraft->inflow.shape_thrust;
  const R highest = R(40) * kRadPerDeg<R>;
  R speed[kMaxBladeStations];
  c.air = standard_air(R(0));
  c.air.speed_of_sound = rotor.speed_helicopter * rotor.radius / c.aircraft->inflow.shape_tip_mach;
  AnnularHover<R> hover{c, rotor.speed_helicopter, R(0)};
  hover.collective = bracketed_root(
      [&](R collective) {
        hover.collective = collective;
        return annular_inflow(hover, speed) - thrust;
      },
      R(0), highest, hover.resolution());
  annular_inflow(hover, speed);
  const R mean = sqrt(R(0.5) * thrust) * hover.omega * rotor.radius;
  for (int i = 0; i < c.blade.count; ++i) c.blade.station[i].inflow_shape = speed[i] / mean - R(1);
}

}  // namespace tiltrotor

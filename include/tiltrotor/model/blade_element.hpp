// Aerodynamic load of one blade element and of one blade.
//
// At a given azimuth the flow along a blade is linear in radius, so five numbers describe it whatever the state of
// the aircraft: BladeFlow. That is the waist through which the derivatives of a blade pass.
#pragma once

#include "tiltrotor/math/smooth.hpp"
#include "tiltrotor/math/waist.hpp"
#include "tiltrotor/model/configuration.hpp"

namespace tiltrotor {

// Flow seen by one blade: U_T = tangential_0 + r tangential_r (positive onto the leading edge),
// U_P = normal_0 + r normal_r (positive from above), and its pitch at the collective's reference radius.
template <class T>
struct BladeFlow {
  T tangential_0, tangential_r;  // m/s, 1/s
  T normal_0, normal_r;          // m/s, 1/s
  T pitch;                       // rad

  static constexpr int kCount = 5;
  template <class Self, class Visit>
  static void each(Self& s, Visit&& visit) {
    visit(s.tangential_0);
    visit(s.tangential_r);
    visit(s.normal_0);
    visit(s.normal_r);
    visit(s.pitch);
  }
};

// Loads of one blade: along the blade normal (up) and the direction of rotation, and their first radial moments.
template <class T>
struct BladeLoads {
  T normal, tangential;                // N
  T normal_moment, tangential_moment;  // N m

  static constexpr int kCount = 4;
  template <class Self, class Visit>
  static void each(Self& s, Visit&& visit) {
    visit(s.normal);
    visit(s.tangential);
    visit(s.normal_moment);
    visit(s.tangential_moment);
  }
};

template <class T>
struct SectionCoefficients {
  T lift, drag;
};

// Section coefficients at angle of attack `alpha` (rad, -pi..pi) and Mach number: the table of the spanwise region
// inside its range of alpha, blended over `stall_blend` degrees to a flat plate outside. Beyond the last Mach column
// the column holds.
template <class T>
SectionCoefficients<T> section_coefficients(const RotorTables<Real<T>>& rotor, Interpolation mode, int region,
                                            const T& alpha, const T& mach) {
  using R = Real<T>;
  const Table<R, 2>& lift = rotor.section_lift[region];
  const Table<R, 2>& drag = rotor.section_drag[region];
  const T alpha_deg = alpha * kDegree<R>;
  SectionCoefficients<T> c{lookup(lift, mode, alpha_deg, mach), lookup(drag, mode, alpha_deg, mach)};
  const Axis<R>& range = lift.smooth[0];
  const R low = range.knot[0];
  const R high = range.knot[range.count - 1];
  const R a = value(alpha_deg);
  if (a > low && a < high) return c;  // the blend starts with zero slope and curvature at the ends
  const T beyond = a >= high ? alpha_deg - high : low - alpha_deg;
  const T plate = smooth_step(beyond * (R(1) / rotor.stall_blend));
  const T sine = sin(alpha);
  const T plate_lift = R(2) * rotor.plate_lift * sine * cos(alpha);
  const T plate_drag = rotor.plate_drag_min + rotor.plate_drag * sine * sine;
  c.lift = c.lift + plate * (plate_lift - c.lift);
  c.drag = c.drag + plate * (plate_drag - c.drag);
  return c;
}

// Sum over the stations of one blade. Valid in reverse flow: the angle of attack runs over the full circle.
template <class T>
BladeLoads<T> blade_loads(const Configuration<Real<T>>& c, const BladeFlow<T>& flow) {
  using R = Real<T>;
  const RotorTables<R>& rotor = c.aircraft->rotor;
  const Interpolation mode = c.setup.options.tables;
  const R speed_floor2 = square(c.aircraft->smooth.section_speed);
  const R inverse_sound = R(1) / c.air.speed_of_sound;
  BladeLoads<T> sum{T(R(0)), T(R(0)), T(R(0)), T(R(0))};
  int i = 0;
  for (int region = 0; region < kSectionRegions; ++region) {
    for (; i < c.blade.region_end[region]; ++i) {
      const BladeStation<R>& s = c.blade.station[i];
      const T ut = flow.tangential_0 + s.radius * flow.tangential_r;
      const T up = flow.normal_0 + s.radius * flow.normal_r;
      const T speed = sqrt(ut * ut + up * up + speed_floor2);
      const T alpha = wrapped_difference(flow.pitch + s.twist, atan2(up, ut));
      const SectionCoefficients<T> k = section_coefficients(rotor, mode, region, alpha, speed * inverse_sound);
      // dF_n = 1/2 rho U c dr (cl U_T - cd U_P),  dF_t = -1/2 rho U c dr (cl U_P + cd U_T)
      const T scale = (c.air.density * s.half_chord_dr) * speed;
      const T lift = s.lift_weight * k.lift;
      const T normal = scale * (lift * ut - k.drag * up);
      const T tangential = -(scale * (lift * up + k.drag * ut));
      sum.normal += normal;
      sum.tangential += tangential;
      sum.normal_moment += s.radius * normal;
      sum.tangential_moment += s.radius * tangential;
    }
  }
  return sum;
}

}  // namespace tiltrotor

// The part of one half wing inside its rotor's wake (structure of GTRS, NASA CR-166536; wash factor and
// centre of pressure from replaying the printed runs of NASA CR-166537, load factor in choices.csv).
#pragma once

#include "tiltrotor/model/airframe/rotor_wake.hpp"
#include "tiltrotor/model/airframe/wing_coefficients.hpp"

namespace tiltrotor {

template <class T>
struct WingInWake {
  ImmersedWing<T> immersed;
  Vec3<T> velocity;  // of the part relative to the air, wash included, m/s
  T pressure;        // dynamic pressure there, Pa
  Loads<T> loads;
};

// The centre of pressure moves from quarter chord at zero angle of attack to mid chord in the vertical wash
// of hover.
template <class T, class C>
void wing_in_wake(const Configuration<C>& c, const AirframeInput<T>& in, const FreeStream<T>& stream,
                  int side, WingInWake<T>& out) {
  using R = Real<T>;
  const WingTables<R>& wing = c.aircraft->wing;
  const SmoothingWidths<R>& e = c.aircraft->smooth;
  const Vec3<C> line = station_arm(c.mass, wing.sl, R(0), wing.wl);
  out.immersed = immersed_wing(c, in, stream, side);
  Vec3<T> arm = {T(line.x), side_sign<R>(side) * out.immersed.lateral, T(line.z)};
  out.velocity = in.velocity_b + cross(in.rates_b, arm) + along(out.immersed.wash, c.nacelle_axis_b);
  out.pressure = R(0.5) * c.air.density * dot(out.velocity, out.velocity);

  const T alpha = angle_of_attack(out.velocity, e);
  const T beta = sideslip_angle(out.velocity, e.lateral_plane_speed);
  const WingCoefficients<T> k = wing_coefficients(c, alpha, stream.mach);
  const T scale = c.download * c.wing.wake_load_factor * (out.pressure * out.immersed.area);
  const SineCosine<T> attack = sine_and_cosine(alpha);
  const Vec3<T> force = wind_force(T(scale * k.lift), T(scale * k.drag), attack, sine_and_cosine(beta));
  arm.x = arm.x - (wing.chord / R(4)) * attack.sine * attack.sine;
  out.loads = {force, cross(arm, force)};
}

}  // namespace tiltrotor

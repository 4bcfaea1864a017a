// The C interface: rates and what an instrument would read.
#include <cmath>

#include "library/c_memory.hpp"

using namespace tiltrotor;
using namespace tiltrotor::c_interface;

tr_status tr_derivative(const tr_sim* sim, tr_real* rates, size_t length) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  if (rates == nullptr) return TR_BAD_ARGUMENT;
  if (length < TR_STATES) return TR_SHORT_BUFFER;
  const Sim& s = *opened(sim);
  Configuration<R> room;
  State<R> xdot;
  derivative(equipped(s, room), evaluated_state(s), s.u, xdot);
  pack(xdot, rates);
  return all_finite(rates, TR_STATES) ? TR_OK : TR_NOT_FINITE;
}

tr_status tr_get_outputs(const tr_sim* sim, tr_outputs* outputs) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  if (outputs == nullptr) return TR_BAD_ARGUMENT;
  const Sim& s = *opened(sim);
  Configuration<R> room;
  const Configuration<R>& c = equipped(s, room);
  Evaluation<R> e;
  evaluate(c, evaluated_state(s), s.u, e);
  const Vec3<R> v = s.x.velocity - s.u.gust;  // relative to the air
  const BladeControls<R> blades = mix_controls(c, s.u, v);

  tr_outputs& o = *outputs;
  const R airspeed = std::sqrt(dot(v, v));
  o.time_s = s.time;
  o.airspeed_mps = airspeed;
  o.angle_of_attack_rad = airspeed > R(0) ? atan2(v.z, v.x) : R(0);
  o.sideslip_rad = airspeed > R(0) ? atan2(v.y, std::sqrt(v.x * v.x + v.z * v.z)) : R(0);
  Vec3<R> force{};
  for (const Loads<R>& loads : e.loads.component) force = force + loads.force;
  const R per_mass = R(1) / c.mass.mass;
  o.specific_force_mps2[0] = force.x * per_mass;
  o.specific_force_mps2[1] = force.y * per_mass;
  o.specific_force_mps2[2] = force.z * per_mass;
  o.load_factor = -(force.z * per_mass) / kGravity<R>;
  o.climb_rate_mps = -e.rates.position.z;
  for (int side = 0; side < 2; ++side) {
    const RotorLoads<R>& rotor = e.rotor[side].loads;
    const RotorState<R>& x = s.x.rotor[side];
    o.thrust_n[side] = std::sqrt(dot(rotor.force, rotor.force));
    o.torque_nm[side] = rotor.torque;
    o.power_w[side] = rotor.torque * c.setup.rotor_speed;
    o.collective_rad[side] = blades.collective[side];
    o.long_cyclic_rad[side] = blades.long_cyclic[side];
    o.gimbal_tilt_rad[side] = std::sqrt(x.b1c * x.b1c + x.b1s * x.b1s);
  }
  o.elevator_rad = blades.elevator;
  o.aileron_rad = blades.aileron;
  o.rudder_rad = blades.rudder;
  const bool finite = is_finite(o.load_factor) && is_finite(o.power_w[0]) && is_finite(o.power_w[1]) &&
                      all_finite(o.specific_force_mps2, 3);
  return finite ? TR_OK : TR_NOT_FINITE;
}

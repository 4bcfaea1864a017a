// Net thrust of the engines' jets along the nacelles: gross thrust less the drag of the air they take in.
#pragma once

#include "tiltrotor/model/airframe/airflow.hpp"

namespace tiltrotor {

// All engines together, at the conversion axis (NASA CR-166537 pp.: the printed moments), in N and
// N m. `rotor_power`: shaft power of both rotors, W; `speed`: of the aircraft through the air, m/s. The source
// has two coefficients against speed, T = K_JT1(V) + K_JT2(V) P (NASA CR-166536, subsystem 18); its tables are
// not public. Momentum gives both linear in V:
//   T = F(P) - m(P) V,  F = F_0 + F_1 P,  m = m_0 + m_1 P,
// with the referred quantities of a turbine away from sea level: F/delta and m sqrt(theta)/delta against
// P/(delta sqrt(theta)). Engines that the rotors drive idle.
template <class T, class C>
Loads<T> engine_jet_loads(const Configuration<C>& c, const T& rotor_power, const T& speed) {
  using R = Real<T>;
  const EngineJetTables<R>& j = c.aircraft->jet;
  const Air<R> sea_level = standard_air(R(0));
  const C theta = c.air.temperature * (R(1) / sea_level.temperature);
  const C delta = c.air.density * (R(1) / sea_level.density) * theta;
  const C root = sqrt(theta);
  const T power = smooth_positive(rotor_power, c.aircraft->smooth.engine_power);
  const T gross = j.thrust * delta + (j.thrust_per_power / root) * power;
  const T airflow = j.airflow * delta / root + (j.airflow_per_power / theta) * power;
  return force_at(c.pivot_arm_b, along(T(gross - airflow * speed), c.nacelle_axis_b));
}

}  // namespace tiltrotor

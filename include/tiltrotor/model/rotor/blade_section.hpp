// Lift and drag of a blade section.
#pragma once

#include "tiltrotor/math/smooth.hpp"
#include "tiltrotor/math/tables/table.hpp"
#include "tiltrotor/model/aircraft/rotor_tables.hpp"

namespace tiltrotor {

template <class T>
struct SectionCoefficients {
  T lift, drag;
};

// Section coefficients at angle of attack `alpha` (rad, -pi..pi) and Mach number: the table of the spanwise
// region inside its range of alpha, blended over `stall_blend` degrees to a flat plate outside. Beyond the
// last Mach column the column holds. Lift and drag share the search along their axes, and the cell, where these are equal.
template <class T>
TILTROTOR_INLINE SectionCoefficients<T> section_coefficients(const RotorTables<Real<T>>& rotor,
                                                             Interpolation mode, int region, const T& alpha,
                                                             const T& mach) {
  using R = Real<T>;
  const Table<R, 2>& lift = rotor.section_lift[region];
  const Table<R, 2>& drag = rotor.section_drag[region];
  const T alpha_deg = alpha * kDegPerRad<R>;
  Bracket<T> at_alpha = bracket_on_grid(lift.smooth[0], mode, alpha_deg);
  Bracket<T> at_mach = bracket_on_grid(lift.smooth[1], mode, mach);
  const bool outside = any(at_alpha.outside | at_mach.outside);
  if (outside) {
    fade_outside(lift.smooth[0], mode, at_alpha);
    fade_outside(lift.smooth[1], mode, at_mach);
  }
  SectionCoefficients<T> c;
  const Bracket<T>* const at[] = {&at_alpha, &at_mach};
  TableCell<T> cell(lift.smooth, at);
  c.lift = lookup(lift, cell, at);
  if (drag.smooth[0].knot != lift.smooth[0].knot || drag.smooth[1].knot != lift.smooth[1].knot) {
    at_alpha = bracket(drag.smooth[0], mode, alpha_deg);
    at_mach = bracket(drag.smooth[1], mode, mach);
    cell = TableCell<T>(drag.smooth, at);
  }
  c.drag = lookup(drag, cell, at);

  const Axis<R>& range = lift.smooth[0];
  const R low_deg = range.knot[0];
  const R high_deg = range.knot[range.count - 1];
  const auto a = value(alpha_deg);
  if (!outside) return c;  // the blend starts with zero slope and curvature at the ends
  const T beyond = select(a >= high_deg, T(alpha_deg - high_deg), T(low_deg - alpha_deg));
  const T plate = smooth_step(T(beyond * (R(1) / rotor.stall_blend)));
  // Flat plate beyond stall, cl = 1.1 sin 2 alpha, cd = 0.02 + 1.9 sin^2 alpha: choices.csv, plate_*.
  const auto [sine, cosine] = sine_and_cosine(alpha);
  const T plate_lift = R(2) * rotor.plate_lift * sine * cosine;
  const T plate_drag = rotor.plate_drag_min + rotor.plate_drag * sine * sine;
  c.lift = c.lift + plate * (plate_lift - c.lift);
  c.drag = c.drag + plate * (plate_drag - c.drag);
  return c;
}

}  // namespace tiltrotor

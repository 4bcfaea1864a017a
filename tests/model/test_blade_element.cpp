// Coefficients of a blade section. Expected values: a flat plate beyond the tables, the lift slope of a section, knots
// of its own for drag.
#include "flight_cases.hpp"

using namespace flight_cases;

// Section coefficients beyond the table: a flat plate over the whole circle, without a step.
TEST(rotor_section_coefficients_all_around) {
  const RotorTables<double>& rotor = aircraft().rotor;
  for (int region = 0; region < kSectionRegions; ++region) {
    double last_lift = 0;
    double last_drag = 0;
    for (int k = 0; k <= 3600; ++k) {
      const double alpha = (-180 + 0.1 * k) * kRadPerDeg<double>;
      const SectionCoefficients<double> s =
          section_coefficients(rotor, Interpolation::c1, region, alpha, 0.4);
      if (k > 0) {
        CHECK_NEAR(s.lift, last_lift, 0.06);
        CHECK_NEAR(s.drag, last_drag, 0.06);
      }
      if (alpha > 36 * kRadPerDeg<double> || alpha < -16 * kRadPerDeg<double>) {
        CHECK_NEAR(s.lift, 1.1 * std::sin(2 * alpha), 1e-12);
        CHECK_NEAR(s.drag, 0.02 + 1.9 * std::pow(std::sin(alpha), 2), 1e-12);
      }
      last_lift = s.lift;
      last_drag = s.drag;
    }
  }
  // Small angles: the table's lift slope is that of a section, 5.5..6.7 per radian at Mach 0.4.
  const double slope = (section_coefficients(rotor, Interpolation::c1, 2, 0.03, 0.4).lift -
                        section_coefficients(rotor, Interpolation::c1, 2, 0.0, 0.4).lift) /
                       0.03;
  CHECK(slope > 5.3 && slope < 7.0);
}

// Lift and drag of this aircraft share their axes; with knots of their own, equal ones, nothing changes.
TEST(rotor_section_drag_on_axes_of_its_own) {
  RotorTables<double> rotor = aircraft().rotor;
  double knots[2][kMaxKnots];
  for (int axis = 0; axis < 2; ++axis) {
    const Axis<double>& shared = rotor.section_drag[1].smooth[axis];
    std::copy(shared.knot, shared.knot + shared.count, knots[axis]);
  }
  for (int own = 1; own < 4; ++own) {
    for (int axis = 0; axis < 2; ++axis)
      rotor.section_drag[1].smooth[axis].knot =
          (own >> axis & 1) != 0 ? knots[axis] : aircraft().rotor.section_drag[1].smooth[axis].knot;
    for (double alpha = -0.25; alpha < 0.4; alpha += 0.05) {
      for (double mach : {0.1, 0.45, 0.7}) {
        const SectionCoefficients<double> a =
            section_coefficients(aircraft().rotor, Interpolation::c1, 1, alpha, mach);
        const SectionCoefficients<double> b = section_coefficients(rotor, Interpolation::c1, 1, alpha, mach);
        CHECK(a.lift == b.lift && a.drag == b.drag);
      }
    }
  }
}

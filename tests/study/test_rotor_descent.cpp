// The rotor alone from climb to windmill, against the measured rotors of NACA TN 2474.
// Expected: the printed points; blade-element theory in closed form; the step of the study.
#include <algorithm>
#include <cmath>

#include "check.hpp"
#include "study/reference_points.hpp"
#include "study/sections.hpp"
#include "tiltrotor/math/scalar.hpp"

using namespace tiltrotor::study;

namespace {

const Table& table(const Section& section, const std::string& name) {
  for (const NumberedTable& t : section.tables)
    if (t.name == name) return t.table;
  throw std::logic_error(name);
}

// Linear between the points of one measured rotor.
double measured(const Table& points, double descent) {
  for (std::size_t i = 1; i < points.rows(); ++i) {
    const double a = points.number(i - 1, "descent_over_vh"), b = points.number(i, "descent_over_vh");
    if (descent < a || descent > b) continue;
    const double part = (descent - a) / (b - a);
    return (1 - part) * points.number(i - 1, "total_inflow_over_vh") +
           part * points.number(i, "total_inflow_over_vh");
  }
  return NAN;
}

}  // namespace

// Two readings of one report: inflow of the figure, and from the table's thrust and pitch of untwisted blades
// of constant chord, CT = sigma a/2 (theta_75/3 - lambda/2) with sigma 0.05, a 5.75.
TEST_OF_XV15(report_measured_descents_agree_with_each_other) {
  const Table figure = reference_points("rotor_descent").where("twist_deg", std::string("0"));
  const Table runs = reference_points("rotor_descent_runs");
  int compared = 0;
  for (std::size_t i = 0; i < runs.rows(); ++i) {
    const double descent = runs.number(i, "descent_over_vh"), ct = runs.number(i, "ct");
    const double hover = std::sqrt(ct / 2),
                 pitch = runs.number(i, "collective75_deg") * tiltrotor::kRadPerDeg<double>;
    CHECK_NEAR(runs.number(i, "speed_over_tip") / hover, descent, 0.06 * descent + 0.01);
    if (descent > 1.4) continue;
    const double inflow = 2 * (pitch / 3 - 2 * ct / (0.05 * 5.75)) / hover;
    if (!CHECK_NEAR(inflow, measured(figure, descent), 0.2))
      NOTE("run " << runs.text(i, "run") << ", " << descent);
    ++compared;
  }
  CHECK(compared > 50);
}

// Within 0.3 v_h of both rotors until the ring opens, then between them as far as they differ, at last the
// windmill of momentum theory, up to 0.7 v_h below the measured inflow. Never a jump.
TEST_OF_XV15(report_rotor_descent_follows_the_measured_rotors) {
  const Section section = rotor_descent();
  const Table points = reference_points("rotor_descent");
  const Table plain = points.where("twist_deg", std::string("0")),
              twisted = points.where("twist_deg", std::string("-12"));
  const Table& here = table(section, "rotor_descent");
  CHECK(here.rows() > 110);
  double last = NAN;
  for (std::size_t i = 0; i < here.rows(); ++i) {
    const double d = here.number(i, "descent_over_vh"), inflow = here.number(i, "total_inflow_over_vh");
    if (!CHECK(!(std::fabs(inflow - last) > 0.25))) NOTE("descent " << d);
    last = inflow;
    CHECK_EQ(here.text(i, "status"), std::string(d > 0.45 && d < 1.5 ? "vortex_ring" : "ok"));
    const double a = measured(plain, d), b = measured(twisted, d);
    if (!std::isfinite(a) || !std::isfinite(b)) continue;
    const double above = d < 1.95 ? 0.3 : 0.7;
    if (!CHECK(inflow > std::min(a, b) - above && inflow < std::max(a, b) + 0.3)) NOTE("descent " << d);
    if (d < 1.4) CHECK(std::fabs(inflow - a) < 0.3 && std::fabs(inflow - b) < 0.3);
  }
  const Table& ends = table(section, "autorotation_compared");
  CHECK_EQ(ends.rows(), 8u);
  for (std::size_t i = 0; i < ends.rows(); ++i) {
    CHECK_NEAR(ends.number(i, "measured"), 1.9, 0.11);
    CHECK_NEAR(ends.number(i, "here"), 1.89, 0.01);
  }
  for (const Finding& f : section.findings) CHECK(f.verdict != Finding::differs);
}

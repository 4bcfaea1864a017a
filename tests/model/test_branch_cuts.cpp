// Continuity through every place where an angle of the flow jumps or a law
// ends: the model's rates and their slopes on both sides of it, along straight
// lines through the place. A function that is C1 changes by its slope times the
// step, on either side; that is the criterion, whatever the formulas are.
#include <algorithm>
#include <cmath>

#include "flight_cases.hpp"

using namespace flight_cases;

namespace {

using D = Dual<double, 1>;

struct Line {
  const char* name;
  Vec3<double> at,
      along;  // velocity on the cut, and the direction that crosses it
};

// Rearward flight with w, v through zero and both, straight down and up,
// sideways, hover.
const Line kLines[] = {
    {"rearward, w through 0", {-20, 0, 0}, {0, 0, 1}},
    {"slowly rearward, w through 0", {-1, 0, 0}, {0, 0, 1}},
    {"rearward and sideways, w through 0", {-15, 6, 0}, {0, 0, 1}},
    {"fast rearward, w through 0", {-80, 0, 0}, {0, 0.3, 1}},
    {"rearward, v through 0", {-20, 0, 3}, {0, 1, 0}},
    {"rearward, v and w through 0", {-20, 0, 0}, {0, 1, -1}},
    {"hover, u through 0", {0, 0, 0}, {1, 0, 0}},
    {"hover, w through 0", {0, 0, 0}, {0, 0, 1}},
    {"hover, v through 0", {0, 0, 0}, {0, 1, 0}},
    {"down, u through 0", {0, 0, 8}, {1, 0, 0}},
    {"up, u and v through 0", {0, 0, -8}, {1, 1, 0}},
    {"sideways, u through 0", {0, 12, 0}, {1, 0, 0}},
    {"sideways, w through 0", {0, -12, 0}, {0, 0, 1}},
    {"forward, w through 0", {40, 0, 0}, {0, 0, 1}},
};

StateAndControls<D> on_line(const StateAndControls<double>& s, const Line& line, double distance) {
  StateAndControls<D> c{converted<D>(s.x), converted<D>(s.u)};
  const D t = D::variable(distance, 0);
  c.x.velocity = {line.at.x + t * line.along.x, line.at.y + t * line.along.y, line.at.z + t * line.along.z};
  return c;
}

std::array<D, state_count> rates_at(const Configuration<double>& c, const StateAndControls<double>& s,
                                    const Line& line, double distance) {
  const StateAndControls<D> here = on_line(s, line, distance);
  State<D> rates;
  derivative(c, here.x, here.u, rates);
  return flat(rates);
}

// Largest jump of value and slope across the cut, relative to the larger of 1
// and the numbers there.
void check_line(const Configuration<double>& c, const StateAndControls<double>& s, const Line& line,
                double mast) {
  constexpr double step = 1e-7;
  const auto before = rates_at(c, s, line, -step);
  const auto after = rates_at(c, s, line, step);
  double jump = 0, kink = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const D& a = before[i];
    const D& b = after[i];
    CHECK(std::isfinite(a.v) && std::isfinite(b.v) && std::isfinite(a.d.get(0)) && std::isfinite(b.d.get(0)));
    const double expected = step * (a.d.get(0) + b.d.get(0));
    const double size = std::max({1.0, std::fabs(a.v), std::fabs(a.d.get(0))});
    jump = std::max(jump, std::fabs(b.v - a.v - expected) / size);
    kink = std::max(kink, std::fabs(b.d.get(0) - a.d.get(0)) / size);
  }
  if (!CHECK_LT(jump, 1e-10)) NOTE(line.name << ", mast " << mast);
  if (!CHECK_LT(kink, 2e-4)) NOTE(line.name << ", mast " << mast);
}

}  // namespace

TEST_OF_XV15(derivatives_are_continuous_through_every_branch_cut) {
  Generator random(77);
  for (const double mast : {0.0, 30.0, 60.0, 90.0}) {
    for (const bool fitted : {false, true}) {
      Options options;
      if (fitted) options.tail_wash = TailWash::closed_form;
      options.downwash_lag = !fitted;
      const Configuration<double> c = configuration(mast, options);
      for (int n = 0; n < 4; ++n) {
        StateAndControls<double> s = random_case(random, c);
        s.u.gust = {0, 0, 0};
        if (n == 0) s.x.rates = {0, 0, 0};
        for (const Line& line : kLines) check_line(c, s, line, mast);
      }
    }
  }
}

// The angle of the free wing, which carries the rotors' wash: it passes 180 deg
// beside the cut of w = 0.
TEST(derivatives_are_continuous_through_wing_angle_of_180_deg) {
  Generator random(78);
  for (const double mast : {0.0, 45.0, 90.0}) {
    const Configuration<double> c = configuration(mast, Options());
    StateAndControls<double> s = random_case(random, c);
    s.x.velocity = {-30, 0, 0};
    s.u.gust = {0, 0, 0};
    // Where along w does it jump? Bisection between two of its signs.
    const auto angle = [&](double w) {
      Evaluation<double> e;
      State<double> x = s.x;
      x.velocity.z = w;
      evaluate_aircraft(c, x, s.u, e);
      return e.wing_alpha;
    };
    double low = 0, high = 0;
    for (double w = -30; w < 30 && high == 0; w += 0.1)
      if (std::fabs(angle(w + 0.1) - angle(w)) > 3) low = w, high = w + 0.1;
    if (!CHECK(high != 0)) continue;
    for (int k = 0; k < 40; ++k) {
      const double middle = 0.5 * (low + high);
      (angle(middle) * angle(low) > 0 ? low : high) = middle;
    }
    check_line(c, s, {"wing angle through 180 deg", {-30, 0, 0.5 * (low + high)}, {0, 0, 1}}, mast);
  }
}

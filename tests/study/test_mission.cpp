// The mission of the report: drawn and judged from what was flown, and what an ideal governor makes of the modes.
// Expected: made-up flights that keep and break each promise; the phugoid at constant power from the linear model with
// rotor speed and collective held: A - b (dP/dx)/(dP/dc), its slopes of power by differences.
#include <cmath>

#include "check.hpp"
#include "plot/xml_check.hpp"
#include "study/drawn_with.hpp"
#include "study/linear_models.hpp"
#include "study/mission.hpp"
#include "study/sections.hpp"

using namespace tiltrotor;
using namespace tiltrotor::study;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Masts up from 10 to 20 s, with this load factor meanwhile.
FlownMission flown(double load_factor) {
  FlownMission f;
  f.name = "made_up.txt";
  for (int t = 0; t <= 30; ++t) {
    const double mast = std::fmin(std::fmax(t - 10, 0), 10) * 9;
    const bool converts = t > 10 && t <= 20;
    f.motion.add({double(t), 10.0, 3.0 * t, mast, 20.0, 900.0, 2300.0, converts ? load_factor : 1.5});
  }
  for (int t = 0; t <= 30; t += 5) f.modes.add({double(t), std::string("phugoid"), t > 20 ? 0.1 : -0.1, 0.2});
  f.models = 7;
  f.height_error = 4;
  f.power_part = 0.9;
  f.touch_down = 0.5;
  f.summary = "duration: 30.00 s\ntouch-down: 0.50 m/s at 29.0 s\n";
  return f;
}

int held(const Section& section) {
  int count = 0;
  for (const Finding& f : section.findings) count += f.verdict == Finding::holds;
  return count;
}

}  // namespace

TEST(report_mission_is_judged_on_its_numbers) {
  const Section good = mission(flown(1.05));
  CHECK_EQ(held(good), 4);
  CHECK(contains(good.findings[0].found, "duration: 30.00 s; touch-down: 0.50 m/s at 29.0 s."));
  CHECK_EQ(held(mission(flown(1.2))), 3);
  FlownMission bad = flown(0.8);
  bad.height_error = 6;
  bad.power_part = 1.1;
  bad.touch_down = 1.2;
  CHECK_EQ(held(mission(bad)), 0);
  bool grows = false;
  for (const Finding& f : good.findings) grows = grows || contains(f.found, "phugoid at 2, up to +0.10/s");
  CHECK(grows);
}

TEST(report_mission_has_two_figures_that_say_with_what) {
  const Section section = mission(flown(1));
  CHECK_EQ(section.pictures.size(), std::size_t{2});
  for (const Picture& p : section.pictures) {
    CHECK_EQ(check::XmlChecker::fault(p.svg), "");
    for (const char* part : {"Aircraft: ", "Governor: pi", "Inflow: ", "Time, s"})
      if (!CHECK(contains(p.svg, part))) NOTE(p.name << " " << part);
  }
  for (const char* part : {"Height, m", "Airspeed, m/s", "Angle, deg", "Power, kW"})
    CHECK(contains(section.pictures[0].svg, part));
  CHECK_EQ(section.tables.size(), std::size_t{2});
}

TEST(report_names_the_governor_that_it_was_drawn_with) {
  CHECK(contains(drawn_with(), "Governor: none, rotor speed held"));
  CHECK(contains(drawn_with(Governor::ideal), "Governor: ideal"));
  CHECK(contains(drawn_with(Governor::pi), "Governor: pi"));
}

TEST(report_modes_with_an_ideal_governor_keep_the_power) {
  const Configured held = configured(90);
  Configured ideal = held;
  ideal.setup.options.governor = Governor::ideal;
  const Trimmed t = trimmed_persistently(held, 100);
  const auto power = [&](const State<double>& x, const Controls<double>& u) {
    const Evaluation<double> e = evaluated(held, x, u);
    return e.rotor[right].loads.torque + e.rotor[left].loads.torque;
  };
  Controls<double> u = t.controls;
  Linear expected = linear_model(held, t);
  const double step = 1e-5;
  Controls<double> up = u, down = u;
  up.collective += step;
  down.collective -= step;
  const double by_collective = (power(t.state, up) - power(t.state, down)) / (2 * step);
  double flat[state_count];
  for (int j = 0; j < expected.states; ++j) {
    const double h = step * state_scale<double>(expected.state[j]);
    const auto at = [&](double way) {
      flatten(t.state, flat);
      flat[expected.state[j]] += way;
      State<double> x;
      unflatten(flat, x);
      return power(x, u);
    };
    const double by_state = (at(h) - at(-h)) / (2 * h);
    for (int i = 0; i < expected.states; ++i) expected.a(i, j) -= expected.b(i, 0) * by_state / by_collective;
  }
  const Linear found = linear_model(ideal, governed(ideal, t.state, u), t.state, u);
  const auto phugoid = [](const Linear& m) {
    const Modes modes = modes_of(m);
    for (int k = 0; k < modes.count; ++k)
      if (modes.mode[k].label.kind == ModeKind::phugoid) return modes.mode[k];
    return Mode<double>{};
  };
  CHECK_NEAR(phugoid(found).real, phugoid(expected).real, 1e-5);
  CHECK_NEAR(phugoid(found).imag, phugoid(expected).imag, 1e-5);
  CHECK_LT(phugoid(found).damping_ratio, 0.3 * phugoid(linear_model(held, t)).damping_ratio);
}

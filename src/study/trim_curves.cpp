// Trim against speed at four mast angles, with published points over the curves.

#include <algorithm>
#include <cmath>

#include "study/compared_aircraft.hpp"
#include "study/sections.hpp"
#include "study/trim_comparison.hpp"
#include "study/trim_pictures.hpp"
#include "study/wording.hpp"

namespace tiltrotor::study {

namespace {

constexpr double kJudgedMasts[] = {0, 30, 60, 90};  // of the paper's statements

constexpr double kStep = 1;  // m/s
constexpr double kHighest = 140;

bool is_shown(double mast_deg) {
  return std::find(std::begin(kTrimMasts), std::end(kTrimMasts), mast_deg) != std::end(kTrimMasts);
}

void add_curve(const SpeedSweep& sweep, Table& table) {
  for (const LevelFlight& f : sweep.flights) {
    const Trimmed& t = f.trim;
    const Evaluation<double> e = evaluated(sweep.c, t.state, t.controls);
    using K = Component;
    const auto force = [&](K k) { return e.loads[k].force; };
    const Vec3<double> wing = force(K::wing_free) + force(K::wing_wake_right) + force(K::wing_wake_left);
    const Vec3<double> airframe = wing + force(K::pylon) + force(K::fuselage) + force(K::htail) +
                                  force(K::fin_right) + force(K::fin_left);
    table.add({sweep.mast_deg, f.speed_mps, static_cast<double>(t.iterations), degrees(t.state.pitch),
               degrees(t.controls.collective), degrees(t.collective_root), stick_position(t),
               degrees(t.blades.long_cyclic[right]), degrees(t.blades.elevator), t.thrust[right],
               total_power_kw(t), degrees(t.wing_angle_of_attack), t.download_fraction,
               e.rotor[right].loads.force_a.z, degrees(t.state.rotor[right].b1c),
               degrees(t.state.rotor[right].b1s), airframe.x, wing.z, force(K::htail).z});
  }
}

Table empty_table() {
  Table table({"mast_deg", "speed_mps", "iterations", "pitch_deg", "collective75_deg", "collective_root_deg",
               "long_stick_in", "long_cyclic_deg", "elevator_deg", "thrust_n", "power_kw", "wing_alpha_deg",
               "download_frac", "shaft_thrust_n", "long_flap_deg", "lat_flap_deg", "airframe_x_n", "wing_z_n",
               "tail_z_n"});
  table.comment(
      "Level flight, sea level, 13000 lb; flap 40/25 at mast 0 and 15, 20/12.5 between, 0/0 at mast 90.");
  table.comment("thrust_n: one rotor; power_kw: both; stick 0..9.6 in, neutral 4.8, larger = forward.");
  table.comment(
      "Flapping: longitudinal + disk forward, lateral - disk outboard. Forces in body axes, z down;");
  table.comment("airframe: without rotors and spinners; wing: with its part in the wakes.");
  return table;
}

Table standard_curves(const Sweeps& sweeps) {
  Table table = empty_table();
  for (const SpeedSweep& sweep : sweeps) {
    if (!is_shown(sweep.mast_deg)) continue;
    const Setup setup = trim_setup(ComparedAircraft::standard, sweep.mast_deg);
    const bool is_flown = setup.flap_deg == sweep.c.setup.flap_deg;
    add_curve(is_flown ? sweep : speed_sweep(setup, kStep, kHighest), table);
  }
  return table;
}

Table simulated_curves() {
  Table table = empty_table();
  table.comment("The aircraft as simulated: with the controls of the printed runs.");
  for (const double mast : kTrimMasts)
    add_curve(speed_sweep(trim_setup(ComparedAircraft::as_simulated, mast), kStep, kHighest), table);
  return table;
}

// Statements of the paper on trim, judged on the curves.
std::vector<Finding> statements(const Table& curves) {
  const Table helicopter = curves.where("mast_deg", 0.0);
  const std::vector<double> speed = helicopter.numbers("speed_mps");
  const std::vector<double> collective = helicopter.numbers("collective_root_deg");
  const std::vector<double> stick = helicopter.numbers("long_stick_in");
  const std::vector<double> pitch = helicopter.numbers("pitch_deg");
  const std::size_t lowest =
      static_cast<std::size_t>(std::min_element(collective.begin(), collective.end()) - collective.begin());
  const double drop = collective.front() - collective[lowest];
  const bool bucket =
      lowest > 0 && lowest + 1 < speed.size() && collective.back() > collective[lowest] + 1 && drop > 1;

  bool nose_falls = true;
  bool stick_rises = true;
  std::size_t rises_from = 0;
  for (std::size_t i = 1; i < speed.size(); ++i) {
    nose_falls = nose_falls && pitch[i] < pitch[i - 1];
    if (stick[i] <= stick[i - 1]) rises_from = i;
  }
  stick_rises = stick.back() > stick.front() + 0.5;
  const auto [slow_low, slow_high] =
      std::minmax_element(stick.begin(), stick.begin() + static_cast<std::ptrdiff_t>(rises_from) + 1);

  const Table airplane = curves.where("mast_deg", 90.0);
  const std::vector<double> high = airplane.numbers("collective_root_deg");
  const auto range_text = [](const std::vector<double>& v, int decimals) {
    const auto [low, top] = std::minmax_element(v.begin(), v.end());
    return fixed(*low, decimals) + ".." + fixed(*top, decimals);
  };
  // Stick range over all flyable speeds and over their faster half.
  std::string spans;
  std::string fast_spans;
  std::vector<double> span_of_all;
  std::vector<double> fast_span;
  for (const double mast : kJudgedMasts) {
    const Table rows = curves.where("mast_deg", mast);
    const std::vector<double> s = rows.numbers("long_stick_in");
    const std::vector<double> v = rows.numbers("speed_mps");
    const auto span = [](auto first, auto last) {
      return *std::max_element(first, last) - *std::min_element(first, last);
    };
    fast_span.push_back(span(s.begin() + static_cast<std::ptrdiff_t>(s.size() / 2), s.end()));
    const std::string comma = spans.empty() ? "" : ", ";
    span_of_all.push_back(span(s.begin(), s.end()));
    spans += comma + fixed(span_of_all.back(), 1);
    fast_spans += comma + fixed(fast_span.back(), 1);
  }

  std::vector<Finding> findings;
  findings.push_back({bucket ? Finding::holds : Finding::differs,
                      "Collective follows a bucket curve with speed in helicopter mode.",
                      "It falls by " + fixed(drop, 1) + " deg from hover to a minimum at " +
                          fixed(speed[lowest], 0) + " m/s and ends " +
                          with_sign(collective.back() - collective.front(), 1) +
                          " deg from its hover value at " + fixed(speed.back(), 0) + " m/s."});
  findings.push_back(
      {verdict_of(nose_falls + stick_rises + (rises_from == 0), 3),
       "In helicopter mode the stick goes forward and the nose down with speed.",
       "Pitch runs from " + fixed(pitch.front(), 1) + " to " + fixed(pitch.back(), 1) + " deg" +
           (nose_falls ? " without turning" : "") + ", stick from " + fixed(stick.front(), 2) + " to " +
           fixed(stick.back(), 2) + " in, rising steadily from " + fixed(speed[rises_from], 0) + " m/s." +
           (rises_from == 0 ? ""
                            : " Slower, while the wing leaves the wake, it moves between " +
                                  fixed(*slow_low, 2) + " and " + fixed(*slow_high, 2) + " in.")});
  findings.push_back(
      {high.front() > collective.front() && high.back() > high.front() ? Finding::holds : Finding::differs,
       "Airplane mode needs high collective.",
       "Root collective " + range_text(high, 1) + " deg, " + with_sign(high.back() - high.front(), 1) +
           " deg from the slowest to the fastest flight, against " + range_text(collective, 1) +
           " deg in helicopter mode."});
  const int smaller = std::is_sorted(fast_span.rbegin(), fast_span.rend()) +
                      std::is_sorted(span_of_all.rbegin(), span_of_all.rend());
  findings.push_back(
      {verdict_of(smaller, 2), "Control variation with speed becomes smaller as the masts tilt forward.",
       "Stick range over the faster half of the speeds at mast 0, 30, 60, 90 deg: " + fast_spans +
           " in. Over all speeds: " + spans + " in" +
           (smaller == 2 ? "."
                         : ": with the masts tilted the slow end of the range is close to the wing's stall, "
                           "where the stick comes far aft.")});
  return findings;
}

}  // namespace

Section trim_curves(const Sweeps& sweeps, const Uncertainty& bands) {
  Section section{"trim", "Trim from hover to cruise", "", {}, {}, {}};
  section.reading =
      "Lines: this program, every level flight inside its limits, rotor speed as scheduled (589 rpm, 517 rpm "
      "at mast 90). Squares: the GTRS simulation as printed, its power derived from the printed rotor "
      "loads; circles: GTRS read off a figure; triangles: flight, whose weight, flap and centre of gravity are not "
      "published. Thrust, elevator, flapping and the loads of the components are drawn as simulated, with the "
      "lateral cyclic and the elevator gearing of the printed runs.";
  const Table curves = standard_curves(sweeps);
  const Table simulated = simulated_curves();
  section.pictures = trim_pictures(curves, simulated, bands.trim);
  section.findings = statements(curves);
  const Table compared = trim_comparison();
  for (const Finding& f : trim_comparison_findings(compared)) section.findings.push_back(f);
  section.tables.push_back({"trim_curves", "the curves", curves});
  section.tables.push_back({"trim_curves_simulated", "the curves of the aircraft as simulated", simulated});
  section.tables.push_back(
      {"trim_compared", "every published point against this program at that speed", compared});
  return section;
}

}  // namespace tiltrotor::study

// Trim against speed at four mast angles, with published points over the curves.

#include <algorithm>
#include <cmath>

#include "plot/plot.hpp"
#include "study/drawn_with.hpp"
#include "study/printed_flights.hpp"
#include "study/sections.hpp"
#include "study/trim_comparison.hpp"
#include "study/wording.hpp"

namespace tiltrotor::study {

using namespace plot;

namespace {

constexpr double kShownMasts[] = {0, 15, 30, 60, 90};
constexpr double kJudgedMasts[] = {0, 30, 60, 90};  // of the paper's statements

// The printed runs at this mast angle had the flap of helicopter mode.
constexpr double kFlappedMast = 15;
constexpr double kFlap = 40;  // deg
constexpr double kStep = 1;   // m/s
constexpr double kHighest = 140;

bool is_shown(double mast_deg) {
  return std::find(std::begin(kShownMasts), std::end(kShownMasts), mast_deg) != std::end(kShownMasts);
}

void add_curve(const SpeedSweep& sweep, Table& table) {
  for (const LevelFlight& f : sweep.flights) {
    const Trimmed& t = f.trim;
    const Evaluation<double> e = evaluated(sweep.c, t.state, t.controls);
    const auto force = [&](Component k) { return e.loads.component[k].force; };
    const Vec3<double> wing = force(wing_free) + force(wing_wake_right) + force(wing_wake_left);
    const Vec3<double> airframe =
        wing + force(pylon) + force(fuselage) + force(htail) + force(fin_right) + force(fin_left);
    table.add({sweep.mast_deg, f.speed_mps, static_cast<double>(t.iterations), degrees(t.state.pitch),
               degrees(t.controls.collective), degrees(t.collective_root), stick_position(t),
               degrees(t.blades.long_cyclic[right]), degrees(t.blades.elevator), t.thrust[right],
               total_power_kw(t), degrees(t.wing_angle_of_attack), t.download_fraction,
               e.rotor[right].loads.force_a.z, degrees(t.state.rotor[right].b1c),
               degrees(t.state.rotor[right].b1s), airframe.x, wing.z, force(htail).z});
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

Setup shown_setup(ComparedAircraft aircraft, double mast_deg) {
  Setup setup = setup_of(aircraft, mast_deg);
  if (mast_deg == kFlappedMast) setup.flap_deg = kFlap;
  return setup;
}

Table standard_curves(const Sweeps& sweeps) {
  Table table = empty_table();
  for (const SpeedSweep& sweep : sweeps) {
    if (sweep.mast_deg == kFlappedMast) {
      add_curve(speed_sweep(shown_setup(ComparedAircraft::standard, kFlappedMast), kStep, kHighest), table);
    } else if (is_shown(sweep.mast_deg)) {
      add_curve(sweep, table);
    }
  }
  return table;
}

Table simulated_curves() {
  Table table = empty_table();
  table.comment("The aircraft as simulated: with the controls of the printed runs.");
  for (const double mast : kShownMasts)
    add_curve(speed_sweep(shown_setup(ComparedAircraft::as_simulated, mast), kStep, kHighest), table);
  return table;
}

// Published points of one quantity: set, column, unit, and of which component.
enum Kind : unsigned char { printed, figure, flight };
struct Source {
  Kind kind;
  const char* set;
  const char* column;
  double factor;
  const char* component = nullptr;
};

struct Quantity {
  const char* id;
  const char* title;
  const char* axis;
  const char* column;  // of the curves
  double factor;
  ComparedAircraft aircraft;  // of the curves: where all points are of the simulation, the simulated one
  std::vector<Source> sources;
};

const std::vector<Quantity>& quantities() {
  constexpr ComparedAircraft standard = ComparedAircraft::standard;
  constexpr ComparedAircraft simulated = ComparedAircraft::as_simulated;
  constexpr double percent = kStickTravel / 100;
  constexpr double kilo = 1e-3;
  constexpr double kilo_pound = kilo * kPoundForce;
  static const std::vector<Quantity> all = {
      {"trim_pitch",
       "Pitch attitude",
       "Pitch, deg",
       "pitch_deg",
       1,
       standard,
       {{printed, "trim_gtrs_printed", "pitch_deg", 1},
        {printed, "trim_gtrs_conversion", "pitch_deg", 1},
        {figure, "trim_gtrs_figures", "pitch_deg", 1},
        {flight, "trim_flight", "pitch_deg", 1}}},
      {"trim_stick",
       "Longitudinal stick (forward up)",
       "Stick, in of 9.6",
       "long_stick_in",
       1,
       standard,
       {{printed, "trim_gtrs_printed", "long_stick_in", 1},
        {printed, "trim_gtrs_conversion", "long_stick_in", 1},
        {figure, "trim_gtrs_figures", "long_stick_pct", percent},
        {flight, "trim_flight", "long_stick_pct", percent}}},
      {"trim_collective",
       "Collective at the root",
       "Root collective, deg",
       "collective_root_deg",
       1,
       standard,
       {{printed, "flapping_gtrs", "collective_root_deg", 1},
        {printed, "trim_gtrs_conversion", "collective_root_deg", 1},
        {figure, "trim_gtrs_figures", "collective_root_deg", 1}}},
      {"trim_power",
       "Shaft power of both rotors",
       "Power, kW",
       "power_kw",
       1,
       standard,
       {{printed, "rotor_power_gtrs", "power_kw", 1},
        {figure, "trim_gtrs_figures", "power_kw", 1},
        {flight, "trim_flight", "power_kw", 1}}},
      {"trim_thrust",
       "Thrust of one rotor along its shaft",
       "Thrust, kN",
       "shaft_thrust_n",
       kilo,
       simulated,
       {{printed, "trim_gtrs_printed", "thrust_n", kilo},
        {printed, "trim_gtrs_conversion", "thrust_n", kilo}}},
      {"trim_elevator",
       "Elevator (trailing edge down up)",
       "Elevator, deg",
       "elevator_deg",
       1,
       simulated,
       {{printed, "trim_gtrs_printed", "elevator_deg", 1},
        {printed, "trim_gtrs_conversion", "elevator_deg", 1}}},
      {"trim_long_flap",
       "Longitudinal flapping (disk forward up)",
       "Longitudinal flapping, deg",
       "long_flap_deg",
       1,
       simulated,
       {{printed, "flapping_gtrs", "long_flap_deg", 1},
        {printed, "trim_gtrs_conversion", "long_flap_deg", 1}}},
      {"trim_lat_flap",
       "Lateral flapping (disk outboard down)",
       "Lateral flapping, deg",
       "lat_flap_deg",
       1,
       simulated,
       {{printed, "flapping_gtrs", "lat_flap_deg", 1}, {printed, "trim_gtrs_conversion", "lat_flap_deg", 1}}},
      {"trim_airframe_x",
       "Force of the airframe along x, without rotors",
       "X, kN",
       "airframe_x_n",
       kilo,
       simulated,
       {{printed, "component_loads_gtrs_conversion", "x_lbf", kilo_pound, "airframe"}}},
      {"trim_wing_z",
       "Force of the wing along z, with its part in the wakes",
       "Z, kN (lift is negative)",
       "wing_z_n",
       kilo,
       simulated,
       {{printed, "component_loads_gtrs_conversion", "z_lbf", kilo_pound, "wing"}}},
      {"trim_tail_z",
       "Force of the horizontal tail along z",
       "Z, kN (lift is negative)",
       "tail_z_n",
       kilo,
       simulated,
       {{printed, "component_loads_gtrs", "z_lbf", kilo_pound, "horizontal_tail"},
        {printed, "component_loads_gtrs_conversion", "z_lbf", kilo_pound, "horizontal_tail"}}},
  };
  return all;
}

bool has_column(const Table& table, const char* name) {
  return std::find(table.columns().begin(), table.columns().end(), name) != table.columns().end();
}

// Sets of helicopter mode alone have no mast angle.
Series points(const Source& source, double mast_deg) {
  Series s;
  s.line = Line::none;
  Table rows = reference_points(source.set);
  if (has_column(rows, "mast_deg")) {
    rows = rows.where("mast_deg", mast_deg);
  } else if (mast_deg != 0) {
    return s;
  }
  if (source.component != nullptr) rows = rows.where("component", std::string(source.component));
  const bool metric = has_column(rows, "speed_mps");
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    const double y = source.factor * rows.number(i, source.column);
    if (!std::isfinite(y)) continue;
    s.x.push_back(metric ? rows.number(i, "speed_mps") : kKnot * rows.number(i, "speed_kt"));
    s.y.push_back(y);
  }
  return s;
}

constexpr struct {
  const char* name;
  Marker marker;
  bool filled;
} kKinds[] = {{"GTRS, printed", Marker::square, true},
              {"GTRS, figure", Marker::circle, false},
              {"flight", Marker::triangle, true}};

void set_marker(Kind kind, Series& s) {
  s.line = Line::none;
  s.marker = kKinds[kind].marker;
  s.filled = kKinds[kind].filled;
}

Picture picture(const Quantity& quantity, const Table& curves) {
  Plot plot;
  plot.id = quantity.id;
  plot.title = quantity.title;
  plot.note = drawn_with(quantity.aircraft, setup_of(quantity.aircraft, 0));
  plot.x.label = "Speed, m/s";
  plot.y.label = quantity.axis;
  plot.x.low = 0;
  plot.y.zero_line = true;
  int color = 0;
  for (const double mast : kShownMasts) {
    const Table rows = curves.where("mast_deg", mast);
    Series curve;
    curve.name = "mast " + fixed(mast, 0);
    curve.color = kLineColor[color];
    curve.x = rows.numbers("speed_mps");
    for (const double y : rows.numbers(quantity.column)) curve.y.push_back(quantity.factor * y);
    plot.series.push_back(curve);
    for (const Source& source : quantity.sources) {
      Series s = points(source, mast);
      s.color = kLineColor[color];
      set_marker(source.kind, s);
      plot.series.push_back(s);
    }
    ++color;
  }
  for (const Kind kind : {printed, figure, flight}) {
    const bool shown = std::any_of(quantity.sources.begin(), quantity.sources.end(),
                                   [&](const Source& source) { return source.kind == kind; });
    if (!shown) continue;
    Series s;  // stands in the key for every mast angle
    s.name = kKinds[kind].name;
    s.color = kGrey;
    set_marker(kind, s);
    plot.series.push_back(s);
  }
  return {quantity.id, svg(plot)};
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

Section trim_curves(const Sweeps& sweeps) {
  Section section{"trim", "Trim from hover to cruise", "", {}, {}, {}};
  section.reading =
      "Lines: this program, every level flight inside its limits, rotor speed as scheduled (589 rpm, 517 rpm at "
      "mast 90). Squares: the GTRS simulation as printed, its power derived from the printed rotor loads; "
      "circles: GTRS read off a figure; triangles: flight, whose weight, flap and centre of gravity are not "
      "published. Thrust, elevator, flapping and the loads of the components are drawn as simulated, with the "
      "lateral cyclic and the elevator gearing of the printed runs.";
  const Table curves = standard_curves(sweeps);
  const Table simulated = simulated_curves();
  for (const Quantity& quantity : quantities()) {
    const bool is_standard = quantity.aircraft == ComparedAircraft::standard;
    section.pictures.push_back(picture(quantity, is_standard ? curves : simulated));
  }
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

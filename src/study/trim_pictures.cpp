#include "study/trim_pictures.hpp"

#include <algorithm>
#include <cmath>

#include "plot/plot.hpp"
#include "study/drawn_with.hpp"
#include "study/printed_flights.hpp"
#include "study/spread.hpp"
#include "study/wording.hpp"

namespace tiltrotor::study {

using namespace plot;

namespace {

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

Picture picture(const Quantity& quantity, const Table& curves, const Table& spreads) {
  Plot plot;
  plot.id = quantity.id;
  plot.title = quantity.title;
  plot.note = drawn_with(quantity.aircraft, setup_of(quantity.aircraft, 0));
  plot.x.label = "Speed, m/s";
  plot.y.label = quantity.axis;
  plot.x.low = 0;
  plot.y.zero_line = true;
  int color = 0;
  const Table of_quantity = spreads.where("quantity", std::string(quantity.column));
  const bool has_band = quantity.aircraft == ComparedAircraft::standard && of_quantity.rows() > 0;
  if (has_band) plot.note += kBandNote;
  for (const double mast : kTrimMasts) {
    const Table rows = curves.where("mast_deg", mast);
    Series curve;
    curve.name = "mast " + fixed(mast, 0);
    curve.color = kLineColor[color];
    curve.x = rows.numbers("speed_mps");
    for (const double y : rows.numbers(quantity.column)) curve.y.push_back(quantity.factor * y);
    if (has_band)
      plot.bands.push_back(
          band_around(curve, of_quantity.where("mast_deg", mast), "speed_mps", quantity.factor));
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

}  // namespace

Setup trim_setup(ComparedAircraft aircraft, double mast_deg) {
  constexpr double flapped_mast = 15;
  Setup setup = setup_of(aircraft, mast_deg);
  if (mast_deg == flapped_mast) setup.flap_deg = aircraft_data<double>().defaults.flap_helicopter;
  return setup;
}

std::vector<Picture> trim_pictures(const Table& standard, const Table& simulated, const Table& spreads) {
  std::vector<Picture> pictures;
  for (const Quantity& quantity : quantities()) {
    const bool is_standard = quantity.aircraft == ComparedAircraft::standard;
    pictures.push_back(picture(quantity, is_standard ? standard : simulated, spreads));
  }
  return pictures;
}

}  // namespace tiltrotor::study

#include "study/printed_flights.hpp"

#include <functional>
#include <utility>

#include "study/reference_points.hpp"

namespace tiltrotor::study {

namespace {

constexpr double kSlugFoot2 = kPoundFoot;  // kg m^2: one slug is one lbf s^2/ft

// A trim of this program in the conditions of a printed one.
struct Flight {
  Configured c;
  Trimmed trim;
  double coning_deg;  // of the balance of the blades, which the trim does not need
};

Flight flown(const Setup& setup, double speed_kt) {
  Flight f{configured(setup), {}, 0};
  f.trim = trimmed_persistently(f.c, kKnot * speed_kt);
  Setup coned = setup;
  coned.options.coning_states = true;
  f.coning_deg = degrees(trimmed_persistently(configured(coned), kKnot * speed_kt).state.coning[right].angle);
  return f;
}

// Flow down through the disk over tip speed, of the climbing rotor and the mean induced together.
double inflow_ratio(const Flight& f) {
  const double climb = dot(f.c.hub[right].thrust_axis_b, f.trim.state.velocity);
  return climb / f.c.tip_speed + f.trim.state.rotor[right].lambda_0;
}

using Value = double (*)(const Flight&);
constexpr std::pair<const char*, Value> kValues[] = {
    {"pitch_deg", [](const Flight& f) { return degrees(f.trim.state.pitch); }},
    {"long_stick_in", [](const Flight& f) { return stick_position(f.trim); }},
    {"long_cyclic_deg", [](const Flight& f) { return degrees(f.trim.blades.long_cyclic[right]); }},
    {"elevator_deg", [](const Flight& f) { return degrees(f.trim.blades.elevator); }},
    {"thrust_n", [](const Flight& f) { return shaft_thrust(f.c, f.trim); }},
    {"inflow_ratio", inflow_ratio},
    {"coning_deg", [](const Flight& f) { return f.coning_deg; }},
    {"long_flap_deg", [](const Flight& f) { return degrees(f.trim.state.rotor[right].b1c); }},
    {"lat_flap_deg", [](const Flight& f) { return degrees(f.trim.state.rotor[right].b1s); }},
    {"collective_root_deg", [](const Flight& f) { return degrees(f.trim.collective_root); }},
    {"cg_sl_ft", [](const Flight& f) { return f.c.mass.sl_cg / kFoot; }},
    {"cg_wl_ft", [](const Flight& f) { return f.c.mass.wl_cg / kFoot; }},
    {"ixx_slug_ft2", [](const Flight& f) { return f.c.mass.inertia.xx / kSlugFoot2; }},
    {"iyy_slug_ft2", [](const Flight& f) { return f.c.mass.inertia.yy / kSlugFoot2; }},
    {"izz_slug_ft2", [](const Flight& f) { return f.c.mass.inertia.zz / kSlugFoot2; }},
    {"ixz_slug_ft2", [](const Flight& f) { return f.c.mass.inertia.xz / kSlugFoot2; }},
    {"power_kw", [](const Flight& f) { return total_power_kw(f.trim); }},
    // The spring resists the tilt; of the left rotor, whose disk tilted outboard rolls the hub left.
    {"hub_roll_lbfft",
     [](const Flight& f) { return f.c.hub_spring * f.trim.state.rotor[left].b1s / kPoundFoot; }},
    {"hub_pitch_lbfft",
     [](const Flight& f) { return -f.c.hub_spring * f.trim.state.rotor[left].b1c / kPoundFoot; }},
};

std::vector<Comparison> compared(const std::string& set, ComparedAircraft aircraft) {
  std::vector<Comparison> rows;
  const Table printed = reference_points(set);
  for (std::size_t i = 0; i < printed.rows(); ++i) {
    const Flight f = flown(printed_setup(aircraft, printed, i), printed.number(i, "speed_kt"));
    for (const std::string& column : printed.columns()) {
      for (const auto& [name, value] : kValues) {
        if (column != name || !std::isfinite(printed.number(i, column))) continue;
        rows.push_back({set, point_of(printed, i), column, is_trimmed(f.trim.status) ? value(f) : kMissing,
                        printed.number(i, column), printed.number(i, "mast_deg")});
      }
    }
  }
  return rows;
}

}  // namespace

Setup printed_setup(ComparedAircraft aircraft, const Table& printed, std::size_t row) {
  Setup setup = setup_of(aircraft, printed.number(row, "mast_deg"));
  const std::vector<std::string>& columns = printed.columns();
  const auto set_from = [&](const char* column, double unit, double& value) {
    for (const std::string& name : columns) {
      if (name == column) value = unit * printed.number(row, column);
    }
  };
  set_from("flap_deg", 1, setup.flap_deg);
  set_from("rotor_rpm", kPi<double> / 30, setup.rotor_speed);
  return setup;
}

std::string point_of(const Table& printed, std::size_t row) {
  return "mast_deg=" + printed.text(row, "mast_deg") + " speed_kt=" + printed.text(row, "speed_kt");
}

void compare_printed_trims(std::vector<Comparison>& out) {
  for (const std::string set : {"trim_gtrs_conversion", "rotor_power_gtrs", "flapping_gtrs"})
    add_compared(
        set, [&](ComparedAircraft aircraft) { return compared(set, aircraft); }, out);
}

}  // namespace tiltrotor::study

#include "study/component_loads.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "study/missing.hpp"
#include "study/printed_flights.hpp"
#include "study/reference_points.hpp"
#include "tiltrotor/model/airframe/airframe.hpp"
#include "tiltrotor/model/airframe/engine_jet.hpp"

namespace tiltrotor::study {

namespace {

// Printed names, and what they hold of the airframe in the printed state of flight.
struct ComponentName {
  const char* name;
  std::vector<Component> parts;
};
const std::vector<ComponentName>& airframe_names() {
  using C = Component;
  static const std::vector<ComponentName> names = {
      {"fuselage", {C::fuselage}},
      {"free_wing", {C::wing_free}},
      {"wing", {C::wing_free, C::wing_wake_right, C::wing_wake_left}},
      {"pylons", {C::pylon}},
      {"pylons_and_jet", {C::pylon, C::engine_jets}},
      {"horizontal_tail", {C::htail}},
      {"fins", {C::fin_right, C::fin_left}},
      {"fin", {C::fin_left}},
      {"spinners", {C::spinners}},
      {"airframe",
       {C::wing_free, C::wing_wake_right, C::wing_wake_left, C::pylon, C::fuselage, C::htail, C::fin_right,
        C::fin_left, C::engine_jets}}};
  return names;
}
// The same of a trim: what the rotors and the balance of the whole aircraft decide.
const std::vector<ComponentName>& trim_names() {
  using C = Component;
  static const std::vector<ComponentName> names = {
      {"rotor_right", {C::rotor_right}},
      {"rotor_left", {C::rotor_left}},
      {"rotors_and_spinners", {C::rotor_right, C::rotor_left, C::spinners}},
      {"jets", {C::engine_jets}},
      {"aircraft",
       {C::rotor_right, C::rotor_left, C::spinners, C::wing_free, C::wing_wake_right, C::wing_wake_left,
        C::pylon, C::fuselage, C::htail, C::fin_right, C::fin_left, C::engine_jets}}};
  return names;
}

// State of flight of a print: velocity in body axes, mean induced velocity and in-plane advance ratio of each
// rotor, force of one rotor, elevator, power of both rotors.
struct PrintedState {
  double u_fps, w_fps, induced_fps, advance_ratio, rotor_force_lbf, elevator_deg, power_kw;
};

// Of the torques that the printed loads contain; no such print at mast 0.
double printed_power(const Table& trims, std::size_t row) {
  return reference_points("rotor_power_gtrs")
      .where("mast_deg", trims.text(row, "mast_deg"))
      .where("speed_kt", trims.text(row, "speed_kt"))
      .number(0, "power_kw");
}

// Where the print has the whole flow through the disk, that of the climbing rotor is no induced one.
PrintedState state_of(const Table& trims, std::size_t row, const Table& loads, const Configured& c) {
  if (trims.columns().front() == "speed_kt") {
    return {trims.number(row, "u_fps"),
            trims.number(row, "w_fps"),
            trims.number(row, "induced_velocity_fps"),
            trims.number(row, "advance_ratio"),
            trims.number(row, "rotor_force_lbf"),
            trims.number(row, "elevator_deg"),
            kMissing};
  }
  const Table rotor = loads.where("component", std::string("rotor_left"));
  const double u = trims.number(row, "u_fps");
  const double w = trims.number(row, "w_fps");
  const double tip_fps = c.tip_speed / kFoot;
  const Vec3<double> up = c.nacelle_axis_b;
  const double climb = u * up.x + w * up.z;
  const double across = w * up.x - u * up.z;
  return {u,
          w,
          tip_fps * trims.number(row, "inflow_ratio") - climb,
          std::fabs(across) / tip_fps,
          std::sqrt(square(rotor.number(0, "x_lbf")) + square(rotor.number(0, "y_lbf")) +
                    square(rotor.number(0, "z_lbf"))),
          trims.number(row, "elevator_deg"),
          printed_power(trims, row)};
}

// Loads of the airframe in the printed state of flight, as the source computed them: tables linear, the
// downwash that of the wing at that moment.
LoadRecord<double> replayed(const Table& trims, std::size_t row, const Table& printed, Setup setup) {
  setup.options.tables = Interpolation::linear;
  setup.options.downwash_lag = false;
  const Configured c = configured(setup);
  const PrintedState state = state_of(trims, row, printed, c);
  const double radius = c.aircraft->rotor.radius;
  AirframeInput<double> in{};
  in.velocity_b = {kFoot * state.u_fps, 0, kFoot * state.w_fps};
  in.mean_wash[right] = in.mean_wash[left] = kFoot * state.induced_fps;
  in.rotor_force = 2 * kPoundForce * state.rotor_force_lbf /
                   (c.air.density * kPi<double> * c.tip_speed * c.tip_speed * radius * radius);
  in.advance_ratio = state.advance_ratio;
  in.elevator = state.elevator_deg * kRadPerDeg<double>;
  LoadRecord<double> loads{};
  AirframeWorkspace<double> work;
  AirframeResponse<double> sum;
  airframe_response(c, in, work, sum, [&](Component k, const Loads<double>& l) { loads[k] = l; });
  if (setup.options.engine_jets && std::isfinite(state.power_kw))
    loads[Component::engine_jets] =
        engine_jet_loads(c, 1e3 * state.power_kw, total_speed(in.velocity_b, 0.0));
  return loads;
}

// Six numbers of a component; of an airframe's force the tolerance is a fraction of its size in the plane of
// symmetry.
void compare(const LoadRecord<double>& loads, const std::vector<ComponentName>& names, const Table& printed,
             bool by_size, Comparison row, std::vector<Comparison>& out) {
  for (const ComponentName& which : names) {
    const Table there = printed.where("component", std::string(which.name));
    if (there.rows() == 0) continue;
    Loads<double> sum{};
    for (const Component part : which.parts) sum = sum + loads[part];
    const double size = std::hypot(there.number(0, "x_lbf"), there.number(0, "z_lbf"));
    const auto add = [&](const char* column, double value, double unit, bool of_size) {
      const std::vector<std::string>& columns = there.columns();
      if (std::find(columns.begin(), columns.end(), column) == columns.end()) return;
      row.quantity = std::string(which.name) + "_" + column;
      row.here = value / unit;
      row.reference = there.number(0, column);
      row.scale = of_size && std::isfinite(size) ? size : std::fabs(row.reference);
      if (std::isfinite(row.reference)) out.push_back(row);
    };
    add("x_lbf", sum.force.x, kPoundForce, by_size);
    if (!by_size) add("y_lbf", sum.force.y, kPoundForce, false);
    add("z_lbf", sum.force.z, kPoundForce, by_size);
    if (!by_size) add("l_lbfft", sum.moment.x, kPoundFoot, false);
    add("m_lbfft", sum.moment.y, kPoundFoot, false);
    if (!by_size) add("n_lbfft", sum.moment.z, kPoundFoot, false);
  }
}

void check_names(const std::string& set, const Table& printed) {
  for (const std::string& name : printed.different("component")) {
    const auto has = [&](const std::vector<ComponentName>& names) {
      return std::any_of(names.begin(), names.end(), [&](const auto& c) { return name == c.name; });
    };
    if (!has(airframe_names()) && !has(trim_names()))
      throw std::runtime_error(set + ": no component '" + name + "' here");
  }
}

std::vector<Comparison> compared(const std::string& set, const Table& trims, ComparedAircraft aircraft) {
  std::vector<Comparison> rows;
  const Table all = reference_points(set);
  check_names(set, all);
  const bool conversion = trims.columns().front() == "mast_deg";
  for (std::size_t i = 0; i < trims.rows(); ++i) {
    Table printed = all.where("speed_kt", trims.text(i, "speed_kt"));
    if (conversion) printed = printed.where("mast_deg", trims.text(i, "mast_deg"));
    const double mast = conversion ? trims.number(i, "mast_deg") : 0;
    const Setup setup = conversion ? printed_setup(aircraft, trims, i) : setup_of(aircraft, mast);
    Comparison row{};
    row.set = set;
    row.point = conversion ? point_of(trims, i) : "speed_kt=" + trims.text(i, "speed_kt");
    if (conversion) row.mast_deg = mast;
    compare(replayed(trims, i, printed, setup), airframe_names(), printed, true, row, rows);
    const Configured c = configured(setup);
    const Trimmed t = trimmed_persistently(c, kKnot * trims.number(i, "speed_kt"));
    compare(evaluated(c, t.state, t.controls).loads, trim_names(), printed, false, row, rows);
  }
  return rows;
}

}  // namespace

void compare_component_loads(std::vector<Comparison>& out) {
  for (const auto& [set, trims] : {std::pair("component_loads_gtrs", "component_states_gtrs"),
                                   std::pair("component_loads_gtrs_conversion", "trim_gtrs_conversion")}) {
    const Table states = reference_points(trims);
    add_compared(
        set, [&, name = set](ComparedAircraft aircraft) { return compared(name, states, aircraft); }, out);
  }
}

}  // namespace tiltrotor::study

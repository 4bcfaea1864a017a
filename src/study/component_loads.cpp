#include "study/component_loads.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "study/flights.hpp"
#include "study/reference_points.hpp"
#include "tiltrotor/model/airframe/airframe.hpp"

namespace tiltrotor::study {

namespace {

constexpr double kFoot = 0.3048;                 // m
constexpr double kPoundForce = 4.4482216152605;  // N
constexpr double kKnot = 1852.0 / 3600;          // m/s

struct ComponentName {
  const char* name;  // in the published set
  Component part[2];
  int parts;
};
constexpr ComponentName kAirframe[] = {
    {"fuselage", {fuselage, fuselage}, 1}, {"free_wing", {wing_free, wing_free}, 1},
    {"pylons", {pylon, pylon}, 1},         {"horizontal_tail", {htail, htail}, 1},
    {"fins", {fin_right, fin_left}, 2},    {"spinners", {spinners, spinners}, 1}};

constexpr const char* kRotor = "rotor_right";

bool is_compared(const std::string& name) {
  return name == kRotor || std::any_of(std::begin(kAirframe), std::end(kAirframe),
                                       [&](const auto& c) { return name == c.name; });
}

// Loads of the airframe in the printed state of flight, as the source computed them: tables linear, the
// downwash that of the wing at that moment.
LoadRecord<double> replayed(const Table& states, std::size_t row) {
  Setup setup = default_setup(0);
  setup.options.tables = Interpolation::linear;
  setup.options.downwash_lag = false;
  const Configured c = configured(setup);
  const double radius = c.aircraft->rotor.radius;
  AirframeInput<double> in{};
  in.velocity = {kFoot * states.number(row, "u_fps"), 0, kFoot * states.number(row, "w_fps")};
  in.mean_wash[right] = in.mean_wash[left] = kFoot * states.number(row, "induced_velocity_fps");
  in.rotor_force = 2 * kPoundForce * states.number(row, "rotor_force_lbf") /
                   (c.air.density * kPi<double> * c.tip_speed * c.tip_speed * radius * radius);
  in.advance_ratio = states.number(row, "advance_ratio");
  in.elevator = states.number(row, "elevator_deg") * kRadPerDeg<double>;
  LoadRecord<double> loads{};
  AirframeWorkspace<double> room;
  AirframeResponse<double> sum;
  airframe_response(c, in, room, sum, [&](Component k, const Loads<double>& l) { loads.component[k] = l; });
  return loads;
}

void compare(const Loads<double>& here, const std::string& component, const Table& printed, bool by_size,
             Table& table) {
  const Table rows = printed.where("component", component);
  const std::string point = "speed_kt=" + rows.text(0, "speed_kt");
  const double size = std::hypot(rows.number(0, "x_lbf"), rows.number(0, "z_lbf"));
  const auto add = [&](const char* column, double value, bool of_size) {
    const double reference = rows.number(0, column);
    table.add({std::string("component_loads_gtrs"), point, component + "_" + column, value, reference,
               of_size ? size : std::fabs(reference)});
  };
  add("x_lbf", here.force.x / kPoundForce, by_size);
  if (!by_size) add("y_lbf", here.force.y / kPoundForce, false);
  add("z_lbf", here.force.z / kPoundForce, by_size);
  add("m_lbfft", here.moment.y / (kPoundForce * kFoot), false);
}

}  // namespace

Table compared_component_loads() {
  Table table({"set", "point", "quantity", "here", "reference", "scale"});
  const Table states = reference_points("component_states_gtrs");
  const Table all = reference_points("component_loads_gtrs");
  for (const std::string& name : all.different("component"))
    if (!is_compared(name))
      throw std::runtime_error("component_loads_gtrs: no component '" + name + "' here");
  for (std::size_t i = 0; i < states.rows(); ++i) {
    const Table printed = all.where("speed_kt", states.text(i, "speed_kt"));
    const LoadRecord<double> loads = replayed(states, i);
    for (const ComponentName& which : kAirframe) {
      Loads<double> sum = loads.component[which.part[0]];
      if (which.parts == 2) sum = sum + loads.component[which.part[1]];
      compare(sum, which.name, printed, true, table);
    }
    const Configured c = configured(0);
    const Trimmed t = trimmed_persistently(c, kKnot * states.number(i, "speed_kt"));
    compare(evaluated(c, t.state, t.controls).loads.component[rotor_right], kRotor, printed, false, table);
  }
  return table;
}

}  // namespace tiltrotor::study

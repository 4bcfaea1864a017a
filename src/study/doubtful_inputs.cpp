#include "study/doubtful_inputs.hpp"

#include <stdexcept>

#include "study/reference_points.hpp"

namespace tiltrotor::study {

namespace {

using Parameter = ConfigurationParameter;
using Unit = double (*)(const Configured& c);        // in that of the parameter
using Move = void (*)(MovedAircraft& m, double by);  // by: in the unit of the input
constexpr Parameter kNoParameter = Parameter::count;

constexpr double kInch = 0.0254;       // m
constexpr double kFoot = 12 * kInch;   // m
constexpr double kPound = 0.45359237;  // kg
constexpr double kPercent = 0.01;

// One row for each row of doubtful_inputs.csv.
struct Action {
  const char* name;
  const char* unit;
  Parameter parameter;
  Unit amount;
  Move move;
};

Action exact(const char* name, const char* unit, Parameter parameter, Unit amount) {
  return {name, unit, parameter, amount, nullptr};
}
Action moved(const char* name, const char* unit, Move move) {
  return {name, unit, kNoParameter, nullptr, move};
}

double factor(double percent) { return 1 + kPercent * percent; }

const std::vector<Action>& actions() {
  using M = MovedAircraft;
  static const std::vector<Action> all = {
      exact("cg_station", "in", Parameter::sl_cg, [](const Configured&) { return kInch; }),
      exact("cg_waterline", "in", Parameter::wl_cg, [](const Configured&) { return kInch; }),
      exact("mass", "lb", Parameter::mass, [](const Configured&) { return kPound; }),
      exact("air_density", "%", Parameter::air_density,
            [](const Configured& c) { return kPercent * c.air.density; }),
      exact("inertia_pitch", "%", Parameter::inertia_yy,
            [](const Configured& c) { return kPercent * c.mass.inertia.yy; }),
      exact("inertia_yaw", "%", Parameter::inertia_zz,
            [](const Configured& c) { return kPercent * c.mass.inertia.zz; }),
      exact("hub_spring", "%", Parameter::hub_spring_factor, [](const Configured&) { return kPercent; }),
      moved("nacelle_weight", "lb", [](M& m, double by) { m.aircraft.mass.nacelles += by * kPound; }),
      moved("mast_cant", "deg", [](M& m, double by) { m.aircraft.mast.cant += by * kRadPerDeg<double>; }),
      moved("blade_inertia", "%", [](M& m, double by) { m.aircraft.rotor.flap_inertia *= factor(by); }),
      moved("coning", "deg",
            [](M& m, double by) {
              m.aircraft.rotor.coning.at_0 += by * kRadPerDeg<double>;
              m.aircraft.rotor.coning.at_90 += by * kRadPerDeg<double>;
            }),
      moved("tip_loss", "ND", [](M& m, double by) { m.aircraft.rotor.tip_loss += by; }),
      moved("induced_power_factor", "ND", [](M& m, double by) { m.aircraft.inflow.induced_power += by; }),
      moved("apparent_mass", "ND", [](M& m, double by) { m.aircraft.inflow.apparent_mass_uniform += by; }),
      moved("wake_load_factor", "ND", [](M& m, double by) { m.aircraft.wake.load_factor.at_0 += by; }),
      moved("wake_fade_start", "m/s", [](M& m, double by) { m.aircraft.wake.fade_start += by; }),
      moved("wake_fade_end", "m/s", [](M& m, double by) { m.aircraft.wake.fade_end += by; }),
      // The load factor was calibrated with it: the download of the printed hover stays.
      moved("wash_factor", "ND",
            [](M& m, double by) {
              WakeTables<double>& wake = m.aircraft.wake;
              const double before = wake.wash_factor;
              wake.wash_factor += by;
              wake.load_factor.at_0 *= square(before / wake.wash_factor);
            }),
      moved("wake_axis_speed", "ND", [](M& m, double by) { m.aircraft.wake.axis_speed_factor += by; }),
      moved("advance_floor", "ND", [](M& m, double by) { m.aircraft.wing.advance_floor += by; }),
      moved("extra_drag", "ft2",
            [](M& m, double by) { m.aircraft.fuselage.extra_drag += by * kFoot * kFoot; }),
      moved("tail_pressure", "%",
            [](M& m, double by) {
              m.aircraft.htail.pressure = {1, factor(by)};
              m.setup.options.tail_pressure = TailPressure::by_mast;
            }),
      moved("fin_pressure", "ND", [](M& m, double by) { m.aircraft.fin.pressure_ratio += by; }),
      moved("fin_area", "%", [](M& m, double by) { m.aircraft.fin.surface.area *= factor(by); }),
      moved("wing_chord", "%", [](M& m, double by) { m.aircraft.wing.chord *= factor(by); }),
      moved("elevator_gearing", "%", [](M& m, double by) { m.aircraft.controls.elevator *= factor(by); }),
      moved("cyclic_rigging", "deg",
            [](M& m, double by) { m.aircraft.controls.cyclic_rigging += by * kRadPerDeg<double>; }),
      moved("table_section_lift", "%",
            [](M& m, double by) {
              for (auto& region : m.aircraft.rotor.section_lift) m.scale(region, factor(by));
            }),
      moved("table_section_drag", "%",
            [](M& m, double by) {
              for (auto& region : m.aircraft.rotor.section_drag) m.scale(region, factor(by));
            }),
      moved("table_blade_twist", "%", [](M& m, double by) { m.scale(m.aircraft.rotor.twist, factor(by)); }),
      moved("table_wing_lift", "%",
            [](M& m, double by) {
              for (auto& flap : m.aircraft.wing.lift_0) m.scale(flap, factor(by));
              for (auto& flap : m.aircraft.wing.lift_90) m.scale(flap, factor(by));
            }),
      moved("table_wing_drag", "%",
            [](M& m, double by) {
              for (auto& flap : m.aircraft.wing.drag_0) m.scale(flap, factor(by));
              for (auto& flap : m.aircraft.wing.drag_90) m.scale(flap, factor(by));
            }),
      moved("table_wing_moment", "%", [](M& m, double by) { m.scale(m.aircraft.wing.moment, factor(by)); }),
      moved("table_downwash", "%", [](M& m, double by) { m.scale(m.aircraft.wing.downwash, factor(by)); }),
      moved("table_interference", "%",
            [](M& m, double by) { m.scale(m.aircraft.pylon.interference, factor(by)); }),
      moved("table_fuselage", "%",
            [](M& m, double by) {
              for (auto* table : {&m.aircraft.fuselage.lift_alpha, &m.aircraft.fuselage.drag_alpha,
                                  &m.aircraft.fuselage.moment_alpha})
                m.scale(*table, factor(by));
            }),
      moved("table_tail_lift", "%",
            [](M& m, double by) {
              m.scale(m.aircraft.htail.lift_elevator, factor(by));
              m.scale(m.aircraft.htail.lift_mach, factor(by));
            }),
      moved("table_tail_wash", "%",
            [](M& m, double by) { m.scale(m.aircraft.htail.rotor_wash, factor(by)); }),
      moved("table_tail_pressure", "%",
            [](M& m, double by) { m.scale(m.aircraft.htail.pressure_ratio, factor(by)); }),
      moved("table_fin_force", "%",
            [](M& m, double by) {
              m.scale(m.aircraft.fin.side_rudder, factor(by));
              m.scale(m.aircraft.fin.side_mach, factor(by));
            }),
      moved("table_sidewash", "%", [](M& m, double by) { m.scale(m.aircraft.fin.sidewash, factor(by)); }),
      moved("table_long_cyclic", "%",
            [](M& m, double by) { m.scale(m.aircraft.controls.long_cyclic, factor(by)); }),
  };
  return all;
}

const Action& action_of(const DoubtfulInput& input) {
  for (const Action& action : actions()) {
    if (input.name == action.name) return action;
  }
  throw std::runtime_error("doubtful_inputs.csv: nothing moves '" + input.name + "'");
}

}  // namespace

const std::vector<DoubtfulInput>& doubtful_inputs() {
  static const std::vector<DoubtfulInput> all = [] {
    std::vector<DoubtfulInput> inputs;
    const text::Table rows = reference_points("doubtful_inputs");
    for (std::size_t i = 0; i < rows.rows(); ++i) {
      const DoubtfulInput input{rows.text(i, "input"), rows.number(i, "below"), rows.number(i, "above"),
                                rows.text(i, "unit"), rows.text(i, "reason")};
      if (input.unit != action_of(input).unit)
        throw std::runtime_error("doubtful_inputs.csv: " + input.name + " moves in " + action_of(input).unit);
      if (!(input.below >= 0 && input.above >= 0))
        throw std::runtime_error("doubtful_inputs.csv: " + input.name + " has a negative distance");
      inputs.push_back(input);
    }
    return inputs;
  }();
  return all;
}

ConfigurationParameter parameter_of(const DoubtfulInput& input) { return action_of(input).parameter; }

double parameter_amount(const DoubtfulInput& input, const Configured& c, double by) {
  const Action& action = action_of(input);
  return action.amount == nullptr ? 0 : by * action.amount(c);
}

MovedAircraft::MovedAircraft(const Setup& at, const DoubtfulInput& input, double by)
    : aircraft(aircraft_data<double>()), setup(at) {
  const Action& action = action_of(input);
  if (action.move != nullptr) {
    action.move(*this, by);
    c_ = configured(setup, aircraft);
  } else {
    const Configured base = configured(setup, aircraft);
    const double amount = parameter_amount(input, base, by);
    moved_configuration(base, &action.parameter, &amount, 1, c_);
  }
}

}  // namespace tiltrotor::study

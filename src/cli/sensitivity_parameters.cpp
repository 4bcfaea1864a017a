#include "cli/sensitivity_parameters.hpp"

#include <algorithm>

#include "cli/errors.hpp"
#include "cli/flight_options.hpp"
#include "text/nearest.hpp"
#include "text/split.hpp"

namespace tiltrotor::cli {

namespace {

using P = ConfigurationParameter;
using Configured = Configuration<double>;
using Kind = ParameterKind;

constexpr double kPercent = 0.01;
constexpr double kDegree = kRadPerDeg<double>;

double one(const Configured&) { return 1; }
double inch(const Configured&) { return kInch; }
double degree(const Configured&) { return kDegree; }
template <class R>
R factor(R percent) {
  return R(1) + R(kPercent) * percent;
}

// Every set of inertia that a switch may choose.
template <class A, class R>
void scale_inertia(A& a, R Inertia<R>::*axis, R by) {
  MassTables<R>& m = a.aircraft.mass;
  for (Inertia<R>* set : {&m.inertia, &m.inertia_slope, &m.design_0, &m.design_90}) set->*axis *= factor(by);
}

SensitivityParameter setting(const char* name, double amount, const char* unit, P parameter,
                             double (*in_si)(const Configured&)) {
  return {name, amount, unit, Kind::setting, parameter, in_si, {nullptr, nullptr}, nullptr};
}
SensitivityParameter consequence(const char* name, double amount, const char* unit, P parameter,
                                 double (*in_si)(const Configured&), AircraftChange change) {
  return {name, amount, unit, Kind::consequence, parameter, in_si, change, nullptr};
}
template <class Change>
AircraftChange both(Change change) {
  return {change, change};
}
template <class Change>
SensitivityParameter number(const char* name, double amount, const char* unit, Change change) {
  return {name, amount, unit, Kind::aircraft, P::count, nullptr, both(change), nullptr};
}
template <class Change>
SensitivityParameter gain(Kind kind, const char* name, Change change) {
  return {name, 5, "%", kind, P::count, nullptr, both(change), nullptr};
}

std::vector<SensitivityParameter> settings() {
  return {
      {"speed", 1, "m/s", Kind::flight, P::count, one, {nullptr, nullptr}, &SteadyFlight<double>::speed},
      {"turn_rate",
       1,
       "deg/s",
       Kind::flight,
       P::count,
       degree,
       {nullptr, nullptr},
       &SteadyFlight<double>::turn_rate},
      setting("mass", 100, "kg", P::mass, one),
      setting("cg_station", 1, "in", P::sl_cg, inch),
      setting("cg_waterline", 1, "in", P::wl_cg, inch),
      setting("mast", 1, "deg", P::mast, degree),
      setting("flap", 1, "deg", P::flap, degree),
      setting("rotor_speed", 10, "rpm", P::rotor_speed, [](const Configured&) { return kRpm; }),
      setting("altitude", 300, "m", P::altitude, one),
      consequence("air_density", 1, "%", P::air_density,
                  [](const Configured& c) { return kPercent * c.air.density; }, {nullptr, nullptr}),
      consequence("speed_of_sound", 1, "%", P::speed_of_sound,
                  [](const Configured& c) { return kPercent * c.air.speed_of_sound; }, {nullptr, nullptr}),
      consequence(
          "inertia_roll", 5, "%", P::inertia_xx,
          [](const Configured& c) { return kPercent * c.mass.inertia.xx; },
          both([](auto& a, auto by) { scale_inertia(a, &Inertia<decltype(by)>::xx, by); })),
      consequence(
          "inertia_pitch", 5, "%", P::inertia_yy,
          [](const Configured& c) { return kPercent * c.mass.inertia.yy; },
          both([](auto& a, auto by) { scale_inertia(a, &Inertia<decltype(by)>::yy, by); })),
      consequence(
          "inertia_yaw", 5, "%", P::inertia_zz,
          [](const Configured& c) { return kPercent * c.mass.inertia.zz; },
          both([](auto& a, auto by) { scale_inertia(a, &Inertia<decltype(by)>::zz, by); })),
      consequence(
          "inertia_roll_yaw", 5, "%", P::inertia_xz,
          [](const Configured& c) { return kPercent * c.mass.inertia.xz; },
          both([](auto& a, auto by) { scale_inertia(a, &Inertia<decltype(by)>::xz, by); })),
      // The factor is of the aircraft's spring, whatever a switch makes of it.
      consequence(
          "hub_spring", 10, "%", P::hub_spring_factor,
          [](const Configured& c) { return kPercent * c.hub_spring / c.aircraft->rotor.hub_spring; },
          both([](auto& a, auto by) { a.aircraft.rotor.hub_spring *= factor(by); })),
  };
}

std::vector<SensitivityParameter> numbers() {
  return {
      number("tail_area", 5, "%", [](auto& a, auto by) { a.aircraft.htail.surface.area *= factor(by); }),
      number("tail_incidence", 1, "deg",
             [](auto& a, auto by) { a.aircraft.htail.surface.incidence += by * kDegree; }),
      number("tail_station", 5, "in", [](auto& a, auto by) { a.aircraft.htail.surface.sl += by * kInch; }),
      number("tail_waterline", 5, "in", [](auto& a, auto by) { a.aircraft.htail.surface.wl += by * kInch; }),
      number("fin_area", 5, "%",
             [](auto& a, auto by) {
               a.aircraft.fin.surface.area *= factor(by);
               a.aircraft.fin.area_report *= factor(by);
             }),
      number("fin_station", 5, "in", [](auto& a, auto by) { a.aircraft.fin.surface.sl += by * kInch; }),
      number("fin_waterline", 5, "in", [](auto& a, auto by) { a.aircraft.fin.surface.wl += by * kInch; }),
      number("nacelle_mass", 50, "kg",
             [](auto& a, auto by) {
               a.aircraft.mass.nacelles += by;
               a.aircraft.mass.nacelles_quoted += by;
             }),
      number("mast_length", 1, "in", [](auto& a, auto by) { a.aircraft.mast.length += by * kInch; }),
      number("mast_cant", 0.5, "deg", [](auto& a, auto by) { a.aircraft.mast.cant += by * kDegree; }),
      number("blade_inertia", 5, "%", [](auto& a, auto by) { a.aircraft.rotor.flap_inertia *= factor(by); }),
      number("delta3", 1, "deg", [](auto& a, auto by) { a.aircraft.rotor.delta3 += by * kDegree; }),
      number("drag_area", 0.1, "m^2", [](auto& a, auto by) { a.aircraft.fuselage.extra_drag += by; }),
      number("elevator_gearing", 5, "%",
             [](auto& a, auto by) {
               a.aircraft.controls.elevator *= factor(by);
               a.aircraft.controls.elevator_replay *= factor(by);
             }),
      number("cyclic_rigging", 0.5, "deg",
             [](auto& a, auto by) { a.aircraft.controls.cyclic_rigging += by * kDegree; }),
  };
}

template <class A, std::size_t Count, class Table, class R>
void scale_all(A& a, Table (&tables)[Count], R by) {
  for (Table& table : tables) a.scale(table, factor(by));
}
template <class A, std::size_t Count, class Table, class R>
void shift_all(A& a, Table (&tables)[Count], R by) {
  for (Table& table : tables) a.shift(table, by);
}

// Tables of coefficients by component: all entries by a factor, or by an amount added.
std::vector<SensitivityParameter> tables() {
  return {
      number("blade_lift_factor", 5, "%",
             [](auto& a, auto by) { scale_all(a, a.aircraft.rotor.section_lift, by); }),
      number("blade_lift_shift", 0.01, "-",
             [](auto& a, auto by) { shift_all(a, a.aircraft.rotor.section_lift, by); }),
      number("blade_drag_factor", 5, "%",
             [](auto& a, auto by) { scale_all(a, a.aircraft.rotor.section_drag, by); }),
      number("blade_drag_shift", 0.001, "-",
             [](auto& a, auto by) { shift_all(a, a.aircraft.rotor.section_drag, by); }),
      number("blade_twist_factor", 5, "%",
             [](auto& a, auto by) { a.scale(a.aircraft.rotor.twist, factor(by)); }),
      number("wing_lift_factor", 5, "%",
             [](auto& a, auto by) {
               scale_all(a, a.aircraft.wing.lift_0, by);
               scale_all(a, a.aircraft.wing.lift_90, by);
             }),
      number("wing_lift_shift", 0.01, "-",
             [](auto& a, auto by) {
               shift_all(a, a.aircraft.wing.lift_0, by);
               shift_all(a, a.aircraft.wing.lift_90, by);
             }),
      number("wing_drag_factor", 5, "%",
             [](auto& a, auto by) {
               scale_all(a, a.aircraft.wing.drag_0, by);
               scale_all(a, a.aircraft.wing.drag_90, by);
             }),
      number("wing_drag_shift", 0.001, "-",
             [](auto& a, auto by) {
               shift_all(a, a.aircraft.wing.drag_0, by);
               shift_all(a, a.aircraft.wing.drag_90, by);
             }),
      number("wing_moment_factor", 5, "%",
             [](auto& a, auto by) { a.scale(a.aircraft.wing.moment, factor(by)); }),
      number("wing_moment_shift", 0.01, "-", [](auto& a, auto by) { a.shift(a.aircraft.wing.moment, by); }),
      number("wing_dihedral_shift", 0.01, "1/rad",
             [](auto& a, auto by) { a.shift(a.aircraft.wing.roll_beta, by); }),
      number("downwash_factor", 5, "%",
             [](auto& a, auto by) { a.scale(a.aircraft.wing.downwash, factor(by)); }),
      number("downwash_shift", 0.5, "deg",
             [](auto& a, auto by) { a.shift(a.aircraft.wing.downwash, by * kDegree); }),
      number("pylon_interference_factor", 5, "%",
             [](auto& a, auto by) { a.scale(a.aircraft.pylon.interference, factor(by)); }),
      number("fuselage_lift_factor", 5, "%",
             [](auto& a, auto by) { a.scale(a.aircraft.fuselage.lift_alpha, factor(by)); }),
      number("fuselage_moment_factor", 5, "%",
             [](auto& a, auto by) { a.scale(a.aircraft.fuselage.moment_alpha, factor(by)); }),
      number("fuselage_moment_shift", 0.1, "m^3",
             [](auto& a, auto by) { a.shift(a.aircraft.fuselage.moment_alpha, by); }),
      number("fuselage_side_factor", 5, "%",
             [](auto& a, auto by) { a.scale(a.aircraft.fuselage.side_beta, factor(by)); }),
      number("fuselage_yaw_factor", 5, "%",
             [](auto& a, auto by) { a.scale(a.aircraft.fuselage.yaw_beta, factor(by)); }),
      number("tail_lift_factor", 5, "%",
             [](auto& a, auto by) {
               a.scale(a.aircraft.htail.lift_elevator, factor(by));
               a.scale(a.aircraft.htail.lift_mach, factor(by));
             }),
      number("tail_lift_shift", 0.01, "-",
             [](auto& a, auto by) {
               a.shift(a.aircraft.htail.lift_elevator, by);
               a.shift(a.aircraft.htail.lift_mach, by);
             }),
      number("tail_drag_factor", 5, "%",
             [](auto& a, auto by) { a.scale(a.aircraft.htail.drag, factor(by)); }),
      number("tail_wash_factor", 5, "%",
             [](auto& a, auto by) { a.scale(a.aircraft.htail.rotor_wash, factor(by)); }),
      number("tail_pressure_factor", 5, "%",
             [](auto& a, auto by) { a.scale(a.aircraft.htail.pressure_ratio, factor(by)); }),
      number("fin_side_factor", 5, "%",
             [](auto& a, auto by) {
               a.scale(a.aircraft.fin.side_rudder, factor(by));
               a.scale(a.aircraft.fin.side_mach, factor(by));
             }),
      number("fin_drag_factor", 5, "%", [](auto& a, auto by) { a.scale(a.aircraft.fin.drag, factor(by)); }),
      number("sidewash_factor", 5, "%",
             [](auto& a, auto by) { a.scale(a.aircraft.fin.sidewash, factor(by)); }),
  };
}

std::vector<SensitivityParameter> gains() {
  return {
      gain(Kind::scas_gain, "scas_pitch_gain",
           [](auto& a, auto by) { a.scale(a.aircraft.systems.augmentation.pitch, factor(by)); }),
      gain(Kind::scas_gain, "scas_roll_gain",
           [](auto& a, auto by) { a.scale(a.aircraft.systems.augmentation.roll, factor(by)); }),
      gain(Kind::scas_gain, "scas_yaw_gain",
           [](auto& a, auto by) { a.scale(a.aircraft.systems.augmentation.yaw, factor(by)); }),
      gain(Kind::scas_gain, "scas_washout",
           [](auto& a, auto by) { a.aircraft.systems.augmentation.washout *= factor(by); }),
      gain(Kind::scas_gain, "scas_servo",
           [](auto& a, auto by) { a.aircraft.systems.augmentation.servo *= factor(by); }),
      gain(Kind::governor_gain, "governor_proportional_gain",
           [](auto& a, auto by) { a.scale(a.aircraft.systems.governor.proportional, factor(by)); }),
      gain(Kind::governor_gain, "governor_integral_gain",
           [](auto& a, auto by) { a.scale(a.aircraft.systems.governor.integral, factor(by)); }),
  };
}

}  // namespace

const std::vector<SensitivityParameter>& sensitivity_parameters() {
  static const std::vector<SensitivityParameter> all = [] {
    std::vector<SensitivityParameter> list = settings();
    for (const auto& part : {numbers(), tables(), gains()}) list.insert(list.end(), part.begin(), part.end());
    return list;
  }();
  return all;
}

namespace {

struct Freed {
  const char *column, *parameter;
};
constexpr Freed kFreed[] = {{"speed_mps", "speed"},      {"turn_rate_degps", "turn_rate"},
                            {"mass_kg", "mass"},         {"cg_sl_in", "cg_station"},
                            {"flap_deg", "flap"},        {"rotor_rpm", "rotor_speed"},
                            {"altitude_m", "altitude"},  {"climb_deg", "climb"},
                            {"sideslip_deg", "sideslip"}};

// Which moves with what a target lets go alone.
const SensitivityParameter kPath[] = {
    {"climb", 1, "deg", Kind::flight, P::count, degree, {nullptr, nullptr}, &SteadyFlight<double>::climb},
    {"sideslip",
     1,
     "deg",
     Kind::flight,
     P::count,
     degree,
     {nullptr, nullptr},
     &SteadyFlight<double>::sideslip}};

std::string parameter_of(const std::string& freed) {
  return std::find_if(std::begin(kFreed), std::end(kFreed), [&](const Freed& f) { return freed == f.column; })
      ->parameter;
}

}  // namespace

const SensitivityParameter& freed_parameter(const std::string& freed) {
  const std::string name = parameter_of(freed);
  for (const SensitivityParameter& parameter : kPath)
    if (name == parameter.name) return parameter;
  const auto& all = sensitivity_parameters();
  return *std::find_if(all.begin(), all.end(), [&](const auto& parameter) { return name == parameter.name; });
}

bool acts(const SensitivityParameter& parameter, const SensitivitySystems& systems) {
  if (parameter.kind == ParameterKind::governor_gain) return systems.governor == Governor::pi;
  return parameter.kind != ParameterKind::scas_gain || systems.scas;
}

std::vector<const SensitivityParameter*> chosen_parameters(const std::string& text, const std::string& where,
                                                           const SensitivitySystems& systems,
                                                           const std::vector<std::string>& freed) {
  std::vector<const SensitivityParameter*> chosen;
  std::vector<std::string> names;
  const auto follows = [&freed](const SensitivityParameter& parameter) {
    return std::any_of(freed.begin(), freed.end(),
                       [&](const std::string& name) { return parameter_of(name) == parameter.name; });
  };
  for (const SensitivityParameter& parameter : sensitivity_parameters()) {
    names.emplace_back(parameter.name);
    if (text == "all" && acts(parameter, systems) && !follows(parameter)) chosen.push_back(&parameter);
  }
  if (text == "all") return chosen;
  for (const std::string& word : split(text, ',')) {
    const auto place = std::find(names.begin(), names.end(), word);
    if (place == names.end())
      throw UsageError(where + ": " + quoted(word) + " is none of the parameters" +
                       did_you_mean(word, names) + "; choose all or some of " + one_of(names));
    const auto* const parameter = &sensitivity_parameters()[static_cast<std::size_t>(place - names.begin())];
    if (std::find(chosen.begin(), chosen.end(), parameter) != chosen.end())
      throw UsageError(where + ": " + quoted(word) + " is there twice");
    if (!acts(*parameter, systems))
      throw UsageError(where + ": " + word + " goes with " +
                       (parameter->kind == ParameterKind::scas_gain ? "--of modes --scas on"
                                                                    : "--of modes --option governor=pi"));
    if (follows(*parameter))
      throw UsageError(where + ": " + word +
                       " follows the others, since a held result lets it go: choose another");
    chosen.push_back(parameter);
  }
  return chosen;
}

}  // namespace tiltrotor::cli

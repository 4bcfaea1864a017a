#include "study/compared_aircraft.hpp"

#include <stdexcept>

#include "study/reference_points.hpp"
#include "tiltrotor/model/variables/presets.hpp"

namespace tiltrotor::study {

namespace {

struct Choice {
  const char* kind;  // of evidence
  const char* set;   // nullptr: every set of that kind
  ComparedAircraft aircraft;
};
// The first row that fits; what no row names is compared with the default of the program.
constexpr Choice kChoices[] = {
    {"reference simulation", nullptr, ComparedAircraft::as_simulated},
    {"identified", nullptr, ComparedAircraft::as_flown},
    {"flight", nullptr, ComparedAircraft::as_flown},
    {"design prediction", "hover_control_response", ComparedAircraft::as_designed},
};

constexpr double kDesignRotorSpeed = 565 * kPi<double> / 30;  // rad/s, NASA TM X-62407 p. 19

}  // namespace

const char* word(ComparedAircraft aircraft) {
  switch (aircraft) {
    case ComparedAircraft::as_simulated:
      return "as simulated";
    case ComparedAircraft::as_flown:
      return "as flown";
    case ComparedAircraft::as_designed:
      return "as designed";
    default:
      return "standard";
  }
}

ComparedAircraft compared_aircraft(const std::string& set) {
  static const Table sets = reference_points("validation_sets");
  const Table row = sets.where("set", set);
  if (row.rows() != 1) throw std::runtime_error("validation_sets.csv: no single row for " + set);
  for (const Choice& choice : kChoices) {
    if (row.text(0, "kind") == choice.kind && (choice.set == nullptr || set == choice.set))
      return choice.aircraft;
  }
  return ComparedAircraft::standard;
}

ComparedAircraft other_aircraft(ComparedAircraft aircraft) {
  if (aircraft == ComparedAircraft::as_simulated) return ComparedAircraft::as_flown;
  if (aircraft == ComparedAircraft::as_flown) return ComparedAircraft::as_simulated;
  return aircraft;
}

Setup setup_of(ComparedAircraft aircraft, double mast_deg) {
  Setup setup = default_setup(mast_deg);
  Options& o = setup.options;
  if (aircraft == ComparedAircraft::as_simulated) {
    choose(DataSet::as_simulated, o);
    o.lateral_cyclic = true;
    o.elevator_gearing = ElevatorGearing::printed_runs;
    o.engine_jets = true;
  }
  if (aircraft == ComparedAircraft::as_flown) choose(DataSet::as_flown, o);
  if (aircraft == ComparedAircraft::as_designed) {
    o.inertia = InertiaSet::design_1975;
    setup.rotor_speed = kDesignRotorSpeed;
  }
  return setup;
}

}  // namespace tiltrotor::study

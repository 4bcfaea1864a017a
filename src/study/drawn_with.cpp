#include "study/drawn_with.hpp"

#include "study/wording.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

namespace tiltrotor::study {

namespace {

constexpr double kPound = 0.45359237;  // kg

std::string name() { return aircraft_identity().name; }

constexpr const char* kHeld = "none, rotor speed held";

const char* governor_words(Governor governor) {
  switch (governor) {
    case Governor::off:
      return kHeld;
    case Governor::ideal:
      return "ideal, rotor speed and power held";
    case Governor::pi:
      return "pi, rotor speed by collective";
  }
  return "";
}

std::string inflow_words(const Options& options) {
  return std::string(options.inflow == InflowShape::pitt_peters ? "Pitt-Peters" : "uniform") +
         (options.radial_inflow == RadialInflow::annular ? ", radial shape" : "");
}

}  // namespace

std::string drawn_with(ComparedAircraft aircraft, const Setup& setup) {
  return "Aircraft: " + name() + ", " + word(aircraft) + ", " + fixed(setup.mass / kPound, 0) + " lb, " +
         (setup.altitude > 0 ? fixed(setup.altitude, 0) + " m" : "sea level") +
         ". Governor: " + governor_words(setup.options.governor) +
         ". Inflow: " + inflow_words(setup.options) + ".";
}

std::string drawn_with(Governor governor) {
  Setup setup = default_setup(0);
  setup.options.governor = governor;
  return drawn_with(ComparedAircraft::standard, setup);
}

std::string drawn_with() { return drawn_with(ComparedAircraft::standard, default_setup(0)); }

std::string drawn_with_rotor_alone() {
  return "Aircraft: one rotor of the " + name() + ". Governor: " + kHeld +
         ". Inflow: " + inflow_words(default_setup(0).options) + ", in equilibrium.";
}

}  // namespace tiltrotor::study

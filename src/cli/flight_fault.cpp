#include "cli/flight_fault.hpp"

#include <algorithm>
#include <cmath>

#include "text/number.hpp"

namespace tiltrotor::cli {

namespace {

using text::number_text;

constexpr int kDigits = 6;

struct Left {
  std::string name;
  double value;  // in the last good step
  Bounds<double> range;
  std::string unit;
};

std::string sentence(const Left& left) {
  const std::string unit = left.unit.empty() || left.unit == "-" ? "" : " " + left.unit;
  return ", " + left.name + ": leaves " + number_text(left.range.low, kDigits) + ".." +
         number_text(left.range.high, kDigits) + unit + " (" + number_text(left.value, kDigits) + unit +
         " in the last good step)";
}

Left setting(const Configuration<double>& c, SetupField field, double value, const char* name = nullptr) {
  return {name == nullptr ? setup_field_name(field) : name, value, setup_range(*c.aircraft, field),
          setup_field_unit(field)};
}

// Of its range, from the nearer end.
double margin(const Left& left) {
  return std::fmin(left.value - left.range.low, left.range.high - left.value) /
         (left.range.high - left.range.low);
}

// A step refused for its setting leaves that of the step before: what stands at the end of its range has left it.
std::string setting_at_its_end(const Configuration<double>& c) {
  constexpr double step = 0.01;  // at most, of a range
  const FlightSetup<double>& s = c.setup;
  const Left moving[] = {
      setting(c, SetupField::mass, s.mass),
      setting(c, SetupField::altitude, s.altitude),
      setting(c, SetupField::rotor_speed, s.rotor_speed - 0.5 * s.rotor_difference),
      setting(c, SetupField::rotor_speed, s.rotor_speed + 0.5 * s.rotor_difference),
      setting(c, SetupField::mast_rate, s.mast_rate),
      setting(c, SetupField::mast_acceleration, s.mast_acceleration),
      setting(c, SetupField::rotor_acceleration, s.rotor_acceleration),
  };
  const auto* const nearest =
      std::min_element(std::begin(moving), std::end(moving),
                       [](const Left& one, const Left& other) { return margin(one) < margin(other); });
  return margin(*nearest) < step ? sentence(*nearest) : "";
}

}  // namespace

std::string flight_fault_text(const Configuration<double>& c, const SystemFlight<double>& flight,
                              const Simulation<double>& simulation) {
  const int state = simulation.fault_state;
  const Status status = simulation.status;
  const std::string name = state < 0 ? "" : vehicle_variable(state).name;
  const std::string otherwise = (name.empty() ? "" : ", " + name) + ": " + status_text(status);
  if (status != Status::out_of_range) return otherwise;
  const SystemState<int>& at = kSystemIndex;
  const int system = state - state_count;
  if (state < 0 || system == at.fuel || system == at.mast || system == at.mast_rate || system == at.flap) {
    const std::string found = setting_at_its_end(c);
    if (state < 0 || !found.empty()) return found.empty() ? otherwise : found;
  }
  if (state == state_count + kSystemIndex.governor)
    return ", governor: the rotors take the power of the engines at no collective";
  if (state == state_count + kSystemIndex.rotor_speed)
    return sentence(setting(c, SetupField::rotor_speed, flight.state.rotor_speed, name.c_str()));
  if (state == kStateIndex.position.z)
    return sentence(setting(c, SetupField::altitude, c.setup.altitude, "down, altitude"));
  double x[vehicle_state_count];
  flatten(current_state(simulation), x);
  flatten(flight.state, x + state_count);
  const Variable& variable = vehicle_variable(state);
  const double bound = variable.facts().bound;
  return sentence({name, x[state], {-bound, bound}, variable.unit()});
}

}  // namespace tiltrotor::cli

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

Left setting(const Configuration<double>& c, SetupField field, double value) {
  return {setup_field_name(field), value, setup_range(*c.aircraft, field), setup_field_unit(field)};
}

// Of its range, from the nearer end.
double margin(const Left& left) {
  return std::fmin(left.value - left.range.low, left.range.high - left.value) /
         (left.range.high - left.range.low);
}

// The rotor that is nearer an end of the range of both.
Left rotor_at_its_end(const Configuration<double>& c) {
  const double mean = c.setup.rotor_speed, half = 0.5 * c.setup.rotor_difference;
  const Left slower = setting(c, SetupField::rotor_speed, mean - half);
  const Left faster = setting(c, SetupField::rotor_speed, mean + half);
  return margin(slower) < margin(faster) ? slower : faster;
}

// A step refused for its setting leaves that of the step before: what stands at the end of its range has left it.
std::string motion_at_its_end(const Configuration<double>& c) {
  constexpr double step = 0.01;  // at most, of a range
  const Left moving[] = {setting(c, SetupField::altitude, c.setup.altitude), rotor_at_its_end(c),
                         setting(c, SetupField::mast_rate, c.setup.mast_rate),
                         setting(c, SetupField::mast_acceleration, c.setup.mast_acceleration),
                         setting(c, SetupField::rotor_acceleration, c.setup.rotor_acceleration)};
  const auto* const nearest =
      std::min_element(std::begin(moving), std::end(moving),
                       [](const Left& one, const Left& other) { return margin(one) < margin(other); });
  return margin(*nearest) < step ? sentence(*nearest) : "";
}

// What a state of the systems has put beyond its range: system_behind().
bool find_setting(const Configuration<double>& c, int system, Left& left) {
  const SystemState<int>& at = kSystemIndex;
  const FlightSetup<double>& s = c.setup;
  if (system == at.mast)
    left = setting(c, SetupField::mast_deg, s.mast_deg);
  else if (system == at.mast_rate)
    left = setting(c, SetupField::mast_rate, s.mast_rate);
  else if (system == at.flap)
    left = setting(c, SetupField::flap_deg, s.flap_deg);
  else if (system == at.fuel)
    left = setting(c, SetupField::mass, s.mass);
  else if (system == at.rotor_speed || system == at.twist_rate)
    left = rotor_at_its_end(c);
  else
    return false;
  return true;
}

}  // namespace

std::string flight_fault_text(const Configuration<double>& c, const SystemFlight<double>& flight,
                              const Simulation<double>& simulation) {
  const int state = simulation.fault_state;
  const Status status = simulation.status;
  const std::string name = state < 0 ? "" : vehicle_variable(state).name;
  const std::string otherwise = (name.empty() ? "" : ", " + name) + ": " + status_text(status);
  if (status != Status::out_of_range) return otherwise;
  if (state < 0) {
    const std::string found = motion_at_its_end(c);
    return found.empty() ? otherwise : found;
  }
  if (state == state_count + kSystemIndex.governor)
    return ", governor: the rotors take the power of the engines at no collective";
  if (state == kStateIndex.position.z) {
    Left down = setting(c, SetupField::altitude, c.setup.altitude);
    down.name = "down, altitude";
    return sentence(down);
  }
  Left left;
  if (find_setting(c, state - state_count, left)) return sentence(left);
  double x[vehicle_state_count];
  flatten(current_state(simulation), x);
  flatten(flight.state, x + state_count);
  const Variable& variable = vehicle_variable(state);
  const double bound = variable.facts().bound;
  return sentence({name, x[state], {-bound, bound}, variable.unit()});
}

}  // namespace tiltrotor::cli

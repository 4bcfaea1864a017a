#include "study/flight_facts.hpp"

#include "study/linear_models.hpp"
#include "study/printed_flights.hpp"
#include "study/reference_points.hpp"
#include "study/sideward_flight.hpp"
#include "study/transfer_function.hpp"

namespace tiltrotor::study {

namespace {

// Conditions of an identified response of flight, and what flight had there.
constexpr double kCruiseSpeed = 104.4;  // m/s
constexpr double kCruiseAltitude = 2438;
constexpr double kStallMass = 12500 * 0.45359237;  // kg, of 12,000 to 13,000 lb
constexpr double kFlownYaw = 5.45;                 // deg/s^2 an inch: transfer_functions_lateral.csv

// Identified pitch acceleration by elevator, 1/s^2.
double flown_elevator() {
  return leading_coefficient(reference_points("transfer_functions")
                                 .where("name", std::string("cruise_q_elevator"))
                                 .text(0, "numerator"));
}

double flown_short_period() {
  return reference_points("modes_identified")
      .where("mode", std::string("short period"))
      .number(0, "frequency_rad_s");
}

double ratio_of(const std::string& quantity, ComparedAircraft aircraft, double mast_deg) {
  Setup setup = setup_of(aircraft, mast_deg);
  if (quantity == "ratio_yaw") {
    return degrees(control_derivative(quasi_steady(linear_model_at(setup, 0, kAllControls)),
                                      kStateIndex.rates.z, kControlIndex.pedal)) /
           kFlownYaw;
  }
  setup.altitude = kCruiseAltitude;
  const Linear model = linear_model_at(setup, kCruiseSpeed, kAllControls);
  if (quantity == "ratio_elevator")
    return control_derivative(model, kStateIndex.rates.y, kControlIndex.elevator) / flown_elevator();
  const Modes modes = modes_of(model);
  for (int k = 0; k < modes.count; ++k) {
    if (modes.mode[k].label.kind == ModeKind::short_period)
      return modes.mode[k].frequency / flown_short_period();
  }
  return kMissing;
}

// NaN where a limit of the trim is exceeded.
double travel_in_level_flight(const Configured& c, double speed_mps) {
  const Trimmed t = trimmed_persistently(c, speed_mps);
  return t.status == TrimStatus::ok ? travel_used(c, t.controls) : kMissing;
}

// Towards the side the travel is the same by symmetry.
double travel_on_track(const Configured& c, double speed_mps, double track_deg) {
  const SidewardFlight f = sideward_flight(c, speed_mps, track_deg * kRadPerDeg<double>);
  return f.found ? travel_used(c, f.controls) : kMissing;
}

// Power of level flight over that of the engines at take-off.
double power_used(const Configured& c, double speed_mps) {
  const Trimmed t = trimmed_persistently(c, speed_mps);
  const double engines = 2 * c.aircraft->controls.engine_power;
  return t.status == TrimStatus::ok ? total_power_kw(t) / (kWatt * engines) : kMissing;
}

constexpr int kHalvings = 30;

// Lowest speed of level flight with the wing short of its stall.
double stall_speed(const Setup& setup) {
  const Configured c = configured(setup);
  double low = 30;
  double high = 70;
  for (int k = 0; k < kHalvings; ++k) {
    const double speed = 0.5 * (low + high);
    const Trimmed t = trimmed_persistently(c, speed);
    const bool flies = is_trimmed(t.status) && t.status != TrimStatus::wing_stall;
    (flies ? high : low) = speed;
  }
  return high;
}

// Rate of descent at which the rotors take no power.
double idle_descent(const Setup& setup, double speed_mps) {
  const Configured c = configured(setup);
  double steep = -0.5;  // rad
  double shallow = 0;
  for (int k = 0; k < kHalvings; ++k) {
    const double climb = 0.5 * (steep + shallow);
    (total_power_kw(trimmed_persistently(c, speed_mps, climb)) > 0 ? shallow : steep) = climb;
  }
  return -speed_mps * std::sin(shallow);
}

double value_of(const Table& facts, std::size_t i, ComparedAircraft aircraft) {
  const std::string& quantity = facts.text(i, "quantity");
  const double mast = facts.number(i, "mast_deg");
  if (quantity.find("ratio_") == 0) return ratio_of(quantity, aircraft, mast);
  Setup setup = setup_of(aircraft, mast);
  const double speed = kKnot * facts.number(i, "speed_kt");
  if (quantity == "stall_speed_mps") {
    setup.mass = kStallMass;
    return stall_speed(setup);
  }
  if (quantity == "descent_mps") return idle_descent(setup, speed);
  const Configured c = configured(setup);
  if (quantity == "power_used") return power_used(c, speed);
  if (quantity == "travel_used_sideward") return travel_on_track(c, speed, 90);
  if (quantity == "travel_used_rearward") return travel_on_track(c, speed, 180);
  return travel_in_level_flight(c, speed);
}

std::vector<Comparison> compared(const std::string& set, ComparedAircraft aircraft) {
  std::vector<Comparison> rows;
  const Table facts = reference_points("flight_facts").where("set", set);
  for (std::size_t i = 0; i < facts.rows(); ++i) {
    rows.push_back({set, facts.text(i, "name") + ", " + point_of(facts, i), facts.text(i, "quantity"),
                    value_of(facts, i, aircraft), facts.number(i, "value"), facts.number(i, "mast_deg")});
  }
  return rows;
}

}  // namespace

void compare_flight_facts(std::vector<Comparison>& out) {
  for (const std::string set : {"ratios_gtrs_over_flight", "flight_facts"})
    add_compared(
        set, [&](ComparedAircraft aircraft) { return compared(set, aircraft); }, out);
}

}  // namespace tiltrotor::study

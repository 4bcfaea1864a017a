#include "study/linear_comparison.hpp"

#include <complex>

#include "study/printed_flights.hpp"
#include "study/printed_linear_model.hpp"
#include "study/reference_points.hpp"
#include "study/transfer_function.hpp"
#include "study/wording.hpp"

namespace tiltrotor::study {

namespace {

Linear printed_conditions(ComparedAircraft aircraft) {
  return printed_states(printed_model_setup(aircraft), aircraft_data<double>(), DownwashDelay::first_order);
}

std::vector<Comparison> compared_terms(ComparedAircraft aircraft) {
  std::vector<Comparison> rows;
  const std::vector<double> here = terms_of(printed_conditions(aircraft));
  for (std::size_t i = 0; i < here.size(); ++i) {
    const LinearTerm& term = printed_terms()[i];
    rows.push_back(
        {"linear_model_gtrs", "mast_deg=90 speed_kt=200", term.quantity(), here[i], term.printed, 90});
  }
  return rows;
}

// Of that name, NaN when there is none.
Complex root_named(const Modes& modes, const std::string& name, double& frequency, double& damping) {
  for (int k = 0; k < modes.count; ++k) {
    const Mode<double>& m = modes.mode[k];
    if (kind_word(m.label.kind) != name) continue;
    frequency = m.frequency;
    damping = m.damping_ratio;
    return {m.real, m.imag};
  }
  frequency = damping = kMissing;
  return {kMissing, kMissing};
}

// Frequency and damping ratio of an oscillation, the root itself where it is real.
void compare_root(const Modes& modes, const Table& there, std::size_t i, Comparison row,
                  std::vector<Comparison>& out) {
  double frequency = 0;
  double damping = 0;
  const std::string mode = there.text(i, "mode");
  const Complex root = root_named(modes, mode, frequency, damping);
  const auto add = [&](const char* what, double here, double reference) {
    row.quantity = mode + what;
    row.here = here;
    row.reference = reference;
    out.push_back(row);
  };
  if (there.number(i, "imag_rad_per_s") != 0) {
    add("_frequency_rad_s", frequency, there.number(i, "frequency_rad_s"));
    add("_damping_ratio", damping, there.number(i, "damping_ratio"));
  } else {
    add("_1_per_s", root.real(), there.number(i, "real_1_per_s"));
  }
}

std::vector<Comparison> compared_gtrs_modes(ComparedAircraft aircraft) {
  std::vector<Comparison> rows;
  const Table there = reference_points("modes_gtrs");
  const Modes modes = modes_of(printed_conditions(aircraft));
  for (std::size_t i = 0; i < there.rows(); ++i)
    compare_root(modes, there, i, {"modes_gtrs", point_of(there, i), "", 0, 0, 90}, rows);
  return rows;
}

Setup setup_at(ComparedAircraft aircraft, const Table& there, std::size_t row) {
  Setup setup = setup_of(aircraft, there.number(row, "mast_deg"));
  setup.altitude = there.number(row, "altitude_m");
  return setup;
}

std::vector<Comparison> compared_identified_modes(ComparedAircraft aircraft) {
  std::vector<Comparison> rows;
  const Table there = reference_points("modes_lateral_identified");
  for (std::size_t i = 0; i < there.rows(); ++i) {
    const Linear model =
        linear_model_at(setup_at(aircraft, there, i), there.number(i, "speed_mps"), kInceptors);
    Comparison row{"modes_lateral_identified", "condition=" + there.text(i, "condition"), "", 0, 0,
                   there.number(i, "mast_deg")};
    if (there.text(i, "mode") != "yaw") {
      compare_root(modes_of(model), there, i, row, rows);
      continue;
    }
    // In hover the yaw rate is alone with its damping.
    row.quantity = "yaw_1_per_s";
    row.here = state_derivative(quasi_steady(model), kStateIndex.rates.z, kStateIndex.rates.z);
    row.reference = there.number(i, "real_1_per_s");
    rows.push_back(row);
  }
  return rows;
}

// Without a name in the source: the root of the airframe nearest to it.
std::vector<Comparison> compared_other_modes(ComparedAircraft aircraft) {
  const std::string set = "modes_other_kleinhesselink";
  std::vector<Comparison> rows;
  const Table there = reference_points(set);
  for (std::size_t i = 0; i < there.rows(); ++i) {
    const Modes modes = modes_of(
        linear_model_at(printed_setup(aircraft, there, i), kKnot * there.number(i, "speed_kt"), kInceptors));
    const Complex root = {there.number(i, "real_1_per_s"), there.number(i, "imag_rad_per_s")};
    Complex nearest = {kMissing, kMissing};
    for (int k = 0; k < modes.count; ++k) {
      const Mode<double>& m = modes.mode[k];
      if (axis_word(m.axis) != there.text(i, "axis")) continue;
      const Complex here = {m.real, m.imag};
      if (!(std::abs(here - root) >= std::abs(nearest - root))) nearest = here;
    }
    const std::string point =
        point_of(there, i) + " " + there.text(i, "axis") + " " + there.text(i, "number");
    rows.push_back({set, point, "real_1_per_s", nearest.real(), root.real(), there.number(i, "mast_deg")});
    rows.push_back({set, point, "imag_rad_per_s", nearest.imag(), root.imag(), there.number(i, "mast_deg")});
  }
  return rows;
}

// Output of a lateral transfer function over its input, at one frequency, deg and s.
Complex response_here(const Linear& model, const Table& function, double omega) {
  if (function.text(0, "pedal_deg_per_in").empty()) {
    return response_of(model, kStateIndex.velocity.y, kControlIndex.rudder, omega) /
           function.number(0, "speed_mps");
  }
  return degrees(1) * response_of(model, kStateIndex.rates.z, kControlIndex.pedal, omega) /
         function.number(0, "pedal_deg_per_in");
}

std::vector<Comparison> compared_frequencies(ComparedAircraft aircraft) {
  const std::string set = "transfer_functions_lateral";
  std::vector<Comparison> rows;
  const Table functions = reference_points(set);
  const Table points = reference_points("frequency_points_lateral");
  for (const std::string& name : points.different("name")) {
    const Table function = functions.where("name", name);
    const double mast = function.number(0, "mast_deg");
    const Linear model =
        linear_model_at(setup_at(aircraft, function, 0), function.number(0, "speed_mps"), kAllControls);
    const Table there = points.where("name", name);
    for (std::size_t i = 0; i < there.rows(); ++i) {
      const std::string point = name + " omega=" + there.text(i, "omega_rad_s");
      const Complex here = response_here(model, function, there.number(i, "omega_rad_s"));
      const double phase = there.number(i, "phase_deg");
      rows.push_back({set, point, "gain_db", decibel(here), there.number(i, "gain_db"), mast});
      rows.push_back({set, point, "phase_deg", nearest_turn(phase_deg(here), phase), phase, mast});
    }
  }
  return rows;
}

}  // namespace

void compare_linear_model(std::vector<Comparison>& out) {
  add_compared("linear_model_gtrs", compared_terms, out);
}

void compare_modes(std::vector<Comparison>& out) {
  add_compared("modes_gtrs", compared_gtrs_modes, out);
  add_compared("modes_lateral_identified", compared_identified_modes, out);
  add_compared("modes_other_kleinhesselink", compared_other_modes, out);
}

void compare_lateral_frequencies(std::vector<Comparison>& out) {
  add_compared("transfer_functions_lateral", compared_frequencies, out);
}

}  // namespace tiltrotor::study

// Published flights of the reference simulation: that the files agree with themselves and with what they were
// derived from, and which aircraft each kind of evidence is compared with. Expected values: sums, geometry and
// characteristic polynomials of the published numbers alone.

#include <complex>

#include "check.hpp"
#include "study/compared_aircraft.hpp"
#include "study/printed_flights.hpp"
#include "study/reference_points.hpp"
#include "study/transfer_function.hpp"

using namespace tiltrotor::study;

namespace {

using C = std::complex<double>;

// Determinant of A - s over some of the states of the printed linear model, by elimination.
C characteristic(const Table& terms, const std::vector<std::string>& states, C s) {
  const std::size_t n = states.size();
  std::vector<std::vector<C>> m(n, std::vector<C>(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const Table term = terms.where("row", states[i]).where("column", states[j]);
      m[i][j] = (term.rows() > 0 ? term.number(0, "value") : 0) - (i == j ? s : C(0));
    }
  }
  // Kinematics, which the print leaves out: theta' = q, phi' = p + r tan 1.27 deg.
  for (std::size_t i = 0; i < n; ++i) {
    if (states[i] == "theta" && states[i - 1] == "q") m[i][i - 1] = 1;
    if (states[i] == "phi") {
      m[i][1] = 1;
      m[i][2] = 0.0221;
    }
  }
  C product = 1;
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < n; ++i) {
      if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
    }
    if (pivot != k) product = -product;
    std::swap(m[k], m[pivot]);
    product *= m[k][k];
    for (std::size_t i = k + 1; i < n; ++i) {
      const C factor = m[i][k] / m[k][k];
      for (std::size_t j = k; j < n; ++j) m[i][j] -= factor * m[k][j];
    }
  }
  return product;
}

}  // namespace

// A simulation is compared with the simulated aircraft and its own controls, a flight with the flown one.
TEST_OF_XV15(validation_sets_have_the_aircraft_of_their_kind) {
  const Table sets = reference_points("validation_sets");
  for (std::size_t i = 0; i < sets.rows(); ++i) {
    const ComparedAircraft aircraft = compared_aircraft(sets.text(i, "set"));
    const std::string& kind = sets.text(i, "kind");
    CHECK_EQ(kind == "reference simulation", aircraft == ComparedAircraft::as_simulated);
    CHECK_EQ(kind == "flight" || kind == "identified", aircraft == ComparedAircraft::as_flown);
    if (sets.text(i, "set").find("gtrs") != std::string::npos && kind != "reference simulation")
      CHECK_EQ(sets.text(i, "set"), std::string("trim_other_sheng_fig7_gtrs"));
  }
  const Setup simulated = setup_of(ComparedAircraft::as_simulated, 30);
  CHECK(simulated.options.lateral_cyclic);
  CHECK(simulated.options.elevator_gearing == tiltrotor::ElevatorGearing::printed_runs);
  const Setup designed = setup_of(compared_aircraft("hover_control_response"), 0);
  CHECK(designed.options.inertia == tiltrotor::InertiaSet::design_1975);
  CHECK_NEAR(designed.rotor_speed, 59.1667, 1e-4);
  CHECK(!setup_of(ComparedAircraft::as_flown, 0).options.lateral_cyclic);
  CHECK(other_aircraft(ComparedAircraft::as_flown) == ComparedAircraft::as_simulated);
  CHECK(other_aircraft(ComparedAircraft::as_designed) == ComparedAircraft::as_designed);
}

// A printed trim: its velocity has its speed and pitch, its forces carry 13000 lb and add up, its hub moments
// are those of its flapping.
TEST_OF_XV15(validation_sets_of_printed_trims_agree_with_themselves) {
  const Table trims = reference_points("trim_gtrs_conversion");
  const Table power = reference_points("rotor_power_gtrs");
  const Table loads = reference_points("component_loads_gtrs_conversion");
  CHECK_EQ(trims.rows(), 13u);
  for (std::size_t i = 0; i < trims.rows(); ++i) {
    const double u = trims.number(i, "u_fps");
    const double w = trims.number(i, "w_fps");
    CHECK_NEAR(degrees(std::atan2(w, u)), trims.number(i, "pitch_deg"), 0.08);
    CHECK_NEAR(std::hypot(u, w) * kFoot, trims.number(i, "speed_kt") * kKnot, 0.06);
    CHECK_NEAR(power.number(i, "hub_roll_lbfft"), 225 * trims.number(i, "lat_flap_deg"), 0.6);
    CHECK_NEAR(power.number(i, "hub_pitch_lbfft"), -225 * trims.number(i, "long_flap_deg"), 0.6);
    const Table at =
        loads.where("mast_deg", trims.text(i, "mast_deg")).where("speed_kt", trims.text(i, "speed_kt"));
    const auto force = [&](const char* component, const char* axis) {
      return at.where("component", std::string(component)).number(0, axis);
    };
    CHECK_NEAR(std::hypot(force("aircraft", "x_lbf"), force("aircraft", "z_lbf")), 13000.0, 3.5);
    // The shaft leans outboard by 1 deg at mast 0, not at mast 90.
    const double mast = trims.number(i, "mast_deg") / degrees(1);
    const double cant = std::cos(mast) / degrees(1);
    const double along = std::cos(cant) * (std::sin(mast) * force("rotor_left", "x_lbf") -
                                           std::cos(mast) * force("rotor_left", "z_lbf")) -
                         std::sin(cant) * force("rotor_left", "y_lbf");
    CHECK_REL(along * kPoundForce, trims.number(i, "thrust_n"), 2e-3);
    for (const char* axis : {"x_lbf", "z_lbf"})
      CHECK_NEAR(force("airframe", axis) + force("rotors_and_spinners", axis), force("aircraft", axis), 3.5);
  }
}

// The roots are those of the printed matrix, the points those of the published transfer functions.
TEST_OF_XV15(validation_sets_of_roots_and_points_follow_from_their_sources) {
  const Table terms = reference_points("linear_model_gtrs").where("matrix", std::string("A"));
  const Table modes = reference_points("modes_gtrs");
  for (std::size_t i = 0; i < modes.rows(); ++i) {
    const bool along = modes.text(i, "axis") == "longitudinal";
    const std::vector<std::string> states = along ? std::vector<std::string>{"u", "w", "q", "theta"}
                                                  : std::vector<std::string>{"v", "p", "r", "phi"};
    const C root = {modes.number(i, "real_1_per_s"), modes.number(i, "imag_rad_per_s")};
    const double near_by = std::abs(characteristic(terms, states, root + C(0.1, 0)));
    CHECK_LT(std::abs(characteristic(terms, states, root)), 0.02 * near_by);
    CHECK_NEAR(std::abs(root), modes.number(i, "frequency_rad_s"), 1e-3);
  }
  const Table functions = reference_points("transfer_functions_lateral");
  const Table points = reference_points("frequency_points_lateral");
  CHECK_EQ(points.rows(), 18u);
  for (std::size_t i = 0; i < points.rows(); ++i) {
    const Table f = functions.where("name", points.text(i, "name"));
    const C s(0, points.number(i, "omega_rad_s"));
    const C value = polynomial(f.text(0, "numerator"), s) / polynomial(f.text(0, "denominator"), s) *
                    std::exp(-s * f.number(0, "delay_s"));
    CHECK_NEAR(decibel(value), points.number(i, "gain_db"), 0.01);
    CHECK_NEAR(nearest_turn(phase_deg(value), points.number(i, "phase_deg")), points.number(i, "phase_deg"),
               0.1);
  }
}

// Frequency responses, zeros, margins and the first-order rigid body of the aircraft's linear models. Expected: GNU
// Octave with SLICOT on the same matrices (tests/reference/README.md), the full model, and closed forms.
#include <complex>

#include "analysis_case.hpp"
#include "tiltrotor/analysis/linear/channel.hpp"
#include "tiltrotor/analysis/linear/frequency_measures.hpp"
#include "tiltrotor/analysis/linear/mode_shape.hpp"
#include "tiltrotor/analysis/linear/rigid_model.hpp"

using namespace analysis_case;
using C = std::complex<double>;

namespace {

struct Work {
  VehicleChannel<double> channel;
  VehicleTransfer<double> f;
  TransferFunctionWorkspace<double, kMaxVehicleStates> roots;
  ResponseWorkspace<double, kMaxVehicleStates> response;
};

// Rows and columns of the reference files; complete, heading included, or as set_channel() makes it.
void reference_channel(const std::string& point, const std::string& output, const std::string& input,
                       bool complete, VehicleChannel<double>& s) {
  const check::CsvFile a("tests/reference/A_" + point + ".csv"), b("tests/reference/B_" + point + ".csv");
  VehicleShape shape{};
  for (int i = 0; i < a.rows(); ++i)
    for (int k = 0; k < state_count; ++k)
      if (a.text(i, "row") == kStateVariables[k].name) shape.state[shape.states++] = k;
  const auto entry = [&](int i, int j) { return a.number(i, kStateVariables[shape.state[j]].name); };
  const auto column = [&](int i) { return b.number(i, input); };
  const auto row = [&](int j) { return output == kStateVariables[shape.state[j]].name ? 1.0 : 0.0; };
  if (!complete) return set_channel(shape, 0, entry, column, row, 0.0, s);
  s.states = shape.states;
  s.d = 0;
  for (int i = 0; i < s.states; ++i) {
    s.b[i] = column(i);
    s.c[i] = row(i);
    for (int j = 0; j < s.states; ++j) s.a(i, j) = entry(i, j);
  }
}

double nearest(const Eigenvalues<double, kMaxVehicleStates>& roots, C root) {
  double least = 1e300;
  for (int k = 0; k < roots.size; ++k)
    least = std::min(least, std::abs(C(roots.real[k], roots.imag[k]) - root));
  return least / (1 + std::abs(root));
}

}  // namespace

TEST(transfer_function_of_the_aircraft_is_that_of_an_independent_tool) {
  static Work whole, part;
  const check::CsvFile octave("tests/reference/frequency_octave.csv");
  std::string channel_before;
  int zeros = 0;
  double worst_zero = 0, worst_part = 0, worst_response = 0, worst_gain = 0;
  for (int i = 0; i < octave.rows(); ++i) {
    const std::string point = octave.text(i, "point"), to = octave.text(i, "output"),
                      from = octave.text(i, "input");
    const std::string quantity = octave.text(i, "quantity");
    const C value(octave.number(i, "real"), octave.number(i, "imag"));
    if (point + to + from != channel_before) {
      reference_channel(point, to, from, true, whole.channel);
      CHECK(transfer_function(whole.channel, whole.roots, whole.f) == Status::ok);
      reference_channel(point, to, from, false, part.channel);
      CHECK(transfer_function(part.channel, part.roots, part.f) == Status::ok);
      CHECK_LT(part.f.states, whole.f.states);  // the other half is left out, with as many poles as zeros
      CHECK_EQ(whole.f.states - whole.f.zeros.size, part.f.states - part.f.zeros.size);
      channel_before = point + to + from;
      zeros = 0;
    }
    if (quantity == "zero") {
      ++zeros;
      CHECK_LE(zeros, whole.f.zeros.size);
      worst_zero = std::max(worst_zero, nearest(whole.f.zeros, value));
      // A zero of the part, or a pole of what it leaves out.
      worst_part =
          std::max(worst_part, std::min(nearest(part.f.zeros, value), nearest(whole.f.poles, value)));
    }
    if (quantity == "gain") {
      CHECK_EQ(zeros, whole.f.zeros.size);
      for (const Work* const w : {&whole, &part})
        worst_gain = std::max(worst_gain, std::abs(w->f.gain / value.real() - 1));
    }
    if (quantity != "response") continue;
    for (Work* const w : {&whole, &part}) {
      const C here = response(w->f, {0, octave.number(i, "x")}, w->response);
      worst_response = std::max(worst_response, std::abs(here / value - 1.0));
    }
  }
  NOTE("zeros " << worst_zero << ", of the part " << worst_part << ", responses " << worst_response
                << ", gain " << worst_gain);
  CHECK_LT(worst_zero, 1e-9);
  CHECK_LT(worst_part, 1e-9);
  CHECK_LT(worst_response, 1e-9);
  CHECK_LT(worst_gain, 1e-9);
}

TEST(transfer_function_margins_are_those_of_an_independent_tool) {
  static Work at;
  const check::CsvFile octave("tests/reference/frequency_octave.csv");
  int compared = 0;
  for (int i = 0; i < octave.rows(); ++i) {
    const std::string what = octave.text(i, "quantity");
    if (what == "zero" || what == "gain" || what == "response") continue;
    reference_channel(octave.text(i, "point"), octave.text(i, "output"), octave.text(i, "input"), true,
                      at.channel);
    CHECK(transfer_function(at.channel, at.roots, at.f) == Status::ok);
    const Bandwidth<double> b = bandwidth(at.f, at.response);
    Margins<double> m;
    CHECK(margins(at.channel, at.f, octave.number(i, "x"), at.roots, at.response, m) == Status::ok);
    const double here = what == "omega_180"          ? b.omega_180
                        : what == "by_phase"         ? b.by_phase
                        : what == "by_gain"          ? b.by_gain
                        : what == "phase_delay"      ? b.phase_delay
                        : what == "gain_margin"      ? m.gain
                        : what == "omega_gain"       ? m.omega_gain
                        : what == "phase_margin_deg" ? m.phase / kDeg
                        : what == "omega_phase"      ? m.omega_phase
                                                     : m.unstable_closed;
    const double there = octave.number(i, "real");
    ++compared;
    if (!std::isfinite(there)) {
      if (!CHECK(std::isnan(here))) NOTE(octave.text(i, "point") << " " << what << " " << here);
    } else if (!CHECK_NEAR(here, there, 1e-5 * (0.1 + std::abs(there)))) {
      NOTE(octave.text(i, "point") << " " << octave.text(i, "output") << " " << what);
    }
  }
  CHECK_EQ(compared, 36);
}

// x' = -x + u, y = x + d u: a direct term of rounding beside x is none, and a hundred times it is one.
TEST(transfer_function_of_a_channel_has_no_direct_term_of_rounding) {
  static Work at;
  VehicleShape shape{};
  shape.states = 1;
  shape.state[0] = kStateIndex.rates.y;
  const int input = kControlIndex.long_stick;
  const double bend = vehicle_variable(shape.state[0]).facts().bend / vehicle_input(input).facts().bend;
  const double rounding = 64 * std::numeric_limits<double>::epsilon() * bend;
  for (const double times : {0.5, 100.0}) {
    set_channel(
        shape, input, [](int, int) { return -1.0; }, [](int) { return 1.0; }, [](int) { return 1.0; },
        times * rounding, at.channel);
    CHECK(transfer_function(at.channel, at.roots, at.f) == Status::ok);
    CHECK_EQ(at.f.d, times < 1 ? 0.0 : times * rounding);
    CHECK_EQ(at.f.zeros.size, times < 1 ? 0 : 1);
  }
}

// The steady response is that of the full model, and every root nearer than that of the quasi-steady one where the lag
// of the downwash counts: the short period, 1 to 3 %, at worst 6 % of the roots below 4 rad/s.
TEST(residualised_model_of_first_order_keeps_the_roots) {
  static LinearModel<double> full, reduced, balance;
  static RigidModelWorkspace<double> work;
  static ModesWorkspace<double> modes_work;
  static ModeSet<double> of_full, of_reduced, of_balance;
  static FullRoot<double> first[kMaxLinearStates], none[kMaxLinearStates];
  static LU<double, kMaxLinearStates> big, small;
  for (int k = 0; k < 3; ++k) {
    const Point p = reference_point(kReferencePoints[k]);
    linear_model(configuration(kReferenceMasts[k]), p.x, p.u, kInceptors, full);
    CHECK(rigid_model(full, Reduction::first_order, work, reduced) == Status::ok);
    CHECK(rigid_model(full, Reduction::quasi_steady, work, balance) == Status::ok);
    CHECK(lu_factor(full.a, full.states, big) == Status::ok);
    CHECK(lu_factor(reduced.a, reduced.states, small) == Status::ok);
    for (int j = 0; j < 4; ++j) {
      double x[kMaxLinearStates], y[kMaxLinearStates];
      for (int i = 0; i < full.states; ++i) x[i] = full.b(i, j);
      for (int i = 0; i < 8; ++i) y[i] = reduced.b(i, j);
      CHECK(lu_solve(big, x) == Status::ok);
      CHECK(lu_solve(small, y) == Status::ok);
      for (int i = 0; i < 8; ++i) CHECK_NEAR(y[i], x[i], 1e-8 * (1 + std::abs(x[i])));
    }
    CHECK(modes(full, modes_work, of_full) == Status::ok);
    CHECK(modes(reduced, modes_work, of_reduced) == Status::ok);
    CHECK(modes(balance, modes_work, of_balance) == Status::ok);
    find_full_roots(of_full, of_reduced, first);
    find_full_roots(of_full, of_balance, none);
    double worst_first = 0, worst_none = 0;
    for (int i = 0; i < 8; ++i) {
      worst_first = std::max(worst_first, first[i].error);
      worst_none = std::max(worst_none, none[i].error);
    }
    NOTE(kReferencePoints[k] << ": first order " << worst_first << ", quasi-steady " << worst_none);
    CHECK_LT(worst_first, 0.06);
    CHECK_LT(worst_first, worst_none);
  }
}

// One fast state by hand: x' = a x + b z, z' = (g x - z)/T: (1 + b g T) x' = (a + b g) x. And refusals.
TEST(residualised_model_of_first_order_in_closed_form) {
  static LinearModel<double> full, reduced;
  static RigidModelWorkspace<double> work;
  clear(full);
  full.states = kRigidStates + 1;
  full.controls = 1;
  const double a = -0.7, b = -2, g = 0.4, T = 0.05;
  for (int i = 0; i < kRigidStates; ++i) full.a(i, i) = -1 - i;
  full.a(2, 2) = a;
  full.a(2, kRigidStates) = b;
  full.a(kRigidStates, 2) = g / T;
  full.a(kRigidStates, kRigidStates) = -1 / T;
  full.b(2, 0) = 3;
  CHECK(rigid_model(full, Reduction::first_order, work, reduced) == Status::ok);
  CHECK_NEAR(reduced.a(2, 2), (a + b * g) / (1 + b * g * T), 1e-14);
  CHECK_NEAR(reduced.b(2, 0), 3 / (1 + b * g * T), 1e-14);
  CHECK_NEAR(reduced.a(3, 3), -4, 1e-14);
  full.a(kRigidStates, 2) = full.a(kRigidStates, kRigidStates) = 0;
  CHECK(rigid_model(full, Reduction::first_order, work, reduced) == Status::singular);
  CHECK_EQ(reduced.states, 0);
}

// Phasors satisfy the model's own kinematics: theta' = q and phi' = p + r tan(theta0) in straight flight, so that their
// ratio is the eigenvalue; participations of a mode sum to 1.
TEST(modes_shapes_obey_the_kinematics) {
  static LinearModel<double> model;
  static ModesWorkspace<double> work;
  static ModeSet<double> set;
  Phasor<double> phasor[kMaxLinearStates];
  for (int k = 0; k < 3; ++k) {
    const Point p = reference_point(kReferencePoints[k]);
    linear_model(configuration(kReferenceMasts[k]), p.x, p.u, kInceptors, model);
    CHECK(modes(model, work, set) == Status::ok);
    int theta = 0, q = 0;
    for (int i = 0; i < set.states; ++i) {
      if (set.coordinate[i].state == kStateIndex.pitch) theta = i;
      if (set.coordinate[i].state == kStateIndex.rates.y) q = i;
    }
    for (int m = 0; m < set.count; ++m) {
      const Mode<double>& mode = set.mode[m];
      const int largest = largest_state(set.system, mode.eigenvalue,
                                        [&](int i) { return is_rigid(set.coordinate[i].state); });
      mode_shape(set.system, mode.eigenvalue, largest, phasor);
      double total = 0;
      for (int i = 0; i < set.states; ++i) {
        total += phasor[i].participation;
        if (is_rigid(set.coordinate[i].state)) CHECK_LE(phasor[i].magnitude, 1.0);
      }
      CHECK_NEAR(total, 1, 1e-12);
      CHECK_NEAR(phasor[largest].magnitude, 1, 0);
      CHECK_NEAR(phasor[largest].angle, 0, 0);
      if (mode.axis != ModeAxis::longitudinal || phasor[theta].magnitude < 1e-9) continue;
      mode_shape(set.system, mode.eigenvalue, theta, phasor);
      const C ratio = std::polar(phasor[q].magnitude, phasor[q].angle);
      CHECK_LT(std::abs(ratio - C(mode.real, mode.imag)), 1e-8 * (1 + mode.frequency));
    }
  }
}

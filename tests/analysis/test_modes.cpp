// Modes: eigenvalues of a second implementation, the definition of a mode, and names.
#include <algorithm>
#include <set>

#include "analysis_case.hpp"

using namespace analysis_case;

namespace {

// Distance of an expected eigenvalue from the nearest one of the modes on `axis side`, relative to its size.
double nearest(const ModeSet<double>& set, double real, double imag, bool longitudinal) {
  double best = 1e9;
  for (int i = 0; i < set.count; ++i) {
    const ModeShares<double>& s = set.mode[i].shares;
    const bool is_longitudinal = s.longitudinal_body() + s.mean + s.downwash > 0.5;
    if (is_longitudinal != longitudinal) continue;
    best = std::min(best, std::hypot(set.mode[i].real - real, set.mode[i].imag - std::abs(imag)));
  }
  return best / std::hypot(real, imag);
}

void check_names_unique(const ModeSet<double>& set) {
  std::set<std::string> names;
  int roots = 0;
  for (int i = 0; i < set.count; ++i) {
    names.insert(set.mode[i].name);
    roots += set.mode[i].imag > 0 ? 2 : 1;
  }
  CHECK_EQ(names.size(), static_cast<std::size_t>(set.count));
  CHECK_EQ(roots, set.states);
}

bool has(const ModeSet<double>& set, const char* name) { return !std::isnan(mode_named(set, name).real); }

}  // namespace

// tests/reference: symmetric, antisymmetric and residualised sets of a second implementation.
TEST_OF_XV15(modes_reference_eigenvalues) {
  static LinearModel<double> full, reduced;
  static ResidualisationWorkspace<double> residual;
  static ModesWorkspace<double> work;
  static ModeSet<double> modes_full, modes_reduced;
  const check::CsvFile file("tests/reference/eigenvalues.csv");
  double worst = 0;
  for (int k = 0; k < 3; ++k) {
    const Point p = reference_point(kReferencePoints[k]);
    linear_model(reference_configuration(kReferenceMasts[k]), p.x, p.u, kInceptors, full);
    CHECK(residualise(full, residual, reduced) == Status::ok);
    CHECK(modes(full, work, modes_full) == Status::ok);
    CHECK(modes(reduced, work, modes_reduced) == Status::ok);
    check_names_unique(modes_full);
    check_names_unique(modes_reduced);
    for (int row = 0; row < file.rows(); ++row) {
      if (file.number(row, "mast_deg") != kReferenceMasts[k]) continue;
      const std::string set = file.text(row, "set");
      const bool quasi_steady = set.size() > 3;
      const double error = nearest(quasi_steady ? modes_reduced : modes_full, file.number(row, "real"),
                                   file.number(row, "imag"), set.substr(0, 3) == "lon");
      CHECK_LT(error, 1e-8);
      worst = std::max(worst, error);
    }
  }
  NOTE("worst relative error " << worst);
}

// A x = lambda x through the numbers a user sees: damping and times from their definitions.
TEST(modes_numbers_follow_from_the_eigenvalue) {
  static ModeSet<double> set;
  const Configuration<double> c = configuration(90);
  const TrimResult<double> r = trimmed(c, level(100));
  modes_of(c, r.state, r.controls, set);
  for (int i = 0; i < set.count; ++i) {
    const Mode<double>& m = set.mode[i];
    CHECK_NEAR(std::exp(m.real * m.time_to_half), 0.5, 1e-12);
    CHECK_NEAR(-m.damping_ratio * m.frequency, m.real, 1e-12 * m.frequency);
    CHECK_LE(0.0, m.imag);
    const ModeShares<double>& s = m.shares;
    CHECK_NEAR(s.body() + s.downwash + s.mean + s.difference, 1, 1e-12);
    CHECK_NEAR(s.mean + s.difference, s.flap + s.inflow_mean + s.inflow_cyclic + s.coning, 1e-12);
  }
}

// Which root is which: from another program.
TEST_OF_XV15(modes_names_of_known_roots) {
  static ModeSet<double> set;
  const auto near = [&](const char* name, double real, double imag) {
    const Mode<double> m = mode_named(set, name);
    CHECK_NEAR(m.real, real, 2e-3);
    if (!CHECK_NEAR(m.imag, imag, 2e-3)) NOTE(name);
  };
  const auto at = [&](double mast, double speed) {
    const Configuration<double> c = reference_configuration(mast);
    const TrimResult<double> r = trimmed(c, level(speed));
    modes_of(c, r.state, r.controls, set);
    check_names_unique(set);
  };
  at(0, 0);
  near("heave", -0.165, 0);
  near("pitch_subsidence", -0.628, 0);
  near("phugoid", 0.120, 0.385);  // the unstable oscillation of hover
  near("roll", -0.568, 0);
  near("dutch_roll", -0.061, 0.271);
  near("spiral", 0.160, 0);
  at(0, 30.9);
  near("spiral", -0.115, 0);
  near("roll", -0.906, 0);
  near("dutch_roll", 0.083, 0.271);
  at(30, 40);
  near("phugoid", -0.049, 0.293);
  near("short_period", -0.947, 1.356);
  at(60, 60);
  near("phugoid", -0.127, 0.260);
  near("dutch_roll", -0.263, 1.246);
  at(90, 100);
  near("phugoid", -0.196, 0.307);
  near("short_period", -1.295, 2.060);
  near("spiral", -0.053, 0);
  near("dutch_roll", -0.419, 1.805);
  near("roll", -1.433, 0);
  CHECK(has(set, "downwash"));
  for (const char* name :
       {"flap_progressing_sym", "flap_progressing_anti", "flap_regressing_sym", "flap_regressing_anti",
        "inflow_mean_sym", "inflow_mean_anti", "inflow_cyclic_sym", "inflow_cyclic_anti"})
    if (!CHECK(has(set, name))) NOTE(name);
  CHECK(std::string(axis_word(mode_named(set, "downwash").axis)) == "longitudinal");
  CHECK(std::string(axis_word(mode_named(set, "inflow_mean_sym").axis)) == "rotor");
}

// Along sweeps within the corridor the names alone, without following, stay with a mode while it moves, and
// following agrees with them.
TEST(modes_names_persist_along_a_sweep) {
  static ModeSet<double> set, previous;
  struct Sweep {
    double mast, from, to;
  };
  for (const Sweep& sweep : {Sweep{90, 60, 140}, Sweep{60, 50, 85}, Sweep{30, 30, 70}}) {
    const Configuration<double> c = flown_configuration(sweep.mast);
    bool first = true;
    for (double speed = sweep.from; speed <= sweep.to; speed += 2.5) {
      const TrimResult<double> r = trimmed(c, flown(level(speed)));
      modes_of(c, r.state, r.controls, set);
      if (!first) {
        CHECK(follow(previous, set) == Status::ok);
        for (const char* name :
             {"phugoid", "short_period", "spiral", "roll", "dutch_roll", "flap_regressing_sym",
              "flap_regressing_anti", "flap_progressing_sym", "flap_progressing_anti"}) {
          const Mode<double> a = mode_named(previous, name);
          const Mode<double> b = mode_named(set, name);
          const double jump = std::hypot(a.real - b.real, a.imag - b.imag);
          if (!(CHECK_LT(jump, 0.1 + 0.25 * a.frequency) && CHECK_EQ(a.branch, b.branch)))
            NOTE(name << " at mast " << sweep.mast << ", " << speed << " m/s");
        }
      }
      check_names_unique(set);
      previous = set;
      first = false;
    }
  }
}

// follow() hands on branches whatever the names: with two exchanged in the previous set, the exchange
// persists.
TEST_OF_XV15(modes_follow_takes_branches_from_the_previous_set) {
  static ModeSet<double> a, b;
  const Configuration<double> c = reference_configuration(90);
  const TrimResult<double> r = trimmed(c, level(100));
  const TrimResult<double> s = trimmed(c, level(101));
  modes_of(c, r.state, r.controls, a);
  modes_of(c, s.state, s.controls, b);
  int phugoid = -1, short_period = -1;
  for (int i = 0; i < a.count; ++i) {
    if (a.mode[i].label.kind == ModeKind::phugoid) phugoid = i;
    if (a.mode[i].label.kind == ModeKind::short_period) short_period = i;
  }
  if (!CHECK(phugoid >= 0 && short_period >= 0)) return;
  CHECK_NEAR(overlap(a, phugoid, a, phugoid), 1, 1e-9);
  CHECK_LT(overlap(a, phugoid, a, short_period), 1e-9);  // left and right vectors are biorthogonal
  // One more metre per second: every mode has one clear continuation and overlaps with nothing else.
  for (int i = 0; i < a.count; ++i) {
    double best = 0, sum = 0;
    for (int j = 0; j < b.count; ++j) {
      best = std::max(best, overlap(a, i, b, j));
      sum += overlap(a, i, b, j);
    }
    CHECK_LT(0.9, best);
    CHECK_LT(sum, 1.3);
  }
  std::swap(a.mode[phugoid].branch, a.mode[short_period].branch);
  CHECK(follow(a, b) == Status::ok);
  CHECK_EQ(mode_named(b, "short_period").branch, a.mode[short_period].branch);
  CHECK_EQ(mode_named(b, "phugoid").branch, a.mode[phugoid].branch);
  CHECK_NEAR(mode_named(b, "phugoid").real, -0.196, 0.02);
  CHECK_NEAR(mode_named(b, "short_period").real, -1.3, 0.1);
  check_names_unique(b);
}

// From hover on, pairs split and merge: every mode still has one name and none twice.
TEST(modes_names_in_helicopter_mode_and_turns) {
  static ModeSet<double> set, previous;
  const Configuration<double> c = flown_configuration(0);
  bool first = true;
  for (double speed = 0; speed <= 50; speed += 2.5) {
    const TrimResult<double> r = trimmed(c, flown(level(speed)));
    modes_of(c, r.state, r.controls, set);
    check_names_unique(set);
    if (!first) CHECK(follow(previous, set) == Status::ok);
    check_names_unique(set);
    CHECK(has(set, "phugoid"));
    CHECK(has(set, "dutch_roll") != has(set, "aperiodic_dutch_roll_2"));
    CHECK(has(set, "roll"));
    previous = set;
    first = false;
  }
  for (double mast : {0.0, 30.0, 60.0, 90.0}) {
    const Configuration<double> turning = flown_configuration(mast);
    const TrimResult<double> r =
        trimmed(turning, flown({mast < 90 ? 30.0 + mast / 2 : 80.0, 3 * kDeg, 8 * kDeg, 2 * kDeg}));
    CHECK(is_trimmed(r.status));
    modes_of(turning, r.state, r.controls, set);
    check_names_unique(set);
    CHECK(has(set, "dutch_roll") != has(set, "aperiodic_dutch_roll_2"));
    CHECK(has(set, "phugoid"));
    // and away from any trim
    State<double> x = r.state;
    x.rates.x += 0.3;
    x.velocity.z += 2;
    x.rotor[left].b1c += 0.02;
    modes_of(turning, x, r.controls, set);
    check_names_unique(set);
  }
}

TEST(modes_refuse_bad_input) {
  static LinearModel<double> model;
  static ModesWorkspace<double> work;
  static ModeSet<double> set, other;
  const Point p = reference_point("mast30_v050");
  const Configuration<double> c = configuration(30);
  linear_model(c, p.x, p.u, kInceptors, model);
  CHECK(modes(model, work, other) == Status::ok);
  model.a(3, 4) = std::nan("");
  CHECK(modes(model, work, set) == Status::not_finite);
  CHECK_EQ(set.count, 0);
  CHECK(follow(other, set) == Status::bad_argument);
  for (const int states : {0, kRigidStates - 1, kMaxLinearStates + 1}) {
    model.states = states;
    CHECK(modes(model, work, set) == Status::bad_argument);
  }
  set = other;
  CHECK(follow(other, set) == Status::ok);
  set.coordinate[set.states].state = kStateIndex.yaw;  // past the states there are
  CHECK(follow(other, set) == Status::ok);
  set.states -= 1;
  CHECK(follow(other, set) == Status::bad_argument);
  set = other;
  set.coordinate[2].state = kStateIndex.yaw;
  CHECK(follow(other, set) == Status::bad_argument);
  set = other;
  other.count = 0;
  CHECK(follow(other, set) == Status::bad_argument);
}

// All roots of [0 1; 0 0] and zeros are zero: no frequency, no time to half, and shares that are
// numbers all the same.
TEST(modes_of_a_chain_of_integrators) {
  static LinearModel<double> model;
  static ModesWorkspace<double> work;
  static ModeSet<double> set;
  const Point p = reference_point("mast30_v050");
  static LinearModel<double> full;
  static ResidualisationWorkspace<double> residual;
  linear_model(configuration(30), p.x, p.u, kInceptors, full);
  CHECK(residualise(full, residual, model) == Status::ok);
  set_zero(model.a);
  model.a(0, 1) = 1;
  CHECK(modes(model, work, set) == Status::ok);
  CHECK_EQ(set.count, 8);
  check_names_unique(set);
  for (int i = 0; i < set.count; ++i) {
    const Mode<double>& m = set.mode[i];
    CHECK(m.frequency == 0 && m.damping_ratio == 0 && std::isinf(m.time_to_half));
    CHECK_NEAR(m.shares.body(), 1, 1e-12);
    CHECK(std::isfinite(overlap(set, i, set, i)));
  }
}

// With coning as states each rotor set has two more; they stand apart from flapping by their shares.
TEST(modes_with_coning_states) {
  Options options;
  options.coning_states = true;
  static ModeSet<double> set;
  const Configuration<double> c = configuration(60, options);
  const TrimResult<double> r = trimmed(c, level(60));
  CHECK(is_trimmed(r.status));
  modes_of(c, r.state, r.controls, set);
  check_names_unique(set);
  CHECK(has(set, "coning_sym") && has(set, "coning_anti") && has(set, "downwash"));
  for (int i = 0; i < set.count; ++i) {
    const ModeShares<double>& s = set.mode[i].shares;
    if (set.mode[i].label.kind != ModeKind::coning) continue;
    CHECK_LT(std::max({s.flap, s.inflow_mean, s.inflow_cyclic, s.body()}), s.coning);
    CHECK((s.mean > s.difference) == (set.mode[i].label.symmetry == Symmetry::mean));
  }
}

TEST(modes_names_are_written_with_two_digits) {
  char name[kModeNameLength];
  write_name({ModeKind::flap_progressing, Symmetry::difference, 12}, name);
  CHECK_EQ(std::string(name), "flap_progressing_anti_12");
  write_name({ModeKind::spiral, Symmetry::none, 2}, name);
  CHECK_EQ(std::string(name), "spiral_2");
}

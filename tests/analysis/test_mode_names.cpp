// The rules by which modes get their names, each on a set of made-up roots and shares, and where roots have
// no shares.
// Expected: the rules as their header states them.
#include <algorithm>
#include <string>
#include <vector>

#include "check.hpp"
#include "tiltrotor/analysis/instances.hpp"
#include "tiltrotor/analysis/linear/mode_search.hpp"

using namespace tiltrotor;

namespace {

using Shares = ModeShares<double>;
namespace d = mode_search;

Mode<double> root(double real, double imag, const Shares& shares) {
  Mode<double> m{};
  m.real = real;
  m.imag = imag;
  m.frequency = std::hypot(real, imag);
  m.shares = shares;
  m.label = {ModeKind::count, Symmetry::none, 0};
  return m;
}

ModeSet<double> set_of(const std::vector<Mode<double>>& modes) {
  ModeSet<double> set{};
  for (const Mode<double>& m : modes) set.mode[set.count++] = m;
  return set;
}

d::Selection all(const ModeSet<double>& set) {
  d::Selection s;
  for (int i = 0; i < set.count; ++i) s.add(i);
  return s;
}

std::string kinds(const ModeSet<double>& set) {
  std::string text;
  for (int i = 0; i < set.count; ++i) {
    text += i > 0 ? " " : "";
    text += set.mode[i].label.kind == ModeKind::count ? "unnamed" : kind_word(set.mode[i].label.kind);
    text += set.mode[i].label.symmetry == Symmetry::none   ? ""
            : set.mode[i].label.symmetry == Symmetry::mean ? "+"
                                                           : "-";
  }
  return text;
}

std::string longitudinal(const std::vector<Mode<double>>& modes) {
  ModeSet<double> set = set_of(modes);
  d::name_longitudinal(set, all(set));
  return kinds(set);
}
std::string lateral(const std::vector<Mode<double>>& modes) {
  ModeSet<double> set = set_of(modes);
  d::name_lateral(set, all(set));
  return kinds(set);
}
std::string rotor(const std::vector<Mode<double>>& modes, bool downwash_state) {
  ModeSet<double> set = set_of(modes);
  d::Selection s = all(set);
  d::name_rotor(set, s, downwash_state);
  return kinds(set);
}

Shares share(double Shares::*a, double part, double Shares::*b = nullptr, double rest = 0) {
  Shares s{};
  s.*a = part;
  if (b != nullptr) s.*b = rest;
  return s;
}

// Of a rotor mode: how it divides, half of it or all of it in one symmetry.
Shares rotor_share(double flap, double mean, double cyclic, double coning, bool symmetric) {
  Shares s{};
  s.flap = flap;
  s.inflow_mean = mean;
  s.inflow_cyclic = cyclic;
  s.coning = coning;
  (symmetric ? s.mean : s.difference) = flap + mean + cyclic + coning;
  return s;
}

}  // namespace

TEST(modes_rules_longitudinal) {
  const Shares fast = share(&Shares::w, 0.5, &Shares::q, 0.5);
  const Shares slow = share(&Shares::u, 0.5, &Shares::pitch, 0.5);
  CHECK_EQ(longitudinal({root(-0.1, 0.3, slow), root(-1, 2, fast)}), "phugoid short_period");
  CHECK_EQ(longitudinal({root(-1, 2, fast), root(-0.1, 0.3, slow)}), "short_period phugoid");
  // Whatever their frequencies.
  CHECK_EQ(longitudinal({root(0.1, 0.4, slow), root(-0.35, 0.1, fast)}), "phugoid short_period");
  // One pair of speed and attitude: heave, and pitch where two real roots are left.
  const Mode<double> heave = root(-0.3, 0, share(&Shares::w, 1)), pitch = root(-0.8, 0, share(&Shares::q, 1));
  CHECK_EQ(longitudinal({root(0.1, 0.4, slow), heave, pitch}), "phugoid heave pitch_subsidence");
  CHECK_EQ(longitudinal({root(0.1, 0.4, slow), pitch, heave}), "phugoid pitch_subsidence heave");
  CHECK_EQ(longitudinal({heave}), "heave");
  // One pair of heave and pitch rate: speed and attitude have fallen apart into two real roots.
  const Mode<double> speed = root(-0.05, 0, share(&Shares::u, 1)),
                     other = root(0.1, 0, share(&Shares::pitch, 1));
  CHECK_EQ(longitudinal({root(-1, 2, fast), speed, other}),
           "short_period aperiodic_phugoid aperiodic_phugoid");
  // Each of its two conditions alone makes a phugoid of the pair: more speed than heave ...
  Shares between{};
  between.q = 0.5;
  between.u = 0.3;
  between.w = 0.2;
  CHECK_EQ(longitudinal({root(-1, 2, between), heave, pitch}), "phugoid heave pitch_subsidence");
  // ... and more of speed and attitude than of heave and pitch rate.
  between = {};
  between.w = 0.4;
  between.u = 0.1;
  between.pitch = 0.5;
  CHECK_EQ(longitudinal({root(-1, 2, between), heave, pitch}), "phugoid heave pitch_subsidence");
  // No pair at all: the two that lie closest together stand for one, a phugoid or a short period by what
  // takes part, and keep that name as they come apart.
  CHECK_EQ(longitudinal({heave, speed, other, pitch}),
           "heave aperiodic_phugoid aperiodic_phugoid pitch_subsidence");
  const Mode<double> near_heave = root(-0.31, 0, share(&Shares::q, 1));
  CHECK_EQ(longitudinal({root(-0.9, 0, share(&Shares::u, 1)), near_heave, other, heave}),
           "aperiodic_phugoid pitch_subsidence aperiodic_phugoid heave");
}

TEST(modes_rules_lateral) {
  const Shares yaw = share(&Shares::v, 0.5, &Shares::r, 0.5);
  const Mode<double> roll = root(-2, 0, share(&Shares::p, 0.9, &Shares::roll, 0.1));
  const Mode<double> spiral = root(0.02, 0, share(&Shares::roll, 1));
  const Mode<double> middle = root(-0.5, 0, yaw);
  CHECK_EQ(lateral({root(-0.3, 1.5, yaw), roll, spiral}), "dutch_roll roll spiral");
  CHECK_EQ(lateral({spiral, roll, root(-0.3, 1.5, yaw)}), "spiral roll dutch_roll");
  CHECK_EQ(lateral({root(-0.1, 0.2, yaw), root(-0.3, 1.5, yaw)}), "roll_spiral dutch_roll");
  CHECK_EQ(lateral({root(0.05, 0.36, yaw), root(-0.39, 0.13, yaw)}), "dutch_roll roll_spiral");
  CHECK_EQ(lateral({middle, roll, spiral, root(-1, 0, yaw)}),
           "aperiodic_dutch_roll roll spiral aperiodic_dutch_roll");
  // The spiral need not be the slowest: which two are the Dutch roll is seen by their distance.
  CHECK_EQ(lateral({root(0.20, 0, yaw), roll, root(0.25, 0, yaw), root(-0.1, 0, yaw)}),
           "aperiodic_dutch_roll roll aperiodic_dutch_roll spiral");
  CHECK_EQ(lateral({}), "");
}

TEST(modes_rules_rotor) {
  const Mode<double> progressing = root(-30, 90, rotor_share(1, 0, 0, 0, true));
  const Mode<double> regressing = root(-15, 3, rotor_share(0.8, 0, 0.2, 0, true));
  const Mode<double> mean = root(-9, 0, rotor_share(0, 1, 0, 0, true));
  const Mode<double> cyclic = root(-20, 1, rotor_share(0.3, 0, 0.7, 0, true));
  CHECK_EQ(rotor({progressing, regressing, mean, cyclic}, false),
           "flap_progressing+ flap_regressing+ inflow_mean+ inflow_cyclic+");
  // The same turned round, in the other symmetry.
  std::vector<Mode<double>> other = {cyclic, mean, regressing, progressing};
  for (Mode<double>& m : other) std::swap(m.shares.mean, m.shares.difference);
  CHECK_EQ(rotor(other, false), "inflow_cyclic- inflow_mean- flap_regressing- flap_progressing-");
  // Coning stands out wherever it is the largest share, and only there: as the root with the most mean
  // inflow, and among those left over.
  const Mode<double> coning = root(-25, 60, rotor_share(0.1, 0.2, 0.1, 0.6, true));
  CHECK_EQ(rotor({progressing, coning}, false), "flap_progressing+ coning+");
  CHECK_EQ(rotor({progressing, mean, coning}, false), "flap_progressing+ inflow_mean+ coning+");
  const Mode<double> flaps_more = root(-25, 60, rotor_share(0.5, 0, 0.1, 0.4, true));
  const Mode<double> inflow_more = root(-25, 50, rotor_share(0.1, 0, 0.5, 0.4, true));
  CHECK_EQ(rotor({progressing, mean, flaps_more, inflow_more}, false),
           "flap_progressing+ inflow_mean+ flap_regressing+ inflow_cyclic+");
  // The downwash takes the root it takes part in most, when it is a state; a half without roots stays empty.
  const Mode<double> lag = root(-4, 0, share(&Shares::downwash, 0.7, &Shares::mean, 0.3));
  CHECK_EQ(rotor({progressing, lag, mean}, true), "flap_progressing+ downwash inflow_mean+");
  CHECK_EQ(rotor({lag}, true), "downwash");
  CHECK_EQ(rotor({}, true), "");
}

// Of real roots the two that lie closest together, wherever they are, are one pair.
TEST(modes_rules_of_the_closest_roots) {
  const std::vector<double> places[] = {{-1, -1.1, -9, -20}, {-0.1, -4, -4.2, -30}, {0.5, -8, -19, -19.5}};
  for (int first = 0; first < 3; ++first) {
    std::vector<Mode<double>> modes;
    for (const double place : places[first]) modes.push_back(root(place, 0, Shares{}));
    const ModeSet<double> set = set_of(modes);
    d::Selection from = all(set);
    const d::Selection two = d::take_closest(set, from);
    CHECK(two.count == 2 && two.place[0] == first && two.place[1] == first + 1);
    CHECK_EQ(from.count, 2);
  }
}

// Eight rigid-body roots by share, a pair that no longer fits left out; of the eight, four to each side.
TEST(modes_rules_of_division) {
  std::vector<Mode<double>> modes;
  const auto body = [](double part, bool is_lateral) {
    Shares s{};
    (is_lateral ? s.v : s.u) = part;
    s.mean = 1 - part;
    return s;
  };
  for (int k = 0; k < 7; ++k) modes.push_back(root(-1 - k, 0, body(0.9 - 0.01 * k, k % 2 == 0)));
  modes.push_back(root(-1, 1, body(0.5, false)));  // two roots, one place
  modes.push_back(root(-9, 0, body(0.4, false)));  // one root for it
  modes.push_back(root(-9, 30, body(0.1, false)));
  const ModeSet<double> set = set_of(modes);
  d::Selection rigid, others, longitudinal_half, lateral_half;
  d::divide(set, rigid, others, kRigidStates);
  CHECK_EQ(rigid.count, 8);
  if (!CHECK_EQ(others.count, 2)) return;
  CHECK(others.place[0] == 7 && others.place[1] == 9);
  d::divide_axes(set, rigid, longitudinal_half, lateral_half);
  CHECK(longitudinal_half.count == 4 && lateral_half.count == 4);
  for (int i = 0; i < lateral_half.count; ++i) CHECK(set.mode[lateral_half.place[i]].shares.v > 0);
  for (int i = 0; i < longitudinal_half.count; ++i) CHECK(set.mode[longitudinal_half.place[i]].shares.u > 0);
}

// Modes that would have the same name are numbered, the least stable first, whatever their order.
TEST(modes_rules_of_ordinals) {
  ModeSet<double> set =
      set_of({root(-2, 0, Shares{}), root(0.5, 0, Shares{}), root(-1, 0, Shares{}), root(-3, 0, Shares{})});
  for (int i = 0; i < 4; ++i) set.mode[i].label = {ModeKind::aperiodic_phugoid, Symmetry::none, 9};
  set.mode[3].label.kind = ModeKind::spiral;
  d::number_names(set);
  CHECK_EQ(std::string(set.mode[0].name), "aperiodic_phugoid_3");
  CHECK_EQ(std::string(set.mode[1].name), "aperiodic_phugoid");
  CHECK_EQ(std::string(set.mode[2].name), "aperiodic_phugoid_2");
  CHECK_EQ(std::string(set.mode[3].name), "spiral");
  // Of equal roots the order decides.
  set.mode[0].real = set.mode[2].real;
  d::number_names(set);
  CHECK_EQ(std::string(set.mode[0].name), "aperiodic_phugoid_2");
  CHECK_EQ(std::string(set.mode[2].name), "aperiodic_phugoid_3");
}

// A root whose vectors say nothing, because they are no numbers or nothing, has equal shares of every state
// and continues no other.
TEST(modes_of_roots_without_vectors) {
  static SplitModel<double> model;
  static Eigensystem<double, kMaxLinearStates> system;
  const int states[] = {kStateIndex.velocity.x, kStateIndex.velocity.z, kStateIndex.rates.y,
                        kStateIndex.pitch};
  model.states = 4;
  for (int i = 0; i < 4; ++i) model.coordinate[i] = {states[i], Symmetry::none};
  for (double entry : {std::nan(""), HUGE_VAL, 0.0}) {
    fill(system.right, entry);
    fill(system.left, entry);
    for (double& x : system.condition) x = 1;
    system.values = {};
    const Mode<double> m = d::describe_root(model, system, 0);
    CHECK(m.shares.u == 0.25 && m.shares.w == 0.25 && m.shares.q == 0.25 && m.shares.pitch == 0.25);
  }
  static ModeSet<double> set;
  set.states = 4;
  CHECK_EQ(overlap(set, 0, set, 0), 0.0);
}

// More than half of a mode is needed to continue it: of two that are half of it each, neither has a better
// claim.
TEST(modes_rules_of_continuation) {
  static ModeSet<double> before, after;
  before = after = set_of({root(-1, 0, Shares{}), root(-2, 0, Shares{})});
  for (ModeSet<double>* set : {&before, &after}) {
    set->states = 2;
    for (int i = 0; i < 2; ++i) {
      set->mode[i].eigenvalue = i;
      set->coordinate[i] = {
          i == 0 ? static_cast<int>(kStateIndex.velocity.x) : static_cast<int>(kStateIndex.velocity.z),
          Symmetry::none};
    }
  }
  const auto set_vectors = [](ModeSet<double>& set, double tilt) {
    const double entry[2][2] = {{1, -tilt}, {tilt, 1}};  // in columns, orthogonal
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) set.system.right(i, j) = set.system.left(i, j) = entry[i][j];
  };
  const auto branch_after = [&](double tilt) {
    set_vectors(before, 0);
    set_vectors(after, tilt);
    before.branches = 7;
    before.mode[0].branch = 7;
    before.mode[1].branch = 4;
    CHECK(follow(before, after) == Status::ok);
    CHECK_EQ(after.branches, std::max({7, after.mode[0].branch, after.mode[1].branch}));
    return after.mode[0].branch;
  };
  set_vectors(before, 0);
  set_vectors(after, 1);
  CHECK_EQ(overlap(before, 0, after, 0), 0.5);
  CHECK_EQ(branch_after(0), 7);
  CHECK_EQ(branch_after(0.99), 7);
  CHECK_EQ(branch_after(1), 8);  // a new one
  CHECK_EQ(branch_after(1.01), 4);
}

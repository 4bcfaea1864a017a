// How modes get their names (implementation of modes.hpp).
//
// 1. Rigid-body modes: the roots with the largest share of rigid-body states, eight of them.
// 2. Four of these are longitudinal, four lateral: the division with the largest longitudinal share in the
// one half and
//    the largest lateral share in the other.
// 3. Names inside each half by the pattern of pairs and real roots, and by participation where the pattern is
// open.
// 4. Of the others: the root in which the downwash state takes part most is its lag; the rotors' roots by
// flapping,
//    mean or cyclic inflow, symmetric or antisymmetric.
#pragma once

#include "tiltrotor/analysis/modes.hpp"

namespace tiltrotor {

namespace mode_detail {

template <class R>
constexpr bool is_pair(const Mode<R>& m) {
  return m.imag > R(0);
}
template <class R>
constexpr int roots(const Mode<R>& m) {
  return is_pair(m) ? 2 : 1;
}

template <class R>
Mode<R> describe_root(const SplitModel<R>& split, const Eigensystem<R, kMaxLinearStates>& system, int k) {
  Mode<R> m{};
  m.real = system.values.real[k];
  m.imag = system.values.imag[k];
  m.frequency = length_of(m.real, m.imag);
  m.damping_ratio = m.frequency > R(0) ? -m.real / m.frequency : R(0);
  const R ln2 = static_cast<R>(0.693147180559945309417232121458176568L);
  m.time_to_half = m.real != R(0) ? -ln2 / m.real : std::numeric_limits<R>::infinity();
  m.condition = system.condition[k];
  m.eigenvalue = k;
  R total = R(0);
  for (int i = 0; i < split.states; ++i) total += participation(system, i, k);
  // A defective root has no participation: equal parts then, so that the shares are numbers.
  const bool usable = is_finite(total) && total > R(0);
  for (int i = 0; i < split.states; ++i) {
    const R part = usable ? participation(system, i, k) / total : R(1) / static_cast<R>(split.states);
    add_share(split.coordinate[i], part, m.shares);
  }
  return m;
}

// The places of some of a set's modes.
struct Selection {
  int count = 0;
  int place[kMaxLinearStates];
  void add(int i) { place[count++] = i; }
};

// Places in descending order of `key`.
template <class R, class Key>
void sort_descending(const ModeSet<R>& set, Selection& s, Key&& key) {
  for (int i = 1; i < s.count; ++i) {
    const int moving = s.place[i];
    int j = i;
    for (; j > 0 && key(set.mode[s.place[j - 1]]) < key(set.mode[moving]); --j) s.place[j] = s.place[j - 1];
    s.place[j] = moving;
  }
}

// Moves the mode with the largest key out of the selection; -1 when there is none.
template <class R, class Key>
int take_largest(const ModeSet<R>& set, Selection& s, Key&& key) {
  if (s.count == 0) return -1;
  int best = 0;
  for (int i = 1; i < s.count; ++i)
    if (key(set.mode[s.place[i]]) > key(set.mode[s.place[best]])) best = i;
  const int found = s.place[best];
  for (int i = best + 1; i < s.count; ++i) s.place[i - 1] = s.place[i];
  --s.count;
  return found;
}

template <class R>
void divide(const ModeSet<R>& set, Selection& rigid, Selection& others, int rigid_states) {
  Selection all;
  for (int i = 0; i < set.count; ++i) all.add(i);
  sort_descending(set, all, [](const Mode<R>& m) { return m.shares.body(); });
  int free = rigid_states;
  for (int i = 0; i < all.count; ++i) {
    const int size = roots(set.mode[all.place[i]]);
    if (size <= free) {
      rigid.add(all.place[i]);
      free -= size;
    } else {
      others.add(all.place[i]);
    }
  }
}

// At most eight modes: every subset is tried.
template <class R>
void divide_axes(const ModeSet<R>& set, const Selection& rigid, Selection& longitudinal, Selection& lateral) {
  const int half = kRigidStates / 2;
  unsigned best = 0;
  R best_gain = -std::numeric_limits<R>::infinity();
  for (unsigned subset = 0; subset < (1u << rigid.count); ++subset) {
    int size = 0;
    R gain = R(0);
    for (int i = 0; i < rigid.count; ++i) {
      const Mode<R>& m = set.mode[rigid.place[i]];
      if ((subset >> i & 1u) == 0) continue;
      size += roots(m);
      gain += static_cast<R>(roots(m)) * (m.shares.longitudinal_body() - m.shares.lateral_body());
    }
    if (size == half && gain > best_gain) {
      best = subset;
      best_gain = gain;
    }
  }
  for (int i = 0; i < rigid.count; ++i) ((best >> i & 1u) != 0 ? longitudinal : lateral).add(rigid.place[i]);
}

template <class R>
void name_mode(ModeSet<R>& set, int i, ModeAxis axis, ModeKind kind, Symmetry symmetry = Symmetry::none) {
  if (i < 0) return;
  set.mode[i].axis = axis;
  set.mode[i].label = {kind, symmetry, 1};
}

// Pairs and real roots of a selection.
template <class R>
void by_kind_of_root(const ModeSet<R>& set, const Selection& from, Selection& pairs, Selection& reals) {
  for (int i = 0; i < from.count; ++i) (is_pair(set.mode[from.place[i]]) ? pairs : reals).add(from.place[i]);
}

// Two pairs: short period (fast) and phugoid. One pair: the phugoid, with heave and pitch subsidence, unless
// speed and attitude hardly take part in it; then the short period. Real roots left over are aperiodic
// phugoids.
template <class R>
void name_longitudinal(ModeSet<R>& set, const Selection& modes) {
  const ModeAxis axis = ModeAxis::longitudinal;
  Selection pairs, reals;
  by_kind_of_root(set, modes, pairs, reals);
  const auto fast = [](const Mode<R>& m) { return m.frequency; };
  bool short_period = false;
  if (pairs.count >= 2) {
    name_mode(set, take_largest(set, pairs, fast), axis, ModeKind::short_period);
    short_period = true;
  } else if (pairs.count == 1) {
    const ModeShares<R>& s = set.mode[pairs.place[0]].shares;
    short_period = s.w + s.q > s.u + s.pitch && s.w > s.u;
    name_mode(set, pairs.place[0], axis, short_period ? ModeKind::short_period : ModeKind::phugoid);
    pairs.count = 0;
  }
  while (pairs.count > 0) name_mode(set, take_largest(set, pairs, fast), axis, ModeKind::phugoid);
  if (!short_period) {
    const auto pitching = [](const Mode<R>& m) { return m.shares.q - m.shares.w; };
    const auto heaving = [](const Mode<R>& m) { return m.shares.w; };
    if (reals.count > 1) name_mode(set, take_largest(set, reals, pitching), axis, ModeKind::pitch_subsidence);
    name_mode(set, take_largest(set, reals, heaving), axis, ModeKind::heave);
  }
  while (reals.count > 0) name_mode(set, take_largest(set, reals, fast), axis, ModeKind::phugoid);
}

// One pair: Dutch roll, with roll (the real root with most roll rate) and spiral. Two pairs: the slower is
// the coupled roll and spiral. No pair: the real roots left over are an aperiodic Dutch roll.
template <class R>
void name_lateral(ModeSet<R>& set, const Selection& modes) {
  const ModeAxis axis = ModeAxis::lateral;
  Selection pairs, reals;
  by_kind_of_root(set, modes, pairs, reals);
  const auto fast = [](const Mode<R>& m) { return m.frequency; };
  name_mode(set, take_largest(set, pairs, fast), axis, ModeKind::dutch_roll);
  while (pairs.count > 0) name_mode(set, take_largest(set, pairs, fast), axis, ModeKind::roll_spiral);
  name_mode(set, take_largest(set, reals, [](const Mode<R>& m) { return m.shares.p; }), axis, ModeKind::roll);
  name_mode(set, take_largest(set, reals, [](const Mode<R>& m) { return -m.frequency; }), axis,
            ModeKind::spiral);
  while (reals.count > 0) name_mode(set, take_largest(set, reals, fast), axis, ModeKind::dutch_roll);
}

template <class R>
void name_rotor(ModeSet<R>& set, Selection& modes, bool downwash_state) {
  if (downwash_state) {
    const int lag = take_largest(set, modes, [](const Mode<R>& m) { return m.shares.downwash; });
    name_mode(set, lag, ModeAxis::longitudinal, ModeKind::downwash);
  }
  const ModeAxis axis = ModeAxis::rotor;
  Selection half[2];  // symmetric, antisymmetric
  for (int i = 0; i < modes.count; ++i) {
    const ModeShares<R>& s = set.mode[modes.place[i]].shares;
    half[s.mean >= s.difference ? 0 : 1].add(modes.place[i]);
  }
  for (int k = 0; k < 2; ++k) {
    const Symmetry symmetry = k == 0 ? Symmetry::mean : Symmetry::difference;
    // The progressing flapping mode is the fastest oscillation that flaps.
    const int progressing =
        take_largest(set, half[k], [](const Mode<R>& m) { return m.imag * m.shares.flap; });
    name_mode(set, progressing, axis, ModeKind::flap_progressing, symmetry);
    const int mean = take_largest(set, half[k], [](const Mode<R>& m) { return m.shares.inflow_mean; });
    const bool is_coning = mean >= 0 && set.mode[mean].shares.coning > set.mode[mean].shares.inflow_mean;
    name_mode(set, mean, axis, is_coning ? ModeKind::coning : ModeKind::inflow_mean, symmetry);
    for (int i = 0; i < half[k].count; ++i) {
      const ModeShares<R>& s = set.mode[half[k].place[i]].shares;
      ModeKind kind = s.flap >= s.inflow_cyclic ? ModeKind::flap_regressing : ModeKind::inflow_cyclic;
      if (s.coning > s.flap && s.coning > s.inflow_cyclic) kind = ModeKind::coning;
      name_mode(set, half[k].place[i], axis, kind, symmetry);
    }
  }
}

template <class R>
bool comes_before(const Mode<R>& a, const Mode<R>& b) {
  return a.axis != b.axis ? a.axis < b.axis : a.frequency < b.frequency;
}

template <class R>
void sort_modes(ModeSet<R>& set) {
  for (int i = 1; i < set.count; ++i) {
    const Mode<R> moving = set.mode[i];
    int j = i;
    for (; j > 0 && comes_before(moving, set.mode[j - 1]); --j) set.mode[j] = set.mode[j - 1];
    set.mode[j] = moving;
  }
}

// The first ordinal that no mode marked in `fixed` has.
template <class R>
void make_unique(ModeSet<R>& set, const bool* fixed) {
  bool done[kMaxLinearStates];
  for (int i = 0; i < set.count; ++i) done[i] = fixed != nullptr && fixed[i];
  for (int i = 0; i < set.count; ++i) {
    if (done[i]) continue;
    ModeLabel& label = set.mode[i].label;
    const auto taken = [&set, &done, &label]() {
      bool found = false;
      for (int k = 0; k < set.count; ++k) found = found || (done[k] && set.mode[k].label == label);
      return found;
    };
    label.ordinal = 1;
    // Every other mode can raise it at most once.
    for (int pass = 0; pass < set.count && taken(); ++pass) ++label.ordinal;
    done[i] = true;
  }
  for (int i = 0; i < set.count; ++i) write_name(set.mode[i].label, set.mode[i].name);
}

}  // namespace mode_detail

template <class R>
Status modes(const LinearModel<R>& model, ModesWorkspace<R>& work, ModeSet<R>& set) {
  namespace d = mode_detail;
  set.count = 0;
  set.states = model.states;
  if (model.states < kRigidStates || model.states > kMaxLinearStates) return Status::bad_argument;
  split(model, work.split);
  for (int i = 0; i < model.states; ++i) set.coordinate[i] = work.split.coordinate[i];
  const Status status = eigensystem(work.split.a, model.states, work.eigen, set.system);
  if (status != Status::ok) return status;

  bool downwash_state = false;
  for (int i = 0; i < model.states; ++i) downwash_state = downwash_state || model.state[i] == ix_downwash;
  for (int k = 0; k < model.states; ++k) {
    if (set.system.values.imag[k] >= R(0))
      set.mode[set.count++] = d::describe_root(work.split, set.system, k);
  }
  for (int i = 0; i < set.count; ++i) {
    if (is_finite(set.mode[i].frequency)) continue;
    set.count = 0;
    return Status::not_finite;
  }
  d::Selection rigid, others, longitudinal, lateral;
  d::divide(set, rigid, others, kRigidStates);
  d::divide_axes(set, rigid, longitudinal, lateral);
  d::name_longitudinal(set, longitudinal);
  d::name_lateral(set, lateral);
  d::name_rotor(set, others, downwash_state);
  d::sort_modes(set);
  d::make_unique<R>(set, nullptr);
  return Status::ok;
}

template <class R>
R overlap(const ModeSet<R>& a, int i, const ModeSet<R>& b, int j) {
  // |left^H right| of two modes, which may belong to two sets.
  const auto product = [](const ModeSet<R>& left, int l, const ModeSet<R>& right, int r) {
    ComplexEntry<R> sum{R(0), R(0)};
    for (int k = 0; k < left.states; ++k) {
      const ComplexEntry<R> w = left_entry(left.system, k, left.mode[l].eigenvalue);
      const ComplexEntry<R> v = right_entry(right.system, k, right.mode[r].eigenvalue);
      sum.real += w.real * v.real + w.imag * v.imag;
      sum.imag += w.real * v.imag - w.imag * v.real;
    }
    return std::sqrt(sum.real * sum.real + sum.imag * sum.imag);
  };
  const R own = product(a, i, a, i) * product(b, j, b, j);
  return own > R(0) ? product(a, i, b, j) * product(b, j, a, i) / own : R(0);
}

template <class R>
Status follow(const ModeSet<R>& previous, ModeSet<R>& current) {
  if (previous.states != current.states || previous.count < 1 || current.count < 1)
    return Status::bad_argument;
  for (int i = 0; i < current.states; ++i) {
    if (previous.coordinate[i].state != current.coordinate[i].state) return Status::bad_argument;
  }
  const R threshold = R(0.5);
  bool used[kMaxLinearStates] = {};
  bool fixed[kMaxLinearStates] = {};
  // The surest continuation first.
  for (int round = 0; round < current.count; ++round) {
    R best = threshold;
    int from = -1;
    int to = -1;
    for (int i = 0; i < previous.count; ++i) {
      if (used[i]) continue;
      for (int j = 0; j < current.count; ++j) {
        if (fixed[j] || mode_detail::is_pair(previous.mode[i]) != mode_detail::is_pair(current.mode[j]))
          continue;
        const R likeness = overlap(previous, i, current, j);
        if (likeness > best) {
          best = likeness;
          from = i;
          to = j;
        }
      }
    }
    if (from < 0) break;
    used[from] = true;
    fixed[to] = true;
    current.mode[to].label = previous.mode[from].label;
    current.mode[to].axis = previous.mode[from].axis;
  }
  mode_detail::make_unique<R>(current, fixed);
  mode_detail::sort_modes(current);
  return Status::ok;
}

}  // namespace tiltrotor

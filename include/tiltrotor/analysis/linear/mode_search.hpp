// How modes get their names (implementation of modes.hpp).
//
// 1. Rigid-body modes: the roots with the largest share of rigid-body states, eight of them.
// 2. Four of these are longitudinal, four lateral: the division with the largest longitudinal share in the
//    one half and the largest lateral share in the other.
// 3. Each four are two and two, a fast and a slow half, each a pair or two real roots. Without a pair the two
//    real roots that lie closest together, where a pair has come apart or is about to form, stand for one.
// 4. Of the others: the root in which the downwash state takes part most is its lag; the rotors' roots by
//    flapping, mean or cyclic inflow, symmetric or antisymmetric.
#pragma once

#include "tiltrotor/analysis/linear/modes.hpp"

namespace tiltrotor {

namespace mode_search {

template <class R>
constexpr bool is_pair(const Mode<R>& m) {
  return m.imag > R(0);
}
template <class R>
constexpr int roots(const Mode<R>& m) {
  return is_pair(m) ? 2 : 1;
}

template <class R>
void describe_value(R real, R imag, Mode<R>& m) {
  m.real = real;
  m.imag = imag;
  m.frequency = length_of(m.real, m.imag);
  m.damping_ratio = m.frequency > R(0) ? -m.real / m.frequency : R(0);
  const R ln2 = static_cast<R>(0.693147180559945309417232121458176568L);
  m.time_to_half = m.real != R(0) ? -ln2 / m.real : std::numeric_limits<R>::infinity();
}
template <class R>
Mode<R> describe_root(const SplitModel<R>& split, const Eigensystem<R, kMaxLinearStates>& system, int k) {
  Mode<R> m{};
  describe_value(system.values.real[k], system.values.imag[k], m);
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

// Takes out of real roots the two that lie closest together, with all there are when these are fewer.
template <class R>
Selection take_closest(const ModeSet<R>& set, Selection& from) {
  sort_descending(set, from, [](const Mode<R>& m) { return m.real; });
  const auto gap = [&](int i) { return set.mode[from.place[i]].real - set.mode[from.place[i + 1]].real; };
  int closest = 0;
  for (int i = 1; i + 1 < from.count; ++i)
    if (gap(i) < gap(closest)) closest = i;
  Selection two, rest;
  for (int i = 0; i < from.count; ++i) (i == closest || i == closest + 1 ? two : rest).add(from.place[i]);
  from = rest;
  return two;
}

// Whether heave and pitch rate make up a pair more than speed and attitude do.
template <class R>
bool is_short_period(const ModeSet<R>& set, const Selection& two) {
  R fast = R(0), slow = R(0), heave = R(0), speed = R(0);
  for (int i = 0; i < two.count; ++i) {
    const ModeShares<R>& s = set.mode[two.place[i]].shares;
    fast += s.w + s.q;
    slow += s.u + s.pitch;
    heave += s.w;
    speed += s.u;
  }
  return fast > slow && heave > speed;
}

struct Halves {
  Selection fast, slow;  // each a pair or two real roots
};

// What takes part tells two pairs apart, or what the one pair is. Frequency would not: heave and pitch may
// form a pair slower than the phugoid.
template <class R>
Halves longitudinal_halves(const ModeSet<R>& set, const Selection& modes) {
  Selection pairs, reals;
  by_kind_of_root(set, modes, pairs, reals);
  if (pairs.count > 1) {
    Selection fast;
    fast.add(take_largest(
        set, pairs, [](const Mode<R>& m) { return m.shares.w + m.shares.q - m.shares.u - m.shares.pitch; }));
    return {fast, pairs};
  }
  const Selection two = pairs.count == 1 ? pairs : take_closest(set, reals);
  return is_short_period(set, two) ? Halves{two, reals} : Halves{reals, two};
}

template <class R>
bool oscillates(const ModeSet<R>& set, const Selection& half) {
  return half.count > 0 && is_pair(set.mode[half.place[0]]);
}

template <class R>
void name_all(ModeSet<R>& set, const Selection& half, ModeAxis axis, ModeKind kind) {
  for (int i = 0; i < half.count; ++i) name_mode(set, half.place[i], axis, kind);
}

// The fast half is the short period, or heave and pitch subsidence; the slow one the phugoid.
template <class R>
void name_longitudinal(ModeSet<R>& set, const Selection& modes) {
  const ModeAxis axis = ModeAxis::longitudinal;
  Halves half = longitudinal_halves(set, modes);
  name_all(set, half.slow, axis,
           oscillates(set, half.slow) ? ModeKind::phugoid : ModeKind::aperiodic_phugoid);
  if (oscillates(set, half.fast)) return name_all(set, half.fast, axis, ModeKind::short_period);
  if (half.fast.count > 1) {
    const auto pitching = [](const Mode<R>& m) { return m.shares.q - m.shares.w; };
    name_mode(set, take_largest(set, half.fast, pitching), axis, ModeKind::pitch_subsidence);
  }
  name_all(set, half.fast, axis, ModeKind::heave);
}

// One half is the Dutch roll: the only pair, or of two the one that oscillates faster, since roll and spiral
// begin as a pair with a long period. The other half is roll (the root with more roll rate) and spiral, or
// both coupled.
template <class R>
void name_lateral(ModeSet<R>& set, const Selection& modes) {
  const ModeAxis axis = ModeAxis::lateral;
  Selection pairs, reals;
  by_kind_of_root(set, modes, pairs, reals);
  if (pairs.count > 0) {
    const auto oscillation = [](const Mode<R>& m) { return m.imag; };
    name_mode(set, take_largest(set, pairs, oscillation), axis, ModeKind::dutch_roll);
  } else {
    name_all(set, take_closest(set, reals), axis, ModeKind::aperiodic_dutch_roll);
  }
  name_all(set, pairs, axis, ModeKind::roll_spiral);
  const auto rolling = [](const Mode<R>& m) { return m.shares.p; };
  name_mode(set, take_largest(set, reals, rolling), axis, ModeKind::roll);
  name_all(set, reals, axis, ModeKind::spiral);
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

// Modes of the same kind and symmetry are numbered, the least stable first, and every name is written.
template <class R>
void number_names(ModeSet<R>& set) {
  for (int i = 0; i < set.count; ++i) {
    ModeLabel& label = set.mode[i].label;
    label.ordinal = 1;
    for (int k = 0; k < set.count; ++k) {
      const Mode<R>& other = set.mode[k];
      const bool same = other.label.kind == label.kind && other.label.symmetry == label.symmetry;
      const bool before = other.real > set.mode[i].real || (other.real == set.mode[i].real && k < i);
      if (same && before) ++label.ordinal;
    }
    write_name(label, set.mode[i].name);
  }
}

// Names and order of the modes in a set, by their shares.
template <class R>
void name_set(ModeSet<R>& set, bool downwash_state) {
  Selection rigid, others, longitudinal, lateral;
  divide(set, rigid, others, kRigidStates);
  divide_axes(set, rigid, longitudinal, lateral);
  name_longitudinal(set, longitudinal);
  name_lateral(set, lateral);
  name_rotor(set, others, downwash_state);
  sort_modes(set);
  number_names(set);
}

}  // namespace mode_search

template <class R>
Status modes(const LinearModel<R>& model, ModesWorkspace<R>& work, ModeSet<R>& set) {
  namespace d = mode_search;
  set.count = set.branches = 0;
  set.states = model.states;
  if (model.states < kRigidStates || model.states > kMaxLinearStates) return Status::bad_argument;
  split(model, work.split);
  for (int i = 0; i < model.states; ++i) set.coordinate[i] = work.split.coordinate[i];
  const Status status = eigensystem(work.split.a, model.states, work.eigen, set.system);
  if (status != Status::ok) return status;

  bool downwash_state = false;
  for (int i = 0; i < model.states; ++i)
    downwash_state = downwash_state || model.state[i] == kStateIndex.downwash;
  for (int k = 0; k < model.states; ++k) {
    if (set.system.values.imag[k] >= R(0))
      set.mode[set.count++] = d::describe_root(work.split, set.system, k);
  }
  for (int i = 0; i < set.count; ++i) {
    if (is_finite(set.mode[i].frequency)) continue;
    set.count = 0;
    return Status::not_finite;
  }
  d::name_set(set, downwash_state);
  set.branches = set.count;
  for (int i = 0; i < set.count; ++i) set.mode[i].branch = i + 1;
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
        if (fixed[j] || mode_search::is_pair(previous.mode[i]) != mode_search::is_pair(current.mode[j]))
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
    current.mode[to].branch = previous.mode[from].branch;
  }
  current.branches = previous.branches;
  for (int j = 0; j < current.count; ++j)
    if (!fixed[j]) current.mode[j].branch = ++current.branches;
  return Status::ok;
}

}  // namespace tiltrotor

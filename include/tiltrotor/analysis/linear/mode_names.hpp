// Names of modes: what a root of the linear model is called, decided by the matrix alone (mode_search.hpp).
//
// A pair that has fallen apart into two real roots keeps no name of an oscillation: the short period becomes
// heave and pitch_subsidence, the coupled roll_spiral roll and spiral, the phugoid aperiodic_phugoid (twice),
// the Dutch roll aperiodic_dutch_roll (twice).
#pragma once

#include "tiltrotor/analysis/linear/reduction.hpp"

namespace tiltrotor {

enum class ModeAxis : unsigned char { longitudinal, lateral, rotor };

enum class ModeKind : unsigned char {
  phugoid,
  aperiodic_phugoid,
  short_period,
  heave,
  pitch_subsidence,  // longitudinal
  dutch_roll,
  aperiodic_dutch_roll,
  roll,
  spiral,
  roll_spiral,  // lateral
  downwash,     // lag of the wing's downwash at the tail
  flap_progressing,
  flap_regressing,
  inflow_mean,
  inflow_cyclic,
  coning,  // rotors, symmetric or antisymmetric
  count
};

namespace mode_names_detail {
inline constexpr const char* kAxisWords[] = {"longitudinal", "lateral", "rotor"};
inline constexpr const char* kKindWords[] = {"phugoid",
                                             "aperiodic_phugoid",
                                             "short_period",
                                             "heave",
                                             "pitch_subsidence",
                                             "dutch_roll",
                                             "aperiodic_dutch_roll",
                                             "roll",
                                             "spiral",
                                             "roll_spiral",
                                             "downwash",
                                             "flap_progressing",
                                             "flap_regressing",
                                             "inflow_mean",
                                             "inflow_cyclic",
                                             "coning"};
static_assert(sizeof(kKindWords) / sizeof(kKindWords[0]) == static_cast<unsigned>(ModeKind::count),
              "one word per kind");
}  // namespace mode_names_detail

constexpr const char* axis_word(ModeAxis axis) {
  return mode_names_detail::kAxisWords[static_cast<unsigned>(axis)];
}
constexpr const char* kind_word(ModeKind kind) {
  return mode_names_detail::kKindWords[static_cast<unsigned>(kind)];
}

// What the name of a mode is made of. Two modes of one set never have the same.
struct ModeLabel {
  ModeKind kind;
  Symmetry symmetry;  // of rotor modes: mean (both rotors alike) or difference
  int ordinal;        // 1, 2, ... among modes of the same kind and symmetry, the least stable first
};
constexpr bool operator==(const ModeLabel& a, const ModeLabel& b) {
  return a.kind == b.kind && a.symmetry == b.symmetry && a.ordinal == b.ordinal;
}

inline constexpr int kModeNameLength = 32;

// "flap_regressing_sym_2": kind, _sym or _anti for rotor modes, the ordinal when above 1.
inline void write_name(const ModeLabel& label, char (&name)[kModeNameLength]) {
  int length = 0;
  const auto append = [&](const char* text) {
    for (; *text != '\0' && length < kModeNameLength - 1; ++text) name[length++] = *text;
  };
  append(kind_word(label.kind));
  if (label.symmetry != Symmetry::none) append(label.symmetry == Symmetry::mean ? "_sym" : "_anti");
  if (label.ordinal > 1) {
    const char tens = static_cast<char>('0' + label.ordinal / 10 % 10);
    const char digits[] = {'_', tens, static_cast<char>('0' + label.ordinal % 10), '\0'};
    const char digit[] = {'_', digits[2], '\0'};
    append(label.ordinal >= 10 ? digits : digit);
  }
  name[length] = '\0';
}

// How much each group of states takes part in a mode; all groups together sum to 1.
template <class R>
struct ModeShares {
  R u, w, q, pitch;
  R v, p, roll, r;
  R downwash;
  R flap, inflow_mean, inflow_cyclic, coning;
  R mean, difference;  // the rotors' part again, by symmetry

  R longitudinal_body() const { return u + w + q + pitch; }
  R lateral_body() const { return v + p + roll + r; }
  R body() const { return longitudinal_body() + lateral_body(); }
};

// The share a rigid-body state counts for.
template <class R>
R& rigid_share(int state, ModeShares<R>& shares) {
  const State<int>& at = kStateIndex;
  return state == at.velocity.x   ? shares.u
         : state == at.velocity.z ? shares.w
         : state == at.rates.y    ? shares.q
         : state == at.pitch      ? shares.pitch
         : state == at.velocity.y ? shares.v
         : state == at.rates.x    ? shares.p
         : state == at.roll       ? shares.roll
                                  : shares.r;
}

enum class ShareGroup : unsigned char { none, body, downwash, flap, inflow_mean, inflow_cyclic, coning };

constexpr ShareGroup share_group(VariableKind kind) {
  switch (kind) {
    case VariableKind::speed:
    case VariableKind::body_rate:
    case VariableKind::bank:
    case VariableKind::pitch:
      return ShareGroup::body;
    case VariableKind::downwash:
      return ShareGroup::downwash;
    case VariableKind::gimbal_tilt:
    case VariableKind::gimbal_rate:
      return ShareGroup::flap;
    case VariableKind::mean_inflow:
      return ShareGroup::inflow_mean;
    case VariableKind::cyclic_inflow:
      return ShareGroup::inflow_cyclic;
    case VariableKind::coning:
    case VariableKind::coning_rate:
      return ShareGroup::coning;
    default:
      return ShareGroup::none;
  }
}

// Every state of a linear model has a group, and those of the body are the eight of rigid_share().
constexpr bool every_state_has_its_share() {
  int body = 0;
  for (const Variable& state : kStateVariables.row) {
    const ShareGroup group = share_group(state.kind);
    if (group == ShareGroup::none && !state.facts().ignorable) return false;
    body += group == ShareGroup::body;
  }
  return body == 8;
}
static_assert(every_state_has_its_share(), "a new state counts for a share of the modes");

template <class R>
void add_share(const SplitCoordinate& coordinate, R part, ModeShares<R>& shares) {
  if (coordinate.symmetry != Symmetry::none)
    (coordinate.symmetry == Symmetry::mean ? shares.mean : shares.difference) += part;
  switch (share_group(kStateVariables[coordinate.state].kind)) {
    case ShareGroup::downwash:
      shares.downwash += part;
      return;
    case ShareGroup::flap:
      shares.flap += part;
      return;
    case ShareGroup::inflow_mean:
      shares.inflow_mean += part;
      return;
    case ShareGroup::inflow_cyclic:
      shares.inflow_cyclic += part;
      return;
    case ShareGroup::coning:
      shares.coning += part;
      return;
    case ShareGroup::body:
    case ShareGroup::none:
      rigid_share(coordinate.state, shares) += part;
  }
}

}  // namespace tiltrotor

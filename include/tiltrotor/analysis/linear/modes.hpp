// Modes of a linear model: eigenvalues, eigenvectors, damping, and a name for each.
//
// Works on the full and on the residualised model, at trimmed and at any other states. A mode is a real
// eigenvalue or a conjugate pair. Its name is a function of the matrix alone: the same whatever was looked at
// before. Which mode of one matrix continues which of another is a number of its own, the branch.
#pragma once

#include "tiltrotor/analysis/linear/mode_names.hpp"
#include "tiltrotor/math/algebra/eigen.hpp"

namespace tiltrotor {

template <class R>
struct Mode {
  R real, imag;     // eigenvalue, 1/s; imag >= 0, a pair is one mode
  R frequency;      // |eigenvalue|, rad/s
  R damping_ratio;  // -real / frequency; 1 or -1 for real roots, 0 for a root at zero
  R time_to_half;   // s; negative: time to double; infinite for real = 0 and beyond the range of numbers
  ModeAxis axis;
  ModeLabel label;
  char name[kModeNameLength];
  ModeShares<R> shares;
  R condition;     // of the eigenvalue, math/algebra/eigen.hpp
  int eigenvalue;  // its place in ModeSet::system
  int branch;      // the same number along a sweep that follow() has gone through; alone 1, 2, ... in order
};

// Ordered: longitudinal, lateral, rotor; slow modes first. Coordinates as in SplitModel.
template <class R>
struct ModeSet {
  int count;
  int branches;  // the highest number of a branch so far
  Mode<R> mode[kMaxLinearStates];
  int states;
  SplitCoordinate coordinate[kMaxLinearStates];
  Eigensystem<R, kMaxLinearStates> system;
};

template <class R>
struct ModesWorkspace {
  SplitModel<R> split;
  EigenWorkspace<R, kMaxLinearStates> eigen;
};

// Status: ok; not_finite (also a frequency beyond the range) or not_converged (the set is empty);
// bad_argument (empty model). Cost: eigensystem of order n, about 25 n^3 multiplications.
template <class R>
Status modes(const LinearModel<R>& model, ModesWorkspace<R>& work, ModeSet<R>& set);

// Gives the modes of `current` the branches of those modes of `previous` that they continue: same kind of
// root (real or pair) and eigenvectors that overlap by more than half, the surest first. The others begin
// branches with numbers not used before. Names and order stay. Both sets must belong to models with the same
// states; otherwise bad_argument and nothing changes.
template <class R>
Status follow(const ModeSet<R>& previous, ModeSet<R>& current);

// How far mode j of `b` continues mode i of `a`: 1 for the same mode, 0 for one that has nothing in common
// with it. Does not depend on the units of the states: |w_a^H v_b| |w_b^H v_a| / (|w_a^H v_a| |w_b^H v_b|).
template <class R>
R overlap(const ModeSet<R>& a, int i, const ModeSet<R>& b, int j);

}  // namespace tiltrotor

#include "tiltrotor/analysis/linear/mode_search.hpp"

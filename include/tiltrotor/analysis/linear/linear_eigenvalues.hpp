// Eigenvalues of a linear model, for half the work where the flight is symmetric.
//
// Without sideslip, bank and turn the aircraft is its own mirror image and A falls apart into a longitudinal
// and a lateral block (reduction.hpp) of half the size. What rounding leaves between them is dropped when it
// is below a few units of rounding of the largest entry: an eigenvalue moves by no more than that, and by its
// square unless the blocks share an eigenvalue. Any other A is solved whole.
#pragma once

#include "tiltrotor/analysis/linear/reduction.hpp"
#include "tiltrotor/math/algebra/eigen.hpp"

namespace tiltrotor {

template <class R>
struct LinearEigenvaluesWorkspace {
  EigenvalueWorkspace<R, kMaxLinearStates> eigen;
  SplitModel<R> split;
  Matrix<R, kMaxLinearStates, kMaxLinearStates> lateral;
  Eigenvalues<R, kMaxLinearStates> lateral_values;
};

// Whether the blocks of a split model are decoupled to rounding.
template <class R>
bool decoupled(const SplitModel<R>& split) {
  return split.coupling <= R(8) * std::numeric_limits<R>::epsilon() * split.largest;
}

// Eigenvalues of A: in symmetric flight those of the longitudinal block first. Full or residualised models.
// Status: as eigenvalues() of a matrix (eigen.hpp). Cost: about 8 n^3 multiplications, in symmetric flight
// 2 n^3.
template <class R>
Status eigenvalues(const LinearModel<R>& model, LinearEigenvaluesWorkspace<R>& work,
                   Eigenvalues<R, kMaxLinearStates>& values) {
  SplitModel<R>& split_model = work.split;
  bool symmetric = false;
  if (model.states > 1 && all_finite(model.a, model.states, model.states)) {
    split(model, split_model);
    symmetric = decoupled(split_model) && split_model.states == model.states;
  }
  if (!symmetric) return eigenvalues(model.a, model.states, work.eigen, values);

  const int n = split_model.longitudinal;
  const int rest = split_model.states - n;
  for (int i = 0; i < rest; ++i)
    for (int j = 0; j < rest; ++j) work.lateral(i, j) = split_model.a(n + i, n + j);
  const Status first = eigenvalues(split_model.a, n, work.eigen, values);
  const Status second = eigenvalues(work.lateral, rest, work.eigen, work.lateral_values);
  for (int i = 0; i < rest; ++i) {
    values.real[n + i] = work.lateral_values.real[i];
    values.imag[n + i] = work.lateral_values.imag[i];
  }
  values.size = split_model.states;
  values.converged += work.lateral_values.converged;
  values.sweeps += work.lateral_values.sweeps;
  return first != Status::ok ? first : second;
}

}  // namespace tiltrotor

// Differentiation policies: one interface, two ways to a Jacobian.
//
// AutoDiff runs the function on dual numbers: exact to rounding, no step, a pass of N directions at a time.
// NumDiff runs it on plain numbers: central differences. Both give the value f(x) as well, by the same
// operations, bit for bit. kJacobianIsCheap: whether a Jacobian costs a few values, or two an input.
//
// The function is a generic callable `f(input, output)`. It takes number j of its inputs as input[j], or as input.put(j,
// to), which builds it where it is wanted, on T = Policy::Scalar<R, N> or R, `input`'s T; and it hands over number i of
// what it finds as output(i, y), each once.
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

#include "tiltrotor/math/differentiation/dual.hpp"
#include "tiltrotor/math/differentiation/preaccumulate.hpp"
#include "tiltrotor/model/derivative.hpp"

namespace tiltrotor {

// What is differentiated where: y[outputs] = f(x[inputs]) is written, `scale` says over which distance f bends in
// each input; numerical differences need it. x is read anew in every pass: y lies elsewhere.
template <class R>
struct JacobianRequest {
  int inputs, outputs;
  const R* x;
  const R* scale;
  R* y;
};

// Inputs as plain numbers,
template <class R>
struct PlainInputs {
  using T = R;
  const R* x;
  T operator[](int j) const { return x[j]; }
  void put(int j, T& to) const { to = x[j]; }
};
// outputs to y,
template <class R>
struct PlainOutputs {
  R* y;
  void operator()(int i, R found) const { y[i] = found; }
};
// and inputs as dual numbers: N of them, from `first` on, are the variables of the pass.
template <class R, int N>
struct SeededInputs {
  using T = Dual<R, N>;
  const R* x;
  int first;
  void put(int j, T& to) const {
    to = x[j];
    if (j >= first && j < first + N) to.d.set(j - first, R(1));
  }
  T operator[](int j) const {
    T to;
    put(j, to);
    return to;
  }
};

struct AutoDiff {
  static constexpr const char* kName = "automatic";
  static constexpr bool kJacobianIsCheap = true;  // it costs a few values

  template <class R, int N>
  using Scalar = Dual<R, N>;

  // N: directions of one pass.
  template <class R, int N, int MaxInputs, int MaxOutputs>
  struct Workspace {};

  // y = f(x) and put(i, j, count, slopes): dy_i/dx_j and the next ones of its row, until every entry was put. `slopes`
  // hold during that call alone; it changes nothing that f reads.
  // Cost: ceil(n / N) evaluations of f on N partials.
  template <class R, int N, int MaxInputs, int MaxOutputs, class Function, class Put>
  static void jacobian(Function&& f, const JacobianRequest<R>& at, Workspace<R, N, MaxInputs, MaxOutputs>&,
                       Put&& put) {
    for (int first = 0; first < at.inputs; first += N) {
      const int count = first + N < at.inputs ? N : at.inputs - first;
      f(SeededInputs<R, N>{at.x, first}, [&](int i, const Dual<R, N>& y) {
        at.y[i] = y.v;
        put(i, first, count, y.d.row());
      });
    }
  }
};

struct NumDiff {
  static constexpr const char* kName = "numerical";
  static constexpr bool kJacobianIsCheap = false;  // it costs two values an input

  template <class R, int N>
  using Scalar = R;

  template <class R, int N, int MaxInputs, int MaxOutputs>
  struct Workspace {
    R x[MaxInputs];
    R below[MaxOutputs];
    R above[MaxOutputs];
  };

  // Central differences. Step of input j: cbrt(eps) scale[j], which balances the truncation error (h^2)
  // against rounding (eps / h) for a function that bends over a distance scale[j]; it is then rounded so that
  // x + h and x - h are machine numbers and their distance is exact. Cost: 2 n + 1 evaluations of f.
  template <class R, int N, int MaxInputs, int MaxOutputs, class Function, class Put>
  static void jacobian(Function&& f, const JacobianRequest<R>& at,
                       Workspace<R, N, MaxInputs, MaxOutputs>& work, Put&& put) {
    const int n = at.inputs, m = at.outputs;
    const R* const x = at.x;
    const R step = std::cbrt(std::numeric_limits<R>::epsilon());
    f(PlainInputs<R>{x}, PlainOutputs<R>{at.y});
    for (int j = 0; j < n; ++j) work.x[j] = x[j];
    for (int j = 0; j < n; ++j) {
      const R above = x[j] + step * at.scale[j];
      const R below = x[j] - step * at.scale[j];
      work.x[j] = above;
      f(PlainInputs<R>{work.x}, PlainOutputs<R>{work.above});
      work.x[j] = below;
      f(PlainInputs<R>{work.x}, PlainOutputs<R>{work.below});
      work.x[j] = x[j];
      const R inverse = R(1) / (above - below);
      for (int i = 0; i < m; ++i) {
        const R slope = (work.above[i] - work.below[i]) * inverse;
        put(i, j, 1, &slope);
      }
    }
  }
};

// For a simulation by explicit methods alone, without code and memory for a Jacobian: rodas3 is then a bad argument.
struct NoDifferentiation : NumDiff {
  template <class R, int N, int MaxInputs, int MaxOutputs>
  struct Workspace {};
};

// The caller has the Jacobian of the states that are alive, and what inputs that ramp add to the rates in a second: for
// the exponential step.
struct KnownJacobian : NumDiff {
  template <class R, int N, int MaxInputs, int MaxOutputs>
  struct Workspace {
    R ramp[MaxOutputs];
  };
};

// Which policy the analyses use unless told otherwise: 1 makes the comparison build with numerical
// differences.
#ifndef TILTROTOR_NUMERICAL_DIFFERENCES
#define TILTROTOR_NUMERICAL_DIFFERENCES 0
#endif
#if TILTROTOR_NUMERICAL_DIFFERENCES
using DefaultDifferentiation = NumDiff;
#else
using DefaultDifferentiation = AutoDiff;
#endif

// Directions of one pass through the complete model: 32 take all states and the usual controls at once. Fewer
// (8 or 16) need less stack and more passes, with the same result: for small targets.
#ifndef TILTROTOR_MODEL_DIRECTIONS
#define TILTROTOR_MODEL_DIRECTIONS 32
#endif
inline constexpr int kModelDirections = TILTROTOR_MODEL_DIRECTIONS;
static_assert(kModelDirections >= 1, "at least one direction in a pass");

// Distance over which the model bends in a state or control: the length of a numerical step is this times
// cbrt(eps), 6e-6 in double.
template <class R>
constexpr R state_scale(int index) {
  return static_cast<R>(kStateVariables[index].facts().bend);
}
template <class R>
constexpr R control_scale(int index) {
  return static_cast<R>(kControlVariables[index].facts().bend);
}

// One evaluation of the model on scalar T: state and controls, what leads from them to the rates, and the rates. Controls
// are read before the rates are written: they lie in one place where the scalar allows it.
template <class T, bool = std::is_trivially_default_constructible_v<T>&& std::is_trivially_destructible_v<T>>
struct ModelWorkspace {
  DerivativeSteps<T> derivative;
  union {
    Controls<T> controls;
    State<T> rates;
  };
  State<T> state;
};
template <class T>
struct ModelWorkspace<T, false> {
  DerivativeSteps<T> derivative;
  Controls<T> controls;
  State<T> rates;
  State<T> state;
};

// Where the numbers of an evaluation stand, in the order of files and arrays. These lists need no place on the stack while
// the model runs: functions of their own use them.
template <class T>
struct ModelPlaces {
  T* x[state_count];
  T* u[control_count];
  explicit ModelPlaces(ModelWorkspace<T>& at) {
    list_places(at.state, x);
    list_places(at.controls, u);
  }
};
// output(i, rate) of the state i, for each.
template <class T, class Output>
TILTROTOR_NOINLINE void put_rates(const State<T>& rates, Output&& output) {
  const T* rate[state_count];
  list_places(rates, rate);
  for (int i = 0; i < state_count; ++i) output(i, *rate[i]);
}

// Which directions are the rotors' own states, where one pass takes all inputs on kModelDirections partials, input j being
// variable number j. `state_of(j)`: the state that it is, -1 for none.
class OwnStates {
 public:
  template <class StateOf>
  OwnStates(int inputs, StateOf&& state_of) : known_(inputs <= kModelDirections) {
    int direction[state_count];
    for (int& d : direction) d = -1;
    for (int j = 0; j < inputs; ++j)
      if (state_of(j) >= 0) direction[state_of(j)] = j;
    own_ = rotor_directions(direction);
  }
  const RotorDirections* get() const { return known_ ? &own_ : nullptr; }

 private:
  bool known_;
  RotorDirections own_;
};

// State and controls -> rates, all in `work`; the controls are lost. `own`: which directions are the rotors' own states, if
// that is known.
template <class T>
void model_rates(const Configuration<Real<T>>& c, Real<T> azimuth, ModelWorkspace<T>& work,
                 const RotorDirections* own = nullptr) {
  derivative(c, work.state, work.controls, work.derivative, work.rates, azimuth, own);
}

// For plain numbers and for the scalar S of a policy, which may be the same.
template <class R, class S>
struct ModelWorkspaces {
  ModelWorkspace<R> plain;
  ModelWorkspace<S> seeded;
  template <class T>
  ModelWorkspace<T>& of() {
    if constexpr (ScalarTraits<T>::kTakesSlopes) {
      return seeded;
    } else {
      return plain;
    }
  }
};
template <class R>
struct ModelWorkspaces<R, R> {
  ModelWorkspace<R> plain;
  template <class T>
  ModelWorkspace<T>& of() {
    return plain;
  }
};

}  // namespace tiltrotor

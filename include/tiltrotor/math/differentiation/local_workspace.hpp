// Memory of functions that are evaluated on scalars of their own few directions (preaccumulate.hpp).
#pragma once

#include "tiltrotor/math/differentiation/preaccumulate.hpp"

namespace tiltrotor {

// Of one function from In to Out: the chain to the directions outside, and what the function itself needs inside.
template <template <class> class In, template <class> class Out, template <class> class Inner, class T>
struct LocalWorkspace {
  PreaccumulationWorkspace<In, Out, T> chain;
  Inner<LocalDual<In, T>> inner;
};

// Of two functions that take turns: they share one place where the scalar T allows it.
template <class First, class Second, class T, bool = std::is_trivially_default_constructible_v<T>>
struct TakingTurns {
  union {
    First first;
    Second second;
  };
};
template <class First, class Second, class T>
struct TakingTurns<First, Second, T, false> {
  First first;
  Second second;
};

}  // namespace tiltrotor

// Local preaccumulation of derivatives.
//
// A rotor sees 18 numbers, a blade 6, the airframe 14, whatever the number of states behind them. With dual
// numbers such a function is evaluated with one seed for each of its own inputs and the result is chained to
// the outer directions: the same derivative by the chain rule, with far fewer partials carried. For plain and
// complex scalars, and when nothing would be gained, the function is simply called.
//
// Inputs and outputs are structs templated on the scalar that list their members with `each`.
#pragma once

#include <type_traits>

#include "tiltrotor/math/differentiation/dual.hpp"

namespace tiltrotor {

// Copy the listed scalars to an array, and back.
template <class S, class T>
void flatten(const S& s, T* array) {
  S::each(s, [&array](const auto& x) { *array++ = x; });
}
template <class S, class T>
void unflatten(const T* array, S& s) {
  S::each(s, [&array](auto& x) { x = *array++; });
}

// Where the listed scalars stand.
template <class S, class T>
void list_places(S& s, T** place) {
  S::each(s, [&place](auto& x) { *place++ = &x; });
}
// Numbers that stand apart, as if in a row.
template <class T, int N>
struct Listed {
  const T* at[N];
  const T& operator[](int i) const { return *at[i]; }
};

template <class T>
struct OuterPartials {
  static constexpr int count = 0;
};
template <class R, int M>
struct OuterPartials<Dual<R, M>> {
  static constexpr int count = M;
};

// Groups of lanes that are summed at a time: few enough for registers, enough to hide the delay of additions.
inline constexpr int kGroupsAtOnce = 4;

template <int kGroups, class Count, class R, int M, class Inputs>
TILTROTOR_INLINE void add_chained_groups(Partials<R, M>& d, int first, Count count, const R* slope,
                                         Inputs input) {
  typename Partials<R, M>::Lane sum[kGroups];
  for (int g = 0; g < kGroups; ++g) sum[g] = d.group[first + g];
  for (int j = 0; j < count; ++j)
    for (int g = 0; g < kGroups; ++g) sum[g] = sum[g] + slope[j] * input[j].d.group[first + g];
  for (int g = 0; g < kGroups; ++g) d.group[first + g] = sum[g];
}
// d[outer] += sum over `count` inputs, an int or an integral_constant, of slope[j] = (d out / d input j) times
// (d input j / d outer). `input`: in a row, or Listed.
template <class Count, class R, int M, class Inputs>
TILTROTOR_INLINE void add_chained(Partials<R, M>& d, Count count, const R* slope, Inputs input) {
  constexpr int kGroups = Partials<R, M>::kGroups;
  constexpr int kRest = kGroups % kGroupsAtOnce;
  for (int first = 0; first < kGroups - kRest; first += kGroupsAtOnce)
    add_chained_groups<kGroupsAtOnce>(d, first, count, slope, input);
  if constexpr (kRest > 0) add_chained_groups<kRest>(d, kGroups - kRest, count, slope, input);
}
// out.d[outer] = that sum
template <class R, int N, int M>
Dual<R, M> chain(R local, const R (&slope)[N], const Dual<R, M>* input) {
  Dual<R, M> r(local, scaled(slope[0], input[0].d));
  if constexpr (N > 1) add_chained(r.d, std::integral_constant<int, N - 1>{}, slope + 1, input + 1);
  return r;
}
template <class R, int N, int M>
Dual<R, M> chain(const Dual<R, N>& local, const Dual<R, M>* input) {
  R slope[N];
  local.d.copy_to(slope);
  return chain(local.v, slope, input);
}

// Inputs that are outer variables themselves, from number `First` on: the direction of each, or -1 for a constant. Their
// share of a chain is one number each.
template <int First, int Count>
struct OwnDirections {
  int of[Count];
};
// `own`: nullptr where they are not.
template <int First, int Count, class R, int N, int M>
Dual<R, M> chain(R local, const R (&slope)[N], const Dual<R, M>* input,
                 const OwnDirections<First, Count>* own) {
  constexpr int kEnd = First + Count;
  static_assert(First > 0 && kEnd <= N);
  Dual<R, M> r(local, scaled(slope[0], input[0].d));
  add_chained(r.d, std::integral_constant<int, First - 1>{}, slope + 1, input + 1);
  add_chained(r.d, std::integral_constant<int, N - kEnd>{}, slope + kEnd, input + kEnd);
  if (own == nullptr) {
    add_chained(r.d, std::integral_constant<int, Count>{}, slope + First, input + First);
  } else {
    for (int j = 0; j < Count; ++j) {
      const int direction = own->of[j];
      if (direction >= 0) r.d.set(direction, r.d.get(direction) + slope[First + j]);
    }
  }
  return r;
}
template <int First, int Count, class R, int N, int M>
Dual<R, M> chain(const Dual<R, N>& local, const Dual<R, M>* input, const OwnDirections<First, Count>* own) {
  R slope[N];
  local.d.copy_to(slope);
  return chain(local.v, slope, input, own);
}

// Struct of local duals -> the same struct of outer duals. `own`: OwnDirections, if any.
template <class T, template <class> class Out, class R, int N, class... Own>
void chain_all(const Out<Dual<R, N>>& local, const T (&input)[N], Out<T>& out, const Own*... own) {
  const Dual<R, N>* flat[Out<T>::kCount];
  int i = 0;
  Out<T>::each(local, [&](const auto& x) { flat[i++] = &x; });
  i = 0;
  Out<T>::each(out, [&](auto& x) { x = chain(*flat[i++], input, own...); });
}

// Partials in groups of eight, not in the lanes of this machine: every machine then takes the same way and
// finds the same bits.
constexpr int groups_of_eight(int partials) { return (partials + 7) / 8; }

// Scalar of the function: a dual number of as many partials as it has inputs when that is fewer, else T
// itself.
template <template <class> class In, class T>
using LocalDual =
    std::conditional_t<(groups_of_eight(In<T>::kCount) < groups_of_eight(OuterPartials<T>::count)),
                       Dual<Real<T>, In<T>::kCount>, T>;

// Inputs with their seeds and outputs, both local, and the outer inputs in a row.
template <template <class> class In, template <class> class Out, class T, class Local = LocalDual<In, T>>
struct PreaccumulationWorkspace {
  In<Local> in;
  Out<Local> out;
  T input[In<T>::kCount];
};
template <template <class> class In, template <class> class Out, class T>
struct PreaccumulationWorkspace<In, Out, T, T> {};

// out = function(in), called as function(in, out) on whichever scalar is best.
template <template <class> class In, template <class> class Out, class T, class Function, class... Own>
TILTROTOR_NOINLINE void preaccumulate(const In<T>& in, PreaccumulationWorkspace<In, Out, T>& work,
                                      Out<T>& out, Function&& function, const Own*... own) {
  using Local = LocalDual<In, T>;
  if constexpr (std::is_same_v<Local, T>) {
    function(in, out);
  } else {
    flatten(in, work.input);
    int direction = 0;
    In<Local>::each(work.in, [&](auto& x) {
      x = Local::variable(work.input[direction].v, direction);
      ++direction;
    });
    function(work.in, work.out);
    chain_all(work.out, work.input, out, own...);
  }
}

// out at an input of the values of the last one, from what the function found there.
template <template <class> class In, template <class> class Out, class T, class... Own>
TILTROTOR_NOINLINE void preaccumulate_again(const In<T>& in, PreaccumulationWorkspace<In, Out, T>& work,
                                            Out<T>& out, const Own*... own) {
  flatten(in, work.input);
  chain_all(work.out, work.input, out, own...);
}

}  // namespace tiltrotor

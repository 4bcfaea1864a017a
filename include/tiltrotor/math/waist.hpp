// Waist: a place in the model where many state variables pass through few intermediate ones.
//
// A rotor sees 16 numbers, a blade 5, a tail a dozen, whatever the number of states behind them. With dual
// numbers the function beyond the waist is evaluated with one seed for each of its own inputs and the result is
// chained to the outer directions: the same derivative by the chain rule, with far fewer partials carried.
// For plain and complex scalars, and when nothing would be gained, the function is simply called.
//
// Inputs and outputs are structs templated on the scalar that list their members with `each`.
#pragma once

#include "tiltrotor/math/dual.hpp"

namespace tiltrotor {

// Number of scalars a struct lists with `each`.
template <class S>
constexpr int scalar_count() {
  return S::kCount;
}

// Copy the listed scalars to an array, and back.
template <class S, class T>
void pack(const S& s, T* array) {
  S::each(s, [&array](const auto& x) { *array++ = x; });
}
template <class S, class T>
void unpack(const T* array, S& s) {
  S::each(s, [&array](auto& x) { x = *array++; });
}

template <class T>
struct OuterPartials {
  static constexpr int count = 0;
};
template <class R, int M>
struct OuterPartials<Dual<R, M>> {
  static constexpr int count = M;
};

// out.d[outer] = sum over the waist of slope[j] = (d out / d waist input j) times (d waist input j / d outer)
template <class R, int N, int M>
Dual<R, M> chain(R local, const R (&slope)[N], const Dual<R, M>* waist) {
  Dual<R, M> r(local, scaled(slope[0], waist[0].d));
  for (int j = 1; j < N; ++j) {
    for (int g = 0; g < Partials<R, M>::kGroups; ++g) {
      r.d.group[g] = r.d.group[g] + slope[j] * waist[j].d.group[g];
    }
  }
  return r;
}
template <class R, int N, int M>
Dual<R, M> chain(const Dual<R, N>& local, const Dual<R, M>* waist) {
  R slope[N];
  for (int j = 0; j < N; ++j) slope[j] = local.d.get(j);
  return chain(local.v, slope, waist);
}

// Struct of local duals -> the same struct of outer duals.
template <class T, template <class> class Out, class R, int N>
Out<T> chained(const Out<Dual<R, N>>& local, const T* waist) {
  Out<T> out;
  Dual<R, N> flat[Out<T>::kCount];
  pack(local, flat);
  int i = 0;
  Out<T>::each(out, [&](auto& x) {
    x = chain(flat[i], waist);
    ++i;
  });
  return out;
}

template <template <class> class In, class T, class Function>
auto through_waist(const In<T>& in, Function&& function) {
  constexpr int n = In<T>::kCount;
  using R = Real<T>;
  using Local = Dual<R, n>;
  // In groups of eight, not in the lanes of this machine: every machine then takes the same way and finds the same bits.
  constexpr int group = 8;
  if constexpr ((n + group - 1) / group < (OuterPartials<T>::count + group - 1) / group) {
    In<Local> seeded;
    T waist[n];
    pack(in, waist);
    int direction = 0;
    In<Local>::each(seeded, [&](auto& x) {
      x = Local::variable(waist[direction].v, direction);
      ++direction;
    });
    const auto local = function(seeded);
    return chained<T>(local, waist);
  } else {
    return function(in);
  }
}

}  // namespace tiltrotor

// Interpolation tables on a rectangular grid, 1 to 4 dimensions, linear or C1 monotone cubic.
//
// A table has Smooth axes, which take any scalar and may be interpolated with C1 cubics, and Linear axes, which
// take the configuration (mast angle, flap), found once as GridPoint, and are always linear. Each node stores the
// value and the mixed slopes along the smooth axes (2^Smooth numbers: f, f_x, f_y, f_xy for two), computed
// beforehand by table_slopes.hpp, so that a look-up evaluates one local polynomial. Beyond the grid: bracket.hpp.
// Slopes may be stored in single precision (SplitNodes): the interpolant moves by 1e-8 of the slopes, stays C1 and
// goes through every value, and its derivatives are exact.
#pragma once

#include <type_traits>
#include <utility>

#include "tiltrotor/math/tables/bracket.hpp"

namespace tiltrotor {

// Nodes are stored with the linear axes outermost, then the smooth axes in order, then the 2^Smooth numbers
// of a node: bit a of the index set means derivative along smooth axis a. The values may stand in an array of their
// own, the 2^Smooth - 1 slopes of a node in single precision in another: 20 bytes instead of 32 for two smooth axes.
template <class R>
struct StoredSlope {
  using type = float;
};
template <class R, int Smooth>
struct SplitNodes {
  const R* value;
  const typename StoredSlope<R>::type* slope;
};

template <class R, int Smooth, int Linear = 0, class Nodes = const R*>
struct Table {
  static_assert(Smooth >= 1 && Smooth + Linear <= 4, "tables have 1 to 4 axes");
  Axis<R> smooth[Smooth];
  Axis<R> linear[Linear > 0 ? Linear : 1];  // NOLINT(bugprone-branch-clone)
  Nodes node;
};

namespace table_detail {

template <int... K, class Function>
TILTROTOR_INLINE void for_each(std::integer_sequence<int, K...>, Function&& f) {
  (f(std::integral_constant<int, K>()), ...);
}
// f(0), f(1) ... f(N - 1) with the number known to the compiler.
template <int N, class Function>
TILTROTOR_INLINE void unrolled(Function&& f) {
  for_each(std::make_integer_sequence<int, N>(), f);
}

// Nodes from number `first` on.
template <int Smooth, class R>
const R* from_node(const R* node, int first) {
  return node + first * (1 << Smooth);
}
template <int Smooth, class R>
SplitNodes<R, Smooth> from_node(const SplitNodes<R, Smooth>& node, int first) {
  return {node.value + first, node.slope + first * ((1 << Smooth) - 1)};
}

constexpr int power_of_4(int n) { return n == 0 ? 1 : 4 * power_of_4(n - 1); }

// The local polynomial of a cell has 4^Smooth coefficients: base-4 digit a of a coefficient's number selects,
// on smooth axis a, {left value, right value, left slope, right slope}.
template <class T, int Smooth, class Nodes>
struct Cell {
  using V = typename Bracket<T>::V;
  static constexpr bool kSplit = std::is_same_v<Nodes, SplitNodes<Real<T>, Smooth>>;
  typename Bracket<T>::Index
      place;         // of the corner where every axis is left; in numbers, or in nodes when split
  int step[Smooth];  // to the right end of each axis

  TILTROTOR_INLINE Cell(const Axis<Real<T>>* axis, const Bracket<T>* const* at) {
    int stride = kSplit ? 1 : 1 << Smooth;
    for (int a = Smooth - 1; a >= 0; --a) {
      place = a == Smooth - 1 ? at[a]->interval * stride : place + at[a]->interval * stride;
      step[a] = axis[a].count > 1 ? stride : 0;
      stride *= axis[a].count;
    }
  }
  // The numbers of a corner: bit a of its number is its end of axis a.
  TILTROTOR_INLINE void load(const Nodes& node, int corner, V (&number)[1 << Smooth]) const {
    int to = 0;
    for (int a = 0; a < Smooth; ++a) to += (corner >> a & 1) != 0 ? step[a] : 0;
    if constexpr (kSplit) {
      const auto at = from_node(node, place + to);
      number[0] = *at.value;
      for (int s = 1; s < (1 << Smooth); ++s) number[s] = static_cast<Real<T>>(at.slope[s - 1]);
    } else if constexpr (Smooth == 2) {
      gather_four(node + to, place, number);
    } else {
      for (int s = 0; s < (1 << Smooth); ++s) number[s] = gather(node + to + s, place);
    }
  }
};

// The bits of a number with a zero between each.
constexpr int spread_bits(int k) { return k == 0 ? 0 : (k & 1) + 4 * spread_bits(k >> 1); }

// The four coefficients of one axis, weighed.
template <class W, class V, class C>
TILTROTOR_INLINE W weighed(const V (&w)[4], const C& c0, const C& c1, const C& c2, const C& c3) {
  return (w[0] * c0 + w[1] * c1) + (w[2] * c2 + w[3] * c3);
}

// Axes contracted from the last to the first: 4^Axes coefficients -> 1.
template <int Axes, class T, class C>
TILTROTOR_INLINE typename Bracket<T>::W polynomial(const C* c, const Bracket<T>* const* at) {
  using W = typename Bracket<T>::W;
  if constexpr (Axes == 0) {
    return c[0];
  } else {
    constexpr int rest = power_of_4(Axes - 1);
    W out[rest];
    unrolled<rest>([&](auto k) {
      out[k] = weighed<W>(at[Axes - 1]->weight, c[k], c[k + rest], c[k + 2 * rest], c[k + 3 * rest]);
    });
    return polynomial<Axes - 1, T>(static_cast<const W*>(out), at);
  }
}
// The same with its slope along every axis.
template <int Axes, class T>
TILTROTOR_INLINE typename Bracket<T>::V polynomial_with_slopes(const typename Bracket<T>::V* c,
                                                               const Bracket<T>* const* at,
                                                               typename Bracket<T>::V* slope) {
  using V = typename Bracket<T>::V;
  if constexpr (Axes == 0) {
    return c[0];
  } else {
    constexpr int rest = power_of_4(Axes - 1);
    V out[rest];
    V steep[rest];
    unrolled<rest>([&](auto k) {
      out[k] = weighed<V>(at[Axes - 1]->weight, c[k], c[k + rest], c[k + 2 * rest], c[k + 3 * rest]);
      steep[k] = weighed<V>(at[Axes - 1]->slope, c[k], c[k + rest], c[k + 2 * rest], c[k + 3 * rest]);
    });
    slope[Axes - 1] = polynomial<Axes - 1, T>(static_cast<const V*>(steep), at);
    return polynomial_with_slopes<Axes - 1, T>(out, at, slope);
  }
}

// One smooth block of nodes at located arguments, in the cell that is theirs. The last axis is contracted corner by
// corner as they are loaded, so that few numbers are held at a time.
template <int Smooth, class T, class Nodes>
TILTROTOR_INLINE T cell_value(const Cell<T, Smooth, Nodes>& cell, const Nodes& block,
                              const Bracket<T>* const* at) {
  using V = typename Bracket<T>::V;
  using W = typename Bracket<T>::W;
  constexpr bool kSloped = ScalarTraits<T>::kTakesSlopes;
  constexpr int half = 1 << (Smooth - 1), rest = power_of_4(Smooth - 1);
  const Bracket<T>& last = *at[Smooth - 1];
  W out[rest];
  V steep[kSloped ? rest : 1];
  unrolled<half>([&](auto corner) {
    V left[2 * half], right[2 * half];
    cell.load(block, corner, left);
    cell.load(block, corner + half, right);
    unrolled<half>([&](auto kind) {
      constexpr int k = spread_bits(decltype(corner)::value) + 2 * spread_bits(decltype(kind)::value);
      out[k] = weighed<W>(last.weight, left[kind], right[kind], left[kind + half], right[kind + half]);
      if constexpr (kSloped)
        steep[k] = weighed<V>(last.slope, left[kind], right[kind], left[kind + half], right[kind + half]);
    });
  });
  if constexpr (kSloped) {
    // Value and slopes in plain numbers; the partials of the arguments are touched once.
    V slope[Smooth];
    slope[Smooth - 1] = polynomial<Smooth - 1, T>(static_cast<const V*>(steep), at);
    const V f = polynomial_with_slopes<Smooth - 1, T>(out, at, slope);
    const T* argument[Smooth];
    for (int a = 0; a < Smooth; ++a) argument[a] = at[a]->argument;
    return ScalarTraits<T>::template from_slopes<Smooth>(f, slope, argument);
  } else {
    return polynomial<Smooth - 1, T>(static_cast<const W*>(out), at);
  }
}
template <int Smooth, class T, class Nodes>
TILTROTOR_INLINE T block_value(const Axis<Real<T>>* axis, const Nodes& block, const Bracket<T>* const* at) {
  return cell_value<Smooth, T>(Cell<T, Smooth, Nodes>(axis, at), block, at);
}

}  // namespace table_detail

// Look-up at located arguments; the axes they were located on must be those of the table.
template <class T, class Nodes>
T lookup(const Table<Real<T>, 1, 0, Nodes>& table, const Bracket<T>& x) {
  const Bracket<T>* const at[1] = {&x};
  return table_detail::block_value<1, T>(table.smooth, table.node, at);
}
template <class T, class Nodes>
TILTROTOR_INLINE T lookup(const Table<Real<T>, 2, 0, Nodes>& table, const Bracket<T>& x,
                          const Bracket<T>& y) {
  const Bracket<T>* const at[2] = {&x, &y};
  return table_detail::block_value<2, T>(table.smooth, table.node, at);
}

// The cell of located arguments, for tables over the same axes.
template <class T>
using TableCell = table_detail::Cell<T, 2, const Real<T>*>;
template <class T>
TILTROTOR_INLINE T lookup(const Table<Real<T>, 2>& table, const TableCell<T>& cell,
                          const Bracket<T>* const (&at)[2]) {
  return table_detail::cell_value<2, T>(cell, table.node, at);
}

// Look-up in a table without linear axes.
template <class T, class Nodes>
T lookup(const Table<Real<T>, 1, 0, Nodes>& table, Interpolation mode, const T& x) {
  return lookup(table, bracket(table.smooth[0], mode, x));
}
template <class T, class Nodes>
T lookup(const Table<Real<T>, 2, 0, Nodes>& table, Interpolation mode, const T& x, const T& y) {
  return lookup(table, bracket(table.smooth[0], mode, x), bracket(table.smooth[1], mode, y));
}

// Look-up with linear axes at places C, plain or T: the blend of the smooth blocks at the corners around the
// places. Plain corners of weight zero are skipped, so a place on a knot costs one block.
template <class T, class C, class R, int Smooth, int Linear, class Nodes>
T lookup(const Table<R, Smooth, Linear, Nodes>& table, Interpolation mode,
         const GridPoint<C> (&place)[Linear], const T (&x)[Smooth]) {
  Bracket<T> located[Smooth];
  const Bracket<T>* at[Smooth];
  int block = 1;  // nodes
  for (int a = 0; a < Smooth; ++a) {
    located[a] = bracket(table.smooth[a], mode, x[a]);
    at[a] = &located[a];
    block *= table.smooth[a].count;
  }
  T sum = T(R(0));
  for (int corner = 0; corner < (1 << Linear); ++corner) {
    C weight = R(1);
    int index = 0;
    for (int a = 0; a < Linear; ++a) {
      const int right = (corner >> a) & 1;
      weight *= right == 1 ? place[a].fraction : C(R(1) - place[a].fraction);
      index = index * table.linear[a].count + place[a].interval + right;
    }
    if constexpr (kIsNumber<C>)
      if (weight == R(0)) continue;
    sum = sum + weight * table_detail::block_value<Smooth, T>(
                             table.smooth, table_detail::from_node<Smooth>(table.node, index * block), at);
  }
  return sum;
}

}  // namespace tiltrotor

// Interpolation tables on a rectangular grid, 1 to 4 dimensions, linear or C1
// monotone cubic.
//
// A table has Smooth axes, which take any scalar and may be interpolated with
// C1 cubics, and Linear axes, which take plain numbers fixed within a run (mast
// angle, flap) and are always linear. Each node stores the value and the mixed
// slopes along the smooth axes (2^Smooth numbers: f, f_x, f_y, f_xy for two),
// computed beforehand by table_slopes.hpp, so that a look-up evaluates one
// local polynomial. Outside the grid the end value holds with zero slope; on
// the end node itself the last interval counts. A C1 axis with an end_width
// goes there in two steps: at distance d beyond an end of slope m it adds m d
// (1 - d/w)^2 until d = w, so that the slope has no jump, nothing inside the
// grid changes, and from w on the end value holds. The most it adds is 4/27 m
// w.
#pragma once

#include <type_traits>
#include <utility>

#include "tiltrotor/math/pack.hpp"

namespace tiltrotor {

enum class Interpolation : unsigned char { c1, linear };

inline constexpr int kMaxKnots = 128;  // on one axis, checked by the table generator

template <class R>
struct Axis {
  int count;      // knots, 1..kMaxKnots
  const R* knot;  // strictly increasing
  // Optional index, written by the table generator: equal buckets narrower than
  // the narrowest interval, each with the interval just before its left end. A
  // search is then one multiplication and one comparison, whatever the
  // argument.
  const unsigned char* bucket = nullptr;
  int buckets = 0;
  R per_width = 0;  // buckets per unit of the argument
  R end_width = 0;  // C1: beyond its ends the slope fades over this distance; 0: at once
};

// Nodes are stored with the linear axes outermost, then the smooth axes in
// order, then the 2^Smooth numbers of a node: bit a of the index set means
// derivative along smooth axis a.
template <class R, int Smooth, int Linear = 0>
struct Table {
  static_assert(Smooth >= 1 && Smooth + Linear <= 4, "tables have 1 to 4 axes");
  Axis<R> smooth[Smooth];
  Axis<R> linear[Linear > 0 ? Linear : 1];  // NOLINT(bugprone-branch-clone)
  const R* node;
};

// Place of an argument on an axis: interval and fraction 0..1 inside it.
template <class R>
struct Place {
  int interval;
  R fraction;
};

// Largest i <= count - 2 with knot[i] <= x; 0 when x lies before the grid or is
// NaN. x lies on the grid when the axis has an index.
template <class R>
int find_interval(const Axis<R>& axis, R x) {
  if (axis.bucket != nullptr) {
    const R at = (x - axis.knot[0]) * axis.per_width;
    const R last = static_cast<R>(axis.buckets - 1);
    const int i = axis.bucket[static_cast<int>(at > R(0) ? (at < last ? at : last) : R(0))];
    return i + static_cast<int>(i < axis.count - 2 && x >= axis.knot[i + 1]);
  }
  int low = 0;
  int high = axis.count - 1;
  for (int step = kMaxKnots; step > 1 && high - low > 1; step /= 2) {
    const int middle = (low + high) / 2;
    if (x >= axis.knot[middle]) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return low;
}
template <class R>
TILTROTOR_INLINE PackIndex<R> find_interval(const Axis<R>& axis, const Pack<R>& x) {
  constexpr int lanes = Pack<R>::kLanes;
  PackIndex<R> i;
  if (axis.bucket == nullptr) {
    for (int lane = 0; lane < lanes; ++lane) i.e[lane] = find_interval(axis, x.get(lane));
    return i;
  }
  const Pack<R> at = (x - axis.knot[0]) * axis.per_width;
  const R last = static_cast<R>(axis.buckets - 1);
  const Pack<R> held = select(at > R(0), select(at < last, at, Pack<R>(last)), Pack<R>(R(0)));
  for (int lane = 0; lane < lanes; ++lane) i.e[lane] = static_cast<int>(held.get(lane));
  for (int lane = 0; lane < lanes; ++lane) {
    const int k = axis.bucket[i.e[lane]];
    i.e[lane] =
        k + (static_cast<int>(k < axis.count - 2) & static_cast<int>(x.get(lane) >= axis.knot[k + 1]));
  }
  return i;
}

// Plain place on a linear axis, held at the ends.
template <class R>
Place<R> place_on(const Axis<R>& axis, R x) {
  if (axis.count == 1) return {0, R(0)};
  const int i = find_interval(axis, x);
  const R t = (x - axis.knot[i]) / (axis.knot[i + 1] - axis.knot[i]);
  return {i, t < R(0) ? R(0) : (t > R(1) ? R(1) : t)};
}

template <class R>
R pick(const R* array, int index) {
  return array[index];
}
template <class R>
void pick_four(const R* array, int index, R* out) {
  for (int k = 0; k < 4; ++k) out[k] = array[index + k];
}

// An argument found on a smooth axis, with the weights of the four numbers that
// interpolate there: value at the left and right knot, slope at the left and
// right knot. Tables over the same axis share it.
//   T  scalar of the argument: plain number, pack, dual number, complex
//   V  plain number or pack: what decisions and indices are made from
//   W  scalar of the weights: dual numbers take plain weights and their slopes,
//   the others weigh themselves
template <class T>
struct Located {
  using V = decltype(value(std::declval<T>()));
  using W = std::conditional_t<ScalarTraits<T>::kTakesSlopes, V, T>;
  using Index = decltype(find_interval(std::declval<Axis<Real<T>>>(), std::declval<V>()));
  Index interval;
  W weight[4];
  V slope[ScalarTraits<T>::kTakesSlopes ? 4 : 1];           // d weight / d argument
  decltype(std::declval<V>() < std::declval<V>()) outside;  // beyond the end knots
  const T* argument;                                        // must outlive this
};

// An argument on the grid, or at its end. What changes beyond the end is left to fade_outside(), so that
// several arguments are asked at once whether any lies there: few do.
template <class T>
TILTROTOR_INLINE Located<T> locate_on_grid(const Axis<Real<T>>& axis, Interpolation mode, const T& x) {
  using R = Real<T>;
  using V = typename Located<T>::V;
  using W = typename Located<T>::W;
  const V low = axis.knot[0];
  const V high = axis.knot[axis.count - 1];
  const V plain = value(x);
  const auto before = plain < low;
  const auto beyond = plain > high;
  const V held = select(before, low, select(beyond, high, plain));
  Located<T> at;
  at.argument = &x;
  at.outside = before | beyond;
  V left = low;
  V width = R(1);
  if (axis.count > 1) {
    at.interval = find_interval(axis, held);
    left = pick(axis.knot, at.interval);
    width = pick(axis.knot + 1, at.interval) - left;
  } else {  // a constant
    at.interval = typename Located<T>::Index();
    at.outside = low < low;
  }
  W t = (held - left) / width;
  if constexpr (!std::is_same_v<V, W>) {
    if (!(before | beyond)) t = (x - left) / width;
  }
  const W s = R(1) - t;
  if (mode == Interpolation::linear) {
    at.weight[0] = s;
    at.weight[1] = t;
    at.weight[2] = at.weight[3] = W(R(0));
  } else {  // cubic Hermite basis
    at.weight[0] = s * s * (R(1) + R(2) * t);
    at.weight[1] = t * t * (R(3) - R(2) * t);
    at.weight[2] = width * t * s * s;
    at.weight[3] = -(width * t * t * s);
  }
  if constexpr (ScalarTraits<T>::kTakesSlopes) {
    const V rise = R(1) / width;
    if (mode == Interpolation::linear) {
      at.slope[0] = -rise;
      at.slope[1] = rise;
      at.slope[2] = at.slope[3] = V(R(0));
    } else {
      at.slope[1] = R(6) * t * s * rise;
      at.slope[0] = -at.slope[1];
      at.slope[2] = s * (s - R(2) * t);
      at.slope[3] = t * (t - R(2) * s);
    }
  }
  return at;
}

// Beyond the end knots the weights have no slope, but the end slope of a C1 axis fades.
template <class T>
TILTROTOR_INLINE void fade_outside(const Axis<Real<T>>& axis, Interpolation mode, Located<T>& at) {
  using R = Real<T>;
  using V = typename Located<T>::V;
  using W = typename Located<T>::W;
  if constexpr (ScalarTraits<T>::kTakesSlopes)
    for (V& slope : at.slope) slope = select(at.outside, V(R(0)), slope);
  if (mode == Interpolation::linear) return;
  const V low = axis.knot[0];
  const V high = axis.knot[axis.count - 1];
  const V plain = value(*at.argument);
  const auto before = plain < low;
  const V distance = select(before, low - plain, plain - high);
  const auto fading = at.outside & (distance < V(axis.end_width));
  if (!any(fading)) return;
  const V end = select(before, low, high);
  const W d = [&at] {
    if constexpr (ScalarTraits<T>::kTakesSlopes) {
      return value(*at.argument);
    } else {
      return *at.argument;
    }
  }() - end;
  const W left = R(1) - select(before, W(-d), d) * (R(1) / axis.end_width);
  const W added = d * left * left;
  const auto beyond = high < plain;
  at.weight[2] = select(before & fading, added, at.weight[2]);
  at.weight[3] = select(beyond & fading, added, at.weight[3]);
  if constexpr (ScalarTraits<T>::kTakesSlopes) {
    const V slope = left * (R(3) * left - R(2));
    at.slope[2] = select(before & fading, slope, at.slope[2]);
    at.slope[3] = select(beyond & fading, slope, at.slope[3]);
  }
}

template <class T>
TILTROTOR_INLINE Located<T> locate(const Axis<Real<T>>& axis, Interpolation mode, const T& x) {
  Located<T> at = locate_on_grid(axis, mode, x);
  if (any(at.outside)) fade_outside(axis, mode, at);
  return at;
}

namespace detail {

template <int... K, class Function>
TILTROTOR_INLINE void for_each(std::integer_sequence<int, K...>, Function&& f) {
  (f(std::integral_constant<int, K>()), ...);
}
// f(0), f(1) ... f(N - 1) with the number known to the compiler.
template <int N, class Function>
TILTROTOR_INLINE void unrolled(Function&& f) {
  for_each(std::make_integer_sequence<int, N>(), f);
}

constexpr int power_of_4(int n) { return n == 0 ? 1 : 4 * power_of_4(n - 1); }

// The local polynomial of a cell has 4^Smooth coefficients: base-4 digit a of a
// coefficient's number selects, on smooth axis a, {left value, right value,
// left slope, right slope}.
template <class T, int Smooth>
struct CellCoefficients {
  using V = typename Located<T>::V;
  const Real<T>* node;
  typename Located<T>::Index place;  // of the corner where every axis is left
  int step[Smooth];                  // to the right end of each axis

  TILTROTOR_INLINE CellCoefficients(const Axis<Real<T>>* axis, const Real<T>* block,
                                    const Located<T>* const* at)
      : node(block) {
    int stride = 1 << Smooth;
    for (int a = Smooth - 1; a >= 0; --a) {
      place = a == Smooth - 1 ? at[a]->interval * stride : place + at[a]->interval * stride;
      step[a] = axis[a].count > 1 ? stride : 0;
      stride *= axis[a].count;
    }
  }
  // Numbers of all corners, in order: bit a of a corner's number is its end of
  // axis a.
  TILTROTOR_INLINE void load(V (&number)[1 << Smooth][1 << Smooth]) const {
    unrolled<(1 << Smooth)>([&](auto k) {
      const Real<T>* corner = node;
      for (int a = 0; a < Smooth; ++a) corner += (k >> a & 1) != 0 ? step[a] : 0;
      if constexpr (Smooth == 2) {
        pick_four(corner, place, number[k]);
      } else {
        for (int s = 0; s < (1 << Smooth); ++s) number[k][s] = pick(corner + s, place);
      }
    });
  }
};

// Bits 0, 2, 4 .. of a number.
constexpr int even_bits(int k) { return k == 0 ? 0 : (k & 1) + 2 * even_bits(k >> 2); }

// The four coefficients of one axis, weighed.
template <class W, class V, class C>
TILTROTOR_INLINE W weighed(const V (&w)[4], const C& c0, const C& c1, const C& c2, const C& c3) {
  return (w[0] * c0 + w[1] * c1) + (w[2] * c2 + w[3] * c3);
}

// Axes contracted from the last to the first: 4^Axes coefficients -> 1.
template <int Axes, class T, class C>
TILTROTOR_INLINE typename Located<T>::W polynomial(const C* c, const Located<T>* const* at) {
  using W = typename Located<T>::W;
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
TILTROTOR_INLINE typename Located<T>::V polynomial_with_slopes(const typename Located<T>::V* c,
                                                               const Located<T>* const* at,
                                                               typename Located<T>::V* slope) {
  using V = typename Located<T>::V;
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

// One smooth block of nodes at located arguments.
template <int Smooth, class T>
TILTROTOR_INLINE T evaluate(const Axis<Real<T>>* axis, const Real<T>* block, const Located<T>* const* at) {
  using V = typename Located<T>::V;
  const CellCoefficients<T, Smooth> cell(axis, block, at);
  V number[1 << Smooth][1 << Smooth];
  cell.load(number);
  V c[power_of_4(Smooth)];
  unrolled<power_of_4(Smooth)>([&](auto k) { c[k] = number[even_bits(k)][even_bits(k >> 1)]; });
  if constexpr (ScalarTraits<T>::kTakesSlopes) {
    // Value and slopes in plain numbers; the partials of the arguments are
    // touched once.
    V slope[Smooth];
    const V f = polynomial_with_slopes<Smooth, T>(c, at, slope);
    const T* argument[Smooth];
    for (int a = 0; a < Smooth; ++a) argument[a] = at[a]->argument;
    return ScalarTraits<T>::template from_slopes<Smooth>(f, slope, argument);
  } else {
    return polynomial<Smooth, T>(static_cast<const V*>(c), at);
  }
}

}  // namespace detail

// Look-up at located arguments; the axes they were located on must be those of
// the table.
template <class T>
T lookup(const Table<Real<T>, 1>& table, const Located<T>& x) {
  const Located<T>* const at[1] = {&x};
  return detail::evaluate<1, T>(table.smooth, table.node, at);
}
template <class T>
TILTROTOR_INLINE T lookup(const Table<Real<T>, 2>& table, const Located<T>& x, const Located<T>& y) {
  const Located<T>* const at[2] = {&x, &y};
  return detail::evaluate<2, T>(table.smooth, table.node, at);
}

// Look-up in a table without linear axes.
template <class T>
T lookup(const Table<Real<T>, 1>& table, Interpolation mode, const T& x) {
  return lookup(table, locate(table.smooth[0], mode, x));
}
template <class T>
T lookup(const Table<Real<T>, 2>& table, Interpolation mode, const T& x, const T& y) {
  return lookup(table, locate(table.smooth[0], mode, x), locate(table.smooth[1], mode, y));
}

// Look-up with linear axes at fixed places: the blend of the smooth blocks at
// the corners around the places. Corners of weight zero are skipped, so a place
// on a knot costs one block.
template <class T, class R, int Smooth, int Linear>
T lookup(const Table<R, Smooth, Linear>& table, Interpolation mode, const Place<R> (&place)[Linear],
         const T (&x)[Smooth]) {
  Located<T> located[Smooth];
  const Located<T>* at[Smooth];
  int block = 1 << Smooth;
  for (int a = 0; a < Smooth; ++a) {
    located[a] = locate(table.smooth[a], mode, x[a]);
    at[a] = &located[a];
    block *= table.smooth[a].count;
  }
  T sum = T(R(0));
  for (int corner = 0; corner < (1 << Linear); ++corner) {
    R weight = R(1);
    int index = 0;
    for (int a = 0; a < Linear; ++a) {
      const int right = (corner >> a) & 1;
      weight *= right == 1 ? place[a].fraction : R(1) - place[a].fraction;
      index = index * table.linear[a].count + place[a].interval + right;
    }
    if (weight == R(0)) continue;
    sum = sum + weight * detail::evaluate<Smooth, T>(table.smooth, table.node + index * block, at);
  }
  return sum;
}

}  // namespace tiltrotor

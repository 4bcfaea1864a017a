// Interpolation tables on a rectangular grid, 1 to 4 dimensions, linear or C1 monotone cubic.
//
// A table has Smooth axes, which take any scalar and may be interpolated with C1 cubics, and Linear axes, which
// take plain numbers fixed within a run (mast angle, flap) and are always linear. Each node stores the value and
// the mixed slopes along the smooth axes (2^Smooth numbers: f, f_x, f_y, f_xy for two), computed beforehand by
// table_slopes.hpp, so that a look-up evaluates one local polynomial.
// Outside the grid the end value holds with zero slope; on the end node itself the last interval counts.
#pragma once

#include <type_traits>

#include "tiltrotor/math/scalar.hpp"

namespace tiltrotor {

enum class Interpolation : unsigned char { c1, linear };

inline constexpr int kMaxKnots = 128;  // on one axis, checked by the table generator

template <class R>
struct Axis {
  int count;      // knots, 1..kMaxKnots
  const R* knot;  // strictly increasing
  // Optional index, written by the table generator: equal buckets no wider than the narrowest interval, each with the
  // interval at its left end. A search is then one multiplication and two comparisons, whatever the argument.
  const unsigned char* bucket = nullptr;
  int buckets = 0;
  R per_width = 0;  // buckets per unit of the argument
};

// Nodes are stored with the linear axes outermost, then the smooth axes in order, then the 2^Smooth numbers of
// a node: bit a of the index set means derivative along smooth axis a.
template <class R, int Smooth, int Linear = 0>
struct Table {
  static_assert(Smooth >= 1 && Smooth + Linear <= 4, "tables have 1 to 4 axes");
  Axis<R> smooth[Smooth];
  Axis<R> linear[Linear > 0 ? Linear : 1];
  const R* node;
};

// Place of an argument on an axis: interval and fraction 0..1 inside it.
template <class R>
struct Place {
  int interval;
  R fraction;
};

// Largest i <= count - 2 with knot[i] <= x; 0 when x lies before the grid. At least two knots; x is finite or NaN.
template <class R>
int find_interval(const Axis<R>& axis, R x) {
  if (axis.bucket != nullptr) {
    const R at = (x - axis.knot[0]) * axis.per_width;
    const R last = static_cast<R>(axis.buckets - 1);
    int i = axis.bucket[static_cast<int>(at > R(0) ? (at < last ? at : last) : R(0))];
    i -= static_cast<int>(i > 0 && x < axis.knot[i]);  // rounding at the edge of a bucket
    i += static_cast<int>(i < axis.count - 2 && x >= axis.knot[i + 1]);
    return i;
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

// Plain place on a linear axis, held at the ends.
template <class R>
Place<R> place_on(const Axis<R>& axis, R x) {
  if (axis.count == 1) return {0, R(0)};
  const int i = find_interval(axis, x);
  const R t = (x - axis.knot[i]) / (axis.knot[i + 1] - axis.knot[i]);
  return {i, t < R(0) ? R(0) : (t > R(1) ? R(1) : t)};
}

namespace detail {

// The four weights of one axis on {left value, right value, left slope, right slope}, and their derivatives.
template <class T>
struct AxisWeights {
  T w[4];
};

// Cubic Hermite basis at fraction t of an interval of width h; straight line when linear.
template <class T>
AxisWeights<T> weights(Interpolation mode, const T& t, Real<T> h) {
  using R = Real<T>;
  if (mode == Interpolation::linear) return {{R(1) - t, t, T(R(0)), T(R(0))}};
  const T s = R(1) - t;
  return {{s * s * (R(1) + R(2) * t), t * t * (R(3) - R(2) * t), h * t * s * s, -h * t * t * s}};
}
// d weights / dx
template <class R>
AxisWeights<R> weight_slopes(Interpolation mode, R t, R h) {
  if (mode == Interpolation::linear) return {{-R(1) / h, R(1) / h, R(0), R(0)}};
  const R s = R(1) - t;
  return {{-R(6) * t * s / h, R(6) * t * s / h, s * (s - R(2) * t), t * (t - R(2) * s)}};
}

constexpr int power_of_4(int n) { return n == 0 ? 1 : 4 * power_of_4(n - 1); }

// Where a look-up happens on each smooth axis.
template <class R, int Smooth>
struct Cell {
  int interval[Smooth];
  R width[Smooth];
  bool inside[Smooth];  // false: held at the end, no slope
};

// Corner coefficients of a cell, gathered as c[4^Smooth]: base-4 digit a selects, on smooth axis a,
// {left value, right value, left slope, right slope}.
template <class R, int Smooth>
void gather(const Axis<R>* axis, const R* node, const Cell<R, Smooth>& cell, R* c) {
  constexpr int per_node = 1 << Smooth;
  const R* corner[1 << Smooth];  // bit a: right end of axis a
  for (int k = 0; k < (1 << Smooth); ++k) {
    int index = 0;
    for (int a = 0; a < Smooth; ++a) {
      const int last = axis[a].count - 1;
      const int at = cell.interval[a] + (k >> a & 1);
      index = index * axis[a].count + (at < last ? at : last);
    }
    corner[k] = node + index * per_node;
  }
  for (int k = 0; k < power_of_4(Smooth); ++k) {
    int ends = 0;
    int slopes = 0;
    for (int a = 0; a < Smooth; ++a) {
      ends |= (k >> (2 * a) & 1) << a;
      slopes |= (k >> (2 * a + 1) & 1) << a;
    }
    c[k] = corner[ends][slopes];
  }
}

// Contract the coefficients with the weights of the last axis: 4 Rest numbers -> Rest.
template <int Rest, class T, class C>
void contract(const C* c, const AxisWeights<T>& w, T* out) {
  for (int k = 0; k < Rest; ++k) {
    out[k] = (w.w[0] * c[k] + w.w[1] * c[k + Rest]) + (w.w[2] * c[k + 2 * Rest] + w.w[3] * c[k + 3 * Rest]);
  }
}

// Value of the local polynomial: axes contracted from the last to the first.
template <int Axes, class T, class C>
T polynomial(const C* c, const AxisWeights<T>* w) {
  constexpr int rest = power_of_4(Axes - 1);
  T out[rest];
  contract<rest>(c, w[Axes - 1], out);
  if constexpr (Axes == 1) {
    return out[0];
  } else {
    return polynomial<Axes - 1>(out, w);
  }
}

// The same with its slope along every axis, from the weights `w` and their derivatives `d`.
template <int Axes, class R>
R polynomial_with_slopes(const R* c, const AxisWeights<R>* w, const AxisWeights<R>* d, R* slope) {
  constexpr int rest = power_of_4(Axes - 1);
  R out[rest];
  R steep[rest];
  contract<rest>(c, w[Axes - 1], out);
  contract<rest>(c, d[Axes - 1], steep);
  if constexpr (Axes == 1) {
    slope[0] = steep[0];
    return out[0];
  } else {
    slope[Axes - 1] = polynomial<Axes - 1>(steep, w);
    return polynomial_with_slopes<Axes - 1>(out, w, d, slope);
  }
}

template <class R>
struct PlainArgument {
  R held;       // argument, held inside the grid
  bool inside;  // on the grid
};
template <class R>
PlainArgument<R> hold(const Axis<R>& axis, R x) {
  const R low = axis.knot[0];
  const R high = axis.knot[axis.count - 1];
  if (x < low) return {low, false};
  if (x > high) return {high, false};
  return {x, axis.count > 1};
}

// One smooth block of nodes at arguments x[Smooth].
template <class T, class R, int Smooth>
T evaluate(const Axis<R>* axis, const R* node, Interpolation mode, const T* x) {
  // Dual numbers take plain fractions and the slopes of the polynomial; other scalars go through it themselves.
  using Fraction = std::conditional_t<ScalarTraits<T>::kTakesSlopes, R, T>;
  Cell<R, Smooth> cell;
  Fraction fraction[Smooth];
  for (int a = 0; a < Smooth; ++a) {
    const PlainArgument<R> p = hold(axis[a], value(x[a]));
    cell.inside[a] = p.inside;
    cell.interval[a] = axis[a].count > 1 ? find_interval(axis[a], p.held) : 0;
    const R left = axis[a].knot[cell.interval[a]];
    cell.width[a] = axis[a].count > 1 ? axis[a].knot[cell.interval[a] + 1] - left : R(1);
    if constexpr (ScalarTraits<T>::kTakesSlopes) {
      fraction[a] = (p.held - left) / cell.width[a];
    } else {  // held at an end: a constant
      fraction[a] = p.inside ? (x[a] - left) / cell.width[a] : T((p.held - left) / cell.width[a]);
    }
  }
  R c[power_of_4(Smooth)];
  gather<R, Smooth>(axis, node, cell, c);

  if constexpr (ScalarTraits<T>::kTakesSlopes) {
    // Value and slopes in plain numbers; the partials of the arguments are touched once.
    AxisWeights<R> w[Smooth];
    AxisWeights<R> d[Smooth];
    R slope[Smooth];
    for (int a = 0; a < Smooth; ++a) {
      w[a] = weights<R>(mode, fraction[a], cell.width[a]);
      d[a] = weight_slopes<R>(mode, fraction[a], cell.width[a]);
    }
    const R f = polynomial_with_slopes<Smooth>(c, w, d, slope);
    for (int a = 0; a < Smooth; ++a) slope[a] = cell.inside[a] ? slope[a] : R(0);
    return ScalarTraits<T>::template from_slopes<Smooth>(f, slope, x);
  } else {
    AxisWeights<T> w[Smooth];
    for (int a = 0; a < Smooth; ++a) w[a] = weights<T>(mode, fraction[a], cell.width[a]);
    return polynomial<Smooth>(c, w);
  }
}

}  // namespace detail

// Look-up in a table without linear axes.
template <class T, class R>
T lookup(const Table<R, 1>& table, Interpolation mode, const T& x) {
  return detail::evaluate<T, R, 1>(table.smooth, table.node, mode, &x);
}
template <class T, class R>
T lookup(const Table<R, 2>& table, Interpolation mode, const T& x, const T& y) {
  const T arguments[2] = {x, y};
  return detail::evaluate<T, R, 2>(table.smooth, table.node, mode, arguments);
}

// Look-up with linear axes at fixed places: the blend of the smooth blocks at the corners around the places.
// Corners of weight zero are skipped, so a place on a knot costs one block.
template <class T, class R, int Smooth, int Linear>
T lookup(const Table<R, Smooth, Linear>& table, Interpolation mode, const Place<R> (&place)[Linear],
         const T (&x)[Smooth]) {
  int block = 1 << Smooth;
  for (int a = 0; a < Smooth; ++a) block *= table.smooth[a].count;
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
    sum = sum + weight * detail::evaluate<T, R, Smooth>(table.smooth, table.node + index * block, mode, x);
  }
  return sum;
}

}  // namespace tiltrotor

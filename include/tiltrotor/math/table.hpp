// Interpolation tables on a rectangular grid, 1 to 4 dimensions, linear or C1 monotone cubic (model.md 14.3).
//
// A table has Smooth axes, which take any scalar and may be interpolated with C1 cubics, and Linear axes, which
// take plain numbers fixed within a run (mast angle, flap) and are always linear. Each node stores the value and
// the mixed slopes along the smooth axes (2^Smooth numbers: f, f_x, f_y, f_xy for two), computed beforehand by
// table_slopes.hpp, so that a look-up evaluates one local polynomial.
// Outside the grid the end value holds with zero slope; on the end node itself the last interval counts.
#pragma once

#include "tiltrotor/math/scalar.hpp"

namespace tiltrotor {

enum class Interpolation : unsigned char { c1, linear };

inline constexpr int kMaxKnots = 128;  // on one axis, checked by the table generator

template <class R>
struct Axis {
  int count;      // knots, 1..kMaxKnots
  const R* knot;  // strictly increasing
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

// Largest i <= count - 2 with knot[i] <= x; 0 when x lies before the grid. Bounded bisection.
template <class R>
int find_interval(const Axis<R>& axis, R x) {
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
  for (int k = 0; k < power_of_4(Smooth); ++k) {
    int index = 0;
    int slopes = 0;
    int digits = k;
    for (int a = 0; a < Smooth; ++a) {
      const int digit = digits & 3;
      digits >>= 2;
      const int last = axis[a].count - 1;
      const int at = cell.interval[a] + (digit & 1);
      index = index * axis[a].count + (at < last ? at : last);
      slopes |= (digit >> 1) << a;
    }
    c[k] = node[index * per_node + slopes];
  }
}

// Contract the coefficients with the weights of the last axis: 4^n numbers -> 4^(n-1).
template <class T, class C>
void contract(int remaining, const C* c, const T* w, T* out) {
  for (int k = 0; k < remaining; ++k) {
    out[k] = (w[0] * c[k] + w[1] * c[k + remaining]) + (w[2] * c[k + 2 * remaining] + w[3] * c[k + 3 * remaining]);
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
  Cell<R, Smooth> cell{};
  T fraction[Smooth];
  for (int a = 0; a < Smooth; ++a) {
    const PlainArgument<R> p = hold(axis[a], value(x[a]));
    cell.inside[a] = p.inside;
    cell.interval[a] = axis[a].count > 1 ? find_interval(axis[a], p.held) : 0;
    const R left = axis[a].knot[cell.interval[a]];
    cell.width[a] = axis[a].count > 1 ? axis[a].knot[cell.interval[a] + 1] - left : R(1);
    // Inside: the argument with its derivative. Held at an end: a constant.
    fraction[a] = p.inside ? (x[a] - left) / cell.width[a] : T((p.held - left) / cell.width[a]);
  }
  constexpr int count = power_of_4(Smooth);
  R c[count];
  gather<R, Smooth>(axis, node, cell, c);

  if constexpr (ScalarTraits<T>::kTakesSlopes) {
    // Value and slopes in plain numbers; the partials of the arguments are touched once.
    R current[count];
    R gradient[Smooth][count / 4];
    AxisWeights<R> w[Smooth];
    for (int k = 0; k < count; ++k) current[k] = c[k];
    int remaining = count / 4;
    for (int a = Smooth - 1; a >= 0; --a) {
      w[a] = weights<R>(mode, value(fraction[a]), cell.width[a]);
      AxisWeights<R> slope = weight_slopes<R>(mode, value(fraction[a]), cell.width[a]);
      for (int k = 0; k < 4; ++k) slope.w[k] = cell.inside[a] ? slope.w[k] : R(0);
      contract(remaining, current, slope.w, gradient[a]);
      for (int b = Smooth - 1; b > a; --b) contract(remaining, gradient[b], w[a].w, gradient[b]);
      contract(remaining, current, w[a].w, current);
      remaining /= 4;
    }
    T result = T(current[0]);
    if constexpr (Smooth == 1) return ScalarTraits<T>::from_slopes(current[0], gradient[0][0], x[0]);
    if constexpr (Smooth == 2) {
      return ScalarTraits<T>::from_slopes(current[0], gradient[0][0], x[0], gradient[1][0], x[1]);
    }
    for (int a = 0; a < Smooth; ++a) result.d = combined(R(1), result.d, gradient[a][0], x[a].d);
    return result;
  } else {
    T current[count];
    for (int k = 0; k < count; ++k) current[k] = T(c[k]);
    int remaining = count / 4;
    for (int a = Smooth - 1; a >= 0; --a) {
      const AxisWeights<T> w = weights<T>(mode, fraction[a], cell.width[a]);
      contract(remaining, current, w.w, current);
      remaining /= 4;
    }
    return current[0];
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

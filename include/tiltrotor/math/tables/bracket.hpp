// An axis of a table, and an argument found on it: interval, and the weights of an interpolation that is
// linear or C1 monotone cubic.
//
// Outside the grid the end value holds with zero slope; on the end node itself the last interval counts. A C1
// axis with an end_width goes there in two steps: at distance d beyond an end of slope m it adds
// m d (1 - d/w)^2 until d = w, so that the slope has no jump, nothing inside the grid changes, and from w on the
// end value holds. The most it adds is 4/27 m w.
#pragma once

#include <type_traits>

#include "tiltrotor/math/differentiation/batch.hpp"

namespace tiltrotor {

enum class Interpolation : unsigned char { c1, linear };

inline constexpr int kMaxKnots = 128;  // on one axis, checked by the table generator

template <class R>
struct Axis {
  int count;      // knots, 1..kMaxKnots
  const R* knot;  // strictly increasing
  // Optional index, written by the table generator where every knot begins one of some equal buckets: the interval of
  // each, and that of the right end. A search is then one multiplication, whatever the argument; one that lies
  // within rounding below a knot may be told the interval above it.
  const unsigned char* bucket = nullptr;
  R per_width = 0;  // buckets per unit of the argument
  R end_width = 0;  // C1: beyond its ends the slope fades over this distance; 0: at once
};

// Grid point: an argument on an axis, as interval and fraction 0..1 inside it. With partials the fraction
// carries the slope of its interval: on a knot that towards the next one, on the last knot that from the one
// before.
template <class C>
struct GridPoint {
  int interval;
  C fraction;
};

// Largest i <= count - 2 with knot[i] <= x; 0 when x lies before the grid or is NaN. x lies on the grid when
// the axis has an index.
template <class R>
int find_interval(const Axis<R>& axis, R x) {
  if (axis.bucket != nullptr) {
    const R at = (x - axis.knot[0]) * axis.per_width;
    return axis.bucket[static_cast<int>(at > R(0) ? at : R(0))];
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
TILTROTOR_INLINE BatchIndex<R> find_interval(const Axis<R>& axis, const Batch<R>& x) {
  using Place = std::ptrdiff_t;
  if (axis.bucket == nullptr)
    return BatchIndex<R>::each([&](int lane) { return Place{find_interval(axis, x.get(lane))}; });
  const Batch<R> at = (x - axis.knot[0]) * axis.per_width;
  const Batch<R> held = select(at > R(0), at, Batch<R>(R(0)));
  return BatchIndex<R>::each(
      [&](int lane) { return Place{axis.bucket[static_cast<Place>(held.get(lane))]}; });
}

// Place on a linear axis, held at the ends.
template <class C>
GridPoint<C> grid_point(const Axis<Real<C>>& axis, const C& x) {
  using R = Real<C>;
  if (axis.count == 1) return {0, C(R(0))};
  const int i = find_interval(axis, value(x));
  const C t = (x - axis.knot[i]) / (axis.knot[i + 1] - axis.knot[i]);
  return {i, value(t) < R(0) ? C(R(0)) : (value(t) > R(1) ? C(R(1)) : t)};
}

template <class R>
R gather(const R* array, int index) {
  return array[index];
}
template <class R>
void gather_four(const R* array, int index, R* out) {
  for (int k = 0; k < 4; ++k) out[k] = array[index + k];
}

// An argument found on a smooth axis, with the weights of the four numbers that interpolate there: value at
// the left and right knot, slope at the left and right knot. Tables over the same axis share it.
//   T  scalar of the argument: plain number, batch, dual number, complex
//   V  plain number or batch: what decisions and indices are made from
//   W  scalar of the weights: dual numbers take plain weights and their slopes,
//   the others weigh themselves
template <class T>
struct Bracket {
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
TILTROTOR_INLINE Bracket<T> bracket_on_grid(const Axis<Real<T>>& axis, Interpolation mode, const T& x) {
  using R = Real<T>;
  using V = typename Bracket<T>::V;
  using W = typename Bracket<T>::W;
  const V low = axis.knot[0];
  const V high = axis.knot[axis.count - 1];
  const V plain = value(x);
  const auto before = plain < low;
  const auto beyond = plain > high;
  const V held = select(before, low, select(beyond, high, plain));
  Bracket<T> at;
  at.argument = &x;
  at.outside = before | beyond;
  V left = low;
  V width = R(1);
  if (axis.count > 1) {
    at.interval = find_interval(axis, held);
    left = gather(axis.knot, at.interval);
    width = gather(axis.knot + 1, at.interval) - left;
  } else {  // a constant
    at.interval = typename Bracket<T>::Index();
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
TILTROTOR_INLINE void fade_outside(const Axis<Real<T>>& axis, Interpolation mode, Bracket<T>& at) {
  using R = Real<T>;
  using V = typename Bracket<T>::V;
  using W = typename Bracket<T>::W;
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
TILTROTOR_INLINE Bracket<T> bracket(const Axis<Real<T>>& axis, Interpolation mode, const T& x) {
  Bracket<T> at = bracket_on_grid(axis, mode, x);
  if (any(at.outside)) fade_outside(axis, mode, at);
  return at;
}

}  // namespace tiltrotor

// Node slopes of the C1 monotone cubic interpolant (Fritsch and Butland 1984): computed once, before a table
// is used.
//
// Along one axis the inner slopes are the weighted harmonic mean of the neighbouring secants (zero where they
// change sign), the end slopes one-sided and limited: no overshoot, nodes reproduced, first derivative
// continuous. On an axis that goes once around a circle the two ends are one place with the slope of an inner
// knot. Mixed slopes are the mean over the orders of the axes, so that the interpolant does not depend
// on the order.
#pragma once

#include <cstddef>

#include "tiltrotor/math/tables/table.hpp"

namespace tiltrotor {

namespace table_slopes_detail {

template <class R>
R end_slope(R h0, R h1, R d0, R d1) {
  const R m = ((R(2) * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
  const R size_m = m < R(0) ? -m : m;
  const R size_limit = d0 < R(0) ? -R(3) * d0 : R(3) * d0;
  if (m * d0 <= R(0)) return R(0);
  if (d0 * d1 <= R(0) && size_m > size_limit) return R(3) * d0;
  return m;
}

}  // namespace table_slopes_detail

// Slopes m[k * stride] at `count` knots of values f[k * stride]. One knot: zero. Two: the straight line.
// `around`: the last knot is the first one again, and so is its value.
template <class R>
void monotone_slopes(int count, const R* knot, const R* f, R* m, std::ptrdiff_t stride, bool around = false) {
  if (count == 1) {
    m[0] = R(0);
    return;
  }
  const auto h = [&](int i) { return knot[i + 1] - knot[i]; };
  const auto d = [&](int i) { return (f[(i + 1) * stride] - f[i * stride]) / h(i); };
  if (count == 2) {
    m[0] = d(0);
    m[stride] = d(0);
    return;
  }
  const auto inner_slope = [&](int last, int next) {  // between the intervals `last` and `next`
    const R before = d(last);
    const R after = d(next);
    if (before * after <= R(0)) return R(0);
    const R w1 = R(2) * h(next) + h(last);
    const R w2 = h(next) + R(2) * h(last);
    return (w1 + w2) / (w1 / before + w2 / after);
  };
  for (int i = 1; i < count - 1; ++i) m[i * stride] = inner_slope(i - 1, i);
  const int n = count - 1;
  if (around) {
    m[0] = m[n * stride] = inner_slope(n - 1, 0);
    return;
  }
  m[0] = table_slopes_detail::end_slope(h(0), h(1), d(0), d(1));
  m[n * stride] = table_slopes_detail::end_slope(h(n - 1), h(n - 2), d(n - 1), d(n - 2));
}

// Fill the slopes of one smooth block whose values stand at node[i * 2^Smooth]. `scratch` is as large as
// `node`. `around`: the first axis goes once around a circle. Slopes of a set of axes are the mean, over the
// axes of the set taken last, of the slopes along that axis of the slopes of the others.
template <class R, int Smooth>
void fill_slopes(const Axis<R> (&axis)[Smooth], R* node, R* scratch, bool around = false) {
  constexpr std::ptrdiff_t per_node = 1 << Smooth;
  int nodes = 1;
  for (int a = 0; a < Smooth; ++a) nodes *= axis[a].count;
  for (int set = 1; set < per_node; ++set) {
    int members = 0;
    for (int i = 0; i < nodes; ++i) node[i * per_node + set] = R(0);
    for (int a = 0; a < Smooth; ++a) {
      if ((set >> a & 1) == 0) continue;
      ++members;
      const int others = set & ~(1 << a);
      std::ptrdiff_t step = 1;  // nodes between neighbours along axis a
      for (int b = a + 1; b < Smooth; ++b) step *= axis[b].count;
      for (int i = 0; i < nodes; ++i) {
        if (i / step % axis[a].count != 0) continue;  // first node of a line along axis a
        R* line = node + i * per_node;
        monotone_slopes(axis[a].count, axis[a].knot, line + others, scratch, step * per_node,
                        around && a == 0);
        for (int k = 0; k < axis[a].count; ++k)
          line[k * step * per_node + set] += scratch[k * step * per_node];
      }
    }
    for (int i = 0; i < nodes; ++i) node[i * per_node + set] /= static_cast<R>(members);
  }
}

}  // namespace tiltrotor

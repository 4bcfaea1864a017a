// Reflection of three neighbouring rows or columns, as a QR sweep chases its bulge with: whole vectors of the target
// where it has four lanes, numbers elsewhere. The operations of every entry and their order are the same, and so are
// the results.
//
// Rows lie in vectors as they are stored. Of columns four rows are taken at a time: products by row, exchanged for
// sums by row in one vector, which four vectors subtract again.

#pragma once

#include <cstring>

#include "tiltrotor/math/algebra/matrix.hpp"
#include "tiltrotor/math/differentiation/lanes.hpp"

namespace tiltrotor {

// I - g v v^T with v = (v0, v1, v2), and where it takes the first entry.
template <class R>
struct Reflection {
  R v0, v1, v2, g, head;
};

namespace reflecting {

#if defined(__has_builtin) && !defined(TILTROTOR_PORTABLE_LANES)
#if __has_builtin(__builtin_shufflevector)
#define TILTROTOR_SHUFFLES_LANES
#endif
#endif

#if defined(TILTROTOR_SHUFFLES_LANES)
template <class R>
inline constexpr bool kByFours = kWidestLanes<R> >= 4;
#else
template <class R>
inline constexpr bool kByFours = false;
#endif

// Columns that one step over rows takes; the first step begins at a multiple of it.
template <class R>
inline constexpr int kRowGroup = kByFours<R> ? smaller_of(kWidestLanes<R>, kLane<R>) : kLane<R>;
template <class R>
constexpr int group_floor(int i) {
  return i / kRowGroup<R> * kRowGroup<R>;
}
template <class R>
constexpr int group_ceil(int n) {
  return group_floor<R>(n + kRowGroup<R> - 1);
}

template <class R, int Width>
struct Loaded {
  using Lanes = typename LaneType<R, Width>::type;
  static TILTROTOR_INLINE Lanes from(const R* x) {
    Lanes lanes;
    std::memcpy(&lanes, x, sizeof lanes);
    return lanes;
  }
  static TILTROTOR_INLINE void to(R* x, const Lanes& lanes) { std::memcpy(x, &lanes, sizeof lanes); }
};

// Three (two) neighbouring rows from the left, whole groups of columns.
template <class R>
inline void reflect_rows(const Reflection<R>& p, R* __restrict a, R* __restrict b, R* __restrict c, int begin,
                         int end) {
  const R g0 = p.g * p.v0, g1 = p.g * p.v1, g2 = p.g * p.v2;
  if constexpr (kByFours<R>) {
    using Group = Loaded<R, kRowGroup<R>>;
    for (int q = begin; q < end; q += kRowGroup<R>) {
      const auto x = Group::from(a + q), y = Group::from(b + q), z = Group::from(c + q);
      const auto s = p.v0 * x + p.v1 * y + p.v2 * z;
      Group::to(a + q, x - g0 * s);
      Group::to(b + q, y - g1 * s);
      Group::to(c + q, z - g2 * s);
    }
  } else {
    for (int q = begin; q < end; q += kRowGroup<R>)
      for (int l = q; l < q + kRowGroup<R>; ++l) {
        const R s = p.v0 * a[l] + p.v1 * b[l] + p.v2 * c[l];
        a[l] -= g0 * s;
        b[l] -= g1 * s;
        c[l] -= g2 * s;
      }
  }
}
template <class R>
inline void reflect_rows(const Reflection<R>& p, R* __restrict a, R* __restrict b, int begin, int end) {
  const R g0 = p.g * p.v0, g1 = p.g * p.v1;
  for (int q = begin; q < end; q += kRowGroup<R>)
    for (int l = q; l < q + kRowGroup<R>; ++l) {
      const R s = p.v0 * a[l] + p.v1 * b[l];
      a[l] -= g0 * s;
      b[l] -= g1 * s;
    }
}

#if defined(TILTROTOR_SHUFFLES_LANES)
// Of four columns in the lanes of a vector the first three, four rows at a time.
template <class R>
struct FourRows {
  using Four = typename LaneType<R, 4>::type;
  using Load = Loaded<R, 4>;
  Four v, g;

  explicit FourRows(const Reflection<R>& p)
      : v{p.v0, p.v1, p.v2, p.v2}, g{p.g * p.v0, p.g * p.v1, p.g * p.v2, p.g * p.v2} {}

  // v0 x0 + v1 x1 + v2 x2 of each row, in a lane of its own.
  TILTROTOR_INLINE Four sums(const Four& a, const Four& b, const Four& c, const Four& d) const {
    const Four va = v * a, vb = v * b, vc = v * c, vd = v * d;
    const Four ab_even = __builtin_shufflevector(va, vb, 0, 4, 2, 6);
    const Four ab_odd = __builtin_shufflevector(va, vb, 1, 5, 3, 7);
    const Four cd_even = __builtin_shufflevector(vc, vd, 0, 4, 2, 6);
    const Four cd_odd = __builtin_shufflevector(vc, vd, 1, 5, 3, 7);
    return __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5) +
           __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5) +
           __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  }
  // The row with its sum in lane kRow; its fourth column stays.
  template <int kRow>
  TILTROTOR_INLINE Four moved(const Four& x, const Four& s) const {
    const Four all = x - __builtin_shufflevector(s, s, kRow, kRow, kRow, kRow) * g;
    return __builtin_shufflevector(all, x, 0, 1, 2, 7);
  }
  // Up to four rows of a matrix from x on; four are read.
  template <int kStride>
  TILTROTOR_INLINE void reflect(R* x, int rows) const {
    const Four a = Load::from(x), b = Load::from(x + kStride);
    const Four c = Load::from(x + 2 * kStride), d = Load::from(x + 3 * kStride);
    const Four s = sums(a, b, c, d);
    Load::to(x, moved<0>(a, s));
    if (rows > 1) Load::to(x + kStride, moved<1>(b, s));
    if (rows > 2) Load::to(x + 2 * kStride, moved<2>(c, s));
    if (rows > 3) Load::to(x + 3 * kStride, moved<3>(d, s));
  }
};
#endif

// Three (two) neighbouring columns k.. from the right, rows begin..last.
template <class R, int N>
inline void reflect_three_columns(const Reflection<R>& p, PaddedSquare<R, N>& h, int k, int begin, int last) {
  int i = begin;
#if defined(TILTROTOR_SHUFFLES_LANES)
  if constexpr (kByFours<R>) {
    const FourRows<R> rows(p);
    if (k + 3 < h.kStride)
      for (; i + 3 <= last; i += 4) rows.template reflect<PaddedSquare<R, N>::kStride>(h.row(i) + k, 4);
  }
#endif
  const R g0 = p.g * p.v0, g1 = p.g * p.v1, g2 = p.g * p.v2;
  for (; i <= last; ++i) {
    R* x = h.row(i) + k;
    const R s = p.v0 * x[0] + p.v1 * x[1] + p.v2 * x[2];
    x[0] -= g0 * s;
    x[1] -= g1 * s;
    x[2] -= g2 * s;
  }
}
template <class R, int N>
inline void reflect_two_columns(const Reflection<R>& p, PaddedSquare<R, N>& h, int k, int begin, int last) {
  const R g0 = p.g * p.v0, g1 = p.g * p.v1;
  for (int i = begin; i <= last; ++i) {
    R* x = h.row(i) + k;
    const R s = p.v0 * x[0] + p.v1 * x[1];
    x[0] -= g0 * s;
    x[1] -= g1 * s;
  }
}

// Rows k .. k+2 from the left. Column k-1 is `left` in row k and zero below it, unless `left` is null.
template <class R, int N>
inline void reflect_rows_with_left(const Reflection<R>& p, PaddedSquare<R, N>& h, int k, const R* left,
                                   int row_end) {
  // Columns left of the bulge are zero in these rows, so beginning with a whole group is harmless.
  reflect_rows(p, h.row(k), h.row(k + 1), h.row(k + 2), group_floor<R>(k), row_end);
  if (left == nullptr) return;
  h(k, k - 1) = *left;
  h(k + 1, k - 1) = h(k + 2, k - 1) = R(0);
}

// Rows k .. k+2 from the left and columns k .. k+2 from the right, the columns down to row k+3: a step of a sweep inside
// its block. Where the bulge is, rows and columns
// go on in registers: to read there what narrower or shifted stores have just written stalls most processors. Returns
// column k of rows k+1 .. k+3, from which the next step's reflection comes.
template <class R>
struct Bulge {
  R x, y, z;
};
template <class R, int N>
inline Bulge<R> reflect_both(const Reflection<R>& p, PaddedSquare<R, N>& h, int k, const R* left, int row_end,
                             int column_begin) {
#if defined(TILTROTOR_SHUFFLES_LANES)
  if constexpr (kByFours<R>) {
    using Load = Loaded<R, 4>;
    const FourRows<R> rows(p);
    R* const x = h.row(k) + k;
    constexpr int kStride = PaddedSquare<R, N>::kStride;
    auto a = Load::from(x), b = Load::from(x + kStride);
    auto c = Load::from(x + 2 * kStride), d = Load::from(x + 3 * kStride);
    const auto t = p.v0 * a + p.v1 * b + p.v2 * c;
    a = a - p.g * p.v0 * t;
    b = b - p.g * p.v1 * t;
    c = c - p.g * p.v2 * t;
    const auto s = rows.sums(a, b, c, d);
    reflect_rows_with_left<R, N>(p, h, k, left, row_end);
    Load::to(x, rows.template moved<0>(a, s));
    b = rows.template moved<1>(b, s);
    c = rows.template moved<2>(c, s);
    d = rows.template moved<3>(d, s);
    Load::to(x + kStride, b);
    Load::to(x + 2 * kStride, c);
    Load::to(x + 3 * kStride, d);
    for (int i = column_begin; i < k; i += 4) rows.template reflect<kStride>(h.row(i) + k, k - i);
    return {b[0], c[0], d[0]};
  }
#endif
  reflect_rows_with_left<R, N>(p, h, k, left, row_end);
  reflect_three_columns<R, N>(p, h, k, column_begin, k + 3);
  return {h(k + 1, k), h(k + 2, k), h(k + 3, k)};
}

#undef TILTROTOR_SHUFFLES_LANES

}  // namespace reflecting

}  // namespace tiltrotor

// Real Schur form of a Hessenberg matrix by the implicit double-shift QR iteration of Francis, and its
// eigenvalues.
//
// A sweep chases a bulge of two shifts down the active block low..high with reflections of three rows and
// columns. A subdiagonal entry that is negligible against its neighbours is set to zero and splits the block.
#pragma once

#include <cmath>
#include <limits>

#include "tiltrotor/math/algebra/matrix.hpp"
#include "tiltrotor/math/algebra/reflection.hpp"
#include "tiltrotor/math/scalar.hpp"

namespace tiltrotor {

struct FrancisResult {
  int converged;  // eigenvalues found, from the last one upwards
  int sweeps;
};

inline constexpr int kSweepsPerEigenvalue = 30;

namespace francis_detail {

template <class R>
inline constexpr R kEps = std::numeric_limits<R>::epsilon();

// A subdiagonal entry this small counts as zero where its neighbours are not small too: 2^-484 in double
// precision. Squares of larger ones neither vanish nor lose digits; the matrix is scaled so that this is far
// below eps |H|.
template <class R>
constexpr R negligible_size() {
  R size = R(1);
  for (int i = 0; i < (-std::numeric_limits<R>::min_exponent - std::numeric_limits<R>::digits) / 2; ++i)
    size /= R(2);
  return size;
}

// Reflection that takes (x, y, z) to (head, 0, 0).
template <class R>
inline Reflection<R> reflection(R x, R y, R z) {
  constexpr R kSmallestSquare = std::numeric_limits<R>::min() / (kEps<R> * kEps<R>);
  R square = y * y + z * z;
  R scale = R(1);
  if (square < kSmallestSquare) {
    const R largest = larger_of(std::fabs(y), std::fabs(z));
    if (largest == R(0)) return {R(0), R(0), R(0), R(0), x};
    if (std::fabs(x) <= largest / kEps<R>) {  // otherwise x * x dominates and its square is safe
      scale = larger_of(std::fabs(x), largest);
      x /= scale;
      y /= scale;
      z /= scale;
      square = y * y + z * z;
    }
  }
  const R whole = square + x * x;
  const R norm = tiltrotor::sqrt(whole);
  const R size = std::fabs(x);
  if (whole < std::numeric_limits<R>::min()) return {R(0), R(0), R(0), R(0), x};
  const R g = R(1) / (whole + size * norm);
  return {x < R(0) ? x - norm : x + norm, y, z, g, (x < R(0) ? norm : -norm) * scale};
}

// Whether h(k, k-1) may be set to zero: small against the diagonal, and (Ahues and Tisseur) its effect on the
// eigenvalues of the 2x2 block around it is small too, which keeps small eigenvalues of graded matrices
// accurate.
template <class R, int N>
inline bool negligible(const PaddedSquare<R, N>& h, int k) {
  const R below = std::fabs(h(k, k - 1));
  const R a = h(k - 1, k - 1), d = h(k, k);
  const R above = std::fabs(h(k - 1, k));
  constexpr R kZero = negligible_size<R>();
  if (below <= kZero && below <= kEps<R> * (std::fabs(a) + std::fabs(d) + above)) return true;
  if (below > kEps<R> * (std::fabs(a) + std::fabs(d))) return false;
  const R larger = larger_of(below, above), smaller = smaller_of(below, above);
  const R large_diagonal = larger_of(std::fabs(d), std::fabs(a - d));
  const R small_diagonal = smaller_of(std::fabs(d), std::fabs(a - d));
  const R sum = larger + large_diagonal;
  return smaller * (larger / sum) <=
         larger_of(std::numeric_limits<R>::min(), kEps<R> * (small_diagonal * (large_diagonal / sum)));
}

// Eigenvalues that are equal, or nearly, with few eigenvectors: rounding stays alive below the diagonal, where the test
// above asks for zero as their difference does, and drowns the start of a sweep. After so many sweeps without a split an
// entry counts as zero that is small against the block, a change of the matrix by less than rounding all the same, and
// the start is found from differences.
inline constexpr int kSweepsOfPatience = 20;
template <class R, int N>
inline R rounding_of(const PaddedSquare<R, N>& h, int low, int high) {
  R largest = R(0);
  for (int i = low; i <= high; ++i)
    for (int j = i > low ? i - 1 : low; j <= high; ++j) largest = larger_of(largest, std::fabs(h(i, j)));
  return kEps<R> * largest;
}

// The two shifts: roots of z^2 - sum z + product, or of (z - mean)^2 - square.
template <class R>
struct Shifts {
  R sum, product;
  R mean, square;
};

// The factor that brings a block which has been split off back to numbers whose squares do not vanish; nearly
// always 1.
template <class R, int N>
inline R unit_of(const PaddedSquare<R, N>& h, int low, int high) {
  R largest = std::fabs(h(low, low));
  for (int k = low + 1; k <= high; ++k)
    largest = larger_of(larger_of(largest, std::fabs(h(k, k))),
                        larger_of(std::fabs(h(k - 1, k)), std::fabs(h(k, k - 1))));
  constexpr R kSmall = negligible_size<R>() / kEps<R>;
  if (!(largest < kSmall) || largest < std::numeric_limits<R>::min()) return R(1);
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::ldexp(R(1), -exponent);
}

// Eigenvalues of the last 2x2 block; of two real ones the nearer to the last entry twice. Now and then
// arbitrary ones, which break the rare cycles.
template <class R, int N>
inline Shifts<R> shifts(const PaddedSquare<R, N>& block, int low, int high, int since_split, R unit) {
  const auto h = [&](int i, int j) { return block(i, j) * unit; };
  constexpr int kExceptionalEvery = 10;
  R a, b, c, d;
  if (since_split % kExceptionalEvery == kExceptionalEvery - 1) {
    const bool at_top = since_split / kExceptionalEvery % 2 == 0;
    const R size = at_top ? std::fabs(h(low + 1, low)) + std::fabs(h(low + 2, low + 1))
                          : std::fabs(h(high, high - 1)) + std::fabs(h(high - 1, high - 2));
    a = d = R(0.75) * size + (at_top ? h(low, low) : h(high, high));
    b = R(-0.4375) * size;
    c = size;
  } else {
    a = h(high - 1, high - 1);
    b = h(high - 1, high);
    c = h(high, high - 1);
    d = h(high, high);
  }
  const R half = R(0.5) * (a - d);
  const R discriminant = half * half + b * c;
  if (discriminant < R(0)) return {a + d, a * d - b * c, d + half, discriminant};
  // The root of smaller modulus of z^2 - 2 half z - b c, without cancellation.
  const R far = half + (half < R(0) ? -tiltrotor::sqrt(discriminant) : tiltrotor::sqrt(discriminant));
  const R nearest = d + (far == R(0) ? R(0) : -b * c / far);
  return {nearest + nearest, nearest * nearest, nearest, R(0)};
}

// Where a sweep may start, and the first column of (H - s1)(H - s2) there.
template <class R>
struct Start {
  int row;
  R x, y, z;
};

// Below two small subdiagonal entries in succession a start disturbs the entry above it by less than rounding.
template <class R, int N>
inline Start<R> start(const PaddedSquare<R, N>& block, int low, int high, const Shifts<R>& s, R unit,
                      bool by_differences) {
  const auto h = [&](int i, int j) { return block(i, j) * unit; };
  const auto column = [&](int m) -> Start<R> {
    const R a = h(m, m), c = h(m + 1, m);
    if (by_differences) {
      const R away = a - s.mean, next = h(m + 1, m + 1) - s.mean;
      return {m, away * away - s.square + h(m, m + 1) * c, c * (away + next), c * h(m + 2, m + 1)};
    }
    return {m, a * (a - s.sum) + s.product + h(m, m + 1) * c, c * (a + h(m + 1, m + 1) - s.sum),
            c * h(m + 2, m + 1)};
  };
  for (int m = high - 2; m > low; --m) {
    const Start<R> at = column(m);
    const R moved = std::fabs(h(m, m - 1)) * (std::fabs(at.y) + std::fabs(at.z));
    const R size = std::fabs(h(m - 1, m - 1)) + std::fabs(h(m, m)) + std::fabs(h(m + 1, m + 1));
    if (moved <= kEps<R> * std::fabs(at.x) * size) return at;
  }
  return column(low);
}

// One sweep over the active block. Without the basis only the block itself is kept up to date.
template <bool kWithBasis, class R, int N>
inline void sweep(PaddedSquare<R, N>& h, int n, int low, int high, int since_split, R unit,
                  PaddedSquare<R, N>& basis) {
  using namespace reflecting;
  const Shifts<R> s = shifts<R, N>(h, low, high, since_split, unit);  // and the start in units of the block
  auto [first, x, y, z] = start<R, N>(h, low, high, s, unit, since_split >= kSweepsOfPatience);
  const int row_end = group_ceil<R>(kWithBasis ? n : high + 1);
  const int column_begin = kWithBasis ? 0 : low;
  const int basis_end = lane_ceil<R>(n);
  for (int k = first; k <= high - 2; ++k) {
    const Reflection<R> p = reflection(x, y, z);
    // At a start below the top the rest of the column was found negligible.
    const R left = k > first || k == low ? p.head : h(k, k - 1) - p.g * p.v0 * p.v0 * h(k, k - 1);
    const R* const at_left = k > low ? &left : nullptr;
    if (k + 3 <= high) {
      const Bulge<R> next = reflect_both<R, N>(p, h, k, at_left, row_end, column_begin);
      x = next.x;
      y = next.y;
      z = next.z;
    } else {
      reflect_rows_with_left<R, N>(p, h, k, at_left, row_end);
      reflect_three_columns<R, N>(p, h, k, column_begin, high);
      x = h(k + 1, k);
      y = h(k + 2, k);
    }
    if constexpr (kWithBasis) reflect_rows(p, basis.row(k), basis.row(k + 1), basis.row(k + 2), 0, basis_end);
  }
  const int k = high - 1;
  const Reflection<R> p = reflection(x, y, R(0));
  reflect_rows(p, h.row(k), h.row(k + 1), group_floor<R>(k), row_end);
  h(k, k - 1) = p.head;
  h(k + 1, k - 1) = R(0);
  reflect_two_columns<R, N>(p, h, k, column_begin, high);
  if constexpr (kWithBasis) reflect_rows(p, basis.row(k), basis.row(k + 1), 0, basis_end);
}

// Eigenvalues of the 2x2 block at k, k+1, which has been split off. With the basis a block with real
// eigenvalues is made triangular by a rotation.
template <bool kWithBasis, class R, int N>
inline void split_pair(PaddedSquare<R, N>& h, int n, int k, PaddedSquare<R, N>& basis, R* real, R* imag) {
  const R a = h(k, k), b = h(k, k + 1), c = h(k + 1, k), d = h(k + 1, k + 1);
  const R size = larger_of(larger_of(std::fabs(a), std::fabs(b)), larger_of(std::fabs(c), std::fabs(d)));
  const R unit = size >= std::numeric_limits<R>::min() ? R(1) / size : R(1);
  const R half = R(0.5) * (a - d) * unit;
  const R product = (b * unit) * (c * unit);
  const R discriminant = half * half + product;
  if (discriminant < R(0)) {
    const R mean = d + half * size;
    const R frequency = tiltrotor::sqrt(-discriminant) * size;
    real[k] = real[k + 1] = mean;
    imag[k] = frequency;
    imag[k + 1] = -frequency;
    return;
  }
  const R root = tiltrotor::sqrt(discriminant);
  const R far = half + (half < R(0) ? -root : root);  // lambda - d of the eigenvalue farther from d
  const R near = far == R(0) ? R(0) : -product / far;
  real[k] = d + far * size;
  real[k + 1] = d + near * size;
  imag[k] = imag[k + 1] = R(0);
  if constexpr (kWithBasis) {
    // The first basis vector becomes the eigenvector (lambda - d, c) of the farther eigenvalue.
    const R x = far, y = c * unit;
    const R length = tiltrotor::sqrt(x * x + y * y);
    if (length > R(0)) {
      const R cosine = x / length, sine = y / length;
      // Two sums: a sum beside a difference g++ 12 makes a fused operation, in spite of -ffp-contract=off.
      const R minus = -sine;
      const auto rotate_rows = [&](R* p, R* q, int begin, int end) {
        for (int l = begin; l < end; ++l) {
          const R u = p[l], v = q[l];
          p[l] = cosine * u + sine * v;
          q[l] = cosine * v + minus * u;
        }
      };
      rotate_rows(h.row(k), h.row(k + 1), lane_floor<R>(k), lane_ceil<R>(n));
      rotate_rows(basis.row(k), basis.row(k + 1), 0, lane_ceil<R>(n));
      for (int i = 0; i <= k + 1; ++i) {
        const R u = h(i, k), v = h(i, k + 1);
        h(i, k) = cosine * u + sine * v;
        h(i, k + 1) = cosine * v + minus * u;
      }
    }
    h(k, k) = real[k];
    h(k + 1, k + 1) = real[k + 1];
    h(k + 1, k) = R(0);
  }
}

}  // namespace francis_detail

// Eigenvalues of `h`, upper triangular outside low..high and Hessenberg within. With kWithBasis, `h` becomes
// the real Schur form (2x2 blocks only for complex pairs) and `basis` its transposed basis. At most
// kSweepsPerEigenvalue n sweeps; places not reached keep what real and imag held before.
template <bool kWithBasis, class R, int N>
inline FrancisResult francis(Matrix<R, N, lane_ceil<R>(N)>& h, int n, int low, int high,
                             Matrix<R, N, lane_ceil<R>(N)>& basis, R (&real)[N], R (&imag)[N]) {
  for (int k = 0; k < n; ++k)
    if (k < low || k > high) {
      real[k] = h(k, k);
      imag[k] = R(0);
    }
  const int allowed = kSweepsPerEigenvalue * n;
  int sweeps = 0, since_split = 0, last_top = -1;
  R unit = R(1);
  while (high >= low) {  // each pass splits off an eigenvalue or counts a sweep
    int top = high;
    // Below it an entry as small as its neighbours: zero unless the whole block is small.
    int vanishing = low;
    const R late = since_split < francis_detail::kSweepsOfPatience
                       ? R(-1)
                       : francis_detail::rounding_of<R, N>(h, last_top, high);
    while (top > low && !francis_detail::negligible<R, N>(h, top) && !(std::fabs(h(top, top - 1)) <= late)) {
      constexpr R kTiny = francis_detail::negligible_size<R>();  // not a loop of divisions here
      const bool tiny = std::fabs(h(top, top - 1)) <= kTiny;
      vanishing = tiny && top > vanishing ? top : vanishing;
      --top;
    }
    if (vanishing > top && francis_detail::unit_of<R, N>(h, top, high) == R(1)) top = vanishing;
    if (top > low) h(top, top - 1) = R(0);
    if (top == high) {
      real[high] = h(high, high);
      imag[high] = R(0);
      high -= 1;
      since_split = 0;
    } else if (top == high - 1) {
      francis_detail::split_pair<kWithBasis, R, N>(h, n, top, basis, real, imag);
      high -= 2;
      since_split = 0;
    } else {
      if (sweeps == allowed) break;
      if (since_split == 0 || top != last_top) unit = francis_detail::unit_of<R, N>(h, top, high);
      last_top = top;
      francis_detail::sweep<kWithBasis, R, N>(h, n, top, high, since_split, unit, basis);
      ++sweeps;
      ++since_split;
    }
  }
  const int missing = high >= low ? high - low + 1 : 0;
  return {n - missing, sweeps};
}

}  // namespace tiltrotor

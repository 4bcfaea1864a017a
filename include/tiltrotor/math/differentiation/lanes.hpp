// Partials: a short fixed vector of partial derivatives, padded to the lane width of the target.
//
// The lane width is chosen at compile time from the instruction set (AVX-512 64 bytes, AVX 32, SSE2 and
// NEON 16, otherwise one scalar of any precision: pairs of floats without instructions for them double the
// code). With GCC and clang the lanes are compiler vector types; elsewhere, or with
// TILTROTOR_PORTABLE_LANES defined, plain arrays take their place. Each lane sees the same operations in the
// same order in both forms, so the results are the same. Padding lanes start at zero and stay unread.
#pragma once

#include <cstddef>
#include <cstring>

#include "tiltrotor/math/arithmetic.hpp"

// Inlining decides here: small functions on vectors must not pass them through memory; large ones must not
// add their stack to that of their caller.
#if defined(__GNUC__)
#define TILTROTOR_INLINE inline __attribute__((always_inline))
#define TILTROTOR_NOINLINE __attribute__((noinline))
#else
#define TILTROTOR_INLINE inline
#define TILTROTOR_NOINLINE
#endif

namespace tiltrotor {

// Calls a step of a computation apart: what it needs on the stack does not lie below the steps that follow.
template <class Step>
TILTROTOR_NOINLINE void out_of_line(Step&& step) {
  step();
}

#if defined(__AVX512F__)
inline constexpr int kVectorBytes = 64;
#elif defined(__AVX__)
inline constexpr int kVectorBytes = 32;
#elif defined(__SSE2__) || defined(__ARM_NEON)
inline constexpr int kVectorBytes = 16;
#else
inline constexpr int kVectorBytes = 4;
#endif

// Numbers of type R in the widest vector, at least one.
template <class R>
inline constexpr int kWidestLanes = kVectorBytes > static_cast<int>(sizeof(R))
                                        ? kVectorBytes / static_cast<int>(sizeof(R))
                                        : 1;

// Lanes of one vector for `count` partials of type R: the widest the target has, but no wider than needed.
template <class R>
constexpr int lane_width(int count) {
  int width = 1;
  while (width < kWidestLanes<R> && width < count) width *= 2;
  return width;
}

#if defined(__GNUC__) && !defined(TILTROTOR_PORTABLE_LANES)
template <class R, int Width>
struct LaneType {
  typedef R type __attribute__((vector_size(Width * static_cast<int>(sizeof(R)))));
};
#else
template <class R, int Width>
struct alignas(Width * sizeof(R)) PortableLane {
  R e[Width];
  constexpr R operator[](int i) const { return e[i]; }
  constexpr R& operator[](int i) { return e[i]; }
  friend constexpr PortableLane operator+(PortableLane a, const PortableLane& b) {
    for (int i = 0; i < Width; ++i) a.e[i] = a.e[i] + b.e[i];
    return a;
  }
  friend constexpr PortableLane operator-(PortableLane a, const PortableLane& b) {
    for (int i = 0; i < Width; ++i) a.e[i] = a.e[i] - b.e[i];
    return a;
  }
  friend constexpr PortableLane operator*(R s, PortableLane a) {
    for (int i = 0; i < Width; ++i) a.e[i] = s * a.e[i];
    return a;
  }
};
template <class R, int Width>
struct LaneType {
  typedef PortableLane<R, Width> type;
};
#endif
template <class R>
struct LaneType<R, 1> {
  typedef R type;
};

// Partials to be: what stands in group g. Operations return such a rule and the result is built of it where it
// is to stand. A result returned by value would be built, and copied word by word: a third of a Jacobian's work
// on processors without vectors. It refers to its operands: not to be kept.
template <class R, int N, class Group>
struct PartialsRule {
  Group group;
};

template <class R, int N>
struct Partials {
  static constexpr int kWidth = lane_width<R>(N);
  static constexpr int kGroups = (N + kWidth - 1) / kWidth;
  static constexpr int kPadded = kWidth * kGroups;
  using Lane = typename LaneType<R, kWidth>::type;

  Lane group[kGroups];

  // Copied lane group by lane group: a copy in smaller pieces, as a compiler may make it, is slow to read
  // back whole.
  Partials() = default;
  TILTROTOR_INLINE Partials(const Partials& other) {
    for (int g = 0; g < kGroups; ++g) group[g] = other.group[g];
  }
  TILTROTOR_INLINE Partials& operator=(const Partials& other) {
    for (int g = 0; g < kGroups; ++g) group[g] = other.group[g];
    return *this;
  }

  template <class Group>
  TILTROTOR_INLINE Partials(const PartialsRule<R, N, Group>& rule) {  // NOLINT(google-explicit-constructor)
    for (int g = 0; g < kGroups; ++g) group[g] = rule.group(g);
  }
  template <class Group>
  TILTROTOR_INLINE Partials& operator=(const PartialsRule<R, N, Group>& rule) {
    for (int g = 0; g < kGroups; ++g) group[g] = rule.group(g);
    return *this;
  }

  static TILTROTOR_INLINE auto zero() {
    return rule([](int) { return Lane{}; });
  }

  R get(int i) const {
    if constexpr (kWidth == 1) {
      return group[i];
    } else {
      return group[i / kWidth][i % kWidth];
    }
  }
  void set(int i, R x) {
    if constexpr (kWidth == 1) {
      group[i] = x;
    } else {
      group[i / kWidth][i % kWidth] = x;
    }
  }

  // All of them in a row, where they are: vectors of a compiler, or plain arrays, stand without gaps and may be read as what
  // they are made of;
  const R* row() const {
    static_assert(sizeof group == kPadded * sizeof(R));
    return reinterpret_cast<const R*>(group);
  }
  // or copied: one by one, each would cost the search for its group.
  void copy_to(R (&to)[N]) const { std::memcpy(to, group, sizeof to); }
  // The first `count`; the others are zero.
  void copy_from(const R* from, int count) {
    for (int g = 0; g < kGroups; ++g) group[g] = Lane{};
    if (count > 0) std::memcpy(group, from, static_cast<std::size_t>(count) * sizeof(R));
  }

  // s a
  TILTROTOR_INLINE friend auto scaled(R s, const Partials& a) {
    return rule([s, &a](int g) { return s * a.group[g]; });
  }
  // s a + t b
  TILTROTOR_INLINE friend auto combined(R s, const Partials& a, R t, const Partials& b) {
    return rule([s, &a, t, &b](int g) { return s * a.group[g] + t * b.group[g]; });
  }
  TILTROTOR_INLINE friend auto operator+(const Partials& a, const Partials& b) {
    return rule([&a, &b](int g) { return a.group[g] + b.group[g]; });
  }
  TILTROTOR_INLINE friend auto operator-(const Partials& a, const Partials& b) {
    return rule([&a, &b](int g) { return a.group[g] - b.group[g]; });
  }

 private:
  template <class Group>
  static TILTROTOR_INLINE PartialsRule<R, N, Group> rule(Group group) {
    return {group};
  }
};

}  // namespace tiltrotor

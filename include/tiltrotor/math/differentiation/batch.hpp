// Batch: several plain numbers computed together, as many as the target's vectors hold.
//
// A batch is a scalar of the model like any other: the formulas of a blade element, written once, run on one
// number, on a batch, or on a dual number whose value and partials are batches. Each lane sees the operations of
// a plain number in the same order, so its result is the plain result bit for bit, whatever the number of
// lanes. Decisions are made lane by lane with select(): both sides are computed.
#pragma once

#include <cmath>
#include <cstddef>
#include <utility>

#include "tiltrotor/math/differentiation/dual.hpp"
#include "tiltrotor/math/differentiation/lanes.hpp"

namespace tiltrotor {

template <class R>
inline constexpr int kBatchLanes = kWidestLanes<R>;

namespace batch_detail {

// Whole numbers as wide as R: indices, and truth as -1 or 0.
template <class R>
struct IndexOf {
  using type = long long;
};
template <>
struct IndexOf<float> {
  using type = int;
};

template <class E, int Lanes>
struct ArrayLanes {
  E e[Lanes];
  constexpr E operator[](int i) const { return e[i]; }
  constexpr E& operator[](int i) { return e[i]; }
};

#if defined(__GNUC__) && !defined(TILTROTOR_PORTABLE_LANES)
inline constexpr bool kCompilerVectors = true;
template <class E, int Lanes>
struct BatchStorage {
  typedef E type __attribute__((vector_size(Lanes * static_cast<int>(sizeof(E)))));
};
template <class E>
struct BatchStorage<E, 1> {
  typedef ArrayLanes<E, 1> type;
};
#else
inline constexpr bool kCompilerVectors = false;
template <class E, int Lanes>
struct BatchStorage {
  typedef ArrayLanes<E, Lanes> type;
};
#endif

}  // namespace batch_detail

// Body of an operation: on whole vectors where the compiler has them, else lane by lane.
#define TILTROTOR_LANEWISE(RESULT, WHOLE, LANE)                 \
  if constexpr (batch_detail::kCompilerVectors && kLanes > 1) { \
    return {WHOLE};                                             \
  } else {                                                      \
    RESULT r;                                                   \
    for (int i = 0; i < kLanes; ++i) r.e[i] = LANE;             \
    return r;                                                   \
  }

// Indices into an array, one for each lane. Plain integers: addresses are computed one by one on every
// target.
template <class R>
struct BatchIndex {
  static constexpr int kLanes = kBatchLanes<R>;
  std::ptrdiff_t e[kLanes];

  // {of(0), of(1), ...}: written out at once, so that no lane goes through memory.
  template <class Of>
  TILTROTOR_INLINE static BatchIndex each(Of&& of) {
    return of_lanes(of, std::make_integer_sequence<int, kLanes>());
  }
  TILTROTOR_INLINE friend BatchIndex operator+(const BatchIndex& a, const BatchIndex& b) {
    return each([&](int i) { return a.e[i] + b.e[i]; });
  }
  TILTROTOR_INLINE friend BatchIndex operator*(const BatchIndex& a, int factor) {
    return each([&](int i) { return a.e[i] * factor; });
  }

 private:
  template <class Of, int... Lane>
  TILTROTOR_INLINE static BatchIndex of_lanes(Of& of, std::integer_sequence<int, Lane...>) {
    return {{of(Lane)...}};
  }
};

// Truth of each lane: -1 or 0.
template <class R>
struct BatchMask {
  static constexpr int kLanes = kBatchLanes<R>;
  using I = typename batch_detail::IndexOf<R>::type;
  typename batch_detail::BatchStorage<I, kLanes>::type e;

  TILTROTOR_INLINE friend BatchMask operator&(const BatchMask& a, const BatchMask& b){
      TILTROTOR_LANEWISE(BatchMask, a.e& b.e, a.e[i] & b.e[i])} TILTROTOR_INLINE friend BatchMask
  operator|(const BatchMask& a,
            const BatchMask& b){TILTROTOR_LANEWISE(BatchMask, a.e | b.e, a.e[i] | b.e[i])} TILTROTOR_INLINE
      friend bool any(const BatchMask& a) {
#if defined(__AVX__) && !defined(TILTROTOR_PORTABLE_LANES)
    typedef long long Whole __attribute__((vector_size(32)));
    if constexpr (sizeof(a.e) == sizeof(Whole))  // one instruction instead of ten
      return __builtin_ia32_ptestz256(reinterpret_cast<Whole>(a.e), reinterpret_cast<Whole>(a.e)) == 0;
#endif
    I all = 0;
    for (int i = 0; i < kLanes; ++i) all |= a.e[i];
    return all != 0;
  }
};

template <class R>
struct Batch {
  static constexpr int kLanes = kBatchLanes<R>;
  using I = typename batch_detail::IndexOf<R>::type;
  using Mask = BatchMask<R>;
  typename batch_detail::BatchStorage<R, kLanes>::type e;

  Batch() = default;
  Batch(R x) {  // NOLINT(google-explicit-constructor): the same number in every lane
    if constexpr (batch_detail::kCompilerVectors && kLanes > 1) {
      e = x - decltype(e){};
    } else {
      for (int i = 0; i < kLanes; ++i) e[i] = x;
    }
  }
  explicit Batch(const typename batch_detail::BatchStorage<R, kLanes>::type& lanes) : e(lanes) {}

  R get(int lane) const { return e[lane]; }
  void set(int lane, R x) { e[lane] = x; }

  TILTROTOR_INLINE friend Batch operator-(const Batch& a){
      TILTROTOR_LANEWISE(Batch, Batch(-a.e), -a.e[i])} TILTROTOR_INLINE friend Batch
  operator+(const Batch& a, const Batch& b){
      TILTROTOR_LANEWISE(Batch, Batch(a.e + b.e), a.e[i] + b.e[i])} TILTROTOR_INLINE friend Batch
  operator-(const Batch& a, const Batch& b){
      TILTROTOR_LANEWISE(Batch, Batch(a.e - b.e), a.e[i] - b.e[i])} TILTROTOR_INLINE friend Batch
  operator*(const Batch& a, const Batch& b){
      TILTROTOR_LANEWISE(Batch, Batch(a.e* b.e), a.e[i] * b.e[i])} TILTROTOR_INLINE friend Batch
  operator/(const Batch& a,
            const Batch& b){TILTROTOR_LANEWISE(Batch, Batch(a.e / b.e), a.e[i] / b.e[i])} Batch&
  operator+=(const Batch& b) {
    return *this = *this + b;
  }
  Batch& operator-=(const Batch& b) { return *this = *this - b; }

  TILTROTOR_INLINE friend Mask operator<(const Batch& a, const Batch& b){
      TILTROTOR_LANEWISE(Mask, a.e < b.e, -static_cast<I>(a.e[i] < b.e[i]))} TILTROTOR_INLINE friend Mask
  operator>(const Batch& a, const Batch& b) {
    return b < a;
  }
  TILTROTOR_INLINE friend Mask operator<=(const Batch& a, const Batch& b){
      TILTROTOR_LANEWISE(Mask, a.e <= b.e, -static_cast<I>(a.e[i] <= b.e[i]))} TILTROTOR_INLINE friend Mask
  operator>=(const Batch& a, const Batch& b) {
    return b <= a;
  }
  TILTROTOR_INLINE friend Mask operator==(const Batch& a, const Batch& b){
      TILTROTOR_LANEWISE(Mask, a.e == b.e, -static_cast<I>(a.e[i] == b.e[i]))}

  TILTROTOR_INLINE friend Batch select(const Mask& m, const Batch& a, const Batch& b) {
    TILTROTOR_LANEWISE(Batch, Batch(m.e ? a.e : b.e), m.e[i] != 0 ? a.e[i] : b.e[i])
  }
};

#undef TILTROTOR_LANEWISE

// The dual number of the chosen side.
template <class R, int N>
TILTROTOR_INLINE Dual<Batch<R>, N> select(const BatchMask<R>& m, const Dual<Batch<R>, N>& a,
                                          const Dual<Batch<R>, N>& b) {
  Dual<Batch<R>, N> r;
  r.v = select(m, a.v, b.v);
  for (int g = 0; g < Partials<Batch<R>, N>::kGroups; ++g)
    r.d.group[g] = select(m, a.d.group[g], b.d.group[g]);
  return r;
}

// array[index] in each lane.
namespace batch_detail {

template <class R, int... Lane>
TILTROTOR_INLINE Batch<R> gather_lanes(const R* array, const BatchIndex<R>& index,
                                       std::integer_sequence<int, Lane...>) {
  Batch<R> r;
  ((r.e[Lane] = array[index.e[Lane]]),
   ...);  // one by one: faster than the gather instructions of many processors
  return r;
}

}  // namespace batch_detail

template <class R>
TILTROTOR_INLINE Batch<R> gather(const R* array, const BatchIndex<R>& index) {
  return batch_detail::gather_lanes(array, index, std::make_integer_sequence<int, kBatchLanes<R>>());
}

// out[k] = array[index + k] in each lane, k = 0 .. 3.
template <class R>
TILTROTOR_INLINE void gather_four(const R* array, const BatchIndex<R>& index, Batch<R>* out) {
  for (int k = 0; k < 4; ++k) out[k] = gather(array + k, index);
}
#if defined(__has_builtin) && !defined(TILTROTOR_PORTABLE_LANES)
#if __has_builtin(__builtin_shufflevector) && defined(__AVX__)
// Whole rows loaded and transposed.
TILTROTOR_INLINE void gather_four(const double* array, const BatchIndex<double>& index, Batch<double>* out) {
  typedef double Row __attribute__((vector_size(32)));
  const auto row = [&](int lane) {
    Row r;
    __builtin_memcpy(&r, array + index.e[lane], sizeof r);
    return r;
  };
#if defined(__AVX512F__)
  const auto both = [&](int lane) {
    return __builtin_shufflevector(row(lane), row(lane + 4), 0, 1, 2, 3, 4, 5, 6, 7);
  };
  const auto a = both(0);
  const auto b = both(1);
  const auto c = both(2);
  const auto d = both(3);
  const auto ab_even = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
  const auto ab_odd = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
  const auto cd_even = __builtin_shufflevector(c, d, 0, 8, 2, 10, 4, 12, 6, 14);
  const auto cd_odd = __builtin_shufflevector(c, d, 1, 9, 3, 11, 5, 13, 7, 15);
  out[0].e = __builtin_shufflevector(ab_even, cd_even, 0, 1, 8, 9, 4, 5, 12, 13);
  out[1].e = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 8, 9, 4, 5, 12, 13);
  out[2].e = __builtin_shufflevector(ab_even, cd_even, 2, 3, 10, 11, 6, 7, 14, 15);
  out[3].e = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 10, 11, 6, 7, 14, 15);
#else
  const auto ab_even = __builtin_shufflevector(row(0), row(1), 0, 4, 2, 6);
  const auto ab_odd = __builtin_shufflevector(row(0), row(1), 1, 5, 3, 7);
  const auto cd_even = __builtin_shufflevector(row(2), row(3), 0, 4, 2, 6);
  const auto cd_odd = __builtin_shufflevector(row(2), row(3), 1, 5, 3, 7);
  out[0].e = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  out[1].e = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  out[2].e = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  out[3].e = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
#endif
}
#endif
#endif

template <class R>
SineCosine<Batch<R>> sine_and_cosine(const Batch<R>& x) {
  return sine_cosine(x);
}

template <class R>
struct ScalarTraits<Batch<R>> {
  using Real = R;
  using T = Batch<R>;
  static T value(const T& x) { return x; }
  static T sqrt(const T& x) {
    T r;
    for (int i = 0; i < T::kLanes; ++i) r.e[i] = ScalarTraits<R>::sqrt(x.e[i]);
    return r;
  }
  static T sin(const T& x) { return sine_cosine(x).sine; }
  static T cos(const T& x) { return sine_cosine(x).cosine; }
  // A call from the loop over elements would pass vectors, and what stands in others, through memory.
  static TILTROTOR_INLINE T atan2(const T& y, const T& x) {
    if constexpr (T::kLanes > 1) {
      return arctangent2_here(y, x);
    } else {
      return arctangent2(y, x);
    }
  }
  static constexpr bool kTakesSlopes = false;
};

}  // namespace tiltrotor

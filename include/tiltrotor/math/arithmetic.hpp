// The arithmetic that every promise of this library rests on: each operation rounds once, to nearest, and is
// done as written. Compiled otherwise, the same formulas give other numbers without a word.
//
// Refused here, when compiled: -ffast-math and each of its parts that the compiler tells (g++ all that change
// values, clang++ -ffast-math and -ffinite-math-only), and excess precision (x87).
// Told by no macro of g++ or clang++, hence looked for at run time by prepare(): fused multiply-add (g++
// fuses wherever the processor can unless told -ffp-contract=off, which `pkg-config --cflags tiltrotor`
// does), and the processor's rounding mode. Not looked for: flush-to-zero, which acts on numbers below 1.2e-38
// in single and 2.3e-308 in double precision only.
#pragma once

#include <limits>

// __GCC_IEC_559 tells of every part, but is 0 as well where a processor computes only single precision.
#if defined(__arm__) && !(defined(__ARM_FP) && (__ARM_FP & 8))
#define TILTROTOR_DOUBLE_IN_SOFTWARE 1
#else
#define TILTROTOR_DOUBLE_IN_SOFTWARE 0
#endif
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) ||             \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__) || \
    (defined(__GCC_IEC_559) && __GCC_IEC_559 == 0 && !TILTROTOR_DOUBLE_IN_SOFTWARE)
#error "tiltrotor needs IEEE arithmetic: compile without -ffast-math, -Ofast and their parts"
#endif
#undef TILTROTOR_DOUBLE_IN_SOFTWARE
// 16: only half precision, which is not used, is widened.
#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0 && __FLT_EVAL_METHOD__ != 16
#error \
    "tiltrotor needs one rounding an operation: compile without excess precision (x86: -msse2 -mfpmath=sse)"
#endif

namespace tiltrotor {

// False where a rounding mode other than to nearest, a second rounding or a fused multiply-add is found.
// Cost: 4 additions, 1 multiplication.
template <class R>
bool rounds_once_to_nearest() {
  static_assert(std::numeric_limits<R>::is_iec559 && std::numeric_limits<R>::radix == 2);
  constexpr R step = std::numeric_limits<R>::epsilon();
  // Volatile: neither the operations nor their order may be anticipated.
  volatile const R one = R(1);
  volatile const R half = step / 2;                               // a tie, goes to the even number: 1
  volatile const R more = step / 2 * (R(1) + R(1) / R(1 << 12));  // above the tie, unless rounded twice
  volatile const R factor = R(1) + step;                          // its square is 1 + 2 step + step^2
  volatile const R square = R(1) + 2 * step;
  volatile const R tie = one + half;
  volatile const R up = one + more;
  volatile const R down = -one - more;
  const R a = factor;
  volatile const R rest = a * a - square;
  return tie == R(1) && up == R(1) + step && down == -(R(1) + step) && rest == R(0);
}

}  // namespace tiltrotor

// The arithmetic that every promise of this library rests on: each operation rounds once, to nearest, keeps the
// smallest numbers, and is done as written. Compiled otherwise, the same formulas give other numbers without a
// word.
//
// Refused here, when compiled: -ffast-math and each of its parts that the compiler tells (g++ all that change
// values, clang++ -ffast-math and -ffinite-math-only), constants cut to single precision, and excess precision
// (x87).
// Told by no macro of g++ or clang++, hence looked for at run time by prepare(), in what the optimiser made of
// samples: fused multiply-add (g++ fuses wherever the processor can unless told -ffp-contract=off, which
// `pkg-config --cflags tiltrotor` does), the other parts of -ffast-math of clang++ (-fassociative-math,
// -freciprocal-math, -fno-signed-zeros, -fno-honor-nans), and the processor's modes: rounding, flush-to-zero and
// denormals-are-zero.
// What cannot be found: -fapprox-func and -fno-honor-infinities of clang++ where they change no sample, and a
// sample that the linker took from another file of the program, compiled with other flags.
#pragma once

#include <cmath>
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

static_assert(0.1 - static_cast<double>(0.1f) != 0,
              "tiltrotor needs constants in double precision: compile without -fsingle-precision-constant");

namespace arithmetic_detail {

// Volatile: neither the operations nor their order may be anticipated. Operands are copied to plain numbers where
// the optimiser shall do with them what it does everywhere.
template <class R>
bool rounds_once_to_nearest() {
  constexpr R step = std::numeric_limits<R>::epsilon();
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

template <class R>
bool computes_as_written() {
  volatile const R given[] = {R(1), std::numeric_limits<R>::epsilon() / 2, R(-0.0),
                              R(5), std::numeric_limits<R>::quiet_NaN(),   R(2)};
  const R one = given[0], small = given[1], zero = given[2], five = given[3], none = given[4], two = given[5];
  volatile const R three = R(3);
  volatile const R dividend = five;
  volatile const R associated = (one + small) - one;  // `small` where the ones cancel first
  volatile const R sum = zero + R(0);                 // -0 where the sign of zero does not matter
  volatile const R quotient = five / R(3);            // another number as 5 times the rounded 1/3
  volatile const bool equal = none == none;
  volatile const R root = std::sqrt(two);
  return associated == R(0) && !std::signbit(static_cast<R>(sum)) && quotient == dividend / three && !equal &&
         root == R(1.41421356237309504880L);
}

template <class R>
bool keeps_small_numbers() {
  volatile const R least_normal = std::numeric_limits<R>::min();
  volatile const R smaller = least_normal / 2;
  return smaller * 2 == least_normal;
}

}  // namespace arithmetic_detail

// False where the arithmetic is not as above. Cost: about 20 operations, two of them divisions.
template <class R>
bool is_ieee_arithmetic() {
  static_assert(std::numeric_limits<R>::is_iec559 && std::numeric_limits<R>::radix == 2);
  using namespace arithmetic_detail;
  return rounds_once_to_nearest<R>() && computes_as_written<R>() && keeps_small_numbers<R>();
}

}  // namespace tiltrotor

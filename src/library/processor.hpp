// Instructions beyond those every processor of its kind has: what a file is compiled for, what the processor
// runs.
#pragma once

namespace tiltrotor {

// ONE(place, name, macro of a file compiled for it, whether this processor has it). What came to all
// processors together with one of these, as lzcnt with bmi2, needs no line.
#if defined(__x86_64__) || defined(__i386__)
#define TILTROTOR_INSTRUCTIONS(ONE)                                                   \
  ONE(sse3, "sse3", __SSE3__, __builtin_cpu_supports("sse3"))                         \
  ONE(ssse3, "ssse3", __SSSE3__, __builtin_cpu_supports("ssse3"))                     \
  ONE(sse4_1, "sse4.1", __SSE4_1__, __builtin_cpu_supports("sse4.1"))                 \
  ONE(sse4_2, "sse4.2", __SSE4_2__, __builtin_cpu_supports("sse4.2"))                 \
  ONE(popcnt, "popcnt", __POPCNT__, __builtin_cpu_supports("popcnt"))                 \
  ONE(avx, "avx", __AVX__, __builtin_cpu_supports("avx"))                             \
  ONE(avx2, "avx2", __AVX2__, __builtin_cpu_supports("avx2"))                         \
  ONE(fma, "fma", __FMA__, __builtin_cpu_supports("fma"))                             \
  ONE(fma4, "fma4", __FMA4__, __builtin_cpu_supports("fma4"))                         \
  ONE(xop, "xop", __XOP__, __builtin_cpu_supports("xop"))                             \
  ONE(bmi, "bmi", __BMI__, __builtin_cpu_supports("bmi"))                             \
  ONE(bmi2, "bmi2", __BMI2__, __builtin_cpu_supports("bmi2"))                         \
  ONE(avx512f, "avx512f", __AVX512F__, __builtin_cpu_supports("avx512f"))             \
  ONE(avx512cd, "avx512cd", __AVX512CD__, __builtin_cpu_supports("avx512cd"))         \
  ONE(avx512bw, "avx512bw", __AVX512BW__, __builtin_cpu_supports("avx512bw"))         \
  ONE(avx512dq, "avx512dq", __AVX512DQ__, __builtin_cpu_supports("avx512dq"))         \
  ONE(avx512vl, "avx512vl", __AVX512VL__, __builtin_cpu_supports("avx512vl"))         \
  ONE(avx512ifma, "avx512ifma", __AVX512IFMA__, __builtin_cpu_supports("avx512ifma")) \
  ONE(avx512vbmi, "avx512vbmi", __AVX512VBMI__, __builtin_cpu_supports("avx512vbmi")) \
  ONE(avx512vpopcntdq, "avx512vpopcntdq", __AVX512VPOPCNTDQ__, __builtin_cpu_supports("avx512vpopcntdq"))
#elif defined(__aarch64__) && defined(__linux__)
#define TILTROTOR_INSTRUCTIONS(ONE)                                          \
  ONE(sve, "sve", __ARM_FEATURE_SVE, (getauxval(AT_HWCAP) & HWCAP_SVE) != 0) \
  ONE(sve2, "sve2", __ARM_FEATURE_SVE2, (getauxval(AT_HWCAP2) & HWCAP2_SVE2) != 0)
#elif defined(__arm__) && defined(__linux__)
#define TILTROTOR_INSTRUCTIONS(ONE) ONE(neon, "neon", __ARM_NEON, (getauxval(AT_HWCAP) & HWCAP_NEON) != 0)
#else
#define TILTROTOR_INSTRUCTIONS(ONE)
#endif

#define TILTROTOR_PLACE(place, name, macro, here) place,
enum class InstructionPlace : unsigned { TILTROTOR_INSTRUCTIONS(TILTROTOR_PLACE) count };
#undef TILTROTOR_PLACE
inline constexpr unsigned kInstructionCount = static_cast<unsigned>(InstructionPlace::count);
constexpr unsigned instruction_bit(InstructionPlace place) { return 1u << static_cast<unsigned>(place); }

// What the library and the program are compiled for; what this processor has: one bit each. All that is
// declared here is constant, or compiled without -march so that it can answer everywhere.
extern const unsigned compiled_instructions;
unsigned processor_instructions();

// The first of `compiled` that is not among `available`, by the compiler's name; nullptr: none.
const char* missing_instructions(unsigned compiled, unsigned available);

}  // namespace tiltrotor

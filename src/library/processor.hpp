// Instructions beyond those every processor of its kind has: what a file is compiled for, what the processor
// runs.
#pragma once

namespace tiltrotor {

enum : unsigned { kAvx = 1, kAvx2 = 2, kFma = 4, kAvx512f = 8, kAvx512dq = 16, kAvx512vl = 32, kBmi2 = 64 };

// Of the file that includes this.
inline constexpr unsigned kInstructions = 0
#ifdef __AVX__
                                          | kAvx
#endif
#ifdef __AVX2__
                                          | kAvx2
#endif
#ifdef __FMA__
                                          | kFma
#endif
#ifdef __AVX512F__
                                          | kAvx512f
#endif
#ifdef __AVX512DQ__
                                          | kAvx512dq
#endif
#ifdef __AVX512VL__
                                          | kAvx512vl
#endif
#ifdef __BMI2__
                                          | kBmi2
#endif
    ;

// The first of `instructions` that this processor lacks, by the compiler's name; nullptr: none. Compiled
// without -march, so that it can answer everywhere.
const char* missing_instructions(unsigned instructions);

inline bool processor_runs(unsigned instructions) {
  return instructions == 0 || missing_instructions(instructions) == nullptr;
}

}  // namespace tiltrotor

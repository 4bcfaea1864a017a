#include "library/processor.hpp"

namespace tiltrotor {

const char* missing_instructions([[maybe_unused]] unsigned instructions) {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_cpu_init();
  if ((instructions & kAvx) && !__builtin_cpu_supports("avx")) return "avx";
  if ((instructions & kAvx2) && !__builtin_cpu_supports("avx2")) return "avx2";
  if ((instructions & kFma) && !__builtin_cpu_supports("fma")) return "fma";
  if ((instructions & kAvx512f) && !__builtin_cpu_supports("avx512f")) return "avx512f";
  if ((instructions & kAvx512dq) && !__builtin_cpu_supports("avx512dq")) return "avx512dq";
  if ((instructions & kAvx512vl) && !__builtin_cpu_supports("avx512vl")) return "avx512vl";
  if ((instructions & kBmi2) && !__builtin_cpu_supports("bmi2")) return "bmi2";
#endif
  return nullptr;
}

}  // namespace tiltrotor

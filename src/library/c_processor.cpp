#include "library/processor.hpp"

#if (defined(__aarch64__) || defined(__arm__)) && defined(__linux__)
#include <asm/hwcap.h>
#include <sys/auxv.h>
#endif

namespace tiltrotor {

unsigned processor_instructions() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_cpu_init();
#endif
#define TILTROTOR_HERE(place, name, macro, here) | ((here) ? instruction_bit(InstructionPlace::place) : 0u)
  return 0u TILTROTOR_INSTRUCTIONS(TILTROTOR_HERE);
#undef TILTROTOR_HERE
}

const char* missing_instructions([[maybe_unused]] unsigned compiled, [[maybe_unused]] unsigned available) {
#define TILTROTOR_NAME(place, name, macro, here) \
  if (compiled & ~available & instruction_bit(InstructionPlace::place)) return name;
  TILTROTOR_INSTRUCTIONS(TILTROTOR_NAME)
#undef TILTROTOR_NAME
  return nullptr;
}

}  // namespace tiltrotor

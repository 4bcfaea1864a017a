#include "library/processor.hpp"

namespace tiltrotor {

// A macro that is not defined stays a word.
#define TILTROTOR_WORD(macro) #macro
#define TILTROTOR_COMPILED(place, name, macro, here) \
  | (TILTROTOR_WORD(macro)[0] == '1' ? instruction_bit(InstructionPlace::place) : 0u)
constexpr unsigned kInstructions = 0u TILTROTOR_INSTRUCTIONS(TILTROTOR_COMPILED);
const unsigned compiled_instructions = kInstructions;

}  // namespace tiltrotor

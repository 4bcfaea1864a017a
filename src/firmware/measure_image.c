/* Instruction counts as a firmware image. */
#include "firmware/board.h"
#include "firmware/measure.h"

#ifndef MEASURED_STATES
#define MEASURED_STATES 1000
#endif

int image(void) {
  int failed;
  board_start_counter();
  failed = measure(board_write, board_instructions, MEASURED_STATES);
  write_count(board_write, "deepest_stack_bytes", board_deepest_stack());
  return failed;
}

/* Instruction counts as a firmware image. */
#include "firmware/board.h"
#include "firmware/measure.h"

int image(void) {
  int failed;
  board_start_counter();
  failed = measure(board_write, board_instructions, board_number(1000));
  write_count(board_write, "deepest_stack_bytes", board_deepest_stack());
  return failed;
}

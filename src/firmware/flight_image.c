/* The reference flight as a firmware image. */
#include "firmware/board.h"
#include "firmware/reference_flight.h"

int image(void) {
  const int failed = reference_flight(board_write, board_number(REFERENCE_FRAMES));
  write_count(board_write, "deepest_stack_bytes", board_deepest_stack());
  return failed;
}

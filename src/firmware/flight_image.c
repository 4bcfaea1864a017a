/* The reference flight as a firmware image. */
#include "firmware/board.h"
#include "firmware/reference_flight.h"

#ifndef FIRMWARE_FRAMES
#define FIRMWARE_FRAMES REFERENCE_FRAMES
#endif

int image(void) {
  const int failed = reference_flight(board_write, FIRMWARE_FRAMES);
  write_count(board_write, "deepest_stack_bytes", board_deepest_stack());
  return failed;
}

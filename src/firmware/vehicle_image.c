/* The flight of the complete vehicle as a firmware image. */
#include "firmware/board.h"
#include "firmware/vehicle_flight.h"

int image(void) {
  int failed;
  write_precision(board_write);
  failed = vehicle_flight(board_write, board_number(REFERENCE_FRAMES));
  write_count(board_write, "deepest_stack_bytes", board_deepest_stack());
  return failed;
}

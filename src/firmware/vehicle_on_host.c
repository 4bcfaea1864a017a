/* The flight of the complete vehicle on a machine with an operating system. Argument: frames, 600 unless given. */
#include <stdio.h>
#include <stdlib.h>

#include "firmware/vehicle_flight.h"

static void write_stdout(const char* text) { fputs(text, stdout); }

int main(int count, char** arguments) {
  write_precision(write_stdout);
  return vehicle_flight(write_stdout, count > 1 ? atoi(arguments[1]) : REFERENCE_FRAMES);
}

/* The reference flight on a machine with an operating system. Argument: frames, 600 unless given. */
#include <stdio.h>
#include <stdlib.h>

#include "firmware/reference_flight.h"

static void write_stdout(const char* text) { fputs(text, stdout); }

int main(int count, char** arguments) {
  return reference_flight(write_stdout, count > 1 ? atoi(arguments[1]) : REFERENCE_FRAMES);
}

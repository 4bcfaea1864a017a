/* The little that an image needs of an Arm MPS2 board and of semihosting. */
#ifndef TILTROTOR_BOARD_H
#define TILTROTOR_BOARD_H

#include <stdint.h>

void board_write(const char* text);
/* The number given to emulate.sh, or another one. */
int board_number(int otherwise);
/* Instructions since the counter was started. The emulator must run with -icount shift=5: an instruction
 * takes 32 ns of the board's time, a tick of its 25 MHz timer 40 ns; reads are exact to 2 instructions. */
void board_start_counter(void);
uint32_t board_instructions(void);
/* Bytes of the stack that have ever been written. */
uint32_t board_deepest_stack(void);

/* What the image does; the result is its exit status. */
int image(void);

#endif

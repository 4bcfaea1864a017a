/* Start-up of a Cortex-M4F or M7 on an Arm MPS2 board: vectors, FPU, memory, output by semihosting. */
#include "firmware/board.h"

extern uint32_t stack_bottom[], stack_top[];
extern uint32_t data_in_rom[], data_start[], data_end[], bss_start[], bss_end[];

#define UNUSED_STACK 0xa5a5a5a5u

enum { SEMIHOSTING_WRITE0 = 0x04, SEMIHOSTING_COMMAND_LINE = 0x15, SEMIHOSTING_EXIT = 0x20 };

static int semihosting(int operation, const void* argument) {
  register int r0 __asm__("r0") = operation;
  register const void* r1 __asm__("r1") = argument;
  __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

void board_write(const char* text) { semihosting(SEMIHOSTING_WRITE0, text); }

/* The last word of the command line that the emulator was given for the image. */
int board_number(int otherwise) {
  static char text[80];
  struct {
    char* text;
    uint32_t length;
  } line = {text, sizeof text - 1};
  int number = 0;
  int digits = 0;
  const char* c;
  if (semihosting(SEMIHOSTING_COMMAND_LINE, &line) != 0) return otherwise;
  for (c = text; *c != '\0'; ++c) {
    if (*c == ' ') number = digits = 0;
    if (*c >= '0' && *c <= '9' && digits < 9) number = 10 * number + (*c - '0'), ++digits;
  }
  return digits > 0 ? number : otherwise;
}

static void leave(uint32_t status) {
  const uint32_t application_exit[2] = {0x20026u, status};
  semihosting(SEMIHOSTING_EXIT, application_exit);
  for (;;) {
  }
}

/* CMSDK timer 0: counts down from the reload value. */
#define TIMER_CONTROL (*(volatile uint32_t*)0x40000000u)
#define TIMER_VALUE (*(volatile uint32_t*)0x40000004u)
#define TIMER_RELOAD (*(volatile uint32_t*)0x40000008u)

void board_start_counter(void) {
  TIMER_RELOAD = 0xffffffffu;
  TIMER_VALUE = 0xffffffffu;
  TIMER_CONTROL = 1;
}

/* 40 ns a tick over 32 ns an instruction. Ticks are summed in 64 bits: the timer itself wraps every 172 s. */
uint32_t board_instructions(void) {
  static uint64_t ticks;
  static uint32_t last = 0xffffffffu;
  const uint32_t now = TIMER_VALUE;
  ticks += last - now;
  last = now;
  return (uint32_t)(ticks * 5 / 4);
}

uint32_t board_deepest_stack(void) {
  const uint32_t* word = stack_bottom;
  while (word < stack_top && *word == UNUSED_STACK) ++word;
  return (uint32_t)((const char*)stack_top - (const char*)word);
}

/* Some loops below may not become calls of memcpy or memset, which could use the FPU before it is on. */
__attribute__((noreturn, used, optimize("no-tree-loop-distribute-patterns"))) void reset(void) {
  volatile uint32_t* const coprocessor_access = (volatile uint32_t*)0xe000ed88u;
  uint32_t* to;
  const uint32_t* from = data_in_rom;
  uint32_t* const here = (uint32_t*)__builtin_frame_address(0) - 16;
  *coprocessor_access |= 0xfu << 20;
  __asm__ volatile("dsb\n isb" ::: "memory");
  for (to = data_start; to < data_end;) *to++ = *from++;
  for (to = bss_start; to < bss_end;) *to++ = 0;
  for (to = stack_bottom; to < here;) *to++ = UNUSED_STACK;
  leave((uint32_t)image());
  for (;;) {
  }
}

static void fault(void) {
  board_write("failed processor_fault (the stack overflowed, or an address was wrong)\n");
  leave(1);
}

/* From the second vector on: the first is the top of the stack, which the linker script writes. */
__attribute__((section(".vectors"), used)) static void (*const vectors[])(void) = {reset, fault, fault,
                                                                                   fault, fault, fault};

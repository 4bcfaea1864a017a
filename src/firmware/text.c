#include "firmware/text.h"

static void write_digits(text_sink write, uint64_t number, int least_digits) {
  char text[24];
  int place = (int)sizeof text;
  text[--place] = '\0';
  do {
    text[--place] = (char)('0' + number % 10);
    number /= 10;
    --least_digits;
  } while (number > 0 || least_digits > 0);
  write(text + place);
}

void write_count(text_sink write, const char* name, uint64_t count) {
  write(name);
  write(" ");
  write_digits(write, count, 1);
  write("\n");
}

void write_number(text_sink write, const char* name, double number) {
  int exponent = 0;
  int step;
  uint64_t digits;
  write(name);
  write(" ");
  if (!(number - number == 0)) {
    write("not_finite\n");
    return;
  }
  if (number < 0) {
    write("-");
    number = -number;
  }
  for (step = 0; step < 330 && number >= 10; ++step, ++exponent) number /= 10;
  for (step = 0; step < 330 && number > 0 && number < 1; ++step, --exponent) number *= 10;
  digits = (uint64_t)(number * 1e11 + 0.5);
  write_digits(write, digits / UINT64_C(100000000000), 1);
  write(".");
  write_digits(write, digits % UINT64_C(100000000000), 11);
  write(exponent < 0 ? "e-" : "e+");
  write_digits(write, (uint64_t)(exponent < 0 ? -exponent : exponent), 2);
  write("\n");
}

void write_hash(text_sink write, const char* name, uint64_t hash) {
  static const char digit[] = "0123456789abcdef";
  char text[17];
  int k;
  for (k = 0; k < 16; ++k) text[k] = digit[(hash >> (60 - 4 * k)) & 15u];
  text[16] = '\0';
  write(name);
  write(" ");
  write(text);
  write("\n");
}

int failed(text_sink write, const char* call, tr_status status) {
  if (status == TR_OK) return 0;
  write("failed ");
  write(call);
  write(" ");
  write(tr_status_word(status));
  write("\n");
  return 1;
}

void write_precision(text_sink write) {
  write(sizeof(tr_real) == 8 ? "precision double\n" : "precision single\n");
}

/* Lines "name value\n" of what is compared between machines. Needs no C library. */
#ifndef TILTROTOR_TEXT_H
#define TILTROTOR_TEXT_H

#include "tiltrotor/tiltrotor.h"

typedef void (*text_sink)(const char* text);

/* 12 significant digits by integer arithmetic: the same text on every machine for the same number. */
void write_number(text_sink write, const char* name, double number);
void write_count(text_sink write, const char* name, uint64_t count);
void write_hash(text_sink write, const char* name, uint64_t hash);
/* Of tr_real. */
void write_precision(text_sink write);

/* 0, or 1 with a line that names the call when `status` is not TR_OK. */
int failed(text_sink write, const char* call, tr_status status);

#endif

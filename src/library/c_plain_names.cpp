// The three functions whose symbols name the version, under their plain names too: for dlsym(), whose caller
// asks tr_init for the version.
#include "tiltrotor/tiltrotor.h"

#undef tr_eigenvalues
#undef tr_modes
#undef tr_hash

#ifdef TR_SINGLE_PRECISION
#define TR_PLAIN(name) name##_single
#else
#define TR_PLAIN(name) name
#endif

extern "C" {
#pragma GCC visibility push(default)

tr_status TR_PLAIN(tr_eigenvalues)(tr_work* work, const tr_real* a, size_t n, tr_real* real, tr_real* imag,
                                   size_t length) {
  return TR_OF_VERSION(tr_eigenvalues)(work, a, n, real, imag, length);
}

tr_status TR_PLAIN(tr_modes)(tr_work* work, const tr_linear_shape* shape, const tr_real* a, size_t a_length,
                             tr_mode* modes, size_t capacity, size_t* count) {
  return TR_OF_VERSION(tr_modes)(work, shape, a, a_length, modes, capacity, count);
}

tr_status TR_PLAIN(tr_hash)(const tr_real* numbers, size_t length, uint64_t* hash) {
  return TR_OF_VERSION(tr_hash)(numbers, length, hash);
}

#pragma GCC visibility pop
}

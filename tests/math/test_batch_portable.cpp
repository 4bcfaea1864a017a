// The portable form of batches, under another namespace name so that both forms live in one program: the other
// half of test_batch.cpp.
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#define TILTROTOR_PORTABLE_LANES
#define tiltrotor tiltrotor_portable_batches
#define batch_program portable_batch_program
#include "batch_program.hpp"
#undef batch_program
#undef tiltrotor

std::vector<double> portable_batch_results() { return portable_batch_program::batch_results<double>(); }
std::vector<float> portable_batch_results_float() { return portable_batch_program::batch_results<float>(); }

// The portable form of packs, under another namespace name so that both forms live in one program: the other
// half of test_pack.cpp.
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#define TILTROTOR_PORTABLE_LANES
#define tiltrotor tiltrotor_portable_packs
#define pack_program portable_pack_program
#include "batch_program.hpp"
#undef pack_program
#undef tiltrotor

std::vector<double> portable_pack_results() { return portable_pack_program::pack_results<double>(); }
std::vector<float> portable_pack_results_float() { return portable_pack_program::pack_results<float>(); }

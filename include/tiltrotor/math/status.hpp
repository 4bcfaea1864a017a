// Status: the one outcome type of every fallible function of the library.
//
// A function that can fail returns a Status and documents which words it can return. Adding a word: add the
// enumerator before `count`, and one row to kStatusTable in the same place; the static_assert watches the
// length.
#pragma once

#include "tiltrotor/math/arithmetic.hpp"

namespace tiltrotor {

enum class [[nodiscard]] Status : unsigned char{
    ok,   not_converged, singular, not_finite, out_of_range, bad_argument, bad_arithmetic, vortex_ring,
    count  // number of words above; never returned
};

namespace status_detail {

struct Row {
  const char* word;
  const char* text;
};

inline constexpr Row kStatusTable[] = {
    {"ok", "the result is valid"},
    {"not_converged", "the iteration reached its limit before its tolerance"},
    {"singular", "a matrix that must be inverted is singular"},
    {"not_finite", "a NaN or an infinity was met in the input or arose in the computation"},
    {"out_of_range", "an input lies outside the range for which the model is defined"},
    {"bad_argument", "an argument contradicts the function's contract, for example a size"},
    {"bad_arithmetic",
     "the processor or the compiled code does not compute as IEEE 754 has it (math/arithmetic.hpp)"},
    {"vortex_ring", "the rotor descends in its own wake"},
};

static_assert(sizeof(kStatusTable) / sizeof(kStatusTable[0]) == static_cast<unsigned>(Status::count),
              "one row per status word");

constexpr bool known(Status status) {
  return static_cast<unsigned>(status) < static_cast<unsigned>(Status::count);
}

}  // namespace status_detail

// One word, as printed in the `status` column of every output.
constexpr const char* status_word(Status status) {
  return status_detail::known(status) ? status_detail::kStatusTable[static_cast<unsigned>(status)].word
                                      : "unknown";
}

// One sentence for a person.
constexpr const char* status_text(Status status) {
  return status_detail::known(status) ? status_detail::kStatusTable[static_cast<unsigned>(status)].text
                                      : "not a status of this library";
}

}  // namespace tiltrotor

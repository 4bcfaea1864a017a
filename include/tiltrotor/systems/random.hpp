// Random numbers without a state: number k of stream s of a seed is a function of the three. A flight may begin
// anywhere, two flights run side by side, a saved one goes on; a step computed twice gets the same noise.
// Integers, one subtraction and one exact division: the same bits on every machine, in float and double.
//
//   const double n = normal_number<double>(seed, stream, step);
#pragma once

#include <cstdint>

#include "tiltrotor/math/arithmetic.hpp"

namespace tiltrotor {

// SplitMix64: Steele, Lea, Flood, OOPSLA 2014, with the constants of Stafford's mixing function 13. Word k of a
// sequence that begins at a number is mixed(begin + (k + 1) kGoldenStep).
inline constexpr std::uint64_t kGoldenStep = 0x9e3779b97f4a7c15u;
constexpr std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}
// A stream begins at a word of the seed's own sequence, which is mixed first: seeds 1, 2, 3 are not alike.
constexpr std::uint64_t random_word(std::uint64_t seed, std::uint64_t stream, std::uint64_t k) {
  const std::uint64_t begin = mixed(mixed(seed) + (stream + 1) * kGoldenStep);
  return mixed(begin + (k + 1) * kGoldenStep);
}

// Mean 0, variance 1 (less 2^-32): the sum of twelve numbers spread evenly over -1/2..1/2. Its fourth moment is 2.9
// where that of the normal law is 3, its largest value 6. A filter that is slow against the steps adds up many.
// k below 2^62.
template <class R>
constexpr R normal_number(std::uint64_t seed, std::uint64_t stream, std::uint64_t k) {
  constexpr int words = 3;
  constexpr int bits = 16;  // of each of the twelve
  constexpr int largest = (1 << bits) - 1;
  int sum = 0;
  for (int i = 0; i < words; ++i) {
    const std::uint64_t word = random_word(seed, stream, words * k + static_cast<std::uint64_t>(i));
    for (int shift = 0; shift < 64; shift += bits) sum += static_cast<int>((word >> shift) & largest);
  }
  constexpr int twice_mean = words * (64 / bits) * largest;
  return static_cast<R>(2 * sum - twice_mean) / static_cast<R>(2 << bits);
}

}  // namespace tiltrotor

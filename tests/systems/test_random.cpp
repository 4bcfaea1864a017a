// Random numbers: the published sequence of SplitMix64, moments of a sum of twelve even numbers, independence of
// steps, streams and seeds to what a million numbers can show.
#include "tiltrotor/systems/random.hpp"

#include <cmath>
#include <set>

#include "check.hpp"

using namespace tiltrotor;

// As printed by others for the seed 1234567 (Rosetta Code, "Pseudo-random numbers/Splitmix64").
TEST(random_mixing_is_splitmix64) {
  std::uint64_t state = 1234567;
  for (const std::uint64_t expected : {6457827717110365317u, 3203168211198807973u, 9817491932198370423u,
                                       4593380528125082431u, 16408922859458223821u}) {
    state += kGoldenStep;
    CHECK_EQ(mixed(state), expected);
  }
}

// A sum of n even numbers of -1/2..1/2: variance n/12, fourth moment 3 - 6/(5 n) in its unit.
TEST(random_normal_has_the_moments_of_the_sum) {
  constexpr int count = 1000000;
  double sum[7] = {};
  int beyond[4] = {};
  for (int k = 0; k < count; ++k) {
    const double n = normal_number<double>(7, 2, static_cast<std::uint64_t>(k));
    double power = 1;
    for (double& s : sum) {
      s += power / count;
      power *= n;
    }
    for (int i = 1; i < 4; ++i) beyond[i] += std::abs(n) > i ? 1 : 0;
  }
  // Five times the scatter of such a mean: sqrt(1), sqrt(2), sqrt(15), sqrt(96) thousandths.
  CHECK_NEAR(sum[1], 0, 5e-3);
  CHECK_NEAR(sum[2], 1, 7e-3);
  CHECK_NEAR(sum[3], 0, 20e-3);
  CHECK_NEAR(sum[4], 3 - 6.0 / (5 * 12), 49e-3);
  // Beyond 1, 2, 3: 0.3173, 0.0455, 0.0027 of a normal law; the sum of twelve lies within 0.002.
  CHECK_NEAR(beyond[1] / double(count), 0.3173, 4e-3);
  CHECK_NEAR(beyond[2] / double(count), 0.0455, 2e-3);
  CHECK_NEAR(beyond[3] / double(count), 0.0027, 1e-3);
}

TEST(random_numbers_are_independent) {
  constexpr std::uint64_t count = 200000;
  struct Other {
    std::uint64_t seed, stream, later;
  };
  for (const Other& other :
       {Other{1, 0, 1}, Other{1, 0, 2}, Other{1, 0, 1000}, Other{1, 1, 0}, Other{1, 5, 0}, Other{2, 0, 0},
        Other{0, 0, 0}, Other{1ull << 63, 0, 0}, Other{2, 1, 1}}) {
    double product = 0;
    double squares = 0;
    for (std::uint64_t k = 0; k < count; ++k) {
      const double a = normal_number<double>(1, 0, k);
      const double b = normal_number<double>(other.seed, other.stream, k + other.later);
      product += a * b / count;
      squares += (a * a - 1) * (b * b - 1) / count;
    }
    CHECK_NEAR(product, 0, 5 / std::sqrt(double(count)));
    CHECK_NEAR(squares, 0, 5 * 1.9 / std::sqrt(double(count)));
  }
}

// Every bit of a word is a coin, whatever the place in the three arguments.
TEST(random_words_change_half_their_bits) {
  for (int argument = 0; argument < 3; ++argument)
    for (int bit = 0; bit < 64; ++bit) {
      int changed = 0;
      constexpr int trials = 200;
      for (std::uint64_t k = 0; k < trials; ++k) {
        const std::uint64_t flip = 1ull << bit;
        const std::uint64_t difference =
            random_word(k, 3 * k, 7 * k) ^ random_word(argument == 0 ? k ^ flip : k,
                                                       argument == 1 ? (3 * k) ^ flip : 3 * k,
                                                       argument == 2 ? (7 * k) ^ flip : 7 * k);
        for (int i = 0; i < 64; ++i) changed += static_cast<int>((difference >> i) & 1);
      }
      CHECK_NEAR(changed / double(trials), 32, 5 * 4 / std::sqrt(double(trials)));
    }
}

// A function of its arguments alone, bits and all: +-6 at most, the same in both precisions.
TEST(random_numbers_have_no_state) {
  static_assert(normal_number<double>(1, 2, 3) == normal_number<double>(1, 2, 3));
  std::set<double> values;
  for (std::uint64_t k = 0; k < 1000; ++k) {
    const double n = normal_number<double>(4, 4, k);
    CHECK_LE(std::abs(n), 6.0);
    CHECK_EQ(normal_number<float>(4, 4, k), n);
    values.insert(n);
  }
  CHECK_LE(990u, values.size());
}

// Words and numbers in a buffer. Expected: the text itself, and numbers read back.
#include "tiltrotor/math/sentence.hpp"

#include <cstdlib>
#include <string>

#include "check.hpp"

using namespace tiltrotor;

namespace {

std::string number(double value, int decimals = 0) {
  char text[64];
  Sentence(text, sizeof text).number(value, decimals);
  return text;
}

}  // namespace

// With as many decimals as single precision has digits, and no more than a number may have.
TEST(sentence_of_a_number_shows_its_digits) {
  CHECK_EQ(number(2), "2");
  CHECK_EQ(number(2, 1), "2.0");
  CHECK_EQ(number(-0.125), "-0.125");
  for (const double value : {1.0 / 3, -7.0 / 9, 123.456789, 4.321e-3})
    CHECK_REL(std::strtod(number(value).c_str(), nullptr), value, 1e-7);
  CHECK_EQ(number(1.23456789e-9), "0.00000000123");  // eleven decimals, and there it ends
  CHECK_EQ(number(1e9), "very large");
}

// Two numbers read differently with so many decimals; equal ones never do, and numbers too large to be written no more.
TEST(sentence_tells_two_numbers_apart) {
  CHECK_EQ(Sentence::decimals_apart(1, 2), 2);
  CHECK_EQ(Sentence::decimals_apart(1, 1.0001), 4);
  CHECK_EQ(Sentence::decimals_apart(-3, -3.000002), 6);
  CHECK_EQ(Sentence::decimals_apart(1, 1), 11);
  CHECK_EQ(Sentence::decimals_apart(1e9, 2), 2);
  CHECK_EQ(Sentence::decimals_apart(2, 1e9), 2);
}

TEST(sentence_that_does_not_fit_is_cut) {
  char text[6];
  Sentence sentence(text, sizeof text);
  sentence << "mast " << 120;
  CHECK_EQ(std::string(text), "mast ");
  CHECK_EQ(sentence.left(), 0);
  char none[1] = {'x'};
  Sentence(none, 0) << "nothing";
  CHECK_EQ(none[0], 'x');
}

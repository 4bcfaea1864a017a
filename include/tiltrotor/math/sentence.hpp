// Words and numbers one after the other in a buffer of the caller.
#pragma once

#include <cstdint>

#include "tiltrotor/math/arithmetic.hpp"

namespace tiltrotor {

// Appends to a buffer and always leaves it terminated; what does not fit is cut.
class Sentence {
 public:
  Sentence(char* text, int capacity) : text_(text), capacity_(capacity) {
    if (capacity_ > 0) text_[0] = '\0';
  }
  Sentence& operator<<(const char* words) {
    for (; *words != '\0'; ++words) put(*words);
    return *this;
  }
  Sentence& operator<<(int number) {
    char digit[12];
    int count = 0;
    long rest = number < 0 ? -static_cast<long>(number) : number;
    if (number < 0) put('-');
    do {
      digit[count++] = static_cast<char>('0' + rest % 10);
      rest /= 10;
    } while (rest > 0 && count < 12);
    while (count > 0) put(digit[--count]);
    return *this;
  }
  Sentence& fixed(double number, int decimals = 2) {
    if (!is_writable(number)) return *this << (number == number ? "very large" : "no number");
    const std::int64_t unit = power_of_ten(decimals);
    const std::int64_t units = rounded(number < 0 ? -number : number, unit);
    if (number < 0 && units > 0) put('-');
    *this << static_cast<int>(units / unit);
    if (decimals > 0) put('.');
    for (std::int64_t place = unit / 10; place > 0; place /= 10)
      put(static_cast<char>('0' + units / place % 10));
    return *this;
  }
  // With the fewest decimals that show it to the digits of single precision, at least so many.
  Sentence& number(double value, int decimals = 0) {
    const double size = value < 0 ? -value : value;
    const auto error = [&] {
      const std::int64_t unit = power_of_ten(decimals);
      const double off = size - static_cast<double>(rounded(size, unit)) / static_cast<double>(unit);
      return off < 0 ? -off : off;
    };
    if (is_writable(value))
      while (decimals < kMostDecimals && error() > 1e-7 * size) ++decimals;
    return fixed(value, decimals);
  }
  // The fewest decimals, at least two, with which two numbers read differently.
  static int decimals_apart(double a, double b) {
    int decimals = 2;
    while (decimals < kMostDecimals && is_writable(a) && is_writable(b) &&
           rounded(a < 0 ? -a : a, power_of_ten(decimals)) == rounded(b < 0 ? -b : b, power_of_ten(decimals)))
      ++decimals;
    return decimals;
  }
  // One digit and a power of ten, rounded down.
  Sentence& scientific(double number) {
    if (!(number > 0 && number < 1e300)) return *this << (number == 0 ? "0" : "no number");
    int exponent = 0;
    for (int k = 0; k < 330 && number >= 10; ++k, ++exponent) number /= 10;
    for (int k = 0; k < 330 && number < 1; ++k, --exponent) number *= 10;
    *this << static_cast<int>(number) << "e" << exponent;
    return *this;
  }
  int length() const { return length_; }
  int left() const { return capacity_ - 1 - length_; }

 private:
  static constexpr int kMostDecimals = 11;  // of a number below 1e7 they fit in 63 bits
  static bool is_writable(double number) { return number > -1e7 && number < 1e7; }
  static std::int64_t power_of_ten(int exponent) {
    std::int64_t power = 1;
    for (int k = 0; k < exponent; ++k) power *= 10;
    return power;
  }
  // Units in a number that is not negative.
  static std::int64_t rounded(double size, std::int64_t unit) {
    const double half_up = size * static_cast<double>(unit) + 0.5;
    return static_cast<std::int64_t>(half_up);
  }
  void put(char c) {
    if (length_ + 1 >= capacity_) return;
    text_[length_++] = c;
    text_[length_] = '\0';
  }
  char* text_;
  int capacity_;
  int length_ = 0;
};

}  // namespace tiltrotor

// Words and numbers one after the other in a buffer of the caller.
#pragma once

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
  // Two decimals.
  Sentence& fixed(double number) {
    const double limit = 1e7;
    if (!(number > -limit && number < limit)) return *this << (number == number ? "very large" : "no number");
    const double size = number < 0 ? -number : number;
    // Never negative, and small enough to be exact.
    const long hundredths = static_cast<long>(size * 100 + 0.5);  // NOLINT(bugprone-incorrect-roundings)
    if (number < 0 && hundredths > 0) put('-');
    *this << static_cast<int>(hundredths / 100);
    put('.');
    put(static_cast<char>('0' + hundredths / 10 % 10));
    put(static_cast<char>('0' + hundredths % 10));
    return *this;
  }
  // Without decimals where there are none.
  Sentence& number(double value) {
    const auto whole = static_cast<int>(value > -1e7 && value < 1e7 ? value : 0);
    return value == whole ? *this << whole : fixed(value);
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

// A small test harness.
//
//   TEST(eigen_jordan_block) {
//       CHECK_NEAR(eigenvalue.real(), 2.0, 1e-7);
//       if (!CHECK(status == Status::ok)) return;  // every check is an expression: true when it holds
//       NOTE("worst error " << error);             // a line of information, printed also when the test
//       passes
//   }
//
// A check that fails prints file, line, expression and values; the test goes on. NaN fails every comparison.
#pragma once

#include <cmath>
#include <complex>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>

namespace check {

using TestFunction = void (*)();

constexpr int any_aircraft = 0;
constexpr int xv15 = 1;  // AircraftIdentity::id

struct Registration {
  Registration(const char* name, const char* file, int line, TestFunction function,
               int aircraft = any_aircraft);
};

/// Counts one check of the running test and prints it when it failed; returns `passed`.
bool report(bool passed, const char* file, int line, const std::string& expression,
            const std::string& values);
void note(const std::string& text);

template <class T, class = void>
struct IsPrintable : std::false_type {};
template <class T>
struct IsPrintable<T, std::void_t<decltype(std::declval<std::ostream&>() << std::declval<const T&>())>>
    : std::true_type {};

template <class T>
std::string text(const T& value) {
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10);
  if constexpr (std::is_same_v<T, bool>) {
    out << (value ? "true" : "false");
  } else if constexpr (std::is_enum_v<T> && !IsPrintable<T>::value) {
    out << +static_cast<std::underlying_type_t<T>>(value);
  } else if constexpr (IsPrintable<T>::value) {
    out << value;
  } else {
    out << "(no text for this type)";
  }
  return out.str();
}

/// Mixed types are compared by value: -1 is less than 1u, and float against double raises no warning.
template <class A, class B>
bool equal(const A& a, const B& b) {
  if constexpr (std::is_arithmetic_v<A> && std::is_arithmetic_v<B>) {
    if constexpr (std::is_integral_v<A> && std::is_integral_v<B>) {
      if ((a < A{}) != (b < B{})) return false;
    }
    using Common = std::common_type_t<A, B>;
    return static_cast<Common>(a) == static_cast<Common>(b);
  } else {
    return a == b;
  }
}
inline bool equal(const char* a, const char* b) { return std::string(a) == b; }

template <class A, class B>
bool less(const A& a, const B& b) {
  if constexpr (std::is_arithmetic_v<A> && std::is_arithmetic_v<B>) {
    if constexpr (std::is_integral_v<A> && std::is_integral_v<B>) {
      if ((a < A{}) != (b < B{})) return a < A{};
    }
    using Common = std::common_type_t<A, B>;
    return static_cast<Common>(a) < static_cast<Common>(b);
  } else {
    return a < b;
  }
}

// Tolerances compare in double, real or complex.
template <class T>
double widened(const T& value) {
  return static_cast<double>(value);
}
template <class T>
std::complex<double> widened(const std::complex<T>& value) {
  return {static_cast<double>(value.real()), static_cast<double>(value.imag())};
}

template <class A, class B>
bool check_close(const A& actual, const B& expected, double tolerance, const char* file, int line,
                 const char* expression) {
  const double error = std::abs(actual - expected);
  // Equal infinities have no difference but are equal; with NaN both conditions are false.
  const bool passed = actual == expected || error <= tolerance;
  return report(passed, file, line, expression,
                passed ? std::string()
                       : "actual " + text(actual) + ", expected " + text(expected) + ", error " +
                             text(error) + ", tolerance " + text(tolerance));
}

template <class A, class B>
bool check_pair(bool passed, const A& left, const B& right, const char* file, int line,
                const char* expression) {
  return report(passed, file, line, expression,
                passed ? std::string() : "left " + text(left) + ", right " + text(right));
}

template <class A, class B>
bool check_near(const A& actual, const B& expected, double tolerance, const char* file, int line,
                const char* expression) {
  return check_close(widened(actual), widened(expected), tolerance, file, line, expression);
}

template <class A, class B>
bool check_rel(const A& actual, const B& expected, double tolerance, const char* file, int line,
               const char* expression) {
  return check_close(widened(actual), widened(expected), tolerance * std::abs(widened(expected)), file, line,
                     expression);
}

template <class A, class B>
bool check_eq(const A& left, const B& right, const char* file, int line, const char* expression) {
  return check_pair(equal(left, right), left, right, file, line, expression);
}

template <class A, class B>
bool check_lt(const A& left, const B& right, const char* file, int line, const char* expression) {
  return check_pair(less(left, right), left, right, file, line, expression);
}

template <class A, class B>
bool check_le(const A& left, const B& right, const char* file, int line, const char* expression) {
  return check_pair(less(left, right) || equal(left, right), left, right, file, line, expression);
}

}  // namespace check

/// Defines and registers a test. Names are unique in the whole runner; a name that begins with slow_ may be
/// skipped.
#define TEST(name)                                                                              \
  static void test_##name();                                                                    \
  static const check::Registration registration_##name(#name, __FILE__, __LINE__, test_##name); \
  static void test_##name()

/// A test that knows numbers of the XV-15: printed runs, reference files, column texts with its ranges. Left out,
/// and counted as such, when another aircraft is compiled in.
#define TEST_OF_XV15(name)                                                                                   \
  static void test_##name();                                                                                 \
  static const check::Registration registration_##name(#name, __FILE__, __LINE__, test_##name, check::xv15); \
  static void test_##name()

#define CHECK(...) \
  check::report(static_cast<bool>(__VA_ARGS__), __FILE__, __LINE__, "CHECK(" #__VA_ARGS__ ")", "")

/// |actual - expected| <= abs_tol; real or complex.
#define CHECK_NEAR(actual, expected, abs_tol)                                           \
  check::check_near(actual, expected, static_cast<double>(abs_tol), __FILE__, __LINE__, \
                    "CHECK_NEAR(" #actual ", " #expected ", " #abs_tol ")")

/// |actual - expected| <= rel_tol |expected|: an expected zero must be met exactly.
#define CHECK_REL(actual, expected, rel_tol)                                           \
  check::check_rel(actual, expected, static_cast<double>(rel_tol), __FILE__, __LINE__, \
                   "CHECK_REL(" #actual ", " #expected ", " #rel_tol ")")

#define CHECK_EQ(left, right) \
  check::check_eq(left, right, __FILE__, __LINE__, "CHECK_EQ(" #left ", " #right ")")
#define CHECK_LT(left, right) \
  check::check_lt(left, right, __FILE__, __LINE__, "CHECK_LT(" #left ", " #right ")")
#define CHECK_LE(left, right) \
  check::check_le(left, right, __FILE__, __LINE__, "CHECK_LE(" #left ", " #right ")")

#define NOTE(stream)                \
  do {                              \
    std::ostringstream note_stream; \
    note_stream << stream;          \
    check::note(note_stream.str()); \
  } while (false)

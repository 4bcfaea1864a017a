#include "text/number.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

#include "text/errors.hpp"
#include "text/nearest.hpp"

namespace tiltrotor::text {

namespace {

// from_chars knows no leading plus sign.
std::string_view without_plus(std::string_view text) {
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  return plus ? text.substr(1) : text;
}

}  // namespace

std::string number_text(double value, int digits) {
  if (value == 0) return "0";  // not -0
  char buffer[64];
  const std::to_chars_result result =
      digits == kShortest
          ? std::to_chars(buffer, buffer + sizeof buffer, value)
          : std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, digits);
  return std::string(buffer, result.ptr);
}

std::string range_text(const Range& range) {
  const std::string unit = range.unit;
  return number_text(range.low) + ".." + number_text(range.high) + (unit.empty() ? "" : " ") + unit;
}

namespace {

// What ends a message about a list or range where one number belongs.
const char* one_number(std::string_view text) {
  const bool of_numbers = text.find_first_not_of("0123456789+-.eE,: ") == std::string_view::npos;
  if (of_numbers && text.find(':') != std::string_view::npos) return "; one value, not a range";
  if (of_numbers && text.find(',') != std::string_view::npos) return "; one value, not a list";
  return "";
}

// `hint` ends the message.
double parse_finite(std::string_view text, const std::string& where, const std::string& hint) {
  const auto refuse = [&](const std::string& what) { throw UsageError(where + ": " + quoted(text) + what); };
  const std::string_view digits = without_plus(text);
  double value = 0;
  const std::from_chars_result result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (result.ec == std::errc::result_out_of_range)
    refuse(" is beyond the range of floating-point numbers" + hint);
  if (result.ec != std::errc() || result.ptr != digits.data() + digits.size())
    refuse(" is not a number" + hint + one_number(text));
  if (!std::isfinite(value)) refuse(" is not a finite number" + hint);
  return value;
}

}  // namespace

double parse_number(std::string_view text, const std::string& where) { return parse_finite(text, where, ""); }

double parse_number(std::string_view text, const std::string& where, const Range& range) {
  const double value = parse_finite(text, where, "; give " + range_text(range));
  require_within(value, text, where, range);
  return value;
}

void require_within(double value, std::string_view text, const std::string& where, const Range& range) {
  if (value < range.low || value > range.high)
    throw UsageError(where + ": " + (text.size() < 40 ? std::string(text) : number_text(value)) +
                     " lies outside " + range_text(range));
}

bool read_number(std::string_view text, double& value) {
  const std::string_view digits = without_plus(text);
  const std::from_chars_result result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return result.ec == std::errc() && result.ptr == digits.data() + digits.size() && std::isfinite(value);
}

double given_as(double value, double unit) {
  constexpr int digits = 15;  // any number of so many digits survives as a double
  const double quotient = value / unit;
  double round = 0;
  return read_number(number_text(quotient, digits), round) && round * unit == value ? round : quotient;
}

long parse_integer(std::string_view text, const std::string& where, long low, long high,
                   const std::string& stated) {
  const std::string range = stated.empty() ? std::to_string(low) + ".." + std::to_string(high) : stated;
  const std::string_view digits = without_plus(text);
  long value = 0;
  const std::from_chars_result result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool complete = result.ec == std::errc() && result.ptr == digits.data() + digits.size();
  if (!complete || value < low || value > high) refuse_integer(text, where, range);
  return value;
}

void refuse_integer(std::string_view text, const std::string& where, const std::string& range) {
  throw UsageError(where + ": " + quoted(text) + " is not a whole number in " + range + one_number(text));
}

}  // namespace tiltrotor::text

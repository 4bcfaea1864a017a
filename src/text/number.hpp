// Numbers as text, the same in every locale.
#pragma once

#include <string>
#include <string_view>

namespace tiltrotor::text {

// Interval a value must lie in, ends included, with its unit for the message.
struct Range {
  double low;
  double high;
  const char* unit;
};

// The fewest digits that read back as the same number.
inline constexpr int kShortest = 0;

// As printf's %.<digits>g prints it in the C locale.
std::string number_text(double value, int digits = kShortest);

// A number that was given in `unit` and kept as value = number * unit: what was given, not the neighbour that
// a division finds (60 deg, not 59.99999999999999).
double given_as(double value, double unit);

std::string range_text(const Range& range);

// A finite number, throughout the text. Throws UsageError "<where>: ..." for anything else; `where` names the
// option, or the file and line.
double parse_number(std::string_view text, const std::string& where);
double parse_number(std::string_view text, const std::string& where, const Range& range);
// `text` is how the value was written.
void require_within(double value, std::string_view text, const std::string& where, const Range& range);
// The same without a message: whether the text is a finite number.
bool read_number(std::string_view text, double& value);
// `stated`: the range as the message says it, where low..high is not all of it.
long parse_integer(std::string_view text, const std::string& where, long low, long high,
                   const std::string& stated = "");
[[noreturn]] void refuse_integer(std::string_view text, const std::string& where, const std::string& range);

}  // namespace tiltrotor::text

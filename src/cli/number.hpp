// Numbers as text, the same in every locale.
#pragma once

#include <string>
#include <string_view>

namespace tiltrotor::cli {

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

std::string range_text(const Range& range);

// A finite number, throughout the text. Throws UsageError "<where>: ..." for anything else; `where` names the
// option, or the file and line.
double parse_number(std::string_view text, const std::string& where);
double parse_number(std::string_view text, const std::string& where, const Range& range);
long parse_integer(std::string_view text, const std::string& where, long low, long high);

}  // namespace tiltrotor::cli

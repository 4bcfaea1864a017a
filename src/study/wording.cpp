#include "study/wording.hpp"

#include <charconv>
#include <cmath>

#include "text/number.hpp"

namespace tiltrotor::study {

std::string fixed(double value, int decimals) {
  char buffer[64];
  const double unit = std::pow(10.0, -decimals);
  const double shown = std::fabs(value) < 0.5 * unit ? 0.0 : value;  // no minus zero
  const std::to_chars_result end =
      std::to_chars(buffer, buffer + sizeof buffer, shown, std::chars_format::fixed, decimals);
  return std::string(buffer, end.ptr);
}

std::string with_sign(double value, int decimals) {
  const std::string text = fixed(value, decimals);
  return text[0] == '-' ? text : "+" + text;
}

std::string root_text(double real, double imag) {
  return fixed(real, 3) + (imag > 0 ? " ± " + fixed(imag, 3) + "i" : "");
}

std::string capitalized(std::string word) {
  if (!word.empty() && word[0] >= 'a' && word[0] <= 'z') word[0] = static_cast<char>(word[0] - 'a' + 'A');
  return word;
}

std::string mast_text(double mast_deg) { return "mast " + text::number_text(mast_deg) + " deg"; }

}  // namespace tiltrotor::study

#include "plot/ticks.hpp"

#include <algorithm>
#include <cmath>

#include "text/number.hpp"

namespace tiltrotor::plot {

namespace {

double round_step(double rough) {
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double digit = rough / power;
  return power * (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10);
}

std::string tick_text(double value, double step) {
  // Rounded to a digit below the step, so that 0.30000000000000004 reads 0.3.
  const double unit = std::pow(10.0, std::floor(std::log10(step)) - 1);
  const double rounded =
      unit < 1 ? std::round(value / unit) / std::round(1 / unit) : std::round(value / unit) * unit;
  return value_text(rounded);
}

}  // namespace

std::string value_text(double value) {
  std::string text = text::number_text(value == 0 ? 0.0 : value, 12);
  if (text[0] == '-') text.replace(0, 1, "\u2212");
  return text;
}

Scale linear_scale(double low, double high, int count, bool fixed) {
  if (!(high > low)) {
    const double margin = low == 0 ? 1 : 0.1 * std::fabs(low);
    low -= margin;
    high += margin;
  }
  const double step = round_step((high - low) / count);
  const double slack = 1e-9 * (high - low);
  if (!fixed) {
    low = step * std::floor((low + slack) / step);
    high = step * std::ceil((high - slack) / step);
  }
  Scale scale{low, high, false, {}};
  for (double k = std::ceil((low - slack) / step); k * step <= high + slack; ++k) {
    scale.ticks.push_back({k * step, tick_text(k * step, step)});
  }
  return scale;
}

// Numbers at every power of ten; over few powers at 2 and 5 as well, over many at every third and none
// between.
Scale logarithmic_scale(double low, double high) {
  Scale scale{low, high, true, {}};
  const double powers = std::log10(high / low);
  const bool few = powers < 3;
  const bool many = powers > 7;
  for (double power = std::floor(std::log10(low)); power <= std::log10(high); ++power) {
    for (int digit = 1; digit < (many ? 2 : 10); ++digit) {
      const double value = digit * std::pow(10.0, power);
      if (value < low * (1 - 1e-9) || value > high * (1 + 1e-9)) continue;
      const bool numbered =
          many ? std::fmod(power, 3) == 0 : digit == 1 || (few && (digit == 2 || digit == 5));
      scale.ticks.push_back({value, numbered ? text::number_text(value, 3) : ""});
    }
  }
  return scale;
}

double fraction(const Scale& scale, double value) {
  if (scale.logarithmic) return std::log(value / scale.low) / std::log(scale.high / scale.low);
  return (value - scale.low) / (scale.high - scale.low);
}

}  // namespace tiltrotor::plot

// Ticks at round numbers.
#pragma once

#include <string>
#include <vector>

namespace tiltrotor::plot {

struct Tick {
  double value;
  std::string text;  // with a typographic minus; empty: a tick without number
};

struct Scale {
  double low, high;  // both are ticks of a linear scale
  bool logarithmic;
  std::vector<Tick> ticks;
};

// Steps of 1, 2 or 5 times a power of ten, about `count` of them. With `fixed` the ends stay as given, else
// they move outwards to the next tick.
Scale linear_scale(double low, double high, int count, bool fixed);

// Decades, with numbers at 2 and 5 when there are fewer than three; low > 0.
Scale logarithmic_scale(double low, double high);

// A round number as it stands at an axis, with a typographic minus.
std::string value_text(double value);

// Place of a value on the scale: 0 at low, 1 at high; not finite outside the domain of a logarithm.
double fraction(const Scale& scale, double value);

}  // namespace tiltrotor::plot

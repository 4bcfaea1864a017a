// Tables of modes along a parameter, and their picture in the complex plane.
#pragma once

#include <string>
#include <vector>

#include "study/linear_models.hpp"
#include "study/section.hpp"

namespace tiltrotor::study {

// Empty table: the given columns, then axis, mode, real, imag, frequency_rad_s, damping_ratio,
// time_to_half_s.
Table mode_table(std::vector<std::string> leading_columns);

// One row for each body mode.
void add_modes(Table& table, const std::vector<double>& leading, const Modes& modes);

// A part of the complex plane.
struct PlaneWindow {
  double left, right, top;
};

// Around the rows whose mode's name holds that word, not further left than `left`; with every row if it is empty.
PlaneWindow window_around(const Table& rows, const std::string& word, double left);

struct ModePlot {
  std::string id, title;
  std::string parameter;  // column that runs along each branch
  const char* unit = "";
  double label_step = 10;  // markers stand at multiples of it, numbers where there is room
  PlaneWindow window = {};
  std::string note;
};

// Upper half of the complex plane, one line for each mode; a unit is as long along both axes.
Picture mode_picture(const ModePlot& what, const Table& rows);

}  // namespace tiltrotor::study

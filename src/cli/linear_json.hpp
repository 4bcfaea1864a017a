// A linear model as members of a JSON object, each "name": value, with commas and ends of line between.
#pragma once

#include <functional>
#include <string>

#include "cli/linear_settings.hpp"
#include "cli/shown_model.hpp"

namespace tiltrotor::cli {

std::string joined(int count, const std::string& separator, const std::function<std::string(int)>& item);

// Rows and columns of numbers that JSON reads back exactly; `wrap` goes around a row.
std::string matrix_text(int rows, int columns, const std::string& row_separator, const std::string& separator,
                        const std::function<double(int, int)>& entry,
                        const std::function<std::string(const std::string&)>& wrap);

std::string settings_json(const LinearSettings& settings);

// states, controls and, where there are some, outputs: names with units.
std::string names_json(const ShownModel& model);
// x0, u0, A and B, and where there are outputs y0, C and D.
std::string matrices_json(const ShownModel& model);

}  // namespace tiltrotor::cli

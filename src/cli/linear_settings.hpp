// What a linear model was made with, as files of models tell it: every setting and every switch.
#pragma once

#include <string>
#include <vector>

#include "tiltrotor/model/setup/configuration.hpp"

namespace tiltrotor::cli {

struct LinearSettings {
  struct Number {
    std::string name;  // with its unit
    double value;
  };
  std::vector<Number> numbers;
  std::vector<std::pair<std::string, std::string>> switches;  // all of them, those at their default too

  LinearSettings() = default;
  explicit LinearSettings(const Configuration<double>& c);
};

}  // namespace tiltrotor::cli

// What a linear model was made with, as files of models tell it: every setting and every switch.
#pragma once

#include <string>
#include <vector>

#include "cli/feedback.hpp"
#include "cli/trimmed_flights.hpp"

namespace tiltrotor::cli {

struct LinearSettings {
  struct Number {
    std::string name;  // with its unit
    double value;
  };
  std::vector<Number> numbers;
  std::vector<std::pair<std::string, std::string>>
      words;  // of the options that the flight was asked for with
  std::vector<std::pair<std::string, std::string>> switches;  // all of them, those at their default too

  std::vector<FeedbackGain> feedback;  // as they are there, of a closed loop

  LinearSettings() = default;
  explicit LinearSettings(const Configuration<double>& c);
  // And what the flight was asked for, as it was found.
  void add(const TrimmedFlight& flight);
};

}  // namespace tiltrotor::cli

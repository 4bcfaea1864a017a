// The tables as they may have been before print rounded them.
#pragma once

#include <cstdint>
#include <vector>

#include "tiltrotor/model/aircraft/aircraft.hpp"

namespace tiltrotor::cli {

class PrintRounding {
 public:
  // Moves every printed value of the tables of loads by up to half a unit of its last digit, each by itself with equal
  // chance, and draws the C1 curves anew. Draw `number` is always the same. The aircraft reads its tables here, until
  // the next draw.
  void draw(std::uint64_t number, Aircraft<double>& aircraft);

 private:
  std::vector<std::vector<double>> nodes_;
  std::vector<std::vector<float>> slopes_;  // where they stand apart
};

}  // namespace tiltrotor::cli

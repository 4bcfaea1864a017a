// Gains of the reference pilot over a whole flight: a row of speeds for each of several mast angles.
#pragma once

#include <vector>

#include "pilot/pilot_gains.hpp"

namespace tiltrotor::pilot {

class PilotSchedule {
 public:
  // In order of mast angle, then of speed.
  void add(const PilotGains& point);
  bool is_empty() const { return rows_.empty(); }
  // Linear between speeds of a row and between rows. Beyond the ends those of the end, with its own speed: the pilot
  // goes on from there by what a change of speed needs (Needs::steady). At least one point.
  PilotGains at(double mast_deg, double speed) const;

 private:
  std::vector<std::vector<PilotGains>> rows_;
};

}  // namespace tiltrotor::pilot

// What a flight did not do as it was told, for its summary.
#pragma once

#include <string>
#include <vector>

#include "tiltrotor/model/variables/controls.hpp"
#include "tiltrotor/systems/vehicle.hpp"

namespace tiltrotor::cli {

class FlightRemarks {
 public:
  // "gear up at 12 s: ignored, with weight on the wheels", each time.
  void ignored(const std::string& command, double time, const std::string& why);
  // A command that counts when the aircraft takes off, if it ever does.
  void waits(const std::string& command, double time);
  void leaves_wheels() { waiting_.clear(); }
  // A stop held a control back for so long, s.
  void stopped(int control, double time) { stopped_[control] += time; }
  // What is on and does nothing, told when it begins.
  void effects(const Vehicle<double>& vehicle, double time);
  // A line each.
  std::vector<std::string> text() const;

 private:
  struct Remark {
    std::string command, line;
  };
  static void add_once(const std::string& command, const std::string& line, std::vector<Remark>& remarks);
  static std::string line(const std::string& command, double time, const std::string& why);

  std::vector<Remark> said_, waiting_;
  double stopped_[control_count] = {};
  bool is_without_effect_[3] = {};  // engines right and left, interconnect
};

}  // namespace tiltrotor::cli

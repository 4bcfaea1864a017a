// What a flight was like, in a few lines.
#pragma once

#include <string>

#include "cli/script_flight.hpp"

namespace tiltrotor::cli {

class FlightSummary {
 public:
  // Every step.
  void add(const FlightMoment& moment);
  // ScriptFlight::remarks(), one.
  void add(const std::string& remark) { remarks_ += remark + "\n"; }
  double height_error() const { return height_error_.value; }                 // m, while a height is held
  double power_part() const { return power_part_.value; }                     // of take-off power
  double touch_down() const { return touched_ > 0 ? touch_down_.value : 0; }  // m/s
  // Lines "name: value", each with its end.
  std::string text() const;

 private:
  struct Extreme {
    double value, time;
  };
  static void keep_most(double value, double time, Extreme& most) {
    if (value > most.value) most = {value, time};
  }
  double duration_ = 0;
  Extreme height_error_{0, 0}, power_part_{0, 0}, bank_{0, 0};
  double power_ = 0;
  Extreme most_load_{-1e9, 0}, least_load_{-1e9, 0};  // of the second, the negative
  bool flies_ = false;
  int touched_ = 0;
  Extreme touch_down_{0, 0};  // the hardest
  double fuel_ = 0, least_mast_ = 1e9, most_mast_ = -1e9;
  double last_climb_ = 0;
  double beyond_ = 0;  // s that rotors without governor took more than take-off power
  bool is_beyond_ = false;
  std::string remarks_;
};

}  // namespace tiltrotor::cli

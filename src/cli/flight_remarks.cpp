#include "cli/flight_remarks.hpp"

#include <algorithm>
#include <cstdio>

#include "text/number.hpp"

namespace tiltrotor::cli {

using text::number_text;

std::string FlightRemarks::line(const std::string& command, double time, const std::string& why) {
  return command + " at " + number_text(time, 6) + " s: ignored, " + why;
}

void FlightRemarks::add_once(const std::string& command, const std::string& line,
                             std::vector<Remark>& remarks) {
  const bool is_said =
      std::any_of(remarks.begin(), remarks.end(), [&](const Remark& r) { return r.command == command; });
  if (!is_said) remarks.push_back({command, line});
}

void FlightRemarks::ignored(const std::string& command, double time, const std::string& why) {
  said_.push_back({command, line(command, time, why)});
}

void FlightRemarks::waits(const std::string& command, double time) {
  add_once(command, line(command, time, "on the wheels"), waiting_);
}

void FlightRemarks::effects(const Vehicle<double>& v, double time) {
  const Governor governor = v.on.governor;
  const char* const kind = governor == Governor::off ? "off" : "ideal";
  const struct {
    std::string what;
    bool is_without_effect;
  } now[] = {
      {"engine 1 fail: no effect on the rotors", governor == Governor::off && v.engine_failed[right]},
      {"engine 2 fail: no effect on the rotors", governor == Governor::off && v.engine_failed[left]},
      {"interconnect twists: no effect", governor != Governor::pi && v.on.interconnect},
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const bool is_new = now[k].is_without_effect && !is_without_effect_[k];
    is_without_effect_[k] = now[k].is_without_effect;
    if (is_new)
      said_.push_back(
          {now[k].what, now[k].what + " from " + number_text(time, 6) + " s on, with the governor " + kind});
  }
}

std::vector<std::string> FlightRemarks::text() const {
  std::vector<std::string> lines;
  for (const std::vector<Remark>* const remarks : {&said_, &waiting_})
    for (const Remark& remark : *remarks) lines.push_back(remark.line);
  std::string held;
  for (int control = 0; control < control_count; ++control) {
    if (stopped_[control] == 0) continue;
    char time[32];
    std::snprintf(time, sizeof time, " %.2f s", stopped_[control]);
    held += (held.empty() ? "" : ", ") + std::string(kControlVariables[control].name) + time;
  }
  if (!held.empty()) lines.push_back("held at its stop: " + held);
  return lines;
}

}  // namespace tiltrotor::cli

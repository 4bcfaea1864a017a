// Level flight at 40 m/s in helicopter mode, then one degree more collective and nothing else.
#pragma once

#include <array>
#include <vector>

#include "study/flights.hpp"
#include "tiltrotor/analysis/flight/response.hpp"

namespace tiltrotor::study {

inline constexpr double kStepSpeed = 40;          // m/s
inline constexpr double kStepDuration = 3;        // s
inline constexpr double kStepRecordEvery = 0.05;  // s

// Of symmetric flight through still air, as the figures show it.
inline constexpr int kMotionQuantities = 4;
inline constexpr const char* kMotionQuantity[kMotionQuantities] = {"climb_mps", "ground_speed_mps", "q_degps",
                                                                   "pitch_deg"};
using Motion = std::array<double, kMotionQuantities>;
Motion motion_of(const State<double>& x);

// The flight at the moment of the step. Throws when it cannot begin.
Simulation<double> collective_step(const Configured& c, const Trimmed& trim, double step_s);

// The motion every kStepRecordEvery, from 0 to kStepDuration. Throws when it ends before.
std::vector<Motion> motion_after_step(const Configured& c, const Trimmed& trim, double step_s);

}  // namespace tiltrotor::study

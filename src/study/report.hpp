// The study of `tiltrotor report`.
#pragma once

#include <string>

#include "study/mission.hpp"

namespace tiltrotor::study {

// What is printed: every statement of the study, or the table of the validation.
enum class ReportSummary { statements, validation };

// `fly_mission`: flies the mission of the report. Writes figures, tables and index.html to an existing folder and a summary to stdout. False when a case failed;
// with the validation, also when a number exceeds its tolerance and is not on the list of known exceedances, or no
// longer belongs there.
bool run_report(const std::string& folder, ReportSummary summary, const FlyMission& fly_mission);

}  // namespace tiltrotor::study

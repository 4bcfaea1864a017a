// Which program, of which aircraft and state of the sources, made an output.
#pragma once

#include <string>

namespace tiltrotor::text {

// "tiltrotor 0.2.0, aircraft XV-15, commit 0123456789ab, automatic derivatives"; the commit only where known.
std::string identity_text();

// For results, without the commit, so that they stay comparable: "tiltrotor 0.2.0, aircraft XV-15", and as
// JSON
// {"name": "tiltrotor", "version": "0.2.0", "aircraft": "XV-15"}.
std::string program_text();
const std::string& program_json();

// With the commit and the kind of derivatives, for models that are kept: {"name": ..., "commit": "0123456789ab",
// "derivatives": "automatic"}; the commit empty where unknown.
std::string program_and_commit_json();

// Day of the run, UTC, "2026-11-25"; of SOURCE_DATE_EPOCH where that is set.
std::string date_text();

}  // namespace tiltrotor::text

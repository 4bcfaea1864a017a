#include "text/identity.hpp"

#include <cstdlib>
#include <ctime>

#include "library/analyses.hpp"
#include "text/json.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

namespace tiltrotor::text {

namespace {

constexpr const char* commit_of_sources =
#include "identity.inc"
    ;

std::vector<JsonMember> program_members() {
  return {{"name", json_text("tiltrotor")},
          {"version", json_text(TILTROTOR_VERSION)},
          {"aircraft", json_text(aircraft_identity().name)}};
}

}  // namespace

std::string program_text() {
  return std::string("tiltrotor " TILTROTOR_VERSION ", aircraft ") + aircraft_identity().name;
}

std::string identity_text() {
  const std::string commit = commit_of_sources;
  return program_text() + (commit.empty() ? "" : ", commit " + commit) + ", " + differentiation_name() +
         " derivatives";
}

const std::string& program_json() {
  static const std::string text = json_object(program_members());
  return text;
}

std::string program_and_commit_json() {
  std::vector<JsonMember> members = program_members();
  members.emplace_back("commit", json_text(commit_of_sources));
  members.emplace_back("derivatives", json_text(differentiation_name()));
  return json_object(members);
}

std::string date_text() {
  std::time_t now = std::time(nullptr);
  if (const char* epoch = std::getenv("SOURCE_DATE_EPOCH")) {
    char* end = nullptr;
    const long long seconds = std::strtoll(epoch, &end, 10);
    if (end != epoch && *end == '\0' && seconds >= 0) now = static_cast<std::time_t>(seconds);
  }
  char text[16] = "";
  if (const std::tm* utc = std::gmtime(&now)) std::strftime(text, sizeof text, "%Y-%m-%d", utc);
  return text;
}

}  // namespace tiltrotor::text

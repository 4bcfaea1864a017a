#include "cli/flight_script_checks.hpp"

#include <filesystem>

#include "cli/errors.hpp"

namespace tiltrotor::cli {

namespace {

namespace fs = std::filesystem;

struct NamedFile {
  std::string path, option;
};

// A device may be read and written at once.
bool is_same(const std::string& one, const std::string& other) {
  std::error_code error;
  if (fs::exists(one, error) && !fs::is_regular_file(one, error)) return false;
  if (fs::equivalent(one, other, error)) return true;
  return fs::absolute(one, error).lexically_normal() == fs::absolute(other, error).lexically_normal();
}

std::vector<NamedFile> written(const Arguments& arguments) {
  std::vector<NamedFile> files;
  const auto add = [&](const char* option, const std::string& name) {
    const std::string path = arguments.text(option, "-");
    if (path != "-") files.push_back({path + name, option});
  };
  add("--output", "");
  add("--modes", "");
  for (const char* name : {"/a.csv", "/b.csv"}) add("--matrices", name);
  for (const char* name : {"/flight.svg", "/flight_modes.svg"}) add("--figures", name);
  return files;
}

std::vector<NamedFile> read(const Arguments& arguments, const FlightScript& script) {
  std::vector<NamedFile> files;
  for (const char* option : {"--script", "--feedback", "--config"}) {
    const std::string path = arguments.text(option, "-");
    if (path != "-") files.push_back({path, option});
  }
  for (const InputSeries& series : script.series) files.push_back({series.name, "series"});
  return files;
}

}  // namespace

void require_files_apart(const Arguments& arguments, const FlightScript& script) {
  std::vector<NamedFile> taken = read(arguments, script);
  const std::size_t inputs = taken.size();
  for (const NamedFile& file : written(arguments)) {
    for (std::size_t k = 0; k < taken.size(); ++k)
      if (is_same(file.path, taken[k].path))
        throw UsageError(arguments.where(file.option) + ": " + file.path + " is what this flight " +
                         (k < inputs ? "reads" : "writes") + " as " + taken[k].option +
                         "; give another file");
    taken.push_back(file);
  }
}

void require_governed_ground(const FlightScript& script) {
  for (const ScriptEvent& e : script.events) {
    const bool climbs = e.command == ScriptCommand::hold_climb && e.number[0] > 0;
    if (climbs || e.command == ScriptCommand::hold_height) return;
    constexpr std::size_t ideal = 1;
    if (e.command == ScriptCommand::governor && e.word == ideal)
      throw UsageError(script.where(e) +
                       ": governor ideal: not before take-off (hold height, hold climb); give pi or off");
  }
}

}  // namespace tiltrotor::cli

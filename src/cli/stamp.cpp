#include "cli/stamp.hpp"

#include "cli/errors.hpp"
#include "text/identity.hpp"

namespace tiltrotor::cli {

Option stamp_option() {
  return {"--stamp", "", "begins CSV with lines of '#': version and command (JSON has its program)"};
}

std::string stamp_of(const Arguments& arguments, const std::string& format) {
  if (!arguments.given("--stamp")) return "";
  if (format != "csv" && format != "table")
    throw UsageError(arguments.where("--stamp") + ": " + format +
                     " has no place for comments, and tells its program anyway; choose csv or table");
  return "# " + identity_text() + "\n# tiltrotor " + arguments.line() + "\n";
}

}  // namespace tiltrotor::cli

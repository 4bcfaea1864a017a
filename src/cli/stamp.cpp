#include "cli/stamp.hpp"

#include "cli/errors.hpp"
#include "text/identity.hpp"

namespace tiltrotor::cli {

Option stamp_option() {
  return {"--stamp", "",
          "begins CSV with lines of '#', MATLAB with %: version and command\n(JSON has its program)"};
}

std::string stamp_of(const Arguments& arguments, const std::string& format) {
  if (!arguments.given("--stamp")) return "";
  if (format == "json")
    throw UsageError(arguments.where("--stamp") +
                     ": json has no place for comments, and tells its program anyway; choose csv or table");
  const std::string comment = format == "matlab" ? "% " : "# ";
  return comment + identity_text() + "\n" + comment + "tiltrotor " + arguments.line() + "\n";
}

}  // namespace tiltrotor::cli

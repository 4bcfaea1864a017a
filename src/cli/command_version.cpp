// `tiltrotor version`.

#include "cli/command.hpp"
#include "cli/errors.hpp"
#include "text/identity.hpp"
#include "text/sink.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

namespace tiltrotor::cli {

namespace {

int run(const Arguments&) {
  Sink sink("-", "");
  sink.write(identity_text() + "\n" + aircraft_identity().description + "\n");
  sink.finish();
  return exit_success;
}

}  // namespace

Command version_command() {
  return {"version",
          "version, aircraft, commit, and how this program differentiates",
          "Prints what was compiled in: version, aircraft, commit (where built from a git tree; + for "
          "changed files)\n"
          "and the way of differentiation, automatic or numerical; then what the aircraft is.\n",
          "tiltrotor version",
          {},
          run};
}

}  // namespace tiltrotor::cli

// `tiltrotor version`.

#include "cli/command.hpp"
#include "cli/errors.hpp"
#include "cli/sink.hpp"
#include "library/analyses.hpp"

namespace tiltrotor::cli {

namespace {

int run(const Arguments&) {
  Sink sink("-", "");
  sink.write(std::string("tiltrotor " TILTROTOR_VERSION " (") + differentiation_name() + " derivatives)\n");
  sink.finish();
  return exit_success;
}

}  // namespace

Command version_command() {
  return {"version",
          "version, and how this program differentiates",
          "Prints the version and the way of differentiation that was compiled in: automatic or numerical.\n",
          "tiltrotor version",
          {},
          run};
}

}  // namespace tiltrotor::cli

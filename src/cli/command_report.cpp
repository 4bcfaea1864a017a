// `tiltrotor report`: the whole study.

#include "cli/command.hpp"
#include "cli/errors.hpp"
#include "cli/sink.hpp"
#include "report/report.hpp"
#include "tiltrotor/model/aircraft_data.hpp"
#include "tiltrotor/tiltrotor.h"

namespace tiltrotor::cli {

namespace {

int run(const Arguments& arguments) {
  constexpr int published = TR_XV15;
  if (aircraft_identity().id != published) {
    throw UsageError(
        std::string("report: its published numbers are those of the XV-15, and this program flies the ") +
        aircraft_identity().name + "; make AIRCRAFT=xv15");
  }
  const std::string folder = arguments.text("--output", "build/report");
  require_writable_folder(folder, arguments.where("--output"));
  return report::run_report(folder, arguments.given("--validate") ? report::ReportSummary::validation
                                                                  : report::ReportSummary::statements);
}

}  // namespace

Command report_command() {
  return {"report",
          "the whole study: figures, numbers and a page to read",
          "Trim curves, modes, response and timing as SVG, CSV and one index.html.\n",
          "tiltrotor report --output build/report",
          {{"--output", "DIR", "folder to write, made when missing (build/report)"},
           {"--validate", "",
            "print every number against its published one, the worst first; exit 1 on a fault"}},
          run};
}

}  // namespace tiltrotor::cli

// `tiltrotor report`: the whole study.

#include "cli/command.hpp"
#include "cli/errors.hpp"
#include "cli/flown_mission.hpp"
#include "study/reference_points.hpp"
#include "study/report.hpp"
#include "text/sink.hpp"

namespace tiltrotor::cli {

namespace {

int run(const Arguments& arguments) {
  if (!study::has_reference_points())
    throw UsageError(
        "report: no published numbers of this aircraft; give tables/<aircraft>/published and build again");
  const std::string folder = arguments.text("--output", "build/report");
  require_writable_folder(folder, arguments.where("--output"));
  const study::ReportSummary summary =
      arguments.given("--validate") ? study::ReportSummary::validation : study::ReportSummary::statements;
  return study::run_report(folder, summary, fly_mission) ? exit_success : exit_case_failed;
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

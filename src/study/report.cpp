#include "study/report.hpp"

#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "study/page.hpp"
#include "study/sections.hpp"
#include "study/validation.hpp"
#include "study/wording.hpp"
#include "text/errors.hpp"
#include "text/identity.hpp"
#include "text/progress.hpp"
#include "text/sink.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

namespace tiltrotor::study {

namespace {

constexpr double kSweepMasts[] = {0, 15, 30, 45, 60, 75, 90};
constexpr double kSweepStep = 1;       // m/s
constexpr double kHighestSpeed = 140;  // m/s

struct File {
  std::string name;
  std::string text;
};

// Every file is complete under a temporary name before the first gets its own, the page last: a run that
// fails leaves an earlier report as it was.
void write_files(const std::string& folder, const std::vector<File>& files) {
  std::vector<std::unique_ptr<text::Sink>> sinks;
  for (const File& file : files) {
    sinks.push_back(
        std::make_unique<text::Sink>((std::filesystem::path(folder) / file.name).string(), "report"));
    sinks.back()->write(file.text);
  }
  for (const auto& sink : sinks) sink->finish();
}

std::vector<File> files_of(const PageHead& head, const std::vector<Section>& sections) {
  std::vector<File> files;
  for (const Section& section : sections) {
    for (const NumberedTable& t : section.tables) files.push_back({t.name + ".csv", t.table.csv()});
    for (const Picture& p : section.pictures) {
      files.push_back({p.name + ".svg", "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + p.svg});
    }
  }
  // Apart from the data, which stay comparable from run to run.
  files.push_back({"run.txt", text::identity_text() + "\n" + text::date_text() + "\n"});
  files.push_back({"index.html", page(head, sections)});
  return files;
}

PageHead page_head(const std::vector<Section>& sections, double seconds) {
  std::size_t pictures = 0;
  int counts[4] = {};
  for (const Section& s : sections) {
    pictures += s.pictures.size();
    for (const Finding& f : s.findings) ++counts[static_cast<std::size_t>(f.verdict)];
  }
  const auto count = [&counts](Finding::Verdict verdict) {
    return std::to_string(counts[static_cast<std::size_t>(verdict)]);
  };
  PageHead head;
  const std::string name = aircraft_identity().name;
  head.title = name + " flight dynamics: the study";
  head.lead =
      "Trim, exact linear models, modes and response of the " + name +
      " tilt rotor, computed from its published "
      "tables, in the "
      "order of Yuan, Thomson and Anderson (Journal of Aircraft, 2020). Every curve was computed in this "
      "run; marks without "
      "a line are published numbers. Each statement is judged on the numbers beside it.";
  head.facts = {
      text::identity_text() + "; run of " + text::date_text(),
      std::to_string(pictures) + " figures, computed in " + fixed(seconds, 1) + " s",
      "statements: " + count(Finding::holds) + " hold, " + count(Finding::partly) + " hold in part, " +
          count(Finding::differs) + " differ",
      std::string(
          "aircraft: 13000 lb, centre of gravity at station 301.2 in, sea level, standard day, unless "
          "said otherwise"),
      std::string(
          "governor: none, rotor speed and collective held, unless said otherwise; of a trim, rotor speed held "
          "and power what it takes")};
  return head;
}

void print_summary(const std::vector<Section>& sections) {
  for (const Section& section : sections) {
    std::printf("\n%s\n", section.title.c_str());
    for (const Finding& f : section.findings) {
      std::printf("  %-8s %s\n           %s\n", verdict_word(f.verdict), f.statement.c_str(),
                  f.found.c_str());
    }
  }
}

}  // namespace

bool run_report(const std::string& folder, ReportSummary summary, const FlyMission& fly_mission) {
  const auto start = std::chrono::steady_clock::now();
  std::vector<Section> sections;
  std::optional<Validation> validation;
  try {
    Sweeps sweeps;
    Uncertainty bands;
    const std::vector<std::function<Section()>> parts = {
        [&] { return trim_curves(sweeps, bands); },
        [&] { return mode_map(sweeps, bands); },
        [&] { return collective_response(bands); },
        jacobian_timing,
        conversion_corridor,
        mast_locus,
        [&] { return power_required(sweeps); },
        [&] { return load_sharing(sweeps); },
        isolated_rotor_tests,
        lateral_flapping,
        rotor_descent,
        [&] { return control_response(sweeps); },
        frequency_responses,
        linear_matrices,
        [&] { return mission(fly_mission()); },
        [&] { return uncertainty_shares(bands); },
        data_flow,
    };
    text::Progress progress("report", parts.size() + std::size(kSweepMasts) + 1);
    for (const double mast : kSweepMasts) {
      sweeps.push_back(speed_sweep(mast, kSweepStep, kHighestSpeed));
      progress.advance();
    }
    bands = uncertainty();
    progress.advance();
    for (const auto& part : parts) {
      sections.push_back(part());
      progress.advance();
    }
    validation = validate(sections);
    sections.push_back(validation_section(*validation));
  } catch (const text::UsageError&) {
    throw;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tiltrotor: report: %s\n", error.what());
    return false;
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  write_files(folder, files_of(page_head(sections, seconds), sections));
  if (summary == ReportSummary::validation) {
    print(*validation);
  } else {
    print_summary(sections);
  }
  std::printf("\n%s\n", (std::filesystem::path(folder) / "index.html").string().c_str());
  if (summary == ReportSummary::validation && !validation->faults.empty()) {
    for (const std::string& fault : validation->faults)
      std::fprintf(stderr, "tiltrotor: report: %s\n", fault.c_str());
    return false;
  }
  return true;
}

}  // namespace tiltrotor::study

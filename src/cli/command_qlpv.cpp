// `tiltrotor qlpv`: linear models on a grid as one file, and what interpolation between them is worth.

#include <cstdio>
#include <limits>
#include <map>

#include "cli/command.hpp"
#include "cli/errors.hpp"
#include "cli/governed.hpp"
#include "cli/linear_json.hpp"
#include "cli/output.hpp"
#include "cli/qlpv_check.hpp"
#include "text/identity.hpp"
#include "text/json.hpp"
#include "text/progress.hpp"

namespace tiltrotor::cli {

namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

int told(const QlpvGrid& grid, const SchedulingPoint& at, const QlpvPoint& point, Progress& progress) {
  if (!point.explanation.empty())
    progress.message(grid.where(at) + ": " + point.status + ": " + point.explanation);
  return point.valid && point.explanation.empty() ? exit_success : exit_case_failed;
}

std::string head_json(const QlpvGrid& grid) {
  std::string variables;
  for (int k = 0; k < kSchedulingVariables; ++k)
    variables += std::string(k > 0 ? ",\n" : "") + json_object({{"name", json_text(kSchedulingNames[k])},
                                                                {"unit", json_text(kSchedulingUnits[k])},
                                                                {"values", json_array(grid.axis(k))}});
  return "{\n\"kind\": \"qlpv\",\n\"program\": " + program_and_commit_json() + ",\n\"scheduling\": [\n" +
         variables + "\n],\n\"interpolation\": " +
         json_text(
             "every x0, u0, y0, A, B, C, D linear along each scheduling variable; "
             "xdot = A (x - x0) + B (u - u0), y = y0 + C (x - x0) + D (u - u0)") +
         ",\n" + names_json(grid.names()) + ",\n\"points\": [\n";
}

std::string point_json(const QlpvGrid& grid, const SchedulingPoint& at, const QlpvPoint& point) {
  std::string text = "{\n";
  for (int k = 0; k < kSchedulingVariables; ++k)
    text += "\"" + std::string(kSchedulingNames[k]) + "\": " + json_number(at[k]) + ", ";
  text +=
      "\"status\": " + json_text(point.status) + ",\n\"settings\": " + settings_json(grid.settings(point));
  if (point.valid) text += ",\n" + matrices_json(point.shown);
  return text + "\n}";
}

int write_model(const Arguments& arguments, const QlpvGrid& grid) {
  arguments.choice("--format", "json", {"json"});
  if (arguments.given("--stamp"))
    throw UsageError(
        arguments.where("--stamp") +
        ": json has no place for comments, and tells its program anyway; goes with --show check");
  const Shard shard = parse_shard(arguments.text("--shard", "1/1"), arguments.where("--shard"));
  Sink sink(arguments.text("--output", "-"), arguments.where("--output"));
  const AnalysesWorkspace work;
  const std::size_t count = grid.points();
  Progress progress(arguments.command(), shard.end(count) - shard.begin(count));
  int exit_status = exit_success;
  if (shard.first()) sink.write(head_json(grid));
  for (std::size_t i = shard.begin(count); i < shard.end(count); ++i) {
    SchedulingPoint at;
    grid.place_point(i, at);
    const QlpvPoint point = grid.find(at, *work);
    sink.write((i > 0 ? ",\n" : "") + point_json(grid, at, point));
    if (told(grid, at, point, progress) != exit_success) exit_status = exit_case_failed;
    progress.advance();
  }
  if (shard.part == shard.parts) sink.write("\n]\n}\n");
  sink.finish();
  return exit_status;
}

const std::vector<std::string> check_columns = {
    "mast_deg", "speed_mps",         "altitude_m",        "kind",  "name",        "real",
    "imag",     "interpolated_real", "interpolated_imag", "error", "worst_rad_s", "status"};

class Checker {
 public:
  Checker(const Arguments& arguments, const QlpvGrid& grid)
      : grid_(grid),
        output_(arguments),
        records_(output_.records(check_columns, Output::to_read)),
        progress_(arguments.command(),
                  output_.shard().end(grid.cells()) - output_.shard().begin(grid.cells())) {}

  int run() {
    int exit_status = exit_success;
    const std::size_t count = grid_.cells();
    for (std::size_t i = output_.shard().begin(count); i < output_.shard().end(count); ++i) {
      if (check_cell(i) != exit_success) exit_status = exit_case_failed;
      progress_.advance();
    }
    records_.finish();
    return exit_status;
  }

 private:
  struct Corner {
    std::unique_ptr<VehicleMatrices> model;  // none: not valid
    ShownModel shown;
    std::string status;
  };
  // Corners are shared by neighbours; those before the first of a cell are not asked for again.
  const Corner& corner(std::size_t number) {
    const auto known = corners_.find(number);
    if (known != corners_.end()) return known->second;
    SchedulingPoint at;
    grid_.place_point(number, at);
    QlpvPoint found = grid_.find(at, *work_);
    told(grid_, at, found, progress_);
    if (!found.valid) found.model.reset();
    return corners_[number] = {std::move(found.model), std::move(found.shown), found.status};
  }

  int check_cell(std::size_t number) {
    SchedulingPoint centre;
    std::vector<std::size_t> corners;
    grid_.place_cell(number, centre, corners);
    std::vector<const VehicleMatrices*> models;
    std::vector<const ShownModel*> shown;
    corners_.erase(corners_.begin(), corners_.lower_bound(corners.front()));
    for (const std::size_t place : corners) {
      const Corner& found = corner(place);
      if (found.model == nullptr) return add_failed(centre, "corner_" + found.status);
      models.push_back(found.model.get());
      shown.push_back(&found.shown);
    }
    const QlpvPoint exact = grid_.find(centre, *work_);
    told(grid_, centre, exact, progress_);
    if (!exact.valid) return add_failed(centre, exact.status);
    QlpvErrors errors;
    const auto mean = mean_model(models);
    Status status = qlpv_errors(*exact.model, *mean, *work_, errors);
    if (status == Status::ok && !grid_.outputs().empty())
      status = qlpv_output_errors(exact, *mean, shown, errors);
    if (status != Status::ok) return add_failed(centre, status_word(status));
    for (const QlpvRoot& root : errors.roots)
      records_.add({centre[kByMast], centre[kBySpeed], centre[kByAltitude], "root", root.name,
                    root.exact.real(), root.exact.imag(), root.interpolated.real(), root.interpolated.imag(),
                    root.error(), kNothing, exact.status});
    for (const QlpvResponse& response : errors.responses)
      records_.add({centre[kByMast], centre[kBySpeed], centre[kByAltitude], "response", response.name,
                    kNothing, kNothing, kNothing, kNothing, response.error, response.omega, exact.status});
    for (const QlpvReading& reading : errors.readings)
      records_.add({centre[kByMast], centre[kBySpeed], centre[kByAltitude], "output", reading.name,
                    reading.exact, kNothing, reading.interpolated, kNothing, reading.error(), kNothing,
                    exact.status});
    return exit_success;
  }
  int add_failed(const SchedulingPoint& centre, const std::string& status) {
    records_.add({centre[kByMast], centre[kBySpeed], centre[kByAltitude], "", "", kNothing, kNothing,
                  kNothing, kNothing, kNothing, kNothing, status});
    return exit_case_failed;
  }

  const QlpvGrid& grid_;
  Output output_;
  Records records_;
  Progress progress_;
  AnalysesWorkspace work_;
  std::map<std::size_t, Corner> corners_;
};

int run(const Arguments& arguments) {
  const QlpvGrid grid(arguments);
  if (arguments.choice("--show", "model", {"model", "check"}) == 0) return write_model(arguments, grid);
  if (grid.cells() == 0)
    throw UsageError(arguments.where("--show") + " check: needs two values of --altitude, --mast or --speed");
  return Checker(arguments, grid).run();
}

}  // namespace

Command qlpv_command() {
  return {
      "qlpv",
      "linear models on a grid in one file, and the error of interpolation",
      "A quasi-linear parameter-varying model: trim and exact A, B, C, D at every combination of --altitude, --mast and\n"
      "--speed, the scheduling variables; everything else takes one value. JSON (--format json):\n"
      "  kind program scheduling[{name,unit,values}] interpolation states[{name,unit}] controls outputs\n"
      "  points[{altitude_m mast_deg speed_mps status settings x0 u0 y0 A B C D}], speed fastest, altitude slowest.\n"
      "A point without a trim has no matrices. Flaps and rotor speed are those of `trim` at each mast angle: give\n"
      "--flap and --rotor-rpm where they shall not jump. Shards join in order to the file as one run writes it. With a\n"
      "governor or --scas on rows and columns are those of `linearize`: states of systems, rotor speed among them, throttles.\n"
      "--outputs and --feedback as in `linearize`: these rows of C, D and y0 (all that instruments read), the closed loop.\n"
      "--show check: at the centre of every cell the mean of its corners against the model of a trim there; of each root\n"
      "the distance over its size, of each inceptor's response the largest |G' - G|/|G| within 0.1..10 rad/s, and where;\n"
      "of each of --outputs its y0 (`real`), and its response to the input that moves it most.\n",
      "tiltrotor qlpv --mast 90 --speed 90,100 --show check",
      OptionList{{"--show", "KIND", "model: the file; check: errors of interpolation (model)"}} +
          reduce_option() + control_set_option() + outputs_option() + scas_option() + feedback_option() +
          flight_list() + SetupOptions::list() + Output::list(),
      run};
}

}  // namespace tiltrotor::cli

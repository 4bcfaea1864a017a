// `tiltrotor rotor`: one rotor alone, as on a test stand or in a wind tunnel.

#include <cmath>
#include <limits>

#include "cli/command.hpp"
#include "cli/errors.hpp"
#include "cli/flight_options.hpp"
#include "cli/output.hpp"
#include "text/progress.hpp"
#include "text/rounding.hpp"
#include "tiltrotor/analysis/isolated_rotor.hpp"

namespace tiltrotor::cli {

namespace {

constexpr double radian = kRadPerDeg<double>;
constexpr double kilo = 1000;
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

constexpr Range collective_range{-90, 90, "deg"};
Range hub_speed_range() { return {-kSpeedRange.high, kSpeedRange.high, "m/s"}; }
constexpr Range cyclic_range{-30, 30, "deg"};

struct Case {
  double rotor_speed;                                               // rad/s
  double rpm, collective_deg, lateral_cyclic_deg, long_cyclic_deg;  // as given
  RotorFlow<double> flow;
};

using Rotor = const IsolatedRotor<double>&;

struct Column {
  const char* name;
  double (*value)(Rotor);
  bool always = false;                      // also without an equilibrium
  double (*given)(const Case&) = nullptr;   // instead of the value, as it was given
  bool (*is_given)(const Case&) = nullptr;  // null: always
};

bool cyclic_is_given(const Case& c) { return c.flow.cyclic == CyclicUse::given; }

// Force without the rounding of a thrust beside which it is nothing.
Vec3<double> in_plane(Rotor r) {
  const Vec3<double>& force = r.response.loads.force_a;
  return without_rounding(force, std::sqrt(dot(force, force)));
}

// The column `status` follows them.
const Column numbers[] = {
    {"collective75_deg", nullptr, true, [](const Case& c) { return c.collective_deg; }},
    {"ct", [](Rotor r) { return r.figures.thrust_coefficient; }},
    {"cp", [](Rotor r) { return r.figures.power_coefficient; }},
    {"figure_of_merit", [](Rotor r) { return r.figures.figure_of_merit; }},
    {"ct_sigma", [](Rotor r) { return r.figures.thrust_coefficient / r.figures.solidity; }},
    {"thrust_n", [](Rotor r) { return r.figures.thrust; }},
    {"power_kw", [](Rotor r) { return r.figures.power / kilo; }},
    {"b1c_deg", [](Rotor r) { return r.input.state.b1c / radian; }},
    {"b1s_deg", [](Rotor r) { return r.input.state.b1s / radian; }},
    {"n0", [](Rotor r) { return r.input.state.lambda_0; }},
    {"efficiency", [](Rotor r) { return r.figures.efficiency; }},
    {"cp_sigma", [](Rotor r) { return r.figures.power_coefficient / r.figures.solidity; }},
    {"nc", [](Rotor r) { return r.input.state.lambda_c; }},
    {"ns", [](Rotor r) { return r.input.state.lambda_s; }},
    {"lateral_cyclic_deg", [](Rotor r) { return r.input.lateral_cyclic / radian; }, false,
     [](const Case& c) { return c.lateral_cyclic_deg; }, cyclic_is_given},
    {"long_cyclic_deg", [](Rotor r) { return r.input.long_cyclic / radian; }, false,
     [](const Case& c) { return c.long_cyclic_deg; }, cyclic_is_given},
    {"coning_deg", [](Rotor r) { return r.input.coning.angle / radian; }},
    {"force_aft_n", [](Rotor r) { return in_plane(r).x; }},
    {"force_advancing_n", [](Rotor r) { return in_plane(r).y; }},
    {"torque_nm", [](Rotor r) { return r.figures.torque; }},
    {"rotor_rpm", nullptr, true, [](const Case& c) { return c.rpm; }},
    {"speed_axial_mps", nullptr, true, [](const Case& c) { return c.flow.axial; }},
    {"speed_inplane_mps", nullptr, true, [](const Case& c) { return c.flow.in_plane; }},
    {"axial_ratio", [](Rotor r) { return r.figures.axial_ratio; }, true},
    {"advance_ratio", [](Rotor r) { return r.figures.advance_ratio; }, true},
    {"iterations", [](Rotor r) { return static_cast<double>(r.iterations); }, true},
    {"residual", [](Rotor r) { return r.residual; }, true},
};

std::vector<std::string> column_names() {
  std::vector<std::string> names;
  for (const Column& column : numbers) names.emplace_back(column.name);
  names.emplace_back("status");
  return names;
}

// Every combination; the collective changes fastest.
std::vector<Case> cases(const Arguments& arguments, double default_rotor_speed) {
  Case one{};
  RotorFlow<double>& flow = one.flow;
  one.lateral_cyclic_deg = arguments.number("--lateral-cyclic", 0, cyclic_range);
  one.long_cyclic_deg = arguments.number("--long-cyclic", 0, cyclic_range);
  flow.lateral_cyclic = one.lateral_cyclic_deg * radian;
  flow.long_cyclic = one.long_cyclic_deg * radian;
  flow.cyclic = arguments.given("--cancel-tilt") ? CyclicUse::cancels_tilt : CyclicUse::given;
  for (const char* name : {"--lateral-cyclic", "--long-cyclic"})
    if (flow.cyclic == CyclicUse::cancels_tilt && arguments.given(name))
      throw UsageError(arguments.where(name) + ": --cancel-tilt finds the cyclic; leave one of the two out");
  std::vector<double> rotor_speeds = {given_as(default_rotor_speed, kRpm)};
  if (arguments.given("--rpm")) rotor_speeds = arguments.sweep("--rpm", "", kRotorSpeedRange);
  const std::vector<double> axial = arguments.sweep("--speed-axial", "0", hub_speed_range());
  const std::vector<double> in_plane = arguments.sweep("--speed-inplane", "0", hub_speed_range());
  const std::vector<double> collective = arguments.sweep("--collective75", "0:1:16", collective_range);
  require_few(arguments.command(), {rotor_speeds.size(), axial.size(), in_plane.size(), collective.size()});
  std::vector<Case> all;
  for (const double rpm : rotor_speeds) {
    for (const double a : axial) {
      for (const double i : in_plane) {
        for (const double pitch : collective) {
          one.rpm = rpm;
          one.rotor_speed = arguments.given("--rpm") ? rpm * kRpm : default_rotor_speed;
          one.collective_deg = pitch;
          flow.axial = a;
          flow.in_plane = i;
          flow.collective = pitch * radian;
          all.push_back(one);
        }
      }
    }
  }
  return all;
}

// In its own wake a rotor has figures where the inflow law knows it.
bool has_figures(const Options& options, Status status) {
  return status == Status::ok ||
         (status == Status::vortex_ring && options.descent_inflow == DescentInflow::vortex_ring);
}

Cell cell(const Column& column, const Case& which, bool has_figures, Rotor rotor) {
  if (!has_figures && !column.always) return nothing;
  const bool is_given = column.given != nullptr && (column.is_given == nullptr || column.is_given(which));
  return is_given ? Cell(as_given(column.given(which))) : Cell(column.value(rotor));
}

std::string explanation(Status status, Rotor rotor) {
  if (status == Status::vortex_ring && rotor.momentum == MomentumRange::other_branch)
    return "no windmill found: in the equilibrium found the wake goes down against the air that comes up";
  if (status == Status::vortex_ring) return status_text(status);
  return std::string(status_text(status)) + "; residual " + number_text(rotor.residual, 3);
}

int run(const Arguments& arguments) {
  const SetupOptions setup(arguments);
  const double mast_deg = arguments.number("--mast", 0, kMastRange);
  const std::vector<Case> all = cases(arguments, setup.configuration(mast_deg).setup.rotor_speed);
  Output output(arguments);
  Records records = output.records(column_names(), Output::to_read);
  const std::size_t begin = output.shard().begin(all.size());
  const std::size_t end = output.shard().end(all.size());
  Progress progress("rotor", end - begin);
  int exit_status = exit_success;
  IsolatedRotorWorkspace<double> work;
  for (std::size_t i = begin; i < end; ++i) {
    const Configuration<double> configuration = setup.configuration(mast_deg, all[i].rotor_speed);
    IsolatedRotor<double> rotor;
    const Status status = isolated_rotor(configuration, all[i].flow, work, rotor);
    Row row;
    const bool found = has_figures(configuration.setup.options, status);
    for (const Column& column : numbers) row.push_back(cell(column, all[i], found, rotor));
    row.emplace_back(status_word(status));
    records.add(row);
    if (status != Status::ok) {
      progress.message("rotor: collective " + number_text(all[i].collective_deg, 6) + " deg, axial " +
                       number_text(all[i].flow.axial, 6) + " m/s: " + explanation(status, rotor));
      exit_status = exit_case_failed;
    }
    progress.advance();
  }
  records.finish();
  return exit_status;
}

OptionList options() {
  const auto limits = [](const Range& range) {
    return number_text(range.low) + ".." + number_text(range.high);
  };
  static const std::string rotor = "rotor speed, " + limits(kRotorSpeedRange) + " (that of the mast angle)";
  static const std::string axial =
      "up the shaft: climb, or forward in airplane mode, " + limits(hub_speed_range()) + " (0)";
  static const std::string across = "across the shaft, " + limits(hub_speed_range()) + " (0)";
  return {
      {"--collective75", "DEG", "blade pitch at 0.75 R, -90..90 (0:1:16)"},
      {"--rpm", "RPM", rotor.c_str()},
      {"--speed-axial", "MPS", axial.c_str()},
      {"--speed-inplane", "MPS", across.c_str()},
      {"--lateral-cyclic", "DEG", "A1, -30..30 (0)"},
      {"--long-cyclic", "DEG", "B1, -30..30 (0)"},
      {"--cancel-tilt", "", "find the cyclic that holds the disk normal to the shaft"},
  };
}

}  // namespace

Command rotor_command() {
  return {
      "rotor",
      "one rotor alone on a fixed shaft: thrust, power, efficiency",
      "Brings inflow and flapping into equilibrium at every combination of pitch, rotor speed and flow "
      "(each a\n"
      "value, a list or a range). figure_of_merit stands where the rotor hovers, efficiency (thrust "
      "times axial\n"
      "speed over power) where it propels. The mast angle sets coning and the default rotor speed. With "
      "the status\n"
      "vortex_ring the rotor descends in its own wake: figures are means of an unsteady flow. By momentum theory "
      "alone\n"
      "(--option descent_inflow=momentum) there are none, nor where no windmill balances the thrust.\n",
      "tiltrotor rotor --collective75 4:1:14 --rpm 589",
      options() + mast_option() + SetupOptions::rotor_list() + Output::list(),
      run};
}

}  // namespace tiltrotor::cli

// `sensitivity` of trims that hold a result. Expected: differences of complete new searches of `trim` and `modes` with the
// same --hold, and of trims of an aircraft changed by hand; extrapolated from two steps, so that what they leave out goes
// with the fourth power of the step.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "check.hpp"
#include "cli/analyses_workspace.hpp"
#include "cli/csv_text.hpp"
#include "cli/refused.hpp"
#include "cli/sensitivity.hpp"
#include "cli/targeted_trim.hpp"
#include "run_program.hpp"
#include "this_aircraft.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

using namespace tiltrotor;
using check::CsvText;
using check::run_tiltrotor;

namespace {

struct Parameter {
  const char *name, *option, *column;
  double value, step;
};
const Parameter kMass{"mass", "--mass", "mass_kg", 5700, 1},
    kStation{"cg_station", "--cg-sl", "cg_sl_in", 299, 0.01},
    kSpeed{"speed", "--speed", "speed_mps", 57, 0.002}, kFlap{"flap", "--flap", "flap_deg", 12, 0.01},
    kRotor{"rotor_speed", "--rotor-rpm", "rotor_rpm", 560, 0.05},
    kAltitude{"altitude", "--altitude", "altitude_m", 700, 1};

struct Held {
  std::string flight;  // with what is held
  const Parameter* parameter;
};
const std::string kAt = "--mast 37 --sideslip 2 ", kStraight = "--mast 37 ";

std::string with_value(const Held& held, double by) {
  std::string options = " --format csv --grid realtime " + held.flight;
  for (const Parameter* p : {&kMass, &kStation, &kSpeed, &kFlap, &kRotor, &kAltitude}) {
    if (held.flight.find(p->option) != std::string::npos) continue;
    if (held.flight.find("--free " + std::string(p->column)) != std::string::npos) continue;
    char text[40];
    std::snprintf(text, sizeof text, "%.12g", p->value + (p == held.parameter ? by : 0));
    options += std::string(" ") + p->option + " " + text;
  }
  return options;
}

std::size_t row_of(const CsvText& rows, const std::string& mode) {
  for (std::size_t i = 0; i < rows.rows.size(); ++i)
    if (mode.empty() || rows.text(i, "mode") == mode) return i;
  throw std::runtime_error("no row of " + mode);
}

double extrapolated(const double (&at)[4]) { return (8 * (at[2] - at[3]) - (at[0] - at[1])) / 6; }

void compare(const Held& held, const std::string& of, const std::string& mode,
             std::initializer_list<const char*> numbers) {
  const double step = held.parameter->step, by[4] = {step, -step, step / 2, -step / 2};
  const CsvText found(
      run_tiltrotor("sensitivity --of " + of + " --to " + held.parameter->name + with_value(held, 0)).out);
  CsvText run[4] = {CsvText(""), CsvText(""), CsvText(""), CsvText("")};
  for (int k = 0; k < 4; ++k) run[k] = CsvText(run_tiltrotor(of + with_value(held, by[k])).out);
  const std::size_t row = row_of(found, mode);
  for (const char* number : numbers) {
    double at[4];
    for (int k = 0; k < 4; ++k) at[k] = run[k].number(row_of(run[k], mode), number);
    const double scale = found.number(row, "change") / step, expected = scale * extrapolated(at);
    const double got = found.number(row, std::string("d_") + number);
    // 12 digits are printed, and searches end within 1e-10 of what is held.
    if (!CHECK_NEAR(got, expected,
                    1e-8 * (1 + scale) * (1 + 1e-3 * std::fabs(at[0])) + 1e-6 * std::fabs(expected)))
      NOTE(held.flight << " by " << held.parameter->name << ": " << mode << " " << number);
  }
}

}  // namespace

TEST_OF_XV15(cli_sensitivity_with_a_result_held_is_that_of_new_searches) {
  const Held cases[] = {
      {kAt + "--hold power_kw=970 --free climb_deg", &kMass},
      {kAt + "--hold power_kw=970 --free climb_deg", &kFlap},
      {kAt + "--bank 20", &kSpeed},
      {kAt + "--load-factor 1.1", &kMass},
      {kAt + "--hold pitch_deg=4 --free speed_mps --speed 57", &kAltitude},
      {kAt + "--hold nz@230/0/75=1.1 --free turn_rate_degps --turn-rate 3", &kStation},
      {kAt + "--hold htail_angle_of_attack=-0.002 --free cg_sl_in", &kSpeed},
      {kAt + "--hold thrust_right_n=12300 --free mass_kg", &kStation},
      {kAt + "--hold rotor_right_force_x=6230 --free altitude_m", &kRotor},
      {kAt + "--hold collective75_deg=13 --free rotor_rpm", &kMass},
      {kStraight + "--hold ny=0.03 --free sideslip_deg --turn-rate 3", &kMass},
      {kStraight + "--ball centred --bank 20 --hold power_kw=1000 --free climb_deg", &kStation},
      {"--mast 4 --azimuth 180 --climb 10 --speed 11 --hold power_kw=1240 --free climb_deg", &kMass},
  };
  for (const Held& held : cases) {
    compare(held, "trim", "",
            {"pitch_deg", "roll_deg", "collective75_deg", "long_stick_in", "lat_stick_in", "pedal_in",
             "power_kw"});
    compare(held, "modes", "phugoid", {"real", "imag"});
  }
  for (const std::string systems : {"--option governor=pi ", "--scas on "}) {
    const Held governed{kAt + systems + "--hold power_kw=970 --free climb_deg", &kMass};
    compare(governed, "modes", "phugoid", {"real", "imag"});
    compare(governed, "modes", "dutch_roll", {"real", "imag"});
  }
}

// Numbers of the aircraft, which no option changes: against the same search with the aircraft changed. What is held stays.
TEST_OF_XV15(cli_sensitivity_with_a_result_held_is_that_of_new_aircraft) {
  const cli::AnalysesWorkspace work;
  static cli::TrimmedFlight base;
  base = {};
  FlightSetup<double> setup = flight_setup(aircraft_data<double>(), 33.0);
  setup.options.grid = BladeGrid::realtime;
  base.flight = {53, 0, 0.03, 0.02};
  base.targets = {{"power_kw", 900, "climb_deg", "--hold"},
                  {"load_factor", 1.02, "turn_rate_degps", "--hold"}};
  base.turn_rate_degps = 0.03 * 180 / kPi<double>;
  CHECK(prepare(aircraft_data<double>(), setup, base.configuration) == Status::ok);
  cli::TrimmedFlight start = base;
  CHECK_EQ(trim_to_targets(base.targets, *work, base), std::string());
  cli::Sensitivity sensitivity({Governor::off, false});
  CHECK(sensitivity.begin(base, *work) == Status::ok);
  for (const cli::SensitivityParameter& p : cli::sensitivity_parameters()) {
    const char* const some[] = {"tail_incidence", "hub_spring", "blade_drag_factor", "drag_area",
                                "cyclic_rigging"};
    if (std::none_of(std::begin(some), std::end(some),
                     [&](const char* s) { return std::strcmp(s, p.name) == 0; }))
      continue;
    cli::FlightMotion motion;
    CHECK(sensitivity.move(p, motion) == Status::ok);
    const double part = 0.05, by[4] = {part, -part, part / 2, -part / 2};
    double at[4][4];
    for (int k = 0; k < 4; ++k) {
      const cli::ChangedAircraft changed(
          start.configuration, [&](cli::ChangedAircraft& a) { p.change.anew(a, by[k] * p.amount); });
      cli::TrimmedFlight flight = start;
      flight.configuration = changed.configuration();
      CHECK_EQ(trim_to_targets(base.targets, *work, flight), std::string());
      const TrimResult<double>& t = flight.trim;
      const double numbers[] = {t.state.pitch, t.state.velocity.z, t.controls.collective,
                                t.controls.long_stick};
      std::copy(std::begin(numbers), std::end(numbers), at[k]);
    }
    const double found[] = {motion.trim.x.pitch, motion.trim.x.velocity.z, motion.trim.u.collective,
                            motion.trim.u.long_stick};
    for (int i = 0; i < 4; ++i) {
      const double expected = extrapolated({at[0][i], at[1][i], at[2][i], at[3][i]}) / part;
      if (!CHECK_NEAR(found[i], expected, 1e-7 + 1e-5 * std::fabs(expected))) NOTE(p.name << " number " << i);
    }
    CHECK_NEAR(motion.power, 0, 1e-6 * 900e3);
  }
}

// What is let go is no parameter.
TEST(cli_sensitivity_with_a_result_held_refuses_what_is_let_go) {
  check::check_refused("sensitivity --grid realtime --to speed,mass --hold pitch_deg=1 --free speed_mps",
                       "speed follows the others");
  check::check_refused("sensitivity --grid realtime --to turn_rate --bank 20",
                       "turn_rate follows the others");
  const CsvText all(
      run_tiltrotor(this_aircraft::flown("sensitivity --grid realtime --format csv --of trim --mast 30 "
                                         "--speed 50 --bank 20"))
          .out);
  for (std::size_t i = 0; i < all.rows.size(); ++i) {
    CHECK(all.text(i, "parameter") != "turn_rate");
    CHECK_NEAR(all.number(i, "d_roll_deg"), 0, 1e-9);
  }
  CHECK_LT(50u, all.rows.size());
}

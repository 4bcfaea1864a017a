// `sensitivity`. Expected: differences of complete runs of `modes` and `trim`, and of new trims of an aircraft changed by
// hand; both extrapolated from two steps, so that what they leave out goes with the fourth power of the step.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "check.hpp"
#include "cli/analyses_workspace.hpp"
#include "cli/csv_text.hpp"
#include "cli/governed.hpp"
#include "cli/json_grammar.hpp"
#include "cli/refused.hpp"
#include "cli/sensitivity.hpp"
#include "run_program.hpp"
#include "this_aircraft.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

using namespace tiltrotor;
using check::CsvText;
using check::run_tiltrotor;
using cli::ChangedAircraft;
using cli::FlightMotion;
using cli::Sensitivity;
using cli::SensitivityParameter;
using cli::SensitivitySystems;

namespace {

std::string exactly(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.12g", value);
  return text;
}

CsvText rows_of(const std::string& command) {
  return CsvText(run_tiltrotor(this_aircraft::flown(command + " --format csv --grid realtime")).out);
}

std::size_t row_of(const CsvText& rows, const std::string& column, const std::string& word) {
  for (std::size_t i = 0; i < rows.rows.size(); ++i)
    if (rows.text(i, column) == word) return i;
  throw std::runtime_error("no row of " + word);
}

double extrapolated(double above, double below, double near_above, double near_below) {
  return (8 * (near_above - near_below) - (above - below)) / 6;  // over the longer step
}

// A setting of the flight: its parameter, its option, where it is and its step.
struct Setting {
  const char *parameter, *option;
  double value, step;
};
const Setting settings[] = {{"speed", "--speed", 57, 0.002},   {"turn_rate", "--turn-rate", 2, 0.002},
                            {"mass", "--mass", 5700, 0.4},     {"cg_station", "--cg-sl", 299, 0.005},
                            {"flap", "--flap", 12, 0.005},     {"rotor_speed", "--rotor-rpm", 560, 0.02},
                            {"altitude", "--altitude", 700, 1}};
std::string flight(const std::string& changed, const std::string& value) {
  std::string options = " --mast 37 --sideslip 2";
  for (const Setting& s : settings)
    options += std::string(" ") + s.option + " " + (changed == s.option ? value : exactly(s.value));
  return options;
}

}  // namespace

TEST_OF_XV15(cli_sensitivity_of_modes_is_that_of_new_runs_of_modes) {
  for (const Setting& s : settings) {
    const CsvText found = rows_of("sensitivity --to " + std::string(s.parameter) + flight("", ""));
    CsvText run[4] = {CsvText(""), CsvText(""), CsvText(""), CsvText("")};
    const double by[4] = {s.step, -s.step, s.step / 2, -s.step / 2};
    for (int k = 0; k < 4; ++k) run[k] = rows_of("modes" + flight(s.option, exactly(s.value + by[k])));
    for (const char* mode : {"dutch_roll", "phugoid", "roll", "spiral"}) {
      const std::size_t row = row_of(found, "mode", mode);
      const double scale = found.number(row, "change") / s.step;
      for (const char* number : {"damping_ratio", "frequency_rad_s", "real", "imag"}) {
        double at[4];
        for (int k = 0; k < 4; ++k) at[k] = run[k].number(row_of(run[k], "mode", mode), number);
        const double expected = scale * extrapolated(at[0], at[1], at[2], at[3]);
        // 12 digits are printed.
        const double rounding = 1e-11 * scale * (1 + std::abs(at[0]));
        CHECK_NEAR(found.number(row, std::string("d_") + number), expected, rounding + 1e-7);
      }
    }
  }
}

// Warmer air and higher flights are known mixtures of both: of the ideal gas at one pressure, and of the standard
// troposphere. Steps are short: a knot of a table lies near.
TEST_OF_XV15(cli_sensitivity_to_air_goes_with_systems) {
  constexpr double temperature = 288.15 - 0.0065 * 700;
  struct Way {
    const char* option;
    double value, step, density, sound;  // percent a unit
  };
  const Way ways[] = {{"--isa-offset", 0, 0.04, -100 / temperature, 50 / temperature},
                      {"--altitude", 700, 2, -0.65 * 4.2559 / temperature, -0.325 / temperature}};
  for (const std::string systems :
       {" --option governor=pi --scas on", " --option governor=ideal", " --scas on"}) {
    const CsvText density = rows_of("sensitivity --to air_density" + flight("", "") + systems);
    const CsvText sound = rows_of("sensitivity --to speed_of_sound" + flight("", "") + systems);
    for (const Way& way : ways) {
      CsvText run[4] = {CsvText(""), CsvText(""), CsvText(""), CsvText("")};
      const double by[4] = {way.step, -way.step, way.step / 2, -way.step / 2};
      for (int k = 0; k < 4; ++k) {
        const std::string at = exactly(way.value + by[k]);
        run[k] = rows_of("modes" + flight(way.option, at) + systems +
                         (way.value == 0 ? std::string(" ") + way.option + " " + at : ""));
      }
      for (const char* mode : {"dutch_roll", "phugoid", "roll"}) {
        for (const char* number : {"real", "imag"}) {
          double at[4];
          for (int k = 0; k < 4; ++k) at[k] = run[k].number(row_of(run[k], "mode", mode), number);
          const std::string d = std::string("d_") + number;
          const double found = way.density * density.number(row_of(density, "mode", mode), d) +
                               way.sound * sound.number(row_of(sound, "mode", mode), d);
          const double expected = extrapolated(at[0], at[1], at[2], at[3]) / way.step;
          if (!CHECK_NEAR(found, expected, 1e-9 + 2e-4 * std::abs(expected)))
            NOTE(systems << " " << way.option << " " << mode << " " << number);
        }
      }
    }
  }
}

TEST_OF_XV15(cli_sensitivity_of_trim_is_that_of_new_trims) {
  for (const Setting& s : settings) {
    const CsvText found = rows_of("sensitivity --of trim --to " + std::string(s.parameter) + flight("", ""));
    CsvText run[4] = {CsvText(""), CsvText(""), CsvText(""), CsvText("")};
    const double by[4] = {s.step, -s.step, s.step / 2, -s.step / 2};
    for (int k = 0; k < 4; ++k) run[k] = rows_of("trim" + flight(s.option, exactly(s.value + by[k])));
    const double scale = found.number(0, "change") / s.step;
    for (const char* number : {"pitch_deg", "roll_deg", "collective75_deg", "long_stick_in", "lat_stick_in",
                               "pedal_in", "power_kw"}) {
      double at[4];
      for (int k = 0; k < 4; ++k) at[k] = run[k].number(0, number);
      const double expected = scale * extrapolated(at[0], at[1], at[2], at[3]);
      CHECK_NEAR(found.number(0, std::string("d_") + number), expected,
                 1e-11 * scale * (1 + std::abs(at[0])) + 1e-7);
    }
  }
}

// Wind from any side, backwards too: speed, climb and turn rate beside what the aircraft is.
TEST_OF_XV15(cli_sensitivity_in_wind_from_any_side_is_that_of_new_runs) {
  const Setting slow[] = {
      {"speed", "--speed", 11, 0.002}, {"turn_rate", "--turn-rate", 3, 0.002}, {"mass", "--mass", 5700, 0.1}};
  for (const char* const azimuth : {"90", "180", "-130"}) {
    const auto slow_flight = [&](const std::string& changed, double value) {
      std::string options = std::string(" --mast 4 --climb 10 --azimuth ") + azimuth;
      for (const Setting& s : slow)
        options += std::string(" ") + s.option + " " + exactly(changed == s.option ? value : s.value);
      return options;
    };
    for (const Setting& s : slow) {
      const double by[4] = {s.step, -s.step, s.step / 2, -s.step / 2};
      const auto compare = [&](const std::string& of, const CsvText& found, const std::string& what,
                               std::initializer_list<const char*> numbers) {
        CsvText run[4] = {CsvText(""), CsvText(""), CsvText(""), CsvText("")};
        for (int k = 0; k < 4; ++k) run[k] = rows_of(of + slow_flight(s.option, s.value + by[k]));
        for (const char* number : numbers) {
          double at[4];
          for (int k = 0; k < 4; ++k)
            at[k] = run[k].number(what.empty() ? 0 : row_of(run[k], "mode", what), number);
          const std::size_t row = what.empty() ? 0 : row_of(found, "mode", what);
          const double scale = found.number(row, "change") / s.step;
          const double expected = scale * extrapolated(at[0], at[1], at[2], at[3]);
          if (!CHECK_NEAR(found.number(row, std::string("d_") + number), expected,
                          1e-11 * scale * (1 + std::abs(at[0])) + 1e-7))
            NOTE(azimuth << " " << s.parameter << " " << what << " " << number);
        }
      };
      const std::string to = " --to " + std::string(s.parameter) + slow_flight("", 0);
      compare("trim", rows_of("sensitivity --of trim" + to), "",
              {"pitch_deg", "roll_deg", "collective75_deg", "long_stick_in", "lat_stick_in", "pedal_in",
               "power_kw"});
      const CsvText modes = rows_of("sensitivity" + to);
      for (const char* const mode : {"phugoid", "roll"})
        if (azimuth == std::string("180")) compare("modes", modes, mode, {"real"});
    }
  }
}

// A hover that the wind begins to blow at from the right, against winds from both sides.
TEST(cli_sensitivity_of_a_hover_to_wind_from_the_side) {
  const double step = 0.004 * this_aircraft::speed();
  const auto trim = [](double speed, const char* from) {
    return rows_of("trim --mast 0 --speed " + exactly(speed) + " --azimuth " + from);
  };
  const CsvText found = rows_of("sensitivity --of trim --to speed --mast 0 --speed 0 --azimuth 90");
  const CsvText run[4] = {trim(step, "90"), trim(step, "-90"), trim(step / 2, "90"), trim(step / 2, "-90")};
  for (const char* number : {"roll_deg", "lat_stick_in", "pedal_in"}) {
    double at[4];
    for (int k = 0; k < 4; ++k) at[k] = run[k].number(0, number);
    const double expected = found.number(0, "change") / step * extrapolated(at[0], at[1], at[2], at[3]);
    CHECK_NEAR(found.number(0, std::string("d_") + number), expected, 1e-6 * (std::fabs(expected) + 0.1));
    CHECK(std::fabs(expected) > 1e-4);
  }
}

// Wind from ahead is the flight without sideslip, as long as it is symmetric.
TEST(cli_sensitivity_by_azimuth_and_by_sideslip_agree_ahead) {
  const std::string flight = " --of trim --mast 20 --speed 25";
  const CsvText one = rows_of("sensitivity" + flight + " --azimuth 0"),
                other = rows_of("sensitivity" + flight);
  CHECK_EQ(one.rows.size(), other.rows.size());
  for (const char* const parameter : {"speed", "mass", "tail_area", "fin_area", "blade_lift_factor"})
    for (const char* const number : {"d_pitch_deg", "d_collective75_deg", "d_long_stick_in", "d_power_kw"}) {
      const double expected = other.number(row_of(other, "parameter", parameter), number);
      CHECK_NEAR(one.number(row_of(one, "parameter", parameter), number), expected,
                 1e-8 * (1 + std::fabs(expected)));
    }
}

namespace {

cli::TrimmedFlight trimmed_flight(double mast_deg, double speed, Analyses& work, Governor governor) {
  cli::TrimmedFlight f{};
  FlightSetup<double> setup = flight_setup(aircraft_data<double>(), mast_deg);
  setup.options.grid = BladeGrid::realtime;
  setup.options.governor = governor;
  f.flight = {this_aircraft::speed() * speed, 0, 0.03 / this_aircraft::speed(), 0.02};
  f.mast_deg = mast_deg;
  f.where = "here";
  setup.altitude = this_aircraft::altitude();
  CHECK(prepare(aircraft_data<double>(), setup, f.configuration) == Status::ok);
  CHECK(is_trimmed(trim(f.configuration, f.flight, work, f.trim)));
  return f;
}

// What is compared of a flight: trim, power, and real and imaginary part of every root.
using Numbers = std::vector<double>;
Numbers numbers_of(const State<double>& x, const Controls<double>& u, double power) {
  return {x.pitch, x.roll, u.collective, u.long_stick, u.lat_stick, u.pedal, power};
}

// Of new trims with the aircraft changed; roots in the order of `near`.
Numbers numbers_of(const cli::TrimmedFlight& base, const SensitivitySystems& systems,
                   const SensitivityParameter& p, double by, const std::vector<cli::NamedRoot>& near,
                   Analyses& work) {
  const ChangedAircraft changed(base.configuration, [&](ChangedAircraft& a) { p.change.anew(a, by); });
  const Configuration<double>& c = changed.configuration();
  TrimResult<double> trim;
  CHECK(is_trimmed(tiltrotor::trim(c, base.flight, work, trim)));
  Numbers all = numbers_of(trim.state, trim.controls, trim.power[right] + trim.power[left]);
  static VehicleMatrices matrices;
  static VehicleModes<double> modes;
  CHECK(cli::linearize_governed(c, trim.state, trim.controls, ControlSet{}, work, matrices, systems.scas) ==
        Status::ok);
  CHECK(vehicle_modes(matrices, work, modes) == Status::ok);
  for (const cli::NamedRoot& root : near) {
    if (root.axis == "rotor") continue;  // those of both rotors stand too near each other
    const auto distance = [&root](const VehicleMode<double>& m) {
      return std::hypot(m.real - root.real, m.imag - root.imag);
    };
    const auto* nearest =
        std::min_element(modes.mode, modes.mode + modes.count,
                         [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
    all.push_back(nearest->real);
    all.push_back(nearest->imag);
  }
  return all;
}

void check_aircraft(const SensitivitySystems& systems, double mast_deg, double speed, double tolerance) {
  const cli::AnalysesWorkspace work;
  const cli::TrimmedFlight base = trimmed_flight(mast_deg, speed, *work, systems.governor);
  Sensitivity sensitivity(systems);
  CHECK(sensitivity.begin(base, *work) == Status::ok);
  const std::vector<cli::NamedRoot> roots = sensitivity.roots();
  double worst = 0;
  for (const SensitivityParameter& p : cli::sensitivity_parameters()) {
    if (p.change.along == nullptr || !acts(p, systems)) continue;
    FlightMotion motion;
    if (!CHECK(sensitivity.move(p, motion) == Status::ok)) NOTE(p.name);
    Numbers found = numbers_of(motion.trim.x, motion.trim.u, motion.power);
    for (std::size_t i = 0; i < roots.size(); ++i)
      if (roots[i].axis != "rotor") found.insert(found.end(), {motion.root[i].real, motion.root[i].imag});
    const double part = 0.004;  // of the usual change
    const auto at = [&](double by) { return numbers_of(base, systems, p, by * p.amount, roots, *work); };
    const Numbers zero = at(0), above = at(part), below = at(-part), near_above = at(part / 2),
                  near_below = at(-part / 2);
    for (std::size_t i = 0; i < found.size(); ++i) {
      const double expected = extrapolated(above[i], below[i], near_above[i], near_below[i]) / part;
      const double size = 1 + std::abs(zero[i]);
      const double error = std::abs(found[i] - expected) / size;
      worst = std::max(worst, error);
      if (!CHECK_LT(error, tolerance)) NOTE(p.name << " number " << i << " " << found[i] << " " << expected);
    }
  }
  NOTE("largest error of a usual change " << worst << " of the number");
}

}  // namespace

// Every number and table of the aircraft, against complete new trims and modes of the changed aircraft: as good as a trim
// and an eigenvalue over a fiftieth of the usual change.
TEST(cli_sensitivity_to_the_aircraft_is_that_of_new_aircraft) {
  check_aircraft({Governor::off, false}, 33, 53, 1e-10);
}
// With the augmentation and its gains, and those of the governor.
TEST(cli_sensitivity_to_gains_is_that_of_new_gains) { check_aircraft({Governor::pi, true}, 78, 83, 1e-10); }

// Two ways to one derivative: inertia and hub spring as parameters of the configuration, exact, and as numbers of the
// aircraft, by which systems go; without a governor that acts the roots are the same.
TEST(cli_sensitivity_is_the_same_both_ways) {
  const cli::AnalysesWorkspace work;
  const cli::TrimmedFlight base = trimmed_flight(45, 61, *work, Governor::off);
  Sensitivity exact({Governor::off, false});
  CHECK(exact.begin(base, *work) == Status::ok);
  for (const SensitivityParameter& p : cli::sensitivity_parameters()) {
    if (p.kind != cli::ParameterKind::consequence || p.change.along == nullptr) continue;
    SensitivityParameter other = p;
    other.parameter = ConfigurationParameter::count;
    FlightMotion first, second;
    CHECK(exact.move(p, first) == Status::ok && exact.move(other, second) == Status::ok);
    for (std::size_t i = 0; i < first.root.size(); ++i) {
      CHECK_NEAR(first.root[i].real, second.root[i].real, 1e-11);
      CHECK_NEAR(first.root[i].imag, second.root[i].imag, 1e-11);
    }
    CHECK_NEAR(first.power, second.power, 1e-12 * base.trim.power[right]);
  }
}

// In the vortex ring state, where the inflow follows measured rotors.
TEST_OF_XV15(cli_sensitivity_in_the_vortex_ring_state_is_that_of_new_runs) {
  const std::string options = " --mast 0 --speed 9 --climb -90 --mass ";
  const CsvText found = rows_of("sensitivity --to mass --mode heave" + options + "5700");
  const CsvText run = rows_of("modes" + options + "5704,5696,5702,5698");
  std::vector<double> at;
  for (std::size_t i = 0; i < run.rows.size(); ++i)
    if (run.text(i, "mode") == "heave") at.push_back(run.number(i, "real"));
  CHECK_EQ(at.size(), std::size_t{4});
  if (at.size() == 4)
    CHECK_NEAR(found.number(0, "d_real"), 25 * extrapolated(at[0], at[1], at[2], at[3]), 1e-6);
}

// The largest effect first, for every mode; what is asked for and no more; each with its unit.
TEST(cli_sensitivity_is_a_sorted_table) {
  const std::string flight = " --mast 90 --speed 100";
  const CsvText rows = rows_of("sensitivity" + flight);
  CHECK_LT(200, rows.rows.size());
  for (std::size_t i = 1; i < rows.rows.size(); ++i) {
    CHECK(!rows.text(i, "unit").empty());
    if (rows.text(i, "mode") != rows.text(i - 1, "mode")) continue;
    const char* const number = rows.number(i, "imag") > 0 ? "d_damping_ratio" : "d_real";
    CHECK_LE(std::abs(rows.number(i, number)), std::abs(rows.number(i - 1, number)));
  }
  const CsvText two = rows_of("sensitivity --to mass,tail_area --mode all" + flight);
  const CsvText all = rows_of("modes" + flight);
  CHECK_EQ(two.rows.size(), 2 * all.rows.size());
  const CsvText trim = rows_of("sensitivity --of trim" + flight);
  for (std::size_t i = 1; i < trim.rows.size(); ++i)
    CHECK_LE(std::abs(trim.number(i, "d_power_kw")), std::abs(trim.number(i - 1, "d_power_kw")));
  const auto json =
      run_tiltrotor(this_aircraft::flown("sensitivity --to mass --format json --grid realtime" + flight));
  CHECK(check::JsonGrammar::accepts(json.out));
}

TEST(cli_bad_sensitivity_is_refused_in_one_line) {
  check::check_refused("sensitivity --grid realtime --to masss", "did you mean mass?");
  check::check_refused("sensitivity --grid realtime --to mass,mass", "twice");
  check::check_refused("sensitivity --grid realtime --to ''", "is none of the parameters");
  check::check_refused("sensitivity --grid realtime --of roots", "modes or trim");
  check::check_refused("sensitivity --grid realtime --to scas_yaw_gain", "goes with --of modes --scas on");
  check::check_refused("sensitivity --grid realtime --of trim --to scas_yaw_gain",
                       "goes with --of modes --scas on");
  check::check_refused("sensitivity --grid realtime --scas on --to governor_integral_gain",
                       "goes with --of modes --option governor=pi");
  check::check_refused("sensitivity --grid realtime --of trim --scas on", "goes with --of modes");
  check::check_refused("sensitivity --grid realtime --of trim --mode roll", "goes with --of modes");
  const auto none = run_tiltrotor(
      this_aircraft::flown("sensitivity --grid realtime --mode no_mode --to mass --format csv"));
  CHECK_EQ(none.exit_status, 2);
  CHECK(none.err.find("no flight has a mode called 'no_mode'") != std::string::npos);
  CHECK(none.out.empty());
  const auto one = run_tiltrotor(this_aircraft::flown(
      "sensitivity --grid realtime --mode dutch_roll,dutch_rol --to mass --format csv --mast 90 --speed 100"));
  CHECK_EQ(one.exit_status, 1);
  CHECK(one.err.find("no flight has a mode called 'dutch_rol'") != std::string::npos);
  CHECK(one.out.find(",dutch_roll,") != std::string::npos);
}

// `sensitivity` of trims that hold a result. Expected: differences of complete new searches of `trim` and `modes` with the
// same --hold, and of trims of an aircraft changed by hand; extrapolated from two steps, so that what they leave out goes
// with the fourth power of the step.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
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

// What the options of a flight let go.
std::vector<std::string> freed_by(const std::string& flight) {
  std::vector<std::string> names;
  const std::string free = "--free ";
  for (std::size_t at = 0; (at = flight.find(free, at)) != std::string::npos;) {
    at += free.size();
    names.push_back(flight.substr(at, flight.find(' ', at) - at));
  }
  for (const char* turn : {"--bank", "--load-factor"})
    if (flight.find(turn) != std::string::npos) names.emplace_back("turn_rate_degps");
  if (flight.find("--ball") != std::string::npos) names.emplace_back("sideslip_deg");
  return names;
}

double extrapolated(const double (&at)[4]) { return (8 * (at[2] - at[3]) - (at[0] - at[1])) / 6; }

void compare(const Held& held, const std::string& of, const std::string& mode,
             std::vector<std::string> numbers) {
  const double step = held.parameter->step, by[4] = {step, -step, step / 2, -step / 2};
  const CsvText found(
      run_tiltrotor("sensitivity --of " + of + " --to " + held.parameter->name + with_value(held, 0)).out);
  CsvText run[4] = {CsvText(""), CsvText(""), CsvText(""), CsvText("")};
  std::string columns;
  if (of == "trim") {
    for (const std::string& freed : freed_by(held.flight)) numbers.push_back(freed);
    for (const std::string& number : numbers) columns += (columns.empty() ? " --columns " : ",") + number;
  }
  for (int k = 0; k < 4; ++k) run[k] = CsvText(run_tiltrotor(of + with_value(held, by[k]) + columns).out);
  const std::size_t row = row_of(found, mode);
  for (const std::string& number : numbers) {
    double at[4];
    for (int k = 0; k < 4; ++k) at[k] = run[k].number(row_of(run[k], mode), number);
    const double scale = found.number(row, "change") / step, expected = scale * extrapolated(at);
    const double got = found.number(row, "d_" + number);
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
  for (const char* const name :
       {"tail_incidence", "hub_spring", "blade_drag_factor", "drag_area", "cyclic_rigging"}) {
    const auto& all = cli::sensitivity_parameters();
    const auto found_parameter = std::find_if(
        all.begin(), all.end(), [&](const auto& one) { return std::strcmp(name, one.name) == 0; });
    if (!CHECK(found_parameter != all.end())) continue;
    const cli::SensitivityParameter& p = *found_parameter;
    cli::FlightMotion motion;
    CHECK(sensitivity.move(p, motion) == Status::ok);
    const double part = 0.05, by[4] = {part, -part, part / 2, -part / 2};
    double at[4][6];
    for (int k = 0; k < 4; ++k) {
      const cli::ChangedAircraft changed(
          start.configuration, [&](cli::ChangedAircraft& a) { p.change.anew(a, by[k] * p.amount); });
      cli::TrimmedFlight flight = start;
      flight.configuration = changed.configuration();
      CHECK_EQ(trim_to_targets(base.targets, *work, flight), std::string());
      const TrimResult<double>& t = flight.trim;
      const double numbers[] = {t.state.pitch,         t.state.velocity.z, t.controls.collective,
                                t.controls.long_stick, flight.climb_deg,   flight.turn_rate_degps};
      std::copy(std::begin(numbers), std::end(numbers), at[k]);
    }
    const double found[] = {motion.trim.x.pitch,      motion.trim.x.velocity.z, motion.trim.u.collective,
                            motion.trim.u.long_stick, motion.freed.at(0),       motion.freed.at(1)};
    for (int i = 0; i < 6; ++i) {
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

namespace {

const std::string kAsked = "sensitivity --grid realtime --format csv ";

CsvText trims(const std::string& flight, const std::string& columns) {
  return CsvText(run_tiltrotor("trim --grid realtime --format csv " + flight + " --columns " + columns).out);
}

double power(double speed) {
  return trims("--mast 30 --speed " + this_aircraft::shortest(speed), "power_kw").number(0, "power_kw");
}

void check_singular(const std::string& flight, const std::string& message) {
  for (const char* of : {"trim", "modes"}) {
    const auto run = run_tiltrotor(kAsked + "--of " + of + " --to mass,flap " + flight);
    const CsvText rows(run.out);
    CHECK_EQ(run.exit_status, 1);
    CHECK_EQ(rows.rows.size(), std::size_t{1});
    CHECK_EQ(rows.text(0, "status"), std::string("singular"));
    CHECK_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1);
    if (!CHECK(run.err.find(": " + message + ": free another\n") != std::string::npos))
      NOTE(flight << ": " << run.err);
  }
}

}  // namespace

// Where what is held is least, nothing that is let go keeps it: level flight has the least load factor of all,
// and at the speed of least power, found here from trims by parabolas, no speed has the same power with more mass.
TEST_OF_XV15(cli_sensitivity_refuses_what_is_held_at_its_least) {
  check_singular("--mast 30 --speed 50 --load-factor 1",
                 "load_factor does not move with turn_rate_degps here");
  double speed = 33;
  for (const double step : {0.5, 0.1, 0.006}) {
    const double low = power(speed - step), middle = power(speed), high = power(speed + step);
    speed -= step * (high - low) / (2 * (high - 2 * middle + low));
  }
  const auto held_at = [](double at) {
    char text[100];
    std::snprintf(text, sizeof text, "--mast 30 --hold power_kw=%.12g --free speed_mps --speed %.12g",
                  power(at), at);
    return std::string(text);
  };
  check_singular(held_at(speed), "power_kw does not move with speed_mps here");
  check_singular(held_at(speed) + " --ball centred",
                 "power_kw does not move with speed_mps and sideslip_deg here");
  // A little beside it the speed moves, much and inversely to the slope of the power.
  const auto d_speed = [&](double at) {
    const CsvText rows(run_tiltrotor(kAsked + "--of trim --to mass " + held_at(at)).out);
    CHECK_EQ(rows.text(0, "status"), std::string("ok"));
    return rows.number(0, "d_speed_mps");
  };
  CHECK_NEAR(d_speed(speed + 0.02) / d_speed(speed + 0.04), 2, 0.05);
  CHECK_NEAR(d_speed(speed - 0.02) / d_speed(speed + 0.02), -1, 0.05);
}

// At rest no sideslip can be let go: where the ball is centred without one the rows are those of the flight with nothing
// held.
TEST(cli_sensitivity_in_hover_with_the_ball_centred) {
  const std::string to = "--of trim --to mass,cg_station,drag_area,hub_spring --mast 0 --flap 40 ";
  const CsvText plain(run_tiltrotor(this_aircraft::flown(kAsked + to + "--speed 0")).out);
  const CsvText held(run_tiltrotor(this_aircraft::flown(kAsked + to + "--ball centred --speed 0,20")).out);
  CHECK_EQ(plain.rows.size(), std::size_t{4});
  CHECK_EQ(held.rows.size(), std::size_t{8});
  for (std::size_t i = 0; i < plain.rows.size(); ++i) {
    CHECK_EQ(held.text(i, "status"), std::string("ok"));
    CHECK_EQ(held.number(i, "d_sideslip_deg"), 0.0);
    for (const char* number : {"d_pitch_deg", "d_collective75_deg", "d_long_stick_in", "d_power_kw"})
      CHECK_NEAR(held.number(i, number), plain.number(i, number),
                 1e-9 * (1 + std::fabs(plain.number(i, number))));
  }
  // A turn tilts the aircraft, and no sideslip takes that back.
  const auto turn = run_tiltrotor(this_aircraft::flown(
      kAsked + "--of trim --to turn_rate,mass --mast 0 --flap 40 --ball centred --speed 0"));
  const CsvText rows(turn.out);
  CHECK_EQ(turn.exit_status, 1);
  CHECK_EQ(rows.text(0, "parameter") + " " + rows.text(0, "status"), std::string("turn_rate singular"));
  CHECK_EQ(rows.text(1, "parameter") + " " + rows.text(1, "status"), std::string("mass ok"));
  CHECK(turn.err.find("turn_rate: ny moves with turn_rate, for which sideslip_deg has no effect here") !=
        std::string::npos);
}

// Straight up and down, climb let go: -(dh/d mass) / (dh/d climb) of what is held, from trims without any; climb to one
// side alone.
TEST_OF_XV15(cli_sensitivity_of_vertical_flight_lets_climb_go) {
  for (const int way : {1, -1}) {
    const std::string at = "--mast 0 --flap 40 --speed 2 ";
    const auto pitch = [&](double down, double mass) {
      char text[80];
      std::snprintf(text, sizeof text, "--climb=%.12g --mass %.12g", way * (90 - down), mass);
      return trims(at + text, "pitch_deg").number(0, "pitch_deg");
    };
    const double mass = 5800, none = pitch(0, mass), step = 0.1;
    const double by_climb = -way * (4 * pitch(step, mass) - pitch(2 * step, mass) - 3 * none) / (2 * step);
    const double by_mass = (pitch(0, mass + 1) - pitch(0, mass - 1)) / 2;
    char held[100];
    std::snprintf(held, sizeof held, "--mass 5800 --climb=%d --hold pitch_deg=%.12g --free climb_deg",
                  90 * way, none);
    const CsvText rows(run_tiltrotor(kAsked + "--of trim --to mass " + at + held).out);
    CHECK_EQ(rows.text(0, "status"), std::string("ok"));
    const double expected = -100 * by_mass / by_climb;
    CHECK_NEAR(rows.number(0, "d_climb_deg"), expected, 1e-3 * std::fabs(expected));
    CHECK_NEAR(rows.number(0, "d_pitch_deg"), 0, 1e-9);
  }
  // With a bank the path has no side to lean to.
  const std::string turning = "--mast 0 --speed 5 --climb 90 --turn-rate 10 ";
  const std::string pitch = trims(turning, "pitch_deg").text(0, "pitch_deg");
  const auto banked =
      run_tiltrotor(kAsked + "--to mass --free climb_deg --hold pitch_deg=" + pitch + " " + turning);
  CHECK_EQ(CsvText(banked.out).text(0, "status"), std::string("out_of_range"));
  CHECK(banked.err.find("climb_deg has no slope in vertical flight with a bank: free another\n") !=
        std::string::npos);
}

// Where the power stays, what is let go first gives the order. Names of columns follow --units, in JSON as well.
TEST_OF_XV15(cli_sensitivity_with_power_held_is_in_the_order_of_what_is_let_go) {
  const std::string flight = "--of trim --mast 30 --speed 50m/s --hold power_kw=900 --free ";
  const CsvText rows(run_tiltrotor(kAsked + flight + "climb_deg --ball centred").out);
  CHECK_LT(std::size_t{50}, rows.rows.size());
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < rows.rows.size(); ++i) {
    CHECK_NEAR(rows.number(i, "d_power_kw"), 0, 1e-6);
    const double size = std::fabs(rows.number(i, "d_climb_deg"));
    CHECK_LE(size, least);
    least = size;
    CHECK(std::isfinite(rows.number(i, "d_sideslip_deg")));
  }
  CHECK_LT(0.01, std::fabs(rows.number(0, "d_climb_deg")));
  const std::string knots =
      run_tiltrotor("sensitivity --grid realtime --format json --units knots --to mass " + flight +
                    "speed_mps")
          .out;
  const CsvText metres(run_tiltrotor(kAsked + "--to mass " + flight + "speed_mps").out);
  const std::string key = "\"d_speed_kt\": ";
  const std::size_t place = knots.find(key);
  if (CHECK(place != std::string::npos))
    CHECK_NEAR(std::strtod(knots.c_str() + place + key.size(), nullptr) * 1852 / 3600,
               metres.number(0, "d_speed_mps"), 1e-6);
}

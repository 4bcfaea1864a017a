// A flight on the page and the script and series that are saved there, flown again by the command line.
// Expected: the flight of the C interface through the shim of the page, called in the order of src/page/fly.js; what is
// saved is written as src/page/recorder.js does. The command line flies without the C interface.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/model/setup/configuration.hpp"
extern "C" {
#include "page/page.h"
}

namespace {

constexpr tr_real kStep = tr_real(0.01);
constexpr double kHeight = 300, kInch = 0.0254;
enum Switch {
  governor,
  conversion,
  engines,
  actuators,
  scas,
  gear,
  ground_effect,
  turbulence,
  mast,
  flap,
  rotor
};
enum { throttle = 11, gear_down = 13, seed = 14, w20 = 15, interconnect = 16 };

// All digits, as JavaScript has.
std::string digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}
std::string time_text(double time) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4f", time);
  return text;
}

struct Point {
  double mast, speed, altitude, mass, cg, flap;  // flap < 0: that of the mast angle
};

class PageFlight {
 public:
  explicit PageFlight(const Point& point) : point_(point) {
    const double setup[] = {point.mast, point.flap, point.altitude, point.mass, point.cg, -1};
    std::copy(std::begin(setup), std::end(setup), page_array(PAGE_SETUP));
    obeyed(page_begin(PAGE_FLY));
    obeyed(page_set_height(PAGE_FLY, tr_real(kHeight + rest_height())));
    blow(0);
    change(
        {{governor, 2}, {conversion, 1}, {engines, 1}, {actuators, 1}, {scas, 1}, {gear, 1}, {gear_down, 0}});
    obeyed(page_trim(PAGE_FLY, tr_real(point.speed)));
    obeyed(page_look(PAGE_FLY));
    std::copy_n(page_array(PAGE_U), 4, trim_);
    throttle_ = std::clamp<double>(page_array(PAGE_SYSTEMS)[throttle], 0, 1);
    change({{ground_effect, 1}, {throttle, throttle_}, {throttle + 1, throttle_}});
    rotor_ = rotor_of_trim_ = rotor_speed();
    script_ = "0 release all\n0 series flight.csv held\n";
    series_ = "time_s,th75_rad,lon_in,lat_in,ped_in,throttle_1,throttle_2\n";
  }

  // Of the CG above the wheels.
  double rest_height() const {
    const auto& aircraft = tiltrotor::aircraft_data<double>();
    return tiltrotor::flight_setup(aircraft, point_.mast).wl_cg - aircraft.gear.ground_wl;
  }
  double x(int place) const { return page_array(PAGE_X)[place]; }
  double rotor_speed() const { return page_array(PAGE_CONFIGURATION)[4]; }
  int steps() const { return steps_; }

  void command(std::initializer_list<std::pair<int, double>> changes, const std::string& words) {
    change(changes);
    note(words);
  }
  void wind(double from_north) {
    blow(from_north);
    note("wind " + digits(-from_north) + " 0 0");
  }
  void switch_governor(int to) {
    const char* const name[] = {"off", "ideal", "pi"};
    const double now = rotor_speed();
    rotor_ = to == 2 ? now : rotor_of_trim_;
    change({{governor, to}, {rotor, now}});
    note(std::string("governor ") + name[to]);
    note("rotor " + digits(to == 2 ? rotor_of_trim_ : now) + "rad/s");
  }
  // Hands away from the trim, held for so many steps.
  void fly(const double (&hands)[4], double power, int count) {
    for (int k = 0; k < 4; ++k) page_array(PAGE_U)[k] = tr_real(trim_[k] + hands[k]);
    obeyed(page_set_controls(PAGE_FLY));
    std::string row = time_text(steps_ == 0 ? 0 : (steps_ - 0.5) * 0.01);
    for (int k = 0; k < 4; ++k) row += "," + digits(page_array(PAGE_U)[k]);
    throttle_now_ = std::clamp(throttle_ + power, 0.0, 1.0);
    change({{throttle, throttle_now_}, {throttle + 1, throttle_now_}});
    series_ += row + "," + digits(throttle_now_) + "," + digits(throttle_now_) + "\n";
    for (int k = 0; k < count; ++k, ++steps_) {
      if (rotor_ != rotor_of_trim_) {
        rotor_ += std::clamp(rotor_of_trim_ - rotor_, -0.01, 0.01);
        change({{rotor, rotor_}});
      }
      obeyed(page_step(PAGE_FLY, kStep));
    }
    obeyed(page_look(PAGE_FLY));
  }

  // The last row of the flight that the command line makes of it.
  check::CsvText again() const {
    const check::ScratchFolder folder;
    folder.write("flight.csv", series_);
    const std::string script = folder.write("flight.txt", script_ + time_text(steps_ * 0.01) + " end\n");
    const check::ProgramResult result =
        check::run_tiltrotor("fly --mast " + digits(point_.mast) + " --speed " + digits(point_.speed) +
                             " --height " + digits(kHeight) + " --altitude " + digits(point_.altitude) +
                             (point_.flap < 0 ? "" : " --flap " + digits(point_.flap)) + " --mass " +
                             digits(point_.mass) + " --cg-sl " + digits(point_.cg / kInch) +
                             " --dt 0.01 --every 3600 --script " + check::quoted(script));
    CHECK_EQ(result.exit_status, 0);
    if (result.exit_status != 0) NOTE(result.err);
    return check::CsvText(result.out);
  }

 private:
  void obeyed(int32_t status) { CHECK_EQ(std::string(page_status_word(status)), "ok"); }
  void note(const std::string& words) { script_ += time_text(steps_ * 0.01) + " " + words + "\n"; }
  void change(std::initializer_list<std::pair<int, double>> changes) {
    obeyed(page_look(PAGE_FLY));
    for (const auto& [place, value] : changes) page_array(PAGE_SYSTEMS)[place] = tr_real(value);
    obeyed(page_set_systems(PAGE_FLY));
    obeyed(page_look(PAGE_FLY));
  }
  void blow(double from_north) {
    const double air[] = {-from_north, 0, 0, point_.altitude};
    std::copy(std::begin(air), std::end(air), page_array(PAGE_ENVIRONMENT));
    obeyed(page_set_environment(PAGE_FLY));
    obeyed(page_look(PAGE_FLY));
  }

  Point point_;
  double trim_[4] = {}, throttle_ = 0, throttle_now_ = 0, rotor_ = 0, rotor_of_trim_ = 0;
  int steps_ = 0;
  std::string script_, series_;
};

// Degrees and SI, to what the rows of the program show of it.
void check_flown_again(const PageFlight& flown, double tolerance) {
  const check::CsvText rows = flown.again();
  if (rows.rows.empty()) return;
  const std::size_t last = rows.rows.size() - 1;
  const double degree = std::acos(-1.0) / 180;
  const struct {
    const char* column;
    double value;
  } expected[] = {{"time_s", flown.steps() * 0.01},
                  {"u_mps", flown.x(0)},
                  {"v_mps", flown.x(1)},
                  {"w_mps", flown.x(2)},
                  {"p_degps", flown.x(3) / degree},
                  {"q_degps", flown.x(4) / degree},
                  {"r_degps", flown.x(5) / degree},
                  {"roll_deg", flown.x(6) / degree},
                  {"pitch_deg", flown.x(7) / degree},
                  {"yaw_deg", flown.x(8) / degree},
                  {"north_m", flown.x(TR_NORTH)},
                  {"east_m", flown.x(TR_EAST)},
                  {"height_m", -flown.x(TR_DOWN) - flown.rest_height()},
                  {"rotor_rpm", flown.rotor_speed() * 30 / std::acos(-1.0)},
                  {"mast_deg", page_array(PAGE_CONFIGURATION)[0]},
                  {"flap_deg", page_array(PAGE_CONFIGURATION)[3]}};
  double worst = 0;
  for (const auto& e : expected) {
    const double off = std::fabs(rows.number(last, e.column) - e.value) / std::fmax(1, std::fabs(e.value));
    if (!CHECK_LT(off, tolerance))
      NOTE(e.column << " " << rows.number(last, e.column) << " against " << e.value);
    worst = std::fmax(worst, off);
  }
  NOTE("largest difference " << worst);
}

}  // namespace

TEST(fly_repeats_a_flight_of_the_page) {
  PageFlight f({0, 40, 0, 5897, 7.65, -1});
  f.fly({0, 0, 0, 0}, 0, 100);
  f.fly({0, 0.3, 0.2, 0}, 0, 50);
  f.fly({0.005, 0, 0, 0.3}, 0.05, 150);
  check_flown_again(f, 1e-9);
}

TEST(fly_repeats_wind_and_turbulence_of_the_page) {
  PageFlight f({30, 60, 1200, 6123.7, 7.652, 20});
  f.wind(7);
  f.command({{turbulence, 1}, {w20, 15.4}, {seed, 1}}, "turbulence 15.4 1");
  f.fly({0, 0, 0.1, 0}, 0, 120);
  f.command({{scas, 0}}, "scas off");
  f.command({{mast, 40}}, "mast 40");
  f.command({{gear_down, 1}}, "gear down");
  f.fly({0, 0.1, 0, 0}, 0.02, 60);
  f.command({{turbulence, 0}, {w20, 0}, {seed, 1}}, "turbulence 0 1");
  f.command({{flap, 40}}, "flap 40");
  f.fly({0, 0.1, 0, 0.1}, 0, 60);
  f.wind(-3);
  f.command({{turbulence, 1}, {w20, 7.7}, {seed, 1}}, "turbulence 7.7 1");
  f.command({{scas, 1}}, "scas on");
  f.command({{gear_down, 0}}, "gear up");
  f.fly({0, 0, -0.1, 0}, 0, 60);
  check_flown_again(f, 1e-9);
}

TEST(fly_repeats_governors_of_the_page) {
  PageFlight f({15, 30, 0, 5897, 7.65, -1});
  f.fly({0.01, 0, 0, 0}, 0.05, 40);
  for (const int to : {1, 2, 0, 1, 0, 2}) {
    f.switch_governor(to);
    f.fly({0.005, 0, 0, 0}, 0, 30);
  }
  f.fly({0, 0, 0, 0}, 0, 50);
  check_flown_again(f, 1e-9);
}

// The shaft between the rotors twists in flight and becomes rigid again, with a governor beside that does not know it.
TEST(fly_repeats_the_interconnect_of_the_page) {
  PageFlight f({15, 30, 0, 5897, 7.65, -1});
  f.fly({0.01, 0, 0, 0}, 0.05, 40);
  f.command({{interconnect, 1}}, "interconnect twists");
  f.fly({0.005, 0, 0.3, 0}, 0, 60);
  CHECK_LT(1e-6, std::fabs(f.x(TR_SHAFT_TWIST)));
  f.switch_governor(1);
  f.fly({0.005, 0, 0, 0}, 0, 30);
  CHECK_EQ(f.x(TR_SHAFT_TWIST), 0.0);
  f.switch_governor(2);
  f.fly({0, 0, -0.2, 0}, 0, 30);
  f.command({{interconnect, 0}}, "interconnect rigid");
  f.fly({0, 0, 0, 0}, 0, 50);
  check_flown_again(f, 1e-9);
}

// What the page draws as arrows. Expected: `loads` of the command line at its own trim.
TEST(cli_loads_are_those_of_the_page) {
  const double setup[] = {30, -1, 0, 5897, 7.65, -1};
  std::copy(std::begin(setup), std::end(setup), page_array(PAGE_SETUP));
  CHECK_EQ(page_begin(PAGE_EXPLORE), 0);
  CHECK_EQ(page_trim(PAGE_EXPLORE, 60), 0);
  CHECK_EQ(page_component_forces(PAGE_EXPLORE), 0);
  const check::ProgramResult result = check::run_tiltrotor(
      "loads --grid realtime --mast 30 --speed 60 --mass 5897 --cg-sl " + digits(7.65 / kInch));
  CHECK_EQ(result.exit_status, 0);
  const check::CsvText rows(result.out);
  double worst = 0;
  std::size_t found = 0;
  for (std::size_t i = 0; i < rows.rows.size(); ++i)
    for (int k = 0; *page_component_name(k) != '\0'; ++k) {
      if (rows.text(i, "component") != page_component_name(k)) continue;
      const char* const columns[] = {"x_n", "y_n", "z_n"};
      for (int axis = 0; axis < 3; ++axis)
        worst = std::fmax(worst,
                          std::fabs(rows.number(i, columns[axis]) - page_array(PAGE_FORCES)[3 * k + axis]));
      ++found;
    }
  CHECK_EQ(found, rows.rows.size() - 1);  // and their sum
  CHECK_LT(worst, 1e-3);                  // N of 58 kN: the trims are apart by that much
  CHECK_EQ(std::string(page_component_name(-1)), "");
}

// Places that the page's script counts by hand. Expected: the C interface's, by name.
TEST(cli_page_knows_the_places_of_the_state) {
  std::ifstream file(check::source_path("src/page/module.js"));
  const std::string script((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const std::size_t begin = script.find("kX = {");
  CHECK(begin != std::string::npos);
  const std::string places = script.substr(begin, script.find('}', begin) - begin);
  const std::regex entry("(\\w+): (\\d+)");
  int counted = 0;
  for (std::sregex_iterator at(places.begin(), places.end(), entry), end; at != end; ++at, ++counted) {
    const std::string name = (*at)[1], wanted = name == "roll"    ? "phi"
                                                : name == "pitch" ? "theta"
                                                : name == "yaw"   ? "psi"
                                                                  : name;
    CHECK_EQ(std::string(tr_state_name(std::stoi((*at)[2]))), wanted);
  }
  CHECK_LE(14, counted);
  CHECK(script.find("copy('x', " + std::to_string(int{TR_STATES}) + ")") != std::string::npos);
  CHECK(script.find("copy('u', " + std::to_string(int{TR_CONTROLS}) + ")") != std::string::npos);
}

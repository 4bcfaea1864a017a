// Flights by script, of the whole vehicle.
// Expected: kinematics (positions are the integrals of the velocities, by the trapezoidal rule), the fuel of the energy
// that the engines gave, ratings of the aircraft, what the script says; nothing of the pilot.
#include <algorithm>
#include <cmath>

#include "check.hpp"
#include "cli/flown.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

using check::CsvText;
using check::Flown;
using check::fly;
using check::run_tiltrotor;
using check::summary;

namespace {

std::string script_of(const char* name) {
  std::ifstream in(check::source_path(std::string("src/examples/") + name));
  return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

const char* const kMissionColumns =
    "--every 0 --columns time_s,height_m,north_m,east_m,climb_rate_mps,north_speed_mps,east_speed_mps,power_1_kw,"
    "power_2_kw,takeoff_power_kw,fuel_burnt_kg,weight_on_wheels,mast_deg,rotor_rpm,airspeed_mps,roll_deg,load_factor";

// From wheels to wheels, through airplane mode, and every number follows from the others.
void check_mission(const Flown& f) {
  CHECK_EQ(f.result.exit_status, 0);
  if (f.count() < 2) return;
  const std::size_t last = f.count() - 1;
  double climbed = 0, north = 0, east = 0, energy = 0, off_height = 0, off_place = 0, touch = 0,
         most_mast = 0;
  double highest = 0, part = 0;
  bool flies = false;
  for (std::size_t k = 1; k <= last; ++k) {
    const double dt = f(k, "time_s") - f(k - 1, "time_s");
    const auto mean = [&](const char* column) { return 0.5 * (f(k, column) + f(k - 1, column)); };
    climbed += dt * mean("climb_rate_mps");
    north += dt * mean("north_speed_mps");
    east += dt * mean("east_speed_mps");
    energy += dt * (mean("power_1_kw") + mean("power_2_kw"));
    off_height = std::max(off_height, std::fabs(f(k, "height_m") - f(0, "height_m") - climbed));
    off_place = std::max(off_place, std::hypot(f(k, "north_m") - f(0, "north_m") - north,
                                               f(k, "east_m") - f(0, "east_m") - east));
    part = std::max(part, std::max(f(k, "power_1_kw"), f(k, "power_2_kw")) / f(k, "takeoff_power_kw"));
    most_mast = std::max(most_mast, f(k, "mast_deg"));
    highest = std::max(highest, f(k, "height_m"));
    if (flies && f(k, "weight_on_wheels") > 0) {
      touch = std::max(touch, (f(k - 1, "height_m") - f(k, "height_m")) / dt);
      flies = false;
    }
    flies = flies || (f(k, "weight_on_wheels") == 0 && f(k, "height_m") > 0.3);
  }
  CHECK_LT(off_height, 0.05);
  CHECK_LT(off_place, 0.5);
  CHECK_LE(part, 1.0005);
  CHECK_NEAR(most_mast, 90, 1e-6);
  CHECK_LT(100, highest);
  CHECK_LT(0, touch);
  CHECK_LT(touch, 1);
  CHECK_NEAR(summary(f, "touch-down"), touch, 0.05);
  CHECK_NEAR(f(0, "weight_on_wheels"), 1, 0.02);
  CHECK_NEAR(f(last, "weight_on_wheels"), 1, 0.1);
  CHECK_NEAR(f(last, "mast_deg"), 0, 1e-6);
  CHECK_NEAR(f(last, "airspeed_mps"), 0, 10);
  const double per_energy = tiltrotor::aircraft_data<double>().systems.drive.fuel_per_energy;
  CHECK_NEAR(f(last, "fuel_burnt_kg"), per_energy * 1e3 * energy, 1e-3 * f(last, "fuel_burnt_kg"));
  CHECK_NEAR(summary(f, "fuel burnt"), f(last, "fuel_burnt_kg"), 0.06);
}

// Masts at 7.5 deg/s in level flight from 33 to 83 m/s, from 155 s on.
void check_conversion(const Flown& f, double end) {
  double most_rate = 0, slowest = 1e9, fastest = 0;
  for (std::size_t k = 1; k < f.count(); ++k) {
    const double time = f(k, "time_s");
    if (time < 155 || time > end) continue;
    CHECK_LT(std::fabs(f(k, "height_m") - 150), 5);
    CHECK_LT(0.9, f(k, "load_factor"));
    CHECK_LT(f(k, "load_factor"), 1.1);
    slowest = std::min(slowest, f(k, "airspeed_mps"));
    fastest = std::max(fastest, f(k, "airspeed_mps"));
    most_rate = std::max(most_rate, (f(k, "mast_deg") - f(k - 1, "mast_deg")) / (time - f(k - 1, "time_s")));
  }
  CHECK_NEAR(most_rate, 7.5, 0.05);
  CHECK_NEAR(slowest, 33, 0.5);
  CHECK_LT(82.5, fastest);
}

}  // namespace

TEST(slow_fly_mission_goes_from_ground_to_ground) {
  const Flown f = fly(script_of("mission.txt"), kMissionColumns);
  check_mission(f);
  CHECK_LT(summary(f, "height held"), 5);
  check_conversion(f, 199);
}

// The other engine at its take-off power at most.
TEST(slow_fly_converts_on_one_engine) {
  const Flown f = fly(script_of("engine_out.txt"), kMissionColumns);
  CHECK_EQ(f.result.exit_status, 0);
  check_conversion(f, 230);
  for (std::size_t k = 0; k < f.count(); ++k) {
    CHECK_LE(f(k, "power_2_kw"), 1.0005 * f(k, "takeoff_power_kw"));
    if (f(k, "time_s") > 170) CHECK_LT(f(k, "power_1_kw"), 1);
  }
}

TEST(slow_fly_mission_goes_through_moderate_turbulence) {
  check_mission(fly("0 turbulence 15.4 1\n" + script_of("mission.txt"), kMissionColumns));
}

TEST(fly_replays_the_same_bytes) {
  const std::string script = "0 turbulence 30kt 5\n1 hold speed 45\n1 gust 0 2 -3 2\n2 turn 3\n4 end\n";
  const Flown one = fly(script, "--speed 40 --every 0"), other = fly(script, "--speed 40 --every 0");
  CHECK_EQ(one.result.exit_status, 0);
  CHECK_EQ(one.count(), std::size_t{401});
  CHECK(one.result.out == other.result.out);
  CHECK(one.result.err == other.result.err);
  CHECK(
      one.result.out !=
      fly("0 turbulence 30kt 6\n" + script.substr(script.find('\n') + 1), "--speed 40 --every 0").result.out);
}

// A trim that is only held stays where it is.
TEST(fly_stays_in_a_trim) {
  for (const char* where : {"--mast 0 --speed 0", "--mast 30 --speed 60", "--mast 90 --speed 90"}) {
    const Flown f = fly("10 end\n", where);
    CHECK_EQ(f.result.exit_status, 0);
    const std::size_t last = f.count() - 1;
    bool stays = CHECK_NEAR(f(last, "height_m"), 300, 0.3) & CHECK_NEAR(f(last, "load_factor"), 1, 0.01);
    stays = stays & CHECK_NEAR(f(last, "airspeed_mps"), f(0, "airspeed_mps"), 0.1) &
            CHECK_NEAR(f(last, "rotor_rpm"), f(0, "rotor_rpm"), 0.1) &
            CHECK_NEAR(f(0, "power_1_kw"), f(0, "throttle_1") * f(0, "takeoff_power_kw"), 10);
    if (!stays) NOTE(where);
  }
}

// Inputs are where the script puts them; steps and doublets come on top.
TEST(fly_moves_inputs_as_the_script_says) {
  const check::ScratchFolder folder;
  folder.write("inputs.csv", "time_s,lat_stick_in\n0,0\n1,0.5\n");
  const std::string script =
      folder.write("script.txt",
                   "0 release all\n0 pedal 0.25\n0 series inputs.csv\n"
                   "0 stick long 0.5\n1 doublet long 0.2 1\n2 step pedal -0.5 0.5\n3 end\n");
  const CsvText rows(
      run_tiltrotor("fly --speed 60 --mast 60 --every 0 --script " + check::quoted(script)).out);
  const auto at = [&](double time, const char* column) {
    return rows.number(static_cast<std::size_t>(std::lround(time * 100)), column);
  };
  CHECK_NEAR(at(0.5, "pedal_in"), 0.25, 1e-12);
  CHECK_NEAR(at(0.5, "lat_stick_in"), 0.25, 1e-12);
  CHECK_NEAR(at(2.9, "lat_stick_in"), 0.5, 1e-12);
  CHECK_NEAR(at(0.9, "long_stick_from_neutral_in"), 0.5, 1e-12);
  CHECK_NEAR(at(1.2, "long_stick_from_neutral_in"), 0.7, 1e-12);
  CHECK_NEAR(at(1.7, "long_stick_from_neutral_in"), 0.3, 1e-12);
  CHECK_NEAR(at(2.2, "pedal_in"), -0.25, 1e-12);
  CHECK_NEAR(at(2.7, "pedal_in"), 0.25, 1e-12);
}

// A wind that begins blows past an aircraft that keeps its speed over the ground; systems switch in flight without a jump
// of the controls they move.
TEST(fly_wind_and_systems_change_without_a_jolt) {
  const Flown f =
      fly("1 wind -5 0 0\n2 scas off\n4 scas on\n6 governor ideal\n8 governor off\n10 governor pi\n14 end\n",
          "--speed 40 --every 0");
  CHECK_EQ(f.result.exit_status, 0);
  CHECK_NEAR(f(100, "airspeed_mps") - f(99, "airspeed_mps"), 5, 0.2);
  for (std::size_t k = 1; k < f.count(); ++k) {
    CHECK_LT(std::fabs(f(k, "north_speed_mps") - f(k - 1, "north_speed_mps")), 0.1);
    CHECK_LT(std::fabs(f(k, "scas_pitch_in") - f(k - 1, "scas_pitch_in")), 0.25);  // rate of the servo
    CHECK_LT(std::fabs(f(k, "rotor_rpm") - f(k - 1, "rotor_rpm")), 3);
  }
  CHECK_NEAR(f(390, "scas_pitch_in"), 0, 1e-6);
  CHECK_LT(std::fabs(f(f.count() - 1, "height_m") - 300), 10);
}

// A wind that grows with height takes the aircraft along as it is there: at 300 m as it ends at 1000 ft, by the logarithm.
TEST(fly_wind_grows_with_height) {
  const Flown f = fly("0.1 wind -3 0 0\n0.5 shear terminal\n1 shear none\n2 end\n", "--speed 40 --every 0");
  CHECK_EQ(f.result.exit_status, 0);
  const auto jump = [&f](int at) {
    const auto k = static_cast<std::size_t>(at);
    return f(k, "airspeed_mps") - f(k - 1, "airspeed_mps");
  };
  const double height_ft = f(50, "height_m") / 0.3048 + 5.9;  // of the CG above the wheels
  const double share = std::log(height_ft / 0.15) / std::log(20 / 0.15);
  CHECK_NEAR(jump(50), 3 * (share - 1), 0.05);
  CHECK_NEAR(jump(100), -3 * (share - 1), 0.05);
  for (std::size_t k = 1; k < f.count(); ++k)
    CHECK_LT(std::fabs(f(k, "north_speed_mps") - f(k - 1, "north_speed_mps")), 0.1);
}

TEST(fly_prints_the_columns_that_are_chosen) {
  const Flown f = fly("1 end\n", "--speed 40 --columns rotor_rpm,time_s --every 0.5");
  CHECK_EQ(check::first_line(f.result.out), std::string("rotor_rpm,time_s"));
  CHECK_EQ(f.count(), std::size_t{3});
  CHECK_NEAR(f(2, "time_s"), 1, 1e-12);
  const check::ProgramResult refused = fly("1 end\n", "--speed 40 --columns time_s,rotor_rp").result;
  CHECK_EQ(refused.exit_status, 2);
  CHECK_EQ(refused.err.substr(0, refused.err.find("; choose")),
           std::string("tiltrotor: fly: --columns: no column 'rotor_rp' (did you mean rotor_rpm?)"));
}

TEST(fly_refuses_before_anything_is_written) {
  const check::ScratchFolder folder;
  const std::string output = folder.path("rows.csv");
  const auto refused = [&](const std::string& script, const std::string& options, const std::string& part) {
    const check::ProgramResult result = fly(script, options + " --output " + check::quoted(output)).result;
    bool right = CHECK_EQ(result.exit_status, 2) & CHECK(result.err.find(part) != std::string::npos) &
                 CHECK_EQ(std::count(result.err.begin(), result.err.end(), '\n'), std::ptrdiff_t{1}) &
                 CHECK_EQ(folder.files(), 0);
    if (!right) NOTE(options << ": " << result.err);
  };
  refused("0 mast 95\n1 end\n", "", "script.txt:1: mast ANGLE");
  refused("1 mast 5\n0 end\n", "", "script.txt:2: time");
  refused("1 fly\n", "", "unknown command 'fly'");
  refused("1 end\n", "--dt 0.1", "--dt");
  refused("1 end\n", "--speed 500", "--speed");
  refused("1 end\n", "--height 0 --speed 40", "--height");
  refused("1 end\n", "--rotor-rpm 500", "--rotor-rpm");
  refused("1 end\n", "--modes-every 1", "--modes-every");
  refused("1 end\n", "--option governor=ideal", "--option governor: a script says it");
  refused("0 shear rough\n1 end\n", "", "none, terminal or other");
  CHECK_EQ(run_tiltrotor("fly").exit_status, 2);
}

// Full forward stick and nobody who holds: the flight ends, told with time and state; rows so far are whole.
TEST(fly_tells_time_and_state_of_a_lost_flight) {
  const Flown f = fly("0 release all\n0 scas off\n0 stick long 4\n60 end\n", "--speed 40 --every 0.5");
  CHECK_EQ(f.result.exit_status, 1);
  const std::string begins = "fly: the flight cannot be continued: at ";
  const std::size_t place = f.result.err.find(begins);
  if (!CHECK(place != std::string::npos)) {
    NOTE(f.result.err);
    return;
  }
  const double time = std::strtod(f.result.err.c_str() + place + begins.size(), nullptr);
  const std::size_t last = f.count() - 1;
  CHECK_LT(0, last);
  CHECK_LE(f(last, "time_s"), time);
  CHECK_LT(time - f(last, "time_s"), 0.52);
  for (const auto& row : f.rows.rows) CHECK_EQ(row.size(), f.rows.columns.size());
}

TEST(fly_draws_and_lists_modes) {
  const check::ScratchFolder folder;
  const Flown f =
      fly("4 end\n", "--speed 40 --modes-every 2 --modes " + check::quoted(folder.path("modes.csv")) +
                         " --figures " + check::quoted(folder.path("figures")));
  CHECK_EQ(f.result.exit_status, 0);
  const CsvText modes(folder.read("modes.csv"));
  int phugoids = 0;
  for (std::size_t k = 0; k < modes.rows.size(); ++k) {
    phugoids += modes.text(k, "mode") == "phugoid";
    const double size = std::hypot(modes.number(k, "real"), modes.number(k, "imag"));
    CHECK_NEAR(modes.number(k, "frequency_rad_s"), size, 1e-9 * (1 + size));
  }
  CHECK_EQ(phugoids, 3);
  for (const char* name : {"figures/flight.svg", "figures/flight_modes.svg"}) {
    const std::string svg = folder.read(name);
    CHECK_EQ(svg.substr(0, 4), std::string("<svg"));
    CHECK(svg.size() > 1000 && svg.substr(svg.size() - 7) == "</svg>\n");
  }
}

// On its wheels, and at the moment they touch, a gear that is told to go up stays; the summary says so.
TEST(fly_gear_stays_down_with_weight_on_the_wheels) {
  const Flown f = fly("0 gear up\n0.5 gear up\n2 end\n", "--every 0.5");
  CHECK_EQ(f.result.exit_status, 0);
  for (std::size_t k = 0; k < f.count(); ++k) {
    CHECK_NEAR(f(k, "height_m"), 0, 0.05);
    CHECK_NEAR(f(k, "weight_on_wheels"), 1, 0.05);
  }
  CHECK(f.result.err.find("gear up at 0.5 s: ignored, with weight on the wheels\n") != std::string::npos);
  CHECK(fly("0 gear down\n1 end\n", "").result.err.find("ignored") == std::string::npos);
}

// An aircraft that comes down without its wheels ends its flight at the ground: it does not fly on below.
TEST(fly_ends_at_the_ground_with_the_gear_up) {
  for (const char* down : {"0 land 2", "0 hold climb -3", "0 release all\n0 throttle 0.2"}) {
    const Flown f = fly(std::string(down) + "\n60 end\n", "--speed 20 --height 10 --every 0");
    CHECK_EQ(f.result.exit_status, 1);
    const std::size_t last = f.count() - 1;
    bool right = CHECK_LE(0, f(last, "height_m")) & CHECK_LT(f(last, "height_m"), 0.2) &
                 CHECK(f.result.err.find(", down: the aircraft has met the ground with the gear up\n") !=
                       std::string::npos);
    if (!right) NOTE(down << ": " << f.result.err);
  }
  const Flown lands = fly("0 gear down\n0 hold speed 0\n5 land 1\n40 end\n", "--speed 5 --height 10");
  CHECK_EQ(lands.result.exit_status, 0);
  CHECK_NEAR(lands(lands.count() - 1, "weight_on_wheels"), 1, 0.2);
}

// Told to come down at 1 s it is half out at 5 s and carries from 9 s; before that there is no gear to land on.
TEST_OF_XV15(fly_gear_takes_its_time) {
  const Flown f = fly("0 hold speed 20\n1 gear down\n10 end\n", "--speed 20 --height 50 --every 1");
  CHECK_EQ(f.result.exit_status, 0);
  const double expected[] = {0, 0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1, 1};
  CHECK_EQ(f.count(), std::size_t{11});
  for (std::size_t k = 0; k < f.count(); ++k) CHECK_NEAR(f(k, "gear"), expected[k], 2e-3);
  const Flown early = fly("0 gear down\n0 hold climb -3\n20 end\n", "--speed 20 --height 10 --every 0");
  CHECK_EQ(early.result.exit_status, 1);
  CHECK(early.result.err.find(", down: the aircraft has met the ground before the gear was down\n") !=
        std::string::npos);
}

// A and B of the whole vehicle along the way: at a trim those of the airframe, where its systems leave it alone, and at any
// time the trace is the sum of the modes' roots; what is switched off has no rows.
TEST(fly_writes_matrices_of_the_whole_vehicle) {
  const check::ScratchFolder folder;
  const Flown f = fly("1.5 scas off\n1.5 governor ideal\n4 end\n",
                      "--speed 40 --modes-every 2 --modes " + check::quoted(folder.path("modes.csv")) +
                          " --matrices " + check::quoted(folder.path("m")));
  CHECK_EQ(f.result.exit_status, 0);
  const CsvText a(folder.read("m/a.csv")), b(folder.read("m/b.csv")), modes(folder.read("modes.csv"));
  CHECK_EQ(b.rows.size(), a.rows.size());
  const check::Traces t = check::traces(a, modes);
  for (int k = 0; k < 3; ++k) CHECK_NEAR(t.trace[k], t.sum[k], 1e-8 * t.size[k]);
  CHECK_EQ(t.rows[0] - t.rows[2], 6);  // three series actuators and the washout, rotor speed and governor
  CHECK(a.text(a.rows.size() - 1, "scas_pitch").empty() && !a.text(0, "scas_pitch").empty());
  CHECK_NEAR(b.number(0, "rotor_command"), 0, 1e-12);
  double lag = 0;
  for (std::size_t i = 0; i < 45 && i < b.rows.size(); ++i)
    if (b.text(i, "row") == "power_R") lag = b.number(i, "throttle_R") / -a.number(i, "power_R");
  CHECK_NEAR(lag / 1e3, f(0, "takeoff_power_kw"), 0.02 * f(0, "takeoff_power_kw"));
  const check::ProgramResult refused = fly("1 end\n", "--speed 40 --control-set all").result;
  CHECK_EQ(refused.exit_status, 2);
}

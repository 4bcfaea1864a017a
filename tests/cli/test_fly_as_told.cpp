// What is asked of a flight by script comes true, or is said not to.
// Expected: the trim of `trim`; take-off power by the law of the ideal gas; stops and ranges of the aircraft; sums of the
// rows; the trace of a matrix against the roots found apart from it.
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
using tiltrotor::aircraft_data;

namespace {

// CG above the wheels at rest, m.
double cg_height() { return aircraft_data<double>().mass.wl_cg - aircraft_data<double>().gear.ground_wl; }

// Of an engine, kW, in air so much warmer: density as 1/T and the speed of sound as sqrt(T) at one pressure.
double takeoff_power_kw(double altitude, double warmer) {
  const auto& t = aircraft_data<double>().controls;
  const double standard = 288.15 - 0.0065 * altitude, pressure = std::pow(standard / 288.15, 5.2558797);
  const double lapse = pressure * std::sqrt(288.15 / (standard + warmer));
  return 1e-3 * t.engine_power * (1 + t.engine_lapse * (lapse - 1));
}

bool says(const Flown& f, const std::string& text) { return f.result.err.find(text) != std::string::npos; }

}  // namespace

TEST(fly_in_warm_air_begins_in_its_trim) {
  for (const char* offset : {"20", "0", "-20"}) {
    const std::string air = std::string(" --isa-offset ") + offset;
    const Flown f =
        fly("2 end\n", "--speed 40 --columns time_s,rotor_power_kw,takeoff_power_kw,height_m" + air);
    CHECK_EQ(f.result.exit_status, 0);
    const CsvText trim(run_tiltrotor("trim --grid realtime --columns power_kw --speed 40 --altitude " +
                                     std::to_string(300 + cg_height()) + air)
                           .out);
    const double power = trim.number(0, "power_kw");
    const std::size_t last = f.count() - 1;
    bool right = CHECK_NEAR(f(0, "rotor_power_kw"), power, 1e-5 * power) &
                 CHECK_NEAR(f(last, "rotor_power_kw"), power, 5e-3 * power);
    for (const std::size_t row : {std::size_t{0}, last}) {
      const double expected = takeoff_power_kw(f(row, "height_m") + cg_height(), std::atof(offset));
      right = right & CHECK_NEAR(f(row, "takeoff_power_kw"), expected, 1e-4 * expected);
    }
    const Flown stands = fly("1 end\n", "--columns time_s,takeoff_power_kw" + air);
    const double expected = takeoff_power_kw(cg_height(), std::atof(offset));
    right = right & CHECK_NEAR(stands(0, "takeoff_power_kw"), expected, 1e-4 * expected);
    if (!right) NOTE(air);
  }
}

// The right one, from the beginning; until the other is started.
TEST_OF_XV15(fly_on_one_engine_runs_the_right_one) {
  const Flown f = fly("4 engine 2 restart\n14 end\n", "--speed 40 --engines 1 --every 0.5");
  CHECK_EQ(f.result.exit_status, 0);
  const double efficiency = aircraft_data<double>().controls.transmission_efficiency;
  CHECK_NEAR(f(0, "power_1_kw"), f(0, "rotor_power_kw") / efficiency, 1e-6);
  for (std::size_t k = 0; f(k, "time_s") < 3.9; ++k) {
    CHECK_EQ(f(k, "power_2_kw"), 0);
    CHECK_NEAR(f(k, "rotor_rpm"), f(0, "rotor_rpm"), 1);
    CHECK_NEAR(f(k, "height_m"), 300, 0.3);
  }
  const std::size_t last = f.count() - 1;
  CHECK_NEAR(f(last, "power_2_kw"), f(last, "power_1_kw"), 0.1 * f(last, "power_1_kw"));
  const Flown all = fly("1 end\n", "--speed 40 --engines 2");
  CHECK(all.result.out == fly("1 end\n", "--speed 40").result.out);
  const Flown stands = fly("0 spool\n10 end\n", "--engines 1 --every 10");
  CHECK_LT(1.5 * stands(0, "rotor_rpm"), stands(1, "rotor_rpm"));
  CHECK_EQ(stands(1, "power_2_kw"), 0);
  CHECK_LT(10, stands(1, "power_1_kw"));
}

TEST(fly_flies_the_stick_that_trim_prints) {
  const CsvText trim(
      run_tiltrotor("trim --speed 40 --grid realtime --altitude 300 --columns long_stick_in").out);
  const check::ScratchFolder folder;
  const std::string series =
      folder.write("s.csv", "time_s,long_stick_in\n0," + trim.text(0, "long_stick_in") + "\n");
  const Flown f = fly("0 scas off\n0 series " + series + "\n1 end\n", "--speed 40 --every 0.5");
  CHECK_EQ(f.result.exit_status, 0);
  CHECK_NEAR(f(1, "long_stick_from_neutral_in"),
             trim.number(0, "long_stick_in") - aircraft_data<double>().controls.long_travel, 1e-9);
}

// Rotors that nothing ties to the engines: what they take is the power, and what the engines do has no effect.
TEST_OF_XV15(fly_summary_takes_the_power_of_rotors_without_governor) {
  const Flown f = fly("0 governor off\n0 hold climb 15\n2 engine 1 fail\n5 end\n", "--speed 40 --every 0");
  CHECK_EQ(f.result.exit_status, 0);
  const double efficiency = aircraft_data<double>().controls.transmission_efficiency;
  double highest = 0, part = 0;
  int beyond = 0;
  for (std::size_t k = 0; k < f.count(); ++k) {
    const double needed = f(k, "rotor_power_kw") / efficiency / (f(k, "time_s") < 1.999 ? 2 : 1);
    highest = std::max(highest, needed);
    part = std::max(part, needed / f(k, "takeoff_power_kw"));
    beyond += k + 1 < f.count() && needed > f(k, "takeoff_power_kw");
  }
  CHECK_LT(1, part);
  CHECK_NEAR(summary(f, "highest power"), highest, 0.6);
  CHECK(says(f, "of an engine, " + std::to_string(static_cast<int>(part * 100)) + "."));
  CHECK_NEAR(summary(f, "governor off"), 0.01 * beyond, 0.006);
  CHECK(says(f, "engine 1 fail: no effect on the rotors from 2 s on, with the governor off\n"));
  const Flown governed = fly("0 hold climb 5\n2 engine 1 fail\n5 end\n", "--speed 40");
  CHECK(!says(governed, "governor") && !says(governed, "no effect"));
  CHECK(says(fly("1 governor off\n2 end\n", "--speed 40 --engines 1"),
             "engine 2 fail: no effect on the rotors from 1 s on, with the governor off\n"));
}

TEST(fly_says_that_a_shaft_does_not_twist) {
  const std::string said = "interconnect twists: no effect from ";
  CHECK(says(fly("1 governor ideal\n2 interconnect twists\n3 end\n", "--mast 60 --speed 60"),
             said + "2 s on, with the governor ideal\n"));
  CHECK(says(fly("1 governor off\n3 end\n", "--mast 60 --speed 60 --option interconnect=twists"),
             said + "1 s on, with the governor off\n"));
  CHECK(!says(fly("1 interconnect twists\n2 end\n", "--mast 60 --speed 60"), "no effect"));
}

// Every state that has a row has a column: the trace is the sum of the roots, and twist' = twist rate.
TEST(fly_matrices_have_the_twist_of_the_shaft) {
  const struct {
    const char *script, *options;
    int rows[3];  // more than those of a rigid shaft, at 0, 2 and 4 s
  } flights[] = {{"4 end\n", "--option interconnect=twists", {2, 2, 2}},
                 {"0 interconnect twists\n4 end\n", "", {2, 2, 2}},
                 {"1 interconnect twists\n3 interconnect rigid\n4 end\n", "", {0, 2, 0}},
                 {"4 end\n", "", {0, 0, 0}}};
  int rigid = 0;
  for (int flight = 3; flight >= 0; --flight) {
    const check::ScratchFolder folder;
    const Flown f =
        fly(flights[flight].script, std::string("--mast 60 --speed 60 --modes-every 2 --modes ") +
                                        check::quoted(folder.path("modes.csv")) + " --matrices " +
                                        check::quoted(folder.path("m")) + " " + flights[flight].options);
    CHECK_EQ(f.result.exit_status, 0);
    const CsvText a(folder.read("m/a.csv")), modes(folder.read("modes.csv"));
    const check::Traces t = check::traces(a, modes);
    for (std::size_t i = 0; i < a.rows.size(); ++i)
      if (a.text(i, "row") == "shaft_twist") CHECK_EQ(a.number(i, "twist_rate"), 1);
    if (flight == 3) rigid = t.rows[0];
    bool right = true;
    for (int k = 0; k < 3; ++k)
      right = right & CHECK_EQ(t.rows[k], rigid + flights[flight].rows[k]) &
              CHECK_NEAR(t.trace[k], t.sum[k], 1e-8 * t.size[k]);
    if (!right) NOTE(flights[flight].script);
  }
}

// A step beyond the stop stands at the stop, and the summary counts how long.
TEST(fly_steps_end_at_the_stops) {
  const auto& t = aircraft_data<double>().controls;
  const std::string far = std::to_string(1.5 * t.pedal_travel);
  const Flown f = fly("0 release all\n0 pedal 0\n0 stick lat 0\n0.5 doublet pedal " + far +
                          " 0.6\n0.5 step lat 0.1 0.4\n1.5 end\n",
                      "--mast 60 --speed 60 --every 0");
  CHECK_EQ(f.result.exit_status, 0);
  CHECK_NEAR(f(60, "pedal_in"), t.pedal_travel, 1e-12);
  CHECK_NEAR(f(100, "pedal_in"), -t.pedal_travel, 1e-12);
  CHECK_NEAR(f(120, "pedal_in"), 0, 1e-12);
  CHECK_NEAR(f(60, "lat_stick_in"), 0.1, 1e-12);
  CHECK(says(f, "held at its stop: pedal 0.60 s\n"));
  CHECK(!says(fly("0.5 step lat 0.1 0.4\n1 end\n", "--mast 60 --speed 60"), "stop"));
}

TEST(fly_leaves_the_files_that_it_reads) {
  const check::ScratchFolder folder;
  const std::string series_text = "time_s,pedal_in\n0,0\n", law_text = "input,q\nlong_stick,0\n";
  const std::string series = folder.write("s.csv", series_text), law = folder.write("law.csv", law_text);
  const std::string text = "0 series s.csv\n1 end\n", script = folder.write("x.txt", text);
  const std::string begin =
      "fly --speed 40 --script " + check::quoted(script) + " --feedback " + check::quoted(law) + " ";
  const auto refused = [&](const std::string& options, const std::string& part) {
    const check::ProgramResult result = run_tiltrotor(begin + options);
    const bool right = CHECK_EQ(result.exit_status, 2) & CHECK(result.err.find(part) != std::string::npos) &
                       CHECK_EQ(std::count(result.err.begin(), result.err.end(), '\n'), std::ptrdiff_t{1}) &
                       CHECK_EQ(folder.files(), 3);
    if (!right) NOTE(options << ": " << result.err);
  };
  refused("--output " + check::quoted(script),
          "--output: " + script + " is what this flight reads as --script");
  refused("--output " + check::quoted(folder.path("./s.csv")), "reads as series");
  refused("--modes " + check::quoted(law), "reads as --feedback");
  const std::string rows = check::quoted(folder.path("rows.csv"));
  refused("--output " + rows + " --modes " + rows, "writes as --output");
  CHECK(folder.read("x.txt") == text && folder.read("s.csv") == series_text &&
        folder.read("law.csv") == law_text);
}

TEST(fly_refuses_an_ideal_governor_before_take_off) {
  const check::ProgramResult ideal = fly("0 spool\n1 governor ideal\n2 hold height 9\n3 end\n", "").result;
  CHECK_EQ(ideal.exit_status, 2);
  CHECK(ideal.out.empty());
  CHECK(ideal.err.find("script.txt:2: governor ideal: not before take-off") != std::string::npos);
  CHECK_EQ(fly("0 governor ideal\n1 end\n", "--speed 40").result.exit_status, 0);
}

// Each once, at its first time; what waits for a take-off that comes is not ignored.
TEST(fly_says_what_wheels_keep_from_happening) {
  const Flown f =
      fly("0 hold speed 5\n0.2 hold speed 6\n0.3 land 1\n0.4 hold climb -1\n0.5 turn 3\n1 end\n", "");
  CHECK_EQ(f.result.exit_status, 0);
  CHECK(says(f,
             "land at 0.3 s: ignored, on the wheels\nhold climb at 0.4 s: ignored, on the wheels\n"
             "hold speed at 0 s: ignored, on the wheels\nturn at 0.5 s: ignored, on the wheels\n"));
  CHECK(!says(f, "at 0.2 s"));
  CHECK(!says(fly("0 hold speed 5\n0.5 hold height 3\n1 end\n", ""), "ignored"));
}

// Fuel takes the mass below its range; without fuel flow the rotors slow down below theirs.
TEST_OF_XV15(fly_names_what_leaves_its_range) {
  const Flown light = fly("1 end\n", "--speed 40 --mass 3000");
  CHECK_EQ(light.result.exit_status, 1);
  CHECK(says(light, "s, mass: leaves 3000..10000 kg (3000 kg in the last good step)\n"));
  const Flown slow = fly("0 release all\n0 throttle 0\n0 collective 20\n30 end\n", "--speed 40 --height 900");
  CHECK_EQ(slow.result.exit_status, 1);
  CHECK(says(slow, "s, rotor speed: leaves 20..80 rad/s (20."));
}

// A collective that was taken goes on as the governor has made it, and so do blades under another governor: no step, and
// hardly one of the power.
TEST(fly_hands_on_what_a_governor_has_added) {
  const struct {
    const char *from, *to;
  } changes[] = {{"pi", "off"}, {"ideal", "off"}, {"ideal", "pi"}, {"pi", "ideal"}};
  for (const auto& change : changes) {
    const Flown f =
        fly(std::string("0 governor ") + change.from +
                "\n0 collective 30\n0 mast 90\n1 step long 1 1\n5 governor " + change.to + "\n5.1 end\n",
            "--mast 90 --speed 90 --every 0.01 --columns "
            "time_s,collective75_deg,governor_deg,collective_right,rotor_power_kw");
    CHECK_EQ(f.result.exit_status, 0);
    CHECK_LT(0.1, std::fabs(f(499, "governor_deg")));
    const auto lever = [&f](std::size_t row) { return f(row, "collective75_deg") + f(row, "governor_deg"); };
    CHECK_NEAR(lever(500), lever(499), 0.05);
    CHECK_NEAR(f(500, "collective_right"), f(499, "collective_right"), 1e-3);
    CHECK_NEAR(f(500, "rotor_power_kw"), f(499, "rotor_power_kw"), 0.02 * f(499, "rotor_power_kw"));
    if (change.to == std::string("off")) CHECK_EQ(f(500, "governor_deg"), 0);
  }
}

// Under an ideal governor the pilot takes off the power until the blades are near flat.
TEST(fly_lands_under_an_ideal_governor) {
  const Flown f = fly("0 gear down\n0 governor ideal\n9 land 0.6\n70 end\n",
                      "--height 5 --every 1 --columns time_s,weight_on_wheels,collective75_deg,governor_deg");
  CHECK_EQ(f.result.exit_status, 0);
  const std::size_t last = f.count() - 1;
  CHECK_LT(0.5, f(last, "weight_on_wheels"));
  CHECK_NEAR(f(last, "collective75_deg") + f(last, "governor_deg"), 0.07 * 180 / 3.14159265358979, 0.05);
}

// A take-off to 3 m is no error of the 3 m that are held; a height that was held and is lost is one.
TEST(fly_counts_a_held_height_from_when_it_is_there) {
  const Flown f = fly("0 spool\n34 hold height 3\n60 end\n", "");
  CHECK_EQ(f.result.exit_status, 0);
  CHECK_LT(summary(f, "height held"), 0.51);
  const Flown low = fly("0 hold height 60 5\n20 throttle 0.3\n40 end\n",
                        "--speed 40 --height 50 --every 1 --columns time_s,height_m");
  const double lost = 60 - low(low.count() - 1, "height_m");
  CHECK_LT(10, lost);
  CHECK_NEAR(summary(low, "height held"), lost, 0.01);
}

TEST(fly_takes_contingency_power) {
  const Flown f = fly("0 engine 2 fail\n0 throttle 1.2\n20 end\n",
                      "--speed 40 --columns time_s,power_1_kw,takeoff_power_kw");
  const auto& t = aircraft_data<double>();
  CHECK_REL(f(f.count() - 1, "power_1_kw"),
            f(f.count() - 1, "takeoff_power_kw") * t.systems.drive.contingency / t.controls.engine_power,
            1e-3);
  const check::ProgramResult more = fly("0 throttle 1.21\n1 end\n", "--speed 40").result;
  CHECK_EQ(more.exit_status, 2);
  CHECK(more.err.find("0..1.2") != std::string::npos);
}

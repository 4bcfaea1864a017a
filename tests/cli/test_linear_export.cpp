// What files of linear models tell of themselves: settings, program, outputs. Expected: what the user typed, the air's
// geometry and the law of power, and the modes of the command of that name, through Octave where it is.
#include <cmath>
#include <regex>
#include <sstream>
#include <vector>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "cli/json_grammar.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"

using check::run_program;
using check::run_tiltrotor;

namespace {

const std::string kFlight = "linearize --mast 60 --speed 60 --grid realtime --altitude 1500 --mass 5500 ";

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Numbers of a member that is an array, one of arrays by rows.
std::vector<double> numbers(const std::string& json, const std::string& member) {
  const std::size_t begin = json.find("\n\"" + member + "\": [");
  std::vector<double> out;
  if (!CHECK(begin != std::string::npos)) return out;
  std::size_t end = begin + member.size() + 6;
  for (int open = 1; open > 0 && end < json.size(); ++end)
    open += json[end] == '[' ? 1 : json[end] == ']' ? -1 : 0;
  std::string text = json.substr(begin + member.size() + 5, end - begin - member.size() - 5);
  for (char& c : text) c = c == '[' || c == ']' || c == ',' ? ' ' : c;
  std::istringstream in(text);
  for (double x; in >> x;) out.push_back(x);
  return out;
}

std::vector<std::string> names(const std::string& json, const std::string& member) {
  const std::size_t begin = json.find("\n\"" + member + "\": [");
  const std::string line =
      begin == std::string::npos ? "" : json.substr(begin + 1, json.find('\n', begin + 1) - begin);
  std::vector<std::string> out;
  const std::regex name("\"name\": \"(\\w+)\", \"unit\": \"[^\"]+\"");
  for (std::sregex_iterator match(line.begin(), line.end(), name), end; match != end; ++match)
    out.push_back((*match)[1]);
  return out;
}

std::size_t place(const std::vector<std::string>& names, const std::string& name) {
  std::size_t k = 0;
  while (k < names.size() && names[k] != name) ++k;
  CHECK(k < names.size());
  return k;
}

}  // namespace

TEST_OF_XV15(cli_linearize_json_tells_every_setting) {
  const std::string json =
      run_tiltrotor(
          kFlight +
          "--flap 20 --rotor-rpm 560 --cg-sl 300 --climb 3 --option wake=gtrs_empirical --format json")
          .out;
  CHECK(check::JsonGrammar::accepts(json));
  for (const char* const told :
       {"\"mast_deg\": 60,", "\"flap_deg\": 20,", "\"rotor_rpm\": 560,", "\"mass_kg\": 5500,",
        "\"cg_sl_in\": 300,", "\"altitude_m\": 1500,", "\"climb_deg\": 3,", "\"sideslip_deg\": 0,",
        "\"turn_rate_degps\": 0,", "\"tables\": \"c1\"", "\"grid\": \"realtime\"",
        "\"wake\": \"gtrs_empirical\"", "\"governor\": \"off\"", "\"reduce\": \"none\"", "\"scas\": \"off\"",
        "\"version\": ", "\"commit\": \"", "\"derivatives\": \"automatic\""})
    if (!CHECK(contains(json, told))) NOTE(told);
  // As many switches as the help lists, those that stand for several others aside, and the reduction.
  const std::string help = run_tiltrotor("linearize --help").out;
  const std::string switches = json.substr(json.find("\"switches\": {"));
  const std::string told = switches.substr(0, switches.find('}'));
  const std::regex listed("\n  (\\w+)=\\S+ ");
  int count = 0;
  for (std::sregex_iterator match(help.begin(), help.end(), listed), end; match != end; ++match, ++count)
    if ((*match)[1] != "data_set" && !CHECK(contains(told, "\"" + (*match)[1].str() + "\": \"")))
      NOTE((*match)[1].str());
  CHECK_LE(40, count);
  CHECK(contains(run_tiltrotor(kFlight + "--format json --reduce quasi_steady").out,
                 "\"reduce\": \"quasi_steady\""));
  // Also of a flight that finds no trim.
  CHECK(contains(run_tiltrotor("linearize --mast 90 --speed 20 --mass 5500 --format json").out,
                 "\"mass_kg\": 5500,"));
  // The script tells the same.
  const std::string script = run_tiltrotor(kFlight + "--format matlab").out;
  for (const char* const line :
       {"model(1).settings.mass_kg = 5500;\n", "model(1).settings.switches.grid = 'realtime';\n"})
    if (!CHECK(contains(script, line))) NOTE(line);
}

// What the flight was asked for, by the names of the options, and the gains that close it at its speed: halfway between
// two rows of the law.
TEST_OF_XV15(cli_linearize_tells_what_the_flight_was_asked_for) {
  const check::ScratchFolder folder;
  const std::string law =
      folder.write("law.csv", "speed_mps,input,q,load_factor\n80,long_stick,-7,0.2\n120,long_stick,-5,0.4\n");
  struct Told {
    const char *options, *json, *matlab;
  };
  const Told cases[] = {
      {"--isa-offset 15", "\"isa_offset_k\": 15,", "isa_offset_k = 15;"},
      {"", "\"isa_offset_k\": 0, \"engines\": 2,", "engines = 2;"},
      {"--engines 1", "\"engines\": 1,", "engines = 1;"},
      {"--azimuth 1", "\"azimuth_deg\": 1,", "azimuth_deg = 1;"},
      {"--bank 30", "\"bank_deg\": 30,", "bank_deg = 30;"},
      {"--load-factor 1.1", "\"load_factor\": 1.1,", "load_factor = 1.1;"},
      {"--bank 20 --ball centred", "\"ball\": \"centred\",", "ball = 'centred';"},
      {"--hold power_kw=1000 --free climb_deg", "\"hold\": \"power_kw=1000\", \"free\": \"climb_deg\",",
       "hold = 'power_kw=1000';"},
  };
  const std::string flight = " --mast 90 --speed 100 --grid realtime ";
  for (const Told& told : cases) {
    const std::string options = flight + told.options;
    const std::string json = run_tiltrotor("linearize --format json" + options).out;
    CHECK(check::JsonGrammar::accepts(json));
    if (!CHECK(contains(json, told.json))) NOTE(told.options);
    if (!CHECK(contains(run_tiltrotor("linearize --format matlab" + options).out,
                        std::string("model(1).settings.") + told.matlab)))
      NOTE(told.options);
    if (!CHECK(contains(run_tiltrotor("qlpv" + options).out, told.json))) NOTE("qlpv " << told.options);
  }
  const std::string loop = flight + "--feedback " + check::quoted(law);
  const std::string json = run_tiltrotor("linearize --format json" + loop).out;
  CHECK(check::JsonGrammar::accepts(json));
  CHECK(contains(json,
                 "\"feedback\": [{\"input\": \"long_stick\", \"output\": \"q\", \"gain\": -6}, "
                 "{\"input\": \"long_stick\", \"output\": \"load_factor\", \"gain\": 0.3"));
  CHECK(contains(run_tiltrotor("linearize --format matlab" + loop).out,
                 "settings.feedback = struct('input', {'long_stick', 'long_stick'}, 'output', {'q', "
                 "'load_factor'}, 'gain', {-6, 0.3"));
  CHECK(!contains(run_tiltrotor("linearize --format json" + flight).out, "\"feedback\": ["));
}

// Airspeed is the length of (u, v, w), power is torque times rotor speed, stick and elevator are geared.
TEST(cli_linearize_has_the_outputs) {
  const std::string json = run_tiltrotor("linearize --mast 90 --speed 80 --sideslip 2 --format json").out;
  const std::vector<std::string> states = names(json, "states"), outputs = names(json, "outputs");
  const std::vector<double> x = numbers(json, "x0"), y = numbers(json, "y0"), c = numbers(json, "C"),
                            d = numbers(json, "D");
  const std::size_t n = states.size(), m = names(json, "controls").size(), k = outputs.size();
  if (!CHECK(k > 0 && x.size() == n && y.size() == k && c.size() == k * n && d.size() == k * m)) return;
  const std::size_t airspeed = place(outputs, "airspeed");
  for (const char* const name : {"u", "v", "w"})
    CHECK_NEAR(c[airspeed * n + place(states, name)], x[place(states, name)] / y[airspeed], 1e-12);
  CHECK_NEAR(y[airspeed], 80, 1e-9);
  CHECK_NEAR(y[place(outputs, "sideslip")], 2 * std::acos(-1.0) / 180, 1e-9);
  CHECK_NEAR(y[place(outputs, "climb_rate")], 0, 1e-9);
  std::smatch rpm;
  if (!CHECK(std::regex_search(json, rpm, std::regex("\"rotor_rpm\": ([0-9.]+)")))) return;
  const double speed = std::stod(rpm[1]) * std::acos(-1.0) / 30;
  for (const char* const side : {"right", "left"}) {
    const std::size_t torque = place(outputs, std::string("torque_") + side),
                      power = place(outputs, std::string("power_") + side);
    for (std::size_t j = 0; j < n; ++j)
      CHECK_NEAR(c[power * n + j], speed * c[torque * n + j], 1e-6 + 1e-9 * std::fabs(c[power * n + j]));
  }
  CHECK(d[place(outputs, "elevator") * m + 1] > 0 && d[place(outputs, "collective_right") * m] > 0);
}

// Without the package a script that makes no system says so, once.
TEST(cli_linearize_script_names_the_package_of_its_system) {
  const std::string script =
      run_tiltrotor("linearize --mast 90 --speed 100:20:120 --grid realtime --format matlab").out;
  const std::size_t said =
      script.find("else\n  disp('model(k).ss is left out: ss() is of the control package");
  CHECK(said != std::string::npos && script.find("else\n", said + 1) == std::string::npos);
  CHECK(contains(script, "model(2).ss = ss("));
  const std::string tool = check::quoted(check::source_path("tests/tool.sh"));
  const check::ProgramResult there = run_program(tool + " octave octave octave");
  if (there.exit_status != 0) {
    NOTE(there.out);
    return;
  }
  const check::ScratchFolder folder;
  const check::ProgramResult octave = run_program(
      "octave --no-gui --norc -q " + check::quoted(folder.write("model.m", script)) + " 2>/dev/null");
  CHECK(contains(octave.out, "pkg load control"));
}

// Another program's poles of the script's system are the modes of this one.
TEST(slow_cli_octave_finds_the_same_poles) {
  const std::string tool = check::quoted(check::source_path("tests/tool.sh"));
  check::ProgramResult there = run_program(tool + " octave octave octave");
  if (there.exit_status == 0 && run_program("octave --no-gui -q --eval 'pkg load control'").exit_status != 0)
    there = {1, "octave: not installed: package control (Debian: octave-control), left out", ""};
  if (there.exit_status != 0) {
    NOTE(there.out);
    return;
  }
  const check::ScratchFolder folder;
  for (const char* const which : {"", "--option governor=pi", "--reduce rigid"}) {
    const std::string flight = " --mast 60 --speed 60 --grid realtime " + std::string(which);
    CHECK_EQ(
        run_tiltrotor("linearize --format matlab --output " + check::quoted(folder.path("model.m")) + flight)
            .exit_status,
        0);
    const check::ProgramResult octave = run_program(
        "cd " + check::quoted(folder.path("")) +
        " && octave --no-gui -q --eval \"pkg load control; run model.m; p = pole(model(1).ss); printf('%.17g %.17g\\n', "
        "[real(p) imag(p)]'); printf('%s\\n', get(model(1).ss, 'inname'){2});\" 2>/dev/null");
    std::vector<std::pair<double, double>> poles;
    std::istringstream lines(octave.out);
    for (double re, im; lines >> re >> im;) poles.emplace_back(re, im);
    CHECK(contains(octave.out, "long_stick"));
    const check::CsvText modes(run_tiltrotor("modes --format csv" + flight).out);
    std::size_t found = 0;
    for (std::size_t row = 0; row < modes.rows.size(); ++row) {
      const double re = modes.number(row, "real"), im = modes.number(row, "imag");
      found += im != 0 ? 2 : 1;
      double nearest = 1e9;
      for (const auto& [a, b] : poles) nearest = std::fmin(nearest, std::hypot(a - re, b - im));
      if (!CHECK_LE(nearest, 1e-8 * (1 + std::hypot(re, im)))) NOTE(which << ": " << re << " " << im);
    }
    CHECK_EQ(poles.size(), found);
  }
}

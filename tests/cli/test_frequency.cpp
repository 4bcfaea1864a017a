// `bode`, `qualities`, shapes of modes and reduced models on the command line. Expected: the program's own A and B put
// through another formula here, and the limits as the published file has them.
#include <algorithm>
#include <cmath>
#include <complex>
#include <fstream>
#include <iterator>
#include <map>
#include <vector>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "cli/exported_model.hpp"
#include "cli/scratch_folder.hpp"
#include "csv_file.hpp"
#include "plot/xml_check.hpp"
#include "run_program.hpp"
#include "this_aircraft.hpp"

using check::CsvText;
using check::run_tiltrotor;
using check::ScratchFolder;
using C = std::complex<double>;

namespace {

// y/u = det [s I - A, b; -c, 0] / det (s I - A): Cramer's rule, on what `linearize` prints.
struct Printed {
  std::vector<std::string> states;
  std::map<std::string, double> entry;  // "row column"

  explicit Printed(const std::string& options) {
    const CsvText rows(run_tiltrotor("linearize --format csv --control-set all " + options).out);
    for (std::size_t i = 0; i < rows.rows.size(); ++i) {
      if (rows.text(i, "matrix") == "x0") states.push_back(rows.text(i, "row"));
      if (rows.text(i, "matrix") == "A" || rows.text(i, "matrix") == "B")
        entry[rows.text(i, "row") + " " + rows.text(i, "column")] = rows.number(i, "value");
    }
  }

  C response(const std::string& input, const std::string& output, C s) const {
    const std::size_t n = states.size();
    std::vector<std::vector<C>> below(n, std::vector<C>(n)), above(n + 1, std::vector<C>(n + 1));
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j)
        above[i][j] = below[i][j] = (i == j ? s : 0.0) - entry.at(states[i] + " " + states[j]);
      above[i][n] = entry.at(states[i] + " " + input);
      above[n][i] = states[i] == output ? -1.0 : 0.0;
    }
    return determinant(above) / determinant(below);
  }

  static C determinant(std::vector<std::vector<C>> m) {
    C product = 1;
    for (std::size_t k = 0; k < m.size(); ++k) {
      std::size_t pivot = k;
      for (std::size_t i = k; i < m.size(); ++i)
        if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
      if (pivot != k) std::swap(m[pivot], m[k]), product = -product;
      product *= m[k][k];
      for (std::size_t i = k + 1; i < m.size(); ++i) {
        const C factor = m[i][k] / m[k][k];
        for (std::size_t j = k; j < m.size(); ++j) m[i][j] -= factor * m[k][j];
      }
    }
    return product;
  }
};

std::string content(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST(cli_bode_responses_are_those_of_the_printed_matrices) {
  const Printed model("--mast 30 --speed 50");
  const CsvText rows(
      run_tiltrotor("bode --format csv --mast 30 --speed 50 --from long_stick,pedal --to theta,r,b1c_R "
                    "--frequency 0.2,2,20")
          .out);
  CHECK_EQ(rows.rows.size(), 18u);
  int silent = 0;
  for (std::size_t i = 0; i < rows.rows.size(); ++i) {
    const double omega = rows.number(i, "omega_rad_s"), gain = rows.number(i, "gain");
    const C expected = model.response(rows.text(i, "input"), rows.text(i, "output"), {0, omega});
    if (rows.text(i, "status") == "no_response") {
      ++silent;
      CHECK_EQ(gain, 0.0);
      CHECK_LT(std::abs(expected), 1e-9);
      continue;
    }
    CHECK_NEAR(gain, std::abs(expected), 1e-7 * std::abs(expected));
    const double phase = rows.number(i, "phase_deg") * 3.14159265358979323846 / 180;
    CHECK_LT(std::abs(std::polar(1.0, phase) - expected / std::abs(expected)), 1e-7);
  }
  CHECK_EQ(silent, 6);  // pitch to pedal, yaw to stick
}

// At each zero the printed matrices do not answer; poles and gain give the response again.
TEST(cli_bode_roots_make_the_response) {
  const Printed model("--mast 60 --speed 70");
  const CsvText rows(
      run_tiltrotor("bode --format csv --mast 60 --speed 70 --from pedal --to phi --show roots").out);
  const C at(0.3, 1.7);
  C product = 1;
  double gain = 0, steady = 0;
  for (std::size_t i = 0; i < rows.rows.size(); ++i) {
    const std::string kind = rows.text(i, "kind");
    if (kind == "gain") gain = rows.number(i, "real");
    if (kind == "steady_gain") steady = rows.number(i, "real");
    if (kind != "zero" && kind != "pole") continue;
    const C root(rows.number(i, "real"), rows.number(i, "imag"));
    product = kind == "zero" ? product * (at - root) : product / (at - root);
    if (kind == "zero") CHECK_LT(std::abs(model.response("pedal", "phi", root)), 1e-7);
  }
  const C expected = model.response("pedal", "phi", at);
  CHECK_LT(std::abs(gain * product - expected), 1e-7 * std::abs(expected));
  CHECK_NEAR(steady, model.response("pedal", "phi", 0).real(), 1e-7 * std::abs(steady));
}

// The phase margin is reached, and the loop of the printed gain has the unstable roots that Nyquist's criterion counts.
TEST(cli_bode_margins_are_on_the_curve) {
  const std::string flight = "--format csv --mast 90 --speed 100 --from long_stick --to theta ";
  const CsvText m(run_tiltrotor("bode --show margins --gain -10 " + flight).out);
  const double omega = m.number(0, "omega_phase_rad_s");
  const C loop = -10.0 * Printed("--mast 90 --speed 100").response("long_stick", "theta", {0, omega});
  CHECK_NEAR(std::abs(loop), 1, 1e-8);
  const double half_turn = 3.14159265358979323846;
  CHECK_NEAR(std::cos(std::arg(loop) + half_turn),
             std::cos(m.number(0, "phase_margin_deg") * half_turn / 180), 1e-8);
  CHECK_EQ(m.number(0, "unstable_closed"), 0.0);
  // With systems: without rate damping the attitude in hover never has 45 deg left, with it there is a bandwidth.
  const CsvText bare(run_tiltrotor("bode --format csv --show margins").out);
  const CsvText damped(run_tiltrotor("bode --format csv --show margins --scas on --option governor=pi").out);
  CHECK(bare.text(0, "bandwidth_phase_rad_s").empty() && bare.text(0, "bandwidth_rad_s").empty());
  CHECK_LT(0.5, damped.number(0, "bandwidth_rad_s"));
}

TEST(cli_bode_and_qualities_draw_what_they_print) {
  const ScratchFolder folder;
  const std::string bode = folder.path("bode.svg"), shapes = folder.path("shapes.svg"),
                    levels = folder.path("q.svg");
  CHECK_EQ(run_tiltrotor("bode --mast 90 --speed 80,100 --figure " + bode).exit_status, 0);
  CHECK_EQ(run_tiltrotor("modes --mast 90 --speed 100 --figure " + shapes).exit_status, 0);
  CHECK_EQ(run_tiltrotor("qualities --mast 90 --speed 80,100 --figure " + levels).exit_status, 0);
  for (const std::string& file : {bode, shapes, levels}) {
    const std::string svg = content(file);
    CHECK_EQ(check::XmlChecker::fault(svg), std::string());
  }
  CHECK(contains(content(bode), "theta to long_stick"));
  CHECK(contains(content(shapes), "dutch_roll"));
  CHECK(contains(content(levels), "Dutch roll, MIL-F-8785C"));
}

TEST(cli_bad_frequencies_and_names_are_refused) {
  for (const char* const bad :
       {"bode --from elevatr", "bode --to thta", "bode --frequency 3..1", "bode --frequency 1..a",
        "bode --frequency -1", "bode --gain 2", "bode --show all", "bode --scas maybe",
        "modes --normalise q2", "modes --normalise q", "modes --reduce first", "qualities --category D",
        "qualities --figure /nowhere/at/all.svg", "bode --from throttle_R"}) {
    const check::ProgramResult result = run_tiltrotor(bad);
    CHECK_EQ(result.exit_status, 2);
    CHECK_EQ(result.out, std::string());
    if (!CHECK_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1)) NOTE(bad << ": " << result.err);
  }
  CHECK_EQ(run_tiltrotor("bode --from throttle_R --option governor=pi").exit_status, 0);
}

// Every root of the full model stands beside the reduced one, and is one that the full model prints.
TEST(cli_modes_reduced_show_the_error_of_each_root) {
  const std::string flight = "modes --format csv --mast 90 --speed 100 ";
  const CsvText full(run_tiltrotor(flight).out);
  std::map<std::string, C> root;
  for (std::size_t i = 0; i < full.rows.size(); ++i)
    root[full.text(i, "mode")] = {full.number(i, "real"), full.number(i, "imag")};
  double error[2] = {};
  const char* const order[] = {"rigid", "quasi_steady"};
  for (int k = 0; k < 2; ++k) {
    const CsvText rows(run_tiltrotor(flight + "--reduce " + order[k]).out);
    CHECK_EQ(rows.rows.size(), 5u);
    for (std::size_t i = 0; i < rows.rows.size(); ++i) {
      const C known = root[rows.text(i, "mode")];
      const C own(rows.number(i, "real"), rows.number(i, "imag"));
      CHECK_LT(std::abs(C(rows.number(i, "full_real"), rows.number(i, "full_imag")) - known), 1e-9);
      CHECK_NEAR(rows.number(i, "root_error"), std::abs(own - known) / std::abs(known), 1e-9);
      error[k] = std::max(error[k], rows.number(i, "root_error"));
    }
  }
  CHECK_LT(error[0], 0.03);
  CHECK_LT(0.08, error[1]);
}

// With systems their states stay, and their roots; what the rotors lag is all that is off.
TEST(cli_modes_reduced_keep_the_systems) {
  for (const std::string systems : {"--option governor=pi ", "--option governor=ideal ", "--scas on ",
                                    "--scas on --option governor=pi --option interconnect=twists "}) {
    const std::string flight = this_aircraft::flown("--mast 90 --speed 100 --grid realtime " + systems) + " ";
    const CsvText full(run_tiltrotor("modes --format csv " + flight).out);
    double error[2] = {};
    const char* const order[] = {"--reduce rigid ", "--reduce quasi_steady "};
    for (int k = 0; k < 2; ++k) {
      const CsvText rows(run_tiltrotor("modes --format csv " + flight + order[k]).out);
      const check::ExportedModel model(flight + order[k]), whole(flight);
      CHECK_EQ(whole.n() - model.n(), 15u);  // seven states of each rotor, and the downwash
      double roots = 0;
      for (std::size_t i = 0; i < rows.rows.size(); ++i) {
        const C own(rows.number(i, "real"), rows.number(i, "imag"));
        const C known(rows.number(i, "full_real"), rows.number(i, "full_imag"));
        roots += own.imag() > 0 ? 2 : 1;
        double nearest = HUGE_VAL;
        for (std::size_t j = 0; j < full.rows.size(); ++j)
          nearest = std::min(nearest, std::abs(known - C(full.number(j, "real"), full.number(j, "imag"))));
        CHECK_LT(nearest, 1e-9);
        CHECK_NEAR(rows.number(i, "root_error"), std::abs(own - known) / std::abs(known), 1e-8);
        if (std::abs(known) < 5) error[k] = std::max(error[k], rows.number(i, "root_error"));
      }
      CHECK_EQ(static_cast<std::size_t>(roots), model.n());
    }
    NOTE(systems << ": largest error of a root below 5 rad/s " << error[0] << ", in balance " << error[1]);
    CHECK_LT(error[0], 0.05);
    CHECK_LT(error[0], 0.5 * error[1]);
  }
}

// theta' = q; the state that is named is one at angle zero, the others stay; participations sum to one.
TEST(cli_modes_shapes_are_normalised) {
  const std::string flight = "modes --format csv --show shapes --mast 90 --speed 100 ";
  for (const char* const systems : {"", "--scas on --option governor=pi "}) {
    const CsvText rows(run_tiltrotor(flight + systems + "--normalise theta").out);
    std::map<std::string, double> total;
    std::map<std::string, C> theta, q, lambda;
    for (std::size_t i = 0; i < rows.rows.size(); ++i) {
      const std::string mode = rows.text(i, "mode");
      total[mode] += rows.number(i, "participation");
      lambda[mode] = {rows.number(i, "real"), rows.number(i, "imag")};
      if (rows.text(i, "normalised_by") != "theta" || rows.text(i, "angle_deg").empty()) continue;
      const C phasor =
          std::polar(rows.number(i, "magnitude"), rows.number(i, "angle_deg") * 3.14159265358979323846 / 180);
      if (rows.text(i, "state") == "theta") theta[mode] = phasor;
      if (rows.text(i, "state") == "q") q[mode] = phasor;
    }
    CHECK_LE(2u, theta.size());
    for (const auto& [mode, sum] : total) CHECK_NEAR(sum, 1, 1e-9);
    for (const auto& [mode, phasor] : theta) {
      CHECK_LT(std::abs(phasor - 1.0), 1e-12);
      CHECK_LT(std::abs(q[mode] - lambda[mode]), 1e-7 * (1 + std::abs(lambda[mode])));
    }
    CHECK(theta.count("short_period") == 1);
    CHECK(theta.count("dutch_roll") == 0);  // theta stands still there
  }
}

// Limits as the file has them, levels by comparing again; roots are those of `modes`.
TEST_OF_XV15(cli_qualities_have_the_published_limits) {
  const CsvText rows(run_tiltrotor("qualities --format csv --mast 90 --speed 80,120").out);
  const CsvText modes(run_tiltrotor("modes --format csv --mast 90 --speed 80,120").out);
  int dutch = 0;
  for (std::size_t i = 0; i < rows.rows.size(); ++i) {
    CHECK(!rows.text(i, "source").empty());
    CHECK(rows.text(i, "confidence") == "high" || rows.text(i, "confidence") == "medium");
    if (rows.text(i, "quantity") == "dutch_zeta") {
      ++dutch;
      CHECK_NEAR(rows.number(i, "low_1"), 0.08, 0);
      CHECK_NEAR(rows.number(i, "low_2"), 0.02, 0);
      CHECK_NEAR(rows.number(i, "low_3"), 0, 0);
      const double zeta = rows.number(i, "value");
      CHECK_EQ(rows.text(i, "level"), std::string(zeta >= 0.08 ? "1" : zeta >= 0.02 ? "2" : "3"));
      for (std::size_t k = 0; k < modes.rows.size(); ++k)
        if (modes.text(k, "mode") == "dutch_roll" && modes.text(k, "speed_mps") == rows.text(i, "speed_mps"))
          CHECK_NEAR(modes.number(k, "damping_ratio"), zeta, 1e-9);
    }
    if (rows.text(i, "quantity") == "roll_time") {
      CHECK_NEAR(rows.number(i, "high_1"), 1.4, 0);
      CHECK_NEAR(rows.number(i, "high_2"), 3, 0);
      CHECK_NEAR(rows.number(i, "high_3"), 10, 0);
    }
  }
  CHECK_EQ(dutch, 2);
  // Categories have limits of their own: level 1 of category A wants more damping.
  const CsvText precise(run_tiltrotor("qualities --format csv --mast 90 --speed 80 --category A").out);
  for (std::size_t i = 0; i < precise.rows.size(); ++i)
    if (precise.text(i, "quantity") == "dutch_zeta") CHECK_NEAR(precise.number(i, "low_1"), 0.19, 0);
}

// Sensitivity and damping in hover: the steady response of the rate row, rotors in balance, from the printed quasi-steady
// matrices; an inch of stick turns the attitude as the complete model's step does.
TEST_OF_XV15(cli_qualities_in_hover_are_those_of_the_matrices) {
  const CsvText rows(run_tiltrotor("qualities --format csv").out);
  const CsvText entries(run_tiltrotor("linearize --format csv --reduce quasi_steady").out);
  std::map<std::string, double> entry;
  for (std::size_t i = 0; i < entries.rows.size(); ++i)
    entry[entries.text(i, "row") + " " + entries.text(i, "column")] = entries.number(i, "value");
  const std::map<std::string, double> expected = {{"sensitivity_pitch", std::abs(entry["q long_stick"])},
                                                  {"sensitivity_roll", std::abs(entry["p lat_stick"])},
                                                  {"sensitivity_yaw", std::abs(entry["r pedal"])},
                                                  {"damping_pitch", -entry["q q"]},
                                                  {"damping_roll", -entry["p p"]},
                                                  {"damping_yaw", -entry["r r"]}};
  std::size_t found = 0;
  for (std::size_t i = 0; i < rows.rows.size(); ++i) {
    const auto known = expected.find(rows.text(i, "quantity"));
    if (known == expected.end()) continue;
    ++found;
    CHECK_NEAR(rows.number(i, "value"), known->second, 1e-8);
    const bool met = known->second >= rows.number(i, "low_1");
    CHECK_EQ(rows.text(i, "level"), std::string(met ? "met" : "not met"));
  }
  CHECK_EQ(found, 11u);
  // The augmentation is made to damp: pitch 1/0.4 s.
  const CsvText damped(run_tiltrotor("qualities --format csv --scas on").out);
  for (std::size_t i = 0; i < damped.rows.size(); ++i)
    if (damped.text(i, "quantity") == "damping_pitch") CHECK_NEAR(damped.number(i, "value"), 2.5, 0.2);
}

// `bode` of outputs and of the heading, and what its margins leave empty. Expected: C (s I - A)^-1 B + D of the matrices
// that `linearize` exports, solved here; the kinematics of the heading; `qualities`.
#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "cli/exported_model.hpp"
#include "cli/feedback_law.hpp"
#include "cli/refused.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"
#include "this_aircraft.hpp"

using check::CsvText;
using check::ExportedModel;
using check::run_tiltrotor;
using C = std::complex<double>;

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

// x of (s I - A) x = b by elimination with pivots.
std::vector<C> states_at(const ExportedModel& model, const std::string& input, C s) {
  const std::size_t n = model.n(), column = ExportedModel::place(model.controls, input);
  std::vector<std::vector<C>> m(n, std::vector<C>(n + 1));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) m[i][j] = (i == j ? s : 0.0) - model.a[i * n + j];
    m[i][n] = model.b[i * model.m() + column];
  }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < n; ++i)
      if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
    std::swap(m[k], m[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const C factor = m[i][k] / m[k][k];
      for (std::size_t j = k; j <= n; ++j) m[i][j] -= factor * m[k][j];
    }
  }
  std::vector<C> x(n);
  for (std::size_t i = 0; i < n; ++i) x[i] = m[i][n] / m[i][i];
  return x;
}

C response(const ExportedModel& model, const std::string& input, const std::string& output, C s) {
  const std::vector<C> x = states_at(model, input, s);
  const std::size_t row = ExportedModel::place(model.outputs, output);
  C y = model.d[row * model.m() + ExportedModel::place(model.controls, input)];
  for (std::size_t j = 0; j < model.n(); ++j) y += model.c[row * model.n() + j] * x[j];
  return y;
}

// A row of `bode` is this number.
void check_row(const CsvText& rows, std::size_t i, C expected) {
  CHECK_NEAR(rows.number(i, "gain"), std::abs(expected), 1e-7 * std::abs(expected));
  CHECK_NEAR(rows.number(i, "gain_db"), 20 * std::log10(std::abs(expected)), 1e-6);
  const C turned = std::polar(1.0, rows.number(i, "phase_deg") * kDegree);
  if (!CHECK_LT(std::abs(turned - expected / std::abs(expected)), 1e-7))
    NOTE(rows.text(i, "output") << " to " << rows.text(i, "input"));
}

const std::string kOutputs = "load_factor,nz@100/0/80,climb_rate,thrust_right,htail_moment_y";

}  // namespace

TEST(cli_bode_outputs_are_those_of_the_exported_matrices) {
  const check::ScratchFolder folder;
  const std::string loop = check::law(folder, "law.csv", "input,load_factor,q\nlong_stick,3,-0.7\n");
  for (const std::string& systems :
       {std::string(), std::string("--scas on"), std::string("--option governor=pi --scas on"), loop}) {
    const std::string flight =
        this_aircraft::flown("--mast 60 --speed 60 --grid realtime --sideslip 3") + " " + systems;
    const ExportedModel model(flight + " --control-set all --outputs " + kOutputs);
    const check::ProgramResult run = run_tiltrotor("bode --format csv --from long_stick,pedal,gust_w --to " +
                                                   kOutputs + " --frequency 0.2,2,20 " + flight);
    const CsvText rows(run.out);
    if (!CHECK_EQ(rows.rows.size(), 45u)) NOTE(run.err);
    for (std::size_t i = 0; i < rows.rows.size(); ++i)
      check_row(
          rows, i,
          response(model, rows.text(i, "input"), rows.text(i, "output"), {0, rows.number(i, "omega_rad_s")}));
  }
}

// As many zeros as poles where the input acts at once; together they are the response.
TEST(cli_bode_zeros_of_an_output_make_the_response) {
  const std::string flight = this_aircraft::flown("--mast 90 --speed 100 --grid realtime") + " ";
  const CsvText rows(
      run_tiltrotor("bode --format csv --show roots --from elevator --to load_factor " + flight).out);
  const ExportedModel model(flight + "--control-set all --outputs load_factor");
  const C at(0.3, 1.7);
  C product = 1;
  int zeros = 0, poles = 0;
  double gain = 0;
  for (std::size_t i = 0; i < rows.rows.size(); ++i) {
    const std::string kind = rows.text(i, "kind");
    if (kind == "gain") gain = rows.number(i, "real");
    if (kind != "zero" && kind != "pole") continue;
    const C root(rows.number(i, "real"), rows.number(i, "imag"));
    (kind == "zero" ? zeros : poles) += 1;
    product = kind == "zero" ? product * (at - root) : product / (at - root);
  }
  CHECK_EQ(zeros, poles);
  CHECK_NEAR(gain, model.d[ExportedModel::place(model.controls, "elevator")], 1e-10);
  const C expected = response(model, "elevator", "load_factor", at);
  CHECK_LT(std::abs(gain * product - expected), 1e-7 * std::abs(expected));
}

// What is rounding is no response.
TEST(cli_bode_outputs_that_do_not_answer_say_so) {
  const CsvText rows(run_tiltrotor("bode --format csv --frequency 1 --from pedal,lat_stick --to load_factor,"
                                   "climb_rate,nz@100/0/80,total_aero_moment_y,airspeed " +
                                   this_aircraft::flown("--mast 90 --speed 100 --grid realtime"))
                         .out);
  CHECK_EQ(rows.rows.size(), 10u);
  for (std::size_t i = 0; i < rows.rows.size(); ++i)
    if (!CHECK_EQ(rows.text(i, "status"), std::string("no_response"))) NOTE(rows.text(i, "output"));
}

// psi' cos theta = q sin phi + r cos phi, differentiated here about the trim; in a turn all four parts are there.
TEST(cli_bode_heading_is_that_of_its_kinematics) {
  for (const char* const which : {"--mast 0 --speed 0", "--mast 60 --speed 60 --bank 40"}) {
    const std::string flight = this_aircraft::flown(which) + " --grid realtime ";
    const ExportedModel model(flight);
    const auto at = [&](const char* state) { return model.x0[ExportedModel::place(model.states, state)]; };
    const double phi = at("phi"), theta = at("theta"), q = at("q"), r = at("r");
    const CsvText rows(
        run_tiltrotor("bode --format csv --from pedal,lat_stick --to psi --frequency 0.3,3 " + flight).out);
    CHECK_EQ(rows.rows.size(), 4u);
    for (std::size_t i = 0; i < rows.rows.size(); ++i) {
      const C s(0, rows.number(i, "omega_rad_s"));
      const std::vector<C> x = states_at(model, rows.text(i, "input"), s);
      const auto moved = [&](const char* state) { return x[ExportedModel::place(model.states, state)]; };
      const C numerator = moved("q") * std::sin(phi) + moved("r") * std::cos(phi) +
                          moved("phi") * (q * std::cos(phi) - r * std::sin(phi));
      const C rate = numerator / std::cos(theta) + moved("theta") * std::sin(theta) /
                                                       std::pow(std::cos(theta), 2) *
                                                       (q * std::sin(phi) + r * std::cos(phi));
      check_row(rows, i, rate / s);
    }
  }
  // Straight ahead it is what the handling qualities have.
  const std::string hover = this_aircraft::flown("--mast 0 --speed 0 --scas on");
  const CsvText margins(run_tiltrotor("bode --format csv --show margins --from pedal --to psi " + hover).out);
  const CsvText levels(run_tiltrotor("qualities --format csv " + hover).out);
  bool found = false;
  for (std::size_t i = 0; i < levels.rows.size(); ++i) {
    if (levels.text(i, "quantity") != "bandwidth_yaw") continue;
    found = true;
    CHECK_NEAR(margins.number(0, "bandwidth_rad_s"), levels.number(i, "value"), 1e-7);
  }
  CHECK(found);
}

// The bandwidth of a rate response type is the smaller of two: of one alone there is none. A stable loop alone has a
// delay that ends it.
TEST_OF_XV15(cli_bode_margins_that_do_not_exist_are_empty) {
  const CsvText hover(
      run_tiltrotor("bode --format csv --show margins --from long_stick,pedal --to theta,r").out);
  int without = 0;
  for (std::size_t i = 0; i < hover.rows.size(); ++i) {
    const bool both =
        !hover.text(i, "bandwidth_phase_rad_s").empty() && !hover.text(i, "bandwidth_gain_rad_s").empty();
    CHECK_EQ(hover.text(i, "bandwidth_rad_s").empty(), !both);
    without += !both && !hover.text(i, "bandwidth_gain_rad_s").empty() ? 1 : 0;
  }
  CHECK_EQ(without, 2);
  const std::string flight =
      "bode --format csv --mast 90 --speed 100 --from elevator --to theta --show margins ";
  const CsvText unstable(run_tiltrotor(flight).out), stable(run_tiltrotor(flight + "--gain=-1").out);
  CHECK_EQ(unstable.text(0, "unstable_closed"), std::string("1"));
  CHECK(!unstable.text(0, "phase_margin_deg").empty() && unstable.text(0, "delay_margin_s").empty());
  CHECK_EQ(stable.text(0, "unstable_closed"), std::string("0"));
  CHECK_NEAR(stable.number(0, "delay_margin_s"),
             stable.number(0, "phase_margin_deg") * kDegree / stable.number(0, "omega_phase_rad_s"), 1e-9);
}

TEST(cli_bad_outputs_of_bode_are_refused) {
  check::check_refused("bode --to load_facter",
                       "'load_facter' is not in this model (did you mean load_factor?)");
  check::check_refused("bode --to nz@1/2", "'nz@1/2': a station is SL/BL/WL in inches: nz@230/0/75");
  check::check_refused("bode --to theta,nz@1/2/99999", "-10000..10000");
  for (const std::string command : {"bode", "linearize", "modes", "qualities", "qlpv", "sensitivity"})
    check::check_refused(command + " --option position_states=on", "positions are not in a linear model");
  check::check_refused("qlpv --stamp", "json has no place for comments");
  check::check_refused("respond --scas on", "`tiltrotor fly");
}

// `qlpv`. Expected: the models that `linearize` writes for each flight and the modes of `modes`; errors of linear
// interpolation, which fall with the square of the distance.
#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "cli/exported_model.hpp"
#include "cli/feedback_law.hpp"
#include "cli/json_grammar.hpp"
#include "cli/refused.hpp"
#include "run_program.hpp"
#include "this_aircraft.hpp"
#include "tiltrotor/math/algebra/eigen.hpp"
#include "tiltrotor/model/variables/controls.hpp"

using check::CsvText;
using check::ExportedModel;
using this_aircraft::flown;

namespace {

const std::string grid = "qlpv --grid realtime --flap 0 ";

check::ProgramResult run_tiltrotor(const std::string& words) { return check::run_tiltrotor(flown(words)); }

std::string speed(double mps) { return this_aircraft::shortest(mps); }

CsvText check_of(const std::string& options) {
  return CsvText(run_tiltrotor(grid + "--show check --format csv " + options).out);
}

double error_of(const CsvText& rows, const std::string& name) {
  for (std::size_t i = 0; i < rows.rows.size(); ++i)
    if (rows.text(i, "name") == name) return rows.number(i, "error");
  return HUGE_VAL;
}

// Output y over control v at i omega, by Gauss in complex numbers.
std::complex<double> response_of(const ExportedModel& m, double omega, std::size_t y, std::size_t v) {
  const std::size_t n = m.n();
  std::vector<std::vector<std::complex<double>>> t(n, std::vector<std::complex<double>>(n + 1));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) t[i][j] = {-m.a[i * n + j], i == j ? omega : 0};
    t[i][n] = m.b[i * m.m() + v];
  }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < n; ++i)
      if (std::abs(t[i][k]) > std::abs(t[pivot][k])) pivot = i;
    std::swap(t[k], t[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const auto by = t[i][k] / t[k][k];
      for (std::size_t j = k; j <= n; ++j) t[i][j] -= by * t[k][j];
    }
  }
  std::complex<double> sum = m.d[y * m.m() + v];
  for (std::size_t k = 0; k < n; ++k) sum += m.c[y * n + k] * t[k][n] / t[k][k];
  return sum;
}

double bend_of(const std::string& control) {
  for (int k = 0; k < tiltrotor::control_count; ++k)
    if (control == tiltrotor::kControlVariables[k].name) return tiltrotor::kControlVariables[k].facts().bend;
  throw std::runtime_error("no control " + control);
}

}  // namespace

TEST(cli_qlpv_holds_the_models_of_linearize) {
  for (const std::string kind : {"--reduce none", "--reduce rigid", "--option governor=pi",
                                 "--option governor=ideal --control-set all", "--scas on",
                                 "--option governor=pi --scas on --reduce rigid"}) {
    const std::string axes =
        "--mast 80,90 --speed " + speed(85) + "," + speed(100) + " --altitude 0,300 " + kind;
    const std::string all = run_tiltrotor(grid + axes).out;
    CHECK(check::JsonGrammar::accepts(all));
    for (const char* mast : {"80", "90"})
      for (const double mps : {85.0, 100.0})
        for (const char* altitude : {"0", "300"}) {
          const std::string one =
              run_tiltrotor("linearize --grid realtime --flap 0 --format json --mast " + std::string(mast) +
                            " --speed " + speed(mps) + " --altitude " + altitude + " " + kind)
                  .out;
          const std::size_t matrices = one.find("\"x0\""), names = one.find("\"states\": [");
          CHECK(matrices != std::string::npos && names < matrices);
          const std::string model = one.substr(matrices, one.rfind("\n}") - matrices);
          CHECK(all.find(model) != std::string::npos);
          CHECK(all.find(one.substr(names, matrices - names - 2)) != std::string::npos);
        }
    const auto count = [&all](const std::string& word) {
      std::size_t found = 0;
      for (std::size_t at = all.find(word); at != std::string::npos; at = all.find(word, at + 1)) ++found;
      return found;
    };
    CHECK_EQ(count("\"A\": ["), 8u);
    CHECK_EQ(count("\"C\": ["), 8u);
    for (const char* name : {"\"altitude_m\", \"unit\": \"m\"", "\"mast_deg\", \"unit\": \"deg\"",
                             "\"speed_mps\", \"unit\": \"m/s\""})
      CHECK_EQ(count(name), 1u);
  }
}

// Closed loop and chosen outputs: those of linearize, and A - B K of the open grid point put together here.
TEST_OF_XV15(cli_qlpv_takes_outputs_and_feedback) {
  const check::ScratchFolder folder;
  const std::string loop = check::law(folder, "law.csv", "input,q,theta\nlong_stick,-7,-8\n");
  const std::string outputs = "--outputs nz,airspeed,htail_moment_y,q ";
  for (const std::string kind : {"", "--option governor=pi ", "--scas on --reduce rigid "}) {
    const std::string all = run_tiltrotor(grid + "--mast 90 --speed 85,100 " + outputs + kind + loop).out;
    CHECK(check::JsonGrammar::accepts(all));
    for (const double mps : {85.0, 100.0}) {
      const std::string flight =
          "--grid realtime --flap 0 --mast 90 --speed " + speed(mps) + " " + outputs + kind;
      const std::string one = run_tiltrotor("linearize --format json " + flight + loop).out;
      const std::size_t matrices = one.find("\"x0\""), names = one.find("\"states\": [");
      CHECK(all.find(one.substr(matrices, one.rfind("\n}") - matrices)) != std::string::npos);
      CHECK(all.find(one.substr(names, matrices - names - 2)) != std::string::npos);
      const ExportedModel open(flight), closed(flight + loop);
      const std::size_t stick = ExportedModel::place(open.controls, "long_stick");
      const auto check_rows = [&](const std::vector<double>& found, const std::vector<double>& by_state,
                                  const std::vector<double>& by_control) {
        for (std::size_t i = 0; i < found.size() / open.n(); ++i)
          for (std::size_t j = 0; j < open.n(); ++j) {
            const double gain = open.states[j] == "q" ? -7 : open.states[j] == "theta" ? -8 : 0;
            const double fed = by_control[i * open.m() + stick] * gain,
                         expected = by_state[i * open.n() + j] - fed;
            CHECK_NEAR(found[i * open.n() + j], expected, 1e-12 * (std::fabs(fed) + std::fabs(expected)));
          }
      };
      check_rows(closed.a, open.a, open.b);
      check_rows(closed.c, open.c, open.d);
      CHECK_EQ(closed.outputs.size(), 4u);
      // The row of a state is that state, and airspeed the length of a velocity.
      const std::size_t q = ExportedModel::place(closed.states, "q");
      for (std::size_t j = 0; j < closed.n(); ++j) CHECK_EQ(closed.c[3 * closed.n() + j], j == q ? 1.0 : 0.0);
      CHECK_NEAR(closed.y0[1], mps, 1e-9 * mps);
      for (const char* const of : {"u", "w"}) {
        const std::size_t place = ExportedModel::place(closed.states, of);
        CHECK_NEAR(closed.c[closed.n() + place], closed.x0[place] / mps, 1e-9);
      }
    }
    CHECK(all.find("\"input\": \"long_stick\", \"output\": \"q\", \"gain\": -7") != std::string::npos);
    CHECK(all.find("law.csv") != std::string::npos);
  }
}

// What the check says of outputs, from the models that linearize writes at the corners and at the centre: y0 by their
// mean, the response by C (i w - A)^-1 B + D solved here at the frequency that it names; of the input that moves the
// output most, each by the distance over which the model bends in it.
TEST_OF_XV15(cli_qlpv_check_covers_outputs) {
  const std::string flight =
      "--grid realtime --flap 0 --mast 90 --reduce rigid --outputs nz,climb_rate --speed ";
  const ExportedModel low(flight + "85"), high(flight + "95"), centre(flight + "90");
  ExportedModel mean = low;
  const auto average = [](std::vector<double>& to, const std::vector<double>& other) {
    for (std::size_t i = 0; i < to.size(); ++i) to[i] = (to[i] + other[i]) / 2;
  };
  average(mean.a, high.a), average(mean.b, high.b), average(mean.c, high.c), average(mean.d, high.d);
  average(mean.y0, high.y0);
  const CsvText found = check_of("--mast 90 --reduce rigid --outputs nz,climb_rate --speed 85,95");
  const auto row_named = [&](const std::string& kind, const std::string& end) {
    for (std::size_t i = 0; i < found.rows.size(); ++i) {
      const std::string name = found.text(i, "name");
      const bool ends = name.size() >= end.size() && name.substr(name.size() - end.size()) == end;
      if (ends && found.text(i, "kind") == kind) return i;
    }
    throw std::runtime_error("no " + end);
  };
  for (const std::size_t y : {0u, 1u}) {
    const std::size_t reading = row_named("output", centre.outputs[y]);
    CHECK_NEAR(found.number(reading, "real"), centre.y0[y], 1e-9);
    CHECK_NEAR(found.number(reading, "interpolated_real"), mean.y0[y], 1e-9);
    const std::size_t row = row_named("response", ">" + centre.outputs[y]);
    std::size_t v = 0;
    double most = 0;
    for (std::size_t k = 0; k < centre.m(); ++k)
      for (double omega = 0.1; omega < 10; omega *= 1.1) {
        const double size = std::abs(response_of(centre, omega, y, k)) * bend_of(centre.controls[k]);
        if (size > most) v = k;
        most = std::max(most, size);
      }
    CHECK_EQ(found.text(row, "name"), centre.controls[v] + ">" + centre.outputs[y]);
    const double omega = found.number(row, "worst_rad_s");
    const auto g = response_of(centre, omega, y, v), h = response_of(mean, omega, y, v);
    const double expected = std::abs(h - g) / std::abs(g);
    CHECK_NEAR(found.number(row, "error"), expected, 1e-6 * expected);
    // No other frequency is worse.
    for (double other = 0.1; other < 10; other *= 1.3) {
      const auto g1 = response_of(centre, other, y, v), h1 = response_of(mean, other, y, v);
      CHECK_LE(std::abs(h1 - g1) / std::abs(g1), 1.05 * expected);
    }
  }
}

// A point without a trim keeps its place, without matrices.
TEST(cli_qlpv_says_which_points_have_no_trim) {
  const auto run = run_tiltrotor(grid + "--mast 90 --speed 0," + speed(100));
  CHECK_EQ(run.exit_status, 1);
  CHECK(check::JsonGrammar::accepts(run.out));
  CHECK(run.out.find("\"A\": [") != std::string::npos);
  CHECK_EQ(run.out.find("\"A\": ["), run.out.rfind("\"A\": ["));
  CHECK_LT(0, std::count(run.err.begin(), run.err.end(), '\n'));
  const CsvText checked = check_of("--mast 90 --speed 0," + speed(100));
  CHECK_EQ(checked.rows.size(), std::size_t{1});
  CHECK_EQ(checked.text(0, "status").substr(0, 7), std::string("corner_"));
}

TEST(cli_qlpv_shards_join_to_the_whole) {
  for (const std::string& show :
       {std::string("model --reduce rigid"), std::string("check --format csv --reduce rigid"),
        std::string("check --format csv --option governor=pi")}) {
    const std::string axes = grid + "--show " + show + " --mast 80,85,90 --speed " + speed(90) + "," +
                             speed(100) + " --altitude 0,300";
    const std::string whole = run_tiltrotor(axes).out;
    std::string joined;
    for (const char* shard : {"1/5", "2/5", "3/5", "4/5", "5/5"})
      joined += run_tiltrotor(axes + " --shard " + shard).out;
    CHECK(whole == joined && !whole.empty());
  }
}

TEST_OF_XV15(cli_qlpv_check_compares_with_the_modes_at_the_centre) {
  struct Kind {
    std::string options;
    std::size_t responses;  // with a rotor speed that the throttle moves
  };
  for (const Kind& kind :
       {Kind{"", 4}, Kind{"--option governor=pi ", 5}, Kind{"--option governor=ideal ", 4}}) {
    const CsvText found = check_of(kind.options + "--mast 90 --speed " + speed(90) + "," + speed(110));
    const CsvText modes = CsvText(run_tiltrotor("modes --grid realtime --flap 0 --format csv --mast 90 " +
                                                kind.options + "--speed " + speed(100))
                                      .out);
    CHECK_EQ(found.rows.size(), modes.rows.size() + kind.responses);
    for (std::size_t i = 0; i < modes.rows.size(); ++i) {
      CHECK_EQ(found.text(i, "name"), modes.text(i, "mode"));
      const double size = modes.number(i, "frequency_rad_s");
      CHECK_NEAR(found.number(i, "real"), modes.number(i, "real"), 1e-9 * size);
      CHECK_NEAR(found.number(i, "imag"), modes.number(i, "imag"), 1e-9 * size);
      const double error = std::hypot(found.number(i, "interpolated_real") - found.number(i, "real"),
                                      found.number(i, "interpolated_imag") - found.number(i, "imag"));
      CHECK_NEAR(found.number(i, "error"), error / size, 1e-9);
    }
  }
}

// The mean of the matrices at both ends has the roots that are shown: eigenvalues of what `linearize` writes, put together
// here.
TEST_OF_XV15(cli_qlpv_check_interpolates_the_governed_matrices) {
  const std::string common = "--grid realtime --flap 0 --option governor=pi --mast 90 --speed ";
  const ExportedModel low(common + "90"), high(common + "110");
  const std::size_t n = low.n();
  CHECK(low.states == high.states && n > 24);
  constexpr int most = 40;
  const auto work = std::make_unique<tiltrotor::EigenWorkspace<double, most>>();
  const auto mean = std::make_unique<tiltrotor::Matrix<double, most, most>>();
  tiltrotor::set_zero(*mean);
  for (std::size_t i = 0; i < n * n; ++i)
    (*mean)(static_cast<int>(i / n), static_cast<int>(i % n)) = (low.a[i] + high.a[i]) / 2;
  tiltrotor::Eigenvalues<double, most> values{};
  CHECK(eigenvalues(*mean, static_cast<int>(n), *work, values) == tiltrotor::Status::ok);
  const CsvText found = check_of("--option governor=pi --mast 90 --speed 90,110");
  std::size_t roots = 0;
  for (std::size_t i = 0; i < found.rows.size() && found.text(i, "kind") == "root"; ++i, ++roots) {
    const double real = found.number(i, "interpolated_real"), imag = found.number(i, "interpolated_imag");
    double nearest = 1e9;
    for (int k = 0; k < values.size; ++k)
      nearest = std::min(nearest, std::hypot(values.real[k] - real, values.imag[k] - imag));
    CHECK_LE(nearest, 1e-7 * (1 + std::hypot(real, imag)));
  }
  CHECK_LT(10u, roots);
}

// To second order: a sixteenth of the cell leaves a 256th of the error, were it not for the knots of the tables.
TEST_OF_XV15(cli_qlpv_errors_fall_with_the_square_of_the_cell) {
  for (const std::string governor : {"off", "pi"}) {
    const auto around = [&governor](double half) {
      return check_of("--option governor=" + governor + " --mast 90 --speed " + speed(100 - half) + "," +
                      speed(100 + half));
    };
    const CsvText wide = around(8), narrow = around(0.5);
    for (const std::string name :
         {"short_period", "dutch_roll", "roll", "long_stick>q", "lat_stick>p", "throttle_R>rotor_speed"}) {
      if (governor == "off" && name.find("rotor_speed") != std::string::npos) continue;
      CHECK_LT(error_of(wide, name), 0.2);
      if (!CHECK_LT(error_of(narrow, name), 0.03 * error_of(wide, name))) NOTE(governor << " " << name);
    }
  }
}

TEST(cli_bad_qlpv_is_refused_in_one_line) {
  check::check_refused("qlpv --speed 100,90", "--speed: the values of a grid must increase");
  check::check_refused("qlpv --mast 30,30", "--mast: the values of a grid must increase");
  check::check_refused("qlpv --speed 90,100 --climb 0,2", "everything else takes one value");
  check::check_refused("qlpv --speed 90,100 --cg-sl 299,300", "everything else takes one value");
  check::check_refused("qlpv --show check", "needs two values");
  check::check_refused("qlpv --show other", "model or check");
  check::check_refused("qlpv --format csv", "json");
  check::check_refused("qlpv --outputs airsped", "airspeed");
  check::check_refused("qlpv --outputs nz,nz", "twice");
  check::check_refused("qlpv --feedback /nowhere/law.csv", "law.csv");
}

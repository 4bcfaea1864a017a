// `qlpv`. Expected: the models that `linearize` writes for each flight and the modes of `modes`; errors of linear
// interpolation, which fall with the square of the distance.
#include <algorithm>
#include <cmath>
#include <memory>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "cli/exported_model.hpp"
#include "cli/json_grammar.hpp"
#include "cli/refused.hpp"
#include "run_program.hpp"
#include "this_aircraft.hpp"
#include "tiltrotor/math/algebra/eigen.hpp"

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
}

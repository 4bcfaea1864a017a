// A feedback law from a file, in linear models. Expected: A - B K and its like by matrices that the program exports without
// the law, put together here, and the eigenvalues of those.
#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>

#include "check.hpp"
#include "cli/exported_model.hpp"
#include "cli/feedback_law.hpp"
#include "tiltrotor/math/algebra/eigen.hpp"
#include "tiltrotor/math/algebra/lu.hpp"

using check::ExportedModel;
using check::Gains;
using check::kFlight;
using check::law;
using check::quoted;
using check::run_tiltrotor;
using check::shipped;
using check::shipped_gains;

namespace {

using Numbers = std::vector<double>;

// M - right K, by rows of `rows` x m, m the controls of `open`.
Numbers minus_fed_back(const ExportedModel& open, Numbers m, const Numbers& right, const Gains& gains,
                       const std::string& speed) {
  const std::size_t n = open.n(), inputs = open.m();
  for (std::size_t i = 0; i < m.size() / n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t k = 0; k < inputs; ++k)
        m[i * n + j] -= right[i * inputs + k] * gains.at(speed, open.controls[k], open.states[j]);
  return m;
}

void check_equal(const Numbers& found, const Numbers& expected, std::size_t width, double tolerance) {
  if (!CHECK_EQ(found.size(), expected.size())) return;
  for (std::size_t i = 0; i < found.size(); ++i) {
    double row = 0;
    for (std::size_t j = i / width * width; j < (i / width + 1) * width; ++j)
      row = std::max(row, std::fabs(expected[j]));
    if (!CHECK_NEAR(found[i], expected[i], tolerance * row + 1e-300)) NOTE("entry " << i);
  }
}

// Every output over control v at a real s: C (s - A)^-1 B + D.
Numbers transfer(const ExportedModel& model, double s, std::size_t v) {
  const std::size_t n = model.n(), m = model.m();
  constexpr int most = 40;
  const auto lu = std::make_unique<tiltrotor::LU<double, most>>();
  const auto matrix = std::make_unique<tiltrotor::Matrix<double, most, most>>();
  tiltrotor::set_zero(*matrix);
  double x[most] = {};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j)
      (*matrix)(static_cast<int>(i), static_cast<int>(j)) = (i == j ? s : 0) - model.a[i * n + j];
    x[i] = model.b[i * m + v];
  }
  CHECK(lu_factor(*matrix, static_cast<int>(n), *lu) == tiltrotor::Status::ok);
  CHECK(lu_solve(*lu, x) == tiltrotor::Status::ok);
  Numbers y;
  for (std::size_t k = 0; k < model.outputs.size(); ++k) {
    y.push_back(model.d[k * m + v]);
    for (std::size_t j = 0; j < n; ++j) y.back() += model.c[k * n + j] * x[j];
  }
  return y;
}

using Root = std::complex<double>;
std::vector<Root> roots_of(const Numbers& a, std::size_t n) {
  constexpr int most = 40;
  const auto work = std::make_unique<tiltrotor::EigenWorkspace<double, most>>();
  const auto matrix = std::make_unique<tiltrotor::Matrix<double, most, most>>();
  tiltrotor::set_zero(*matrix);
  for (std::size_t i = 0; i < n * n; ++i) (*matrix)(static_cast<int>(i / n), static_cast<int>(i % n)) = a[i];
  tiltrotor::Eigenvalues<double, most> values{};
  CHECK(eigenvalues(*matrix, static_cast<int>(n), *work, values) == tiltrotor::Status::ok);
  std::vector<Root> roots;
  for (int k = 0; k < values.size; ++k)
    if (values.imag[k] >= 0) roots.emplace_back(values.real[k], values.imag[k]);
  return roots;
}

void check_modes(const std::string& arguments, const std::vector<Root>& expected) {
  const check::CsvText modes(run_tiltrotor("modes --format csv " + arguments).out);
  if (!CHECK_EQ(modes.rows.size(), expected.size())) return;
  for (std::size_t row = 0; row < modes.rows.size(); ++row) {
    const Root root(modes.number(row, "real"), modes.number(row, "imag"));
    double nearest = 1e9;
    for (const Root& other : expected) nearest = std::min(nearest, std::abs(root - other));
    if (!CHECK_LE(nearest, 1e-6 * std::abs(root))) NOTE(modes.text(row, "mode"));
  }
}

}  // namespace

TEST_OF_XV15(cli_feedback_closes_the_exported_model) {
  const ExportedModel open(kFlight), closed(kFlight + shipped());
  const Gains gains = shipped_gains();
  CHECK(gains.at("100", "pedal", "r") > 1);
  check_equal(closed.a, minus_fed_back(open, open.a, open.b, gains, "100"), open.n(), 1e-12);
  check_equal(closed.c, minus_fed_back(open, open.c, open.d, gains, "100"), open.n(), 1e-12);
  CHECK(closed.b == open.b && closed.d == open.d && closed.x0 == open.x0 && closed.u0 == open.u0);
  CHECK(closed.y0 == open.y0 && closed.controls == open.controls);
  // The same columns of other control sets, and the inputs of the law need not be among them.
  const ExportedModel blades(kFlight + shipped() + "--control-set blades");
  CHECK(blades.a == closed.a && blades.controls.size() == 7);
  CHECK(blades.b == ExportedModel(kFlight + "--control-set blades").b);
  // With a governor; there are columns of the throttles behind the inceptors.
  const std::string governed = kFlight + "--option governor=pi ";
  const ExportedModel wild(governed), tame(governed + shipped());
  check_equal(tame.a, minus_fed_back(wild, wild.a, wild.b, gains, "100"), wild.n(), 1e-12);
  CHECK(tame.b == wild.b && tame.controls == wild.controls);
}

TEST_OF_XV15(cli_feedback_modes_are_the_roots_of_the_closed_loop) {
  const Gains gains = shipped_gains();
  for (const char* const option :
       {"", "--option governor=pi ", "--option governor=ideal ", "--reduce rigid "}) {
    const std::string flight = kFlight + option;
    const ExportedModel open(flight);
    const std::vector<Root> slow = roots_of(open.a, open.n());
    // The reduced model is that of the closed loop: its own matrices say what its roots are.
    const bool reduced = std::string(option) == "--reduce rigid ";
    const ExportedModel model = reduced ? ExportedModel(flight + shipped()) : open;
    const Numbers a = reduced ? model.a : minus_fed_back(model, model.a, model.b, gains, "100");
    check_modes(flight + shipped(), roots_of(a, model.n()));
    const auto slowest = [](const std::vector<Root>& roots) {
      double real = -1e9;
      for (const Root& root : roots) real = std::max(real, root.real());
      return real;
    };
    CHECK_LT(slowest(roots_of(a, model.n())), slowest(slow) + 0.1);
  }
  CHECK_EQ(run_tiltrotor("modes --scas on " + kFlight + shipped()).exit_status, 0);
}

// y/u at s = 0 is that of the full model, whatever the order; near it the lag of rotors and wash is what is off by a
// surface, and to first order next to nothing.
TEST_OF_XV15(cli_linearize_reduced_outputs_are_those_of_slow_motion) {
  const ExportedModel full(kFlight), lagging(kFlight + "--reduce rigid"),
      steady(kFlight + "--reduce quasi_steady");
  CHECK(lagging.outputs == full.outputs && lagging.n() == 8 && steady.y0 == full.y0);
  for (std::size_t v = 0; v < 2; ++v) {
    for (const double s : {0.0, 0.01}) {
      const Numbers expected = transfer(full, s, v), first = transfer(lagging, s, v),
                    none = transfer(steady, s, v);
      for (const char* const name :
           {"airspeed", "climb_rate", "thrust_right", "torque_left", "gimbal_tilt_right"}) {
        const std::size_t y = ExportedModel::place(full.outputs, name);
        const double size = std::fabs(expected[y]), off = std::fabs(first[y] - expected[y]);
        if (s == 0) CHECK_LT(std::max(off, std::fabs(none[y] - expected[y])), 1e-10 * size);
        if (s > 0) CHECK_LT(off, 2e-3 * size);
        if (s > 0 && v == 1 && !CHECK_LT(off, 0.01 * std::fabs(none[y] - expected[y]))) NOTE(name);
      }
    }
  }
}

// With systems, whose states stay: the stick's response at 0.2 rad/s.
TEST_OF_XV15(cli_linearize_reduced_outputs_go_with_systems) {
  struct Kind {
    std::string systems;
    std::size_t states, inputs;
  };
  for (const Kind& kind : {Kind{"--scas on ", 12, 4}, Kind{"--option governor=pi ", 10, 6},
                           Kind{"--option governor=ideal " + shipped(), 8, 6}}) {
    const std::string flight = kFlight + kind.systems;
    const ExportedModel full(flight), lagging(flight + "--reduce rigid"),
        steady(flight + "--reduce quasi_steady");
    CHECK(lagging.outputs == full.outputs && lagging.controls == full.controls && steady.y0 == full.y0);
    CHECK_EQ(lagging.n(), kind.states);
    CHECK_EQ(full.m(), kind.inputs);
    const Numbers expected = transfer(full, 0.2, 1), first = transfer(lagging, 0.2, 1),
                  none = transfer(steady, 0.2, 1);
    for (const char* const name :
         {"airspeed", "climb_rate", "thrust_right", "torque_left", "gimbal_tilt_right"}) {
      const std::size_t y = ExportedModel::place(full.outputs, name);
      const double off = std::fabs(first[y] - expected[y]), of_none = std::fabs(none[y] - expected[y]);
      if (!CHECK_LT(off, 0.1 * of_none + 1e-9)) NOTE(kind.systems << " " << name << " of " << expected[y]);
      CHECK_LT(off, 0.01 * std::fabs(expected[y]) + 1e-9);
    }
  }
}

// A governor adds a lever's travel: its column of C is that of D, and forces hang on the rest as without.
TEST_OF_XV15(cli_linearize_governed_outputs_are_those_of_the_airframe) {
  const ExportedModel free(kFlight), governed(kFlight + "--option governor=pi");
  CHECK(governed.outputs == free.outputs && governed.c.size() == governed.outputs.size() * governed.n());
  const std::size_t governor = ExportedModel::place(governed.states, "governor");
  const std::size_t lever = ExportedModel::place(governed.controls, "collective");
  for (const char* const name : {"airspeed", "thrust_right", "thrust_left", "specific_force_z", "load_factor",
                                 "collective_right", "elevator"}) {
    const std::size_t y = ExportedModel::place(free.outputs, name);
    CHECK_NEAR(governed.y0[y], free.y0[y], 1e-9 * std::fabs(free.y0[y]) + 1e-9);
    double size = 1e-12;
    for (std::size_t j = 0; j < free.n(); ++j) size = std::max(size, std::fabs(free.c[y * free.n() + j]));
    for (std::size_t j = 0; j < free.n(); ++j)
      if (!CHECK_NEAR(governed.c[y * governed.n() + ExportedModel::place(governed.states, free.states[j])],
                      free.c[y * free.n() + j], 1e-9 * size))
        NOTE(name << " " << free.states[j]);
    CHECK_NEAR(governed.c[y * governed.n() + governor], governed.d[y * governed.m() + lever],
               1e-9 * std::fabs(governed.d[y * governed.m() + lever]));
    for (std::size_t j = 0; j < free.m(); ++j)
      CHECK_NEAR(governed.d[y * governed.m() + j], free.d[y * free.m() + j],
                 1e-9 * std::fabs(free.d[y * free.m() + j]));
  }
}

TEST_OF_XV15(cli_feedback_is_in_bode_and_qualities) {
  const check::ScratchFolder folder;
  for (const std::string& loop :
       {shipped(), law(folder, "law.csv", "input,r,specific_force_y\npedal,3,0.02\n")}) {
    const check::CsvText modes(run_tiltrotor("modes --format csv " + kFlight + loop).out);
    std::size_t dutch = 0;
    while (modes.text(dutch, "mode") != "dutch_roll") ++dutch;
    const Root root(modes.number(dutch, "real"), modes.number(dutch, "imag"));
    const check::CsvText roots(
        run_tiltrotor("bode --format csv --show roots --from pedal --to r " + kFlight + loop).out);
    double nearest = 1e9;
    for (std::size_t row = 0; row < roots.rows.size(); ++row)
      if (roots.text(row, "kind") == "pole")
        nearest =
            std::min(nearest, std::abs(root - Root(roots.number(row, "real"), roots.number(row, "imag"))));
    CHECK_LT(nearest, 1e-8);
    const check::CsvText levels(run_tiltrotor("qualities --format csv " + kFlight + loop).out);
    std::size_t row = 0;
    while (levels.text(row, "quantity") != "dutch_zeta") ++row;
    CHECK_NEAR(levels.number(row, "value"), modes.number(dutch, "damping_ratio"), 1e-9);
    CHECK_LT(0.25, levels.number(row, "value"));
  }
}

// Of y = C x + D u one input that reads one output: u = (v - k C x) / (1 + k D), throttles among the v that D sees: an ideal
// governor answers them at once, and the torque of a mast speeds its rotor up.
TEST_OF_XV15(cli_feedback_of_outputs_is_exact) {
  const check::ScratchFolder folder;
  struct Loop {
    const char *option, *reading, *gain;
    bool sees_throttle;
  };
  for (const Loop& loop : {Loop{"", "load_factor", "3", false}, Loop{"", "specific_force_x", "0.4", false},
                           Loop{"", "airspeed", "0.4", false}, Loop{"", "elevator", "0.4", false},
                           Loop{"--option governor=ideal ", "load_factor", "3", true},
                           Loop{"--option governor=ideal ", "specific_force_x", "0.4", true},
                           Loop{"--option governor=pi ", "load_factor", "3", false},
                           Loop{"--option governor=pi ", "torque_right", "1e-4", true}}) {
    const std::string flight = kFlight + loop.option;
    const ExportedModel open(flight);
    const std::size_t n = open.n(), m = open.m(), stick = ExportedModel::place(open.controls, "long_stick");
    const std::size_t y = ExportedModel::place(open.outputs, loop.reading);
    const double k = std::atof(loop.gain), share = 1 / (1 + k * open.d[y * m + stick]);
    CHECK_EQ(std::fabs(k * open.d[y * m + m - 1]) > 1e-3, loop.sees_throttle);
    const ExportedModel closed(
        flight +
        law(folder, "law.csv", std::string("input,") + loop.reading + "\nlong_stick," + loop.gain + "\n"));
    Numbers a = open.a, b = open.b, c = open.c, d = open.d;
    const auto close = [&](Numbers& rows, Numbers& columns) {
      for (std::size_t i = 0; i < rows.size() / n; ++i) {
        const double by_stick = columns[i * m + stick];
        for (std::size_t j = 0; j < n; ++j) rows[i * n + j] -= by_stick * share * k * open.c[y * n + j];
        for (std::size_t v = 0; v < m; ++v)
          columns[i * m + v] += by_stick * (v == stick ? share - 1 : -share * k * open.d[y * m + v]);
      }
    };
    close(a, b);
    close(c, d);
    check_equal(closed.a, a, n, 1e-11);
    check_equal(closed.b, b, m, 1e-11);
    check_equal(closed.c, c, n, 1e-11);
    check_equal(closed.d, d, m, 1e-11);
  }
}

TEST_OF_XV15(cli_feedback_gains_are_scheduled) {
  const check::ScratchFolder folder;
  const std::string head = "mast_deg,speed_mps,input,theta\n";
  const std::string schedule = law(folder, "schedule.csv",
                                   head +
                                       "# in any order\n60,60,long_stick,-2\n30,40,long_stick,-7\n\n"
                                       "30,50,long_stick,-5\n60,80,long_stick,-4\n");
  const auto constant = [&](const char* gain) {
    return law(folder, "constant.csv", "input,theta\nlong_stick," + std::string(gain) + "\n");
  };
  struct At {
    const char *flight, *gain;
  };
  for (const At& at :
       {At{"--mast 60 --speed 65", "-2.5"}, At{"--mast 60 --speed 55", "-2"},
        At{"--mast 75 --speed 90", "-4"}, At{"--mast 15 --speed 42", "-6.6"},
        At{"--mast 45 --speed 65", "-3.75"}, At{"--mast 40 --speed 45", "-4.666666666666667"}}) {
    const std::string flight = std::string(at.flight) + " --grid realtime ";
    const ExportedModel found(flight + schedule), expected(flight + constant(at.gain));
    check_equal(found.a, expected.a, found.n(), 1e-13);
  }
}

TEST(cli_bad_feedback_files_are_refused) {
  const check::ScratchFolder folder;
  const auto refused = [&](const std::string& text, const std::string& what, const std::string& how = "") {
    const check::ProgramResult r =
        run_tiltrotor("respond --mast 90 --speed 100 " + how + law(folder, "law.csv", text));
    const bool told = r.err.find("law.csv:" + what) != std::string::npos;
    if (!CHECK(r.exit_status == 2 && told && r.out.empty())) NOTE(r.err);
    CHECK_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1);
  };
  for (const char* const command : {"linearize --speed 40 ", "modes --speed 40 "})
    CHECK_EQ(run_tiltrotor(command + law(folder, "law.csv", "input,thta\nlong_stick,1\n")).exit_status, 2);
  refused("input,thta\nlong_stick,1\n",
          "1: column 'thta' is no reading of this model (did you mean theta?); choose ");
  refused("input,psi\nlong_stick,1\n", "1: column 'psi' is no reading");
  refused("input,b0_R\nlong_stick,1\n", "1: column 'b0_R' is no reading");
  refused("input,airspeed\npedal,1\n", "1: column 'airspeed' is no reading", "--option azimuth=individual ");
  refused("input,theta\nlong_stik,1\n",
          "2: 'long_stik' is no input (did you mean long_stick?); choose among ");
  refused("input,theta\ngust_w,1\n", "2: 'gust_w' is no input");
  refused("# gains\n\ninput,theta\nlong_stick,1e\n", "4: column theta: '1e' is not a number");
  refused("input,theta\nlong_stick,\n", "2: column theta: ");
  refused("input,theta\nlong_stick,inf\n", "2: column theta: ");
  refused("input,theta\npedal,1\npedal,2\n", "3: input pedal stands there twice");
  refused("mast_deg,input,theta\n30,pedal,1\n60,pedal,1\n60,lat_stick,1\n",
          "2: input lat_stick has rows elsewhere and none at mast 30 deg");
  refused("speed_mps,input,theta\n-1,pedal,1\n", "2: column speed_mps: -1 lies outside 0..");
  refused("mast_deg,input,theta\n120,pedal,1\n", "2: column mast_deg: 120 lies outside 0..");
  refused("input,theta,theta\npedal,1,2\n", "1: column 'theta' stands there twice");
  refused("theta\n1\n", "1: missing column input");
  refused("input\npedal\n", "1: no column of a reading");
  refused("input,theta\npedal,1,2\n", "2: 3 cells, but the header names 2 columns");
  refused("input,theta\n", " no gains below the header");
  refused("", "1: no header line");
  const check::ProgramResult none =
      run_tiltrotor("respond --speed 40 --feedback " + quoted(folder.path("none.csv")));
  CHECK(none.exit_status == 2 && none.err.find("none.csv: cannot be read") != std::string::npos);
}

// A loop that answers a control with exactly itself has no controls.
TEST_OF_XV15(cli_feedback_without_an_answer_is_a_failed_case) {
  const check::ScratchFolder folder;
  const ExportedModel open(kFlight);
  const std::size_t y = ExportedModel::place(open.outputs, "elevator"),
                    stick = ExportedModel::place(open.controls, "long_stick");
  char gain[40];
  std::snprintf(gain, sizeof gain, "%.17g", -1 / open.d[y * open.m() + stick]);
  const std::string loop = law(folder, "law.csv", "input,elevator\nlong_stick," + std::string(gain) + "\n");
  for (const char* const command : {"respond", "linearize", "modes"}) {
    const check::ProgramResult r = run_tiltrotor(command + (" " + kFlight) + loop);
    if (!CHECK_EQ(r.exit_status, 1)) NOTE(command << ": " << r.err);
  }
}

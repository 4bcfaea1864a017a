// Flights with a feedback law from a file. Expected: the linear flight by the exponential of the exported A, its roots by
// how a flight decays, and the same flight by other methods.
#include <algorithm>
#include <cmath>

#include "check.hpp"
#include "cli/exported_model.hpp"
#include "cli/feedback_law.hpp"
#include "cli/refused.hpp"

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

// exp(A t) x by Taylor series in short steps.
Numbers carried(const Numbers& a, Numbers x, double t) {
  const std::size_t n = x.size();
  constexpr int steps = 400, terms = 12;
  for (int step = 0; step < steps; ++step) {
    Numbers term = x;
    for (int k = 1; k <= terms; ++k) {
      Numbers next(n, 0.0);
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) next[i] += a[i * n + j] * term[j] * t / steps / k;
      for (std::size_t i = 0; i < n; ++i) x[i] += next[i];
      term = next;
    }
  }
  return x;
}

// States of a row that respond printed, from those of the trim, in the order of the model.
Numbers states_of(const check::CsvText& flight, std::size_t row, const ExportedModel& model) {
  static const std::vector<std::pair<std::string, std::string>> printed = {{"u", "u_mps"},
                                                                           {"v", "v_mps"},
                                                                           {"w", "w_mps"},
                                                                           {"p", "p_degps"},
                                                                           {"q", "q_degps"},
                                                                           {"r", "r_degps"},
                                                                           {"phi", "roll_deg"},
                                                                           {"theta", "pitch_deg"},
                                                                           {"eps", "downwash_deg"},
                                                                           {"b1c_R", "b1c_right_deg"},
                                                                           {"b1s_R", "b1s_right_deg"},
                                                                           {"db1c_R", "b1c_rate_right_degps"},
                                                                           {"db1s_R", "b1s_rate_right_degps"},
                                                                           {"b1c_L", "b1c_left_deg"},
                                                                           {"b1s_L", "b1s_left_deg"},
                                                                           {"db1c_L", "b1c_rate_left_degps"},
                                                                           {"db1s_L", "b1s_rate_left_degps"},
                                                                           {"n0_R", "n0_right"},
                                                                           {"nc_R", "nc_right"},
                                                                           {"ns_R", "ns_right"},
                                                                           {"n0_L", "n0_left"},
                                                                           {"nc_L", "nc_left"},
                                                                           {"ns_L", "ns_left"}};
  Numbers x(model.n());
  for (const auto& [state, column] : printed) {
    const bool in_degrees = column.find("_deg") != std::string::npos;
    const double unit = in_degrees ? std::acos(-1.0) / 180 : 1;
    x[ExportedModel::place(model.states, state)] =
        unit * (flight.number(row, column) - flight.number(0, column));
  }
  for (std::size_t i = 0; i < model.n(); ++i) {
    const double rpm = std::acos(-1.0) / 30, degree = std::acos(-1.0) / 180;
    if (model.states[i] == "rotor_speed")
      x[i] = rpm * (flight.number(row, "rotor_rpm") - flight.number(0, "rotor_rpm"));
    if (model.states[i] == "governor")
      x[i] = degree * (flight.number(row, "governor_deg") - flight.number(0, "governor_deg"));
  }
  return x;
}

// Twice as far from trim, four times as far from the linear flight.
void check_second_order(const std::string& loop) {
  const ExportedModel closed(kFlight + loop);
  double off[2] = {};
  for (int twice = 0; twice < 2; ++twice) {
    const std::string size = twice == 1 ? "0.4" : "0.2";
    const check::CsvText flight(run_tiltrotor("respond --format csv --duration 1 --dt 0.02 " + kFlight +
                                              loop + "--input gust_w=" + size +
                                              "@0..0.2 --input pedal=" + size + "@0..0.2")
                                    .out);
    if (!CHECK_EQ(flight.rows.size(), 51u)) return;
    const Numbers expected = carried(closed.a, states_of(flight, 10, closed), 0.8);
    const Numbers found = states_of(flight, 50, closed);
    double moved = 0;
    for (const char* const state : {"u", "w", "q", "theta", "v", "p", "phi", "r"}) {
      const std::size_t i = ExportedModel::place(closed.states, state);
      off[twice] = std::max(off[twice], std::fabs(found[i] - expected[i]));
      moved = std::max(moved, std::fabs(found[i]));
    }
    CHECK_LT(off[twice], 0.02 * moved);
  }
  if (!CHECK_NEAR(off[1] / off[0], 4, 0.8)) NOTE(loop);
}

std::string outputs_fed_back(const check::ScratchFolder& folder) {
  return law(folder, "outputs.csv",
             "input,q,theta,load_factor,power_right\nlong_stick,-9,-8,0.5,0\ncollective,0,0,0.05,1e-7\n");
}

}  // namespace

TEST_OF_XV15(cli_feedback_flight_is_that_of_the_model_to_second_order) {
  const check::ScratchFolder folder;
  check_second_order(shipped());
  check_second_order(outputs_fed_back(folder));
}

TEST_OF_XV15(cli_feedback_of_a_governed_flight_is_that_of_the_model_to_second_order) {
  const check::ScratchFolder folder;
  for (const char* const governor : {"pi ", "ideal "})
    check_second_order(outputs_fed_back(folder) + "--option governor=" + governor);
}

// Long after a kick of the pedal the bank is left to the slowest lateral root.
TEST_OF_XV15(cli_feedback_flight_decays_with_the_slowest_root) {
  const check::CsvText flight(
      run_tiltrotor("respond --format csv --duration 8 --dt 0.1 --columns time_s,roll_deg " + kFlight +
                    shipped() + "--input pedal=0.5@0..0.5")
          .out);
  const check::CsvText modes(run_tiltrotor("modes --format csv " + kFlight + shipped()).out);
  double slowest = -1e9;
  for (std::size_t row = 0; row < modes.rows.size(); ++row)
    if (modes.text(row, "axis") == "lateral") slowest = std::max(slowest, modes.number(row, "real"));
  const double decay = std::log(flight.number(80, "roll_deg") / flight.number(70, "roll_deg"));
  CHECK_NEAR(decay, slowest, 0.005 * std::fabs(slowest));
}

TEST_OF_XV15(cli_feedback_is_flown_alike_by_every_method) {
  const check::ScratchFolder folder;
  const std::string loop = law(folder, "law.csv", "input,theta,load_factor\nlong_stick,-8,0.5\n");
  const auto end = [&](const std::string& how) {
    const check::CsvText flight(run_tiltrotor("respond --format csv --duration 0.3 " + kFlight + loop + how +
                                              " --input gust_w=2@0.1..0.2 --columns pitch_deg,w_mps")
                                    .out);
    return Numbers{flight.number(flight.rows.size() - 1, "pitch_deg"),
                   flight.number(flight.rows.size() - 1, "w_mps")};
  };
  const Numbers best = end("--dt 0.004");
  for (const char* const how : {"--dt 0.1", "--dt 0.005 --method rk3", "--dt 0.005 --method rodas3",
                                "--dt 0.005 --method exponential"}) {
    const Numbers other = end(how);
    if (!CHECK(std::fabs(other[0] - best[0]) < 3e-4 && std::fabs(other[1] - best[1]) < 3e-4))
      NOTE(how << " " << other[0] - best[0] << " " << other[1] - best[1]);
  }
}

// A loop that is faster than the aircraft needs no shorter steps of the user: they are cut.
TEST_OF_XV15(cli_feedback_of_large_gains_is_stable_in_any_step) {
  const check::ScratchFolder folder;
  const std::string loop = law(folder, "law.csv", "input,q,theta\nlong_stick,-3000,-3000\n");
  const check::CsvText modes(run_tiltrotor("modes --format csv " + kFlight + loop).out);
  double fastest = 0;
  for (std::size_t row = 0; row < modes.rows.size(); ++row)
    fastest = std::max(fastest, -modes.number(row, "real"));
  CHECK_LT(2000, fastest);
  for (const char* const governor : {"", "--option governor=pi "}) {
    const check::CsvText flight(run_tiltrotor("respond --format csv --duration 0.4 --dt 0.1 " + kFlight +
                                              loop + governor + "--input gust_w=2@0 --columns q_degps,w_mps")
                                    .out);
    if (!CHECK_EQ(flight.rows.size(), 5u)) return;
    CHECK_LT(std::fabs(flight.number(4, "q_degps")), 0.1);
    CHECK_LT(0.1, std::fabs(flight.number(4, "w_mps") - flight.number(0, "w_mps")));
  }
}

// One that would cut a step into hundreds of parts is refused, in `fly` too, where actuators slow it down.
TEST_OF_XV15(cli_bad_feedback_of_endless_cost_is_refused) {
  const check::ScratchFolder folder;
  const std::string loop = law(folder, "law.csv", "input,q\nlong_stick,-1e9\n");
  const std::string flight = "respond --duration 1 --dt 0.01 " + kFlight + loop;
  check::check_refused(flight, "law.csv: a root of the closed loop is ");
  // 256 parts of 2.61: where rk4 is stable (limits of its stability function: test_stable_step.cpp).
  check::check_refused(flight,
                       " 1/s, outside 0..6.68e+04 1/s, where a step of 0.01 s is cut into at most 256 parts");
  const std::string script = quoted(folder.write("script.txt", "0 scas off\n1 end\n"));
  check::check_refused("fly --script " + script + " " + kFlight + loop,
                       "law.csv: a root of the closed loop is ");
}

// Beside the pilot: A of the whole vehicle at its start, and a kick that dies sooner.
TEST_OF_XV15(cli_feedback_acts_in_a_flight_by_script) {
  const check::ScratchFolder folder;
  const std::string script =
      quoted(folder.write("flight.txt", "0 scas off\n0 release all\n0.1 step pedal 0.5 0.5\n2 end\n"));
  double bank[2] = {};
  std::vector<check::CsvText> a, b;
  for (const std::string& loop : {std::string(), shipped()}) {
    const std::string to = folder.path(loop.empty() ? "open" : "closed");
    const check::ProgramResult run =
        run_tiltrotor("fly --script " + script +
                      " --mast 90 --speed 100 --every 2 --format csv --columns roll_deg --modes-every 2 "
                      "--matrices " +
                      quoted(to) + " " + loop);
    if (!CHECK_EQ(run.exit_status, 0)) NOTE(run.err);
    bank[loop.empty() ? 0 : 1] = std::fabs(check::CsvText(run.out).number(1, "roll_deg"));
    a.emplace_back(folder.read((loop.empty() ? "open" : "closed") + std::string("/a.csv")));
    b.emplace_back(folder.read((loop.empty() ? "open" : "closed") + std::string("/b.csv")));
  }
  CHECK_LT(bank[1], 0.5 * bank[0]);
  const Gains gains = shipped_gains();
  for (std::size_t row = 0; row < a[0].rows.size() && a[0].text(row, "time_s") == "0"; ++row)
    for (const char* const state : {"u", "q", "theta", "v", "p", "r", "eps"}) {
      double expected = a[0].number(row, state);
      for (const char* const input : {"collective", "long_stick", "lat_stick", "pedal"})
        expected -= b[0].number(row, input) * gains.at("100", input, state);
      CHECK_NEAR(a[1].number(row, state), expected, 1e-9 * (1 + std::fabs(expected)));
    }
  const check::ProgramResult ground = run_tiltrotor("fly --script " + script + " " + shipped());
  CHECK_EQ(ground.exit_status, 2);
  CHECK(ground.err.find("fly: --feedback: counts from the trim") != std::string::npos);
}

TEST_OF_XV15(cli_feedback_goes_along_with_modes_and_matrices) {
  const check::ScratchFolder folder;
  const std::string end =
      "respond --format csv --duration 0.2 --dt 0.1 --modes-every 0.2 " + kFlight + shipped();
  const check::CsvText flight(run_tiltrotor(end + "--matrices " + quoted(folder.path("m"))).out);
  const check::CsvText modes(run_tiltrotor("modes --format csv " + kFlight + shipped()).out);
  CHECK_EQ(flight.text(0, "mode1"), modes.text(0, "mode"));
  CHECK_NEAR(flight.number(0, "mode1_real"), modes.number(0, "real"), 1e-9);
  const check::CsvText a(folder.read("m/a.csv"));
  const ExportedModel closed(kFlight + shipped());
  for (std::size_t j = 0; j < closed.n(); ++j)
    CHECK_NEAR(a.number(2, closed.states[j]), closed.a[2 * closed.n() + j], 1e-9);
  // Masts that move, with a governor: gains follow.
  const check::ProgramResult moving = run_tiltrotor(
      "respond --format csv --duration 0.3 --dt 0.1 --mast 80 --speed 80 --option governor=ideal " +
      shipped() + "--input mast=2deg@0.05..0.5 --modes-every 0.1");
  CHECK_EQ(moving.exit_status, 0);
}

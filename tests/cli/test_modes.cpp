// Names of modes belong to the matrix alone, whatever was looked at before; branches follow a mode along a
// sweep and are the same in shards.
// Expected: the same matrix looked at alone, the C interface.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"
#include "tiltrotor/analysis/instances.hpp"
#include "tiltrotor/tiltrotor.h"

using namespace tiltrotor;
using check::CsvText;
using check::run_tiltrotor;

namespace {

// What is said about a flight: axis, name and root of every mode, in order.
using Roots = std::vector<std::string>;

std::map<double, Roots> roots_by_speed(const std::string& mast, const std::string& speeds) {
  const CsvText rows(
      run_tiltrotor("modes --grid realtime --format csv --mast " + mast + " --speed " + speeds).out);
  std::map<double, Roots> all;
  for (std::size_t i = 0; i < rows.rows.size(); ++i) {
    all[rows.number(i, "speed_mps")].push_back(rows.text(i, "axis") + " " + rows.text(i, "mode") + " " +
                                               rows.text(i, "real") + " " + rows.text(i, "imag"));
  }
  return all;
}

// The names that belong to the matrix of a file with a row a state, each with the name of its state before
// it.
std::vector<Mode<double>> modes_of_matrix(const CsvText& file, const std::string& time) {
  static LinearModel<double> model;
  static ModesWorkspace<double> work;
  static ModeSet<double> set;
  model = {};
  for (std::size_t i = 0; i < file.rows.size(); ++i) {
    if (file.text(i, "time_s") != time) continue;
    for (int k = 0; k < state_count; ++k)
      if (file.text(i, "row") == kStateVariables[k].name) model.state[model.states] = k;
    for (std::size_t j = 2; j < file.columns.size(); ++j)
      model.a(model.states, static_cast<int>(j) - 2) = file.number(i, file.columns[j]);
    ++model.states;
  }
  CHECK(modes(model, work, set) == Status::ok);
  return {set.mode, set.mode + set.count};
}

std::string content(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

struct Point {
  double real, imag;
  bool is_pair() const { return imag > 0; }
};

}  // namespace

TEST(cli_modes_names_do_not_depend_on_the_sweep) {
  for (const std::string mast : {"0", "45", "80"}) {
    const std::map<double, Roots> fine = roots_by_speed(mast, "0:1:100");
    for (const std::string speeds : {"0:2.5:100", "0:10:100", "100:-10:0", "30,100,10,0,70,45,20,50", "45"}) {
      std::size_t common = 0;
      for (const auto& [speed, roots] : roots_by_speed(mast, speeds)) {
        if (fine.count(speed) == 0) continue;
        ++common;
        if (!CHECK(roots == fine.at(speed))) NOTE("mast " << mast << ", " << speeds << ": " << speed);
      }
      CHECK(common > 0);
    }
  }
  // The names of oscillations belong to pairs.
  for (const auto& [speed, roots] : roots_by_speed("45", "0:5:100")) {
    for (const std::string& root : roots) {
      const bool is_real = root.substr(root.rfind(' ') + 1) == "0";
      for (const char* name : {" dutch_roll", " phugoid", " short_period", " roll_spiral"}) {
        if (root.find(name) != std::string::npos && !CHECK(!is_real)) NOTE(speed << ": " << root);
      }
    }
  }
}

// Along a sweep a branch has one kind of root, moves little, and a number stands for one branch only.
TEST(cli_modes_branches_are_followed) {
  const CsvText rows(run_tiltrotor("modes --grid realtime --mast 90 --speed 40:2:120 --format csv").out);
  std::map<double, Point> last;
  std::set<double> ended;
  std::set<double> here;
  double speed = -1;
  int longest = 0;
  std::map<double, int> length;
  for (std::size_t i = 0; i < rows.rows.size(); ++i) {
    if (rows.number(i, "speed_mps") != speed) {
      for (const auto& [branch, point] : last)
        if (speed >= 0 && here.count(branch) == 0) ended.insert(branch);
      here.clear();
      speed = rows.number(i, "speed_mps");
    }
    if (rows.text(i, "mode").empty()) {
      CHECK_EQ(rows.text(i, "branch"), "");  // no trim
      continue;
    }
    const double branch = rows.number(i, "branch");
    CHECK(here.insert(branch).second && ended.count(branch) == 0);
    const Point now{rows.number(i, "real"), rows.number(i, "imag")};
    if (last.count(branch) > 0) {
      const Point before = last[branch];
      CHECK_EQ(now.is_pair(), before.is_pair());
      CHECK_LT(std::hypot(now.real - before.real, now.imag - before.imag),
               0.1 + 0.25 * std::hypot(before.real, before.imag));
    }
    last[branch] = now;
    longest = std::max(longest, ++length[branch]);
  }
  CHECK(longest > 20);
}

// Wherever a sweep is cut: within it, at a flight without a trim, between mast angles.
TEST(cli_modes_branches_join_over_shards) {
  for (const std::string sweep :
       {"modes --grid realtime --mast 45,90 --speed 46:4:74 --format csv ",
        "modes --grid realtime --mast 0:15:90 --speed 50 --format csv ",
        "modes --grid realtime --mast 30 --speed 0:5:30,60 --altitude 0,2000 --format csv "}) {
    const std::string whole = run_tiltrotor(sweep).out;
    for (const int parts : {2, 5}) {
      std::string joined;
      for (int k = 1; k <= parts; ++k)
        joined += run_tiltrotor(sweep + "--shard " + std::to_string(k) + "/" + std::to_string(parts)).out;
      if (!CHECK(joined == whole)) NOTE(sweep << parts);
    }
  }
}

// With an input now or later: at every time the names are those of the matrix of that time.
TEST(cli_respond_names_modes_by_the_matrix_of_the_moment) {
  const check::ScratchFolder folder;
  for (const std::string start : {"0", "0.5"}) {
    const std::string matrices = folder.path("matrices" + start);
    const CsvText flight(run_tiltrotor("respond --grid realtime --mast 30 --speed 30 --dt 0.01 --duration 1 "
                                       "--modes-every 0.25 --format csv --input collective=2deg@" +
                                       start + " --input pedal=1in@" + start + " --matrices " + matrices)
                             .out);
    const CsvText file(content(matrices + "/a.csv"));
    for (std::size_t row = 0; row < flight.rows.size(); row += 25) {
      std::size_t shown = 0;
      for (const Mode<double>& mode : modes_of_matrix(file, flight.text(row, "time_s"))) {
        if (mode.axis == ModeAxis::rotor) continue;
        const std::string column = "mode" + std::to_string(++shown);
        CHECK_EQ(flight.text(row, column), std::string(mode.name));
        CHECK_NEAR(flight.number(row, column + "_real"), mode.real, 1e-9);
        CHECK(flight.number(row, column + "_branch") >= 1);
      }
      CHECK(shown > 5);
    }
  }
}

// The C interface gives the same names to the same flight.
TEST(cli_modes_are_those_of_the_c_interface) {
  static tr_sim sim;
  static tr_work work;
  static tr_real a[TR_MAX_LINEAR_STATES * TR_MAX_LINEAR_STATES];
  static tr_mode found[TR_MAX_LINEAR_STATES];
  if (sizeof(tr_real) < sizeof(double)) return;
  for (const int mast : {0, 45}) {
    const CsvText rows(run_tiltrotor("modes --grid realtime --format csv --mast " + std::to_string(mast) +
                                     " --speed 20:5:50")
                           .out);
    std::size_t row = 0;
    for (int speed = 20; speed <= 50; speed += 5) {
      tr_setup setup;
      CHECK_EQ(tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0), mast), TR_OK);
      CHECK_EQ(tr_init(&sim, TR_API_VERSION, &setup), TR_OK);
      const tr_flight flight = {tr_real(speed), 0, 0, 0};
      tr_linear_shape shape;
      std::size_t count = 0;
      (void)tr_trim(&sim, &work, &flight, nullptr);
      CHECK_EQ(tr_linearize(&sim, &work, TR_INCEPTORS, &shape, a, std::size(a), nullptr, 0), TR_OK);
      CHECK_EQ(tr_modes(&work, &shape, a, std::size(a), found, TR_MAX_LINEAR_STATES, &count), TR_OK);
      for (std::size_t i = 0; i < count && row < rows.rows.size(); ++i, ++row) {
        CHECK_EQ(rows.text(row, "mode"), std::string(found[i].name));
        CHECK_NEAR(rows.number(row, "real"), double(found[i].real), 1e-6);
      }
    }
    CHECK_EQ(row, rows.rows.size());
  }
}

// Isolated rotors in descent: vortex ring, turbulent wake and windmill; by momentum theory alone the windmill
// where there is one, otherwise the truth.
// Expected: a search of every inflow for roots of the same balance; momentum theory for what they mean; energy.
#include <cfenv>
#include <cmath>
#include <vector>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "rotor_stand.hpp"
#include "run_program.hpp"
#include "this_aircraft.hpp"

using check::CsvText;
using check::run_tiltrotor;
using namespace tiltrotor;
using rotor_stand::flow;

namespace {

Options realtime() {
  Options options;
  options.grid = BladeGrid::realtime;
  return options;
}

Options by_momentum() {
  Options options = realtime();
  options.descent_inflow = DescentInflow::momentum;
  return options;
}

double hover_speed(double thrust, const Configuration<double>& c) {
  return std::sqrt(std::fabs(thrust) /
                   (2 * c.air.density * kPi<double> * std::pow(c.aircraft->rotor.radius, 2)));
}

// In axial flow the balance of the mean inflow is the whole problem. Its roots on a grid of inflows, least
// first: m/s, where the rate changes sign.
std::vector<double> roots(const Configuration<double>& c, double axial, double collective_deg) {
  static RotorWorkspace<double> work;
  std::vector<double> found;
  double before = 0;
  const double step = 0.1;  // m/s
  for (double v = -10; v < 90; v += step) {
    RotorInput<double> in{};
    RotorResponse<double> out;
    in.velocity_a = {0, 0, axial};
    in.collective = collective_deg * kRadPerDeg<double>;
    in.coning.angle = c.coning;
    in.state.lambda_0 = v / c.tip_speed;
    rotor_response(c, rotor_conditions(c, right), in, c.azimuth, work, out);
    if (before * out.inflow.lambda_0 < 0) found.push_back(v - step / 2);
    before = out.inflow.lambda_0;
  }
  return found;
}

}  // namespace

// The solver against a search of the whole range of inflow. At 40 m/s the blades balance a windmill up to 4
// deg; from 6 deg on they give more thrust than its wake can carry, and the one root left is no flow that
// exists: 6 m/s down through a rotor that descends at 40, its wake faster still, against the air.
TEST(isolated_rotor_finds_the_windmill) {
  rotor_stand::Stand stand(0, by_momentum());
  const Configuration<double>& c = stand.configuration;
  int windmills = 0, none = 0, two_stable = 0;
  const double scale = this_aircraft::speed();
  for (const double speed : {-30.0, -36.0, -40.0, -44.0, -50.0, -60.0}) {
    const double axial = scale * speed;
    for (double collective = -4; collective <= 12; collective += 2) {
      const std::vector<double> at = roots(c, axial, collective);
      if (!CHECK(!at.empty())) continue;
      const Status status = stand.run(flow(collective, axial));
      const double v = stand.rotor.input.state.lambda_0 * c.tip_speed;
      const double h = hover_speed(stand.rotor.figures.thrust, c);
      const bool windmill = at[0] < -0.6 * axial;  // half in theory, and less than twice the other
      windmills += windmill;
      none += !windmill;
      two_stable += at.size() >= 3;
      if (windmill) {
        CHECK_NEAR(v, at[0], 0.1);
        if (std::fabs(axial / h + 2) > 0.005)
          CHECK(status == (-axial > 2 * h ? Status::ok : Status::vortex_ring));
      } else {
        if (!CHECK(status == Status::vortex_ring && stand.rotor.momentum != MomentumRange::holds))
          NOTE(axial << " m/s, " << collective << " deg: " << status_word(status) << ", " << v);
        CHECK_EQ(at.size(), std::size_t{1});
      }
      if (status != Status::ok) continue;
      CHECK_NEAR(v, -axial / 2 - std::sqrt(axial * axial / 4 - h * h), 0.1 * h);
    }
  }
  CHECK(windmills > 20 && none > 10 && two_stable > 20);
  CHECK(stand.run(flow(4, -40 * scale)) == Status::ok);
  CHECK_NEAR(stand.rotor.input.state.lambda_0 * c.tip_speed, roots(c, -40 * scale, 4).at(0), 0.1);
  CHECK(stand.run(flow(8, -40 * scale)) == Status::vortex_ring);
  CHECK(stand.rotor.momentum == MomentumRange::other_branch);
}

// Collective down, rotor pulled up the shaft: the same with the signs turned, and never ok on the other
// branch.
TEST(isolated_rotor_pushed_against_its_thrust_says_so) {
  rotor_stand::Stand stand(0, by_momentum());
  const Configuration<double>& c = stand.configuration;
  int beyond = 0, windmills = 0;
  for (double axial = 10; axial <= 60; axial += 10) {
    for (double collective = -24; collective <= 0; collective += 3) {
      const Status status = stand.run(flow(collective, axial));
      if (status == Status::vortex_ring) ++beyond;
      if (status != Status::ok || stand.rotor.figures.thrust > 0) continue;
      const double h = hover_speed(stand.rotor.figures.thrust, c);
      const double v = -stand.rotor.input.state.lambda_0 * c.tip_speed;
      CHECK(axial < 0.45 * h || (axial > 2 * h && v < axial / 2));
      windmills += axial > 2 * h;
    }
  }
  CHECK(beyond > 5 && windmills > 3);
}

// What is printed without an equilibrium that could be flown is empty and explained.
TEST(cli_rotor_without_a_windmill_prints_no_figures) {
  const std::string slow = this_aircraft::shortest(this_aircraft::given("--speed-axial", -10));
  const std::string fast = this_aircraft::shortest(this_aircraft::given("--speed-axial", -40));
  const auto run = run_tiltrotor("rotor --collective75 4,8 --speed-axial " + slow + "," + fast +
                                 " --grid realtime --option descent_inflow=momentum");
  CHECK_EQ(run.exit_status, 1);
  const CsvText csv(run.out);
  const char* status[] = {"vortex_ring", "vortex_ring", "ok", "vortex_ring"};
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK_EQ(csv.text(i, "status"), std::string(status[i]));
    for (const char* column : {"n0", "thrust_n", "power_kw", "ct"})
      CHECK_EQ(csv.text(i, column).empty(), std::string(status[i]) != "ok");
    CHECK(!csv.text(i, "axial_ratio").empty());
  }
  CHECK(run.err.find("collective 8 deg, axial " + fast + " m/s: no windmill found") != std::string::npos);
  CHECK(run.err.find("collective 8 deg, axial " + slow + " m/s: the rotor descends in its own wake") !=
        std::string::npos);
}

// In axial flow the balance of the mean inflow is the whole problem: it has one root at any pitch and descent,
// which the solver finds; the status is that of the boundaries -0.45 and -1.50 v_h.
TEST(isolated_rotor_descends_on_one_branch) {
  rotor_stand::Stand stand(0, realtime());
  const Configuration<double>& c = stand.configuration;
  int in_ring = 0, windmills = 0;
  for (double axial = 12; axial >= -60; axial -= 4) {
    for (double collective = -4; collective <= 12; collective += 2) {
      const Status status = stand.run(flow(collective, axial));
      const double thrust = stand.rotor.figures.thrust, h = hover_speed(thrust, c);
      const double v = stand.rotor.input.state.lambda_0 * c.tip_speed;
      const std::vector<double> at = roots(c, axial, collective);
      if (thrust < 100) continue;  // no thrust, no wake
      if (!CHECK_EQ(at.size(), std::size_t{1})) {
        NOTE(axial << " m/s, " << collective << " deg");
        continue;
      }
      CHECK_NEAR(v, at[0], 0.1);
      const double descent = -axial / h;
      const bool ring = descent > 0.45 && descent < 1.5;
      if (!CHECK(status == (ring ? Status::vortex_ring : Status::ok)))
        NOTE(axial << " m/s, " << collective << " deg: " << status_word(status));
      in_ring += ring;
      windmills += descent > 2.3;
      if (descent > 2.3) CHECK_NEAR(v, -axial / 2 - std::sqrt(axial * axial / 4 - h * h), 0.01 * h);
    }
  }
  CHECK(in_ring > 10 && windmills > 10);
}

// At constant pitch a rotor that sinks faster gains thrust (heave is damped), but in vortex ring it loses
// thrust; momentum theory knows no loss.
TEST(isolated_rotor_heave_damping_is_negative_in_vortex_ring) {
  rotor_stand::Stand stand(0, realtime()), momentum(0, by_momentum());
  const auto damping = [](rotor_stand::Stand& on, double descent) {
    (void)on.run(flow(8, -descent - 0.5));
    const double faster = on.rotor.figures.thrust;
    (void)on.run(flow(8, -descent + 0.5));
    return faster - on.rotor.figures.thrust;
  };
  for (const double descent : {-10.0, -5.0, 0.0, 3.0, 22.0, 26.0, 30.0}) {
    if (!CHECK(damping(stand, descent) > 0)) NOTE(descent << " m/s");
  }
  for (const double descent : {8.0, 10.0, 12.0, 14.0, 16.0}) {
    if (!CHECK(damping(stand, descent) < 0)) NOTE(descent << " m/s");
    CHECK(damping(momentum, descent) > 0);
  }
}

// Autorotation: power passes through zero while the rotor still draws a little air up through the disk, as much
// as its profile power needs: between the descent without through-flow, 1.89 v_h, and the windmill's, 2.3.
TEST(isolated_rotor_autorotates) {
  rotor_stand::Stand stand(0, realtime());
  const Configuration<double>& c = stand.configuration;
  for (const double collective : {0.0, 2.0, 4.0}) {
    double low = 10, high = 45;  // m/s: power given, power taken
    for (int k = 0; k < 40; ++k) {
      const double middle = 0.5 * (low + high);
      CHECK(stand.run(flow(collective, -middle)) != Status::not_converged);
      (stand.rotor.figures.power > 0 ? low : high) = middle;
    }
    CHECK(stand.run(flow(collective, -low)) == Status::ok);
    const double descent = low / hover_speed(stand.rotor.figures.thrust, c);
    NOTE(collective << " deg: autorotation at " << low << " m/s, " << descent << " v_h");
    CHECK(descent > 1.89 && descent < 2.3);
  }
}

// The figures of vortex ring are printed, flagged and explained.
TEST(cli_rotor_in_vortex_ring_prints_figures_and_says_so) {
  const auto run = run_tiltrotor("rotor --collective75 8 --speed-axial -3,-12,-40 --grid realtime");
  CHECK_EQ(run.exit_status, 1);
  const CsvText csv(run.out);
  const char* status[] = {"ok", "vortex_ring", "ok"};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK_EQ(csv.text(i, "status"), std::string(status[i]));
    for (const char* column : {"n0", "thrust_n", "power_kw", "ct"}) CHECK(!csv.text(i, column).empty());
  }
  CHECK(run.err.find("axial -12 m/s: the rotor descends in its own wake") != std::string::npos);
}

// Over the whole range of flow, pitch and cyclic, found or not.
TEST(isolated_rotor_raises_no_floating_point_exception) {
  std::uint32_t seed = 77;
  const auto random = [&seed](double low, double high) {
    seed = seed * 1664525u + 1013904223u;
    return low + (high - low) * seed / 4294967296.0;
  };
  const double most = aircraft_data<double>().limits.speed;
  for (const double mast_deg : {0.0, 90.0}) {
    rotor_stand::Stand stand(mast_deg, realtime());
    for (int k = 0; k < 500; ++k) {
      const double part = k % 4 == 0 ? 1 : 0.3;
      RotorFlow<double> f = flow(random(-90, 90) * part, random(-most, most) * part,
                                 k % 3 == 0 ? 0 : random(-most, most) * part);
      if (k % 5 == 0) f.cyclic = CyclicUse::cancels_tilt;
      if (k % 5 == 1) f.long_cyclic = random(-0.5, 0.5);
      std::feclearexcept(FE_ALL_EXCEPT);
      const Status status = stand.run(f);
      const int raised = std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
      if (!CHECK_EQ(raised, 0)) NOTE("case " << k << ": " << status_word(status));
      CHECK(status != Status::not_finite && status != Status::out_of_range);
    }
  }
}

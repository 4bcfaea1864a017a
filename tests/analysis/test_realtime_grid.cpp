// The real-time blade grid against a fine one (80 x 48 stations) at a few trimmed flights: thrust and torque
// at the same state, trim, and the eigenvalues of the rigid-body model. bench/grid_convergence.cpp does the
// same over the trim set.
#include <cmath>
#include <memory>

#include "check.hpp"
#include "tiltrotor/analysis/instances.hpp"
#include "tiltrotor/math/algebra/eigen.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

namespace {

using namespace tiltrotor;

struct Workspaces {
  TrimWorkspace<double> trim;
  LinearizationWorkspace<double> linearization;
  ResidualisationWorkspace<double> residualisation;
  EigenWorkspace<double, kMaxLinearStates> eigen;
  LinearModel<double> full, reduced;
  Evaluation<double> evaluation;
  TrimResult<double> fine, realtime;
};

Configuration<double> configuration(double mast_deg, bool realtime) {
  FlightSetup<double> setup = flight_setup(aircraft_data<double>(), mast_deg);
  setup.options.grid = realtime ? BladeGrid::realtime : BladeGrid::specification;
  if (!realtime) {
    setup.options.grid_refinement = 4;
    setup.options.azimuth_stations = 48;
  }
  Configuration<double> c;
  CHECK(prepare(aircraft_data<double>(), setup, c) == Status::ok);
  return c;
}

Eigenvalues<double, kMaxLinearStates> rigid_eigenvalues(const Configuration<double>& c,
                                                        const TrimResult<double>& at, Workspaces& work) {
  Eigenvalues<double, kMaxLinearStates> values{};
  CHECK(linearize(c, at.state, at.controls, kInceptors, work.linearization, work.full) == Status::ok);
  CHECK(residualise(work.full, work.residualisation, work.reduced) == Status::ok);
  CHECK(eigenvalues(work.reduced.a, kRigidStates, work.eigen, values) == Status::ok);
  return values;
}

TEST_OF_XV15(realtime_grid_keeps_its_bounds) {
  const auto work = std::make_unique<Workspaces>();
  constexpr double flights[][2] = {{0, 0},   {0, 35},  {30, 40},
                                   {60, 60}, {75, 80}, {90, 100}};  // mast deg, m/s
  for (const auto& [mast, speed] : flights) {
    const Configuration<double> fine = configuration(mast, false);
    const Configuration<double> realtime = configuration(mast, true);
    CHECK_LE(4 * realtime.blade.count * realtime.azimuth.count, 20 * 24 * 4);
    SteadyFlight<double> flight{};
    flight.speed = speed;
    CHECK(is_trimmed(trim(fine, flight, work->trim, work->fine)));
    work->realtime = work->fine;
    CHECK(is_trimmed(trim_from(realtime, flight, work->trim, work->realtime)));
    CHECK_NEAR(work->realtime.state.pitch, work->fine.state.pitch, 0.02 * kRadPerDeg<double>);
    CHECK_NEAR(work->realtime.collective_root, work->fine.collective_root, 0.02 * kRadPerDeg<double>);

    const double half_weight = fine.setup.mass * kGravity<double> / 2;
    evaluate_aircraft(fine, work->fine.state, work->fine.controls, work->evaluation);
    const MastLoads<double> exact = work->evaluation.rotor[right].loads;
    evaluate_aircraft(realtime, work->fine.state, work->fine.controls, work->evaluation);
    const MastLoads<double> found = work->evaluation.rotor[right].loads;
    CHECK_NEAR(found.force_a.z, exact.force_a.z, 1e-3 * half_weight);
    CHECK_REL(found.torque, exact.torque, 6e-3);

    const auto a = rigid_eigenvalues(fine, work->fine, *work);
    const auto b = rigid_eigenvalues(realtime, work->realtime, *work);
    double worst = 0;
    for (int i = 0; i < kRigidStates; ++i) {
      double nearest = 1e9;
      for (int j = 0; j < kRigidStates; ++j)
        nearest = std::fmin(nearest, std::hypot(a.real[i] - b.real[j], a.imag[i] - b.imag[j]));
      worst = std::fmax(worst, nearest / std::fmax(std::hypot(a.real[i], a.imag[i]), 0.05));
    }
    CHECK_LE(worst, 0.02);
    NOTE("mast " << mast << ", " << speed << " m/s: thrust "
                 << 100 * (found.force_a.z - exact.force_a.z) / half_weight
                 << " % of half the weight, worst rigid-body eigenvalue " << 100 * worst << " %");
  }
}

}  // namespace

// The same analyses with numerical differences and in single precision.
// Expected: double precision and exact derivatives; tolerances by the digits of a float.
#include <algorithm>

#include "analysis_case.hpp"

using namespace analysis_case;

// Both policies solve the same equations to the same tolerance: same trim, the same Newton steps give or take
// one.
TEST(trim_automatic_and_numerical_agree) {
  static TrimWorkspace<double, AutoDiff> automatic;
  static TrimWorkspace<double, NumDiff> numerical;
  double worst = 0;
  for (double mast : {0.0, 30.0, 60.0, 90.0}) {
    const Configuration<double> c = configuration(mast);
    const SteadyFlight<double> flight{mast < 90 ? 40 + mast / 2 : 90, 2 * kDeg, 4 * kDeg, 1 * kDeg};
    TrimResult<double> a, b;
    CHECK(trim(c, flight, automatic, a) == TrimStatus::ok);
    CHECK(trim(c, flight, numerical, b) == TrimStatus::ok);
    CHECK_LE(std::abs(a.iterations - b.iterations), 1);
    double x[state_count], y[state_count];
    flatten(a.state, x);
    flatten(b.state, y);
    for (int i = 0; i < state_count; ++i) worst = std::max(worst, std::abs(x[i] - y[i]));
    CHECK_NEAR(a.controls.pedal, b.controls.pedal, 1e-7);
  }
  CHECK_LT(worst, 1e-7);
  NOTE("largest difference of a state " << worst);
}

// Single precision: 24 bits carry the trim to about 1e-4, the slow modes to about 1e-2.
TEST(analysis_in_single_precision) {
  static TrimWorkspace<float> work;
  static LinearizationWorkspace<float> linear;
  static ModesWorkspace<float> eigen;
  static SimulationWorkspace<float> flight;
  static LinearModel<float> model;
  static ModeSet<float> set;
  for (double mast : {0.0, 30.0, 60.0, 90.0}) {
    const float speed = mast < 90 ? 40.0f + static_cast<float>(mast) / 2 : 100.0f;
    Configuration<float> c;
    CHECK(prepare(aircraft_data<float>(), flight_setup(aircraft_data<float>(), static_cast<float>(mast)),
                  c) == Status::ok);
    TrimResult<float> r;
    CHECK(trim(c, SteadyFlight<float>{speed, 0, 0, 0}, work, r) == TrimStatus::ok);
    CHECK_LE(r.iterations, 12);
    const TrimResult<double> d = trimmed(configuration(mast), level(static_cast<double>(speed)));
    CHECK_NEAR(r.state.pitch, d.state.pitch, 1e-3);
    CHECK_NEAR(r.controls.collective, d.controls.collective, 1e-4);
    CHECK_NEAR(r.controls.long_stick, d.controls.long_stick, 1e-2);

    CHECK(linearize(c, r.state, r.controls, kInceptors, linear, model) == Status::ok);
    CHECK(modes(model, eigen, set) == Status::ok);
    static ModeSet<double> exact;
    modes_of(configuration(mast), d.state, d.controls, exact);
    for (int i = 0; i < set.count; ++i) {
      if (set.mode[i].axis == ModeAxis::rotor) continue;
      const Mode<double> m = mode_named(exact, set.mode[i].name);
      CHECK_NEAR(set.mode[i].real, m.real, 1e-2 * (1 + m.frequency));
      CHECK_NEAR(set.mode[i].imag, m.imag, 1e-2 * (1 + m.frequency));
    }
    for (Integrator integrator : {Integrator::rk4, Integrator::rodas3}) {
      Simulation<float> s;
      CHECK(start(c, r.state, r.controls, 0.01f, integrator, s) == Status::ok);
      for (int k = 0; k < 100; ++k) CHECK(advance(c, flight, s) == Status::ok);
      CHECK_NEAR(s.state.velocity.x, r.state.velocity.x, 0.02);
      CHECK_NEAR(s.state.pitch, r.state.pitch, 1e-3);
    }
  }
}

// Smaller linear models: residualised rotors, symmetric and antisymmetric halves. Expected values: the full model's
// steady response, decoupling in symmetric flight.
#include "analysis_case.hpp"

using namespace analysis_case;

// Every mirror sign of the model: in symmetric flight nothing longitudinal drives anything lateral.
TEST(split_decouples_in_symmetric_flight) {
  static LinearModel<double> model;
  static SplitModel<double> halves;
  for (int k = 0; k < 3; ++k) {
    const Point p = reference_point(kReferencePoints[k]);
    linear_model(configuration(kReferenceMasts[k]), p.x, p.u, kInceptors, model);
    split(model, halves);
    CHECK_EQ(halves.states, 23);
    CHECK_EQ(halves.longitudinal, 12);
    CHECK_LT(halves.coupling, 1e-12);
    // Collective and longitudinal stick drive the first half alone, lateral stick and pedal the second.
    for (int i = 0; i < halves.states; ++i)
      for (int j = 0; j < 4; ++j)
        if ((i < 12) != (j < 2)) CHECK_NEAR(halves.b(i, j), 0, 1e-12);
    NOTE(kReferencePoints[k] << ": coupling " << halves.coupling);
  }
  const Point p = slanted_point();
  linear_model(configuration(30), p.x, p.u, kInceptors, model);
  split(model, halves);
  CHECK_LT(1e-2, halves.coupling);
}

// The quasi-steady model has the same steady response to constant inputs: -A_qs^-1 B_qs equals the rigid part
// of -A^-1 B (both are the equilibrium).
TEST(residualised_model_keeps_the_steady_response) {
  static LinearModel<double> full, reduced;
  static ResidualisationWorkspace<double> work;
  static LU<double, kMaxLinearStates> big, small;
  for (int k = 0; k < 3; ++k) {
    const Point p = reference_point(kReferencePoints[k]);
    linear_model(configuration(kReferenceMasts[k]), p.x, p.u, kInceptors, full);
    CHECK(residualise(full, work, reduced) == Status::ok);
    CHECK_EQ(reduced.states, 8);
    CHECK(lu_factor(full.a, full.states, big) == Status::ok);
    CHECK(lu_factor(reduced.a, reduced.states, small) == Status::ok);
    for (int j = 0; j < 4; ++j) {
      double x[kMaxLinearStates], y[kMaxLinearStates];
      for (int i = 0; i < full.states; ++i) x[i] = full.b(i, j);
      for (int i = 0; i < 8; ++i) y[i] = reduced.b(i, j);
      CHECK(lu_solve(big, x) == Status::ok);
      CHECK(lu_solve(small, y) == Status::ok);
      for (int i = 0; i < 8; ++i) CHECK_NEAR(y[i], x[i], 1e-9 * (1 + std::abs(x[i])));
    }
  }
}

// A model of rigid-body states alone is its own quasi-steady model; fast states that stand still have none.
TEST(residualised_model_at_the_ends_of_its_range) {
  static LinearModel<double> full, reduced, again;
  static ResidualisationWorkspace<double> work;
  const Point p = reference_point("mast00_v000");
  linear_model(configuration(0), p.x, p.u, kInceptors, full);
  CHECK(residualise(full, work, reduced) == Status::ok);
  CHECK(residualise(reduced, work, again) == Status::ok);
  for (int i = 0; i < kRigidStates; ++i) {
    for (int j = 0; j < kRigidStates; ++j) CHECK_EQ(again.a(i, j), reduced.a(i, j));
    for (int j = 0; j < reduced.controls; ++j) CHECK_EQ(again.b(i, j), reduced.b(i, j));
  }
  reduced.states = kRigidStates - 1;
  CHECK(residualise(reduced, work, again) == Status::bad_argument);
  for (int j = 0; j < full.states; ++j) full.a(kRigidStates, j) = 0;
  CHECK(residualise(full, work, again) == Status::singular);
  CHECK_EQ(again.states, 0);
  linear_model(configuration(0), p.x, p.u, kInceptors, full);
  full.b(kRigidStates + 1, 0) = std::nan("");
  CHECK(residualise(full, work, again) == Status::not_finite);
  CHECK_EQ(again.states, 0);
  for (const int column : {1, kRigidStates + 1}) {  // A_rr, A_rf
    linear_model(configuration(0), p.x, p.u, kInceptors, full);
    full.a(2, column) = std::nan("");
    CHECK(residualise(full, work, again) == Status::not_finite);
    CHECK_EQ(again.states, 0);
  }
  linear_model(configuration(0), p.x, p.u, kInceptors, full);
  full.b(2, 0) = std::nan("");
  CHECK(residualise(full, work, again) == Status::not_finite);
}

// Work beyond the fast states there are is left alone: with the most there can be, it would lie outside.
TEST(residualised_model_stays_within_its_states) {
  static LinearModel<double> full, reduced;
  static ResidualisationWorkspace<double> work;
  const Point p = reference_point("mast30_v050");
  linear_model(configuration(30), p.x, p.u, kInceptors, full);
  const int fast = full.states - kRigidStates;
  CHECK_LT(fast, kMaxFastStates);
  fill(work.fast, 7.5);
  fill(work.drive, 7.5);
  CHECK(residualise(full, work, reduced) == Status::ok);
  for (int i = 0; i < kMaxFastStates; ++i) {
    for (int j = 0; j < kMaxFastStates; ++j) {
      if (i >= fast || j >= fast) CHECK_EQ(work.fast(i, j), 7.5);
    }
    for (int j = 0; i >= fast && j < work.drive.kCols; ++j) CHECK_EQ(work.drive(i, j), 7.5);
  }
}

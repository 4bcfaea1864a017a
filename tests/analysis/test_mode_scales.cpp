// Modes of A times a power of two: frequencies scale with it, everything else stays; a frequency that no
// number can hold is refused. The modes of A itself are the expectation.
#include "analysis_case.hpp"

using namespace analysis_case;

TEST(modes_of_a_scaled_matrix_are_scaled) {
  static LinearModel<double> model, scaled;
  static ModesWorkspace<double> work;
  static ModeSet<double> expected, set;
  const Configuration<double> c = configuration(30);
  const TrimResult<double> flight = trimmed(c, level(50));
  linear_model(c, flight.state, flight.controls, kInceptors, model);
  CHECK(modes(model, work, expected) == Status::ok);
  for (const int exponent : {-900, -400, -60, 60, 300, 664, 1000}) {  // 2^664: 1e200
    scaled = model;
    for (double& x : scaled.a.entry) x = std::ldexp(x, exponent);
    CHECK(modes(scaled, work, set) == Status::ok);
    CHECK_EQ(set.count, expected.count);
    for (int i = 0; i < set.count; ++i) {
      const Mode<double>& e = expected.mode[i];
      const double tolerance = 1e-11 * e.condition;
      CHECK(std::isfinite(set.mode[i].frequency));
      CHECK_NEAR(std::ldexp(set.mode[i].frequency, -exponent), e.frequency, tolerance);
      CHECK_NEAR(std::ldexp(set.mode[i].real, -exponent), e.real, tolerance);
      if (e.frequency > 0.01) CHECK_NEAR(set.mode[i].damping_ratio, e.damping_ratio, 1e-6);
      CHECK_EQ(std::string(set.mode[i].name), std::string(e.name));
    }
  }
  for (double& x : scaled.a.entry) x = 0;
  for (int i = 0; i + 1 < model.states; i += 2) {  // pairs whose length exceeds what their parts do not
    scaled.a(i, i) = scaled.a(i + 1, i + 1) = 1.5e308;
    scaled.a(i, i + 1) = 1.5e308;
    scaled.a(i + 1, i) = -1.5e308;
  }
  CHECK(modes(scaled, work, set) == Status::not_finite);
  CHECK_EQ(set.count, 0);
}

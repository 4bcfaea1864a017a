// Loads of the rotor over the number of its stations: the finest grid is the expected value.
#include "settled_rotor.hpp"

using namespace flight_cases;
using settled_rotor::hover_input;

// Refining the stations: azimuth converges spectrally, the aligned radial grid to half a percent.
TEST(rotor_converges_with_the_grid) {
  const auto thrust = [](int azimuths, int refinement) {
    Options options;
    options.azimuth_stations = azimuths;
    options.grid_refinement = refinement;
    const Configuration<double> c = configuration(0, options);
    RotorInput<double> in = hover_input(c);
    in.velocity_a = {-30.867, 0, -3};  // 60 kt
    in.collective = 0.15;
    in.state.lambda_0 = 0.031;
    in.state.lambda_c = 0.03;
    in.state.b1c = -0.02;
    in.state.b1s = -0.04;
    in.long_cyclic = 0.018;
    return rotor_loads(c, in, c.azimuth).force_a.z;
  };
  const double t12 = thrust(12, 1);
  const double t24 = thrust(24, 1);
  const double t48 = thrust(48, 1);
  const double fine = thrust(24, 4);
  CHECK_REL(t12, t24, 2e-4);
  CHECK_REL(t24, t48, 2e-5);
  CHECK_REL(t24, fine, 5e-3);
  NOTE("thrust change 12 to 24 stations " << t24 / t12 - 1 << ", 24 to 48 " << t48 / t24 - 1
                                          << ", 20 to 80 segments " << fine / t24 - 1);
}

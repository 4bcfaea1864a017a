// What a rig calls, through the C interface: an aircraft in asymmetric flight, its frames, and its systems.
#pragma once

#include <memory>
#include <vector>

#include "flights.hpp"
#include "tiltrotor/tiltrotor.h"

namespace bench {

// A tr_sim trimmed in a turn with sideslip, and room for its models.
struct Rig {
  tr_sim sim;
  std::unique_ptr<tr_work> work = std::make_unique<tr_work>();
  tr_linear_shape shape;
  std::vector<tr_real> a = std::vector<tr_real>(TR_MAX_LINEAR_STATES * TR_MAX_LINEAR_STATES);
  std::vector<tr_real> b = std::vector<tr_real>(TR_MAX_LINEAR_STATES * TR_INPUTS);
  std::vector<tr_real> c = std::vector<tr_real>(TR_OUTPUTS * TR_MAX_LINEAR_STATES);
  std::vector<tr_real> d = std::vector<tr_real>(TR_OUTPUTS * TR_INPUTS);
  tr_real real[TR_MAX_LINEAR_STATES], imag[TR_MAX_LINEAR_STATES];

  Rig(double mast_deg, double speed_mps) {
    tr_setup setup;
    const tr_flight turn = {speed_mps, 0, 0.1, 0.05};
    require(tr_default_setup(&setup, TR_API_VERSION, TR_XV15, mast_deg) == TR_OK, "no setup");
    require(tr_init(&sim, TR_API_VERSION, &setup) == TR_OK, "no aircraft");
    const tr_status status = tr_trim(&sim, work.get(), &turn, nullptr);
    require(status == TR_OK || status >= TR_WING_STALL, "no trim");
  }

  // Everything on but the ground.
  void switch_on() {
    tr_systems on;
    require(tr_get_systems(&sim, &on) == TR_OK, "no systems");
    on.governor = TR_GOVERNOR_PI;
    on.conversion = on.engines = on.actuators = on.scas = on.turbulence = 1;
    on.turbulence_w20_mps = 15.4;
    require(tr_set_systems(&sim, &on) == TR_OK, "systems refused");
  }

  tr_status linearize() {
    return tr_linearize(&sim, work.get(), TR_BLADE_CONTROLS, &shape, a.data(), a.size(), b.data(), b.size());
  }
  // C and D.
  tr_status linearize_outputs() {
    return tr_linearize_outputs(&sim, work.get(), TR_BLADE_CONTROLS, c.data(), c.size(), d.data(), d.size());
  }
  tr_status eigenvalues() {
    return tr_eigenvalues(work.get(), a.data(), static_cast<std::size_t>(shape.states), real, imag,
                          TR_MAX_LINEAR_STATES);
  }
  // A, B, all eigenvalues and a step of order 3, as frame.hpp does without the interface.
  bool frame(double dt) {
    return tr_linearize_and_step(&sim, work.get(), dt, TR_BLADE_CONTROLS, &shape, a.data(), a.size(),
                                 b.data(), b.size()) == TR_OK &&
           eigenvalues() == TR_OK;
  }
  // A, B, all eigenvalues and the exponential step.
  bool exponential_frame(double dt) {
    return tr_linearize_and_step_exponential(&sim, work.get(), dt, nullptr, TR_BLADE_CONTROLS, &shape,
                                             a.data(), a.size(), b.data(), b.size()) == TR_OK &&
           eigenvalues() == TR_OK;
  }
  // A, B, the eigenvalues of the rigid body and the exponential step.
  bool slow_frame(double dt) {
    return tr_linearize_and_step_exponential(&sim, work.get(), dt, nullptr, TR_BLADE_CONTROLS, &shape,
                                             a.data(), a.size(), b.data(), b.size()) == TR_OK &&
           tr_rigid_model(work.get(), &shape, a.data(), a.size(), nullptr, 0, &shape, a.data(), a.size(),
                          nullptr, 0) == TR_OK &&
           eigenvalues() == TR_OK;
  }
};

}  // namespace bench

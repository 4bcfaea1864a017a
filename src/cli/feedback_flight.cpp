#include "cli/feedback_flight.hpp"

#include "cli/errors.hpp"
#include "cli/output.hpp"
#include "tiltrotor/analysis/linear/linear_eigenvalues.hpp"

namespace tiltrotor::cli {

namespace {

constexpr int kMostParts = 256;  // of a step: no law that a control could follow needs as many

}  // namespace

FeedbackFlight::FeedbackFlight(const Feedback& feedback, SystemFlight<double>* systems, Analyses& work)
    : feedback_(feedback),
      systems_(systems),
      work_(work),
      loop_(feedback.is_given() ? std::make_unique<Loop>() : nullptr) {}

Status FeedbackFlight::begin(const Configuration<double>& c, const Simulation<double>& simulation) {
  if (loop_ == nullptr) return Status::ok;
  const FeedbackLaw<double>& law = feedback_.law();
  double seen[kReadingCount] = {};
  flatten(current_state(simulation), seen);
  if (systems_ != nullptr) flatten(systems_->state, seen + state_count);
  FeedbackReference<double>& reference = loop_->reference;
  set_zero(reference.d);
  Status status = Status::ok;
  const auto take = [&](const auto& outputs) {
    for (int i = 0; i < outputs.outputs; ++i) {
      seen[vehicle_state_count + i] = outputs.y[i];
      for (int j = 0; j < control_count; ++j) reference.d(i, j) = outputs.d(i, j);
    }
  };
  const State<double>& x = simulation.state;
  const Controls<double>& u = simulation.controls;
  if (law.reads_instruments() && systems_ == nullptr) {
    const auto outputs = std::make_unique<OutputMatrices>();
    status = linearize_outputs(c, x, u, kAllControls, work_, *outputs);
    take(*outputs);
  } else if (law.reads_instruments()) {
    const auto outputs = std::make_unique<VehicleOutputs>();
    VehicleShape shape{0, control_count, {}, {}};
    for (int j = 0; j < control_count; ++j) shape.input[j] = j;
    status = linearize_vehicle_outputs(*systems_, c, x, u, shape, *outputs);
    take(*outputs);
  }
  for (int k = 0; k < law.readings; ++k) reference.reading[k] = seen[law.reading[k]];
  loop_->law = &law;
  loop_->fastest = {};
  if (status == Status::ok) status = find_fastest(c, simulation);
  if (status == Status::ok) check_cost(simulation);
  return status;
}

void FeedbackFlight::check_cost(const Simulation<double>& simulation) const {
  const double dt = simulation.dt;
  if (flight_step::parts(simulation.integrator, dt, loop_->fastest) <= kMostParts) return;
  const StabilityLimits& limits =
      simulation.integrator == Integrator::rk3 ? kRungeKutta3Limits : kRungeKutta4Limits;
  const FastestRates<double>& fastest = loop_->fastest;
  const bool decays = fastest.decay / limits.decay > fastest.oscillation / limits.oscillation;
  const double most = kMostParts * (decays ? limits.decay : limits.oscillation) / dt;
  throw UsageError("--feedback " + feedback_.name() + ": a root of the closed loop is " +
                   number_text(decays ? fastest.decay : fastest.oscillation, 3) + " 1/s, outside 0.." +
                   number_text(most, 3) + " 1/s, where a step of " + number_text(dt) +
                   " s is cut into at most " + std::to_string(kMostParts) +
                   " parts; give smaller gains or steps");
}

Status FeedbackFlight::find_fastest(const Configuration<double>& c, const Simulation<double>& simulation) {
  const State<double>& x = simulation.state;
  const Controls<double>& u = simulation.controls;
  if (systems_ != nullptr) {
    const auto matrices = std::make_unique<VehicleMatrices>();
    const auto modes = std::make_unique<VehicleModes<double>>();
    Status status =
        feedback_.linearize_flight(c, *systems_, x, u, ControlSet{}, CommandColumns::all, work_, *matrices);
    if (status == Status::ok) status = vehicle_modes(*matrices, work_, *modes);
    const VehicleMode<double>* const mode = modes->mode;
    loop_->fastest = fastest_rates<double>(
        status == Status::ok ? modes->count : 0, [mode](int k) { return mode[k].real; },
        [mode](int k) { return mode[k].imag; });
    return status;
  }
  const auto model = std::make_unique<LinearModel<double>>();
  const auto search = std::make_unique<LinearEigenvaluesWorkspace<double>>();
  Eigenvalues<double, kMaxLinearStates> values{};
  Status status = feedback_.linearize(c, x, u, ControlSet{}, work_, *model, nullptr);
  if (status == Status::ok) status = eigenvalues(*model, *search, values);
  loop_->fastest = fastest_rates<double>(
      values.size, [&values](int k) { return values.real[k]; }, [&values](int k) { return values.imag[k]; });
  return status;
}

Status FeedbackFlight::act(const Configuration<double>& c, const Simulation<double>& simulation) {
  acting_ = current_controls(simulation);
  if (loop_ == nullptr) return Status::ok;
  const Controls<double> hands = acting_;
  const State<double> x = current_state(simulation);
  const double azimuth = current_azimuth(c, simulation);
  const FeedbackLaw<double>& law = feedback_.law();
  if (systems_ == nullptr)
    return feed_back<double>(law, loop_->reference, c, x, nullptr, hands, azimuth, loop_->search, acting_);
  Configuration<double> put = c;
  put.around = with_turbulence(c, x, hands, systems_->vehicle, systems_->state);
  const FlownVehicle<double> vehicle{systems_->vehicle, systems_->state, c.setup, put};
  return feed_back<double>(law, loop_->reference, put, x, &vehicle, hands, azimuth, loop_->search, acting_);
}

Status FeedbackFlight::advance(Configuration<double>& c, Simulation<double>& simulation, const double* xdot) {
  MovingConfiguration<double> moving{&c, false, 0, {}, 0};
  if (loop_ == nullptr) {
    return systems_ != nullptr ? advance_vehicle(c, *systems_, work_, simulation, xdot)
                               : advance_moving(moving, work_, simulation, xdot);
  }
  return systems_ != nullptr ? advance_vehicle(c, *systems_, *loop_, simulation, xdot)
                             : advance_moving(moving, *loop_, simulation, xdot);
}

}  // namespace tiltrotor::cli

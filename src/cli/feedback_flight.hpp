// A flight from trim, on its way: open, or with a feedback law that counts from there.
#pragma once

#include <memory>

#include "cli/feedback.hpp"
#include "library/closed_loop_flight.hpp"

namespace tiltrotor::cli {

class FeedbackFlight {
 public:
  // `systems`: those of the flight, or nullptr; they and `work` outlive it.
  FeedbackFlight(const Feedback& feedback, SystemFlight<double>* systems, Analyses& work);
  // The law counts from here. Status: those of linearize_outputs(). Throws UsageError where the closed loop is so fast
  // here that steps would be cut into hundreds of parts; a scheduled law may be as fast later, up to kMaxParts.
  Status begin(const Configuration<double>& c, const Simulation<double>& simulation);

  // What acts from now on. Status: those of feed_back().
  Status act(const Configuration<double>& c, const Simulation<double>& simulation);
  const Controls<double>& acting() const { return acting_; }
  // Where the law stands then, or nullptr without one.
  const FeedbackPoint<double>* point() const { return loop_ == nullptr ? nullptr : &loop_->search.at; }

  // One step, with what moves in it; `xdot`: rates that are known, or nullptr.
  Status advance(Configuration<double>& c, Simulation<double>& simulation, const double* xdot = nullptr);

  const Feedback& feedback() const { return feedback_; }

 private:
  // How fast the closed loop is where it begins. Status: those of the linear model.
  Status find_fastest(const Configuration<double>& c, const Simulation<double>& simulation);
  void check_cost(const Simulation<double>& simulation) const;

  using Loop = SimulationWorkspace<double, ClosedLoop>;
  Feedback feedback_;
  SystemFlight<double>* systems_;
  Analyses& work_;
  std::unique_ptr<Loop> loop_;
  Controls<double> acting_{};
};

}  // namespace tiltrotor::cli

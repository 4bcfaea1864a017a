// Modes of one linear model after another, and which continues which.
#pragma once

#include <memory>

#include "library/analyses.hpp"

namespace tiltrotor::cli {

// Numbers the branches of a sweep: each number stands for one branch, whatever lies between.
class ModeTracker {
 public:
  void begin_sweep();
  // `connects`: the model continues the one before. Status as modes().
  Status find(const LinearModel<double>& model, bool connects);
  const ModeSet<double>& found() const { return work_->current; }
  void lose_track() { has_previous_ = false; }

 private:
  struct Workspace {
    ModesWorkspace<double> modes;
    ModeSet<double> previous, current;
  };
  bool has_previous_ = false;
  int branches_ = 0;  // numbered so far
  std::unique_ptr<Workspace> work_ = std::make_unique<Workspace>();
};

}  // namespace tiltrotor::cli

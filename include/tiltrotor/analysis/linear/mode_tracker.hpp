// Modes of one linear model after another, and which continues which.
#pragma once

#include "tiltrotor/analysis/linear/modes.hpp"

namespace tiltrotor {

// Numbers the branches of a sweep: each number stands for one branch, whatever lies between. Some 100 kB in double
// precision, of the caller.
template <class R>
class ModeTracker {
 public:
  void begin_sweep() {
    has_previous_ = false;
    branches_ = 0;
  }

  // `connects`: the model continues the one before. Status and cost as modes(), and those of follow().
  Status find(const LinearModel<R>& model, bool connects) {
    Status status = modes(model, work_, current_);
    if (status == Status::ok && connects && has_previous_) {
      status = follow(previous_, current_);
    } else {
      for (int i = 0; i < current_.count; ++i) current_.mode[i].branch += branches_;
      current_.branches += branches_;
    }
    has_previous_ = status == Status::ok;
    if (has_previous_) {
      branches_ = current_.branches;
      previous_ = current_;
    }
    return status;
  }

  const ModeSet<R>& found() const { return current_; }
  // A flight without modes lies between.
  void lose_track() { has_previous_ = false; }

 private:
  bool has_previous_ = false;
  int branches_ = 0;  // numbered so far
  ModesWorkspace<R> work_;
  ModeSet<R> previous_, current_;
};

}  // namespace tiltrotor

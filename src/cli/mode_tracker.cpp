#include "cli/mode_tracker.hpp"

namespace tiltrotor::cli {

void ModeTracker::begin_sweep() {
  has_previous_ = false;
  branches_ = 0;
}

Status ModeTracker::find(const LinearModel<double>& model, bool connects) {
  ModeSet<double>& set = work_->current;
  Status status = modes(model, work_->modes, set);
  if (status == Status::ok && connects && has_previous_) {
    status = follow(work_->previous, set);
  } else {
    for (int i = 0; i < set.count; ++i) set.mode[i].branch += branches_;
    set.branches += branches_;
  }
  has_previous_ = status == Status::ok;
  if (has_previous_) {
    branches_ = set.branches;
    work_->previous = set;
  }
  return status;
}

}  // namespace tiltrotor::cli

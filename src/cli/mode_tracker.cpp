#include "cli/mode_tracker.hpp"

namespace tiltrotor::cli {

Status ModeTracker::find(const LinearModel<double>& model, bool connects) {
  Status status = modes(model, room_->work, room_->current);
  if (status == Status::ok && connects && has_previous_) status = follow(room_->previous, room_->current);
  has_previous_ = status == Status::ok;
  if (has_previous_) room_->previous = room_->current;
  return status;
}

}  // namespace tiltrotor::cli

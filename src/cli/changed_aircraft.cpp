#include "cli/changed_aircraft.hpp"

#include <stdexcept>

namespace tiltrotor::cli {

void ChangedAircraft::remake(const Configuration<double>& base) {
  if (prepare(aircraft, base.setup, c_) != Status::ok)
    throw std::runtime_error("a changed aircraft leaves the ranges of the model");
  c_.around = base.around;
  configure(c_);
}

}  // namespace tiltrotor::cli

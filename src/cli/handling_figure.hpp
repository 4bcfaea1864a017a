// Figures of handling qualities: flights against the boundaries that are published, and no others.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cli/handling_criteria.hpp"
#include "plot/plot.hpp"

namespace tiltrotor::cli {

struct JudgedFlight {
  double mast_deg, speed;
  HandlingQuantities quantities;
};

// Those for which there are flights.
std::vector<plot::Plot> handling_plots(const std::vector<Criterion>& criteria,
                                       const std::vector<JudgedFlight>& flights);

}  // namespace tiltrotor::cli

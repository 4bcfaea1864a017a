// Flights with a feedback law, compiled once in double precision: TILTROTOR_CLOSED_LOOP() stands in analysis_closed_loop.cpp.
#pragma once

#include "library/model_instances.hpp"
#include "tiltrotor/analysis/flight/closed_loop.hpp"

#define TILTROTOR_CLOSED_LOOP(PREFIX)                                                                   \
  PREFIX template Status advance_moving(MovingConfiguration<double>&,                                   \
                                        SimulationWorkspace<double, ClosedLoop>&, Simulation<double>&,  \
                                        const double*);                                                 \
  PREFIX template Status advance_vehicle(Configuration<double>&, SystemFlight<double>&,                 \
                                         SimulationWorkspace<double, ClosedLoop>&, Simulation<double>&, \
                                         const double*);                                                \
  PREFIX template Status feed_back(const FeedbackLaw<double>&, const FeedbackReference<double>&,        \
                                   const Configuration<double>&, const State<double>&,                  \
                                   const FlownVehicle<double>*, const Controls<double>&, double,        \
                                   FeedbackSearch<double>&, Controls<double>&);

namespace tiltrotor {
TILTROTOR_CLOSED_LOOP(extern)
}  // namespace tiltrotor

// Linear models and modes of the flights of the study.
#pragma once

#include <memory>

#include "library/analyses.hpp"
#include "study/flights.hpp"
#include "tiltrotor/analysis/linear/linear_model.hpp"
#include "tiltrotor/analysis/linear/mode_names.hpp"
#include "tiltrotor/analysis/linear/mode_tracker.hpp"
#include "tiltrotor/analysis/linear/modes.hpp"

namespace tiltrotor::study {

using Linear = LinearModel<double>;
using Modes = ModeSet<double>;
using Tracker = ModeTracker<double>;

// Throw when a number is not finite or an eigenvalue is not found.
Linear linear_model(const Configured& c, const State<double>& x, const Controls<double>& u,
                    const ControlSet& columns);
Linear quasi_steady(const Linear& full);  // rotors, inflow and downwash in balance
Linear linear_model(const Configured& c, const Trimmed& trim);
Linear linear_model_at(const Setup& setup, double speed_mps, const ControlSet& columns);  // of level flight
// With a governor that keeps the power of the engines: `ideal`, which adds no states. Rows and columns of the states alone.
Linear linear_model(const Configured& c, const SystemFlight<double>& systems, const State<double>& x,
                    const Controls<double>& u);
Modes modes_of(const Linear& model);
Modes modes_of(const Configured& c, const Trimmed& trim);

// With branches followed along a sweep; `connects`: the model continues the one before. Valid until the next.
const Modes& modes_of(const Linear& model, Tracker& tracker, bool connects);

// A mode of the airframe, not of rotors or wash.
inline bool is_body_mode(const Mode<double>& mode) {
  return mode.axis != ModeAxis::rotor && mode.label.kind != ModeKind::downwash;
}

// Quasi-steady derivative of a state's rate by a state or control, by their places in State and Controls.
double state_derivative(const Linear& model, int rate, int state);
double control_derivative(const Linear& model, int rate, int control);

}  // namespace tiltrotor::study

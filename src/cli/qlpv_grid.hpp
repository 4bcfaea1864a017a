// Linear models on a grid of altitude, mast angle and speed: what a quasi-linear parameter-varying model is made of.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/chosen_model.hpp"
#include "cli/trimmed_flights.hpp"

namespace tiltrotor::cli {

// The scheduling variables, in the order in which points and cells are counted: altitude slowest, speed fastest.
inline constexpr int kByAltitude = 0, kByMast = 1, kBySpeed = 2, kSchedulingVariables = 3;
inline constexpr const char* kSchedulingNames[] = {"altitude_m", "mast_deg", "speed_mps"};
inline constexpr const char* kSchedulingUnits[] = {"m", "deg", "m/s"};
using SchedulingPoint = double[kSchedulingVariables];

// A trimmed flight with its model; `status` is that of the trim or, where the model failed, the model's.
struct QlpvPoint {
  std::unique_ptr<TrimmedFlight> flight;
  std::unique_ptr<VehicleMatrices> model;  // of the airframe, with governor, augmentation and feedback law
  ShownModel shown;                        // with its outputs
  std::vector<FeedbackGain> gains;
  bool valid;
  std::string status;
  std::string explanation;  // of what is not `ok`
};

class QlpvGrid {
 public:
  // Throws UsageError when something but the scheduling variables takes several values, or theirs do not increase.
  explicit QlpvGrid(const Arguments& arguments);

  const std::vector<double>& axis(int variable) const { return axis_[variable]; }
  std::size_t points() const;
  void place_point(std::size_t number, SchedulingPoint& at) const;
  // Cells between neighbours; an axis of one value has no extent.
  std::size_t cells() const;
  // The centre of a cell and the points at its corners.
  void place_cell(std::size_t number, SchedulingPoint& centre, std::vector<std::size_t>& corners) const;

  QlpvPoint find(const SchedulingPoint& at, Analyses& work) const;
  // Names of rows and columns, whatever the flight.
  ShownModel names() const { return model_->names(setup_.switches()); }
  const std::vector<NamedOutput>& outputs() const { return model_->outputs(); }  // that were chosen
  LinearSettings settings(const QlpvPoint& point) const;
  std::string where(const SchedulingPoint& at) const;

 private:
  std::string command_;
  SetupOptions setup_;
  FlightCase flight_;
  std::unique_ptr<ChosenModel> model_;
  std::vector<double> axis_[kSchedulingVariables];
};

}  // namespace tiltrotor::cli

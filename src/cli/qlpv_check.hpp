// What a model interpolated between the points of a grid is worth: at the centre of every cell, where multilinear
// interpolation takes the mean of the corners, against the model of a trim there.
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "cli/qlpv_grid.hpp"

namespace tiltrotor::cli {

// A root of the exact model, and of the interpolated one that continues it; NaN where none does.
struct QlpvRoot {
  std::string axis, name;
  std::complex<double> exact, interpolated;
  double error() const;  // of the distance, over the size of the exact one
};

// A response: of an inceptor to the motion that it is there for, of a throttle to the rotor speed where that is a state.
// An ideal governor takes back the collective at once: there the throttle makes the motion.
struct QlpvResponse {
  std::string name;  // "long_stick>q"
  double error;      // largest |G' - G| / |G| over the band, G' the interpolated
  double omega;      // where, rad/s
};
inline constexpr double kQlpvBand[] = {0.1, 10};  // rad/s

// The reading of a chosen output in the trim, and the mean of the corners.
struct QlpvReading {
  std::string name;
  double exact, interpolated;
  double reach;  // how far an input bends it
  // Of the distance, over the size of the exact one; NaN where that is a rounding of the reach.
  double error() const;
};

struct QlpvErrors {
  std::vector<QlpvRoot> roots;
  std::vector<QlpvResponse> responses;
  std::vector<QlpvReading> readings;
};

// Mean of models with the same rows and columns.
std::unique_ptr<VehicleMatrices> mean_model(const std::vector<const VehicleMatrices*>& corners);

// Status: those of vehicle_modes() and transfer_function().
Status qlpv_errors(const VehicleMatrices& exact, const VehicleMatrices& interpolated, Analyses& work,
                   QlpvErrors& out);

// Adds the readings of the outputs that were chosen, and of each its response to the input that moves it most, over the
// distance at which the model bends; "none" in its place where no input does. `mean`: of the corners. Status: those of transfer_function().
Status qlpv_output_errors(const QlpvPoint& exact, const VehicleMatrices& mean,
                          const std::vector<const ShownModel*>& corners, QlpvErrors& out);

}  // namespace tiltrotor::cli

#include "study/transfer_function.hpp"

#include <cmath>
#include <memory>
#include <stdexcept>

#include "text/number.hpp"
#include "text/split.hpp"
#include "tiltrotor/analysis/linear/channel.hpp"

namespace tiltrotor::study {

namespace {

struct WorkAreas {
  VehicleChannel<double> channel;
  TransferFunctionWorkspace<double, kMaxVehicleStates> roots;
  VehicleTransfer<double> transfer;
  ResponseWorkspace<double, kMaxVehicleStates> response;
};

// Large: one set for the whole program, made at first use.
WorkAreas& work() {
  static const auto areas = std::make_unique<WorkAreas>();
  return *areas;
}

}  // namespace

Complex response_of(const Linear& model, int output, int input, double omega, bool derivative) {
  int column = 0, row = 0;
  while (model.control[column] != input) ++column;
  while (model.state[row] != output) ++row;
  set_channel(model, row, column, work().channel);
  if (transfer_function(work().channel, work().roots, work().transfer) != Status::ok)
    throw std::runtime_error("transfer function: roots were not found");
  const Complex s(0, omega), x = response(work().transfer, s, work().response);
  return derivative ? s * x : x;
}

Complex polynomial(const std::string& coefficients, Complex s) {
  Complex value = 0;
  for (const std::string& c : text::split(coefficients, ' '))
    value = value * s + text::parse_number(c, "transfer function");
  return value;
}

double leading_coefficient(const std::string& coefficients) {
  return text::parse_number(text::split(coefficients, ' ').front(), "transfer function");
}

double decibel(Complex value) { return 20 * std::log10(std::abs(value)); }

double phase_deg(Complex value) { return degrees(std::arg(value)); }

double nearest_turn(double phase, double to) { return phase + 360 * std::round((to - phase) / 360); }

}  // namespace tiltrotor::study

// How a trimmed flight and its modes move with what may be changed: sensitivity_parameters.hpp.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/sensitivity_parameters.hpp"
#include "cli/trimmed_flights.hpp"
#include "tiltrotor/analysis/linear/root_sensitivity.hpp"
#include "tiltrotor/analysis/trim/trim_motion.hpp"

namespace tiltrotor::cli {

struct NamedRoot {
  std::string axis, name;
  double real, imag, frequency, damping_ratio;
};

// For the usual change of a parameter, to first order.
struct FlightMotion {
  TrimMotion<double> trim;
  double power;                          // of both rotors, W
  std::vector<RootMotion<double>> root;  // in the order of the roots
  bool exact;
};

// Derivatives with respect to settings and what follows from them are exact. With respect to numbers of the aircraft
// what the moving trim does is; the aircraft's own part is a difference of exact matrices over a small part of the usual
// change and its half, extrapolated: to rounding where the loads are proportional to the number, as to coefficients.
// With systems the matrices are such differences along the exact motion of the trim.
class Sensitivity {
 public:
  explicit Sensitivity(const SensitivitySystems& systems);
  ~Sensitivity();

  // Linear model and modes of a trimmed flight, which must outlive what follows.
  Status begin(const TrimmedFlight& flight, Analyses& work);
  const std::vector<NamedRoot>& roots() const { return roots_; }

  Status move(const SensitivityParameter& parameter, FlightMotion& out);

 private:
  struct Memory;
  using Numbers = std::vector<double>;

  void name_roots();
  void find_roots(std::vector<RootMotion<double>>& roots);
  // Rates, power and A of the airframe, of a configuration with the trim moved by so many units of the parameter.
  Numbers airframe_numbers(const Configuration<double>& c, const TrimMotion<double>& motion, double by,
                           Status& status);
  // A of the closed loop.
  Numbers closed_loop_numbers(const Configuration<double>& c, const TrimMotion<double>& motion, double by,
                              Status& status);
  using NumbersOf = Numbers (Sensitivity::*)(const Configuration<double>&, const TrimMotion<double>&, double,
                                             Status&);
  // Of these numbers per unit of the parameter.
  Numbers slopes(const SensitivityParameter& parameter, const TrimMotion<double>& motion, double step,
                 NumbersOf numbers_of, Status& status);
  State<double> set_by_flight(const SensitivityParameter& parameter) const;
  Numbers rates_along(const State<double>& direct) const;
  bool changes_aircraft(const SensitivityParameter& parameter) const;

  SensitivitySystems systems_;
  const TrimmedFlight* flight_ = nullptr;
  Analyses* work_ = nullptr;
  std::vector<NamedRoot> roots_;
  std::unique_ptr<Memory> memory_;
};

}  // namespace tiltrotor::cli

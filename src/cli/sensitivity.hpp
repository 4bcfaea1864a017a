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
  std::vector<double> freed;             // of what each target lets go, in the unit of its column
};

// Exact: numbers of the aircraft, settings, what follows from them, gains and tables; the trim moves as well, and with
// systems the balance of power. What targets of the trim hold stays, and what they let go moves for it:
// ds/dp = -(dh/ds)^-1 dh/dp, all along trims. What the flight does not let move (a sideslip at rest) stays too, where
// what is held does without it.
class Sensitivity {
 public:
  explicit Sensitivity(const SensitivitySystems& systems);
  ~Sensitivity();

  // Linear model and modes of a trimmed flight, which must outlive what follows.
  // Status: ok; not_finite; singular (nothing that was let go moves what is held, as where that is largest or least);
  // out_of_range (a climb let go in vertical flight with a bank).
  Status begin(const TrimmedFlight& flight, Analyses& work);
  const std::vector<NamedRoot>& roots() const { return roots_; }

  // Status: ok; not_finite; singular (the flight does not let move what must).
  Status move(const SensitivityParameter& parameter, FlightMotion& out);
  // What was wrong with a target, of the last call; else empty.
  const std::string& fault() const { return fault_; }

 private:
  struct Memory;

  // By one unit, what is let go staying; `held`: how what the targets hold moves.
  Status move_alone(const SensitivityParameter& parameter, FlightMotion& out, std::vector<double>& held);
  Status begin_targets();
  Status keep_targets(const SensitivityParameter& parameter, double change, const std::vector<double>& held,
                      FlightMotion& motion);

  void name_roots();
  void find_roots(std::vector<RootMotion<double>>& roots);
  Status begin_slope(const SensitivityParameter& parameter);
  State<double> set_by_flight(const SensitivityParameter& parameter) const;
  void rates_along(const State<double>& direct, double (&rates)[state_count]) const;
  bool changes_aircraft(const SensitivityParameter& parameter) const;

  SensitivitySystems systems_;
  const TrimmedFlight* flight_ = nullptr;
  Analyses* work_ = nullptr;
  std::vector<NamedRoot> roots_;
  std::string fault_;
  std::unique_ptr<Memory> memory_;
};

}  // namespace tiltrotor::cli

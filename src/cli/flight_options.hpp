// Options that describe the aircraft and its flight, shared by the commands.
#pragma once

#include <optional>
#include <vector>

#include "cli/model_options.hpp"
#include "cli/trim_targets.hpp"
#include "tiltrotor/analysis/trim/steady_flight.hpp"
#include "tiltrotor/model/setup/configuration.hpp"

namespace tiltrotor::cli {

inline constexpr double kInch = 0.0254;  // m

inline constexpr double kRpm = kPi<double> / 30;  // rad/s

// Range of the aircraft for a field, in a unit of so many of the field's; rounded inward to three digits.
Range shown_range(SetupField field, double unit, const char* unit_name);
Range speed_range();
Range isa_offset_range();

inline const Range kMastRange = shown_range(SetupField::mast_deg, 1, "deg");
inline const Range kSpeedRange = speed_range();
inline const Range kAltitudeRange = shown_range(SetupField::altitude, 1, "m");
inline const Range kRotorSpeedRange = shown_range(SetupField::rotor_speed, kRpm, "rpm");
inline const Range kFlapRange = shown_range(SetupField::flap_deg, 1, "deg");
inline const Range kMassRange = shown_range(SetupField::mass, 1, "kg");
inline const Range kCgRange = shown_range(SetupField::sl_cg, kInch, "in");
inline constexpr Range kAngleRange{-60, 60, "deg"};
inline constexpr Range kClimbRange{-90, 90, "deg"};
inline constexpr Range kTurnRateRange{-60, 60, "deg/s"};
inline constexpr Range kAzimuthRange{-180, 360, "deg"};

// The column of --isa-offset.
inline constexpr const char* kWarmerColumn = "isa_offset_k";

// The same configuration for any mast angle.
class SetupOptions {
 public:
  static OptionList list();
  static OptionList rotor_list();  // what concerns an isolated rotor
  explicit SetupOptions(const Arguments& arguments);
  // One for every combination of --altitude, --mass, --cg-sl, --flap, --rotor-rpm and --isa-offset, in that order.
  static std::vector<SetupOptions> every_combination(const Arguments& arguments);

  FlightSetup<double> flight_setup(double mast_deg) const;
  // Throws UsageError when the model refuses the combination.
  Configuration<double> configuration(double mast_deg) const;
  // With another rotor speed, rad/s.
  Configuration<double> configuration(double mast_deg, double rotor_speed) const;
  // What was given of altitude, mass, CG, flaps and air, for a message: ", 3000 m, 6000 kg, CG at 300 in".
  std::string text() const;
  // The aircraft, its switches, air and engines as they differ from the default, for the column `model`.
  std::string model() const;
  const ModelChoice& model_choice() const { return switches_; }
  // Air and engines that were asked for, around a configuration prepared without.
  void surround(Configuration<double>& c) const;
  // The same in other air, K, on so many engines.
  SetupOptions on_day(double isa_offset, int engines) const;
  double warmer() const { return isa_offset_.value_or(0); }  // air, than the standard atmosphere, K
  int engines() const;                                       // that run
  bool some_engines_stand() const;
  const Options& switches() const { return switches_; }
  const Aircraft<double>& aircraft() const;  // with the tables that --tables chooses
  // What was given for a column of settings or kWarmerColumn, in its unit: 300 for cg_sl_in.
  std::optional<double> given(const std::string& column) const;

 private:
  struct Common {};
  SetupOptions(const Arguments& arguments, Common);

  std::optional<double> altitude_;
  std::optional<double> flap_deg_;
  std::optional<double> rotor_rpm_;
  std::optional<double> mass_;
  std::optional<double> cg_sl_in_;
  std::optional<double> isa_offset_;
  int engines_ = 0;  // that run; 0: all
  ModelChoice switches_;
};

// Throws UsageError "<where>..." when the model refuses the combination.
Configuration<double> prepared(const Aircraft<double>& aircraft, const FlightSetup<double>& setup,
                               const std::string& where = "");

// --mast, of which some commands take one value and some several.
OptionList mast_option();

struct FlightCase {
  std::size_t setup;  // among the setups of the command line
  double mast_deg;
  SteadyFlight<double> flight;
  double climb_deg, sideslip_deg, turn_rate_degps;  // as given
  std::optional<double> azimuth_deg;                // of the wind, instead of the sideslip
  TrimTargets targets;
};

// Every combination of so many setups, --climb, --sideslip or --azimuth, --turn-rate, targets, --mast and --speed, in
// that order. Throws UsageError for a single flight that cannot be (impossible_flight.hpp).
OptionList flight_list();
std::vector<FlightCase> flight_cases(const Arguments& arguments, std::size_t setups = 1);

}  // namespace tiltrotor::cli

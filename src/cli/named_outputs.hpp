// Outputs by name: what instruments read, load factors at stations, loads of components.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/airframe_outputs.hpp"
#include "cli/arguments.hpp"

namespace tiltrotor::cli {

struct NamedOutput {
  std::string name, unit;
  int reading;  // among Instruments; -1: `output`
  AirframeOutput output;
};

// "airspeed", "flight_path_angle", "nz", "nz@230/0/75" (SL, BL, WL, in), "b1c_R", "htail_moment_y"; nothing for another
// name. Throws UsageError "<where>: ..." for a station that is none.
std::optional<NamedOutput> output_named(const std::string& name, const std::string& where);

// Names that can be listed: all but those of stations.
std::vector<std::string> output_names();
// Of these the few that are neither states nor loads.
std::vector<std::string> short_output_names();

// What a list of names may hold besides, for messages and help.
inline constexpr const char* kOtherOutputs =
    "nx@SL/BL/WL, ny@.., nz@.. (load factors at a station in inches), a state as b1c_R, or htail_force_z, htail_moment_y, .. of "
    "a component of `loads`";

// --outputs A,B,..: none where it is not given.
OptionList outputs_option();
std::vector<NamedOutput> chosen_outputs(const Arguments& arguments);

}  // namespace tiltrotor::cli

// The model's switches by name: `--option name=value`.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tiltrotor/model/setup/configuration.hpp"

namespace tiltrotor::cli {

// The model's switches, and whether the tables are the C2 fit: the library looks that up as c1, in another aircraft.
struct ModelChoice : Options {
  bool c2_tables = false;
};
ModelChoice choice_of(const Configuration<double>& c);

// Every switch with its values, the default first; for help and messages.
std::string model_options_help();

// The name of every switch, and its values as the help has them: "c1|linear|c2", "0..10".
std::vector<std::pair<std::string, std::string>> model_option_values();

// The aircraft and what differs from the defaults, "XV-15 grid=realtime": rows of states carry it in this column.
inline constexpr const char* kModelColumn = "model";
std::string model_text(const ModelChoice& model);
// Behind it, where they are not the default: air and engines, "isa_offset=30 engines=1".
inline constexpr const char* kIsaOffsetWord = "isa_offset";
inline constexpr const char* kEnginesWord = "engines";

// Every switch and its value.
std::vector<std::pair<std::string, std::string>> model_switches(const ModelChoice& model);

// Throws UsageError "<where>: ..." for an unknown name or value.
void set_model_option(ModelChoice& model, const std::string& name, const std::string& value,
                      const std::string& where);

}  // namespace tiltrotor::cli

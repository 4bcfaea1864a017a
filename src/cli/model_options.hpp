// The model's switches by name: `--option name=value`.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tiltrotor/model/variables/options.hpp"

namespace tiltrotor::cli {

// Every switch with its values, the default first; for help and messages.
std::string model_options_help();

// The name of every switch, and its values as the help has them: "c1|linear", "0..10".
std::vector<std::pair<std::string, std::string>> model_option_values();

// The aircraft and what differs from the defaults, "XV-15 grid=realtime": rows of states carry it in this column.
inline constexpr const char* kModelColumn = "model";
std::string model_text(const Options& options);

// Every switch and its value.
std::vector<std::pair<std::string, std::string>> model_switches(const Options& options);

// Throws UsageError "<where>: ..." for an unknown name or value.
void set_model_option(Options& options, const std::string& name, const std::string& value,
                      const std::string& where);

}  // namespace tiltrotor::cli

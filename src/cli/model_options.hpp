// The model's switches by name: `--option name=value`.
#pragma once

#include <string>

#include "tiltrotor/model/variables/options.hpp"

namespace tiltrotor::cli {

// Every switch with its values, the default first; for help and messages.
std::string model_options_help();

// Throws UsageError "<where>: ..." for an unknown name or value.
void set_model_option(Options& options, const std::string& name, const std::string& value,
                      const std::string& where);

}  // namespace tiltrotor::cli

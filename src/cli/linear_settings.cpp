#include "cli/linear_settings.hpp"

#include "cli/flight_options.hpp"
#include "cli/model_options.hpp"
#include "cli/state_columns.hpp"

namespace tiltrotor::cli {

LinearSettings::LinearSettings(const Configuration<double>& c) : switches(model_switches(choice_of(c))) {
  const FlightSetup<double>& setup = c.setup;
  for (const char* column : {"mast_deg", "flap_deg", "rotor_rpm", "mass_kg", "cg_sl_in"})
    numbers.push_back({column, setting_value(column, setup)});
  numbers.push_back({"cg_wl_in", setup.wl_cg / kInch});
  numbers.push_back({"altitude_m", setting_value("altitude_m", setup)});
}

}  // namespace tiltrotor::cli

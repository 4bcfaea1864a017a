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
  numbers.push_back({"isa_offset_k", c.around.warmer});
  numbers.push_back({"engines", static_cast<double>(c.aircraft->controls.engines)});
}

void LinearSettings::add(const TrimmedFlight& flight) {
  numbers.push_back({"climb_deg", flight.climb_deg});
  numbers.push_back({"sideslip_deg", flight.sideslip_deg});
  numbers.push_back({"turn_rate_degps", flight.turn_rate_degps});
  if (flight.azimuth_deg) numbers.push_back({"azimuth_deg", *flight.azimuth_deg});
  std::string hold, free;
  for (const TrimTarget& target : flight.targets) {
    if (target.option == "--bank") {
      numbers.push_back({"bank_deg", target.value});
    } else if (target.option == "--load-factor") {
      numbers.push_back({"load_factor", target.value});
    } else if (target.option == "--ball") {
      words.emplace_back("ball", "centred");
    } else {
      hold += (hold.empty() ? "" : " ") + target.held + "=" + number_text(target.value);
      free += (free.empty() ? "" : " ") + target.freed;
    }
  }
  if (hold.empty()) return;
  words.emplace_back("hold", hold);
  words.emplace_back("free", free);
}

}  // namespace tiltrotor::cli

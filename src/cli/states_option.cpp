#include "cli/states_option.hpp"

#include "cli/errors.hpp"

namespace tiltrotor::cli {

OptionList states_option() {
  return {{"--states", "FILE",
           "CSV of states: u v w p q r phi theta psi, b1c_R b1s_R db1c_R\n"
           "db1s_R n0_R nc_R ns_R, the same with _L, eps, and controls\n"
           "th75_rad lon_in lat_in ped_in, in any order; SI units, radians,\n"
           "inches from neutral; optional: case, mast_deg, d_* (ignored)"}};
}

StateFile given_states(const Arguments& arguments, const SetupOptions& setup) {
  if (!arguments.given("--states")) throw UsageError(arguments.command() + ": --states FILE is needed");
  StateFile file = read_state_file(arguments.text("--states", ""), setup.switches());
  for (const char* name : {"--speed", "--climb", "--sideslip", "--turn-rate"}) {
    if (arguments.given(name)) throw UsageError(arguments.where(name) + ": cannot be combined with --states");
  }
  if (file.has_mast && arguments.given("--mast")) {
    throw UsageError(arguments.where("--mast") + ": " + file.path + " has its own column mast_deg");
  }
  const double mast_deg = arguments.number("--mast", 0, kMastRange);
  for (StateRow& row : file.rows) row.mast_deg = row.mast_deg.value_or(mast_deg);
  return file;
}

}  // namespace tiltrotor::cli

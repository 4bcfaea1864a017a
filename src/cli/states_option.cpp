#include "cli/states_option.hpp"

#include <cstdio>

#include "cli/derived_columns.hpp"
#include "cli/errors.hpp"
#include "cli/model_options.hpp"

namespace tiltrotor::cli {

namespace {

std::string path_of_states(const Arguments& arguments) {
  std::string path = arguments.text("--states", "");
  if (!arguments.given("--states")) throw UsageError(arguments.command() + ": --states FILE is needed");
  if (path.empty()) throw UsageError(arguments.where("--states") + ": the name is empty; give a file");
  return path;
}

struct Setting {
  const char* option;
  const char* column;
  Target::Kind kind;
};
constexpr Setting settings[] = {
    {"--mast", "mast_deg", Target::Kind::mast}, {"--altitude", "altitude_m", Target::Kind::altitude},
    {"--flap", "flap_deg", Target::Kind::flap}, {"--rotor-rpm", "rotor_rpm", Target::Kind::rotor_speed},
    {"--mass", "mass_kg", Target::Kind::mass},  {"--cg-sl", "cg_sl_in", Target::Kind::sl_cg},
};

// Air and engines are those of the row; an option may say the same.
StateFile::See refuse_another_day(const Arguments& arguments) {
  return [&arguments](const StateRow& row, const std::string& where) {
    if (!row.isa_offset) return;
    const auto refuse = [&](const char* option, const char* word, double of_row) {
      if (!arguments.given(option) || arguments.number(option, 0, isa_offset_range()) == of_row) return;
      throw UsageError(arguments.where(option) + ": " + where + " was made with " + word + "=" +
                       number_text(of_row) + ", and is read so: leave the option out");
    };
    refuse("--isa-offset", kIsaOffsetWord, *row.isa_offset);
    refuse("--engines", kEnginesWord, *row.engines);
  };
}

}  // namespace

OptionList states_option() {
  return {
      {"--states", "FILE",
       "CSV (- is standard input) of states: u v w p q r phi theta psi,\n"
       "b1c_R b1s_R db1c_R db1s_R n0_R nc_R ns_R, the same with _L, eps,\n"
       "and controls th75_rad lon_in lat_in ped_in, in any order; SI\n"
       "units, radians, inches from neutral; or as trim and respond print.\n"
       "Optional: case, mast_deg, altitude_m, flap_deg, rotor_rpm,\n"
       "mass_kg, cg_sl_in; what follows from these (speed_mps,\nalpha_deg, ...) must agree with them; loads, "
       "status, d_* are\nnot read; isa_offset and engines of `model` are those of the row,\nanother grid, table or switch than --grid, "
       "--tables and --option\nchoose is told on stderr"}};
}

GivenStates::GivenStates(const Arguments& arguments, const SetupOptions& setup)
    : setup_(setup),
      mast_deg_(arguments.number("--mast", 0, kMastRange)),
      file_(path_of_states(arguments), setup.switches(), refuse_another_day(arguments)),
      model_(model_text(setup.model_choice())) {
  for (const char* name : {"--speed", "--climb", "--sideslip", "--azimuth", "--turn-rate", "--bank",
                           "--load-factor", "--ball", "--hold", "--free"}) {
    if (arguments.given(name)) throw UsageError(arguments.where(name) + ": cannot be combined with --states");
  }
  for (const Setting& s : settings) {
    if (file_.has(s.kind) && arguments.given(s.option))
      throw UsageError(arguments.where(s.option) + ": " + file_.path() + " has its own column " + s.column);
  }
}

int GivenStates::each(const Shard& shard, const Visit& visit) {
  int exit_status = exit_success;
  file_.each(shard.begin(file_.size()), shard.end(file_.size()), [&](StateRow& row) {
    const Configuration<double> c = configuration(row);
    compare_models(row);
    if (row.fault.empty()) row.fault = contradiction(row, file_, c);
    if (!row.fault.empty()) {
      std::fprintf(stderr, "tiltrotor: %s:%zu: %s\n", file_.path().c_str(), row.line, row.fault.c_str());
      exit_status = exit_case_failed;
    }
    const int visited = visit(row, c);
    if (visited != exit_success) exit_status = visited;
  });
  return exit_status;
}

// A line for the rows of one other model.
void GivenStates::compare_models(const StateRow& row) {
  if (row.model.empty() || row.model == model_ || row.model == told_) return;
  told_ = row.model;
  std::fprintf(
      stderr,
      "tiltrotor: %s:%zu: made with another model, '%s'; computed with '%s', which --grid, --tables and "
      "--option choose\n",
      file_.path().c_str(), row.line, row.model.c_str(), model_.c_str());
}

Configuration<double> GivenStates::configuration(const StateRow& row) const {
  FlightSetup<double> setup = setup_.flight_setup(row.mast_deg.value_or(mast_deg_));
  setup.altitude = row.altitude.value_or(setup.altitude);
  setup.flap_deg = row.flap_deg.value_or(setup.flap_deg);
  setup.rotor_speed = row.rotor_speed.value_or(setup.rotor_speed);
  setup.mass = row.mass.value_or(setup.mass);
  setup.sl_cg = row.sl_cg.value_or(setup.sl_cg);
  Configuration<double> c =
      prepared(setup_.aircraft(), setup, file_.path() + ":" + std::to_string(row.line) + ": ");
  if (row.isa_offset) {
    setup_.on_day(*row.isa_offset, *row.engines).surround(c);
  } else {
    setup_.surround(c);
  }
  return c;
}

}  // namespace tiltrotor::cli

// `tiltrotor modes`: eigenvalues with names.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

#include "cli/command.hpp"
#include "cli/errors.hpp"
#include "cli/feedback.hpp"
#include "cli/figure.hpp"
#include "cli/flight_records.hpp"
#include "cli/governed.hpp"
#include "cli/linear_options.hpp"
#include "cli/mode_shapes.hpp"
#include "tiltrotor/analysis/linear/mode_tracker.hpp"

namespace tiltrotor::cli {

namespace {

const std::vector<std::string> columns = {
    "mast_deg",   "speed_mps",       "axis",          "mode",           "real",
    "imag",       "frequency_rad_s", "damping_ratio", "time_to_half_s", "status",
    "altitude_m", "mass_kg",         "cg_sl_in",      "branch",         "flap_deg"};
// Besides, of a reduced model: the root of the full one, and how far it is from there, of its size.
const std::vector<std::string> reduced_columns = {"full_real", "full_imag", "root_error"};
const std::vector<std::string> shape_columns = {
    "mast_deg",   "speed_mps", "axis",      "mode",      "real",          "imag",
    "state",      "unit",      "magnitude", "angle_deg", "participation", "status",
    "altitude_m", "mass_kg",   "cg_sl_in",  "flap_deg",  "normalised_by"};

enum class Show : unsigned char { modes, shapes };

std::vector<std::string> columns_of(Show show, bool reduced) {
  if (show == Show::shapes) return shape_columns;
  std::vector<std::string> all = columns;
  if (reduced) all.insert(all.end(), reduced_columns.begin(), reduced_columns.end());
  return all;
}

// Branches are followed along a sweep of speed, or of mast angle at one speed, and numbered through it. A
// shard begins with the sweep, to find the same numbers.
bool same_sweep(const FlightCase& a, const FlightCase& b) {
  const auto same_targets = [](const TrimTarget& x, const TrimTarget& y) {
    return x.held == y.held && x.value == y.value;
  };
  return a.setup == b.setup && a.climb_deg == b.climb_deg && a.sideslip_deg == b.sideslip_deg &&
         a.azimuth_deg == b.azimuth_deg && a.turn_rate_degps == b.turn_rate_degps &&
         std::equal(a.targets.begin(), a.targets.end(), b.targets.begin(), b.targets.end(), same_targets) &&
         (a.mast_deg == b.mast_deg || a.flight.speed == b.flight.speed);
}

// Steps of a sweep beyond these connect nothing.
constexpr double longest_speed_step = 10;  // m/s
constexpr double longest_mast_step = 10;   // deg

bool neighbours(const TrimmedFlight& flight, double mast_deg, double speed) {
  return std::abs(flight.flight.speed - speed) <= longest_speed_step &&
         std::abs(flight.mast_deg - mast_deg) <= longest_mast_step;
}

void add_row(FlightRecords& records, const TrimmedFlight& flight, const char* status,
             const Mode<double>* mode = nullptr, const char* axis = nullptr,
             const std::vector<double>& beside = {}) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  Row row = {as_given(flight.mast_deg), as_given(flight.flight.speed)};
  const Row numbers = mode != nullptr ? Row{axis != nullptr ? axis : axis_word(mode->axis),
                                            mode->name,
                                            mode->real,
                                            mode->imag,
                                            mode->frequency,
                                            mode->damping_ratio,
                                            mode->time_to_half}
                                      : Row{"", "", nothing, nothing, nothing, nothing, nothing};
  row.insert(row.end(), numbers.begin(), numbers.end());
  const double branch = mode != nullptr && mode->branch > 0 ? mode->branch : nothing;
  for (const Cell& cell :
       Row{status, as_given(flight.setting("altitude_m")), as_given(flight.setting("mass_kg")),
           as_given(flight.setting("cg_sl_in")), branch, as_given(flight.setting("flap_deg"))})
    row.push_back(cell);
  row.insert(row.end(), beside.begin(), beside.end());
  records.add(flight, row);
}

// What can be written of a flight, in the columns that were chosen.
class ModeRows {
 public:
  ModeRows(const Arguments& arguments, const std::vector<SetupOptions>& setups, Output& output)
      : show_(static_cast<Show>(arguments.choice("--show", "modes", {"modes", "shapes"}))),
        reduced_(wants_rigid(arguments)),
        normalising_(normalising_state(arguments)),
        figure_(arguments),
        records_(arguments, setups, output, columns_of(show_, reduced_), Output::to_read) {
    if (arguments.given("--normalise") && show_ != Show::shapes && !figure_.wanted())
      throw UsageError(arguments.where("--normalise") + ": goes with --show shapes or --figure");
  }

  void add_failed(const TrimmedFlight& flight, const char* status) {
    if (show_ == Show::modes) return add_row(records_, flight, status, nullptr, nullptr, nothing_beside());
    add_shape_row(flight, {"", "", nothing, nothing, "", {}}, {"", "", false, nothing, nothing, nothing},
                  status);
  }

  // `full`: the roots of the full model by eigenvalue of a reduced one.
  void add(const TrimmedFlight& flight, const ModeSet<double>& set, const FullRoot<double>* full) {
    for (int i = 0; i < set.count && show_ == Show::modes; ++i) {
      const Mode<double>& m = set.mode[i];
      add_row(records_, flight, trim_status_word(flight.trim.status), &m, nullptr,
              beside(full, m.eigenvalue));
    }
    if (wants_shapes()) add_shapes(flight, shapes_of(set, normalising_));
  }

  // Modes of a model with systems, on an axis of their own; no branches.
  void add(const TrimmedFlight& flight, const VehicleModes<double>& modes, const VehicleShape& shape,
           const FullRoot<double>* full, Analyses& work) {
    for (int i = 0; i < modes.count && show_ == Show::modes; ++i) {
      const VehicleMode<double>& m = modes.mode[i];
      Mode<double> shown{};
      shown.real = m.real;
      shown.imag = m.imag;
      shown.frequency = m.frequency;
      shown.damping_ratio = m.damping_ratio;
      shown.time_to_half = m.time_to_half;
      shown.axis = m.axis;
      std::copy(std::begin(m.name), std::end(m.name), std::begin(shown.name));
      add_row(records_, flight, trim_status_word(flight.trim.status), &shown,
              m.is_system ? "system" : nullptr, beside(full, m.eigenvalue));
    }
    if (wants_shapes()) add_shapes(flight, shapes_of(modes, vehicle_eigensystem(work), shape, normalising_));
  }

  void finish() {
    records_.finish();
    figure_.draw("Shapes of the modes of the rigid body", diagrams_);
  }

 private:
  static constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> nothing_beside() const {
    return std::vector<double>(reduced_ ? reduced_columns.size() : 0, nothing);
  }
  static std::vector<double> beside(const FullRoot<double>* full, int eigenvalue) {
    if (full == nullptr) return {};
    return {full[eigenvalue].real, full[eigenvalue].imag, full[eigenvalue].error};
  }
  bool wants_shapes() const { return show_ == Show::shapes || figure_.wanted(); }

  void add_shapes(const TrimmedFlight& flight, const std::vector<NamedShape>& shapes) {
    for (const NamedShape& shape : shapes) {
      for (const ShapeEntry& entry : shape.entry)
        if (show_ == Show::shapes) add_shape_row(flight, shape, entry, trim_status_word(flight.trim.status));
      const bool of_body = shape.axis == "longitudinal" || shape.axis == "lateral";
      if (!figure_.wanted() || !of_body || shape.mode == kind_word(ModeKind::downwash)) continue;
      diagrams_.push_back(phasor_diagram(
          shape,
          "mast " + number_text(flight.mast_deg, 4) + " deg, " + number_text(flight.flight.speed, 4) + " m/s",
          diagrams_.size()));
    }
  }

  void add_shape_row(const TrimmedFlight& flight, const NamedShape& shape, const ShapeEntry& entry,
                     const char* status) {
    records_.add(flight, {as_given(flight.mast_deg), as_given(flight.flight.speed), shape.axis, shape.mode,
                          shape.real, shape.imag, entry.state, entry.unit, entry.magnitude, entry.angle_deg,
                          entry.participation, status, as_given(flight.setting("altitude_m")),
                          as_given(flight.setting("mass_kg")), as_given(flight.setting("cg_sl_in")),
                          as_given(flight.setting("flap_deg")), shape.reference});
  }

  Show show_;
  bool reduced_;
  int normalising_;
  Figure figure_;
  FlightRecords records_;
  std::vector<plot::Plot> diagrams_;
};

// Modes of a model with a governor or SCAS, full or reduced.
struct SystemModes {
  const Feedback& feedback;
  bool reduced;
  Reduction order;
  Eigenvalues<double, kMaxVehicleStates> full{};
  FullRoot<double> full_root[kMaxVehicleStates]{};
  std::unique_ptr<VehicleMatrices> matrices = std::make_unique<VehicleMatrices>();
  std::unique_ptr<VehicleModes<double>> modes = std::make_unique<VehicleModes<double>>();

  Status find(const TrimmedFlight& flight, bool scas, Analyses& work) {
    Status status = feedback.linearize_governed(flight.configuration, flight.trim.state, flight.trim.controls,
                                                ControlSet{}, work, *matrices, scas);
    if (status == Status::ok) status = vehicle_modes(*matrices, work, *modes);
    if (status != Status::ok || !reduced) return status;
    full = vehicle_eigensystem(work).values;
    status = reduce_to_rigid(*matrices, order);
    if (status == Status::ok) status = vehicle_modes(*matrices, work, *modes);
    if (status == Status::ok) find_full_roots(full, vehicle_eigensystem(work).values, full_root);
    return status;
  }
  const FullRoot<double>* full_roots() const { return reduced ? full_root : nullptr; }
};

// Modes of the airframe alone, of its full or of a reduced model.
class AirframeModes {
 public:
  AirframeModes(const Arguments& arguments, const Feedback& feedback)
      : feedback_(feedback), reduced_(wants_rigid(arguments)), order_(reduction_order(arguments)) {}

  Status find(const TrimmedFlight& flight, bool connects, Analyses& work) {
    const Configuration<double>& c = flight.configuration;
    const State<double>& x = flight.trim.state;
    const Controls<double>& u = flight.trim.controls;
    Status status = feedback_.is_given() ? feedback_.linearize(c, x, u, ControlSet{}, work, *model_, nullptr)
                                         : linearize(c, x, u, ControlSet{}, work, *model_);
    if (status == Status::ok && reduced_) status = modes(*model_, *workspace_, *full_);
    if (status == Status::ok && reduced_) status = reduce_to_rigid(*model_, order_);
    if (status == Status::ok) status = tracker.find(*model_, connects);
    if (status == Status::ok && reduced_) find_full_roots(*full_, tracker.found(), full_root_);
    return status;
  }
  const FullRoot<double>* full_roots() const { return reduced_ ? full_root_ : nullptr; }

  ModeTracker<double> tracker;

 private:
  const Feedback& feedback_;
  bool reduced_;
  Reduction order_;
  std::unique_ptr<LinearModel<double>> model_ = std::make_unique<LinearModel<double>>();
  std::unique_ptr<ModesWorkspace<double>> workspace_ = std::make_unique<ModesWorkspace<double>>();
  std::unique_ptr<ModeSet<double>> full_ = std::make_unique<ModeSet<double>>();
  FullRoot<double> full_root_[kMaxLinearStates];
};

int run(const Arguments& arguments) {
  const std::vector<SetupOptions> setups = SetupOptions::every_combination(arguments);
  const bool scas = wants_scas(arguments);
  const bool has_systems = scas || setups.front().switches().governor != Governor::off;
  require_no_positions(setups.front().switches(), arguments);
  flight_cases(arguments, setups.size());
  const Feedback feedback(arguments, setups.front().switches(), scas);
  Output output(arguments);
  ModeRows rows(arguments, setups, output);
  const AnalysesWorkspace work;
  SystemModes with_systems{feedback, wants_rigid(arguments), reduction_order(arguments)};
  AirframeModes airframe(arguments, feedback);
  double mast_before = 0;
  double speed_before = 0;
  const auto visit = [&](const TrimmedFlight& flight) -> int {
    const TrimResult<double>& trim = flight.trim;
    const bool connects = flight.connects && neighbours(flight, mast_before, speed_before);
    mast_before = flight.mast_deg;
    speed_before = flight.flight.speed;
    if (!flight.connects) airframe.tracker.begin_sweep();
    if (!is_trimmed(trim.status)) {
      airframe.tracker.lose_track();
      if (!flight.is_preliminary) rows.add_failed(flight, trim_status_word(trim.status));
      return exit_case_failed;
    }
    if (has_systems && flight.is_preliminary) return exit_success;
    const Status status =
        has_systems ? with_systems.find(flight, scas, *work) : airframe.find(flight, connects, *work);
    if (flight.is_preliminary) return exit_success;
    if (status == Status::ok) {
      if (has_systems) {
        rows.add(flight, *with_systems.modes, with_systems.matrices->shape, with_systems.full_roots(), *work);
      } else {
        rows.add(flight, airframe.tracker.found(), airframe.full_roots());
      }
      return exit_success;
    }
    rows.add_failed(flight, status_word(status));
    std::fprintf(stderr, "tiltrotor: %s: %s\n", flight.where.c_str(), status_text(status));
    return exit_case_failed;
  };
  const int exit_status = for_each_trim(arguments, setups, output.shard(), *work, visit, same_sweep);
  rows.finish();
  return exit_status;
}

}  // namespace

Command modes_command() {
  return {
      "modes",
      "eigenvalues of A with names, frequency and damping",
      "One row for every real root or conjugate pair, longitudinal, lateral, then rotor, slow modes\n"
      "first. A negative time_to_half_s is the time to double. The name of a mode comes from its matrix\n"
      "alone, from the states that take part. Which mode of one row continues which of another is the\n"
      "number `branch`: followed along a sweep of speed at one mast angle (of mast angle at one speed) in\n"
      "steps of at most 10 m/s (10 deg). Where a pair falls apart into two real roots, and at a flight\n"
      "without a trim, branches end. A shard follows them from the beginning of its sweep.\n"
      "--reduce shows beside each root that of the full model it stands for, and the distance over its size; states of\n"
      "systems stay.\n"
      "--show shapes: one row for every mode and state: magnitude and angle (ahead positive) of the eigenvector\n"
      "over those of the state `normalised_by`, in the units of the model, and how much the state takes part,\n"
      "all states together 1. Rotors stand as mean and difference of right and left.\n"
      "Everything that describes the flight takes a value, a list or a range; so do --altitude, --mass, --cg-sl,\n"
      "--flap, --rotor-rpm and --isa-offset.\n",
      "tiltrotor modes --mast 30,60,90 --speed 60",
      OptionList{{"--show", "KIND", "modes or shapes (modes)"}} + normalise_option() +
          figure_option("phasor diagrams of the rigid body's modes as SVG") + reduce_option() +
          scas_option() + feedback_option() + flight_list() + SetupOptions::list() + Output::list(),
      run};
}

}  // namespace tiltrotor::cli

// Case-by-case comparison with tests/reference/, the outputs of a second, independent implementation of the
// same equations on the same tables: rotor loads, component loads, state derivatives, with C1 and with linear
// tables. The files give 12 digits. A difference counts relative to the number itself, or to a thousandth of
// the largest number of its kind in the same case, whichever is larger.
//
// That implementation converts units with eight digits (1 slug = 14.593903 kg, 1 lbf = 4.4482216 N). With the
// same rounding in the masses, inertias and the hub spring the two agree to the digits of the files; as built
// they agree to that rounding, amplified where large terms cancel.
#include <algorithm>
#include <string>
#include <vector>

#include "csv_file.hpp"
#include "flight_cases.hpp"
#include "tiltrotor/model/variables/presets.hpp"

using namespace flight_cases;

namespace {

bool are_alike(const Variable& a, const Variable& b) {
  using K = VariableKind;
  const auto is_inflow = [](const Variable& v) {
    return v.kind == K::mean_inflow || v.kind == K::cyclic_inflow;
  };
  if (a.side != b.side) return false;
  if (is_inflow(a)) return is_inflow(b);
  return a.kind == b.kind && (a.kind == K::speed || a.kind == K::body_rate || a.kind == K::gimbal_rate);
}

constexpr double kRoundedTolerance = 1e-10;
constexpr double kTolerance = 1e-6;

Aircraft<double> with_rounded_units() {
  Aircraft<double> a = aircraft();
  const double slug = 14.593903 / (0.45359237 * 9.80665 / 0.3048);
  const double pound = 4.4482216 / (0.45359237 * 9.80665);
  a.rotor.flap_inertia *= slug;
  a.rotor.hub_spring *= pound;
  a.mass.gross *= pound;
  a.mass.nacelles_quoted *= pound;
  for (Inertia<double>* i : {&a.mass.inertia, &a.mass.inertia_slope}) {
    i->xx *= slug;
    i->yy *= slug;
    i->zz *= slug;
    i->xz *= slug;
  }
  return a;
}

// The aircraft of a replay and the agreement to ask of it.
struct Replay {
  Aircraft<double> aircraft;
  double tolerance;
};

Options table_options(const std::string& tables) {
  Options options = reference_options();
  options.tables = tables == "c1" ? Interpolation::c1 : Interpolation::linear;
  return options;
}

class Difference {
 public:
  explicit Difference(double tolerance) : tolerance_(tolerance) {}
  void add(double actual, double expected, double kind_scale, const std::string& where) {
    const double scale = std::max(std::abs(expected), 1e-3 * kind_scale);
    const double relative = scale > 0 ? std::abs(actual - expected) / scale : std::abs(actual);
    CHECK_LE(relative, tolerance_);
    ++count_;
    if (!(relative <= largest_)) {
      largest_ = relative;
      where_ = where;
    }
  }
  void note(const std::string& file) const {
    NOTE(file << ": " << count_ << " numbers, largest relative difference " << largest_ << " at " << where_);
  }
  int count() const { return count_; }

 private:
  double tolerance_;
  double largest_ = 0;
  std::string where_ = "none";
  int count_ = 0;
};

std::string place(const check::CsvFile& file, int row, const std::string& column) {
  return "case " + file.text(row, "case") + " " + column;
}

void replay_rotor_loads(const Replay& replay, const std::string& tables) {
  const std::string name = "tests/reference/rotor_loads_" + tables + ".csv";
  const check::CsvFile file(name);
  Difference difference(replay.tolerance);
  for (int row = 0; row < file.rows(); ++row) {
    const auto at = [&](const char* column) { return file.number(row, column); };
    FlightSetup<double> setup = flight_setup(replay.aircraft, at("mast_deg_for_coning"));
    setup.rotor_speed = at("rpm") * 2 * kPi<double> / 60;
    setup.options = table_options(tables);
    Configuration<double> c;
    if (!CHECK(prepare(replay.aircraft, setup, c) == Status::ok)) return;
    CHECK_NEAR(c.coning, at("b0_deg") * kRadPerDeg<double>, 1e-12);

    RotorInput<double> in{};
    in.velocity_a = {at("Vx_A"), at("Vy_A"), at("Vz_A")};
    in.rates_a = {at("wx_A"), at("wy_A"), at("wz_A")};
    in.state = {at("b1c"), at("b1s"), at("db1c"), at("db1s"), at("n0"), at("nc"), at("ns")};
    in.coning = {at("b0_deg") * kRadPerDeg<double>, 0};
    in.collective = at("th75_rad");
    in.lateral_cyclic = at("A1_rad");
    in.long_cyclic = at("B1_rad");
    const RotorResponse<double> out = rotor_response(c, in, c.azimuth);
    const RotorLoads<double> harmonics = rotor_loads(c, in, c.azimuth);

    struct Entry {
      const char* column;
      double value;
      double kind_scale;
    };
    const double force = std::abs(at("Fz_A_n"));
    const double moment = std::abs(at("M0_nm"));
    const double flap = std::hypot(at("dd_b1c"), at("dd_b1s"));
    const double inflow = std::max({std::abs(at("d_n0")), std::abs(at("d_nc")), std::abs(at("d_ns"))});
    for (const Entry& e :
         {Entry{"Fx_A_n", out.loads.force_a.x, force}, Entry{"Fy_A_n", out.loads.force_a.y, force},
          Entry{"Fz_A_n", out.loads.force_a.z, force}, Entry{"Q_nm", out.loads.torque, moment},
          Entry{"Mc_nm", harmonics.mc, moment}, Entry{"Ms_nm", harmonics.ms, moment},
          Entry{"M0_nm", harmonics.m0, moment}, Entry{"d_b1c", out.flapping.b1c_rate, 0},
          Entry{"d_b1s", out.flapping.b1s_rate, 0}, Entry{"dd_b1c", out.flapping.b1c_acceleration, flap},
          Entry{"dd_b1s", out.flapping.b1s_acceleration, flap}, Entry{"d_n0", out.inflow.lambda_0, inflow},
          Entry{"d_nc", out.inflow.lambda_c, inflow}, Entry{"d_ns", out.inflow.lambda_s, inflow}}) {
      difference.add(e.value, at(e.column), e.kind_scale, place(file, row, e.column));
    }
  }
  difference.note(name);
  CHECK_LT(0, difference.count());
}

struct ReferenceCase {
  Configuration<double> c;
  State<double> x;
  Controls<double> u;
};

ReferenceCase read_case(const Replay& replay, const check::CsvFile& file, int row,
                        const std::string& tables) {
  ReferenceCase r{};
  FlightSetup<double> setup = flight_setup(replay.aircraft, file.number(row, "mast_deg"));
  setup.options = table_options(tables);
  CHECK(prepare(replay.aircraft, setup, r.c) == Status::ok);
  int i = 0;
  State<double>::each(r.x, [&](double& x) {
    if (i <= kStateIndex.downwash) x = file.number(row, kStateVariables[i].name);
    ++i;
  });
  r.u.collective = file.number(row, "th75_rad");
  r.u.long_stick = file.number(row, "lon_in");
  r.u.lat_stick = file.number(row, "lat_in");
  r.u.pedal = file.number(row, "ped_in");
  return r;
}

void replay_state_derivatives(const Replay& replay, const std::string& tables) {
  const std::string name = "tests/reference/state_derivatives_" + tables + ".csv";
  const check::CsvFile file(name);
  Difference difference(replay.tolerance);
  for (int row = 0; row < file.rows(); ++row) {
    const ReferenceCase r = read_case(replay, file, row, tables);
    State<double> rates;
    derivative(r.c, r.x, r.u, rates);
    const auto actual = flat(rates);
    for (int i = 0; i <= kStateIndex.downwash; ++i) {
      const std::string column = std::string("d_") + kStateVariables[i].name;
      // Beside the others of its kind: velocities, rates, flap accelerations and inflow of one rotor.
      double kind = 0;
      for (int k = 0; k <= kStateIndex.downwash; ++k) {
        if (are_alike(kStateVariables[i], kStateVariables[k]))
          kind = std::max(kind, std::abs(file.number(row, std::string("d_") + kStateVariables[k].name)));
      }
      difference.add(actual[static_cast<std::size_t>(i)], file.number(row, column), kind,
                     place(file, row, column));
    }
  }
  difference.note(name);
  CHECK_LT(0, difference.count());
}

void replay_component_loads(const Replay& replay, const std::string& tables) {
  const std::string name = "tests/reference/component_loads_" + tables + ".csv";
  const check::CsvFile states("tests/reference/state_derivatives_" + tables + ".csv");
  const check::CsvFile file(name);
  Difference difference(replay.tolerance);
  for (int row = 0; row < file.rows(); ++row) {
    const int state_row = static_cast<int>(file.number(row, "case"));
    if (!CHECK_EQ(states.number(state_row, "case"), file.number(row, "case"))) return;
    const ReferenceCase r = read_case(replay, states, state_row, tables);
    Evaluation<double> out;
    evaluate_aircraft(r.c, r.x, r.u, out);
    const std::string component = file.text(row, "component");
    Loads<double> loads{};
    bool known = false;
    for (int k = 0; k < component_count; ++k) {
      if (component != kComponentNames[k]) continue;
      loads = out.loads.component[k];
      known = true;
    }
    if (component == "total_aero") {
      for (const Loads<double>& l : out.loads.component) loads = loads + l;
      known = true;
    }
    if (!CHECK(known)) {
      NOTE("unknown component " << component);
      continue;
    }
    const char* const columns[6] = {"X_n", "Y_n", "Z_n", "L_nm", "M_nm", "N_nm"};
    const auto actual = flat(loads);
    for (std::size_t k = 0; k < 6; ++k) {
      double kind = 0;
      for (std::size_t j = 3 * (k / 3); j < 3 * (k / 3) + 3; ++j) {
        kind = std::max(kind, std::abs(file.number(row, columns[j])));
      }
      difference.add(actual[k], file.number(row, columns[k]), kind,
                     place(file, row, component + " " + columns[k]));
    }
  }
  difference.note(name);
  CHECK_LT(0, difference.count());
}

template <class Function>
void with_each_rounding(Function&& function) {
  NOTE("as built");
  function(Replay{aircraft(), kTolerance});
  NOTE("with the units rounded alike");
  function(Replay{with_rounded_units(), kRoundedTolerance});
}

}  // namespace

TEST_OF_XV15(reference_rotor_loads) {
  with_each_rounding([](const Replay& replay) {
    replay_rotor_loads(replay, "c1");
    replay_rotor_loads(replay, "linear");
  });
}
TEST_OF_XV15(reference_component_loads) {
  with_each_rounding([](const Replay& replay) {
    replay_component_loads(replay, "c1");
    replay_component_loads(replay, "linear");
  });
}
TEST_OF_XV15(reference_state_derivatives) {
  with_each_rounding([](const Replay& replay) {
    replay_state_derivatives(replay, "c1");
    replay_state_derivatives(replay, "linear");
  });
}

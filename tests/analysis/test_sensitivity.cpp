// How trims, matrices and roots move with a parameter, against differences of complete new trims and linear models.
//
// The differences are central ones over h and h/2, extrapolated (Richardson): what they leave out goes with h^4, and their
// rounding with the tolerance of a trim over h. The tolerances below are ten times what the two leave for the steps used.
#include <algorithm>

#include "analysis_case.hpp"
#include "tiltrotor/analysis/linear/model_motion.hpp"
#include "tiltrotor/analysis/linear/root_sensitivity.hpp"

using namespace analysis_case;
using Parameter = ConfigurationParameter;

namespace {

// A trimmed flight with its linear model.
struct Flight {
  Configuration<double> c;
  TrimResult<double> trim;
  LinearModel<double> model;
};

void fill(const SteadyFlight<double>& flight, Flight& p, const TrimResult<double>* near = nullptr) {
  static TrimWorkspace<double> trimming;
  static LinearizationWorkspace<double> work;
  if (near != nullptr) p.trim = *near;
  const TrimStatus status =
      near != nullptr ? trim_from(p.c, flight, trimming, p.trim) : trim(p.c, flight, trimming, p.trim);
  CHECK(is_trimmed(status));
  CHECK(linearize(p.c, p.trim.state, p.trim.controls, kInceptors, work, p.model) == Status::ok);
}

struct Motion {
  TrimMotion<double> trim;
  ModelMotion<double> model;
  Status status;
};

// Total derivatives by a parameter.
void find_motion(const SteadyFlight<double>& flight, const Flight& p, Parameter parameter, Motion& out) {
  static SensitivityWorkspace<double> columns;
  static ConfigurationSensitivity<double> column;
  static TrimMotionWorkspace<double> trims;
  static ModelMotionWorkspace<double> work;
  const State<double>& x = p.trim.state;
  const Controls<double>& u = p.trim.controls;
  CHECK(configuration_sensitivity(p.c, x, u, {1, {parameter}}, columns, column) == Status::ok);
  double rates[state_count];
  for (int i = 0; i < state_count; ++i) rates[i] = column.rates(i, 0);
  CHECK(prepare_trim_motion(p.c, flight, x, p.model, trims) == Status::ok);
  CHECK(trim_motion(rates, trims, out.trim) == Status::ok);
  out.status = model_motion(p.c, x, u, p.model, parameter, out.trim, work, out.model);
}

// What is compared: state, controls, power, A and B, all in one row.
using Numbers = std::vector<double>;
Numbers numbers(const Flight& p) {
  Numbers all(state_count + control_count);
  flatten(p.trim.state, all.data());
  flatten(p.trim.controls, all.data() + state_count);
  for (const double power : p.trim.power) all.push_back(power);
  for (int i = 0; i < p.model.states; ++i)
    for (int j = 0; j < p.model.states + p.model.controls; ++j)
      all.push_back(j < p.model.states ? p.model.a(i, j) : p.model.b(i, j - p.model.states));
  return all;
}
Numbers numbers(const LinearPoint<double>& point, const Motion& m) {
  Numbers all(state_count + control_count);
  flatten(m.trim.x, all.data());
  flatten(m.trim.u, all.data() + state_count);
  for (const double power : m.model.power) all.push_back(power);
  for (int i = 0; i < point.states; ++i)
    for (int j = 0; j < point.states + point.controls; ++j)
      all.push_back(j < point.states ? m.model.a(i, j) : m.model.b(i, j - point.states));
  return all;
}

// Step of the differences, in the unit of the parameter: so short that no blade element changes its place among the knots
// of a table, where the second derivative jumps.
double step_of(Parameter parameter) {
  switch (parameter) {
    case Parameter::altitude:
    case Parameter::mass:
      return 0.2;
    case Parameter::rotor_speed:
    case Parameter::rotor_difference:
      return 1e-3;
    case Parameter::mast:
    case Parameter::flap:
      return 4e-5;
    case Parameter::mast_rate:
    case Parameter::mast_acceleration:
    case Parameter::rotor_acceleration:
    case Parameter::sl_cg:
    case Parameter::wl_cg:
    case Parameter::air_density:
    case Parameter::hub_spring_factor:
    case Parameter::ground_wash_right:
    case Parameter::ground_wash_left:
    case Parameter::download:
      return 1e-4;
    case Parameter::speed_of_sound:
      return 0.01;
    default:
      return 2;
  }
}

Numbers difference(const SteadyFlight<double>& flight, const Flight& p, Parameter parameter, double h) {
  static Flight moved;
  const auto at = [&](double by) {
    moved_configuration(p.c, &parameter, &by, 1, moved.c);
    fill(flight, moved, &p.trim);
    return numbers(moved);
  };
  const Numbers above = at(h), below = at(-h), near_above = at(h / 2), near_below = at(-h / 2);
  Numbers out(above.size());
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = (8 * (near_above[i] - near_below[i]) - (above[i] - below[i])) / (6 * h);
  return out;
}

Flight& point_at(double mast_deg, const SteadyFlight<double>& flight, const Options& options) {
  static Flight p;
  p.c = flown_configuration(mast_deg, 300, options);
  ConfigurationSetting<double> setting = p.c.setup;
  setting.flap_deg += 3;  // off the settings of the tables
  CHECK(reconfigure(setting, p.c) == Status::ok);
  fill(flight, p);
  return p;
}

Options fast() {
  Options options;
  options.grid = BladeGrid::realtime;
  return options;
}

// Largest error of a step's change, over the size of the number or of the largest like it in its part of the row.
double worst_error(const Numbers& found, const Numbers& expected, const Numbers& base, double h) {
  double worst = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double size = std::max({std::abs(base[i]), std::abs(expected[i]) * h, 1e-3});
    const double error = std::abs(found[i] - expected[i]) * h / size;
    if (!(error <= worst)) worst = error;
  }
  return worst;
}

}  // namespace

// Mast angle, flap and speed lie between knots of the tables. In a turn and a climb every part of the trim moves.
TEST(sensitivity_of_trim_and_matrices_equals_differences_of_new_trims) {
  const SteadyFlight<double> flight = flown({52, 0.03, 0.05, 0.02});
  const Flight& p = point_at(37, flight, fast());
  const Numbers base = numbers(p);
  static Motion motion;
  double worst = 0;
  for (int k = 0; k < kConfigurationParameters; ++k) {
    const Parameter parameter = static_cast<Parameter>(k);
    const double h = step_of(parameter);
    find_motion(flight, p, parameter, motion);
    CHECK(motion.status == Status::ok);
    const double error = worst_error(numbers(p.model, motion), difference(flight, p, parameter, h), base, h);
    if (!CHECK_LT(error, 1e-9)) NOTE(facts(parameter).name << " " << error);
    worst = std::max(worst, error);
  }
  NOTE("largest error " << worst);
}

// Every switch behind which the model goes by another formula; with coning states there are more directions than one pass
// takes. In hover the derivative of the total speed is that of its smoothing.
TEST(sensitivity_under_other_switches_equals_differences_of_new_trims) {
  Options coning = fast();
  coning.coning_states = coning.flap_angular_acceleration = coning.lateral_cyclic = coning.stall_delay = true;
  coning.wash = WashFactor::vortex_cylinder;
  coning.engine_jets = true;
  Options other = fast();
  other.flapping = FlapOrder::first;
  other.inflow = InflowShape::uniform;
  other.tables = Interpolation::linear;
  other.side_by_side = other.sideward_flight = other.disk_plane_inflow = true;
  other.wake = WakeModel::gtrs_empirical;
  other.wake_load = WakeLoadFactor::gtrs;
  other.mast_drag = MastDrag::linear;
  other.wing_rate_velocity = other.tail_sideslip_loss = true;
  other.tail_wash = TailWash::closed_form;
  const SteadyFlight<double> forward = flown({52, 0.03, 0.05, 0.02}), hover = flown({0, 0, 0, 0});
  static Motion motion;
  for (const Options& options : {coning, other}) {
    for (const SteadyFlight<double>& flight : {forward, hover}) {
      // Hover stands on the knots at zero speed and sideslip, where linear tables have no derivative.
      if (flight.speed == 0 && options.tables == Interpolation::linear) continue;
      const Flight& p = point_at(flight.speed > 0 ? 37 : 3, flight, options);
      const Numbers base = numbers(p);
      for (const Parameter parameter : {Parameter::mass, Parameter::wl_cg, Parameter::rotor_speed,
                                        Parameter::mast, Parameter::inertia_xz}) {
        const double h = step_of(parameter);
        find_motion(flight, p, parameter, motion);
        CHECK(motion.status == Status::ok);
        const double error =
            worst_error(numbers(p.model, motion), difference(flight, p, parameter, h), base, h);
        if (!CHECK_LT(error, 1e-9))
          NOTE(facts(parameter).name << " at " << flight.speed << " m/s: " << error);
      }
    }
  }
}

// In descent the rotors work in their own wake: from where it begins, at a steep curvature, through the vortex ring.
TEST(sensitivity_in_the_vortex_ring_equals_differences_of_new_trims) {
  static Motion motion;
  for (const double descent : {4.0, 9.0, 15.0, 20.0, 30.0}) {
    const SteadyFlight<double> flight = flown({descent, -0.5 * kPi<double>, 0.05, 0});
    const Flight& p = point_at(3, flight, fast());
    const Numbers base = numbers(p);
    for (const Parameter parameter : {Parameter::mass, Parameter::rotor_speed, Parameter::altitude}) {
      const double h = step_of(parameter);
      find_motion(flight, p, parameter, motion);
      CHECK(motion.status == Status::ok);
      const double error =
          worst_error(numbers(p.model, motion), difference(flight, p, parameter, h), base, h);
      if (!CHECK_LT(error, 1e-8)) NOTE(facts(parameter).name << " at " << descent << " m/s: " << error);
    }
  }
}

// The equations of the trim hold on the way: their rates do not move.
TEST(sensitivity_keeps_the_aircraft_trimmed) {
  const SteadyFlight<double> flight = flown({30, 0, 0, 0});
  const Flight& p = point_at(15, flight, fast());
  static Motion motion;
  for (const Parameter parameter : {Parameter::mast, Parameter::mass, Parameter::altitude}) {
    find_motion(flight, p, parameter, motion);
    for (int i = 0; i < p.model.states; ++i) {
      const int state = p.model.state[i];
      const double change = motion.model.rates[state] * step_of(parameter);
      CHECK_NEAR(change, 0, 1e-11 * (1 + std::abs(p.model.xdot[state])));
    }
  }
}

// Every root of the airplane, by mass, CG, rotor speed and inertia: the whole chain against modes of new trims.
TEST(sensitivity_of_roots_equals_differences_of_new_modes) {
  const SteadyFlight<double> flight = flown({97, 0, 0, 0});
  const Flight& p = point_at(83, flight, fast());
  static Motion motion;
  static ModesWorkspace<double> work;
  static ModeSet<double> set, moved_set;
  static RootMotionWorkspace<double> roots;
  static Flight moved;
  static RootMotion<double> found[kMaxLinearStates];
  CHECK(modes(p.model, work, set) == Status::ok);
  for (const Parameter parameter :
       {Parameter::mass, Parameter::sl_cg, Parameter::rotor_speed, Parameter::inertia_zz, Parameter::flap}) {
    find_motion(flight, p, parameter, motion);
    root_motions(p.model, motion.model.a, set, roots, found);
    const double h = step_of(parameter);
    const auto at = [&](double by, Mode<double>* out) {
      moved_configuration(p.c, &parameter, &by, 1, moved.c);
      fill(flight, moved, &p.trim);
      CHECK(modes(moved.model, work, moved_set) == Status::ok);
      CHECK(moved_set.count == set.count && follow(set, moved_set) == Status::ok);
      for (int i = 0; i < moved_set.count; ++i) out[moved_set.mode[i].branch - 1] = moved_set.mode[i];
    };
    static Mode<double> mode[4][kMaxLinearStates];
    const double by[4] = {h, -h, h / 2, -h / 2};
    for (int k = 0; k < 4; ++k) at(by[k], mode[k]);
    for (int i = 0; i < set.count; ++i) {
      const Mode<double>& base = set.mode[i];
      const int branch = base.branch - 1;
      const auto slope = [&](double Mode<double>::*number) {
        const auto of = [&](int k) { return mode[k][branch].*number; };
        return (8 * (of(2) - of(3)) - (of(0) - of(1))) / (6 * h);
      };
      // A root moves by `condition` times the rounding of the matrix.
      const double allowed = 1e-10 * (1 + base.condition) * (1 + base.frequency);
      CHECK_NEAR(found[i].real * h, slope(&Mode<double>::real) * h, allowed);
      CHECK_NEAR(found[i].imag * h, slope(&Mode<double>::imag) * h, allowed);
      CHECK_NEAR(found[i].frequency * h, slope(&Mode<double>::frequency) * h, allowed);
      CHECK_NEAR(found[i].damping_ratio * h, slope(&Mode<double>::damping_ratio) * h,
                 allowed / base.frequency);
    }
  }
}

// A root of [[0, 1], [-k, -d]] by k and d, in closed form.
TEST(sensitivity_of_roots_of_an_oscillator_is_that_of_its_formula) {
  const double k = 4, d = 0.6;
  static Matrix<double, 2, 2> a, by_k, by_d;
  set_zero(a);
  set_zero(by_k);
  set_zero(by_d);
  a(0, 1) = 1;
  a(1, 0) = -k;
  a(1, 1) = -d;
  by_k(1, 0) = -1;
  by_d(1, 1) = -1;
  static EigenWorkspace<double, 2> work;
  static Eigensystem<double, 2> system;
  CHECK(eigensystem(a, 2, work, system) == Status::ok);
  const RootMotion<double> stiffer = root_motion(system, 0, by_k);
  const RootMotion<double> damped = root_motion(system, 0, by_d);
  const double omega = std::sqrt(k), imag = std::sqrt(k - d * d / 4);
  CHECK_NEAR(stiffer.real, 0, 1e-15);
  CHECK_REL(stiffer.imag, 1 / (2 * imag), 1e-14);
  CHECK_REL(stiffer.frequency, 1 / (2 * omega), 1e-14);
  CHECK_REL(stiffer.damping_ratio, -d / (4 * omega * omega * omega), 1e-14);
  CHECK_REL(damped.real, -0.5, 1e-14);
  CHECK_REL(damped.imag, -d / (4 * imag), 1e-14);
  CHECK_NEAR(damped.frequency, 0, 1e-15);
  CHECK_REL(damped.damping_ratio, 1 / (2 * omega), 1e-14);
}

TEST(sensitivity_says_what_it_cannot_know) {
  static Motion motion;
  static ModelMotionWorkspace<double> work;
  static Configuration<double> empty{};
  const SteadyFlight<double> flight = flown({30, 0, 0, 0});
  Flight& p = point_at(15, flight, fast());
  const TrimMotion<double> still{};
  const auto motion_of = [&](const Configuration<double>& c, const State<double>& x, Parameter parameter) {
    return model_motion(c, x, p.trim.controls, p.model, parameter, still, work, motion.model);
  };
  CHECK(motion_of(empty, p.trim.state, Parameter::mass) == Status::bad_argument);
  CHECK(motion_of(p.c, p.trim.state, static_cast<Parameter>(200)) == Status::bad_argument);
  CHECK(motion_of(p.c, p.trim.state, Parameter::count) == Status::ok);  // nothing moves
  CHECK(all_finite(motion.model.a, p.model.states, p.model.states));
  for (int i = 0; i < p.model.states; ++i)
    for (int j = 0; j < p.model.states; ++j) CHECK(motion.model.a(i, j) == 0);
  State<double> nowhere = p.trim.state;
  nowhere.velocity.x = std::nan("");
  CHECK(motion_of(p.c, nowhere, Parameter::mass) == Status::not_finite);
  static TrimMotionWorkspace<double> trims;
  LinearModel<double> no_columns = p.model;
  no_columns.controls = 0;
  CHECK(prepare_trim_motion(p.c, flight, p.trim.state, no_columns, trims) == Status::bad_argument);
  CHECK(prepare_trim_motion(empty, flight, p.trim.state, p.model, trims) == Status::bad_argument);
}

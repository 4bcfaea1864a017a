// Exact derivatives of the complete model: dual numbers against complex steps, whose arithmetic shares
// nothing with them, and against central differences. All 31 states and all 14 controls, every mast angle,
// exact hover and exact zero sideslip among the states: it is there that a smoothed absolute value, a square
// root at zero or a table that starts at zero silently kills or breaks a derivative.
#include <algorithm>
#include <vector>

#include "flight_cases.hpp"

using namespace flight_cases;

namespace {

constexpr double kMasts[] = {0, 15, 30, 45, 60, 75, 90};
constexpr int kColumns = state_count + control_count;
constexpr unsigned kSeed = 20240701;
constexpr int kStates = 1000;

// Size of a usual change of each variable: 1 m/s, 0.1 rad/s, ...
double column_scale(int column) {
  const Variable& variable =
      column < state_count ? kStateVariables[column] : kControlVariables[column - state_count];
  switch (variable.kind) {
    case VariableKind::body_rate:
    case VariableKind::bank:
    case VariableKind::pitch:
    case VariableKind::heading:
      return 0.1;
    case VariableKind::gimbal_tilt:
    case VariableKind::coning:
    case VariableKind::blade_pitch:
    case VariableKind::surface:
      return 0.02;
    case VariableKind::gimbal_rate:
    case VariableKind::coning_rate:
      return 0.5;
    case VariableKind::mean_inflow:
    case VariableKind::cyclic_inflow:
      return 0.01;
    case VariableKind::downwash:
      return 0.05;
    default:
      return 1.0;
  }
}

Options all_states() {
  Options options;
  options.coning_states = true;
  options.position_states = true;
  return options;
}

// The states of the comparison: every tenth exact hover, every tenth exactly symmetric flow with neutral
// controls.
StateAndControls<double> test_case(Generator& random, const Configuration<double>& c, int n) {
  StateAndControls<double> s = random_case(random, c);
  if (n % 10 == 0) {
    s.x.velocity = {0, 0, 0};
    s.x.rates = {0, 0, 0};
    s.u.gust = {0, 0, 0};
  }
  if (n % 10 == 5) {
    s.x.velocity.y = s.x.rates.x = s.x.rates.z = 0;
    s.u.gust.y = 0;
    s.u.lat_stick = s.u.pedal = s.u.aileron = s.u.rudder = s.u.long_stick = s.u.elevator = 0;
  }
  return s;
}

struct Jacobian {
  std::vector<double> entry = std::vector<double>(static_cast<std::size_t>(state_count * kColumns));
  double& operator()(int row, int column) { return entry[static_cast<std::size_t>(row * kColumns + column)]; }
  double operator()(int row, int column) const {
    return entry[static_cast<std::size_t>(row * kColumns + column)];
  }
};

// Values of f come back in `values`.
template <int N>
void dual_columns(const Configuration<double>& c, const StateAndControls<double>& s, int first,
                  Jacobian& jacobian, State<double>& values) {
  using T = Dual<double, N>;
  State<T> x = converted<T>(s.x);
  Controls<T> u = converted<T>(s.u);
  int column = 0;
  const auto seed = [&](T& variable) {
    if (column >= first && column < first + N) variable = T::variable(variable.v, column - first);
    ++column;
  };
  State<T>::each(x, seed);
  Controls<T>::each(u, seed);
  State<T> rates;
  derivative(c, x, u, rates);
  const auto r = flat(rates);
  for (int row = 0; row < state_count; ++row) {
    for (int j = 0; j < N && first + j < kColumns; ++j) {
      jacobian(row, first + j) = r[static_cast<std::size_t>(row)].d.get(j);
    }
  }
  values = converted<double>(rates);
}

Jacobian dual_jacobian(const Configuration<double>& c, const StateAndControls<double>& s,
                       State<double>& values) {
  Jacobian jacobian;
  dual_columns<31>(c, s, 0, jacobian, values);
  dual_columns<31>(c, s, 31, jacobian, values);
  return jacobian;
}

template <class T>
void add_to_variable(State<T>& x, Controls<T>& u, int column, const T& step) {
  int k = 0;
  const auto visit = [&](T& variable) {
    if (k++ == column) variable = variable + step;
  };
  State<T>::each(x, visit);
  Controls<T>::each(u, visit);
}

std::array<double, state_count> complex_step_column(const Configuration<double>& c,
                                                    const StateAndControls<double>& s, int column) {
  using T = std::complex<double>;
  constexpr double step = 1e-30;
  State<T> x = converted<T>(s.x);
  Controls<T> u = converted<T>(s.u);
  add_to_variable(x, u, column, T(0, step));
  State<T> rates;
  derivative(c, x, u, rates);
  std::array<double, state_count> d{};
  const auto r = flat(rates);
  for (std::size_t i = 0; i < d.size(); ++i) d[i] = r[i].imag() / step;
  return d;
}

std::array<double, state_count> central_column(const Configuration<double>& c,
                                               const StateAndControls<double>& s, int column) {
  const double step = 2e-6 * column_scale(column);
  std::array<double, state_count> side[2];
  for (int k = 0; k < 2; ++k) {
    StateAndControls<double> moved = s;
    add_to_variable(moved.x, moved.u, column, k == 0 ? -step : step);
    State<double> rates;
    derivative(c, moved.x, moved.u, rates);
    side[k] = flat(rates);
  }
  std::array<double, state_count> d{};
  for (std::size_t i = 0; i < d.size(); ++i) d[i] = (side[1][i] - side[0][i]) / (2 * step);
  return d;
}

// Scale of an entry: the largest effect of any variable on its row, over the size of its own variable.
struct Comparison {
  double worst = 0;
  int row = 0, column = 0, state = 0;

  void add(const Configuration<double>& c, const Jacobian& dual, const std::array<double, state_count>& other,
           int j, double tolerance, int n) {
    const auto rates = rate_scale(c);
    for (int i = 0; i < state_count; ++i) {
      double scale = 1e-3 * rates[static_cast<std::size_t>(i)];
      for (int k = 0; k < kColumns; ++k) scale = std::max(scale, std::abs(dual(i, k)) * column_scale(k));
      const double error =
          std::abs(dual(i, j) - other[static_cast<std::size_t>(i)]) * column_scale(j) / scale;
      CHECK_LE(error, tolerance);
      if (!(error <= worst)) {
        worst = error;
        row = i;
        column = j;
        state = n;
      }
    }
  }
  void note(const char* what) const {
    NOTE(what << ": largest error " << worst << " of the row's scale, state " << state << ", row " << row
              << ", column " << column);
  }
};

// `complex_columns`, `central_columns`: how many columns are compared at each state; they rotate through all.
void compare(int complex_columns, int central_columns) {
  constexpr double complex_tolerance = 1e-11;
  constexpr double central_tolerance = 1e-6;
  NOTE("seed " << kSeed << ", " << kStates << " states");
  Generator random(kSeed);
  Comparison with_complex;
  Comparison with_central;
  int next_complex = 0;
  int next_central = 0;
  for (int n = 0; n < kStates; ++n) {
    const Configuration<double> c = configuration(kMasts[n % 7], all_states());
    const StateAndControls<double> s = test_case(random, c, n);
    State<double> values;
    const Jacobian dual = dual_jacobian(c, s, values);
    for (const double entry : dual.entry) CHECK(std::isfinite(entry));
    State<double> rates;
    derivative(c, s.x, s.u, rates);
    const auto plain = flat(rates);
    const auto from_dual = flat(values);
    for (std::size_t i = 0; i < state_count; ++i) CHECK(from_dual[i] == plain[i]);  // bit for bit
    for (int k = 0; k < complex_columns; ++k) {
      with_complex.add(c, dual, complex_step_column(c, s, next_complex), next_complex, complex_tolerance, n);
      next_complex = (next_complex + 1) % kColumns;
    }
    for (int k = 0; k < central_columns; ++k) {
      with_central.add(c, dual, central_column(c, s, next_central), next_central, central_tolerance, n);
      next_central = (next_central + 1) % kColumns;
    }
  }
  if (complex_columns > 0) with_complex.note("complex step");
  if (central_columns > 0) with_central.note("central difference");
}

// d loads / d v of a component at the symmetric flow (u, 0, w), in linear tables.
Loads<Dual<double, 1>> sideslip_derivative(Component component, double mast_deg, double u, double w,
                                           bool at_zero_wash) {
  using T = Dual<double, 1>;
  Configuration<double> c = configuration(mast_deg, linear_tables());
  Generator random(5);
  StateAndControls<double> s = random_case(random, c);
  s.x.velocity = {u, 0, w};
  s.x.rates = {0, 0, 0};
  s.u.gust = {0, 0, 0};
  s.x.rotor[left] = s.x.rotor[right];
  if (at_zero_wash) s.x.rotor[left].lambda_0 = s.x.rotor[right].lambda_0 = 0;
  s.u = {};
  State<T> x = converted<T>(s.x);
  x.velocity.y = T::variable(0.0, 0);
  Evaluation<T> out;
  evaluate_aircraft(c, x, converted<T>(s.u), out);
  return out.loads[component];
}

}  // namespace

TEST(derivatives_complex_step) { compare(2, 0); }
TEST(derivatives_central_difference) { compare(0, 2); }
TEST(slow_derivatives_every_column) { compare(kColumns, 9); }

// Table slopes at zero sideslip by hand: CR-166536 tables 3-VII, 3-VIII, 3-IX at 10 deg (-14.5 ft2, -75 ft3,
// -202 ft3), odd, so the slope at zero is that of the first interval. Force and moment in stability axes,
// moments turned by alpha, force at the reference point.
TEST_OF_XV15(derivatives_fuselage_at_zero_sideslip) {
  const double foot = 0.3048;
  const double u = 40;
  const double w = 0;
  const auto d = sideslip_derivative(Component::fuselage, 0, u, w, true);
  const double beta = 10 * kRadPerDeg<double>;
  const double side_slope = -14.5 * foot * foot / beta;
  const double roll_slope = -75.0 * foot * foot * foot / beta;
  const double yaw_slope = -202.0 * foot * foot * foot / beta;
  const double drag = (1.56 + 1.0) * foot * foot;  // table 3-III at alpha 0 and the extra drag area
  const double q_per_v = 0.5 * 1.225 * u;          // q dbeta/dv
  // Stations of the fuselage reference SL 293, WL 84 and of the CG SL 301.2, WL 81.65 (in).
  const double arm_x = (301.2 - 293.0) * foot / 12;
  const double arm_z = (81.65 - 84.0) * foot / 12;
  // D rotates with beta into -Y.
  const double y_v = q_per_v * (side_slope - drag);
  CHECK_REL(d.force.y.d.get(0), y_v, 2e-3);
  CHECK_REL(d.moment.x.d.get(0), q_per_v * roll_slope - arm_z * y_v, 2e-3);
  CHECK_REL(d.moment.z.d.get(0), q_per_v * yaw_slope + arm_x * y_v, 2e-3);
}

TEST(derivatives_lateral_columns_at_zero_sideslip) {
  for (const double mast : kMasts) {
    const double speed = 30 + mast * 0.7;
    for (const Component component : {Component::fin_right, Component::fin_left, Component::wing_free,
                                      Component::fuselage, Component::rotor_right, Component::rotor_left}) {
      const auto d = sideslip_derivative(component, mast, speed, 0.1 * speed, false);
      CHECK_LT(1e-3, std::abs(d.moment.x.d.get(0)));
      CHECK_LT(1e-3, std::abs(d.moment.z.d.get(0)));
      if (component != Component::wing_free) CHECK_LT(1e-2, std::abs(d.force.y.d.get(0)));
    }
    // Fins at the tail: a side force towards the lee, so weathercock yaw stability and positive roll damping
    // arms.
    const auto fin = sideslip_derivative(Component::fin_right, mast, 60 + mast, 0, false);
    CHECK_LT(fin.force.y.d.get(0), 0.0);
    CHECK_LT(0.0, fin.moment.z.d.get(0));
  }
}

TEST(derivatives_exact_hover_is_finite) {
  for (const double mast : kMasts) {
    for (const Interpolation tables : {Interpolation::c1, Interpolation::linear}) {
      Options options = all_states();
      options.tables = tables;
      options.side_by_side = options.sideward_flight = options.lateral_cyclic = options.disk_plane_inflow =
          true;
      const Configuration<double> c = configuration(mast, options);
      StateAndControls<double> s{};  // everything zero, the inflow too
      s.u.collective = 0.2;
      State<double> values;
      const Jacobian dual = dual_jacobian(c, s, values);
      for (const double entry : dual.entry) CHECK(std::isfinite(entry));
      for (const double rate : flat(values)) CHECK(std::isfinite(rate));
      CHECK_LT(1.0, std::abs(dual(kStateIndex.velocity.z, state_count + kControlIndex.collective)) +
                        std::abs(dual(kStateIndex.velocity.x, state_count + kControlIndex.collective)));
    }
  }
}

// Nothing depends on heading and position; the gust enters as minus a velocity, in the air loads alone.
TEST(derivatives_columns_known_in_advance) {
  Generator random(77);
  for (const double mast : kMasts) {
    const Configuration<double> c = configuration(mast, all_states());
    const StateAndControls<double> s = random_case(random, c);
    State<double> values;
    const Jacobian dual = dual_jacobian(c, s, values);
    for (int row = 0; row < kStateIndex.position.x; ++row) {
      CHECK_EQ(dual(row, kStateIndex.yaw), 0.0);
      for (int k = 0; k < 3; ++k) CHECK_EQ(dual(row, kStateIndex.position.x + k), 0.0);
      // d/d(gust) = -(d/dv without the kinematic terms w x v)
      const Vec3<double>& w = s.x.rates;
      const double cross_term[3][3] = {{0, w.z, -w.y}, {-w.z, 0, w.x}, {w.y, -w.x, 0}};
      for (int k = 0; k < 3; ++k) {
        const double kinematic = row < 3 ? cross_term[row][k] : 0.0;
        const double expected = -(dual(row, k) - kinematic);
        CHECK_NEAR(dual(row, state_count + kControlIndex.gust.x + k), expected,
                   1e-10 * (1 + std::abs(expected)));
      }
    }
  }
}

// Float has 24 bits: a few hundred operations in the sums leave about 1e-4 of the rates' scale.
TEST(derivatives_float_close_to_double) {
  Generator random(91);
  NOTE("seed 91");
  double worst = 0;
  double worst_slope = 0;
  for (int n = 0; n < 140; ++n) {
    const double mast = kMasts[n % 7];
    const Configuration<double> c = configuration(mast);
    Configuration<float> cf;
    const FlightSetup<float> setup = flight_setup(aircraft_data<float>(), static_cast<float>(mast));
    if (!CHECK(prepare(aircraft_data<float>(), setup, cf) == Status::ok)) return;
    StateAndControls<double> s = random_case(random, c);
    const State<float> xf = converted<float>(s.x);
    const Controls<float> uf = converted<float>(s.u);
    s.x = converted<double>(xf);  // the same numbers in both
    s.u = converted<double>(uf);
    State<double> rates;
    State<float> rates_f;
    derivative(c, s.x, s.u, rates);
    derivative(cf, xf, uf, rates_f);
    const auto expected = flat(rates);
    const auto actual = flat(rates_f);
    const auto scale = rate_scale(c);
    for (std::size_t i = 0; i < state_count; ++i) {
      const double error =
          std::abs(static_cast<double>(actual[i]) - expected[i]) / std::max(scale[i], std::abs(expected[i]));
      CHECK_LE(error, 1e-3);
      worst = std::max(worst, error);
    }
    // One derivative in float: the collective's.
    using F = Dual<float, 1>;
    using D = Dual<double, 1>;
    Controls<F> uf1 = converted<F>(s.u);
    Controls<D> u1 = converted<D>(s.u);
    uf1.collective = F::variable(uf.collective, 0);
    u1.collective = D::variable(s.u.collective, 0);
    State<F> out_f;
    State<D> out;
    derivative(cf, converted<F>(s.x), uf1, out_f);
    derivative(c, converted<D>(s.x), u1, out);
    const double slope = out.velocity.z.d.get(0);
    const double slope_error =
        std::abs(static_cast<double>(out_f.velocity.z.d.get(0)) - slope) / (10 + std::abs(slope));
    CHECK_LE(slope_error, 1e-2);
    worst_slope = std::max(worst_slope, slope_error);
  }
  NOTE("largest error of the rates " << worst << ", of one derivative " << worst_slope);
}

// Columns of the derivative of rates and component loads with respect to the configuration: dual numbers
// against complex steps, against central differences of prepare() and derivative(), and against closed forms.
#include "tiltrotor/analysis/linear/configuration_sensitivity.hpp"

#include <algorithm>
#include <cstring>

#include "model/flight_cases.hpp"

using namespace flight_cases;
using Parameter = ConfigurationParameter;

namespace {

constexpr unsigned kSeed = 1126;

ParameterSet every_parameter() {
  ParameterSet set{kConfigurationParameters, {}};
  for (int k = 0; k < kConfigurationParameters; ++k) set.parameter[k] = static_cast<Parameter>(k);
  return set;
}

// Size of a usual change, in the unit of the parameter.
double usual_change(Parameter parameter) {
  switch (parameter) {
    case Parameter::mast:
    case Parameter::flap:
    case Parameter::mast_rate:
    case Parameter::mast_acceleration:
    case Parameter::sl_cg:
    case Parameter::wl_cg:
    case Parameter::air_density:
    case Parameter::hub_spring_factor:
    case Parameter::ground_wash_right:
    case Parameter::ground_wash_left:
    case Parameter::download:
      return 0.1;
    case Parameter::rotor_speed:
    case Parameter::rotor_difference:
    case Parameter::rotor_acceleration:
      return 1;
    case Parameter::altitude:
    case Parameter::mass:
      return 100;
    case Parameter::speed_of_sound:
      return 10;
    default:
      return 1000;
  }
}

struct Flight {
  Configuration<double> c;
  StateAndControls<double> s;
};

Configuration<double> prepared(const FlightSetup<double>& setup) {
  Configuration<double> c;
  CHECK(prepare(aircraft(), setup, c) == Status::ok);
  return c;
}

// A setting within its ranges, at the mast angle given.
FlightSetup<double> random_setup(Generator& random, double mast_deg, const Options& options) {
  FlightSetup<double> setup = flight_setup(aircraft(), mast_deg);
  setup.mast_rate = random.between(-0.13, 0.13);
  setup.mast_acceleration = random.between(-0.35, 0.35);
  setup.rotor_acceleration = random.between(-3, 3);
  const Bounds<double>& flap_deg = aircraft().limits.flap_deg;
  setup.flap_deg = random.between(flap_deg.low + 1, flap_deg.high - 1);
  setup.rotor_speed *= random.between(0.95, 1.05);
  setup.altitude = random.between(0, 4000);
  setup.mass *= random.between(0.85, 1.05);
  setup.sl_cg += random.between(-0.1, 0.1);
  setup.wl_cg += random.between(-0.05, 0.05);
  setup.options = options;
  return setup;
}
Flight random_flight(Generator& random, double mast_deg, const Options& options) {
  Flight flight;
  flight.c = prepared(random_setup(random, mast_deg, options));
  flight.c.rotor[right].ground_wash = random.between(0.8, 1);
  flight.c.rotor[left].ground_wash = random.between(0.8, 1);
  flight.c.download = random.between(0.5, 1);
  flight.s = random_case(random, flight.c);
  return flight;
}

// Every switch behind which mast angle, flap, rotor speed or air act by another formula.
Options other_switches() {
  Options options;
  options.grid = BladeGrid::realtime;
  options.tables = Interpolation::linear;
  options.flapping = FlapOrder::first;
  options.coning_states = true;
  options.inflow = InflowShape::uniform;
  options.side_by_side = options.sideward_flight = options.disk_plane_inflow = true;
  options.wake = WakeModel::gtrs_empirical;
  options.wake_load = WakeLoadFactor::gtrs;
  options.mast_drag = MastDrag::linear;
  options.wing_rate_velocity = options.tail_sideslip_loss = options.lateral_cyclic = true;
  options.tail_wash = TailWash::closed_form;
  options.inertia = InertiaSet::design_1975;
  options.hub_spring_factor = 0.8;
  return options;
}
Options individual_blades() {
  Options options;
  options.azimuth = AzimuthMode::individual;
  options.flap_angular_acceleration = true;
  options.wash = WashFactor::vortex_cylinder;
  options.tail_pressure = TailPressure::constant;
  return options;
}

constexpr int kRows = state_count + component_count * 6;
using Column = std::array<double, kRows>;

template <class T, class Part>
void write(const Evaluation<T>& e, const Part& part, Column& column) {
  std::size_t i = 0;
  State<T>::each(e.rates, [&](const T& x) { column[i++] = part(x); });
  for (const Loads<T>& loads : e.loads.component)
    Loads<T>::each(loads, [&](const T& x) { column[i++] = part(x); });
}

Column evaluated(const Configuration<double>& c, const StateAndControls<double>& s, double azimuth = 0) {
  Evaluation<double> e;
  evaluate_aircraft(c, s.x, s.u, e, azimuth);
  Column column;
  write(
      e, [](double x) { return x; }, column);
  return column;
}

Column complex_step(const Flight& flight, Parameter parameter, double azimuth) {
  using Z = std::complex<double>;
  static Configuration<Z> c;
  static Evaluation<Z> e;
  const Z step(0, 1e-30);
  moved_configuration(flight.c, &parameter, &step, 1, c);
  evaluate_aircraft(c, converted<Z>(flight.s.x), converted<Z>(flight.s.u), e, azimuth);
  Column column;
  write(
      e, [](const Z& x) { return x.imag() / 1e-30; }, column);
  return column;
}

// Scale of a row: of the rates as everywhere, of loads half the weight and that at 1 m.
Column row_scale(const Configuration<double>& c) {
  Column scale;
  scale.fill(0.5 * c.mass.mass * kGravity<double>);
  const auto rates = rate_scale(c);
  std::copy(rates.begin(), rates.end(), scale.begin());
  return scale;
}

struct Found {
  SensitivityWorkspace<double> work;
  ConfigurationSensitivity<double> columns;

  Status find(const Flight& flight, const ParameterSet& set, double azimuth = 0) {
    return configuration_sensitivity(flight.c, flight.s.x, flight.s.u, set, work, columns, azimuth);
  }
  Column column(int j) const {
    Column all;
    for (int i = 0; i < state_count; ++i) all[static_cast<std::size_t>(i)] = columns.rates(i, j);
    std::size_t i = state_count;
    for (const Loads<double>& loads : columns.loads[j].component)
      Loads<double>::each(loads, [&](double x) { all[i++] = x; });
    return all;
  }
  double rate(int row, Parameter parameter) const { return columns.rates(row, static_cast<int>(parameter)); }
};
Found& found() {
  static Found memory;
  return memory;
}

// Largest difference over the row's size or the entry, whichever is larger.
double difference(const Column& a, const Column& b, const Column& scale, double change) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double size = std::max(std::abs(b[i]) * change, scale[i]);
    const double error = std::abs(a[i] - b[i]) * change / size;
    if (!(error <= worst)) worst = error;
  }
  return worst;
}

const char* name(Parameter parameter) { return facts(parameter).name; }

}  // namespace

TEST(derivatives_by_configuration_equal_complex_step) {
  Generator random(kSeed);
  double worst = 0;
  for (const double mast : {0.0, 12.0, 30.0, 47.0, 60.0, 81.0, 90.0}) {
    for (const Options& options : {Options{}, other_switches(), individual_blades()}) {
      for (int n = 0; n < 3; ++n) {
        const Flight flight = random_flight(random, mast, options);
        const double azimuth = random.between(0, 6);
        CHECK(found().find(flight, every_parameter(), azimuth) == Status::ok);
        for (int j = 0; j < kConfigurationParameters; ++j) {
          const auto parameter = static_cast<Parameter>(j);
          const double error = difference(found().column(j), complex_step(flight, parameter, azimuth),
                                          row_scale(flight.c), usual_change(parameter));
          if (!CHECK_LE(error, 1e-11)) NOTE(name(parameter) << " at mast " << mast);
          worst = std::max(worst, error);
        }
      }
    }
  }
  NOTE("largest difference " << worst);
}

// On flights and settings off the knots of every table.
TEST(derivatives_by_configuration_equal_central_differences) {
  Generator random(kSeed + 1);
  double worst = 0;
  for (const double mast : {3.0, 21.0, 44.0, 67.0, 88.0}) {
    for (const Options& options : {Options{}, other_switches()}) {
      const Flight flight = random_flight(random, mast, options);
      CHECK(found().find(flight, every_parameter()) == Status::ok);
      for (int j = 0; j < kConfigurationParameters; ++j) {
        const auto parameter = static_cast<Parameter>(j);
        const double step = 1e-5 * usual_change(parameter);
        Column side[2];
        for (int k = 0; k < 2; ++k) {
          FlightSetup<double> setup = flight.c.setup;
          const double by = k == 0 ? -step : step;
          if (parameter == Parameter::mast) setup.mast_deg += by * kDegPerRad<double>;
          if (parameter == Parameter::mast_rate) setup.mast_rate += by;
          if (parameter == Parameter::mast_acceleration) setup.mast_acceleration += by;
          if (parameter == Parameter::flap) setup.flap_deg += by * kDegPerRad<double>;
          if (parameter == Parameter::rotor_speed) setup.rotor_speed += by;
          if (parameter == Parameter::rotor_difference) setup.rotor_difference += by;
          if (parameter == Parameter::rotor_acceleration) setup.rotor_acceleration += by;
          if (parameter == Parameter::altitude) setup.altitude += by;
          if (parameter == Parameter::mass) setup.mass += by;
          if (parameter == Parameter::sl_cg) setup.sl_cg += by;
          if (parameter == Parameter::wl_cg) setup.wl_cg += by;
          if (parameter == Parameter::hub_spring_factor) setup.options.hub_spring_factor += by;
          Configuration<double> moved = prepared(setup);
          if (parameter == Parameter::air_density) moved.air.density += by;
          if (parameter == Parameter::speed_of_sound) moved.air.speed_of_sound += by;
          if (parameter == Parameter::inertia_xx) moved.mass.inertia.xx += by;
          if (parameter == Parameter::inertia_yy) moved.mass.inertia.yy += by;
          if (parameter == Parameter::inertia_zz) moved.mass.inertia.zz += by;
          if (parameter == Parameter::inertia_xz) moved.mass.inertia.xz += by;
          for (const Side r : {right, left}) moved.rotor[r].ground_wash = flight.c.rotor[r].ground_wash;
          moved.download = flight.c.download;
          if (parameter == Parameter::ground_wash_right) moved.rotor[right].ground_wash += by;
          if (parameter == Parameter::ground_wash_left) moved.rotor[left].ground_wash += by;
          if (parameter == Parameter::download) moved.download += by;
          side[k] = evaluated(moved, flight.s);
        }
        Column central;
        for (std::size_t i = 0; i < central.size(); ++i) central[i] = (side[1][i] - side[0][i]) / (2 * step);
        const double error =
            difference(found().column(j), central, row_scale(flight.c), usual_change(parameter));
        if (!CHECK_LE(error, 1e-6)) NOTE(name(parameter) << " at mast " << mast);
        worst = std::max(worst, error);
      }
    }
  }
  NOTE("largest difference " << worst);
}

TEST(derivatives_by_configuration_leave_the_values_alone) {
  Generator random(kSeed + 2);
  for (const double mast : {0.0, 30.0, 52.0, 90.0}) {
    for (const Options& options : {Options{}, other_switches(), individual_blades()}) {
      const Flight flight = random_flight(random, mast, options);
      const Flight before = flight;
      CHECK(found().find(flight, every_parameter(), 0.4) == Status::ok);
      State<double> rates;
      derivative(flight.c, flight.s.x, flight.s.u, rates, 0.4);
      CHECK(std::memcmp(&rates, found().columns.xdot, sizeof rates) == 0);
      CHECK(std::memcmp(&before, &flight, sizeof flight) == 0);
    }
  }
}

// On a knot the slope of the interval above, on the last that of the one below: against differences of the
// interval's inside, extrapolated to its end. Knots of every table along mast angle: 0, 30, 60, 90. With the mast turn
// the angles of attack of the blades: the steps are short against the 0.001 deg in which a slope fades at the end of a
// table, where a station may stand.
TEST(derivatives_by_configuration_are_one_sided_on_knots) {
  Generator random(kSeed + 3);
  for (const double mast : {0.0, 30.0, 60.0, 90.0}) {
    FlightSetup<double> setup = random_setup(random, mast, Options{});
    for (int setting = 0; setting < aircraft().wing.flap_settings; ++setting) {
      const double flap = setup.flap_deg = aircraft().wing.flap_deg[setting];
      const Configuration<double> c = prepared(setup);
      const Flight flight{c, random_case(random, c)};
      CHECK(found().find(flight, every_parameter()) == Status::ok);
      for (const Parameter parameter : {Parameter::mast, Parameter::flap}) {
        const bool is_mast = parameter == Parameter::mast;
        const double end = is_mast ? 90 : aircraft().limits.flap_deg.high;
        const double step_deg = (is_mast ? mast : flap) == end ? -5e-6 : 5e-6;
        Column at[4];
        for (int k = 1; k < 4; ++k) {
          FlightSetup<double> moved = setup;
          (is_mast ? moved.mast_deg : moved.flap_deg) += k * step_deg;
          at[k] = evaluated(prepared(moved), flight.s);
        }
        Column slope;
        for (std::size_t i = 0; i < slope.size(); ++i)
          slope[i] = (-2.5 * at[1][i] + 4 * at[2][i] - 1.5 * at[3][i]) / (step_deg * kRadPerDeg<double>);
        const double error =
            difference(found().column(static_cast<int>(parameter)), slope, row_scale(c), 0.1);
        if (!CHECK_LE(error, 1e-6)) NOTE(name(parameter) << " at mast " << mast << ", flap " << flap);
      }
    }
  }
}

TEST(derivatives_by_configuration_of_every_parameter_act) {
  Generator random(kSeed + 7);
  Flight flight = random_flight(random, 30, Options{});
  flight.s.x.velocity = {5, 1, 1};  // slow enough for the wakes to meet the wing
  CHECK(found().find(flight, every_parameter()) == Status::ok);
  const Column none{};
  for (int j = 0; j < kConfigurationParameters; ++j)
    if (!CHECK(found().column(j) != none)) NOTE(name(static_cast<Parameter>(j)));
}

// Newton, Euler, ISO 2533 and Hooke, differentiated by hand.
TEST(derivatives_by_configuration_follow_closed_forms) {
  Generator random(kSeed + 4);
  Flight flight = random_flight(random, 0, Options{});  // at mast 0 the CG does not depend on the mass
  flight.s.x.rates.x = flight.s.x.rates.z = 0;
  // With the masts at rest: moving ones add a travel of the CG over the mass, and moments of their own.
  ConfigurationSetting<double> at_rest = flight.c.setup;
  at_rest.mast_rate = at_rest.mast_acceleration = 0;
  CHECK(reconfigure(at_rest, flight.c) == Status::ok);
  CHECK(found().find(flight, every_parameter()) == Status::ok);
  const Configuration<double>& c = flight.c;
  Evaluation<double> e;
  evaluate_aircraft(c, flight.s.x, flight.s.u, e);
  Loads<double> total{};
  for (const Loads<double>& loads : e.loads.component) total = total + loads;

  // u' = X/m + ..
  const double m = c.mass.mass;
  CHECK_REL(found().rate(kStateIndex.velocity.x, Parameter::mass), -total.force.x / (m * m), 1e-12);
  CHECK_REL(found().rate(kStateIndex.velocity.z, Parameter::mass), -total.force.z / (m * m), 1e-12);
  // q' = M/Iyy without p and r
  const double iyy = c.mass.inertia.yy;
  CHECK_REL(found().rate(kStateIndex.rates.y, Parameter::inertia_yy), -total.moment.y / (iyy * iyy), 1e-12);
  // b1c'' = .. - K b1c/J, J = N_b I_b/2
  const RotorTables<double>& rotor = aircraft().rotor;
  const double j = rotor.blades * rotor.flap_inertia / 2;
  CHECK_REL(found().rate(kStateIndex.rotor[left].b1c_rate, Parameter::hub_spring_factor),
            -rotor.hub_spring * flight.s.x.rotor[left].b1c / j, 1e-12);
  // rho = rho_0 (1 - L h/T_0)^4.2559, a = sqrt(gamma R T), T = T_0 - L h
  const double lapse = 0.0065;
  const double temperature = 288.15 - lapse * c.setup.altitude;
  CHECK_REL(c.air.temperature, temperature, 1e-15);
  const double density_slope = -c.air.density * 4.2559 * lapse / temperature;
  const double sound_slope = -c.air.speed_of_sound * lapse / (2 * temperature);
  for (int i = 0; i < state_count; ++i)
    CHECK_NEAR(found().rate(i, Parameter::altitude),
               found().rate(i, Parameter::air_density) * density_slope +
                   found().rate(i, Parameter::speed_of_sound) * sound_slope,
               1e-12 * rate_scale(c)[static_cast<std::size_t>(i)]);
}

TEST(derivatives_by_configuration_refuse_what_they_cannot_do) {
  Generator random(kSeed + 5);
  Flight flight = random_flight(random, 30, Options{});
  const auto refused = [&](const Flight& f, const ParameterSet& set) {
    const bool bad = found().find(f, set) == Status::bad_argument;
    return bad && found().columns.parameters == 0 && found().columns.rates(0, 0) == 0;
  };
  CHECK(found().find(flight, {1, {Parameter::mast}}) == Status::ok);
  CHECK_EQ(found().columns.parameters, 1);
  CHECK(found().columns.parameter[0] == Parameter::mast);
  CHECK(refused(flight, {0, {}}));
  CHECK(refused(flight, {kConfigurationParameters + 1, {}}));
  CHECK(refused(flight, {1, {Parameter::count}}));
  Flight unprepared = flight;
  unprepared.c = Configuration<double>{};
  CHECK(refused(unprepared, {1, {Parameter::mast}}));
  flight.s.x.velocity.x = std::nan("");
  CHECK(found().find(flight, {1, {Parameter::mast}}) == Status::not_finite);
}

// A set in any order, more than a pass holds or fewer, names the same columns.
TEST(derivatives_by_configuration_do_not_depend_on_their_company) {
  Generator random(kSeed + 6);
  Flight flight = random_flight(random, 40, Options{});
  CHECK(found().find(flight, every_parameter()) == Status::ok);
  const Column rotor_speed = found().column(static_cast<int>(Parameter::rotor_speed));
  const Column inertia = found().column(static_cast<int>(Parameter::inertia_xz));
  CHECK(found().find(flight, {2, {Parameter::inertia_xz, Parameter::rotor_speed}}) == Status::ok);
  CHECK(found().column(0) == inertia);
  CHECK(found().column(1) == rotor_speed);
}

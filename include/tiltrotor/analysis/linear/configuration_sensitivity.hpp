// Derivatives of rates and component loads with respect to the configuration: mast angle, flaps, rotor speed,
// altitude, loading .., exact to rounding as A and B are.
//
//   const ParameterSet columns = {2, {ConfigurationParameter::mast, ConfigurationParameter::rotor_speed}};
//   static SensitivityWorkspace<double> work;  static ConfigurationSensitivity<double> found;
//   configuration_sensitivity(c, x, u, columns, work, found);     // found.rates(kStateIndex.rates.y, 0)
//
// The model is evaluated on a configuration whose numbers carry partials: code of its own, which only a program
// that includes this header pays for. State and controls stay as they are, in SI units: what is held is inflow
// over tip speed, stick in inches.
//
// Where the model has a kink along the configuration, the derivative is one-sided: on a knot of a table along
// mast angle or flap that of the interval above, on the last knot that of the one below; so at mast 0 towards
// airplane and at mast 90 towards helicopter. The cross-flow law of the wing's drag meets its ends to the width
// of its smoothing: its slope there is that of the law.
#pragma once

#include "tiltrotor/math/algebra/matrix.hpp"
#include "tiltrotor/model/derivative.hpp"

namespace tiltrotor {

enum class ConfigurationParameter : unsigned char {
  mast,
  mast_rate,
  mast_acceleration,
  flap,
  rotor_speed,
  rotor_difference,
  rotor_acceleration,
  altitude,
  mass,
  sl_cg,
  wl_cg,
  air_density,
  speed_of_sound,
  inertia_xx,
  inertia_yy,
  inertia_zz,
  inertia_xz,
  hub_spring_factor,
  ground_wash_right,
  ground_wash_left,
  download,
  count
};
inline constexpr int kConfigurationParameters = static_cast<int>(ConfigurationParameter::count);

struct ParameterFacts {
  ConfigurationParameter parameter;
  const char* name;
  const char* unit;
};
inline constexpr ParameterFacts kParameterFacts[] = {
    {ConfigurationParameter::mast, "mast", "rad"},
    {ConfigurationParameter::mast_rate, "mast_rate", "rad/s"},
    {ConfigurationParameter::mast_acceleration, "mast_acceleration", "rad/s^2"},
    {ConfigurationParameter::flap, "flap", "rad"},
    {ConfigurationParameter::rotor_speed, "rotor_speed", "rad/s"},
    {ConfigurationParameter::rotor_difference, "rotor_difference", "rad/s"},
    {ConfigurationParameter::rotor_acceleration, "rotor_acceleration", "rad/s^2"},
    {ConfigurationParameter::altitude, "altitude", "m"},  // density and speed of sound with it
    {ConfigurationParameter::mass, "mass", "kg"},         // inertia is not scaled with it
    {ConfigurationParameter::sl_cg, "sl_cg", "m"},        // of the CG at mast 0, + aft
    {ConfigurationParameter::wl_cg, "wl_cg", "m"},        // likewise, + up
    {ConfigurationParameter::air_density, "air_density", "kg/m^3"},
    {ConfigurationParameter::speed_of_sound, "speed_of_sound", "m/s"},
    {ConfigurationParameter::inertia_xx, "inertia_xx", "kg m^2"},
    {ConfigurationParameter::inertia_yy, "inertia_yy", "kg m^2"},
    {ConfigurationParameter::inertia_zz, "inertia_zz", "kg m^2"},
    {ConfigurationParameter::inertia_xz, "inertia_xz", "kg m^2"},
    {ConfigurationParameter::hub_spring_factor, "hub_spring_factor", "-"},
    {ConfigurationParameter::ground_wash_right, "ground_wash_right", "-"},  // of the ground: Configuration
    {ConfigurationParameter::ground_wash_left, "ground_wash_left", "-"},
    {ConfigurationParameter::download, "download", "-"},
};
constexpr bool parameters_in_order() {
  for (int k = 0; k < kConfigurationParameters; ++k)
    if (static_cast<int>(kParameterFacts[k].parameter) != k) return false;
  return sizeof(kParameterFacts) / sizeof(kParameterFacts[0]) == kConfigurationParameters;
}
static_assert(parameters_in_order(), "one row of kParameterFacts per ConfigurationParameter, in its order");

constexpr const ParameterFacts& facts(ConfigurationParameter parameter) {
  return kParameterFacts[static_cast<int>(parameter)];
}

// Moves a parameter by an amount in its unit: one of the setting, from which the rest follows.
template <class C>
void move_setting(ConfigurationParameter parameter, const C& by, ConfigurationSetting<C>& s) {
  using R = Real<C>;
  using P = ConfigurationParameter;
  if (parameter == P::mast) s.mast_deg += by * kDegPerRad<R>;
  if (parameter == P::mast_rate) s.mast_rate += by;
  if (parameter == P::mast_acceleration) s.mast_acceleration += by;
  if (parameter == P::flap) s.flap_deg += by * kDegPerRad<R>;
  if (parameter == P::rotor_speed) s.rotor_speed += by;
  if (parameter == P::rotor_difference) s.rotor_difference += by;
  if (parameter == P::rotor_acceleration) s.rotor_acceleration += by;
  if (parameter == P::altitude) s.altitude += by;
  if (parameter == P::mass) s.mass += by;
  if (parameter == P::sl_cg) s.sl_cg += by;
  if (parameter == P::wl_cg) s.wl_cg += by;
}

namespace sensitivity_detail {

// One of what follows, with the setting held.
template <class C>
void move_consequence(ConfigurationParameter parameter, const C& by, Configuration<C>& c) {
  using P = ConfigurationParameter;
  if (parameter == P::air_density) c.air.density += by;
  if (parameter == P::speed_of_sound) c.air.speed_of_sound += by;
  if (parameter == P::inertia_xx) c.mass.inertia.xx += by;
  if (parameter == P::inertia_yy) c.mass.inertia.yy += by;
  if (parameter == P::inertia_zz) c.mass.inertia.zz += by;
  if (parameter == P::inertia_xz) c.mass.inertia.xz += by;
  if (parameter == P::hub_spring_factor) c.hub_spring += by * c.aircraft->rotor.hub_spring;
  if (parameter == P::ground_wash_right) c.rotor[right].ground_wash += by;
  if (parameter == P::ground_wash_left) c.rotor[left].ground_wash += by;
  if (parameter == P::download) c.download += by;
}

}  // namespace sensitivity_detail

// The same numbers in the scalar T.
template <class T, template <class> class Shape>
void in_scalar(const Shape<Real<T>>& from, Shape<T>& to) {
  Real<T> flat[sizeof from / sizeof(Real<T>)];
  flatten(from, flat);
  const Real<T>* next = flat;
  Shape<T>::each(to, [&next](T& x) { x = T(*next++); });
}

// `c` in the scalar T, with parameter[k] moved by by[k], k < count: partials, a complex step, or a number. `c`
// is as prepare() or reconfigure() left it.
template <class T>
void moved_configuration(const Configuration<Real<T>>& c, const ConfigurationParameter* parameter,
                         const T* by, int count, Configuration<T>& moved) {
  static_cast<FixedSetup<Real<T>>&>(moved) = c;
  static_cast<ConfigurationSetting<T>&>(moved.setup) = in_scalar<T>(c.setup);
  moved.setup.options = c.setup.options;
  moved.around = c.around;
  for (const Side side : {right, left}) moved.rotor[side].ground_wash = T(c.rotor[side].ground_wash);
  moved.download = T(c.download);
  for (int k = 0; k < count; ++k) move_setting<T>(parameter[k], by[k], moved.setup);
  configure(moved);
  for (int k = 0; k < count; ++k) sensitivity_detail::move_consequence(parameter[k], by[k], moved);
}

struct ParameterSet {
  int count;
  ConfigurationParameter parameter[kConfigurationParameters];
};

// Column j belongs to parameter[j]; units of a column are those of the rates or loads over the parameter's.
template <class R>
struct ConfigurationSensitivity {
  int parameters;
  ConfigurationParameter parameter[kConfigurationParameters];
  R xdot[state_count];                                     // at the point
  Matrix<R, state_count, kConfigurationParameters> rates;  // d xdot / d parameter
  LoadRecord<R> loads[kConfigurationParameters];           // d loads / d parameter, by component
};

inline constexpr int kParameterDirections = 8;  // of one pass

template <class R>
struct SensitivityWorkspace {
  using T = Dual<R, kParameterDirections>;
  Configuration<T> configuration;
  State<T> x;
  Controls<T> u;
  DerivativeSteps<T> derivative;
  Evaluation<T> evaluation;
};

namespace sensitivity_detail {

template <class R>
void clear(ConfigurationSensitivity<R>& out) {
  out.parameters = 0;
  for (ConfigurationParameter& p : out.parameter) p = ConfigurationParameter::count;
  for (R& rate : out.xdot) rate = R(0);
  set_zero(out.rates);
  for (LoadRecord<R>& column : out.loads) column = LoadRecord<R>{};
}

// Columns `first` to `last` from the partials of one pass. False when one of them is not finite.
template <class R, class T>
bool put_columns(const Evaluation<T>& e, int first, int last, ConfigurationSensitivity<R>& out) {
  bool finite = true;
  const auto slope = [&finite, first](const T& x, int column) {
    const R found = x.d.get(column - first);
    finite &= is_finite(found);
    return found;
  };
  T rates[state_count];
  flatten(e.rates, rates);
  for (int i = 0; i < state_count; ++i) {
    out.xdot[i] = value(rates[i]);
    finite &= is_finite(out.xdot[i]);
    for (int j = first; j < last; ++j) out.rates(i, j) = slope(rates[i], j);
  }
  for (int j = first; j < last; ++j) {
    for (int k = 0; k < component_count; ++k) {
      T loads[Loads<T>::kCount];
      R column[Loads<T>::kCount];
      flatten(e.loads.component[k], loads);
      for (int i = 0; i < Loads<T>::kCount; ++i) column[i] = slope(loads[i], j);
      unflatten(column, out.loads[j].component[k]);
    }
  }
  return finite;
}

}  // namespace sensitivity_detail

// The columns of a set of parameters at (x, u), trimmed or not. The arguments are not changed.
// Status: ok; not_finite (a number in state, controls or result is not finite: `out` is then what was found);
// bad_argument (`columns` names an unknown parameter or too many, or c is not prepared: `out` is empty).
// `azimuth`: rad, for individual blades alone. Cost: one pass for every 8 parameters, each some 4 derivatives of
// the grid.
template <class R>
Status configuration_sensitivity(const Configuration<R>& c, const State<R>& x, const Controls<R>& u,
                                 const ParameterSet& columns, SensitivityWorkspace<R>& work,
                                 ConfigurationSensitivity<R>& out, R azimuth = R(0)) {
  using T = typename SensitivityWorkspace<R>::T;
  sensitivity_detail::clear(out);
  if (c.aircraft == nullptr || columns.count < 1 || columns.count > kConfigurationParameters)
    return Status::bad_argument;
  for (int j = 0; j < columns.count; ++j)
    if (columns.parameter[j] >= ConfigurationParameter::count) return Status::bad_argument;

  out.parameters = columns.count;
  for (int j = 0; j < columns.count; ++j) out.parameter[j] = columns.parameter[j];
  bool finite = true;
  for (int first = 0; first < columns.count; first += kParameterDirections) {
    const int count =
        columns.count - first < kParameterDirections ? columns.count - first : kParameterDirections;
    T by[kParameterDirections];
    for (int k = 0; k < count; ++k) by[k] = T::variable(R(0), k);
    moved_configuration(c, columns.parameter + first, by, count, work.configuration);
    in_scalar(x, work.x);
    in_scalar(u, work.u);
    evaluate_aircraft(work.configuration, work.x, work.u, work.derivative, work.evaluation, azimuth);
    finite &= sensitivity_detail::put_columns(work.evaluation, first, first + count, out);
  }
  return finite ? Status::ok : Status::not_finite;
}

}  // namespace tiltrotor

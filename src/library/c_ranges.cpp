#include "library/c_ranges.hpp"

#include <cstring>
#include <limits>

#include "library/c_words.hpp"
#include "tiltrotor/math/sentence.hpp"
#include "tiltrotor/model/variables/control_range.hpp"
#include "tiltrotor/systems/drive.hpp"

namespace tiltrotor::c_interface {

namespace {

constexpr R kMostTurbulence = R(50);                      // m/s
constexpr R kMostOfSteadyFlight = R(60) * kRadPerDeg<R>;  // turn rate, rad/s, and sideslip: first_invalid()
constexpr R kEndless = std::numeric_limits<R>::max();

struct Field {
  R value, low, high;
};

// Fields in the order of their names below, choices first.
struct Fields {
  static constexpr int kMost = 22;
  Field field[kMost];
  int count, choices;

  void add(R value, R low, R high) { field[count++] = {value, low, high}; }
  void add(R value, const Bounds<R>& bounds) { add(value, bounds.low, bounds.high); }
  void add_choice(std::int32_t value, std::int32_t last) {
    choices = count + 1;
    add(static_cast<R>(value), R(0), static_cast<R>(last));
  }
  void add_vector(const R (&v)[3], R most) {
    for (const R part : v) add(part, -most, most);
  }
};

Fields fields_of(const tr_systems& s) {
  const LimitTables<R>& limits = aircraft_data<R>().limits;
  Fields f{};
  f.add_choice(s.governor, TR_GOVERNOR_PI);
  f.add_choice(s.wind_shear, TR_SHEAR_OTHER);
  for (const std::int32_t on :
       {s.conversion, s.engines, s.actuators, s.scas, s.gear, s.ground_effect, s.turbulence, s.interconnect,
        s.gear_down, s.engine_failed[0], s.engine_failed[1]})
    f.add_choice(on, 1);
  f.add(s.mast_command_deg, limits.mast_deg);
  f.add(s.flap_command_deg, limits.flap_deg);
  f.add(s.rotor_command_radps, limits.rotor_speed);
  for (const R throttle : s.throttle) f.add(throttle, R(0), kMostThrottle<R>);
  f.add(s.turbulence_w20_mps, R(0), kMostTurbulence);
  for (const R brake : s.brake) f.add(brake, R(0), R(1));
  return f;
}
constexpr const char* kSystemsNames[] = {"governor",
                                         "wind_shear",
                                         "conversion",
                                         "engines",
                                         "actuators",
                                         "scas",
                                         "gear",
                                         "ground_effect",
                                         "turbulence",
                                         "interconnect",
                                         "gear_down",
                                         "engine_failed[0]",
                                         "engine_failed[1]",
                                         "mast_command_deg",
                                         "flap_command_deg",
                                         "rotor_command_radps",
                                         "throttle[0]",
                                         "throttle[1]",
                                         "turbulence_w20_mps",
                                         "brake[0]",
                                         "brake[1]"};

// The ground may be infinitely far below.
Fields fields_of(const tr_environment& e) {
  const LimitTables<R>& limits = aircraft_data<R>().limits;
  Fields f{};
  f.add_vector(e.wind_mps, limits.wind);
  for (const auto& gust : e.gust_mps) f.add_vector(gust, limits.gust);
  f.add_vector(e.gust_rates_radps, limits.gust_rate);
  f.add(e.altitude_origin_m, -kEndless, kEndless);
  f.add(e.temperature_offset_k, -limits.warmer, limits.warmer);
  f.add(e.pressure_ratio, R(1) - limits.pressure_above, R(1) + limits.pressure_above);
  const bool is_endless = e.ground_down_m == std::numeric_limits<R>::infinity();
  f.add(is_endless ? kEndless : e.ground_down_m, -kEndless, kEndless);
  return f;
}
constexpr const char* kEnvironmentNames[] = {
    "wind_mps[0]",         "wind_mps[1]",         "wind_mps[2]",       "gust_mps[0][0]",
    "gust_mps[0][1]",      "gust_mps[0][2]",      "gust_mps[1][0]",    "gust_mps[1][1]",
    "gust_mps[1][2]",      "gust_mps[2][0]",      "gust_mps[2][1]",    "gust_mps[2][2]",
    "gust_mps[3][0]",      "gust_mps[3][1]",      "gust_mps[3][2]",    "gust_rates_radps[0]",
    "gust_rates_radps[1]", "gust_rates_radps[2]", "altitude_origin_m", "temperature_offset_k",
    "pressure_ratio",      "ground_down_m"};
static_assert(TR_PLACES == 4, "one name a number");

Fields fields_of(const tr_configuration& c) {
  const LimitTables<R>& limits = aircraft_data<R>().limits;
  Fields f{};
  f.add(c.mast_deg, limits.mast_deg);
  f.add(c.mast_rate_radps, limits.mast_rate);
  f.add(c.mast_acceleration_radps2, limits.mast_acceleration);
  f.add(c.flap_deg, limits.flap_deg);
  f.add(c.rotor_radps, limits.rotor_speed);
  f.add(c.rotor_acceleration_radps2, limits.rotor_acceleration);
  f.add(c.mass_kg, limits.mass);
  f.add(c.cg_station_m, limits.sl_cg);
  f.add(c.cg_waterline_m, limits.wl_cg);
  return f;
}
constexpr const char* kConfigurationNames[] = {"mast_deg", "mast_rate_radps", "mast_acceleration_radps2",
                                               "flap_deg", "rotor_radps",     "rotor_acceleration_radps2",
                                               "mass_kg",  "cg_station_m",    "cg_waterline_m"};

// What has a range and no call that explains it: of tr_setup what tr_configuration has not, and tr_flight.
Fields fields_of_flight() {
  const LimitTables<R>& limits = aircraft_data<R>().limits;
  Fields f{};
  f.add(R(0), limits.altitude);
  f.add(R(0), R(0), limits.speed);
  f.add(R(0), R(-0.5) * kPi<R>, R(0.5) * kPi<R>);
  f.add(R(0), -kMostOfSteadyFlight, kMostOfSteadyFlight);
  f.add(R(0), -kMostOfSteadyFlight, kMostOfSteadyFlight);
  return f;
}
constexpr const char* kFlightNames[] = {"altitude_m", "speed_mps", "climb_rad", "turn_rate_radps",
                                        "sideslip_rad"};

// In the units of tr_control_unit.
Bounds<R> input_range(int input) {
  if (input < TR_CONTROLS) return control_range(aircraft_data<R>(), input);
  const LimitTables<R>& limits = aircraft_data<R>().limits;
  const auto in_rad = [](const Bounds<R>& deg) {
    return Bounds<R>{deg.low * kRadPerDeg<R>, deg.high * kRadPerDeg<R>};
  };
  const Bounds<R> throttle = {R(0), kMostThrottle<R>};
  const Bounds<R> commands[] = {in_rad(limits.mast_deg), in_rad(limits.flap_deg), limits.rotor_speed,
                                throttle, throttle};
  static_assert(sizeof commands / sizeof commands[0] == TR_INPUTS - TR_CONTROLS);
  return commands[input - TR_CONTROLS];
}

Bounds<R> state_range(int state) {
  const R bound = static_cast<R>(vehicle_variable(state).facts().bound);
  return {state == TR_GEAR ? R(0) : -bound, bound};
}

bool find(const char* name, const Fields& f, const char* const* names, Bounds<R>& range) {
  for (int k = 0; k < f.count; ++k)
    if (std::strcmp(name, names[k]) == 0) {
      range = {f.field[k].low, f.field[k].high};
      return true;
    }
  return false;
}

// "x.u", "u.pedal": the place of a name among `count` of them, or -1.
template <class Name>
int place_of(const char* name, const char (&before)[3], int count, Name&& name_of) {
  if (std::strncmp(name, before, 2) != 0) return -1;
  for (int k = 0; k < count; ++k)
    if (std::strcmp(name + 2, name_of(k)) == 0) return k;
  return -1;
}

bool find(const char* name, Bounds<R>& range) {
  const int state = place_of(name, "x.", TR_STATES, [](int k) { return vehicle_variable(k).name; });
  const int input = place_of(name, "u.", TR_INPUTS, [](int k) { return vehicle_input(k).name; });
  if (state >= 0) range = state_range(state);
  if (input >= 0) range = input_range(input);
  return state >= 0 || input >= 0 || find(name, fields_of(tr_systems{}), kSystemsNames, range) ||
         find(name, fields_of(tr_environment{}), kEnvironmentNames, range) ||
         find(name, fields_of(tr_configuration{}), kConfigurationNames, range) ||
         find(name, fields_of_flight(), kFlightNames, range);
}

// The first field that cannot be, unknown choices before what is no number and that before what lies outside.
struct Refusal {
  tr_status status;
  int field;
};
Refusal first_refusal(const Fields& f) {
  const auto outside = [](const Field& x) { return !is_within(x.value, x.low, x.high); };
  for (int k = 0; k < f.choices; ++k)
    if (outside(f.field[k])) return {TR_BAD_ARGUMENT, k};
  for (int k = f.choices; k < f.count; ++k)
    if (!is_finite(f.field[k].value)) return {TR_NOT_FINITE, k};
  for (int k = f.choices; k < f.count; ++k)
    if (outside(f.field[k])) return {TR_OUT_OF_RANGE, k};
  return {TR_OK, 0};
}

template <int count>
tr_status explained(const Fields& f, const char* const (&names)[count], char* text, std::size_t length) {
  const Refusal refusal = first_refusal(f);
  if (refusal.status == TR_OK) return TR_OK;
  const Field& field = f.field[refusal.field];
  constexpr std::size_t longest = 1000;
  Sentence line(text, static_cast<int>(length < longest ? length : longest));
  line << names[refusal.field];
  if (refusal.status == TR_NOT_FINITE) {
    line << " is no finite number";
    if (field.high == kEndless) return refusal.status;
    line << ", which lies in ";
  } else {
    line << " ";
    line.number(static_cast<double>(field.value)) << " lies outside ";
  }
  line.number(static_cast<double>(field.low)) << "..";
  line.number(static_cast<double>(field.high));
  return refusal.status;
}

// Of the calls that explain: what is the same for all.
tr_status begin_text(const void* fields, std::uint32_t version, char* text, std::size_t length) {
  if (text != nullptr && length > 0) text[0] = '\0';
  if (version != TR_API_VERSION) return TR_WRONG_VERSION;
  return fields == nullptr || (text == nullptr && length > 0) ? TR_BAD_ARGUMENT : TR_OK;
}

}  // namespace

tr_status check_systems(const tr_systems& systems) { return first_refusal(fields_of(systems)).status; }
tr_status check_environment(const tr_environment& environment) {
  return first_refusal(fields_of(environment)).status;
}

}  // namespace tiltrotor::c_interface

namespace tiltrotor::c_interface::checked {

tr_status tr_check_systems(const tr_systems* systems, uint32_t version, char* text, size_t length) {
  const tr_status begun = begin_text(systems, version, text, length);
  return begun == TR_OK ? explained(fields_of(*systems), kSystemsNames, text, length) : begun;
}

tr_status tr_check_environment(const tr_environment* environment, uint32_t version, char* text,
                               size_t length) {
  const tr_status begun = begin_text(environment, version, text, length);
  return begun == TR_OK ? explained(fields_of(*environment), kEnvironmentNames, text, length) : begun;
}

tr_status tr_check_configuration(const tr_configuration* configuration, uint32_t version, char* text,
                                 size_t length) {
  const tr_status begun = begin_text(configuration, version, text, length);
  return begun == TR_OK ? explained(fields_of(*configuration), kConfigurationNames, text, length) : begun;
}

tr_status tr_get_range(const char* name, tr_real* low, tr_real* high) {
  Bounds<R> range;
  if (name == nullptr || low == nullptr || high == nullptr || !find(name, range)) return TR_BAD_ARGUMENT;
  *low = range.low;
  *high = range.high;
  return TR_OK;
}

}  // namespace tiltrotor::c_interface::checked

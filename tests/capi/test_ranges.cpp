// Which field of systems, environment and configuration is refused, in words. Expected: names and ranges of the headers, and
// the status of the call that sets it.
#include <string>

#include "capi/conditions.hpp"

using namespace capi;

namespace {

template <class Fields>
using Explain = tr_status (*)(const Fields*, std::uint32_t, char*, std::size_t);

template <class Fields>
std::string words(Explain<Fields> explain, const Fields& fields, tr_status expected) {
  char text[120];
  std::memset(text, '#', sizeof text);
  CHECK_EQ(explain(&fields, TR_API_VERSION, text, sizeof text), expected);
  CHECK_EQ(explain(&fields, TR_API_VERSION, nullptr, 0), expected);
  char cut[6];
  CHECK_EQ(explain(&fields, TR_API_VERSION, cut, sizeof cut), expected);
  CHECK_EQ(std::string(cut), std::string(text).substr(0, 5));
  return text;
}

struct Range {
  const char* name;
  double low, high;
};

std::string shown(double x) {
  std::string text = std::to_string(x);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

// Beyond both ends of its range and where it is no number: `set` answers the status with which the field is refused.
template <class Fields, class Place, class Set>
void check_number(Explain<Fields> explain, const Fields& good, Place place, const Range& range, Set&& set) {
  const std::string around = shown(range.low) + ".." + shown(range.high);
  Fields fields = good;
  for (const double bad : {range.low - 1, range.high + 1}) {
    place(fields) = tr_real(bad);
    CHECK_EQ(set(fields), TR_OUT_OF_RANGE);
    CHECK_EQ(words(explain, fields, TR_OUT_OF_RANGE),
             std::string(range.name) + " " + shown(bad) + " lies outside " + around);
  }
  for (const tr_real bad : {kNan, -kInfinity}) {
    place(fields) = bad;
    CHECK_EQ(set(fields), TR_NOT_FINITE);
    CHECK_EQ(words(explain, fields, TR_NOT_FINITE),
             std::string(range.name) + " is no finite number, which lies in " + around);
  }
}

}  // namespace

TEST(capi_ranges_of_systems_are_told) {
  tr_sim sim = trimmed_sim(0, 20);
  const auto set = [&sim](const tr_systems& s) { return tr_set_systems(&sim, &s); };
  const tr_systems good = systems_of(sim);
  CHECK_EQ(words(tr_check_systems, good, TR_OK), "");
  const struct {
    const char* name;
    std::int32_t tr_systems::*field;
    int last;
  } choices[] = {{"governor", &tr_systems::governor, 2},
                 {"conversion", &tr_systems::conversion, 1},
                 {"engines", &tr_systems::engines, 1},
                 {"actuators", &tr_systems::actuators, 1},
                 {"scas", &tr_systems::scas, 1},
                 {"gear", &tr_systems::gear, 1},
                 {"ground_effect", &tr_systems::ground_effect, 1},
                 {"turbulence", &tr_systems::turbulence, 1},
                 {"interconnect", &tr_systems::interconnect, 1},
                 {"wind_shear", &tr_systems::wind_shear, 2},
                 {"gear_down", &tr_systems::gear_down, 1}};
  for (const auto& choice : choices)
    for (const int bad : {-1, choice.last + 1}) {
      tr_systems s = good;
      s.*choice.field = bad;
      CHECK_EQ(set(s), TR_BAD_ARGUMENT);
      CHECK_EQ(words(tr_check_systems, s, TR_BAD_ARGUMENT), std::string(choice.name) + " " +
                                                                std::to_string(bad) + " lies outside 0.." +
                                                                std::to_string(choice.last));
    }
  tr_systems s = good;
  s.engine_failed[1] = 2;
  CHECK_EQ(words(tr_check_systems, s, TR_BAD_ARGUMENT), "engine_failed[1] 2 lies outside 0..1");
  s.engine_failed[0] = 3;  // the first is named
  CHECK_EQ(words(tr_check_systems, s, TR_BAD_ARGUMENT), "engine_failed[0] 3 lies outside 0..1");

  const struct {
    Range range;
    tr_real& (*place)(tr_systems&);
  } numbers[] = {
      {{"mast_command_deg", 0, 90}, [](tr_systems& x) -> tr_real& { return x.mast_command_deg; }},
      {{"flap_command_deg", 0, 75}, [](tr_systems& x) -> tr_real& { return x.flap_command_deg; }},
      {{"rotor_command_radps", 20, 80}, [](tr_systems& x) -> tr_real& { return x.rotor_command_radps; }},
      {{"throttle[0]", 0, 1.2}, [](tr_systems& x) -> tr_real& { return x.throttle[0]; }},
      {{"throttle[1]", 0, 1.2}, [](tr_systems& x) -> tr_real& { return x.throttle[1]; }},
      {{"turbulence_w20_mps", 0, 50}, [](tr_systems& x) -> tr_real& { return x.turbulence_w20_mps; }},
      {{"brake[0]", 0, 1}, [](tr_systems& x) -> tr_real& { return x.brake[0]; }},
      {{"brake[1]", 0, 1}, [](tr_systems& x) -> tr_real& { return x.brake[1]; }}};
  for (const auto& number : numbers)
    check_number<tr_systems>(tr_check_systems, good, number.place, number.range, set);
}

TEST(capi_ranges_of_the_configuration_are_told) {
  tr_sim sim = trimmed_sim(0, 20);
  const auto set = [&sim](const tr_configuration& c) { return tr_set_configuration(&sim, &c); };
  tr_configuration good;
  CHECK_EQ(tr_get_configuration(&sim, &good), TR_OK);
  CHECK_EQ(words(tr_check_configuration, good, TR_OK), "");
  const struct {
    Range range;
    tr_real tr_configuration::*field;
  } numbers[] = {{{"mast_deg", 0, 90}, &tr_configuration::mast_deg},
                 {{"mast_rate_radps", -1, 1}, &tr_configuration::mast_rate_radps},
                 {{"mast_acceleration_radps2", -10, 10}, &tr_configuration::mast_acceleration_radps2},
                 {{"flap_deg", 0, 75}, &tr_configuration::flap_deg},
                 {{"rotor_radps", 20, 80}, &tr_configuration::rotor_radps},
                 {{"rotor_acceleration_radps2", -50, 50}, &tr_configuration::rotor_acceleration_radps2},
                 {{"mass_kg", 3000, 10000}, &tr_configuration::mass_kg},
                 {{"cg_station_m", 7, 8}, &tr_configuration::cg_station_m},
                 {{"cg_waterline_m", 1.5, 2.5}, &tr_configuration::cg_waterline_m}};
  for (const auto& number : numbers)
    check_number<tr_configuration>(
        tr_check_configuration, good, [&number](tr_configuration& c) -> tr_real& { return c.*number.field; },
        number.range, set);
}

TEST(capi_ranges_of_the_environment_are_told) {
  tr_sim sim = trimmed_sim(0, 20);
  const auto set = [&sim](const tr_environment& e) { return tr_set_environment(&sim, &e); };
  tr_environment good;
  CHECK_EQ(tr_default_environment(&good), TR_OK);
  CHECK_EQ(words(tr_check_environment, good, TR_OK), "");
  const auto check = [&](const std::string& name, double most, auto place) {
    check_number<tr_environment>(tr_check_environment, good, place, {name.c_str(), -most, most}, set);
  };
  for (int k = 0; k < 3; ++k) {
    const std::string part = "[" + std::to_string(k) + "]";
    check("wind_mps" + part, 100, [k](tr_environment& e) -> tr_real& { return e.wind_mps[k]; });
    check("gust_rates_radps" + part, 2, [k](tr_environment& e) -> tr_real& { return e.gust_rates_radps[k]; });
    for (int at = 0; at < TR_PLACES; ++at)
      check("gust_mps[" + std::to_string(at) + "]" + part, 50,
            [=](tr_environment& e) -> tr_real& { return e.gust_mps[at][k]; });
  }
  check("temperature_offset_k", 60, [](tr_environment& e) -> tr_real& { return e.temperature_offset_k; });
  check_number<tr_environment>(
      tr_check_environment, good, [](tr_environment& e) -> tr_real& { return e.pressure_ratio; },
      {"pressure_ratio", 0.8, 1.2}, set);
  // A ground or an origin may lie anywhere, that there is none apart.
  tr_environment e = good;
  e.ground_down_m = -kInfinity;
  CHECK_EQ(set(e), TR_NOT_FINITE);
  CHECK_EQ(words(tr_check_environment, e, TR_NOT_FINITE), "ground_down_m is no finite number");
  e.altitude_origin_m = kNan;
  CHECK_EQ(words(tr_check_environment, e, TR_NOT_FINITE), "altitude_origin_m is no finite number");
}

TEST(capi_ranges_refuse_what_cannot_be_asked) {
  tr_systems systems;
  CHECK_EQ(tr_default_systems(&systems), TR_OK);
  systems.gear = 7;
  char text[80] = "left";
  CHECK_EQ(tr_check_systems(&systems, TR_API_VERSION + 1, text, sizeof text), TR_WRONG_VERSION);
  CHECK_EQ(std::string(text), "");
  CHECK_EQ(tr_check_systems(nullptr, TR_API_VERSION, text, sizeof text), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_check_environment(nullptr, TR_API_VERSION, text, sizeof text), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_check_configuration(nullptr, TR_API_VERSION, text, sizeof text), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_check_systems(&systems, TR_API_VERSION, nullptr, 1), TR_BAD_ARGUMENT);
}

namespace {

// As the call that sets the number sees them: both ends are accepted, beyond either it is refused.
template <class Set>
void check_ends(const std::string& name, Set&& set, tr_real spare = 0) {
  tr_real low = 1, high = 0;
  if (!CHECK_EQ(tr_get_range(name.c_str(), &low, &high), TR_OK)) NOTE(name);
  CHECK_LT(low, high);
  const tr_real beyond = tr_real(1e-3) * (high - low);
  for (const tr_real inside : {low + spare, high - spare})
    if (!CHECK_EQ(set(inside), TR_OK)) NOTE(name << " " << inside);
  for (const tr_real outside : {low - beyond, high + beyond})
    if (!CHECK_EQ(set(outside), TR_OUT_OF_RANGE)) NOTE(name << " " << outside);
}

}  // namespace

// Expected: what tr_set_controls, tr_set_systems, tr_set_state, tr_init and tr_trim accept.
TEST(capi_ranges_by_name_are_those_of_the_calls) {
  tr_sim sim = trimmed_sim(0, 20);
  for (int j = 0; j < TR_CONTROLS; ++j)
    check_ends(std::string("u.") + tr_control_name(j), [&](tr_real value) {
      tr_real u[TR_CONTROLS] = {};
      u[j] = value;
      return tr_set_controls(&sim, u, TR_CONTROLS);
    });
  tr_systems of_commands = systems_of(sim);
  const double in_rad = std::acos(-1.0) / 180;
  const struct {
    int input;
    tr_real* place;
    double unit;
  } commands[] = {{0, &of_commands.mast_command_deg, in_rad},
                  {1, &of_commands.flap_command_deg, in_rad},
                  {2, &of_commands.rotor_command_radps, 1},
                  {3, &of_commands.throttle[0], 1},
                  {4, &of_commands.throttle[1], 1}};
  for (const auto& command : commands)
    check_ends(
        std::string("u.") + tr_control_name(TR_CONTROLS + command.input),
        [&](tr_real value) {
          const tr_real before = *command.place;
          *command.place = tr_real(static_cast<double>(value) / command.unit);
          const tr_status status = tr_set_systems(&sim, &of_commands);
          *command.place = before;
          return status;
        },
        tr_real(1e-6));
  for (int i = 0; i < TR_STATES; ++i) {
    tr_state state = state_of(sim);
    check_ends(std::string("x.") + tr_state_name(i), [&](tr_real value) {
      state.x[i] = value;
      return tr_set_state(&sim, &state);
    });
  }
  tr_setup setup;
  CHECK_EQ(tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0), 0), TR_OK);
  check_ends("altitude_m", [&](tr_real value) {
    setup.altitude_m = value;
    return tr_check_setup(&setup, TR_API_VERSION, nullptr, 0);
  });
  // A trim within the range may fail, with another status.
  static tr_work work;
  const struct {
    const char* name;
    tr_real tr_flight::*field;
  } flights[] = {{"speed_mps", &tr_flight::speed_mps},
                 {"climb_rad", &tr_flight::climb_rad},
                 {"turn_rate_radps", &tr_flight::turn_rate_radps},
                 {"sideslip_rad", &tr_flight::sideslip_rad}};
  for (const auto& flight : flights)
    check_ends(flight.name, [&](tr_real value) {
      tr_flight wanted = {30, 0, 0, 0};
      wanted.*flight.field = value;
      return tr_trim(&sim, &work, &wanted, nullptr) == TR_OUT_OF_RANGE ? TR_OUT_OF_RANGE : TR_OK;
    });
  const struct {
    const char* name;
    double low, high;
  } fields[] = {
      {"throttle[1]", 0, 1.2}, {"wind_mps[2]", -100, 100}, {"mast_rate_radps", -1, 1}, {"scas", 0, 1}};
  for (const auto& field : fields) {
    tr_real low = 1, high = 0;
    CHECK_EQ(tr_get_range(field.name, &low, &high), TR_OK);
    CHECK_EQ(low, tr_real(field.low));
    CHECK_EQ(high, tr_real(field.high));
  }
  tr_real low = 0, high = 0;
  for (const char* const none : {"", "u.", "x.pedal", "u.theta", "pedal", "wind_mps"})
    CHECK_EQ(tr_get_range(none, &low, &high), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_get_range(nullptr, &low, &high), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_get_range("u.pedal", nullptr, &high), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_get_range("u.pedal", &low, nullptr), TR_BAD_ARGUMENT);
}

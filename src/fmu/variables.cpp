#include "fmu/variables.hpp"

#include <cmath>
#include <cstdio>
#include <cstring>

namespace tiltrotor_fmu {

namespace {

constexpr double kRightAngle = 90 * kRadians;
constexpr double kAny = 1e300;  // ranges of the aircraft: the library knows them
constexpr Type F = Type::float64, B = Type::boolean, E = Type::enumeration;

constexpr SettingFacts kSettingFacts[] = {
    {"mast", "rad", F, 0, 0, kRightAngle, "mast angle, 0 helicopter, 90 deg airplane"},
    {"flap", "rad", F, 0, 0, kRightAngle, "flaps; the start value stands for the default by mast angle"},
    {"rotor_speed", "rad/s", F, 0, -kAny, kAny,
     "rotor speed; the start value stands for the default by mast angle"},
    {"mass", "kg", F, 0, -kAny, kAny, "mass"},
    {"cg_station", "m", F, 0, -kAny, kAny, "station of the centre of gravity, masts at 0"},
    {"altitude", "m", F, 0, -kAny, kAny, "of the air's density; of down = 0 where the environment is on"},
    {"grid", "", E, 1, 1, 2, "blade elements"},
    {"tables", "", E, 1, 1, 2, "interpolation of the tables"},
    {"coning", "", B, 0, 0, 1, "coning of the rotors is a state"},
    {"trim", "", B, 1, 0, 1,
     "begin in the steady flight of speed, climb, turn_rate and sideslip; states and inputs that are set to other than "
     "their start values stay as set"},
    {"speed", "m/s", F, 0, 0, kAny, "airspeed of the steady flight"},
    {"climb", "rad", F, 0, -kRightAngle, kRightAngle, "its flight path, up"},
    {"turn_rate", "rad/s", F, 0, -60 * kRadians, 60 * kRadians, "its turn rate, to the right"},
    {"sideslip", "rad", F, 0, -60 * kRadians, 60 * kRadians, "its sideslip, wind from the right"},
    {"environment", "", B, 0, 0, 1, "air follows the altitude; wind and ground are there"},
    {"temperature_offset", "K", F, 0, -60, 60, "from the standard atmosphere"},
    {"pressure_ratio", "", F, 1, 0.8, 1.2, "to the standard atmosphere"},
    {"ground_down", "m", F, 0, -1e9, 1e9, "down of the ground of gear, ground effect and wind shear"},
    {"governor", "", E, 0, 0, 2, "governor of the rotor speed"},
    {"conversion", "", B, 0, 0, 1, "masts and flaps follow their commands"},
    {"engines", "", B, 0, 0, 1, "engines with lag, rate limit and fuel"},
    {"actuators", "", B, 0, 0, 1, "actuators with lag, rate limit and stops"},
    {"scas", "", B, 0, 0, 1, "stability augmentation; in Co-Simulation"},
    {"gear", "", B, 0, 0, 1, "landing gear; needs the environment"},
    {"ground_effect", "", B, 0, 0, 1, "ground effect; needs the environment"},
    {"wind_shear", "", E, 0, 0, 2, "wind that grows with height; needs the environment"},
    {"turbulence", "", B, 0, 0, 1, "Dryden turbulence; in Co-Simulation"},
    {"interconnect", "", B, 0, 0, 1, "the shaft between the rotors twists, with governor pi"},
    {"turbulence_seed", "", Type::uint32, 0, 0, 4294967295.0, "of the turbulence"},
    {"turbulence_w20", "m/s", F, 0, 0, 50,
     "wind 20 ft above the ground, which says how strong the turbulence is"},
    {"longest_step", "s", F, 0.01, 1e-6, 0.02,
     "of Co-Simulation: longer communication steps are cut into equal parts"},
    {"wind_north", "m/s", F, 0, -100, 100, "wind; needs the environment"},
    {"wind_east", "m/s", F, 0, -100, 100, "wind; needs the environment"},
    {"wind_down", "m/s", F, 0, -100, 100, "wind; needs the environment"},
    {"brake_R", "", F, 0, 0, 1, "brake of the right main wheel"},
    {"brake_L", "", F, 0, 0, 1, "brake of the left main wheel"},
    {"gear_down", "", B, 1, 0, 1, "landing gear down; in Co-Simulation it takes its time"},
    {"engine_failed_R", "", B, 0, 0, 1, "right engine gives no power"},
    {"engine_failed_L", "", B, 0, 0, 1, "left engine gives no power"},
};
static_assert(sizeof kSettingFacts / sizeof kSettingFacts[0] == kSettings, "one row a setting");

constexpr OutputFacts kOutputFacts[] = {
    {"airspeed", "m/s", "relative to the air at the aircraft"},
    {"angle_of_attack", "rad", "of the body"},
    {"sideslip", "rad", "wind from the right"},
    {"specific_force_x", "m/s2", "at the centre of gravity"},
    {"specific_force_y", "m/s2", "at the centre of gravity"},
    {"specific_force_z", "m/s2", "at the centre of gravity"},
    {"load_factor", "", "normal to the motion through the air"},
    {"climb_rate", "m/s", "relative to the undisturbed air"},
    {"thrust_R", "N", "force of the right rotor on its hub"},
    {"thrust_L", "N", "force of the left rotor on its hub"},
    {"torque_R", "N.m", "of the right mast"},
    {"torque_L", "N.m", "of the left mast"},
    {"power_R", "W", "at the right mast"},
    {"power_L", "W", "at the left mast"},
    {"collective_R", "rad", "blade pitch at 0.75 radius"},
    {"collective_L", "rad", "blade pitch at 0.75 radius"},
    {"long_cyclic_R", "rad", "longitudinal cyclic"},
    {"long_cyclic_L", "rad", "longitudinal cyclic"},
    {"gimbal_tilt_R", "rad", "tilt of the right gimbal"},
    {"gimbal_tilt_L", "rad", "tilt of the left gimbal"},
    {"elevator", "rad", "deflection"},
    {"aileron", "rad", "deflection"},
    {"rudder", "rad", "deflection"},
};
static_assert(sizeof kOutputFacts / sizeof kOutputFacts[0] == TR_OUTPUTS, "one row an output");

bool among(int index, std::uint64_t places) {
  return index >= 0 && index < 64 && ((places >> index) & 1u) != 0;
}
constexpr std::uint64_t bit(int place) { return std::uint64_t{1} << place; }

// Kinematics know a few states; forces may know all.
constexpr std::uint64_t kRates = bit(TR_P) | bit(TR_Q) | bit(TR_R);
constexpr std::uint64_t kBank = bit(TR_ROLL) | bit(TR_PITCH);
constexpr std::uint64_t kSpeeds = bit(TR_U) | bit(TR_V) | bit(TR_W);
constexpr std::uint64_t kEverything = ~std::uint64_t{0};

std::uint64_t states_of_rate(int state) {
  switch (state) {
    case TR_ROLL:
      return kRates | kBank;
    case TR_PITCH:
      return bit(TR_Q) | bit(TR_R) | bit(TR_ROLL);
    case TR_YAW:
      return bit(TR_Q) | bit(TR_R) | kBank;
    case TR_ROTOR_RIGHT + TR_B1C:
    case TR_ROTOR_RIGHT + TR_B1S:
    case TR_ROTOR_LEFT + TR_B1C:
    case TR_ROTOR_LEFT + TR_B1S:
      return bit(state + 2);
    case TR_CONING_RIGHT:
    case TR_CONING_LEFT:
      return bit(state + 1);
    case TR_MAST:
      return bit(TR_MAST_RATE);
    case TR_SHAFT_TWIST:
      return bit(TR_TWIST_RATE);
    default:
      return kEverything;
  }
}

}  // namespace

Place place_of(std::uint32_t reference) {
  for (int role = 0; role < static_cast<int>(Role::none); ++role)
    if (reference >= kFirst[role] && reference - kFirst[role] < static_cast<std::uint32_t>(kCount[role]))
      return {static_cast<Role>(role), static_cast<int>(reference - kFirst[role])};
  return {Role::none, 0};
}

const SettingFacts& facts_of(int setting) { return kSettingFacts[setting]; }
const OutputFacts& output_facts(int output) { return kOutputFacts[output]; }

Type type_of(Place place) { return place.role == Role::setting ? facts_of(place.index).type : Type::float64; }

const char* name_of(Place place) {
  switch (place.role) {
    case Role::state:
    case Role::rate:
      return tr_state_name(place.index);
    case Role::input:
      return tr_control_name(place.index);
    case Role::output:
      return output_facts(place.index).name;
    case Role::setting:
      return facts_of(place.index).name;
    default:
      return "time";
  }
}

const char* unit_of(Place place) {
  const bool of_state = place.role == Role::state || place.role == Role::rate;
  const char* unit = of_state                      ? tr_state_unit(place.index)
                     : place.role == Role::input   ? tr_control_unit(place.index)
                     : place.role == Role::output  ? output_facts(place.index).unit
                     : place.role == Role::setting ? facts_of(place.index).unit
                                                   : "s";
  return std::strcmp(unit, "-") == 0 ? "" : unit;
}

double nominal_of(const char* unit) {
  constexpr struct {
    const char* unit;
    double nominal;
  } kNominals[] = {{"m/s", 10}, {"rad/s", 0.1}, {"rad", 0.1}, {"m", 100}, {"W", 1e5}, {"kg", 100}, {"in", 1}};
  for (const auto& row : kNominals)
    if (std::strcmp(unit, row.unit) == 0) return row.nominal;
  return 0.01;  // inflow over tip speed
}

bool depends(Place unknown, Place known) {
  if (known.role != Role::state && known.role != Role::input) return false;
  if (known.role == Role::state && known.index >= kContinuousStates) return false;
  const int index = known.index;
  const bool state = known.role == Role::state;
  if (unknown.role == Role::state) return state && index == unknown.index;
  if (unknown.role == Role::rate) {
    if (unknown.index >= TR_NORTH && unknown.index <= TR_DOWN)
      return state && among(index, kSpeeds | kBank | bit(TR_YAW) | bit(TR_DOWN));  // down: along a wind shear
    const std::uint64_t states = states_of_rate(unknown.index);
    return states == kEverything || (state && among(index, states));
  }
  // Velocity of the airframe relative to the air; moving masts move it against the centre of gravity.
  if (unknown.role == Role::output && unknown.index < 3)
    return state ? among(index, kSpeeds | bit(TR_MAST) | bit(TR_MAST_RATE))
                 : index >= TR_GUST_U && index <= TR_GUST_W;
  return unknown.role == Role::output;
}

void instantiation_token(char (&token)[64]) {
  std::uint64_t hash = TR_HASH_START;
  const auto add = [&hash](const char* text) {
    for (; *text != 0; ++text) hash = (hash ^ static_cast<unsigned char>(*text)) * UINT64_C(1099511628211);
  };
  for (int role = 0; role < static_cast<int>(Role::none); ++role)
    for (int i = 0; i < kCount[role]; ++i) {
      add(name_of({static_cast<Role>(role), i}));
      add(unit_of({static_cast<Role>(role), i}));
    }
  add(tr_aircraft_description(tr_aircraft_at(0)));
  std::snprintf(token, sizeof token, "{tiltrotor-%s-%08x-%016llx}", tr_version(), TR_API_VERSION,
                static_cast<unsigned long long>(hash));
}

double degrees(double rad) {
  const double exact = rad / kRadians;
  const double whole = std::round(exact);
  return std::abs(exact - whole) < 1e-12 * (1 + std::abs(whole)) ? whole : exact;
}

}  // namespace tiltrotor_fmu

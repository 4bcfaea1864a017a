#include "fmu/variables.hpp"

#include <cmath>
#include <cstdio>
#include <cstring>

namespace tiltrotor_fmu {

namespace {

constexpr double kFarthest = 1e9;  // m, of positions
constexpr Type F = Type::float64, B = Type::boolean, E = Type::enumeration;

constexpr SettingFacts kSettingFacts[] = {
    {"mast", "rad", F, 0, "mast_deg", "mast angle, 0 helicopter, 90 deg airplane"},
    {"flap", "rad", F, 0, "flap_deg", "flaps; the start value stands for the default by mast angle"},
    {"rotor_speed", "rad/s", F, 0, "rotor_radps",
     "rotor speed; the start value stands for the default by mast angle"},
    {"mass", "kg", F, 0, "mass_kg", "mass"},
    {"cg_station", "m", F, 0, "cg_station_m", "station of the centre of gravity, masts at 0"},
    {"altitude", "m", F, 0, "altitude_m", "of the air's density; of down = 0 where the environment is on"},
    {"grid", "", E, 1, nullptr, "blade elements", 1, 2},
    {"tables", "", E, 1, nullptr, "interpolation of the tables", 1, 2},
    {"coning", "", B, 0, nullptr, "coning of the rotors is a state", 0, 1},
    {"trim", "", B, 1, nullptr,
     "begin in the steady flight of speed, climb, turn_rate and sideslip; states and inputs that are set to other than "
     "their start values stay as set",
     0, 1},
    {"speed", "m/s", F, 0, "speed_mps", "airspeed of the steady flight"},
    {"climb", "rad", F, 0, "climb_rad", "its flight path, up"},
    {"turn_rate", "rad/s", F, 0, "turn_rate_radps", "its turn rate, to the right"},
    {"sideslip", "rad", F, 0, "sideslip_rad", "its sideslip, wind from the right"},
    {"environment", "", B, 0, nullptr, "air follows the altitude; wind and ground are there", 0, 1},
    {"temperature_offset", "K", F, 0, "temperature_offset_k",
     "from the standard atmosphere; needs the environment"},
    {"pressure_ratio", "", F, 1, "pressure_ratio", "to the standard atmosphere; needs the environment"},
    {"ground_down", "m", F, 0, nullptr, "down of the ground of gear, ground effect and wind shear",
     -kFarthest, kFarthest},
    {"governor", "", E, 0, "governor", "governor of the rotor speed"},
    {"conversion", "", B, 0, "conversion", "masts and flaps follow their commands"},
    {"engines", "", B, 0, "engines", "engines with lag, rate limit and fuel"},
    {"actuators", "", B, 0, "actuators", "actuators with lag, rate limit and stops"},
    {"scas", "", B, 0, "scas", "stability augmentation; in Co-Simulation"},
    {"gear", "", B, 0, "gear", "landing gear; needs the environment"},
    {"ground_effect", "", B, 0, "ground_effect", "ground effect; needs the environment"},
    {"wind_shear", "", E, 0, "wind_shear", "wind that grows with height; needs the environment"},
    {"turbulence", "", B, 0, "turbulence", "Dryden turbulence; in Co-Simulation"},
    {"interconnect", "", B, 0, "interconnect", "the shaft between the rotors twists; needs governor pi"},
    {"turbulence_seed", "", Type::uint32, 0, nullptr, "of the turbulence", 0, 4294967295.0},
    {"turbulence_w20", "m/s", F, 0, "turbulence_w20_mps",
     "wind 20 ft above the ground, which says how strong the turbulence is"},
    {"longest_step", "s", F, 0.01, nullptr,
     "longer communication steps are cut into equal parts; in Co-Simulation", 1e-6, 0.02},
    {"wind_north", "m/s", F, 0, "wind_mps[0]", "wind; needs the environment"},
    {"wind_east", "m/s", F, 0, "wind_mps[1]", "wind; needs the environment"},
    {"wind_down", "m/s", F, 0, "wind_mps[2]", "wind; needs the environment"},
    {"brake_R", "", F, 0, "brake[0]", "brake of the right main wheel; needs the gear"},
    {"brake_L", "", F, 0, "brake[1]", "brake of the left main wheel; needs the gear"},
    {"gear_down", "", B, 1, "gear_down",
     "landing gear down; needs the gear; in Co-Simulation it takes its time"},
    {"engine_failed_R", "", B, 0, "engine_failed[0]",
     "right engine gives no power; needs a governor or engines"},
    {"engine_failed_L", "", B, 0, "engine_failed[1]",
     "left engine gives no power; needs a governor or engines"},
};
static_assert(sizeof kSettingFacts / sizeof kSettingFacts[0] == kSettings, "one row a setting");

// Force and moment of a component.
#define AXES(name, unit, text) \
  {name "_x", unit, text ", body x"}, {name "_y", unit, text ", body y"}, { name "_z", unit, text ", body z" }
#define LOADS(component, of)                  \
  AXES(component "_force", "N", "force " of), \
      AXES(component "_moment", "N.m", "moment about the centre of gravity " of)

constexpr OutputFacts kOutputFacts[] = {
    {"airspeed", "m/s", "relative to the air at the aircraft"},
    {"angle_of_attack", "rad", "of the body"},
    {"sideslip", "rad", "wind from the right"},
    {"specific_force_x", "m/s2", "at the centre of gravity"},
    {"specific_force_y", "m/s2", "at the centre of gravity"},
    {"specific_force_z", "m/s2", "at the centre of gravity"},
    {"load_factor", "", "normal to the motion through the air"},
    {"climb_rate", "m/s", "relative to the undisturbed air"},
    {"thrust_right", "N", "force of the right rotor on its hub"},
    {"thrust_left", "N", "force of the left rotor on its hub"},
    {"torque_right", "N.m", "of the right mast"},
    {"torque_left", "N.m", "of the left mast"},
    {"power_right", "W", "at the right mast"},
    {"power_left", "W", "at the left mast"},
    {"collective_right", "rad", "blade pitch at 0.75 radius"},
    {"collective_left", "rad", "blade pitch at 0.75 radius"},
    {"long_cyclic_right", "rad", "longitudinal cyclic"},
    {"long_cyclic_left", "rad", "longitudinal cyclic"},
    {"gimbal_tilt_right", "rad", "tilt of the right gimbal"},
    {"gimbal_tilt_left", "rad", "tilt of the left gimbal"},
    {"elevator", "rad", "deflection"},
    {"aileron", "rad", "deflection"},
    {"rudder", "rad", "deflection"},
    {"nx", "", "specific force along body x over gravity"},
    {"ny", "", "specific force along body y over gravity"},
    {"nz", "", "specific force against body z over gravity: 1 in level flight"},
    {"flight_path_angle", "rad", "of the path through the undisturbed air above the horizon, 0 at rest"},
    {"mast", "rad", "mast angle as it is, the conversion drive on or off"},
    {"flap", "rad", "flaps as they are, the conversion drive on or off"},
    {"rotor_speed", "rad/s", "rotor speed as it is, whatever governs it"},
    {"wing_angle_of_attack", "rad", "of the part of the wing that no wake covers"},
    {"htail_angle_of_attack", "rad", "of the horizontal tail, with incidence, wash and downwash"},
    LOADS("rotor_right", "of the right rotor"),
    LOADS("rotor_left", "of the left rotor"),
    LOADS("wing_wake_right", "of the wing in the wake of the right rotor"),
    LOADS("wing_wake_left", "of the wing in the wake of the left rotor"),
    LOADS("wing_free", "of the wing that no wake covers"),
    LOADS("pylon", "of the pylons where they meet the wing"),
    LOADS("spinners", "of the spinners"),
    LOADS("pylon_side", "of the pylons in flow from the side"),
    LOADS("fuselage", "of the fuselage"),
    LOADS("htail", "of the horizontal tail"),
    LOADS("fin_right", "of the right fin"),
    LOADS("fin_left", "of the left fin"),
    LOADS("engine_jets", "of the engines' jets (off: 0)"),
    LOADS("total_aero", "of all components"),
};
#undef LOADS
#undef AXES
static_assert(sizeof kOutputFacts / sizeof kOutputFacts[0] == kOutputs, "one row an output");

constexpr const char* kWheelNames[] = {"nose", "right", "left"};
static_assert(sizeof kWheelNames / sizeof kWheelNames[0] == kWheels, "one name a wheel");

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
    case Role::indicator:
      return kWheelNames[place.index];
    default:
      return "time";
  }
}

const char* unit_of(Place place) {
  const bool of_state = place.role == Role::state || place.role == Role::rate;
  const char* unit = of_state                        ? tr_state_unit(place.index)
                     : place.role == Role::input     ? tr_control_unit(place.index)
                     : place.role == Role::output    ? output_facts(place.index).unit
                     : place.role == Role::setting   ? facts_of(place.index).unit
                     : place.role == Role::indicator ? "m"
                                                     : "s";
  return std::strcmp(unit, "-") == 0 ? "" : unit;
}

FullName full_name(Place place) {
  const bool is_input = place.role == Role::setting && place.index >= kFirstInputSetting;
  const char* const before = place.role == Role::state               ? "state."
                             : place.role == Role::rate              ? "der(state."
                             : place.role == Role::output            ? "output."
                             : place.role == Role::indicator         ? "wheel_height."
                             : is_input || place.role == Role::input ? "input."
                             : place.role == Role::setting           ? "parameter."
                                                                     : "";
  FullName name;
  std::snprintf(name.text, sizeof name.text, "%s%s%s", before, name_of(place),
                place.role == Role::rate ? ")" : "");
  return name;
}

Range range_of(Place place) {
  Range range = {-HUGE_VAL, HUGE_VAL};
  const char* field = nullptr;
  char name[64];
  if (place.role == Role::setting) {
    const SettingFacts& facts = facts_of(place.index);
    field = facts.field;
    if (field == nullptr) return {facts.least, facts.most};
  } else if (place.role == Role::state || place.role == Role::input) {
    std::snprintf(name, sizeof name, "%s%s", place.role == Role::state ? "x." : "u.", name_of(place));
    field = name;
  }
  if (field == nullptr || tr_get_range(field, &range.low, &range.high) != TR_OK) return range;
  const std::size_t length = std::strlen(field);
  const bool in_degrees = length > 4 && std::strcmp(field + length - 4, "_deg") == 0;
  return in_degrees ? Range{range.low * kRadians, range.high * kRadians} : range;
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

int state_of_output(int output) {
  return output == kOutputMast ? int{TR_MAST} : output == kOutputFlap ? int{TR_FLAP} : int{TR_ROTOR_SPEED};
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
  // The ground is level.
  if (unknown.role == Role::indicator)
    return state && among(index, kBank | bit(TR_DOWN) | bit(TR_MAST) | bit(TR_FUEL));
  if (unknown.role != Role::output) return false;
  // Velocity of the airframe relative to the air; moving masts move it against the centre of gravity.
  if (unknown.index < 3)
    return state ? among(index, kSpeeds | bit(TR_MAST) | bit(TR_MAST_RATE))
                 : index >= TR_GUST_U && index <= TR_GUST_W;
  if (unknown.index >= kOutputJets && unknown.index < kOutputJets + kNumbersOfLoads) return false;  // off
  switch (unknown.index) {
    case kOutputFlightPath:
      return state && among(index, kSpeeds | kBank);
    case kOutputMast:
    case kOutputFlap:
    case kOutputRotorSpeed:
      return state && index == state_of_output(unknown.index);
    default:
      return true;
  }
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

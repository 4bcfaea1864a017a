// The C interface: an aircraft in bytes.
//
// The image holds the setup and the state; what a configuration computes from the setup is computed again,
// and is the same bits on every machine. Numbers lie in a fixed order, little-endian:
//
//   magic 8 | format 4 | TR_API_VERSION 4 | tables and library 8 | setup | state | FNV-1a of all before it 8
#include <cstring>
#include <type_traits>

#include "library/c_ranges.hpp"
#include "library/c_state.hpp"
#include "library/c_systems.hpp"
#include "library/c_words.hpp"

namespace tiltrotor::c_interface {

namespace {

constexpr unsigned char kMagic[8] = {'t', 'r', 's', 'a', 'v', 'e', 'd', 0x1a};
constexpr std::uint32_t kFormat = 3;

// Least significant byte first. Out of line: there are many numbers, and little memory for code on a target.
TILTROTOR_NOINLINE void put(std::uint64_t bits, std::size_t bytes, unsigned char* to) {
  for (std::size_t k = 0; k < bytes; ++k) to[k] = static_cast<unsigned char>(bits >> (8 * k));
}
TILTROTOR_NOINLINE std::uint64_t taken(std::size_t bytes, const unsigned char* from) {
  std::uint64_t bits = 0;
  for (std::size_t k = 0; k < bytes; ++k) bits |= std::uint64_t{from[k]} << (8 * k);
  return bits;
}

template <class T>
using Bits = std::conditional_t<sizeof(T) == 8, std::uint64_t,
                                std::conditional_t<sizeof(T) == 4, std::uint32_t, unsigned char>>;

class Writer {
 public:
  explicit Writer(unsigned char* to) : to_(to) {}
  template <class T>
  void operator()(const T& number) {
    Bits<T> bits;
    std::memcpy(&bits, &number, sizeof number);
    put(bits, sizeof number, to_);
    to_ += sizeof number;
  }

 private:
  unsigned char* to_;
};

class Reader {
 public:
  explicit Reader(const unsigned char* from) : from_(from) {}
  template <class T>
  void operator()(T& number) {
    const auto bits = static_cast<Bits<T>>(taken(sizeof number, from_));
    std::memcpy(&number, &bits, sizeof number);
    from_ += sizeof number;
  }

 private:
  const unsigned char* from_;
};

class Counter {
 public:
  template <class T>
  constexpr void operator()(const T&) {
    bytes += sizeof(T);
  }
  std::size_t bytes = 0;
};

struct Header {
  unsigned char magic[8];
  std::uint32_t format, version;
  std::uint64_t identity;
};

template <class H, class Visit>
constexpr void each_of_header(H& header, Visit&& visit) {
  for (auto& c : header.magic) visit(c);
  visit(header.format);
  visit(header.version);
  visit(header.identity);
}

// What may change in flight and is not in the setup.
struct Conditions {
  R mast_rate, mast_acceleration, rotor_acceleration, wl_cg;
  tr_environment environment;
  std::uint32_t air_follows;
  Loads<R> outside;
  tr_systems systems;
  std::uint32_t scas_fades;
  R loaded_mass;
};

template <class Saved, class Visit>
constexpr void each_of_conditions(Saved& saved, Visit&& visit) {
  visit(saved.mast_rate);
  visit(saved.mast_acceleration);
  visit(saved.rotor_acceleration);
  visit(saved.wl_cg);
  auto& e = saved.environment;
  for (auto& wind : e.wind_mps) visit(wind);
  for (auto& gust : e.gust_mps)
    for (auto& component : gust) visit(component);
  for (auto& rate : e.gust_rates_radps) visit(rate);
  visit(e.altitude_origin_m);
  visit(e.temperature_offset_k);
  visit(e.pressure_ratio);
  visit(e.ground_down_m);
  visit(saved.air_follows);
  Loads<R>::each(saved.outside, visit);
  auto& y = saved.systems;
  visit(y.governor);
  visit(y.conversion);
  visit(y.engines);
  visit(y.actuators);
  visit(y.scas);
  visit(y.gear);
  visit(y.ground_effect);
  visit(y.turbulence);
  visit(y.interconnect);
  visit(y.wind_shear);
  visit(y.mast_command_deg);
  visit(y.flap_command_deg);
  visit(y.rotor_command_radps);
  for (auto& throttle : y.throttle) visit(throttle);
  visit(y.gear_down);
  for (auto& failed : y.engine_failed) visit(failed);
  for (auto& brake : y.brake) visit(brake);
  visit(y.turbulence_seed);
  visit(y.turbulence_w20_mps);
  visit(saved.scas_fades);
  visit(saved.loaded_mass);
}

template <class Setup, class State, class Visit>
constexpr void each_of_flight(Setup& setup, State& state, Visit&& visit) {
  visit(setup.aircraft);
  visit(setup.grid);
  visit(setup.tables);
  visit(setup.coning_states);
  visit(setup.mast_deg);
  visit(setup.flap_deg);
  visit(setup.altitude_m);
  visit(setup.mass_kg);
  visit(setup.rotor_radps);
  visit(setup.cg_station_m);
  visit(state.time_s);
  visit(state.steps);
  for (auto& x : state.x) visit(x);
  for (auto& u : state.u) visit(u);
  visit(state.roll_rad);
  visit(state.yaw_rad);
  for (auto& position : state.position_m) visit(position);
}

constexpr std::size_t bytes_of_header() {
  Counter counter;
  const Header header{};
  each_of_header(header, counter);
  return counter.bytes;
}
constexpr std::size_t bytes_of_flight() {
  Counter counter;
  const tr_setup setup{};
  const tr_state state{};
  each_of_flight(setup, state, counter);
  const Conditions conditions{};
  each_of_conditions(conditions, counter);
  return counter.bytes;
}
constexpr std::size_t kHeaderBytes = bytes_of_header();
constexpr std::size_t kChecked = kHeaderBytes + bytes_of_flight();
constexpr std::size_t kSavedBytes = kChecked + sizeof(std::uint64_t);
static_assert(kSavedBytes <= TR_SAVED_SIZE);

std::uint64_t hash_of(const unsigned char* bytes, std::size_t length) {
  std::uint64_t hash = TR_HASH_START;
  for (std::size_t k = 0; k < length; ++k) hash = hashed(hash, bytes[k]);
  return hash;
}

// What the same setup and state would fly on otherwise: other tables, another library.
std::uint64_t identity() {
  const char* const version = TILTROTOR_VERSION;
  return hashed(hash_of(reinterpret_cast<const unsigned char*>(version), std::strlen(version)),
                aircraft_fingerprint());
}

Conditions conditions_of(const Sim& s) {
  const FlightSetup<R>& setup = s.configuration.setup;
  Conditions c{
      setup.mast_rate, setup.mast_acceleration, setup.rotor_acceleration, setup.wl_cg, {}, 0, {}, {}, 0, 0};
  get_systems(s, c.systems);
  c.loaded_mass = s.systems.vehicle.loaded_mass;
  c.scas_fades = s.systems.vehicle.disengages ? 1 : 0;
  get_environment(s, c.environment);
  c.air_follows = s.air.follows ? 1 : 0;
  c.outside = s.configuration.around.outside;
  return c;
}

// Ranges of what make() does not look at.
tr_status check_conditions(const Conditions& c, const tr_state& state, FlightSetup<R>& wanted) {
  const tr_status possible = check_environment(c.environment);
  if (possible != TR_OK) return possible;
  if (!is_finite(c.loaded_mass)) return TR_NOT_FINITE;
  if (c.air_follows > 1 || c.scas_fades > 1 || !within_limits(c.outside)) return TR_OUT_OF_RANGE;
  const tr_status systems = check_systems(c.systems);
  if (systems != TR_OK) return systems;
  wanted.mast_rate = c.mast_rate;
  wanted.mast_acceleration = c.mast_acceleration;
  wanted.rotor_acceleration = c.rotor_acceleration;
  wanted.wl_cg = c.wl_cg;
  if (c.air_follows == 1) wanted.altitude = c.environment.altitude_origin_m - state.x[TR_DOWN];
  return TR_OK;
}

// The sums are those of the rounded numbers that the state shows.
bool adds_up(const tr_state& state) {
  const double sum[] = {state.roll_rad, state.yaw_rad, state.position_m[0], state.position_m[1],
                        state.position_m[2]};
  for (int k = 0; k < kSums; ++k)
    if (!(static_cast<R>(sum[k]) == state.x[kSumIndex[k]])) return false;
  return true;
}

}  // namespace

}  // namespace tiltrotor::c_interface

namespace tiltrotor::c_interface::checked {

tr_status tr_save(const tr_sim* sim, void* bytes, size_t length, size_t* used) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  if (used == nullptr) return TR_BAD_ARGUMENT;
  *used = kSavedBytes;
  if (length < kSavedBytes) return TR_SHORT_BUFFER;
  if (bytes == nullptr) return TR_BAD_ARGUMENT;
  const Sim& s = *opened(sim);
  Header header = {{}, kFormat, TR_API_VERSION, identity()};
  std::memcpy(header.magic, kMagic, sizeof kMagic);
  auto* const to = static_cast<unsigned char*>(bytes);
  each_of_header(header, Writer(to));
  const tr_setup setup = setup_of(s.configuration.setup);
  tr_state state;
  get_state(s, state);
  const Conditions conditions = conditions_of(s);
  Writer writer(to + kHeaderBytes);
  each_of_flight(setup, state, writer);
  each_of_conditions(conditions, writer);
  put(hash_of(to, kChecked), sizeof(std::uint64_t), to + kChecked);
  return TR_OK;
}

tr_status tr_load_saved(tr_sim* sim, uint32_t version, const void* bytes, size_t length) {
  if (sim == nullptr || bytes == nullptr) return TR_BAD_ARGUMENT;
  if (version != TR_API_VERSION) return TR_WRONG_VERSION;
  if (length < kHeaderBytes) return TR_SHORT_BUFFER;
  const auto* const from = static_cast<const unsigned char*>(bytes);
  Header header;
  each_of_header(header, Reader(from));
  if (std::memcmp(header.magic, kMagic, sizeof kMagic) != 0) return TR_DAMAGED;
  if (header.format != kFormat || header.version != TR_API_VERSION) return TR_WRONG_VERSION;
  if (length < kSavedBytes) return TR_SHORT_BUFFER;
  if (taken(sizeof(std::uint64_t), from + kChecked) != hash_of(from, kChecked)) return TR_DAMAGED;
  if (header.identity != identity()) return TR_WRONG_VERSION;

  tr_setup setup;
  tr_state state;
  Conditions conditions;
  Reader reader(from + kHeaderBytes);
  each_of_flight(setup, state, reader);
  each_of_conditions(conditions, reader);
  const tr_status in_range = check_state(state).status;
  if (in_range != TR_OK) return in_range;
  if (!adds_up(state)) return TR_OUT_OF_RANGE;
  FlightSetup<R> wanted;
  const tr_status possible = wanted_setup(setup, wanted);
  if (possible != TR_OK) return possible;
  const tr_status in_ranges = check_conditions(conditions, state, wanted);
  if (in_ranges != TR_OK) return in_ranges;
  const tr_status made = make(wanted, sim);
  if (made != TR_OK) return made;
  Sim& s = *opened(sim);
  put_switches(conditions.systems, s);
  s.systems.vehicle.loaded_mass = conditions.loaded_mass;
  if (conditions.scas_fades == 1) s.systems.vehicle.on.augmentation = s.systems.vehicle.disengages = true;
  put_state(state, s);
  const tr_status with_systems = follow_systems(s);
  if (with_systems != TR_OK) return with_systems;
  const tr_status around = put_environment(conditions.environment, conditions.air_follows == 1, s);
  return around == TR_OK ? put_loads(conditions.outside, s) : around;
}

}  // namespace tiltrotor::c_interface::checked

// The C interface: an aircraft in bytes, as tr_save writes it and as tr_sim holds it.
// Expected: the flight that went on, constants of FNV-1a as published, the header's text.
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "capi/flying.hpp"
#include "run_program.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

using namespace capi;

namespace {

using Bytes = std::vector<unsigned char>;

Bytes saved(const tr_sim& sim) {
  Bytes bytes(TR_SAVED_SIZE);
  std::size_t used = 0;
  CHECK_EQ(tr_save(&sim, bytes.data(), bytes.size(), &used), TR_OK);
  bytes.resize(used);
  return bytes;
}

tr_status loaded(tr_sim& sim, const Bytes& bytes) {
  return tr_load_saved(&sim, TR_API_VERSION, bytes.data(), bytes.size());
}

// In a climbing turn, far from home, with every kind of number in its state.
tr_sim flying(tr_setup setup, tr_real speed) {
  tr_sim sim;
  CHECK_EQ(tr_init(&sim, TR_API_VERSION, &setup), TR_OK);
  tr_state state = state_of(sim);
  state.x[TR_NORTH] = tr_real(123456.7);
  state.x[TR_YAW] = tr_real(40.1);
  state.u[TR_GUST_V] = tr_real(1.5);
  CHECK_EQ(tr_set_state(&sim, &state), TR_OK);
  const tr_flight flight = {speed, tr_real(0.03), tr_real(0.05), 0};
  CHECK_EQ(tr_trim(&sim, new_work().get(), &flight, nullptr), TR_OK);
  flown_on(sim, 30);
  return sim;
}

// The published constants of FNV-1a, over the bytes one by one.
std::uint64_t fnv_1a(const Bytes& bytes, std::size_t length) {
  std::uint64_t hash = 14695981039346656037u;
  for (std::size_t k = 0; k < length; ++k) hash = (hash ^ bytes[k]) * 1099511628211u;
  return hash;
}

// A forger's image: changed, with the checksum that fits.
Bytes forged(Bytes bytes, std::size_t at, const Bytes& by) {
  std::copy(by.begin(), by.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at));
  const std::uint64_t sum = fnv_1a(bytes, bytes.size() - 8);
  for (std::size_t k = 0; k < 8; ++k)
    bytes[bytes.size() - 8 + k] = static_cast<unsigned char>(sum >> (8 * k));
  return bytes;
}

template <class T>
Bytes little_endian(T number) {
  Bytes bytes(sizeof number);
  std::uint64_t bits = 0;
  if (sizeof number == 8) {
    std::memcpy(&bits, &number, sizeof number);
  } else {
    std::uint32_t half;
    std::memcpy(&half, &number, sizeof half);
    bits = half;
  }
  for (std::size_t k = 0; k < sizeof number; ++k) bytes[k] = static_cast<unsigned char>(bits >> (8 * k));
  return bytes;
}

constexpr std::size_t kHeader = 24;
constexpr std::size_t kMast = kHeader + 16;
constexpr std::size_t kTime = kMast + 6 * sizeof(tr_real);
constexpr std::size_t kState = kTime + 16;
constexpr std::size_t kSums = kState + (TR_STATES + TR_CONTROLS) * sizeof(tr_real);
constexpr std::size_t kConditions =
    kSums + 5 * 8;  // 4 settings, 22 numbers of the environment, a flag, 6 of loads
constexpr std::size_t kFlag = kConditions + 26 * sizeof(tr_real);
constexpr std::size_t kSystems = kFlag + 4 + 6 * sizeof(tr_real);
// 10 switches, 5 commands, 3 of gear and engines, 2 brakes, seed and strength, what fades, loaded mass
constexpr std::size_t kEnd = kSystems + 14 * 4 + 8 + 9 * sizeof(tr_real) + 8;

void write_file(const std::string& path, const void* bytes, std::size_t length) {
  std::ofstream(path, std::ios::binary).write(static_cast<const char*>(bytes), std::streamsize(length));
}
Bytes file_content(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return Bytes(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

}  // namespace

TEST(capi_saved_aircraft_flies_on_bit_for_bit) {
  for (const tr_real mast : {tr_real(0), tr_real(30), tr_real(90)}) {
    tr_setup setup = setup_at(mast);
    setup.coning_states = mast == 30;
    setup.tables = mast == 90 ? TR_TABLES_LINEAR : TR_TABLES_SMOOTH;
    setup.altitude_m = tr_real(321.5);
    setup.mass_kg *= tr_real(0.942);
    tr_sim sim = flying(setup, mast < 90 ? tr_real(40) : tr_real(110));
    const Bytes bytes = saved(sim);
    CHECK_EQ(bytes.size(), kEnd);
    tr_sim other;
    std::memset(&other, 0xff, sizeof other);
    CHECK_EQ(loaded(other, bytes), TR_OK);
    const tr_state a = state_of(sim), b = state_of(other);
    CHECK(same_bits(a, b));
    CHECK(saved(other) == bytes);
    CHECK_EQ(flown_on(sim, 100), flown_on(other, 100));
    // Into an aircraft that flies otherwise, from a longer array.
    other = trimmed_sim(60, 60);
    Bytes longer = bytes;
    longer.resize(2 * bytes.size(), 0x5a);
    CHECK_EQ(loaded(other, longer), TR_OK);
    CHECK(saved(other) == bytes);
  }
}

// Another process of this program, at other addresses: it is this test again, told by its environment. It
// reads what tr_save wrote, and the raw bytes of the tr_sim.
TEST(capi_saved_aircraft_flies_on_in_another_process) {
  constexpr int steps = 60;
  const char* const path = std::getenv("TILTROTOR_SAVED_AIRCRAFT");
  if (path != nullptr) {
    tr_sim sim;
    CHECK_EQ(loaded(sim, file_content(path)), TR_OK);
    const Bytes raw = file_content(std::string(path) + ".raw");
    tr_sim copied;
    CHECK_EQ(raw.size(), sizeof copied);
    if (raw.size() == sizeof copied) std::memcpy(&copied, raw.data(), sizeof copied);
    NOTE("hashes " << flown_on(sim, steps) << " " << flown_on(copied, steps) << " end");
    return;
  }
  tr_sim sim = flying(setup_at(30), 50);
  const std::string file = check::new_temporary_file();
  const Bytes bytes = saved(sim);
  write_file(file, bytes.data(), bytes.size());
  write_file(file + ".raw", &sim, sizeof sim);
  const check::ProgramResult child =
      check::run_program("TILTROTOR_SAVED_AIRCRAFT=" + file + " " + check::built("run_tests") +
                         " capi_saved_aircraft_flies_on_in_another_process");
  CHECK_EQ(child.exit_status, 0);
  const std::string hash = std::to_string(flown_on(sim, steps));
  CHECK(child.out.find("hashes " + hash + " " + hash + " end") != std::string::npos);
  unlink(file.c_str());
  unlink((file + ".raw").c_str());
}

TEST(capi_aircraft_holds_no_address) {
  const tr_sim sim = flying(setup_at(0), 30);
  const auto aircraft = reinterpret_cast<std::uintptr_t>(&tiltrotor::aircraft_data<tr_real>());
  const auto self = reinterpret_cast<std::uintptr_t>(&sim);
  for (std::size_t at = 0; at + sizeof aircraft <= tr_sim_size(); at += sizeof aircraft) {
    std::uintptr_t word;
    std::memcpy(&word, reinterpret_cast<const char*>(&sim) + at, sizeof word);
    CHECK(word != aircraft);
    CHECK(word < self || word >= self + sizeof sim);
  }
}

TEST(capi_every_bit_flip_and_cut_of_saved_bytes_is_refused) {
  const tr_sim sim = flying(setup_at(60), 60);
  const Bytes good = saved(sim);
  tr_sim other = trimmed_sim(0, 20);
  const tr_sim before = other;
  Bytes bad = good;
  int accepted = 0;
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    bad[bit / 8] = static_cast<unsigned char>(bad[bit / 8] ^ (1u << bit % 8));
    const tr_status status = loaded(other, bad);
    accepted += status != TR_DAMAGED && status != TR_WRONG_VERSION;
    bad[bit / 8] = good[bit / 8];
  }
  CHECK_EQ(accepted, 0);
  for (std::size_t length = 0; length < good.size(); ++length)
    CHECK_EQ(tr_load_saved(&other, TR_API_VERSION, good.data(), length), TR_SHORT_BUFFER);
  for (std::size_t a = 0; a + 1 < good.size(); ++a) {  // two bytes in each other's place
    std::swap(bad[a], bad[a + 1]);
    if (bad != good) CHECK(loaded(other, bad) != TR_OK);
    bad = good;
  }
  CHECK_EQ(loaded(other, Bytes(TR_SAVED_SIZE, 0)), TR_DAMAGED);
  CHECK_EQ(tr_load_saved(&other, TR_API_VERSION ^ 0xc, good.data(), good.size()), TR_WRONG_VERSION);
  CHECK(same_bits(other, before));
  // Nothing of a failed load is seen by an aircraft that was never made.
  std::memset(&other, 0x5a, sizeof other);
  const tr_sim untouched = other;
  CHECK_EQ(loaded(other, bad = forged(good, kState, little_endian(tr_real(1e30)))), TR_OUT_OF_RANGE);
  CHECK(same_bits(other, untouched));
}

// A right checksum does not make numbers right.
TEST(capi_forged_numbers_in_saved_bytes_are_refused) {
  const Bytes good = saved(flying(setup_at(0), 30));
  tr_sim sim = trimmed_sim(0, 20);
  const tr_sim before = sim;
  CHECK_EQ(loaded(sim, forged(good, 12, {1})), TR_WRONG_VERSION);
  CHECK_EQ(loaded(sim, forged(good, 8, {9})), TR_WRONG_VERSION);   // format
  CHECK_EQ(loaded(sim, forged(good, 16, {1})), TR_WRONG_VERSION);  // other tables
  for (std::size_t k = 0; k < 4; ++k)
    CHECK_EQ(loaded(sim, forged(good, kHeader + 4 * k, {77})), TR_BAD_ARGUMENT);
  for (const tr_real wild : {kNan, kInfinity, -std::numeric_limits<tr_real>::max(), tr_real(-3e9)}) {
    for (std::size_t at = kMast; at < kTime; at += sizeof wild)
      CHECK_EQ(loaded(sim, forged(good, at, little_endian(wild))), TR_OUT_OF_RANGE);
    for (std::size_t at = kState; at < kSums; at += sizeof wild) {
      const bool finite = wild < kInfinity;
      CHECK_EQ(loaded(sim, forged(good, at, little_endian(wild))), finite ? TR_OUT_OF_RANGE : TR_NOT_FINITE);
    }
  }
  // Settings, environment (but for the altitude of the origin, which is no matter while the air follows none, and the
  // ground, which may be anywhere), loads.
  for (const tr_real wild : {kNan, -kInfinity, tr_real(-3e9)}) {
    const auto forged_at = [&](std::size_t k) {
      return loaded(sim, forged(good, kConditions + k * sizeof wild, little_endian(wild)));
    };
    const tr_status refused = wild == tr_real(-3e9) ? TR_OUT_OF_RANGE : TR_NOT_FINITE;
    for (std::size_t k = 0; k < 4; ++k) CHECK_EQ(forged_at(k), TR_OUT_OF_RANGE);
    for (std::size_t k = 4; k < 25; ++k)
      if (k != 22) CHECK_EQ(forged_at(k), refused);
    for (const std::size_t k : {22u, 25u})
      CHECK(forged_at(k) == (refused == TR_NOT_FINITE ? refused : TR_OK));
    sim = before;
    for (std::size_t k = 0; k < 6; ++k)
      CHECK_EQ(loaded(sim, forged(good, kFlag + 4 + k * sizeof wild, little_endian(wild))), TR_OUT_OF_RANGE);
  }
  CHECK_EQ(loaded(sim, forged(good, kFlag, {2})), TR_OUT_OF_RANGE);
  for (const double wild : {-1.0, 1.1e9, 1e300}) {
    CHECK_EQ(loaded(sim, forged(good, kTime, little_endian(wild))), TR_OUT_OF_RANGE);
    for (std::size_t at = kSums; at < kConditions; at += 8)
      CHECK_EQ(loaded(sim, forged(good, at, little_endian(wild))), TR_OUT_OF_RANGE);
  }
  CHECK_EQ(loaded(sim, forged(good, kTime + 8, Bytes(8, 0xff))), TR_OUT_OF_RANGE);  // steps
  CHECK(same_bits(sim, before));
  CHECK_EQ(loaded(sim, forged(good, 0, {good[0]})), TR_OK);  // the forger's checksum is right
}

// Least significant byte first on every machine, whatever its own order.
TEST(capi_saved_bytes_have_a_fixed_order) {
  const Bytes bytes = saved(sim_at(30));
  const auto at = [&bytes](std::size_t from, std::size_t count) {
    return Bytes(bytes.begin() + std::ptrdiff_t(from), bytes.begin() + std::ptrdiff_t(from + count));
  };
  CHECK(at(0, 7) == Bytes({'t', 'r', 's', 'a', 'v', 'e', 'd'}));
  CHECK(at(12, 4) == Bytes({sizeof(tr_real), 0, 7, 0}));
  CHECK(at(kHeader, 4) == Bytes({static_cast<unsigned char>(tr_aircraft_at(0)), 0, 0, 0}));
  // 30 is 0x403e000000000000, in single precision 0x41f00000.
  const Bytes thirty = sizeof(tr_real) == 8 ? Bytes{0, 0, 0, 0, 0, 0, 0x3e, 0x40} : Bytes{0, 0, 0xf0, 0x41};
  CHECK(at(kMast, sizeof(tr_real)) == thirty);
  CHECK(at(bytes.size() - 8, 8) == little_endian(fnv_1a(bytes, bytes.size() - 8)));
}

TEST(capi_save_says_how_much_it_needs) {
  const tr_sim sim = trimmed_sim(0, 20);
  std::size_t used = 0;
  CHECK_EQ(tr_save(&sim, nullptr, 0, &used), TR_SHORT_BUFFER);
  CHECK_EQ(used, kEnd);
  CHECK_LE(used, TR_SAVED_SIZE);
  Bytes bytes(used + 1, 0x5a);
  used = 0;
  CHECK_EQ(tr_save(&sim, bytes.data(), kEnd - 1, &used), TR_SHORT_BUFFER);
  CHECK_EQ(used, kEnd);
  CHECK(bytes == Bytes(kEnd + 1, 0x5a));
  CHECK_EQ(tr_save(&sim, bytes.data(), kEnd, &used), TR_OK);
  CHECK_EQ(bytes.back(), 0x5a);
}

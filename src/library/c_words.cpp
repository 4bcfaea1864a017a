// The C interface: statuses, names and hashes.
#include "library/c_words.hpp"

#include <cstdint>
#include <cstring>
#include <type_traits>

#include "tiltrotor/systems/system_state.hpp"

namespace tiltrotor::c_interface {

tr_status translated(Status status) {
  switch (status) {
    case Status::ok:
      return TR_OK;
    case Status::not_converged:
      return TR_NOT_CONVERGED;
    case Status::singular:
      return TR_SINGULAR;
    case Status::not_finite:
      return TR_NOT_FINITE;
    case Status::out_of_range:
      return TR_OUT_OF_RANGE;
    case Status::bad_arithmetic:
      return TR_BAD_ARITHMETIC;
    case Status::vortex_ring:
      return TR_VORTEX_RING_STATE;
    case Status::bad_argument:
    case Status::count:
      break;
  }
  return TR_BAD_ARGUMENT;
}

tr_status translated(TrimStatus status) {
  switch (status) {
    case TrimStatus::ok:
      return TR_OK;
    case TrimStatus::wing_stall:
      return TR_WING_STALL;
    case TrimStatus::control_limit:
      return TR_CONTROL_LIMIT;
    case TrimStatus::flap_limit:
      return TR_FLAP_LIMIT;
    case TrimStatus::vortex_ring:
      return TR_VORTEX_RING_STATE;
    case TrimStatus::power_limit:
      return TR_POWER_LIMIT;
    case TrimStatus::torque_limit:
      return TR_TORQUE_LIMIT;
    case TrimStatus::rotor_stall:
      return TR_ROTOR_STALL;
    case TrimStatus::not_converged:
      return TR_NOT_CONVERGED;
    case TrimStatus::singular:
      return TR_SINGULAR;
    case TrimStatus::not_finite:
      return TR_NOT_FINITE;
    case TrimStatus::out_of_range:
    case TrimStatus::count:
      break;
  }
  return TR_OUT_OF_RANGE;
}

namespace {

using R = tr_real;

struct StatusWords {
  const char* word;
  const char* text;
};
constexpr StatusWords kWords[] = {
    {"ok", "the result is valid"},
    {"not_converged", "the iteration reached its limit before its tolerance"},
    {"singular", "a matrix that must be inverted is singular"},
    {"not_finite", "a NaN or an infinity was met in the input or arose in the computation"},
    {"out_of_range", "an input, or the state after a step, lies outside the range of the model"},
    {"bad_argument", "a null pointer, an unknown choice or an impossible size"},
    {"short_buffer", "an array is too short for the result"},
    {"wrong_version", "the program was compiled for another version or precision of the library"},
    {"not_initialized", "tr_init has not succeeded on this aircraft"},
    {"wing_stall", "trimmed, but the wing is past its stall"},
    {"control_limit", "trimmed, but a control is beyond its stop"},
    {"flap_limit", "trimmed, but a gimbal is beyond its stop"},
    {"rotor_stall", "no trim: the rotors stall before the weight is carried"},
    {"damaged", "not the bytes of a saved aircraft, or changed since they were saved"},
    {"bad_arithmetic",
     "the processor does not round to nearest, flushes small numbers to zero, or lacks instructions of the library"},
    {"vortex_ring", "trimmed, but a rotor descends in its own wake"},
    {"power_limit", "trimmed, but the rotors need more than take-off power, or drive the engines"},
    {"torque_limit", "trimmed, but a mast carries more than its largest steady torque"},
};
static_assert(sizeof(kWords) / sizeof(kWords[0]) == TR_STATUS_COUNT, "one row per status");

}  // namespace

}  // namespace tiltrotor::c_interface

using namespace tiltrotor;
using namespace tiltrotor::c_interface;

const char* tr_status_word(int32_t status) {
  const auto place = static_cast<unsigned>(status);
  return place < TR_STATUS_COUNT ? kWords[place].word : "unknown";
}
const char* tr_status_text(int32_t status) {
  const auto place = static_cast<unsigned>(status);
  return place < TR_STATUS_COUNT ? kWords[place].text : "";
}
const char* tr_state_name(int32_t index) {
  return index >= 0 && index < TR_STATES ? vehicle_variable(index).name : "unknown";
}
const char* tr_state_unit(int32_t index) {
  return index >= 0 && index < TR_STATES ? vehicle_variable(index).unit() : "";
}
const char* tr_control_name(int32_t index) {
  return index >= 0 && index < TR_INPUTS ? vehicle_input(index).name : "unknown";
}
const char* tr_control_unit(int32_t index) {
  return index >= 0 && index < TR_INPUTS ? vehicle_input(index).unit() : "";
}
const char* tr_version(void) { return TILTROTOR_VERSION; }

tr_status tr_hash(const tr_real* numbers, size_t length, uint64_t* hash) {
  if (hash == nullptr || (numbers == nullptr && length > 0)) return TR_BAD_ARGUMENT;
  using Bits = std::conditional_t<sizeof(R) == 8, std::uint64_t, std::uint32_t>;
  std::uint64_t h = *hash;
  for (std::size_t i = 0; i < length; ++i) {
    Bits bits;
    std::memcpy(&bits, &numbers[i], sizeof bits);
    h = hashed(h, bits);
  }
  *hash = h;
  return TR_OK;
}

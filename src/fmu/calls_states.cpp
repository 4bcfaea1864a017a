// Calls of the standard: copies of an instance's state, also as bytes. They lie in the instance.
#include <cmath>
#include <cstring>
#include <type_traits>

#include "fmu/instance.hpp"

using namespace tiltrotor_fmu;

namespace {

// Bytes: this head, then the flight without its aircraft, then the aircraft as tr_save writes it.
struct Head {
  char token[64];
  std::uint64_t bytes_of_aircraft, hash;  // of all that follows
  std::uint64_t co_simulation;
};
constexpr size_t kPlain = offsetof(Flight, sim);
constexpr size_t kSerialized = sizeof(Head) + kPlain + TR_SAVED_SIZE;
static_assert(std::is_trivially_copyable_v<Flight>);

std::uint64_t hash_of(const fmi3Byte* bytes, size_t count) {
  std::uint64_t hash = TR_HASH_START;
  for (size_t k = 0; k < count; ++k) hash = (hash ^ bytes[k]) * UINT64_C(1099511628211);
  return hash;
}

Slot* slot_of(Instance& i, fmi3FMUState state) {
  for (Slot& slot : i.slot)
    if (&slot == state && slot.used) return &slot;
  return nullptr;
}

// `state` when it is one of this instance, nullptr for none; else a free one.
fmi3Status find_slot(Instance& i, const fmi3FMUState* state, Slot*& found) {
  if (state == nullptr) return say(i, fmi3Error, "no place for the state");
  found = *state == nullptr ? nullptr : slot_of(i, *state);
  if (found != nullptr) return fmi3OK;
  if (*state != nullptr) return say(i, fmi3Error, "the state is none of this instance");
  for (Slot& slot : i.slot)
    if (!slot.used) {
      found = &slot;
      return fmi3OK;
    }
  return say(i, fmi3Error, "%d states are held already: free one", kSlots);
}

// Bytes with the right hash may be made by hand.
bool is_possible(const Flight& f) {
  const unsigned mode = f.mode;
  if (mode == 0 || mode > kTerminated || (mode & (mode - 1)) != 0 || !std::isfinite(f.time)) return false;
  for (int k = 0; k < kSettings; ++k)
    if (!range_of({Role::setting, k}).holds(f.setting[k])) return false;
  for (const double number : f.state)
    if (!std::isfinite(number)) return false;
  for (const double number : f.input)
    if (!std::isfinite(number)) return false;
  return true;
}

}  // namespace

fmi3Status fmi3GetFMUState(fmi3Instance instance, fmi3FMUState* state) {
  Instance* const i = opened(instance, kAlive, "fmi3GetFMUState");
  Slot* slot = nullptr;
  if (i == nullptr || find_slot(*i, state, slot) != fmi3OK) return fmi3Error;
  slot->used = true;
  slot->flight = i->flight;
  *state = slot;
  return fmi3OK;
}

fmi3Status fmi3SetFMUState(fmi3Instance instance, fmi3FMUState state) {
  Instance* const i = opened(instance, kAlive, "fmi3SetFMUState");
  if (i == nullptr) return fmi3Error;
  const Slot* const slot = slot_of(*i, state);
  if (slot == nullptr) return say(*i, fmi3Error, "the state is none of this instance");
  i->flight = slot->flight;
  return fmi3OK;
}

fmi3Status fmi3FreeFMUState(fmi3Instance instance, fmi3FMUState* state) {
  Instance* const i = opened(instance, kAlive, "fmi3FreeFMUState");
  if (i == nullptr || state == nullptr) return fmi3Error;
  if (*state == nullptr) return fmi3OK;
  Slot* const slot = slot_of(*i, *state);
  if (slot == nullptr) return say(*i, fmi3Error, "the state is none of this instance");
  slot->used = false;
  *state = nullptr;
  return fmi3OK;
}

fmi3Status fmi3SerializedFMUStateSize(fmi3Instance instance, fmi3FMUState state, size_t* size) {
  Instance* const i = opened(instance, kAlive, "fmi3SerializedFMUStateSize");
  if (i == nullptr || size == nullptr) return fmi3Error;
  if (slot_of(*i, state) == nullptr) return say(*i, fmi3Error, "the state is none of this instance");
  *size = kSerialized;
  return fmi3OK;
}

fmi3Status fmi3SerializeFMUState(fmi3Instance instance, fmi3FMUState state, fmi3Byte bytes[], size_t size) {
  Instance* const i = opened(instance, kAlive, "fmi3SerializeFMUState");
  if (i == nullptr) return fmi3Error;
  const Slot* const slot = slot_of(*i, state);
  if (slot == nullptr) return say(*i, fmi3Error, "the state is none of this instance");
  if (bytes == nullptr || size < kSerialized)
    return say(*i, fmi3Error, "a state takes %zu bytes", kSerialized);
  std::memset(bytes, 0, size);
  std::memcpy(bytes + sizeof(Head), &slot->flight, kPlain);
  Head head = {};
  instantiation_token(head.token);
  head.co_simulation = i->co_simulation;
  size_t used = 0;
  const tr_status saved = tr_save(&slot->flight.sim, bytes + sizeof(Head) + kPlain, TR_SAVED_SIZE, &used);
  if (saved != TR_OK) return answer(*i, saved, "state", fmi3Error);
  head.bytes_of_aircraft = used;
  head.hash = hash_of(bytes + sizeof(Head), kPlain + used);
  std::memcpy(bytes, &head, sizeof head);
  return fmi3OK;
}

fmi3Status fmi3DeserializeFMUState(fmi3Instance instance, const fmi3Byte bytes[], size_t size,
                                   fmi3FMUState* state) {
  Instance* const i = opened(instance, kAlive, "fmi3DeserializeFMUState");
  Slot* slot = nullptr;
  if (i == nullptr || find_slot(*i, state, slot) != fmi3OK) return fmi3Error;
  if (bytes == nullptr || size < kSerialized)
    return say(*i, fmi3Error, "a state takes %zu bytes", kSerialized);
  Head head;
  std::memcpy(&head, bytes, sizeof head);
  char token[64];
  instantiation_token(token);
  if (std::memcmp(head.token, token, std::strlen(token) + 1) != 0 ||
      head.co_simulation != static_cast<std::uint64_t>(i->co_simulation))
    return say(*i, fmi3Error, "bytes of another FMU or interface type");
  if (head.bytes_of_aircraft > TR_SAVED_SIZE ||
      head.hash != hash_of(bytes + sizeof(Head), kPlain + static_cast<size_t>(head.bytes_of_aircraft)))
    return say(*i, fmi3Error, "bytes that are damaged");
  Flight flight = {};
  const tr_status loaded = tr_load_saved(&flight.sim, TR_API_VERSION, bytes + sizeof(Head) + kPlain,
                                         static_cast<size_t>(head.bytes_of_aircraft));
  if (loaded != TR_OK) return answer(*i, loaded, "state", fmi3Error);
  std::memcpy(static_cast<void*>(&flight), bytes + sizeof(Head), kPlain);
  if (!is_possible(flight)) return say(*i, fmi3Error, "bytes that are damaged");
  slot->flight = flight;
  slot->used = true;
  *state = slot;
  return fmi3OK;
}

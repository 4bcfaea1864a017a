// What lies in the caller's memory: an aircraft in tr_sim, and one of several work areas in tr_work.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <new>
#include <type_traits>

#include "library/c_analyses.hpp"
#include "tiltrotor/analysis/flight/response.hpp"
#include "tiltrotor/analysis/instances.hpp"
#include "tiltrotor/analysis/linear/output_model.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/tiltrotor.h"

namespace tiltrotor::c_interface {

using R = tr_real;

inline constexpr std::uint32_t kMark = 0x54520000u + TR_API_VERSION;  // "TR"

// Where the air of a flight is taken from: the altitude of the setup, or that of the aircraft.
struct AirOrigin {
  bool follows;
  R altitude, ground_down;  // m
};

struct Sim {
  std::uint32_t mark;              // kMark once initialised
  Configuration<R> configuration;  // without its aircraft: stored bytes hold no address
  State<R> x;
  Travel travel;
  Controls<R> u;
  double time;
  std::uint64_t steps;
  AirOrigin air;
  SystemFlight<R> systems;
  tr_fault fault;
};
static_assert(sizeof(Sim) <= sizeof(tr_sim) && alignof(Sim) <= alignof(tr_sim));
static_assert(std::is_trivially_copyable_v<Sim>, "a snapshot is a copy of the bytes");

// The configuration with its aircraft, for the time of a call.
inline const Configuration<R>& equipped(const Sim& s, Configuration<R>& copy) {
  copy = s.configuration;
  copy.aircraft = &aircraft_data<R>();
  return copy;
}

// The state as the equations of motion see it: bank and heading within half a turn.
inline State<R> evaluated_state(const Sim& s) { return without_turns(s.x, s.travel); }

// One group of members at a time.
struct StepCallWorkspace {
  Configuration<R> configuration;
  SimulationWorkspace<R, NoDifferentiation> workspace;
  Simulation<R> simulation;
};
struct TrimCallWorkspace {
  Configuration<R> configuration;
  TrimWorkspace<R> workspace;
  TrimResult<R> result;
};
struct LinearCallWorkspace {
  Configuration<R> configuration;
  LinearizationWorkspace<R> workspace;
  LinearModel<R> model;
};
struct OutputsCallWorkspace {
  Configuration<R> configuration;
  OutputModelWorkspace<R> workspace;
  LinearPoint<R> point;
};
struct DirectionalCallWorkspace {
  Configuration<R> configuration;
  DirectionalWorkspace<R> workspace;
};
struct EigenCallWorkspace {
  EigenvalueWorkspace<R, TR_MAX_LINEAR_STATES> workspace;
  Matrix<R, TR_MAX_LINEAR_STATES, TR_MAX_LINEAR_STATES> a;
  Eigenvalues<R, TR_MAX_LINEAR_STATES> values;
};
struct ModesCallWorkspace {
  ModesWorkspace<R> workspace;
  LinearModel<R> model;
  ModeSet<R> set;
};
inline constexpr std::size_t kWorkAlignment = 64;

template <class... Workspace>
constexpr std::size_t largest() {
  std::size_t most = 0;
  for (const std::size_t size : {sizeof(Workspace)...}) most = size > most ? size : most;
  return most;
}
// Of a tr_work, wherever it begins, for the largest of some workspaces.
template <class... Workspace>
inline constexpr std::size_t kWorkBytes = largest<Workspace...>() + kWorkAlignment - alignof(tr_work);
inline constexpr std::size_t kOwnWorkBytes =
    kWorkBytes<StepCallWorkspace, TrimCallWorkspace, LinearCallWorkspace, OutputsCallWorkspace,
               DirectionalCallWorkspace, EigenCallWorkspace, ModesCallWorkspace>;
static_assert(kOwnWorkBytes <= sizeof(tr_work));
// Of workspaces that one object alone knows: c_system_model.cpp, c_system_outputs.cpp, c_rigid_model.cpp.
extern const std::size_t kSystemModelWorkBytes, kSystemOutputsWorkBytes, kRigidModelWorkBytes;

// An uninitialised workspace on the first aligned address.
template <class Workspace>
Workspace& workspace_in(tr_work* work) {
  static_assert(alignof(Workspace) <= kWorkAlignment && std::is_trivially_destructible_v<Workspace>);
  const auto address = reinterpret_cast<std::uintptr_t>(work);
  const std::uintptr_t aligned = (address + kWorkAlignment - 1) / kWorkAlignment * kWorkAlignment;
  return *::new (reinterpret_cast<void*>(aligned)) Workspace;
}

inline Sim* opened(tr_sim* sim) { return std::launder(reinterpret_cast<Sim*>(sim->reserved)); }
inline const Sim* opened(const tr_sim* sim) {
  return std::launder(reinterpret_cast<const Sim*>(sim->reserved));
}

inline tr_status check(const tr_sim* sim) {
  if (sim == nullptr) return TR_BAD_ARGUMENT;
  if (!is_ieee_arithmetic<R>()) return TR_BAD_ARITHMETIC;
  return opened(sim)->mark == kMark ? TR_OK : TR_NOT_INITIALIZED;
}

inline bool all_finite(const R* numbers, std::size_t length) {
  for (std::size_t i = 0; i < length; ++i)
    if (!is_finite(numbers[i])) return false;
  return true;
}

}  // namespace tiltrotor::c_interface

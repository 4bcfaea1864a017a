// Modes of the whole vehicle: those of the airframe by their names, those of the systems by the state that takes part
// most.
#pragma once

#include "tiltrotor/analysis/linear/modes.hpp"
#include "tiltrotor/analysis/linear/vehicle_model.hpp"

namespace tiltrotor {

template <class R>
struct VehicleMode {
  R real, imag;                              // 1/s; imag >= 0, a pair is one mode
  R frequency, damping_ratio, time_to_half;  // as in Mode
  R system_share;                            // part of the systems' states in it, 0..1
  ModeAxis axis;
  bool is_system;              // named after a state of the systems
  char name[kModeNameLength];  // "short_period", "rotor_speed", "elevator_2"
  int eigenvalue;              // its place in VehicleModesWorkspace::system
};

// The airframe's first, in the order of ModeSet, then the systems', slow ones first.
template <class R>
struct VehicleModes {
  int count;
  VehicleMode<R> mode[kMaxVehicleStates];
};

template <class R>
struct VehicleModesWorkspace {
  Matrix<R, kMaxVehicleStates, kMaxVehicleStates> a;  // given; rotors by mean and difference afterwards
  EigenWorkspace<R, kMaxVehicleStates> eigen;
  Eigensystem<R, kMaxVehicleStates> system;
  ModeSet<R> airframe;
};

// Rotors' states s = (right + left)/2 and d = (right - left)/2 in the places of right and left.
template <class R>
void split_rotors(const VehicleShape& shape, Matrix<R, kMaxVehicleStates, kMaxVehicleStates>& a,
                  Symmetry (&symmetry)[kMaxVehicleStates]) {
  for (Symmetry& s : symmetry) s = Symmetry::none;
  const int n = shape.states;
  for (int r = 0; r < n; ++r) {
    const int state = shape.state[r];
    if (state >= state_count || kStateVariables[state].side != right) continue;
    int l = 0;
    while (l < n && shape.state[l] != kStateVariables.partner[state]) ++l;
    if (l == n) continue;
    for (int j = 0; j < n; ++j) {
      const R sum = a(r, j) + a(l, j), difference = a(r, j) - a(l, j);
      a(r, j) = R(0.5) * sum;
      a(l, j) = R(0.5) * difference;
    }
    for (int i = 0; i < n; ++i) {
      const R sum = a(i, r) + a(i, l), difference = a(i, r) - a(i, l);
      a(i, r) = sum;
      a(i, l) = difference;
    }
    symmetry[r] = Symmetry::mean;
    symmetry[l] = Symmetry::difference;
  }
}

namespace vehicle_modes_detail {

// What takes part in a root: the airframe's states by their groups, and the systems' together and the largest.
template <class R>
struct RootShares {
  Mode<R> mode;
  R systems;
  int largest;  // place in vehicle_variable()
};

template <class R>
RootShares<R> root_shares(const VehicleShape& shape, const Symmetry (&symmetry)[kMaxVehicleStates],
                          const Eigensystem<R, kMaxVehicleStates>& system, int k) {
  RootShares<R> out{};
  mode_search::describe_value(system.values.real[k], system.values.imag[k], out.mode);
  out.mode.eigenvalue = k;
  R total = R(0);
  for (int i = 0; i < shape.states; ++i) total += participation(system, i, k);
  const bool usable = is_finite(total);
  R most = R(-1);
  for (int i = 0; i < shape.states; ++i) {
    const R part = usable ? participation(system, i, k) / total : R(1) / static_cast<R>(shape.states);
    const int state = shape.state[i];
    if (state < state_count && state != kStateIndex.position.z) {
      add_share(SplitCoordinate{state, symmetry[i]}, part, out.mode.shares);
      continue;
    }
    out.systems += part;
    if (part > most) {
      most = part;
      out.largest = state;
    }
  }
  return out;
}

inline void write_system_name(const char* word, int ordinal, char (&name)[kModeNameLength]) {
  int length = 0;
  for (; length < kModeNameLength - 4 && word[length] != '\0'; ++length) name[length] = word[length];
  if (ordinal > 1) {
    name[length++] = '_';
    if (ordinal >= 10) name[length++] = static_cast<char>('0' + ordinal / 10);
    name[length++] = static_cast<char>('0' + ordinal % 10);
  }
  name[length] = '\0';
}

template <class R>
VehicleMode<R> shown(const Mode<R>& m, R system_share) {
  VehicleMode<R> out{m.real, m.imag, m.frequency, m.damping_ratio, m.time_to_half, system_share,
                     m.axis, false,  {},          m.eigenvalue};
  for (int i = 0; i < kModeNameLength; ++i) out.name[i] = m.name[i];
  return out;
}

}  // namespace vehicle_modes_detail

// Of work.a, which linearize_vehicle() has filled as `shape` says. The roots in which the systems take part least, at most as many as the airframe
// has states and by less than half, are named as modes() names them.
// Status: ok; not_finite or not_converged (the set is empty); bad_argument (fewer states than a rigid body has).
// Cost: eigensystem of order n, about 25 n^3 multiplications.
template <class R>
Status vehicle_modes(const VehicleShape& shape, VehicleModesWorkspace<R>& work, VehicleModes<R>& out) {
  namespace d = vehicle_modes_detail;
  namespace names = mode_search;
  out.count = 0;
  const int n = shape.states;
  if (n < kRigidStates || n > kMaxVehicleStates) return Status::bad_argument;
  Symmetry symmetry[kMaxVehicleStates];
  split_rotors(shape, work.a, symmetry);
  const Status status = eigensystem(work.a, n, work.eigen, work.system);
  if (status != Status::ok) return status;

  d::RootShares<R> root[kMaxVehicleStates];
  int roots = 0, airframe_states = 0;
  bool downwash = false;
  for (int i = 0; i < n; ++i) {
    const int state = shape.state[i];
    airframe_states += state < state_count && state != kStateIndex.position.z;
    downwash = downwash || state == kStateIndex.downwash;
  }
  for (int k = 0; k < n; ++k) {
    if (!(work.system.values.imag[k] >= R(0))) continue;
    root[roots] = d::root_shares(shape, symmetry, work.system, k);
    if (!is_finite(root[roots++].mode.frequency)) return Status::not_finite;
  }
  // Least share of the systems first.
  for (int i = 1; i < roots; ++i) {
    const d::RootShares<R> moving = root[i];
    int j = i;
    for (; j > 0 && root[j - 1].systems > moving.systems; --j) root[j] = root[j - 1];
    root[j] = moving;
  }
  ModeSet<R>& set = work.airframe;
  set.count = 0;
  set.states = airframe_states;
  bool is_airframe[kMaxVehicleStates] = {};
  R share[kMaxVehicleStates];
  int free = airframe_states;
  for (int i = 0; i < roots; ++i) {
    const int size = names::roots(root[i].mode);
    is_airframe[i] = size <= free && root[i].systems < R(0.5);
    if (!is_airframe[i]) continue;
    free -= size;
    share[root[i].mode.eigenvalue] = root[i].systems;
    set.mode[set.count++] = root[i].mode;
  }
  names::name_set(set, downwash);
  for (int i = 0; i < set.count; ++i)
    out.mode[out.count++] = d::shown(set.mode[i], share[set.mode[i].eigenvalue]);

  const int first = out.count;
  for (int i = 0; i < roots; ++i) {
    if (is_airframe[i]) continue;
    int ordinal = 1;
    for (int k = 0; k < roots; ++k) {
      const R other = root[k].mode.frequency, own = root[i].mode.frequency;
      const bool before = other < own || (k < i && other == own);
      ordinal += !is_airframe[k] && before && root[k].largest == root[i].largest;
    }
    VehicleMode<R> moving = d::shown(root[i].mode, root[i].systems);
    moving.is_system = true;
    d::write_system_name(vehicle_variable(root[i].largest).name, ordinal, moving.name);
    int j = out.count++;
    for (; j > first && out.mode[j - 1].frequency > moving.frequency; --j) out.mode[j] = out.mode[j - 1];
    out.mode[j] = moving;
  }
  return Status::ok;
}

}  // namespace tiltrotor

// Rotor and airframe, each on the scalar of its own few directions: what one sees of the aircraft is seeded, the
// result chained to the directions of the aircraft (math/differentiation/preaccumulate.hpp). On plain numbers,
// and where nothing would be gained, the component is simply called.
#pragma once

#include "tiltrotor/math/differentiation/local_workspace.hpp"
#include "tiltrotor/model/airframe/airframe.hpp"
#include "tiltrotor/model/rotor/rotor.hpp"

namespace tiltrotor {

template <class T>
using LocalRotor = LocalWorkspace<RotorInput, RotorResponse, RotorWorkspace, T>;
template <class T>
using LocalAirframe = LocalWorkspace<AirframeInput, AirframeResponse, AirframeWorkspace, T>;

// Partials of a configuration reach a component beside its input: it must then be evaluated on T itself.
template <class T, class C>
inline constexpr bool kScalarsFit = kIsPlain<C> ||
                                    (std::is_same_v<C, T> && std::is_same_v<LocalDual<RotorInput, T>, T> &&
                                     std::is_same_v<LocalDual<AirframeInput, T>, T>);

// `azimuth`: of the first blade, rad; used in the individual-blade mode alone. `own`: which directions are the rotors' own
// states, if that is known.
template <class T, class C>
void local_rotor_response(const Configuration<C>& c, const RotorInput<T>& in, int side, Real<T> azimuth,
                          LocalRotor<T>& work, RotorResponse<T>& out, const RotorDirections* own = nullptr) {
  static_assert(kScalarsFit<T, C>,
                "a configuration with partials has the scalar of the state, of at most 16 directions");
  const bool averaged = c.setup.options.azimuth == AzimuthMode::averaged;
  if (!averaged) individual_azimuth(c.aircraft->rotor.blades, azimuth, work.inner.stations);
  const AzimuthStations<Real<T>>& stations = averaged ? c.azimuth : work.inner.stations;
  const RotorConditions<C> conditions = rotor_conditions(c, side);
  preaccumulate(
      in, work.chain, out,
      [&](const auto& local, auto& found) {
        rotor_response(c, conditions, local, stations, work.inner, found,
                       !std::is_same_v<LocalDual<RotorInput, T>, T>);
      },
      own == nullptr ? nullptr : &own->rotor[side]);
}

// In symmetric flight the left rotor sees, in its mirrored frame, what the right one saw, number by number, and answers
// the same: its blades need not be asked again. The numbers the right one saw are left in `seen`.
template <class T, class C>
void local_rotor_response(const Configuration<C>& c, const RotorInput<T>& in, int side, Real<T> azimuth,
                          LocalRotor<T>& work, Real<T> (&seen)[RotorInput<T>::kCount],
                          RotorResponse<T> (&out)[2], const RotorDirections* own = nullptr) {
  constexpr bool kPlain = kIsPlain<T>;
  constexpr bool kLocal = !std::is_same_v<LocalDual<RotorInput, T>, T>;
  if constexpr (kIsPlain<C> && (kPlain || kLocal)) {
    bool alike = side == left && c.rotor[left].ground_wash == c.rotor[right].ground_wash &&
                 c.rotor[left].speed == c.rotor[right].speed;
    int k = 0;
    RotorInput<T>::each(in, [&](const T& x) {
      alike = alike && value(x) == seen[k];
      seen[k++] = value(x);
    });
    if (alike) {
      if constexpr (kPlain) {
        out[left] = out[right];
      } else {
        preaccumulate_again(in, work.chain, out[left], own == nullptr ? nullptr : &own->rotor[left]);
      }
      return;
    }
  }
  local_rotor_response(c, in, side, azimuth, work, out[side], own);
}
template <class T, class C, class Record>
void local_airframe_response(const Configuration<C>& c, const AirframeInput<T>& in, LocalAirframe<T>& work,
                             AirframeResponse<T>& out, Record& record) {
  static_assert(kScalarsFit<T, C>,
                "a configuration with partials has the scalar of the state, of at most 16 directions");
  preaccumulate(in, work.chain, out, [&](const auto& local, auto& found) {
    airframe_response(c, local, work.inner, found, record);
  });
}

}  // namespace tiltrotor

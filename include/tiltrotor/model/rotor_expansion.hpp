// The rotors to first order about a point: in their inputs, and in what moves around them of the configuration. Found on
// plain numbers; whatever depends on either follows by the chain rule, without a blade.
#pragma once

#include "tiltrotor/model/component_inputs.hpp"
#include "tiltrotor/model/derivative_steps.hpp"
#include "tiltrotor/model/rotor_expansion_workspace.hpp"

namespace tiltrotor {

// About (x, u). Cost: half a Jacobian.
template <class R>
void expand_rotors(const Configuration<R>& c, const State<R>& x, const Controls<R>& u, R azimuth,
                   RotorExpansionWorkspace<R>& work, RotorExpansion<R>& out) {
  using D = PlacedDual<R>;
  const Vec3<R> velocity = x.velocity - u.gust;
  work.controls = mix_controls(c, u, velocity);
  const Vec3<R> velocity_b = airframe_velocity(velocity, c.mass.nacelles);
  const bool averaged = c.setup.options.azimuth == AzimuthMode::averaged;
  if (!averaged) individual_azimuth(c.aircraft->rotor.blades, azimuth, work.inner.stations);
  const AzimuthStations<R>& stations = averaged ? c.azimuth : work.inner.stations;
  for (const Side side : {right, left}) {
    const RotorConditions<R> plain = rotor_conditions(c, side);
    PlacedRotorInput<R>& point = work.point;
    rotor_input(c, x, velocity_b, work.controls, side, point.in);
    point.speed = plain.speed;
    point.ground_wash = plain.ground_wash;
    point.density = plain.density;
    point.speed_of_sound = plain.speed_of_sound;
    R flat[PlacedRotorInput<R>::kCount];
    flatten(point, flat);
    int direction = 0;
    PlacedRotorInput<D>::each(work.seeded, [&](D& seed) {
      seed = D::variable(flat[direction], direction);
      ++direction;
    });
    const PlacedRotorInput<D>& at = work.seeded;
    const RotorConditions<D> conditions = {
        {at.speed, at.speed * c.aircraft->rotor.radius, D(plain.spin_up), at.ground_wash},
        at.density,
        at.speed_of_sound};
    rotor_response(c, conditions, at.in, stations, work.inner, out.rotor[side]);
  }
}

// What finds the rotors' answers in an evaluation: their blades,
struct AskedRotors {
  template <class T, class C>
  void operator()(const Configuration<C>& c, int side, Real<T> azimuth, DerivativeSteps<T>& steps) const {
    local_rotor_response(c, steps.rotor_input, side, azimuth, steps.local.first, steps.seen_by_rotor,
                         steps.rotor);
  }
};

// an expansion about the point of the evaluation,
template <class R>
struct ExpandedRotors {
  const RotorExpansion<R>& about;

  template <class T, class C>
  void operator()(const Configuration<C>& c, int side, R, DerivativeSteps<T>& steps) const {
    constexpr int kSeen = kIsPlain<C> ? RotorInput<T>::kCount : PlacedRotorInput<T>::kCount;
    T seen[kSeen];
    flatten(steps.rotor_input, seen);
    if constexpr (!kIsPlain<C>) {
      const RotorConditions<C> at = rotor_conditions(c, side);
      const T around[] = {at.speed, at.ground_wash, at.density, at.speed_of_sound};
      for (int k = 0; k < 4; ++k) seen[RotorInput<T>::kCount + k] = around[k];
    }
    const RotorResponse<PlacedDual<R>>& known = about.rotor[side];
    const PlacedDual<R>* flat[RotorResponse<T>::kCount];
    int i = 0;
    RotorResponse<PlacedDual<R>>::each(known, [&](const auto& x) { flat[i++] = &x; });
    i = 0;
    RotorResponse<T>::each(steps.rotor[side], [&](T& x) {
      R slope[PlacedRotorInput<T>::kCount], along[kSeen];
      flat[i]->d.copy_to(slope);
      for (int k = 0; k < kSeen; ++k) along[k] = slope[k];
      x = chain(flat[i++]->v, along, seen);
    });
  }
};

// or one of them, whether there is an expansion.
template <class R>
struct KnownRotors {
  const RotorExpansion<R>* about;

  template <class T, class C>
  void operator()(const Configuration<C>& c, int side, R azimuth, DerivativeSteps<T>& steps) const {
    if constexpr (OuterPartials<T>::count > 0) {
      if (about != nullptr) {
        ExpandedRotors<R>{*about}(c, side, azimuth, steps);
        return;
      }
    }
    AskedRotors{}(c, side, azimuth, steps);
  }
};

}  // namespace tiltrotor

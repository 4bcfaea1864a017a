// The rotors to first order about a point: in their inputs, and in what moves around them of the configuration. Found on
// plain numbers; whatever depends on either follows by the chain rule, without a blade.
#pragma once

#include "tiltrotor/model/component_inputs.hpp"
#include "tiltrotor/model/derivative_steps.hpp"
#include "tiltrotor/model/rotor_expansion_workspace.hpp"

namespace tiltrotor {

// `radius`: of the rotor, m; `spin_up`: torque that its changing speed takes, N m.
template <class T>
void set_conditions(const PlacedRotorInput<T>& at, Real<T> radius, Real<T> spin_up,
                    RotorConditions<T>& conditions) {
  conditions.speed = at.speed;
  conditions.tip_speed = at.speed * radius;
  conditions.spin_up = T(spin_up);
  conditions.ground_wash = at.ground_wash;
  conditions.density = at.density;
  conditions.speed_of_sound = at.speed_of_sound;
}

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
    set_conditions(work.seeded, c.aircraft->rotor.radius, plain.spin_up, work.conditions);
    rotor_response(c, work.conditions, work.seeded.in, stations, work.inner, out.rotor[side], true);
  }
}

// What finds the rotors' answers in an evaluation, knowing or not which directions are their own states: their blades,
struct AskedRotors {
  const RotorDirections* own = nullptr;

  template <class T, class C>
  void operator()(const Configuration<C>& c, int side, Real<T> azimuth, DerivativeSteps<T>& steps) const {
    local_rotor_response(c, steps.rotor_input, side, azimuth, steps.local.first, steps.seen_by_rotor,
                         steps.rotor, own);
  }
};

// an expansion about the point of the evaluation,
template <class R>
struct ExpandedRotors {
  const RotorExpansion<R>& about;
  const RotorDirections* own = nullptr;

  // Through the first `N` numbers of PlacedRotorInput; the others are held.
  template <int N, class T>
  void chain_through(const T* seen, int side, RotorResponse<T>& out) const {
    const PlacedDual<R>* known[RotorResponse<T>::kCount];
    int i = 0;
    RotorResponse<PlacedDual<R>>::each(about.rotor[side], [&](const auto& x) { known[i++] = &x; });
    i = 0;
    RotorResponse<T>::each(out, [&](T& x) {
      R slope[PlacedRotorInput<T>::kCount], along[N];
      known[i]->d.copy_to(slope);
      for (int k = 0; k < N; ++k) along[k] = slope[k];
      x = chain(known[i++]->v, along, seen, own == nullptr ? nullptr : &own->rotor[side]);
    });
  }
  template <class T>
  void operator()(const Configuration<R>&, int side, R, DerivativeSteps<T>& steps) const {
    T* const seen = steps.local.first.chain.input;
    flatten(steps.rotor_input, seen);
    chain_through<RotorInput<T>::kCount>(seen, side, steps.rotor[side]);
  }
  template <class T>
  void operator()(const Configuration<T>& c, int side, R, DerivativeSteps<T>& steps) const {
    const RotorConditions<T> at = rotor_conditions(c, side);
    T seen[PlacedRotorInput<T>::kCount];
    flatten(PlacedRotorInput<T>{steps.rotor_input, at.speed, at.ground_wash, at.density, at.speed_of_sound},
            seen);
    chain_through<PlacedRotorInput<T>::kCount>(seen, side, steps.rotor[side]);
  }
};

// or one of them, whether there is an expansion.
template <class R>
struct KnownRotors {
  const RotorExpansion<R>* about;
  const RotorDirections* own = nullptr;

  template <class T>
  void operator()(const Configuration<R>& c, int side, R azimuth, DerivativeSteps<T>& steps) const {
    if constexpr (!std::is_same_v<LocalDual<RotorInput, T>, T>) {
      if (about != nullptr) {
        ExpandedRotors<R>{*about, own}(c, side, azimuth, steps);
        return;
      }
    }
    AskedRotors{own}(c, side, azimuth, steps);
  }
};

}  // namespace tiltrotor

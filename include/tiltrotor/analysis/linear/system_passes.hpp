// The systems on dual numbers about a point, a few columns of A and B at a time, through the airframe's expansion.
#pragma once

#include <utility>

#include "tiltrotor/analysis/linear/airframe_expansion.hpp"
#include "tiltrotor/analysis/linear/vehicle_shape.hpp"

namespace tiltrotor {

// Of one pass: twice as many cost the same a direction, and on a microcontroller more. Each is computed alike.
inline constexpr int kVehicleDirections = kWidestLanes<double> > 1 ? 16 : 8;

template <class R>
struct SystemPassWorkspace {
  using T = Dual<R, kVehicleDirections>;
  Configuration<T> configuration;  // where ground counts
  State<T> x;
  SystemState<T> s, rates;
  Commands<T> commands;
  Controls<T> u;
  AirframeDemand<T> demand;
  AirframeAnswer<T> answer;
  VehicleFlows<T> flows;
  vehicle_linearization::ExpandedWorkspace<T> expanded;
};

namespace vehicle_linearization {

// All states and inputs of a pass, those of columns `first` to `last` of [A B] seeded.
template <class R, class Systems>
void seed(const State<R>& x, const SystemState<R>& s, const Commands<R>& commands, const Controls<R>& u,
          const VehicleShape& shape, int first, int last, Systems& to) {
  using T = typename Systems::T;
  T *states[vehicle_state_count], *inputs[vehicle_input_count];
  in_scalar(x, to.x);
  in_scalar(s, to.s);
  in_scalar(u, to.u);
  in_scalar(commands, to.commands);
  list_places(to.x, states);
  list_places(to.s, states + state_count);
  list_places(to.u, inputs);
  list_places(to.commands, inputs + control_count);
  for (int k = first; k < last; ++k) {
    T& seeded = *(k < shape.states ? states[shape.state[k]] : inputs[shape.input[k - shape.states]]);
    seeded.d.set(k - first, R(1));
  }
}

// put_a and put_b as in linearize_vehicle(), about the point (x, s, u). False: a rate or an entry is not finite. `c`: as it is
// there, `base`: its setting before the systems put it.
template <class R, class PutA, class PutB>
bool differentiate_systems(const Vehicle<R>& v, const Configuration<R>& c,
                           const ConfigurationSetting<R>& base, const State<R>& x, const SystemState<R>& s,
                           const Controls<R>& u, const VehicleShape& shape, const Expansion<R>& about,
                           SystemPassWorkspace<R>& work, PutA&& put_a, PutB&& put_b) {
  using T = typename SystemPassWorkspace<R>::T;
  static_cast<FixedSetup<R>&>(work.configuration) = c;
  work.configuration.setup.options = c.setup.options;
  work.configuration.around = c.around;
  T sum = T(R(0));  // finite where all of them are, short of the largest numbers
  work.expanded.searches = v.on.governor == Governor::ideal;
  const int all = shape.states + shape.inputs;
  for (int first = 0; first < all; first += kVehicleDirections) {
    const int last = first + kVehicleDirections < all ? first + kVehicleDirections : all;
    seed(x, s, v.commands, u, shape, first, last, work);
    const auto within = [&](int end) { return first > end ? 0 : (last < end ? last : end) - first; };
    work.expanded.first_state = first < about.states ? first : about.states;
    work.expanded.states = within(about.states);
    vehicle_rates<T>(v, c, base, work.configuration, work.x, work.s, work.commands, work.u,
                     ExpandedAirframe<T>{about, c, work.expanded}, work.demand, work.answer, work.flows,
                     work.rates);
    const T* found[vehicle_state_count];
    list_places(std::as_const(work.answer.rates), found);
    list_places(std::as_const(work.rates), found + state_count);
    const int states = within(shape.states), inputs = last - first - states;
    for (int i = 0; i < shape.states; ++i) {
      const T& rate = *found[shape.state[i]];
      R slope[kVehicleDirections];
      rate.d.copy_to(slope);
      sum += rate;
      if (states == kVehicleDirections) {
        put_a(i, first, kVehicleDirections, static_cast<const R*>(slope));
        continue;
      }
      if (states > 0) put_a(i, first, states, static_cast<const R*>(slope));
      if (inputs > 0) put_b(i, first + states - shape.states, inputs, static_cast<const R*>(slope + states));
    }
  }
  R slopes[kVehicleDirections];
  sum.d.copy_to(slopes);
  for (const R& slope : slopes) sum.v += slope;
  return sum.v * R(0) == R(0);  // of every finite number
}

}  // namespace vehicle_linearization

}  // namespace tiltrotor

// How rates and instruments of the whole vehicle change along directions of its states and inputs, exactly: the vehicle
// itself on dual numbers, with its configuration, its rotors by their expansion. It shares neither the expansion of the
// airframe nor the choice of states with vehicle_model.hpp: heading, position, fuel and what the augmentation holds
// count as well. Only the turbulence is held.
#pragma once

#include <type_traits>

#include "tiltrotor/analysis/flight/vehicle_readings.hpp"
#include "tiltrotor/analysis/linear/vehicle_model.hpp"

namespace tiltrotor {

// Of one pass; the last direction of its dual numbers is that of an ideal governor's collective.
inline constexpr int kVehicleSlopes = kVehicleDirections - 1;

template <class R>
struct VehicleDirectionWorkspace {
  using T = Dual<R, kVehicleSlopes + 1>;
  Configuration<T> configuration;
  State<T> x;
  SystemState<T> s, rates;
  Commands<T> commands;
  Controls<T> u;
  DerivativeSteps<T> steps;
  AirframeDemand<T> demand;
  AirframeAnswer<T> answer;
  VehicleFlows<T> flows;
  Instruments<T> readings;
  T y[Instruments<T>::kCount];
  struct Point {
    DerivativeSteps<R> steps;
    AirframeDemand<R> demand;
    AirframeAnswer<R> answer;
  } point;
  RotorExpansion<R> rotors;  // about the point
  RotorExpansionWorkspace<R> expanding;
  R governed;                 // collective of an ideal governor at the point, rad
  R follows[kVehicleSlopes];  // and how it changes along each direction
  bool ideal;

  // Of what was found along a direction.
  R slope(const T& found, int direction) const {
    const R open = found.d.get(direction);
    return ideal ? open + follows[direction] * found.d.get(kVehicleSlopes) : open;
  }
};

namespace vehicle_direction_detail {

// The point: `c` is put into what the systems ask for there, the rotors are expanded about it. False: an ideal governor
// finds no collective.
template <class R>
bool find_point(const Vehicle<R>& v, Configuration<R>& c, const State<R>& x, const SystemState<R>& s,
                const Controls<R>& u, R azimuth, VehicleDirectionWorkspace<R>& work) {
  auto& point = work.point;
  VehicleFlows<R> flows;
  SystemState<R> rates;
  const ConfigurationSetting<R> base = c.setup;
  work.ideal = v.on.governor == Governor::ideal;
  work.governed = R(0);
  if (work.ideal) {
    vehicle_rates(v, c, base, c, x, s, v.commands, u, VehicleAirframe<R>{c, x, point.steps, azimuth},
                  point.demand, point.answer, flows, rates);
    work.governed = flows.governed;
    if (!flows.held) return false;
  } else {
    airframe_demand(v, c, base, c, x, s, v.commands, u, point.demand, flows, rates);
    put_into(point.demand, c);
  }
  expand_rotors(c, x, point.demand.controls, azimuth, work.expanding, work.rotors);
  return true;
}

// Rates and instruments from the seeded states and inputs of `work`. An ideal governor's collective is one more input,
// and follows by the implicit function: dP/dx dx + dP/dc dc = 0.
template <class R>
void evaluate_seeded(const Vehicle<R>& v, const Configuration<R>& c, const ConfigurationSetting<R>& base,
                     R azimuth, VehicleDirectionWorkspace<R>& work) {
  using T = typename VehicleDirectionWorkspace<R>::T;
  moved_configuration<T>(c, nullptr, nullptr, 0, work.configuration);
  Vehicle<R> open = v;
  if (work.ideal) open.on.governor = Governor::off;
  const T added = T::variable(work.governed, kVehicleSlopes);
  using Expanded = VehicleAirframe<T, ExpandedRotors<R>>;
  struct Airframe : Expanded {
    const T* added;  // collective, or nullptr
    void operator()(AirframeDemand<T>& demand, AirframeAnswer<T>& answer) const {
      if (added != nullptr) demand.controls.collective = demand.controls.collective + *added;
      Expanded::operator()(demand, answer);
    }
  };
  vehicle_rates<T>(open, c, base, work.configuration, work.x, work.s, work.commands, work.u,
                   Airframe{{work.configuration, work.x, work.steps, azimuth, {work.rotors}},
                            work.ideal ? &added : nullptr},
                   work.demand, work.answer, work.flows, work.rates);
  const Aircraft<R>& aircraft = *c.aircraft;
  out_of_line([&] {
    read_vehicle(v, work.configuration, work.x, work.steps, work.answer.rates, work.rates, work.readings);
  });
  if (!work.ideal) return;
  const T excess = (work.answer.torque[right] + work.answer.torque[left]) * work.demand.setting.rotor_speed -
                   aircraft.controls.transmission_efficiency * work.flows.power;
  for (int k = 0; k < kVehicleSlopes; ++k) work.follows[k] = -excess.d.get(k) / excess.d.get(kVehicleSlopes);
}

}  // namespace vehicle_direction_detail

// dxdot[vehicle_state_count] and dy[Instruments::kCount] along dx[vehicle_state_count] and du[vehicle_input_count].
// `c`: as in linearize_vehicle(). Status: ok; not_finite (what was found is then written); bad_argument (c is not
// prepared); not_converged (an ideal governor finds no collective). Cost: some 3 derivatives, and the search of an ideal governor.
template <class R>
Status vehicle_direction(const Vehicle<R>& v, Configuration<R>& c, const State<R>& x, const SystemState<R>& s,
                         const Controls<R>& u, const R* dx, const R* du, VehicleDirectionWorkspace<R>& work,
                         R* dxdot, R* dy, R azimuth = R(0)) {
  using T = typename VehicleDirectionWorkspace<R>::T;
  if (c.aircraft == nullptr) return Status::bad_argument;
  const ConfigurationSetting<R> base = c.setup;
  if (!vehicle_direction_detail::find_point(v, c, x, s, u, azimuth, work)) return Status::not_converged;
  vehicle_linearization::seed(x, s, v.commands, u, VehicleShape{}, 0, 0, work);
  const auto along = [](const R* way, auto&... parts) {
    const auto add = [&way](T& number) { number.d.set(0, *way++); };
    (std::remove_reference_t<decltype(parts)>::each(parts, add), ...);
  };
  along(dx, work.x, work.s);
  along(du, work.u, work.commands);
  vehicle_direction_detail::evaluate_seeded(v, c, base, azimuth, work);
  bool finite = true;
  const auto put = [&](R* to, const auto&... parts) {
    const auto take = [&](const T& found) {
      const R slope = work.slope(found, 0);
      finite &= is_finite(found.v);
      finite &= is_finite(slope);
      *to++ = slope;
    };
    (std::remove_reference_t<decltype(parts)>::each(parts, take), ...);
  };
  put(dxdot, work.answer.rates, work.rates);
  put(dy, work.readings);
  return finite ? Status::ok : Status::not_finite;
}

// put_c(i, j, dy_i/dx_j) and put_d(i, j, dy_i/du_j), columns as `shape` says, of `rows` outputs that read(y) takes from
// what `work` holds of an evaluation: its configuration, x, steps, answer and readings. y: `rows` numbers of the caller.
// Arguments and status as vehicle_direction(). Cost: some 3 derivatives, and for every 15 columns one and a
// half, without vectors for every 7 one.
template <class R, class Read, class PutC, class PutD>
Status linearize_vehicle_rows(const Vehicle<R>& v, Configuration<R>& c, const State<R>& x,
                              const SystemState<R>& s, const Controls<R>& u, const VehicleShape& shape,
                              VehicleDirectionWorkspace<R>& work, int rows,
                              typename VehicleDirectionWorkspace<R>::T* y, Read&& read, PutC&& put_c,
                              PutD&& put_d, R azimuth = R(0)) {
  if (c.aircraft == nullptr) return Status::bad_argument;
  const ConfigurationSetting<R> base = c.setup;
  if (!vehicle_direction_detail::find_point(v, c, x, s, u, azimuth, work)) return Status::not_converged;
  bool finite = true;
  const int all = shape.states + shape.inputs;
  for (int first = 0; first < all; first += kVehicleSlopes) {
    const int last = first + kVehicleSlopes < all ? first + kVehicleSlopes : all;
    vehicle_linearization::seed(x, s, v.commands, u, shape, first, last, work);
    vehicle_direction_detail::evaluate_seeded(v, c, base, azimuth, work);
    read(y);
    for (int i = 0; i < rows; ++i) {
      for (int j = first; j < last; ++j) {
        const R slope = work.slope(y[i], j - first);
        finite &= is_finite(slope);
        finite &= is_finite(y[i].v);
        if (j < shape.states) {
          put_c(i, j, slope);
        } else {
          put_d(i, j - shape.states, slope);
        }
      }
    }
  }
  return finite ? Status::ok : Status::not_finite;
}

// Of the readings, in the order of Instruments.
template <class R, class PutC, class PutD>
Status linearize_vehicle_outputs(const Vehicle<R>& v, Configuration<R>& c, const State<R>& x,
                                 const SystemState<R>& s, const Controls<R>& u, const VehicleShape& shape,
                                 VehicleDirectionWorkspace<R>& work, PutC&& put_c, PutD&& put_d,
                                 R azimuth = R(0)) {
  using T = typename VehicleDirectionWorkspace<R>::T;
  return linearize_vehicle_rows(
      v, c, x, s, u, shape, work, Instruments<T>::kCount, work.y,
      [&work](T* to) { flatten(work.readings, to); }, put_c, put_d, azimuth);
}

}  // namespace tiltrotor

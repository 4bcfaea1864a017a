// A flight whose controls follow a feedback law at every moment of a step, not from step to step.
//
//   static SimulationWorkspace<double, ClosedLoop> work;
//   work.law = &law;  work.reference = ...;      // gains, and where they count from: feedback.hpp
//   work.fastest = fastest_rates<double>(...);   // of the closed loop, which may be faster than the aircraft
//   advance_moving(moving, work, flight);        // or advance(), advance_vehicle(): response.hpp
//
// What the flight holds as its controls, its own and the inputs, is then what the law adds to. Nothing stops it: whoever
// flies looks whether a control has left its range.
#pragma once

#include "tiltrotor/analysis/flight/response.hpp"
#include "tiltrotor/analysis/flight/vehicle_readings.hpp"
#include "tiltrotor/analysis/linear/feedback.hpp"

namespace tiltrotor {

// The policy of such a flight. Its Jacobians, of rodas3 and the exponential step, are differences of the closed loop.
struct ClosedLoop : NumDiff {};

// y_0 by the columns of a law, and dy/du there by rows of Instruments; zero where the law reads none.
template <class R>
struct FeedbackReference {
  R reading[kReadingCount];
  Matrix<R, Instruments<R>::kCount, control_count> d;
};

// What the law sees and finds on its way.
template <class R>
struct FeedbackSearch {
  FeedbackPoint<R> at;
  Matrix<R, control_count, control_count> loop;  // 1 + K D of the reference, by rows of the law
  LU<R, control_count> lu;
  State<R> rates;
  VehicleReadings<R> vehicle;

  // What the instruments read where `u` acts; an ideal governor's search goes on from the one before.
  const Instruments<R>& read(const Configuration<R>& c, const State<R>& x, const FlownVehicle<R>* systems,
                             SystemState<R>& s, const Controls<R>& u, R azimuth) {
    if (systems == nullptr) {
      derivative(c, x, u, vehicle.steps, rates, azimuth);
      read_instruments(c, x, vehicle.steps, rates, vehicle.readings);
    } else {
      vehicle.read(*systems, c, x, s, u, azimuth);
      if (systems->vehicle.on.governor == Governor::ideal) s.governor = vehicle.flows.governed;
    }
    return vehicle.readings;
  }
};

inline constexpr int kMaxFeedbackSteps = 60;
template <class R>
inline constexpr R kFeedbackTolerance = R(1e5) * std::numeric_limits<R>::epsilon();  // of a control's bend

// The controls that act where the hands are at `hands`; `systems`: around the airframe, or nullptr. Where readings hang
// on the controls, both are found together by steps with (1 + K D) of the reference. Status: ok; not_converged (D is
// another by far, or the loop nearly answers itself); singular; not_finite. Cost: gains; with instruments some five
// derivatives.
template <class R>
Status feed_back(const FeedbackLaw<R>& law, const FeedbackReference<R>& reference, const Configuration<R>& c,
                 const State<R>& x, const FlownVehicle<R>* systems, const Controls<R>& hands, R azimuth,
                 FeedbackSearch<R>& search, Controls<R>& acting) {
  R seen[kReadingCount] = {}, from[control_count], u[control_count];
  flatten(x, seen);
  SystemState<R> s{};
  if (systems != nullptr) s = systems->state;
  flatten(s, seen + state_count);
  flatten(hands, from);
  flatten(hands, u);
  search.at.mast_deg = systems != nullptr ? systems->mast_deg() : c.setup.mast_deg;
  search.at.air = x.velocity - hands.gust;
  const GainShares<R> shares = gain_shares(law, search.at.mast_deg, length(search.at.air));
  // By how much input i stands off the law.
  const auto distance = [&](int i) {
    R sum = from[law.input[i]] - u[law.input[i]];
    for (int k = 0; k < law.readings; ++k) sum -= shares.gain(law, i, k) * search.at.deviation[k];
    return sum;
  };
  const auto look = [&] {
    for (int k = 0; k < law.readings; ++k)
      search.at.deviation[k] = seen[law.reading[k]] - reference.reading[k];
  };
  if (!law.reads_instruments()) {
    look();
    for (int i = 0; i < law.inputs; ++i) u[law.input[i]] += distance(i);
    unflatten(u, acting);
    return Status::ok;
  }
  set_zero(search.loop);
  for (int i = 0; i < law.inputs; ++i)
    for (int j = 0; j < law.inputs; ++j) {
      search.loop(i, j) = R(i == j);
      for (int k = 0; k < law.readings; ++k)
        if (is_instrument(law.reading[k]))
          search.loop(i, j) +=
              shares.gain(law, i, k) * reference.d(law.reading[k] - vehicle_state_count, law.input[j]);
    }
  const Status status = lu_factor(search.loop, law.inputs, search.lu);
  if (status != Status::ok) return status;
  for (int step = 0; step < kMaxFeedbackSteps; ++step) {
    unflatten(u, acting);
    flatten(search.read(c, x, systems, s, acting, azimuth), seen + vehicle_state_count);
    look();
    R way[control_count];
    bool is_there = true;
    for (int i = 0; i < law.inputs; ++i) {
      way[i] = distance(i);
      is_there = is_there && std::fabs(way[i]) <= kFeedbackTolerance<R> * control_scale<R>(law.input[i]);
    }
    if (is_there) return Status::ok;
    const Status solved = lu_solve(search.lu, way);
    if (solved != Status::ok) return solved;
    for (int i = 0; i < law.inputs; ++i) u[law.input[i]] += way[i];
  }
  return Status::not_converged;
}

template <class R>
struct SimulationWorkspace<R, ClosedLoop> : SimulationWorkspace<R, NumDiff> {
  const FeedbackLaw<R>* law;
  FeedbackReference<R> reference;
  FastestRates<R> fastest;  // of the closed loop; 0: not faster than the open one
  FeedbackSearch<R> search;
  Controls<R> acting;  // those of the last evaluation
};

// From eigenvalues: by how well each is damped, the largest. Roots that grow count for accuracy.
template <class R, class Real, class Imag>
FastestRates<R> fastest_rates(int count, Real&& real, Imag&& imag) {
  constexpr R kHardlyDamped = R(0.17364817766693033);  // sin 10 deg, of StabilityLimits
  FastestRates<R> fastest = {R(0), R(0)};
  for (int k = 0; k < count; ++k) {
    const R size = std::sqrt(real(k) * real(k) + imag(k) * imag(k));
    R& most = std::fabs(real(k)) < kHardlyDamped * size ? fastest.oscillation : fastest.decay;
    most = larger_of(most, size);
  }
  return fastest;
}

namespace flight_step {

// The right side of the open loop, at the controls that the law finds there.
template <class R>
struct RightSide<R, ClosedLoop> : RightSide<R, NumDiff> {
  using Open = RightSide<R, NumDiff>;
  SimulationWorkspace<R, ClosedLoop>& work;
  const Controls<R>& hands;

  RightSide(const Configuration<R>& of, SimulationWorkspace<R, ClosedLoop>& w, const Controls<R>& by_hand,
            int& fault, R azimuth_then, const MovingConfiguration<R>* moves, const SteepStart<R>* steeply,
            SystemPart<R>* parts)
      : Open{of, w, w.acting, fault, azimuth_then, moves, steeply, parts}, work(w), hands(by_hand) {}

  // `x`: with Euler angles.
  Status act(const R* x, R azimuth) const {
    const SystemPart<R>* const parts = this->systems;
    const State<R> state = this->airframe_state(x);
    if (parts == nullptr)
      return feed_back<R>(*work.law, work.reference, this->c, state, nullptr, hands, azimuth, work.search,
                          work.acting);
    const SystemState<R> s = this->system_state(x);
    const FlownVehicle<R> vehicle{parts->flight->vehicle, s, parts->base, *parts->c};
    return feed_back<R>(*work.law, work.reference, this->c, state, &vehicle, hands, azimuth, work.search,
                        work.acting);
  }
  template <class Output>
  void evaluate(const PlainInputs<R>& x, Output&& output, R azimuth) const {
    if (act(x.x, azimuth) != Status::ok) work.acting.collective = std::numeric_limits<R>::quiet_NaN();
    Open::evaluate(x, output, azimuth);
  }
  Status operator()(R time, const R* x, R* xdot) const {
    this->place_configuration(time, x);
    const R azimuth = this->azimuth(time);
    if (this->steep != nullptr) Open::steep_rates(x, xdot, azimuth);  // for the Euler angles that it leaves
    const Status status = act(this->steep != nullptr ? work.upright : x, azimuth);
    return status == Status::ok ? Open::operator()(time, x, xdot) : status;
  }
};

// In as many parts as the closed loop needs.
template <class R>
Status hold(const RightSide<R, ClosedLoop>& f, Integrator integrator, R time, R duration, int count,
            const R* known) {
  const int closed = parts(integrator, duration, f.work.fastest);
  return hold<R, ClosedLoop>(f, integrator, time, duration, count > closed ? count : closed, known);
}

}  // namespace flight_step

}  // namespace tiltrotor

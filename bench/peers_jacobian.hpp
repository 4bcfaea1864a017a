// The Jacobian of the model (23 states and 7 controls) by another library, beside our own and one plain
// evaluation.
#pragma once

#include <cmath>
#include <memory>
#include <string>

#include "flights.hpp"
#include "machine.hpp"
#include "results.hpp"

namespace bench {

inline constexpr int kPeerInputs = 30;
inline constexpr int kPeerDirections = 32;  // padded to whole vectors: every peer is fastest so

struct PeerJacobian {
  double entry[kMaxLinearStates][kPeerInputs];
};

// What is differentiated, and where.
struct PeerCase {
  Configuration<double> c;
  TrimResult<double> flight;
  LinearModel<double> exact;
  double input[kPeerInputs];  // states of the linear model, then its controls

  // y[i] = rate of state i at the inputs z. `work` is the caller's.
  template <class T>
  void rates(ModelWorkspace<T>& work, const T* z, T* y) const {
    double x[state_count];
    double u[control_count];
    flatten(flight.state, x);
    flatten(flight.controls, u);
    const ModelPlaces<T> at(work);
    for (int i = 0; i < state_count; ++i) *at.x[i] = T(x[i]);
    for (int j = 0; j < control_count; ++j) *at.u[j] = T(u[j]);
    for (int i = 0; i < exact.states; ++i) *at.x[exact.state[i]] = z[i];
    for (int j = 0; j < exact.controls; ++j) *at.u[exact.control[j]] = z[exact.states + j];
    model_rates(c, 0.0, work);
    T* rate[state_count];
    list_places(work.rates, rate);
    for (int i = 0; i < exact.states; ++i) y[i] = *rate[exact.state[i]];
  }
};

inline std::unique_ptr<PeerCase> peer_case() {
  auto p = std::make_unique<PeerCase>();
  p->c = configuration(kMiddleMast);
  p->flight = trimmed(p->c, kMiddleSpeed);
  const auto work = std::make_unique<LinearizationWorkspace<double, AutoDiff>>();
  require(linearize(p->c, p->flight.state, p->flight.controls, kBladeControls, *work, p->exact) == Status::ok,
          "A, B");
  require(p->exact.states + p->exact.controls == kPeerInputs, "the number of states has changed");
  for (int i = 0; i < p->exact.states; ++i) p->input[i] = p->exact.x[i];
  for (int j = 0; j < p->exact.controls; ++j) p->input[p->exact.states + j] = p->exact.u[j];
  return p;
}

// Largest difference to our Jacobian over the largest entry of the row.
inline double difference(const PeerCase& p, const PeerJacobian& theirs) {
  double worst = 0;
  for (int i = 0; i < p.exact.states; ++i) {
    double size = 0;
    double error = 0;
    for (int j = 0; j < kPeerInputs; ++j) {
      const double ours = j < p.exact.states ? p.exact.a(i, j) : p.exact.b(i, j - p.exact.states);
      size = std::max(size, std::fabs(ours));
      error = std::max(error, std::fabs(theirs.entry[i][j] - ours));
    }
    if (size > 0) worst = std::max(worst, error / size);
  }
  return worst;
}

// One pass of forward mode with `seed(T&, value, direction)` and `partial(const T&, direction)`.
template <class T, class Seed, class Partial>
auto forward_pass(const PeerCase& p, Seed seed, Partial partial) {
  struct Workspace {
    ModelWorkspace<T> model;
    T z[kPeerInputs];
    T y[kMaxLinearStates];
  };
  return [&p, seed, partial, work = std::make_shared<Workspace>()](PeerJacobian& out) {
    for (int j = 0; j < kPeerInputs; ++j) seed(work->z[j], p.input[j], j);
    p.rates(work->model, work->z, work->y);
    for (int i = 0; i < p.exact.states; ++i)
      for (int j = 0; j < kPeerInputs; ++j) out.entry[i][j] = partial(work->y[i], j);
  };
}

// Measures `jacobian(PeerJacobian&)` of the peer called `name` and saves jacobian_over_function_<name>.
template <class Method>
void compare_jacobian(const PeerCase& p, const std::string& name, Method jacobian, Results& results) {
  const auto work = std::make_unique<LinearizationWorkspace<double, AutoDiff>>();
  LinearModel<double> model;
  State<double> rates;
  PeerJacobian theirs;
  Contest contest;
  const int plain = contest.enter("f", [&] { derivative(p.c, p.flight.state, p.flight.controls, rates); });
  const int ours = contest.enter("ours", [&] {
    require(linearize(p.c, p.flight.state, p.flight.controls, kBladeControls, *work, model) == Status::ok,
            "A, B");
  });
  const int peer = contest.enter(name, [&] { jacobian(theirs); });
  contest.run();
  std::printf(
      "\n %s: differs from ours by %.1e of the largest entry of the row; our own ratio in this run %.2f\n",
      name.c_str(), difference(p, theirs), contest.ratio(ours, plain).median);
  results.add("jacobian_over_function_" + name, contest.ratio(peer, plain), "-");
  results.add("jacobian_" + name + "_over_ours", contest.ratio(peer, ours), "-");
  require(difference(p, theirs) < 1e-9, "the peer's Jacobian differs");
}

}  // namespace bench

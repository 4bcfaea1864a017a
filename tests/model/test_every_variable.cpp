// Nothing of the aircraft is forgotten: every rate and load is written, every input acts. Each check names what is
// missing. Expected: memory full of NaN shows what is not written; Newton's law for the sum of the loads.
#include <cstring>

#include "flight_cases.hpp"

using namespace flight_cases;

namespace {

template <class S>
void fill_with_nan(S& s) {
  std::memset(static_cast<void*>(&s), 0xff, sizeof s);
}

// Every choice that decides which states are alive.
template <class Function>
void with_every_set_of_states(Function&& run) {
  for (int choice = 0; choice < 32; ++choice) {
    Options o;
    o.flapping = choice & 1 ? FlapOrder::first : FlapOrder::second;
    o.inflow = choice & 2 ? InflowShape::uniform : InflowShape::pitt_peters;
    o.downwash_lag = (choice & 4) == 0;
    o.coning_states = (choice & 8) != 0;
    o.position_states = (choice & 16) != 0;
    run(o);
  }
}

}  // namespace

TEST(derivatives_fill_every_rate_and_load) {
  Generator random(20);
  with_every_set_of_states([&](const Options& options) {
    const Configuration<double> c = configuration(30, options);
    const StateAndControls<double> s = random_case(random, c);
    static DerivativeSteps<double> work;
    Evaluation<double> e;
    fill_with_nan(work);
    fill_with_nan(e);
    evaluate_aircraft(c, s.x, s.u, work, e);
    const std::array<double, state_count> rates = flat<double, State>(e.rates);
    for (std::size_t i = 0; i < state_count; ++i)
      if (!CHECK(std::isfinite(rates[i]))) NOTE("no rate of " << kStateVariables.row[i].name);
    // Newton in body axes: the loads of all components, with weight, are mass times acceleration.
    Vec3<double> force{0, 0, 0};
    for (int k = 0; k < component_count; ++k) {
      const Loads<double>& loads = e.loads.component[k];
      const double sum = dot(loads.force, loads.force) + dot(loads.moment, loads.moment);
      if (!CHECK(std::isfinite(sum))) NOTE("no loads of " << kComponentNames[k]);
      force = force + loads.force;
    }
    const State<double>& x = s.x;
    const Vec3<double> down = {-std::sin(x.pitch), std::sin(x.roll) * std::cos(x.pitch),
                               std::cos(x.roll) * std::cos(x.pitch)};
    const double m = c.mass.mass;
    const Vec3<double> want =
        m * (e.rates.velocity + cross(x.rates, x.velocity)) - (m * kGravity<double>)*down;
    const Vec3<double> difference = force - want;
    if (!CHECK_NEAR(std::sqrt(dot(difference, difference)), 0, 1e-10 * m * kGravity<double>))
      NOTE("the loads of the components are not those that act");
  });
}

// An input without a column would be one that nothing reads.
TEST(linearize_every_input_acts) {
  Generator random(21);
  for (double mast : {0.0, 45.0}) {
    const Configuration<double> c = configuration(mast);
    const StateAndControls<double> s = random_case(random, c);
    for (std::size_t j = 0; j < control_count; ++j) {
      std::array<double, control_count> u = flat<double, Controls>(s.u);
      u[j] += 0.01;
      Controls<double> moved;
      unflatten(u.data(), moved);
      State<double> before, after;
      derivative(c, s.x, s.u, before);
      derivative(c, s.x, moved, after);
      const auto a = flat<double, State>(before), b = flat<double, State>(after);
      double change = 0;
      for (std::size_t i = 0; i < state_count; ++i) change = std::fmax(change, std::fabs(b[i] - a[i]));
      if (!CHECK_LT(1e-6, change)) NOTE(kControlVariables.row[j].name << " changes no rate");
    }
  }
}

// The random flights of the other tests leave no state and no input at zero.
TEST(derivatives_are_tested_at_every_variable) {
  Generator random(22);
  const StateAndControls<double> s = random_case(random, configuration(30));
  const std::array<double, state_count> x = flat<double, State>(s.x);
  const std::array<double, control_count> u = flat<double, Controls>(s.u);
  for (std::size_t i = 0; i < state_count; ++i)
    if (!CHECK(x[i] != 0)) NOTE("random_case() leaves out " << kStateVariables.row[i].name);
  for (std::size_t j = 0; j < control_count; ++j)
    if (!CHECK(u[j] != 0)) NOTE("random_case() leaves out " << kControlVariables.row[j].name);
}

// In symmetric flight one rotor answers for both.
// Expected: the blades of the other rotor, asked themselves; a trim that is its own mirror image, to the bit.
#include "analysis_case.hpp"

using namespace analysis_case;

namespace {

// Rotor by rotor, in steps of its own for each: nothing of the other one is at hand.
template <class T>
void check_each_rotor(const Configuration<double>& c, const State<T>& x, const Controls<T>& u) {
  static DerivativeSteps<T> together, alone;
  State<T> rates;
  derivative(c, x, u, together, rates);
  for (const Side side : {right, left}) {
    rotor_input(c, x, together.velocity_b, together.controls, side, alone.rotor_input);
    local_rotor_response(c, alone.rotor_input, side, 0.0, alone.local.first, alone.rotor[side]);
    T one[RotorResponse<T>::kCount], other[RotorResponse<T>::kCount];
    flatten(together.rotor[side], one);
    flatten(alone.rotor[side], other);
    for (int i = 0; i < RotorResponse<T>::kCount; ++i) {
      CHECK_EQ(value(one[i]), value(other[i]));
      if constexpr (!kIsPlain<T>)
        for (int k = 0; k < kModelDirections; ++k) CHECK_EQ(one[i].d.get(k), other[i].d.get(k));
    }
  }
}

// On scalar T, the first numbers seeded where there are directions.
template <class T, template <class> class Group>
Group<T> seeded(const Group<double>& group) {
  constexpr int count = sizeof(Group<double>) / sizeof(double);
  double flat[count];
  T numbers[count];
  flatten(group, flat);
  for (int i = 0; i < count; ++i) {
    numbers[i] = T(flat[i]);
    if constexpr (!kIsPlain<T>)
      if (i < kModelDirections) numbers[i] = T::variable(flat[i], i);
  }
  Group<T> to;
  unflatten(numbers, to);
  return to;
}

}  // namespace

TEST(trim_of_symmetric_flight_is_symmetric_to_the_bit) {
  for (double mast : {0.0, 30.0, 60.0, 90.0}) {
    for (bool coning : {false, true}) {
      Options options;
      options.coning_states = coning;
      const TrimResult<double> r = trimmed(configuration(mast, options), level(mast < 30 ? 30 : 70));
      CHECK(is_trimmed(r.status));
      const State<double>& x = r.state;
      for (const double lateral :
           {x.velocity.y, x.rates.x, x.rates.z, x.roll, r.controls.lat_stick, r.controls.pedal})
        CHECK_EQ(lateral, 0.0);
      double flat[state_count];
      flatten(x, flat);
      const auto* const one = reinterpret_cast<const int*>(&kStateIndex.rotor[right]);
      const auto* const other = reinterpret_cast<const int*>(&kStateIndex.rotor[left]);
      for (std::size_t i = 0; i < sizeof kStateIndex.rotor[right] / sizeof(int); ++i)
        CHECK_EQ(flat[one[i]], flat[other[i]]);
      CHECK_EQ(x.coning[right].angle, x.coning[left].angle);
    }
  }
  // What is lateral stays so.
  for (const SteadyFlight<double>& flight :
       {SteadyFlight<double>{70, 0, 0.1, 0}, SteadyFlight<double>{70, 0, 0, 0.05}}) {
    const TrimResult<double> r = trimmed(configuration(60), flight);
    CHECK(is_trimmed(r.status));
    CHECK_LT(1e-3, std::fabs(r.state.roll) + std::fabs(r.controls.pedal));
    CHECK(r.state.rotor[right].b1c != r.state.rotor[left].b1c);
  }
}

TEST(derivative_one_rotor_answers_for_both) {
  for (double mast : {0.0, 60.0, 90.0}) {
    const Configuration<double> c = configuration(mast);
    const TrimResult<double> r = trimmed(c, level(mast < 30 ? 30 : 70));
    State<double> x = r.state;
    check_each_rotor<double>(c, x, r.controls);
    check_each_rotor<Dual<double, kModelDirections>>(c, seeded<Dual<double, kModelDirections>>(x),
                                                     seeded<Dual<double, kModelDirections>>(r.controls));
    // A number in its last place, and each rotor is asked.
    x.rotor[left].b1c = std::nextafter(x.rotor[left].b1c, 1);
    check_each_rotor<double>(c, x, r.controls);
    // Only one of them stands over the ground.
    Configuration<double> banked = c;
    banked.rotor[left].ground_wash = 0.9;
    check_each_rotor<double>(banked, r.state, r.controls);
  }
}

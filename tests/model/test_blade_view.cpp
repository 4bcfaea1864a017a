// Slopes of a rotor's loads, carried back from blades to hub: against a complex step, which goes through blade after blade on
// complex numbers, and the transposes against the maps they belong to.
#include <algorithm>
#include <complex>

#include "flight_cases.hpp"
#include "tiltrotor/model/rotor/nested_blades.hpp"

using namespace flight_cases;

namespace {

using Complex = std::complex<double>;
constexpr int kPlaces = PlacedRotorInput<double>::kCount;

RotorInput<double> random_input(Generator& random) {
  RotorInput<double> in{};
  in.velocity_a = {random.between(-60, 60), random.between(-30, 30), random.between(-20, 90)};
  in.rates_a = {random.between(-0.5, 0.5), random.between(-0.5, 0.5), random.between(-0.5, 0.5)};
  in.state = {random.between(-0.1, 0.1),  random.between(-0.1, 0.1),  random.between(-1, 1),
              random.between(-1, 1),      random.between(0.01, 0.08), random.between(-0.02, 0.02),
              random.between(-0.02, 0.02)};
  in.coning = {random.between(0, 0.1), random.between(-1, 1)};
  in.collective = random.between(0, 0.6);
  in.lateral_cyclic = random.between(-0.1, 0.1);
  in.long_cyclic = random.between(-0.1, 0.1);
  return in;
}

// The loads of a rotor at numbers of its input and of its conditions; kMoving: the latter carry partials, too.
template <bool kSeeded, bool kMoving, class T>
RotorLoads<T> loads_at(const Configuration<double>& c, const AzimuthStations<double>& azimuth,
                       const T* places) {
  PlacedRotorInput<T> at;
  unflatten(places, at);
  BladeGroup<T> blades;
  RotorLoads<T> sum;
  const RotorConditions<double> fixed = rotor_conditions(c, right);
  if constexpr (kMoving) {
    RotorConditions<T> turn;
    set_conditions(at, c.aircraft->rotor.radius, fixed.spin_up, turn);
    rotor_loads(c, turn, at.in, azimuth, blades, sum, kSeeded);
  } else {
    rotor_loads(c, fixed, at.in, azimuth, blades, sum, kSeeded);
  }
  return sum;
}

template <bool kSeeded, bool kMoving>
void compare(const Configuration<double>& c, const AzimuthStations<double>& azimuth, const double* at) {
  constexpr int kLoads = RotorLoads<double>::kCount;
  constexpr int kInputs = RotorInput<double>::kCount;
  using D = Dual<double, kPlaces>;
  D seeded[kPlaces];
  for (int j = 0; j < kPlaces; ++j) seeded[j] = D::variable(at[j], j);
  D found[kLoads];
  flatten(loads_at<kSeeded, kMoving>(c, azimuth, seeded), found);
  double plain[kLoads];
  flatten(loads_at<false, kMoving>(c, azimuth, at), plain);
  for (int i = 0; i < kLoads; ++i) CHECK(found[i].v == plain[i]);
  for (int j = 0; j < (kMoving ? kPlaces : kInputs); ++j) {
    Complex stepped[kPlaces];
    for (int k = 0; k < kPlaces; ++k) stepped[k] = Complex(at[k], k == j ? 1e-30 : 0.0);
    Complex exact[kLoads];
    flatten(loads_at<false, kMoving>(c, azimuth, stepped), exact);
    double size = 0;
    for (const Complex& x : exact) size = std::max(size, std::fabs(x.imag() * 1e30));
    const double largest = std::max(std::fabs(plain[2]), std::fabs(plain[6]));  // thrust, flapping moment
    for (int i = 0; i < kLoads; ++i) {
      CHECK_NEAR(found[i].d.get(j), exact[i].imag() * 1e30, 1e-11 * size + 1e-300);
      CHECK_NEAR(plain[i], exact[i].real(), 1e-12 * largest);
    }
  }
}

}  // namespace

// With more and fewer blades than vectors have lanes.
TEST(rotor_blade_slopes_are_those_of_a_complex_step) {
  NOTE("seed 71");
  Generator random(71);
  const Configuration<double> c = configuration(30);
  for (int n = 0; n < 6; ++n) {
    PlacedRotorInput<double> point;
    point.in = random_input(random);
    const RotorConditions<double> turn = rotor_conditions(c, right);
    point.speed = turn.speed * random.between(0.8, 1.1);
    point.ground_wash = random.between(0.7, 1);
    point.density = turn.density * random.between(0.7, 1);
    point.speed_of_sound = turn.speed_of_sound * random.between(0.9, 1);
    double at[kPlaces];
    flatten(point, at);
    AzimuthStations<double> azimuth =
        averaged_azimuth<double>(aircraft().rotor.blades, n == 0 ? 8 : 4 + 3 * n);
    if (n == 5) individual_azimuth(aircraft().rotor.blades, 0.3, azimuth);
    compare<false, false>(c, azimuth, at);
    compare<true, false>(c, azimuth, at);
    compare<false, true>(c, azimuth, at);
    compare<true, true>(c, azimuth, at);
  }
}

// <w, L x> = <L' w, x> for a linear map L, its transpose L' and any w and x.
TEST(rotor_blade_view_transposes) {
  NOTE("seed 72");
  Generator random(72);
  for (int n = 0; n < 20; ++n) {
    double number[BladeHarmonics<double>::kCount];
    for (double& x : number) x = random.between(-2, 2);
    BladeHarmonics<double> hub;
    unflatten(number, hub);
    const double psi = random.between(-3, 3), cosine = std::cos(psi), sine = std::sin(psi);
    const auto dot = [](const BladeView<double>& a, const BladeView<double>& b) {
      return a.forward * b.forward + a.outward * b.outward + a.axial * b.axial + a.rolling * b.rolling +
             a.spin * b.spin + a.flap * b.flap + a.flap_rate * b.flap_rate + a.inflow * b.inflow +
             a.shaped * b.shaped + a.pitch * b.pitch;
    };
    const auto any = [&random] { return random.between(-2, 2); };
    const BladeView<double> w = {any(), any(), any(), any(), any(), any(), any(), any(), any(), any()};
    double back[BladeHarmonics<double>::kCount];
    flatten(slopes_along_hub(w, cosine, sine), back);
    double forth = 0;
    for (int i = 0; i < BladeHarmonics<double>::kCount; ++i) forth += back[i] * number[i];
    CHECK_NEAR(dot(w, blade_view(hub, cosine, sine)), forth, 1e-13);

    // At a flap angle that is held the flow is linear in the rest of the view.
    BladeView<double> view = blade_view(hub, cosine, sine);
    using Flap = Dual<double, 1>;
    const SineCosine<Flap> flap = sine_and_cosine(Flap::variable(view.flap, 0));
    const BladeFlow<Flap> flow = blade_flow(view, flap);
    const BladeFlow<double> along = {any(), any(), any(), any(), any(), any()};
    const BladeView<double> of = slopes_along_view(along, 0.0, flow, flap.sine.v, flap.cosine.v);
    const double along_flap = view.flap * of.flap;
    CHECK_NEAR(along.tangential_0 * flow.tangential_0.v + along.tangential_r * flow.tangential_r.v +
                   along.normal_0 * flow.normal_0.v + along.normal_r * flow.normal_r.v +
                   along.shaped * flow.shaped.v + along.pitch * flow.pitch.v,
               dot(of, view) - along_flap, 1e-13);
  }
}

// Nested dual numbers over a configuration of plain ones: slope along a direction, and the partials of the values.
TEST(rotor_blades_on_nested_dual_numbers) {
  NOTE("seed 73");
  Generator random(73);
  using D = Dual<double, 3>;
  using N = Nested<D>;
  constexpr int kLoads = RotorLoads<double>::kCount;
  const Configuration<double> c = configuration(60);
  double at[kPlaces] = {}, along[kPlaces];
  flatten(random_input(random), at);
  for (double& x : along) x = random.between(-1, 1);
  N nested[kPlaces];
  for (int k = 0; k < kPlaces; ++k)
    nested[k] = {k < 3 ? D::variable(at[k], k) : D(at[k]), D(k < RotorInput<double>::kCount ? along[k] : 0)};
  N found[kLoads];
  flatten(loads_at<false, false>(c, c.azimuth, nested), found);
  for (int j = -1; j < 3; ++j) {  // -1: along the direction
    Complex stepped[kPlaces];
    for (int k = 0; k < kPlaces; ++k)
      stepped[k] = Complex(at[k], 1e-30 * (j < 0 ? along[k] : k == j ? 1 : 0));
    Complex exact[kLoads];
    flatten(loads_at<false, false>(c, c.azimuth, stepped), exact);
    double size = 0, largest = 0;
    for (const Complex& x : exact) size = std::max(size, std::fabs(x.imag() * 1e30));
    for (const Complex& x : exact) largest = std::max(largest, std::fabs(x.real()));
    for (int i = 0; i < kLoads; ++i) {
      CHECK_NEAR(found[i].v.v, exact[i].real(), 1e-12 * largest);
      CHECK_NEAR(j < 0 ? found[i].along.v : found[i].v.d.get(j), exact[i].imag() * 1e30, 1e-11 * size);
    }
  }
}

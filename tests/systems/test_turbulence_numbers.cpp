// What a program relies on in turbulence: the same bits everywhere, other ones for another seed, finite for whatever
// flies, exact derivatives, calm when it begins.
#include <algorithm>
#include <cstring>
#include <string>

#include "check.hpp"
#include "systems/turbulence_response.hpp"
#include "tiltrotor/math/differentiation/complex_step.hpp"
#include "tiltrotor/math/differentiation/dual.hpp"

using namespace turbulence_response;

namespace {

// FNV-1a of the bits of the first 1000 gusts of an approach: descending, slowing down.
std::uint64_t hash_of_approach(std::uint64_t seed) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  State state{};
  for (std::uint64_t k = 0; k < 1000; ++k) {
    const double left = 1 - static_cast<double>(k) / 1000;
    const Air air{700 * left, 90 * left, 15};
    state = turbulence_step(state, air, 0.01, tiltrotor::gust_noise<double>(seed, k), aircraft());
    for (const double gust : all(gusts_at(state, air, aircraft()))) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &gust, sizeof bits);
      for (int shift = 0; shift < 64; shift += 8) hash = (hash ^ ((bits >> shift) & 0xff)) * 0x100000001b3u;
    }
  }
  return hash;
}

template <class T>
std::array<T, 12> approach(const T& height, const T& airspeed, const T& wind,
                           const tiltrotor::Aircraft<tiltrotor::Real<T>>& numbers) {
  using R = tiltrotor::Real<T>;
  const tiltrotor::TurbulentAir<T> air{height, airspeed, wind};
  tiltrotor::TurbulenceState<T> state{};
  tiltrotor::TurbulenceState<T>::each(state, [](T& x) { x = T(R(0)); });
  for (std::uint64_t k = 0; k < 200; ++k)
    state = turbulence_step(state, air, R(0.01), tiltrotor::gust_noise<R>(3, k), numbers);
  const tiltrotor::LocalGusts<T> g = gusts_at(state, air, numbers);
  std::array<T, 12> list{};
  std::size_t n = 0;
  for (const auto* at : {&g.rotor[0], &g.rotor[1], &g.wing, &g.tail})
    for (const T* x : {&at->x, &at->y, &at->z}) list[n++] = *x;
  return list;
}

}  // namespace

// The number was made on x86-64; AArch64, RISC-V and 32-bit ARM, g++ and clang++, -O0 and -O3 gave it too.
TEST_OF_XV15(turbulence_has_the_same_bits_everywhere) {
  CHECK_EQ(hash_of_approach(1), 0x1f06c64a49c0fc6au);
  CHECK_EQ(hash_of_approach(1), hash_of_approach(1));
  CHECK(hash_of_approach(1) != hash_of_approach(2));
}

// At rest in the air, in a pit, in a calm, at any step.
TEST(turbulence_is_finite_wherever_one_flies) {
  for (const double height : {-100.0, 0.0, 3.0, 300.0, 12000.0})
    for (const double speed : {0.0, 1.0, 150.0})
      for (const double dt : {0.0, 1e-6, 0.01, 100.0}) {
        State state{};
        double largest = 0;
        for (std::uint64_t k = 0; k < 1000; ++k) {
          state = turbulence_step(state, Air{height, speed, 23}, dt, tiltrotor::gust_noise<double>(9, k),
                                  aircraft());
          for (const double gust : all(gusts_at(state, Air{height, speed, 23}, aircraft())))
            largest = std::isfinite(gust) ? std::max(largest, std::abs(gust)) : HUGE_VAL;
        }
        // Severe: 4.6 m/s at most, six times that.
        CHECK_LT(largest, 6 * 4.7);
        CHECK(dt == 0 ? largest == 0 : largest > 0);
      }
}

// At rest the spectra are those of an aircraft that moves at 10 ft/s.
TEST(turbulence_drifts_by_at_rest) {
  const double dt = 0.05;
  const Response at_rest({15, 0, 15}, dt, 300);
  const Response moving({15, 10 * kFoot, 15}, dt, 300);
  for (int i = 0; i < 3; ++i) {
    CHECK_REL(at_rest.variance({tail, i}), moving.variance({tail, i}), 1e-6);
    CHECK_REL(at_rest.covariance({wing, i}, {wing, i}, 20), moving.covariance({wing, i}, {wing, i}, 20),
              0.03);
  }
}

// A gust begins at zero and grows within L/V; no wind, no gust.
TEST(turbulence_begins_calm) {
  const Air air{15, 60, 15};
  for (const double gust : all(gusts_at(State{}, air, aircraft()))) CHECK_EQ(gust, 0);
  State state{};
  const double dt = 1e-4;
  state = turbulence_step(state, air, dt, tiltrotor::gust_noise<double>(1, 0), aircraft());
  const auto law = tiltrotor::dryden_law(air, aircraft().gust);
  for (const double gust : all(gusts_at(state, air, aircraft())))
    CHECK_LT(std::abs(gust), 6 * law.intensity.x * std::sqrt(3 * dt * air.airspeed / law.scale.z));
  for (const double gust : all(gusts_at(state, Air{15, 60, 0}, aircraft()))) CHECK_EQ(gust, 0);
}

// Dual numbers against complex steps, through 200 steps.
TEST(turbulence_has_exact_derivatives) {
  using Dual = tiltrotor::Dual<double, 3>;
  using Complex = std::complex<double>;
  constexpr double step = 1e-30;
  for (const double height : {2.0, 40.0, 450.0, 900.0})
    for (const double speed : {0.0, 40.0}) {
      const auto dual =
          approach(Dual::variable(height, 0), Dual::variable(speed, 1), Dual::variable(12, 2), aircraft());
      const auto plain = approach(height, speed, 12.0, aircraft());
      for (int direction = 0; direction < 3; ++direction) {
        const auto shifted = [&](double x, int i) { return Complex(x, i == direction ? step : 0); };
        const auto complex = approach(shifted(height, 0), shifted(speed, 1), shifted(12, 2), aircraft());
        for (std::size_t i = 0; i < complex.size(); ++i) {
          CHECK_NEAR(dual[i].d.get(direction), complex[i].imag() / step, 1e-11);
          CHECK_EQ(dual[i].v, plain[i]);
        }
      }
    }
}

// The same noise, bit for bit, through filters of 24 bits.
TEST(turbulence_in_single_precision) {
  const auto narrow = approach(40.0f, 60.0f, 12.0f, tiltrotor::aircraft_data<float>());
  const auto wide = approach(40.0, 60.0, 12.0, aircraft());
  for (std::size_t i = 0; i < wide.size(); ++i) CHECK_NEAR(narrow[i], wide[i], 2e-5);
  for (std::uint64_t k = 0; k < 100; ++k)
    CHECK_EQ(tiltrotor::gust_noise<float>(3, k).series[1].y, tiltrotor::gust_noise<double>(3, k).series[1].y);
}

// Names are unlike.
TEST(turbulence_names_its_states) {
  std::vector<std::string> names;
  State state{};
  State::describe(state, [&](double&, const char* name) { names.emplace_back(name); });
  std::sort(names.begin(), names.end());
  CHECK_EQ(names.size(), static_cast<std::size_t>(State::kCount));
  CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
}

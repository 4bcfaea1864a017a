// The filters of turbulence are linear: what they answer to one unit of noise in each channel says everything about
// their statistics. Sums of products of these answers are the covariances, without chance.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/systems/turbulence.hpp"

namespace turbulence_response {

using Air = tiltrotor::TurbulentAir<double>;
using State = tiltrotor::TurbulenceState<double>;
using Noise = tiltrotor::GustNoise<double>;

constexpr double kFoot = 0.3048;
constexpr double kPi = 3.14159265358979323846;

inline const tiltrotor::Aircraft<double>& aircraft() { return tiltrotor::aircraft_data<double>(); }

enum Place { right_rotor, left_rotor, wing, tail };
// Place and component of a gust: u of the wing is Output{wing, 0}.
struct Output {
  int place, component;
};

inline std::array<double, 12> all(const tiltrotor::LocalGusts<double>& g) {
  std::array<double, 12> list{};
  std::size_t n = 0;
  for (const auto* at : {&g.rotor[0], &g.rotor[1], &g.wing, &g.tail})
    for (const double x : {at->x, at->y, at->z}) list[n++] = x;
  return list;
}

constexpr int kChannels = 6;
inline Noise unit_noise(int channel) {
  Noise noise{};
  auto& series = noise.series[channel / 3];
  (channel % 3 == 0 ? series.x : channel % 3 == 1 ? series.y : series.z) = 1;
  return noise;
}

class Response {
 public:
  Response(const Air& air, double dt, double duration) : dt_(dt) {
    for (int channel = 0; channel < kChannels; ++channel) {
      State state{};
      Noise noise = unit_noise(channel);
      for (double t = 0; t < duration; t += dt) {
        state = tiltrotor::turbulence_step(state, air, dt, noise, aircraft());
        noise = Noise{};
        answers_[static_cast<std::size_t>(channel)].push_back(all(gusts_at(state, air, aircraft())));
      }
    }
  }

  // E[a(t + lag steps) b(t)], m^2/s^2.
  double covariance(Output a, Output b, int lag = 0) const {
    double sum = 0;
    for (const auto& answer : answers_)
      for (std::size_t k = 0; k + static_cast<std::size_t>(lag) < answer.size(); ++k)
        sum += answer[k + static_cast<std::size_t>(lag)][index(a)] * answer[k][index(b)];
    return sum;
  }
  double variance(Output a) const { return covariance(a, a); }

  // Of each pair, one-sided, per rad/s: its integral from 0 on is the covariance.
  std::complex<double> spectrum(Output a, Output b, double frequency) const {
    std::complex<double> sum = 0;
    for (const auto& answer : answers_) {
      std::complex<double> at_a = 0;
      std::complex<double> at_b = 0;
      for (std::size_t k = 0; k < answer.size(); ++k) {
        const auto turn = std::polar(1.0, -frequency * dt_ * static_cast<double>(k));
        at_a += answer[k][index(a)] * turn;
        at_b += answer[k][index(b)] * turn;
      }
      sum += at_a * std::conj(at_b);
    }
    return sum * dt_ / kPi;
  }

 private:
  static std::size_t index(Output o) { return static_cast<std::size_t>(3 * o.place + o.component); }
  double dt_;
  std::array<std::vector<std::array<double, 12>>, kChannels> answers_;
};

// MIL-F-8785C section 3.7 below 1000 ft as it is printed, height in ft, wind at 20 ft in m/s: scale in ft, intensity
// in m/s.
struct LowLaw {
  double level_scale, vertical_scale, level_intensity, vertical_intensity;
};
inline LowLaw low_law(double height_ft, double wind) {
  const double bracket = 0.177 + 0.000823 * height_ft;
  const double vertical = 0.1 * wind;
  return {height_ft / std::pow(bracket, 1.2), height_ft, vertical / std::pow(bracket, 0.4), vertical};
}

}  // namespace turbulence_response

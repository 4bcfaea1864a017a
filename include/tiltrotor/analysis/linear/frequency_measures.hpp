// What a frequency response is judged by: bandwidth and phase delay (ADS-33E-PRF), gain and phase margins.
#pragma once

#include "tiltrotor/math/algebra/transfer_function.hpp"

namespace tiltrotor {

// rad/s, between which crossings are looked for, in steps of 1/120 decade.
template <class R>
inline constexpr R kSlowest = R(0.01);
template <class R>
inline constexpr R kFastest = R(1000);
inline constexpr int kStepsPerDecade = 120;
inline constexpr int kCrossingSteps = kStepsPerDecade * 5;

// NaN: there is none. Of the response of an attitude to an inceptor.
template <class R>
struct Bandwidth {
  R omega_180;  // at which the attitude is half a turn late, rad/s
  R by_phase;   // with 45 deg left to it, rad/s
  R by_gain;    // with 6 dB left to it, rad/s
  R rate_command;  // the smaller of both, where both are: rate response types; by_phase is that of attitude response types
  R phase_delay;  // s
};

// NaN: there is none. Of the loop u = -gain y.
template <class R>
struct Margins {
  R gain;             // factor on the gain that makes it unstable, the nearest to 1
  R omega_gain;       // where, rad/s
  R phase;            // rad, the smallest in magnitude
  R omega_phase;      // where, rad/s
  R delay;            // the shortest that makes a stable loop unstable, s; of an unstable one there is none
  int unstable_open;  // poles of the open loop with a real part above zero
  int unstable_closed;
};

namespace measures_detail {

// Calls visit(omega, value, phase) from the slowest to the fastest frequency until it returns false.
template <class R, int N, class Visit>
void scan(const TransferFunction<R, N>& f, ResponseWorkspace<R, N>& work, Visit&& visit) {
  for (int k = 0; k <= kCrossingSteps; ++k) {
    const R omega = kSlowest<R> * std::pow(R(10), static_cast<R>(k) / static_cast<R>(kStepsPerDecade));
    const std::complex<R> value = response(f, {R(0), omega}, work);
    if (!visit(omega, value, continuous_phase(f, omega, value))) return;
  }
}

// Where a function of (omega, value, phase) passes through zero between two frequencies at which its signs differ.
template <class R, int N, class Of>
R crossing(const TransferFunction<R, N>& f, R low, R high, ResponseWorkspace<R, N>& work, Of&& of) {
  const auto at = [&](R omega) {
    const std::complex<R> value = response(f, {R(0), omega}, work);
    return of(value, continuous_phase(f, omega, value));
  };
  const bool negative_low = at(low) < R(0);
  for (int step = 0; step < std::numeric_limits<R>::digits; ++step) {
    const R middle = R(0.5) * (low + high);
    ((at(middle) < R(0)) == negative_low ? low : high) = middle;
  }
  return R(0.5) * (low + high);
}

template <class R>
R half_turns(R phase) {  // the odd number of them at or below
  return std::floor((phase / kPi<R> - R(1)) / R(2)) * R(2) + R(1);
}

}  // namespace measures_detail

// Bandwidth and phase delay of an attitude, ADS-33E-PRF 3.3.2.1. The sign of the input is that to which the attitude
// follows within a second: that of y/u at s = 1 rad/s, or beyond the fastest growth. omega_180 is the first frequency
// at which the phase falls through half a turn. Cost: 700 responses.
template <class R, int N>
Bandwidth<R> bandwidth(const TransferFunction<R, N>& f, ResponseWorkspace<R, N>& work) {
  namespace d = measures_detail;
  const R nan = std::numeric_limits<R>::quiet_NaN();
  Bandwidth<R> out{nan, nan, nan, nan, nan};
  if (f.gain == R(0)) return out;
  R sigma = R(1);
  for (int k = 0; k < f.poles.size; ++k) sigma = larger_of(sigma, R(2) * f.poles.real[k]);
  const R turn = response(f, {sigma, R(0)}, work).real() < R(0) ? kPi<R> : R(0);

  R before = R(0), phase_before = R(0), half_turn = R(0);
  d::scan(f, work, [&](R omega, std::complex<R>, R phase) {
    phase += turn;
    const R level = d::half_turns(phase_before) * kPi<R>;
    const bool falls = before > R(0) && phase < level;
    if (falls) {
      half_turn = level;
      out.omega_180 =
          d::crossing(f, before, omega, work, [&](std::complex<R>, R at) { return at + turn - half_turn; });
    }
    before = omega;
    phase_before = phase;
    return !falls;
  });
  if (!(out.omega_180 > R(0))) return out;
  const R least_gain = R(2) * std::abs(response(f, {R(0), out.omega_180}, work));
  const R late = half_turn + kPi<R> / R(4);
  // The last frequencies before it: of 45 deg and of twice the gain.
  R last = R(0), phase_last = R(0), gain_last = R(0);
  const auto look = [&](R omega, std::complex<R> value, R phase) {
    phase += turn;
    const R gain = std::abs(value);
    if (last > R(0) && (phase < late) != (phase_last < late))
      out.by_phase =
          d::crossing(f, last, omega, work, [&](std::complex<R>, R at) { return at + turn - late; });
    if (last > R(0) && (gain < least_gain) != (gain_last < least_gain))
      out.by_gain =
          d::crossing(f, last, omega, work, [&](std::complex<R> at, R) { return std::abs(at) - least_gain; });
    last = omega;
    phase_last = phase;
    gain_last = gain;
  };
  d::scan(f, work, [&](R omega, std::complex<R> value, R phase) {
    if (omega < out.omega_180) look(omega, value, phase);
    return omega < out.omega_180;
  });
  const std::complex<R> end = response(f, {R(0), out.omega_180}, work);
  look(out.omega_180, end, continuous_phase(f, out.omega_180, end));
  const bool both = is_finite(out.by_phase) && is_finite(out.by_gain);
  out.rate_command = !both ? nan : out.by_phase < out.by_gain ? out.by_phase : out.by_gain;
  const R twice = R(2) * out.omega_180;
  const R beyond = continuous_phase(f, twice, response(f, {R(0), twice}, work)) + turn;
  out.phase_delay = (half_turn - beyond) / twice;
  return out;
}

// Margins of the loop that u = -gain y closes around y/u. Stability is counted from the roots of the closed loop, so that
// a margin of an unstable loop is not mistaken. Status: those of eigenvalues(). Cost: 700 responses.
template <class R, int N>
Status margins(const Channel<R, N>& channel, const TransferFunction<R, N>& f, R gain,
               TransferFunctionWorkspace<R, N>& roots, ResponseWorkspace<R, N>& work, Margins<R>& out) {
  namespace d = measures_detail;
  const R nan = std::numeric_limits<R>::quiet_NaN();
  out = {nan, nan, nan, nan, nan, 0, 0};
  const int n = channel.states;
  for (int k = 0; k < f.poles.size; ++k) out.unstable_open += f.poles.real[k] > R(0);
  const R feedback = gain / (R(1) + gain * channel.d);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      roots.balanced.a(i, j) = channel.a(i, j) - channel.b[i] * feedback * channel.c[j];
  if (n > 0) {
    const Status status = eigenvalues(roots.balanced.a, n, roots.eigen, roots.closed);
    if (status != Status::ok) return status;
    for (int k = 0; k < n; ++k) out.unstable_closed += roots.closed.real[k] > R(0);
  }
  const R size = std::fabs(gain), turn = gain < R(0) ? kPi<R> : R(0);
  if (size == R(0) || f.gain == R(0)) return Status::ok;
  const auto offer_gain = [&](R omega, R factor) {
    const R distance = std::fabs(std::log(factor));
    if (!(distance < std::fabs(std::log(out.gain)))) return;
    out.gain = factor;
    out.omega_gain = omega;
  };
  const auto offer_phase = [&](R omega, R phase) {
    const R left = nearest_turn(phase + kPi<R>, R(0));
    const R delay = (left < R(0) ? left + R(2) * kPi<R> : left) / omega;
    if (delay < out.delay) out.delay = delay;
    if (std::fabs(left) >= std::fabs(out.phase)) return;
    out.phase = left;
    out.omega_phase = omega;
  };
  out.gain = out.phase = out.delay = std::numeric_limits<R>::infinity();
  // A loop that answers at once with the whole input or more bears no delay at all.
  if (size * std::fabs(channel.d) >= R(1)) out.delay = R(0);
  const R steady = gain * response(f, {R(0), R(0)}, work).real();
  if (steady < R(0)) offer_gain(R(0), R(-1) / steady);
  R last = R(0), phase_last = R(0), size_last = R(0);
  d::scan(f, work, [&](R omega, std::complex<R> value, R phase) {
    phase += turn;
    const R loop = size * std::abs(value);
    if (last > R(0)) {
      const R upper = d::half_turns(larger_of(phase, phase_last)) * kPi<R>;
      if ((phase < upper) != (phase_last < upper)) {
        const R at =
            d::crossing(f, last, omega, work, [&](std::complex<R>, R there) { return there + turn - upper; });
        offer_gain(at, R(1) / (size * std::abs(response(f, {R(0), at}, work))));
      }
      if ((loop < R(1)) != (size_last < R(1))) {
        const R at = d::crossing(f, last, omega, work,
                                 [&](std::complex<R> there, R) { return size * std::abs(there) - R(1); });
        offer_phase(at, continuous_phase(f, at, response(f, {R(0), at}, work)) + turn);
      }
    }
    last = omega;
    phase_last = phase;
    size_last = loop;
    return true;
  });
  if (!is_finite(out.gain)) out.gain = nan;
  if (!is_finite(out.phase)) out.phase = nan;
  if (!is_finite(out.delay) || out.unstable_closed > 0) out.delay = nan;
  return Status::ok;
}

}  // namespace tiltrotor

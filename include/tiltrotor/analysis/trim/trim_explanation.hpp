// One sentence that explains how a trim ended.
#pragma once

#include "tiltrotor/analysis/trim/trim.hpp"
#include "tiltrotor/math/sentence.hpp"

namespace tiltrotor {

namespace trim_explanation_detail {

inline constexpr const char* kFieldWords[] = {
    "configuration or options",
    "speed must be 0..",
    "climb angle must be within 90 deg, and 0 at speed 0 (below 1e-15 m/s)",
    "turn rate must be within 60 deg/s",
    "sideslip must be within 60 deg, and 0 at speed 0 (below 1e-15 m/s) and climb +-90 deg",
    "gust must be within "};
static_assert(sizeof(kFieldWords) / sizeof(kFieldWords[0]) ==
                  static_cast<unsigned>(SteadyFlightField::gust) + 1,
              "one text per SteadyFlightField");

// "speed must be 0..150 m/s"
template <class R>
void write_field(const TrimResult<R>& r, Sentence& sentence) {
  sentence << kFieldWords[static_cast<unsigned>(r.invalid)];
  if (r.invalid == SteadyFlightField::speed) sentence.number(static_cast<double>(r.largest_speed)) << " m/s";
  if (r.invalid == SteadyFlightField::gust) sentence.number(static_cast<double>(r.largest_gust)) << " m/s";
}

// "wing angle of attack 17.20 deg". The longitudinal stick is counted as trim prints it: 0 at its rear stop,
// 4.8 in neutral, 9.6 at its front stop.
template <class R>
void write_value(const LimitName& limit, R value, int decimals, Sentence& sentence) {
  sentence << limit.name << " ";
  sentence.fixed(limit.factor * static_cast<double>(value), decimals) << " " << limit.unit;
}

// "wing angle of attack 17.20 deg is beyond 16.00 deg, also elevator 20.50 deg, power 2400.00 kW": every
// limit that is exceeded, or how many more where the text ends; in digits that tell the value from its bound.
template <class R>
void write_limits(const LimitCheck<R>& check, Sentence& sentence) {
  const auto shown = [](const LimitExcess<R>& excess, R value) {
    return excess.limit == TrimLimit::long_stick ? value + std::fabs(excess.bound) : value;
  };
  const auto decimals = [&shown](const LimitName& limit, const LimitExcess<R>& excess) {
    return Sentence::decimals_apart(limit.factor * static_cast<double>(shown(excess, excess.value)),
                                    limit.factor * static_cast<double>(shown(excess, excess.bound)));
  };
  const LimitExcess<R>& first = check.exceeded[0];
  const LimitName& limit = limit_name(first.limit);
  const int digits = decimals(limit, first);
  write_value(limit, shown(first, first.value), digits, sentence);
  sentence << " is beyond " << limit.rating;
  sentence.fixed(limit.factor * static_cast<double>(shown(first, first.bound)), digits) << " " << limit.unit;
  for (int k = 1; k < check.count; ++k) {
    const int longest = 48;  // of one more, and the count of those that follow
    if (sentence.left() < longest) {
      sentence << ", " << check.count - k << " more";
      return;
    }
    sentence << (k == 1 ? ", also " : ", ");
    const LimitExcess<R>& more = check.exceeded[k];
    const LimitName& other = limit_name(more.limit);
    write_value(other, shown(more, more.value), decimals(other, more), sentence);
  }
}

}  // namespace trim_explanation_detail

// Writes at most capacity - 1 characters and a terminating zero; returns the length. 160 characters are
// enough but for a long list of limits, which then ends in their number.
template <class R>
int explain(const TrimResult<R>& r, char* text, int capacity) {
  Sentence sentence(text, capacity);
  switch (r.status) {
    case TrimStatus::ok:
      sentence << "trimmed in " << r.iterations << " Newton steps";
      break;
    case TrimStatus::wing_stall:
    case TrimStatus::control_limit:
    case TrimStatus::flap_limit:
    case TrimStatus::vortex_ring:
    case TrimStatus::power_limit:
    case TrimStatus::torque_limit:
      sentence << "trimmed, but ";
      trim_explanation_detail::write_limits(r.limits, sentence);
      break;
    case TrimStatus::rotor_stall:
      sentence << "no trim: the aircraft carries at most ";
      // Rounded down: less than all of it.
      sentence.fixed(std::floor(10000 * static_cast<double>(r.weight_carried)) / 100)
          << " % of its weight before its rotors stall";
      break;
    case TrimStatus::not_converged:
    case TrimStatus::singular:
      if (r.obstacle == TrimObstacle::upside_down) {
        sentence << "no trim found but with the aircraft on its back or past the vertical: roll ";
        sentence.fixed(static_cast<double>(r.state.roll) * kDegPerRad<double>) << " deg, pitch ";
        sentence.fixed(static_cast<double>(r.state.pitch) * kDegPerRad<double>) << " deg";
        break;
      }
      if (r.obstacle == TrimObstacle::attitude) {
        sentence << "no trim found: climb, turn and sideslip leave no attitude that balances the forces; "
                    "scaled residual ";
        sentence.scientific(static_cast<double>(r.residual))
            << " left in the rate of " << kStateVariables[r.residual_state].name;
        break;
      }
      sentence << "no trim found in " << r.iterations << " Newton steps: scaled residual ";
      sentence.scientific(static_cast<double>(r.residual))
          << " left in the rate of " << kStateVariables[r.residual_state].name;
      if (r.limits.count > 0) {
        sentence << "; at the last point ";
        trim_explanation_detail::write_limits(r.limits, sentence);
      }
      break;
    case TrimStatus::not_finite:
      if (r.invalid != SteadyFlightField::none) {
        sentence << "bad input, not a finite number: ";
        trim_explanation_detail::write_field(r, sentence);
        break;
      }
      sentence << "the rate of " << kStateVariables[r.residual_state].name
               << " is not a number at the first guess";
      break;
    case TrimStatus::out_of_range:
    case TrimStatus::count:
      sentence << "bad input: ";
      trim_explanation_detail::write_field(r, sentence);
      break;
  }
  return sentence.length();
}

}  // namespace tiltrotor

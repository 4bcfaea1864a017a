// Random missions through the C interface: the whole aircraft with its systems, in wind, gusts and turbulence, flown by a
// pilot who holds attitude badly or not at all, with failures on the way. The contract under test: a frame is flown to a
// finite state, or refused with a status, the time and the state that left its range, and then nothing has moved.
#pragma once

#include "properties/envelope.hpp"

namespace envelope {

struct MissionCounts {
  long flown = 0, in_the_air = 0, on_wheels = 0, struck = 0, lost = 0, no_trim = 0;
  long engines_out = 0, scas_off = 0, conversions = 0, gear = 0, governors = 0, gusts = 0;
  long linear_models = 0, ungoverned = 0;
  double frames = 0;
  std::map<std::string, long> left_by;  // state that left its range
  std::vector<double> times;            // of loss, s
  std::string example;
};

class Mission {
 public:
  Mission(std::uint64_t index, MissionCounts& counts, Breaches& breaches)
      : random_(104729 * index + 29),
        counts_(counts),
        breaches_(breaches),
        where_("mission " + std::to_string(index)) {}

  void fly(double duration) {
    if (!begin()) return expect(false, "fifty conditions without a trim");
    ++counts_.flown;
    const double lengths[] = {0.005, 0.01, 0.02};
    const double dt = lengths[random_.below(3)];
    const long frames = std::lround(duration / dt);
    double next_change = 0;
    for (long k = 0; k < frames; ++k) {
      if (static_cast<double>(k) * dt >= next_change) {
        change();
        next_change += random_.between(0.3, 3);
      }
      move_controls();
      if (!step(static_cast<tr_real>(dt))) return;
      ++counts_.frames;
      if (state_.x[TR_DOWN] > ground_ + 3) {
        ++counts_.struck;
        return;
      }
      if (k % 499 == 0) read();
    }
    std::uint32_t flags = 0;
    expect(tr_get_flags(&sim_, &flags) == TR_OK, "no flags at the end");
    ++((flags & TR_ON_GROUND) != 0 ? counts_.on_wheels : counts_.in_the_air);
  }

 private:
  void expect(bool kept, const std::string& what) { breaches_.expect(kept, where_ + ": " + what); }

  // In a steady flight, systems on at random.
  bool begin() {
    piloted_ = random_.chance(0.7);
    for (int attempt = 0; attempt < 50; ++attempt) {
      const double masts[] = {0, 0, 90, random_.between(0, 90)};
      tr_setup setup;
      const double mast = masts[random_.below(4)];
      tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0), static_cast<tr_real>(mast));
      setup.grid = TR_GRID_REALTIME;
      setup.coning_states = random_.below(2);
      expect(tr_init(&sim_, TR_API_VERSION, &setup) == TR_OK, "no aircraft");
      tr_environment& air = air_;
      tr_default_environment(&air);
      for (int k = 0; k < 2; ++k) air.wind_mps[k] = random_.between(-10, 10);
      air.altitude_origin_m = random_.between(0, 2000);
      air.temperature_offset_k = random_.between(-20, 20);
      ground_ = air.ground_down_m = random_.chance(0.5) ? random_.between(4, 30) : random_.between(30, 1000);
      expect(tr_set_environment(&sim_, &air) == TR_OK, "no air");
      tr_systems systems;
      tr_get_systems(&sim_, &systems);
      std::int32_t* const on[] = {&systems.conversion, &systems.engines,     &systems.actuators,
                                  &systems.scas,       &systems.gear,        &systems.ground_effect,
                                  &systems.turbulence, &systems.interconnect};
      for (std::int32_t* const one : on) *one = random_.chance(0.8) ? 1 : 0;
      systems.governor = random_.below(3);
      systems.wind_shear = random_.below(3);
      systems.turbulence_seed = static_cast<std::uint64_t>(random_.between(0, 1e9));
      systems.turbulence_w20_mps = random_.between(0, 23);
      expect(tr_set_systems(&sim_, &systems) == TR_OK, "no systems");
      const double share = mast / 90;
      const tr_flight flight = {static_cast<tr_real>(random_.between(60 * share, 45 + 75 * share)),
                                random_.between(-0.1, 0.1), random_.between(-0.1, 0.1), 0};
      const tr_status trimmed = tr_trim(&sim_, &work_, &flight, nullptr);
      expect(trimmed >= TR_OK && trimmed < TR_STATUS_COUNT, "unknown status of a trim");
      if (trimmed == TR_OK) {
        expect(tr_get_state(&sim_, &wanted_) == TR_OK && tr_get_systems(&sim_, &systems) == TR_OK,
               "no state");
        state_ = wanted_;
        governor_ = systems.governor;
        throttle_ = systems.throttle[0];
        std::copy(wanted_.u, wanted_.u + TR_CONTROLS, disturbed_);
        return true;
      }
      ++counts_.no_trim;
    }
    return false;
  }

  // What pilot, weather and fate do next.
  void change() {
    const double size = piloted_ ? 0.3 : random_.between(0, 1.2);
    const double most[TR_CONTROLS] = {0.1, 3, 3, 2, 0.05};
    for (int j = 0; j < TR_CONTROLS; ++j)
      disturbed_[j] = wanted_.u[j] + static_cast<tr_real>(size * most[j] * random_.between(-1, 1));
    tr_systems systems;
    expect(tr_get_systems(&sim_, &systems) == TR_OK, "no systems");
    const bool moves = random_.chance(0.3);
    counts_.conversions += moves;
    // As the speed allows, as a rule.
    const double slow = std::max(0.0, std::min(1.0, (state_.x[TR_U] - 30) / 40));
    if (moves)
      systems.mast_command_deg =
          random_.chance(0.9) ? 90 * slow * random_.between(0.5, 1) : random_.between(0, 90);
    if (random_.chance(0.2)) systems.flap_command_deg = random_.between(0, 75);
    for (const int k : {0, 1})
      systems.throttle[k] =
          piloted_ ? std::max(0.0, std::min(1.2, throttle_ + 0.1 * sink() + random_.between(-0.1, 0.1)))
          : random_.chance(0.2) ? random_.between(0, 1.2)
                                : systems.throttle[k];
    if (random_.chance(0.05)) systems.rotor_command_radps = random_.between(50, 65);
    const bool fails = random_.chance(0.03);
    counts_.engines_out += fails;
    if (fails) systems.engine_failed[random_.below(2)] = 1;
    const bool switched = random_.chance(0.1);
    counts_.scas_off += switched && systems.scas == 1;
    if (switched) systems.scas = 1 - systems.scas;
    const bool gear = random_.chance(0.1);
    counts_.gear += gear;
    if (gear) systems.gear_down = 1 - systems.gear_down;
    for (tr_real& brake : systems.brake) brake = random_.between(0, 1);
    const bool governed = random_.chance(0.03);
    counts_.governors += governed;
    if (governed) systems.governor = random_.below(3);
    if (random_.chance(0.03)) systems.actuators = 1 - systems.actuators;
    if (random_.chance(0.03)) systems.conversion = 1 - systems.conversion;
    governor_ = systems.governor;
    const tr_sim before = sim_;
    const tr_status set = tr_set_systems(&sim_, &systems);
    // Systems that are switched while a state is beyond what the next one takes.
    if (set != TR_OK)
      expect(set == TR_OUT_OF_RANGE && capi::same_but_for_the_fault(sim_, before),
             "systems: refused with traces");
    const bool gusty = random_.chance(0.3);
    counts_.gusts += gusty;
    if (!gusty) return;
    for (auto& place : air_.gust_mps)
      for (tr_real& speed : place) speed = random_.between(-8, 8);
    for (tr_real& rate : air_.gust_rates_radps) rate = random_.between(-0.1, 0.1);
    expect(tr_set_environment(&sim_, &air_) == TR_OK, "no gust");
  }

  void move_controls() {
    tr_real u[TR_CONTROLS];
    std::copy(disturbed_, disturbed_ + TR_CONTROLS, u);
    if (piloted_) {
      const tr_real* const x = state_.x;
      u[TR_LONG_STICK] += 12 * (x[TR_PITCH] - wanted_.x[TR_PITCH]) + 6 * x[TR_Q];
      u[TR_LAT_STICK] -= 8 * (x[TR_ROLL] - wanted_.x[TR_ROLL]) + 4 * x[TR_P];
      u[TR_PEDAL] -= 6 * x[TR_R];
      if (governor_ == TR_GOVERNOR_OFF) u[TR_COLLECTIVE] += tr_real(0.01) * sink();
    }
    std::uint32_t clipped = 0;
    expect(tr_saturate_controls(&sim_, u, TR_CONTROLS, &clipped) == TR_OK, "controls refused");
  }

  // m/s, limited.
  tr_real sink() const {
    const tr_real* const x = state_.x;
    const tr_real down =
        x[TR_W] * std::cos(x[TR_PITCH]) * std::cos(x[TR_ROLL]) - x[TR_U] * std::sin(x[TR_PITCH]);
    return std::max(tr_real(-5), std::min(tr_real(5), down));
  }

  // False: control is lost, and it was reported.
  bool step(tr_real dt) {
    const tr_sim before = sim_;
    tr_outputs outputs;
    const bool measured = random_.chance(0.1);
    const tr_status status =
        measured ? tr_step_with_outputs(&sim_, &work_, dt, &outputs) : tr_step(&sim_, &work_, dt);
    tr_state& state = state_;
    expect(tr_get_state(&sim_, &state) == TR_OK && finite(state.x, TR_STATES), "no number in a state");
    if (status == TR_OK) {
      tr_sim copy = sim_;
      if (random_.chance(0.01))
        expect(tr_set_state(&copy, &state) == TR_OK, "a state out of range passed for good");
      return true;
    }
    tr_fault fault;
    expect(status == TR_OUT_OF_RANGE || status == TR_NOT_FINITE, "unknown status " + std::to_string(status));
    expect(capi::same_but_for_the_fault(sim_, before), "a failed step left traces");
    expect(tr_last_fault(&sim_, &fault) == TR_OK && fault.status == status && fault.time_s == state.time_s,
           "lost without its time");
    expect(fault.state >= 0 && fault.state < TR_STATES, "lost without the name of a state");
    expect(tr_step(&sim_, &work_, dt) == status, "a lost aircraft flew on");
    ++counts_.lost;
    ++counts_.left_by[tr_state_name(fault.state)];
    counts_.times.push_back(fault.time_s);
    if (counts_.example.empty())
      counts_.example = where_ + ", " + tr_state_name(fault.state) + ": " + tr_status_word(status);
    return false;
  }

  // What may be asked at any moment.
  void read() {
    tr_real rates[TR_STATES];
    tr_outputs outputs;
    const tr_status derived = tr_derivative(&sim_, rates, TR_STATES);
    expect((derived == TR_OK) == finite(rates, TR_STATES), "status and rates disagree");
    expect(derived != TR_OK || tr_get_outputs(&sim_, &outputs) == TR_OK, "finite rates without outputs");
    constexpr std::size_t square = TR_MAX_LINEAR_STATES * TR_MAX_LINEAR_STATES;
    static tr_real a[square], b[TR_MAX_LINEAR_STATES * TR_INPUTS];
    static tr_real c[TR_OUTPUTS * TR_MAX_LINEAR_STATES], d[TR_OUTPUTS * TR_INPUTS];
    tr_linear_shape shape;
    const tr_status linear =
        tr_linearize(&sim_, &work_, TR_ALL_INPUTS, &shape, a, square, b, sizeof b / sizeof *b);
    const tr_status read =
        tr_linearize_outputs(&sim_, &work_, TR_ALL_INPUTS, c, sizeof c / sizeof *c, d, sizeof d / sizeof *d);
    const auto n = static_cast<std::size_t>(shape.states), m = static_cast<std::size_t>(shape.controls);
    expect(linear == TR_OK || linear == TR_NOT_CONVERGED || linear == TR_NOT_FINITE,
           "unknown status of A and B");
    expect(linear != TR_OK || (finite(a, n * n) && finite(b, n * m)), "A and B are not numbers");
    expect((read == TR_OK) == (linear == TR_OK), "A, B and C, D disagree");
    expect(read != TR_OK || (finite(c, TR_OUTPUTS * n) && finite(d, TR_OUTPUTS * m)),
           "C and D are not numbers");
    ++(linear == TR_OK ? counts_.linear_models : counts_.ungoverned);
    tr_real dx[TR_STATES] = {}, du[TR_INPUTS] = {};
    const int along = random_.below(TR_STATES + TR_INPUTS);
    (along < TR_STATES ? dx[along] : du[along - TR_STATES]) = 1;
    const tr_status direction = tr_directional_inputs(&sim_, &work_, dx, du, rates, &outputs);
    expect((direction == TR_OK) == (read == TR_OK), "a direction and C, D disagree");
    expect(direction != TR_OK || finite(rates, TR_STATES), "a direction is no number");
  }

  Generator random_;
  MissionCounts& counts_;
  Breaches& breaches_;
  std::string where_;
  bool piloted_ = false;
  double ground_ = 0;
  tr_sim sim_{};
  tr_environment air_{};
  tr_state wanted_{}, state_{};
  std::int32_t governor_ = 0;
  double throttle_ = 0;
  tr_real disturbed_[TR_CONTROLS] = {};
  static inline tr_work work_;
};

inline void print(const MissionCounts& counts, double duration) {
  std::printf(
      "missions flown %ld: in the air after %g s %ld, on their wheels %ld, struck the ground %ld, lost and reported %ld; "
      "%.0f frames; conditions drawn without a trim %ld\n",
      counts.flown, duration, counts.in_the_air, counts.on_wheels, counts.struck, counts.lost, counts.frames,
      counts.no_trim);
  std::printf(
      "  on the way: masts %ld, engines out %ld, SCAS off %ld, gear %ld, governors %ld, gusts %ld; linear models %ld, "
      "ideal governors without a collective %ld\n",
      counts.conversions, counts.engines_out, counts.scas_off, counts.gear, counts.governors, counts.gusts,
      counts.linear_models, counts.ungoverned);
  std::printf("left their range by:");
  for (const auto& [name, count] : counts.left_by) std::printf("  %s %ld", name.c_str(), count);
  std::vector<double> times = counts.times;
  std::sort(times.begin(), times.end());
  if (!times.empty())
    std::printf("\nafter %.2f s at the earliest, %.2f s in the median; first: %s", times.front(),
                times[times.size() / 2], counts.example.c_str());
  std::printf("\n");
}

}  // namespace envelope

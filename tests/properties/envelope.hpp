// Random states and random flights, far past what an aircraft survives. The contract under test: whatever the
// numbers, the library refuses them, or returns finite results, or says that they are not finite; a flight
// that diverges stops with the time and the state that left its range.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "capi/same_aircraft.hpp"
#include "tiltrotor/analysis/instances.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/tiltrotor.h"

namespace envelope {

using namespace tiltrotor;

class Generator {
 public:
  explicit Generator(std::uint64_t seed) : engine_(seed) {}
  double between(double low, double high) { return low + (high - low) * unit_(engine_); }
  bool chance(double probability) { return unit_(engine_) < probability; }
  int below(int count) { return std::min(static_cast<int>(between(0, count)), count - 1); }

 private:
  std::mt19937_64 engine_;
  std::uniform_real_distribution<double> unit_{0, 1};
};

/// What is wrong, with enough to repeat it; empty when the contract was kept.
struct Breaches {
  std::vector<std::string> text;
  void expect(bool kept, const std::string& what) {
    if (!kept) text.push_back(what);
  }
};

inline bool finite(const double* x, std::size_t count) {
  return std::all_of(x, x + count, [](double a) { return std::isfinite(a); });
}

// ---- states ----

enum Corner {
  anywhere,
  vortex_ring,
  reverse_flow,
  sideways,
  inverted,
  at_the_edges,
  beyond,
  not_a_number,
  corner_count
};
inline constexpr const char* kCornerNames[corner_count] = {"anywhere", "vortex_ring", "reverse_flow",
                                                           "sideways", "inverted",    "at_the_edges",
                                                           "beyond",   "not_a_number"};

struct StateCounts {
  long tried[corner_count] = {}, finite[corner_count] = {}, refused[corner_count] = {},
       not_finite[corner_count] = {};
  long steps = 0, stopped = 0, linear_models = 0, setups = 0, setups_refused = 0;
};

/// A setup; one in eight is wrong in one number, from where the air has no density to NaN.
inline tr_setup random_setup(Generator& random, bool& valid) {
  tr_setup setup;
  const double masts[] = {0, 90, random.between(0, 90)};
  valid = tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0), masts[random.below(3)]) == TR_OK;
  setup.grid = random.chance(0.8) ? TR_GRID_REALTIME : TR_GRID_SPECIFICATION;
  setup.tables = random.chance(0.5) ? TR_TABLES_SMOOTH : TR_TABLES_LINEAR;
  setup.coning_states = random.below(2);
  const auto inside = [&random](const Bounds<double>& range) {
    return random.between(range.low, range.high);
  };
  const LimitTables<double>& limits = aircraft_data<double>().limits;
  setup.flap_deg = inside(limits.flap_deg);
  setup.altitude_m = inside(limits.altitude);
  setup.mass_kg = inside(limits.mass);
  setup.rotor_radps = inside(limits.rotor_speed);
  setup.cg_station_m = inside(limits.sl_cg);
  if (!random.chance(0.125)) return setup;
  valid = false;
  tr_real* const number[] = {&setup.mast_deg, &setup.flap_deg,    &setup.altitude_m,
                             &setup.mass_kg,  &setup.rotor_radps, &setup.cg_station_m};
  // 44330.8 m: where the standard atmosphere's density formula is zero; above it has no real value.
  const double bad[] = {-1e3, 44330.769, 44331, 1e300, -1e300, std::nan(""), HUGE_VAL, -HUGE_VAL};
  *number[random.below(6)] = bad[random.below(8)];
  return setup;
}

inline double bound(int state) { return std::min(state_bound<double>(state), 1e6); }

inline tr_state random_state(Generator& random, Corner corner, double hover_wash) {
  tr_state s{};
  const double edges[] = {0, -0.0, 1e-310, -1e-310, 1e-8, -1e-8, 0.25, -0.25, 1, -1};
  for (int i = 0; i < TR_MAST; ++i) {
    const double share = corner == at_the_edges ? edges[random.below(10)] : random.between(-1, 1);
    // Most flapping and inflow states of the corners are those of a working rotor.
    const bool rotor = i >= TR_ROTOR_RIGHT && i < TR_NORTH;
    s.x[i] = share * bound(i) *
             (corner > anywhere && corner < at_the_edges && rotor && i != TR_DOWNWASH ? 0.05 : 1);
  }
  for (double& u : s.u) u = random.chance(0.2) ? random.between(-100, 100) : random.between(-1, 1);
  s.u[TR_COLLECTIVE] = random.between(-1, 2);
  double* const v = s.x;
  switch (corner) {
    case vortex_ring:  // down at 0 to 2 times the hover wash, slow in the plane of the disk
      v[TR_U] = random.between(-5, 5);
      v[TR_V] = random.between(-5, 5);
      v[TR_W] = random.between(0, 2) * hover_wash;
      break;
    case reverse_flow:  // advance ratios up to 2: most of the retreating blade is flown at from behind
      v[TR_U] = random.between(-300, 300);
      v[TR_V] = random.between(-20, 20);
      v[TR_W] = random.between(-20, 20);
      break;
    case sideways:
      v[TR_U] = random.between(-1, 1);
      v[TR_V] = (random.chance(0.5) ? 1 : -1) * random.between(1, 300);
      v[TR_W] = random.between(-1, 1);
      break;
    case inverted:
      s.x[TR_ROLL] = 3.14159265358979 + random.between(-0.3, 0.3);
      break;
    case beyond: {
      const int i = random.below(TR_NORTH);
      s.x[i] = (random.chance(0.5) ? 1 : -1) * bound(i) * std::pow(10, random.between(0.001, 300));
      if (i == TR_YAW || std::isinf(s.x[i])) s.x[TR_PITCH] = 1.6;
      if (std::isinf(s.x[i])) s.x[i] = 0;
      break;
    }
    case not_a_number: {
      const double bad[] = {std::nan(""), HUGE_VAL, -HUGE_VAL};
      double* const place =
          random.chance(0.7) ? &s.x[random.below(TR_MAST)] : &s.u[random.below(TR_CONTROLS)];
      *place = bad[random.below(3)];
      break;
    }
    default:
      break;
  }
  return s;
}

struct StateTrial {
  tr_state state;
  Corner corner;
  bool linearize_too;
  std::string where;  // seed and number, for a breach
};

inline void try_state(tr_sim& sim, tr_work& work, const StateTrial& trial, StateCounts& counts,
                      Breaches& breaches) {
  const Corner corner = trial.corner;
  const auto expect = [&](bool kept, const char* what) { breaches.expect(kept, trial.where + ": " + what); };
  ++counts.tried[corner];
  const tr_sim before = sim;
  const tr_status set = tr_set_state(&sim, &trial.state);
  if (corner == beyond || corner == not_a_number) {
    expect(set == (corner == beyond ? TR_OUT_OF_RANGE : TR_NOT_FINITE), "accepted");
    expect(capi::same_but_for_the_fault(sim, before), "a refused state left traces");
  }
  if (set != TR_OK) {
    ++counts.refused[corner];
    return;
  }
  tr_real rates[TR_STATES];
  tr_outputs outputs;
  const tr_status derived = tr_derivative(&sim, rates, TR_STATES);
  expect(derived == TR_OK || derived == TR_NOT_FINITE, "unknown status of the derivative");
  expect((derived == TR_OK) == finite(rates, TR_STATES), "status and rates disagree");
  const tr_status read = tr_get_outputs(&sim, &outputs);
  expect(derived != TR_OK || read == TR_OK, "finite rates without outputs");
  ++(derived == TR_OK ? counts.finite : counts.not_finite)[corner];

  const tr_sim here = sim;
  const tr_status stepped = tr_step(&sim, &work, 0.02);
  ++(stepped == TR_OK ? counts.steps : counts.stopped);
  if (stepped == TR_OK) {
    tr_state after;
    expect(tr_get_state(&sim, &after) == TR_OK && finite(after.x, TR_STATES), "a step to nowhere");
    expect(tr_set_state(&sim, &after) == TR_OK, "a step out of range passed for good");
  } else {
    expect(stepped == TR_OUT_OF_RANGE || stepped == TR_NOT_FINITE, "unknown status of a step");
    expect(capi::same_but_for_the_fault(sim, here), "a failed step left traces");
  }
  if (!trial.linearize_too) return;
  constexpr std::size_t capacity = TR_MAX_LINEAR_STATES * TR_MAX_LINEAR_STATES;
  static tr_real a[capacity];
  static tr_real b[TR_MAX_LINEAR_STATES * TR_CONTROLS];
  tr_linear_shape shape;
  const tr_status linear =
      tr_linearize(&here, &work, TR_ALL_CONTROLS, &shape, a, capacity, b, sizeof b / sizeof *b);
  const auto n = static_cast<std::size_t>(shape.states);
  expect((linear == TR_OK) == (finite(a, n * n) && finite(b, n * TR_CONTROLS)),
         "status and linear model disagree");
  ++counts.linear_models;
}

/// `count` states from a seed; a new aircraft every 100.
inline StateCounts try_states(std::uint64_t seed, long count, Breaches& breaches) {
  StateCounts counts;
  const auto work = std::make_unique<tr_work>();
  tr_sim sim{};
  tr_sim bystander{};
  tr_setup setup;
  breaches.expect(tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0), 45) == TR_OK &&
                      tr_init(&bystander, TR_API_VERSION, &setup) == TR_OK,
                  "no bystander");
  const tr_sim bystander_before = bystander;
  for (long first = 0; first < count; first += 100) {
    Generator random(seed + static_cast<std::uint64_t>(first));
    for (bool valid = false; !valid;) {
      setup = random_setup(random, valid);
      const tr_status made = tr_init(&sim, TR_API_VERSION, &setup);
      ++counts.setups;
      if (!valid) ++counts.setups_refused;
      breaches.expect(made == (valid ? TR_OK : TR_OUT_OF_RANGE), "setup: status " + std::to_string(made));
    }
    for (long k = first; k < std::min(first + 100, count); ++k) {
      const auto corner = static_cast<Corner>(k % corner_count);
      const StateTrial trial = {
          random_state(random, corner, 12), corner, k % 211 == 0,
          "seed " + std::to_string(seed) + " state " + std::to_string(k) + " (" + kCornerNames[corner] + ")"};
      try_state(sim, *work, trial, counts, breaches);
    }
  }
  breaches.expect(std::memcmp(&bystander, &bystander_before, sizeof bystander) == 0,
                  "another aircraft was touched");
  return counts;
}

inline void print(const StateCounts& counts) {
  std::printf("%-14s %10s %10s %10s %12s\n", "states", "tried", "finite", "refused", "not finite");
  for (int k = 0; k < corner_count; ++k)
    std::printf("%-14s %10ld %10ld %10ld %12ld\n", kCornerNames[k], counts.tried[k], counts.finite[k],
                counts.refused[k], counts.not_finite[k]);
  std::printf("setups %ld, of which refused %ld; steps done %ld, stopped %ld; linear models %ld\n",
              counts.setups, counts.setups_refused, counts.steps, counts.stopped, counts.linear_models);
}

// ---- flights ----

struct FlightCounts {
  long flown = 0, to_the_end = 0, diverged = 0, no_trim = 0;
  double steps = 0;
  std::map<std::string, long> left_by;  // state that left its range
  std::vector<double> times;            // of divergence, s
  std::string example;
};

/// The trimmed flight of an index: the same on every machine, in whatever shard.
struct RandomFlight {
  Configuration<double> c;
  TrimResult<double> trim;
  bool pilot;  // holds attitude, badly; otherwise the stick moves by itself
};

inline RandomFlight random_flight(Generator& random, FlightCounts& counts) {
  static TrimWorkspace<double> work;
  RandomFlight f;
  f.pilot = random.chance(0.5);
  for (int attempt = 0; attempt < 50; ++attempt) {
    const double masts[] = {0, 0, 90, random.between(0, 90)};
    FlightSetup<double> setup = flight_setup(aircraft_data<double>(), masts[random.below(4)]);
    setup.altitude = random.between(0, 3000);
    setup.options.grid = BladeGrid::realtime;
    setup.options.tables = random.chance(0.5) ? Interpolation::c1 : Interpolation::linear;
    setup.options.position_states = true;
    const double mast = setup.mast_deg / 90;
    SteadyFlight<double> flight = {random.between(60 * mast, 45 + 75 * mast), random.between(-0.15, 0.15),
                                   random.between(-0.15, 0.15), random.between(-0.08, 0.08)};
    if (prepare(aircraft_data<double>(), setup, f.c) == Status::ok &&
        is_trimmed(trim(f.c, flight, work, f.trim)))
      return f;
    ++counts.no_trim;
  }
  f.trim.status = TrimStatus::not_converged;
  return f;
}

inline Controls<double> piloted(const RandomFlight& f, const State<double>& x,
                                const Controls<double>& disturbed) {
  Controls<double> u = disturbed;
  const State<double>& wanted = f.trim.state;
  const auto within = [](double value, double limit) { return std::max(-limit, std::min(limit, value)); };
  u.long_stick = within(u.long_stick + 12 * (x.pitch - wanted.pitch) + 6 * (x.rates.y - wanted.rates.y), 4.8);
  u.lat_stick = within(u.lat_stick - 8 * (x.roll - wanted.roll) - 4 * (x.rates.x - wanted.rates.x), 4.8);
  u.pedal = within(u.pedal - 6 * (x.rates.z - wanted.rates.z), 2.5);
  return u;
}

inline Controls<double> random_controls(Generator& random, const RandomFlight& f) {
  const double size = f.pilot ? 0.3 : random.between(0, 1.5);
  Controls<double> u = f.trim.controls;
  u.collective += 0.1 * size * random.between(-1, 1);
  u.long_stick += 3 * size * random.between(-1, 1);
  u.lat_stick += 3 * size * random.between(-1, 1);
  u.pedal += 2 * size * random.between(-1, 1);
  u.elevator = 0.2 * size * random.between(-1, 1);
  u.lateral_cyclic = 0.05 * size * random.between(-1, 1);
  u.gust = {10 * size * random.between(-1, 1), 10 * size * random.between(-1, 1),
            10 * size * random.between(-1, 1)};
  return u;
}

inline void fly(std::uint64_t index, double duration, FlightCounts& counts, Breaches& breaches) {
  constexpr double dt = 0.0125;  // the longest in one part in every steady flight
  static SimulationWorkspace<double> work;
  Generator random(7919 * index + 17);
  const std::string where = "flight " + std::to_string(index);
  const auto expect = [&](bool kept, const char* what) { breaches.expect(kept, where + ": " + what); };
  const RandomFlight f = random_flight(random, counts);
  if (!is_trimmed(f.trim.status)) return expect(false, "fifty conditions without a trim");

  Simulation<double> s;
  expect(start(f.c, f.trim.state, f.trim.controls, dt, Integrator::rk3, s) == Status::ok, "does not start");
  ++counts.flown;
  Controls<double> disturbed = f.trim.controls;
  double next_change = 0;
  const auto steps = static_cast<unsigned>(std::lround(duration / dt));
  while (s.steps < steps) {
    if (current_time(s) >= next_change) {
      disturbed = random_controls(random, f);
      next_change += random.between(0.3, 3);
    }
    s.controls = f.pilot ? piloted(f, s.state, disturbed) : disturbed;
    const Simulation<double> before = s;
    const Status status = advance(f.c, work, s);
    double x[state_count];
    flatten(s.state, x);
    bool in_range = true;
    for (int i = 0; i < state_count; ++i)
      in_range = in_range && std::fabs(x[i]) <= state_bound<double>(i);  // false for NaN
    expect(in_range, "a state out of range or not a number passed for good");
    if (status == Status::ok) {
      if (!in_range) return;
      continue;
    }
    double kept[state_count];
    flatten(before.state, kept);
    expect(status == Status::out_of_range || status == Status::not_finite, "unknown status");
    expect(std::memcmp(x, kept, sizeof x) == 0 && s.steps == before.steps,
           "a failed step moved the aircraft");
    expect(s.fault_state >= 0 && s.fault_state < state_count, "divergence without the name of a state");
    expect(s.fault_time == current_time(before) + dt, "divergence without its time");
    expect(advance(f.c, work, s) == status && s.steps == before.steps, "a lost flight went on");
    const char* const name =
        s.fault_state >= 0 && s.fault_state < state_count ? kStateVariables[s.fault_state].name : "?";
    ++counts.diverged;
    ++counts.left_by[name];
    counts.times.push_back(s.fault_time);
    if (counts.example.empty()) {
      char line[160];
      std::snprintf(line, sizeof line, "%s: mast %.1f deg, %s at %.2f s, state %s", where.c_str(),
                    f.c.setup.mast_deg, status_word(status), s.fault_time, name);
      counts.example = line;
    }
    counts.steps += s.steps;
    return;
  }
  ++counts.to_the_end;
  counts.steps += s.steps;
}

inline void print(const FlightCounts& counts, double duration) {
  std::printf(
      "flights flown %ld: to the end of %g s %ld, diverged and reported %ld; %.0f steps; conditions drawn "
      "without "
      "a trim %ld\n",
      counts.flown, duration, counts.to_the_end, counts.diverged, counts.steps, counts.no_trim);
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

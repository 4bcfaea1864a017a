// Timing of several methods that take turns, so that whatever else the machine does meets all of them.
//
//   Contest contest;
//   const int plain = contest.enter("function", [&] { derivative(c, x, u, rates); });
//   const int exact = contest.enter("Jacobian", [&] { linearize(...); });
//   contest.run();
//   contest.time(plain).median, contest.ratio(exact, plain).median
//
// Times are processor time of this thread: a neighbour that takes the core away costs nothing, only what it
// does to the caches is left. Ratios are taken round by round.
#pragma once

#include <time.h>
#ifdef __linux__
#include <sched.h>
#endif

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace bench {

inline double clock_seconds(clockid_t clock) {
  timespec t;
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}
inline double processor_seconds() { return clock_seconds(CLOCK_THREAD_CPUTIME_ID); }
inline double wall_seconds() { return clock_seconds(CLOCK_MONOTONIC); }

// Stays on the core it runs on; its number, or -1 where that is not possible.
inline int pin_to_core() {
#ifdef __linux__
  const int core = sched_getcpu();
  cpu_set_t set;
  CPU_ZERO(&set);
  if (core < 0) return -1;
  CPU_SET(static_cast<std::size_t>(core), &set);
  return sched_setaffinity(0, sizeof set, &set) == 0 ? core : -1;
#else
  return -1;
#endif
}

// The compiler must assume that memory is read and written here: nothing measured may be dropped.
inline void keep() { __asm__ volatile("" : : : "memory"); }

// Value below which the given part of the samples lies.
inline double quantile(std::vector<double> samples, double part) {
  if (samples.empty()) return 0;
  const auto at = static_cast<std::size_t>(part * static_cast<double>(samples.size() - 1) + 0.5);
  std::nth_element(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(at), samples.end());
  return samples[at];
}

struct Spread {
  double median, low, high;  // the middle and the quartiles
};
inline Spread spread(const std::vector<double>& samples) {
  return {quantile(samples, 0.5), quantile(samples, 0.25), quantile(samples, 0.75)};
}

class Contest {
 public:
  // The place of the method in the contest.
  template <class Method>
  int enter(std::string name, Method method) {
    methods_.push_back({std::move(name),
                        [method](long calls) mutable {
                          for (long i = 0; i < calls; ++i) {
                            method();
                            keep();
                          }
                        },
                        1,
                        {}});
    return static_cast<int>(methods_.size()) - 1;
  }

  // Warm-up, then `rounds` in which every method runs once for about `turn` seconds.
  void run(int rounds = 41, double turn = 1e-3) {
    for (Entry& m : methods_) {
      while (seconds(m) < turn && m.calls < (1L << 40)) m.calls *= 2;
    }
    for (int round = 0; round < rounds; ++round) {
      for (Entry& m : methods_) m.samples.push_back(seconds(m) / static_cast<double>(m.calls));
    }
  }

  // Seconds of one call.
  Spread time(int method) const { return spread(entry(method).samples); }
  // `method` over `reference`, in the same round.
  Spread ratio(int method, int reference) const {
    const std::vector<double>& above = entry(method).samples;
    const std::vector<double>& below = entry(reference).samples;
    std::vector<double> ratios;
    for (std::size_t i = 0; i < above.size(); ++i) ratios.push_back(above[i] / below[i]);
    return spread(ratios);
  }
  const std::string& name(int method) const { return entry(method).name; }
  int count() const { return static_cast<int>(methods_.size()); }

 private:
  struct Entry {
    std::string name;
    std::function<void(long)> repeat;
    long calls;
    std::vector<double> samples;
  };
  static double seconds(Entry& m) {
    const double begin = processor_seconds();
    m.repeat(m.calls);
    return processor_seconds() - begin;
  }
  const Entry& entry(int method) const { return methods_[static_cast<std::size_t>(method)]; }

  std::vector<Entry> methods_;
};

}  // namespace bench

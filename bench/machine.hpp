// What a timing depends on besides the code: printed at the head of every benchmark.
#pragma once

#include <stdlib.h>

#include <cstdio>
#include <fstream>
#include <string>
#include <thread>

#include "harness.hpp"
#include "tiltrotor/math/differentiation/lanes.hpp"

#ifndef TILTROTOR_FLAGS
#define TILTROTOR_FLAGS "unknown"
#endif

namespace bench {

inline std::string processor_name() {
  std::ifstream in("/proc/cpuinfo");
  std::string line;
  while (std::getline(in, line)) {
    if (line.compare(0, 10, "model name") == 0) return line.substr(line.find(':') + 2);
  }
  return "unknown processor";
}

inline const char* compiler_name() {
#ifdef __clang__
  return "clang " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

// Pins to a core and says where the figures come from. `title`: what is measured.
inline void introduce(const char* title) {
  const int core = pin_to_core();
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  double load[1] = {0};
  const bool known = getloadavg(load, 1) == 1;
  std::printf("\n%s\n  %s, %d cores, ", title, processor_name().c_str(), cores);
  if (core >= 0) {
    std::printf("pinned to core %d", core);
  } else {
    std::printf("not pinned");
  }
  std::printf("; %d-byte vectors\n  %s %s\n", tiltrotor::kVectorBytes, compiler_name(), TILTROTOR_FLAGS);
  if (known && load[0] > 0.5 * cores) {
    std::printf("  load %.1f on %d cores: the machine is busy, trust ratios more than times\n", load[0],
                cores);
  }
  std::fflush(stdout);
}

}  // namespace bench

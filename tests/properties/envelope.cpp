// envelope STATES FLIGHTS MISSIONS [SHARD/SHARDS]: the long version of test_envelope.cpp, with counts.
#include <cstdio>
#include <cstdlib>

#include "properties/missions.hpp"

int main(int count, char** argument) {
  constexpr double duration = 60;  // s
  const long states = count > 1 ? std::atol(argument[1]) : 1000000;
  const long flights = count > 2 ? std::atol(argument[2]) : 10000;
  const long missions = count > 3 ? std::atol(argument[3]) : 1000;
  long shard = 1;
  long shards = 1;
  if (count > 5 || (count > 4 && (std::sscanf(argument[4], "%ld/%ld", &shard, &shards) != 2 || shard < 1 ||
                                  shard > shards || shards > 1000))) {
    std::fputs("usage: envelope STATES FLIGHTS MISSIONS [SHARD/SHARDS]\n", stderr);
    return 2;
  }
  envelope::Breaches breaches;
  if (states > 0) {
    const long first = states * (shard - 1) / shards;
    const long last = states * shard / shards;
    print(envelope::try_states(1000003 + static_cast<std::uint64_t>(first), last - first, breaches));
    std::fflush(stdout);
  }
  if (flights > 0) {
    envelope::FlightCounts counts;
    for (long k = flights * (shard - 1) / shards; k < flights * shard / shards; ++k)
      envelope::fly(static_cast<std::uint64_t>(k), duration, counts, breaches);
    print(counts, duration);
    std::fflush(stdout);
  }
  if (missions > 0) {
    envelope::MissionCounts counts;
    for (long k = missions * (shard - 1) / shards; k < missions * shard / shards; ++k)
      envelope::Mission(static_cast<std::uint64_t>(k), counts, breaches).fly(duration);
    print(counts, duration);
  }
  std::printf("contract broken %zu times\n", breaches.text.size());
  for (std::size_t i = 0; i < breaches.text.size() && i < 20; ++i)
    std::printf("  %s\n", breaches.text[i].c_str());
  return breaches.text.empty() ? 0 : 1;
}

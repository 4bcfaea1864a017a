#include "cli/shard.hpp"

#include "cli/errors.hpp"

namespace tiltrotor::cli {

Shard parse_shard(const std::string& text, const std::string& where) {
  constexpr long max_parts = 1000000;
  const std::vector<std::string> parts = split(text, '/');
  if (parts.size() != 2)
    throw UsageError(where + ": '" + text + "' is not k/n with 1 <= k <= n, for example 1/4");
  const std::string here = where + " " + text;
  Shard shard;
  shard.parts = parse_integer(parts[1], here, 1, max_parts);
  shard.part = parse_integer(parts[0], here, 1, shard.parts);
  return shard;
}

}  // namespace tiltrotor::cli

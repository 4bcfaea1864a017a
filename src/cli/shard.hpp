// One of n equal parts of a long run: `--shard k/n`, k from 1.
#pragma once

#include <cstddef>

#include "cli/arguments.hpp"

namespace tiltrotor::cli {

struct Shard {
  long part = 1;
  long parts = 1;

  bool first() const { return part == 1; }
  // The items of this part are begin(count) .. end(count) - 1; the parts in order make up the whole.
  std::size_t begin(std::size_t count) const { return cut(part - 1, count); }
  std::size_t end(std::size_t count) const { return cut(part, count); }

 private:
  std::size_t cut(long k, std::size_t count) const {
    return count * static_cast<std::size_t>(k) / static_cast<std::size_t>(parts);
  }
};

Shard parse_shard(const std::string& text, const std::string& where);

}  // namespace tiltrotor::cli

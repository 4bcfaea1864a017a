#include "pilot/pilot_schedule.hpp"

#include <algorithm>
#include <cstddef>

namespace tiltrotor::pilot {

namespace {

// The first of two neighbours around x in growing keys, and the part of the way to the second: 0..1.
struct Neighbours {
  std::size_t first, second;
  double part;
};
template <class Key>
Neighbours around(double x, std::size_t count, Key&& key) {
  std::size_t second = 0;
  while (second < count && key(second) <= x) ++second;
  if (second == 0) return {0, 0, 0};
  if (second == count) return {count - 1, count - 1, 0};
  return {second - 1, second, (x - key(second - 1)) / (key(second) - key(second - 1))};
}

PilotGains in_row(const std::vector<PilotGains>& row, double speed) {
  const Neighbours n = around(speed, row.size(), [&](std::size_t i) { return row[i].speed; });
  return between(row[n.first], row[n.second], n.part);
}

}  // namespace

void PilotSchedule::add(const PilotGains& point) {
  if (rows_.empty() || rows_.back().front().mast_deg < point.mast_deg) rows_.emplace_back();
  rows_.back().push_back(point);
}

PilotGains PilotSchedule::at(double mast_deg, double speed) const {
  const Neighbours n =
      around(mast_deg, rows_.size(), [&](std::size_t i) { return rows_[i].front().mast_deg; });
  return between(in_row(rows_[n.first], speed), in_row(rows_[n.second], speed), n.part);
}

}  // namespace tiltrotor::pilot

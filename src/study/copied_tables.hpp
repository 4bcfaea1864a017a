// Tables of an aircraft, scaled or shifted in copies of their own.
#pragma once

#include <vector>

#include "tiltrotor/math/tables/table.hpp"

namespace tiltrotor::study {

template <class R>
class CopiedTables {
 public:
  // Every entry, and with them the slopes between. With SLOPES=single entries and slopes of large tables stand apart.
  template <int Smooth, int Linear>
  void scale(tiltrotor::Table<R, Smooth, Linear>& table, R factor) {
    for (R& number : copied(table)) number *= factor;
  }
  template <int Smooth, int Linear>
  void scale(tiltrotor::Table<R, Smooth, Linear, SplitNodes<R, Smooth>>& table, R factor) {
    const std::size_t count = node_count(table);
    for (R& value : copied_values(table, count)) value *= factor;
    const StoredSlope* const slope = table.node.slope;
    slopes_.emplace_back(slope, slope + count * ((std::size_t{1} << Smooth) - 1));
    for (StoredSlope& number : slopes_.back())
      number = static_cast<StoredSlope>(static_cast<R>(number) * factor);
    table.node.slope = slopes_.back().data();
  }
  // An amount added to every entry: slopes stay.
  template <int Smooth, int Linear>
  void shift(tiltrotor::Table<R, Smooth, Linear>& table, R by) {
    std::vector<R>& nodes = copied(table);
    for (std::size_t i = 0; i < nodes.size(); i += std::size_t{1} << Smooth) nodes[i] += by;
  }
  template <int Smooth, int Linear>
  void shift(tiltrotor::Table<R, Smooth, Linear, SplitNodes<R, Smooth>>& table, R by) {
    for (R& value : copied_values(table, node_count(table))) value += by;
  }

 private:
  using StoredSlope = typename tiltrotor::StoredSlope<R>::type;

  template <int Smooth, int Linear, class Nodes>
  static std::size_t node_count(const tiltrotor::Table<R, Smooth, Linear, Nodes>& table) {
    std::size_t count = 1;
    for (const Axis<R>& axis : table.smooth) count *= static_cast<std::size_t>(axis.count);
    if (Linear > 0)
      for (const Axis<R>& axis : table.linear) count *= static_cast<std::size_t>(axis.count);
    return count;
  }
  template <int Smooth, int Linear>
  std::vector<R>& copied(tiltrotor::Table<R, Smooth, Linear>& table) {
    const std::size_t numbers = table.node == nullptr ? 0 : node_count(table) << Smooth;
    nodes_.emplace_back(table.node, table.node + numbers);
    if (numbers > 0) table.node = nodes_.back().data();
    return nodes_.back();
  }
  template <class Split>
  std::vector<R>& copied_values(Split& table, std::size_t count) {
    nodes_.emplace_back(table.node.value, table.node.value + count);
    table.node.value = nodes_.back().data();
    return nodes_.back();
  }

  std::vector<std::vector<R>> nodes_;  // a moved vector keeps its numbers where they are
  std::vector<std::vector<StoredSlope>> slopes_;
};

}  // namespace tiltrotor::study

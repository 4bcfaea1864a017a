// An aircraft with some of its numbers or tables changed, around a configuration that is there.
#pragma once

#include <vector>

#include "tiltrotor/model/preparation.hpp"

namespace tiltrotor::cli {

class ChangedAircraft {
 public:
  // Of the configuration; `change(*this)` may write to `aircraft`, scale and shift.
  template <class Change>
  ChangedAircraft(const Configuration<double>& base, Change&& change) : aircraft(*base.aircraft) {
    change(*this);
    remake(base);
  }
  ChangedAircraft(const ChangedAircraft&) = delete;
  ChangedAircraft& operator=(const ChangedAircraft&) = delete;

  const Configuration<double>& configuration() const { return c_; }

  Aircraft<double> aircraft;

  // Every entry, and with them the slopes between.
  template <int Smooth, int Linear>
  void scale(tiltrotor::Table<double, Smooth, Linear>& table, double factor) {
    for (double& number : copied(table)) number *= factor;
  }
  // An amount added to every entry: slopes stay.
  template <int Smooth, int Linear>
  void shift(tiltrotor::Table<double, Smooth, Linear>& table, double by) {
    std::vector<double>& nodes = copied(table);
    for (std::size_t i = 0; i < nodes.size(); i += std::size_t{1} << Smooth) nodes[i] += by;
  }

 private:
  template <int Smooth, int Linear>
  std::vector<double>& copied(tiltrotor::Table<double, Smooth, Linear>& table) {
    std::size_t count = table.node == nullptr ? 0 : std::size_t{1} << Smooth;  // numbers of a node
    for (const Axis<double>& axis : table.smooth) count *= static_cast<std::size_t>(axis.count);
    if (Linear > 0)
      for (const Axis<double>& axis : table.linear) count *= static_cast<std::size_t>(axis.count);
    nodes_.emplace_back(table.node, table.node + count);
    if (count > 0) table.node = nodes_.back().data();
    return nodes_.back();
  }
  void remake(const Configuration<double>& base);

  std::vector<std::vector<double>> nodes_;  // a moved vector keeps its numbers where they are
  Configuration<double> c_;
};

}  // namespace tiltrotor::cli

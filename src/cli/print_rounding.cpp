#include "cli/print_rounding.hpp"

#include <algorithm>
#include <random>

#include "c2_tables.inc"
#include "tiltrotor/math/tables/table_slopes.hpp"

namespace tiltrotor::cli {

namespace {

// -1..1, the same on every machine.
double next(std::mt19937_64& engine) {
  constexpr double unit = 1.0 / (std::uint64_t{1} << 52);
  return static_cast<double>(engine() >> 11) * unit - 1;
}

// Value and slopes of `count` nodes, and back into a table; with SLOPES=single they stand apart.
template <int Smooth, int Linear>
std::vector<double> numbers(const Table<double, Smooth, Linear>& table, std::size_t count) {
  return {table.node, table.node + (count << Smooth)};
}
template <int Smooth, int Linear>
std::vector<double> numbers(const Table<double, Smooth, Linear, SplitNodes<double, Smooth>>& table,
                            std::size_t count) {
  constexpr std::size_t per_node = std::size_t{1} << Smooth, slopes = per_node - 1;
  std::vector<double> all(count * per_node);
  for (std::size_t i = 0; i < count; ++i) {
    all[i * per_node] = table.node.value[i];
    for (std::size_t s = 0; s < slopes; ++s)
      all[i * per_node + 1 + s] = static_cast<double>(table.node.slope[i * slopes + s]);
  }
  return all;
}
template <int Smooth, int Linear>
void put(const std::vector<double>& all, std::vector<std::vector<float>>&,
         Table<double, Smooth, Linear>& table) {
  table.node = all.data();
}
template <int Smooth, int Linear>
void put(std::vector<double>& all, std::vector<std::vector<float>>& slopes,
         Table<double, Smooth, Linear, SplitNodes<double, Smooth>>& table) {
  constexpr std::size_t per_node = std::size_t{1} << Smooth;
  std::vector<float>& slope = slopes.emplace_back();
  for (std::size_t i = 0; i < all.size(); ++i)
    if (i % per_node != 0) slope.push_back(static_cast<float>(all[i]));
  for (std::size_t i = 0; i < all.size() / per_node; ++i) all[i] = all[i * per_node];
  table.node = {all.data(), slope.data()};
}

template <int Smooth, int Linear, class Nodes>
std::vector<double> drawn(const Table<double, Smooth, Linear, Nodes>& table, const double* half,
                          std::mt19937_64& engine) {
  constexpr std::size_t per_node = std::size_t{1} << Smooth;
  constexpr double half_turn = 180;
  const Axis<double>& first = table.smooth[0];
  std::size_t values = 1;  // of a block
  std::size_t blocks = 1;
  for (const Axis<double>& axis : table.smooth) values *= static_cast<std::size_t>(axis.count);
  for (int a = 0; a < Linear; ++a) blocks *= static_cast<std::size_t>(table.linear[a].count);
  std::vector<double> node = numbers(table, blocks * values);
  std::vector<double> scratch(values * per_node);
  const std::size_t row = values / static_cast<std::size_t>(first.count);
  for (std::size_t block = 0; block < blocks; ++block) {
    double* const begin = &node[block * values * per_node];
    bool around = first.knot[0] == -half_turn && first.knot[first.count - 1] == half_turn;
    for (std::size_t k = 0; k < row; ++k)
      around = around && begin[k * per_node] == begin[(values - row + k) * per_node];
    for (std::size_t k = 0; k < values; ++k) begin[k * per_node] += half[block * values + k] * next(engine);
    for (std::size_t k = 0; k < row && around; ++k)
      begin[(values - row + k) * per_node] = begin[k * per_node];
    fill_slopes<double, Smooth>(table.smooth, begin, scratch.data(), around);
  }
  return node;
}

}  // namespace

void PrintRounding::draw(std::uint64_t number, Aircraft<double>& aircraft) {
  std::mt19937_64 engine(number);
  std::vector<std::vector<double>> nodes;
  std::vector<std::vector<float>> slopes;
  c2_tables::visit_print(aircraft, [&](const char*, auto& table, const double* half) {
    nodes.push_back(drawn(table, half, engine));
    put(nodes.back(), slopes, table);
  });
  nodes_ = std::move(nodes);  // a moved vector keeps its numbers where they are
  slopes_ = std::move(slopes);
}

}  // namespace tiltrotor::cli

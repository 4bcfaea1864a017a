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

template <int Smooth, int Linear>
std::vector<double> drawn(const Table<double, Smooth, Linear>& table, const double* half,
                          std::mt19937_64& engine) {
  constexpr std::size_t per_node = std::size_t{1} << Smooth;
  constexpr double half_turn = 180;
  const Axis<double>& first = table.smooth[0];
  std::size_t values = 1;  // of a block
  std::size_t blocks = 1;
  for (const Axis<double>& axis : table.smooth) values *= static_cast<std::size_t>(axis.count);
  for (int a = 0; a < Linear; ++a) blocks *= static_cast<std::size_t>(table.linear[a].count);
  std::vector<double> node(table.node, table.node + blocks * values * per_node);
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
  c2_tables::visit_print(aircraft, [&](const char*, auto& table, const double* half) {
    nodes.push_back(drawn(table, half, engine));
    table.node = nodes.back().data();
  });
  nodes_ = std::move(nodes);
}

}  // namespace tiltrotor::cli

#include "tablegen/c2_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tablegen/bounded_least.hpp"
#include "tablegen/compose.hpp"
#include "tablegen/spline.hpp"
#include "tiltrotor/math/tables/table_slopes.hpp"

namespace tablegen {

namespace {

// One block over one or two smooth axes; of one axis the second has one knot.
struct Block {
  std::vector<double> x, y;
  std::vector<double> value, half;
  bool around;
  bool over_mach;

  std::size_t at(std::size_t i, std::size_t j) const { return i * y.size() + j; }
  // Both ends of an axis that goes around are one unknown.
  std::size_t unknown(std::size_t node) const {
    const std::size_t last_row = at(x.size() - 1, 0);
    return around && node >= last_row ? node - last_row : node;
  }
  std::size_t unknowns() const { return value.size() - (around ? y.size() : 0); }
};

double mean_interval(const std::vector<double>& knot) {
  return knot.size() < 2 ? 1 : (knot.back() - knot.front()) / static_cast<double>(knot.size() - 1);
}

// What each line of knots stands for, in mean intervals: half of the intervals beside it.
std::vector<double> widths(const std::vector<double>& knot) {
  std::vector<double> width(knot.size(), knot.size() == 1 ? 1 : 0);
  for (std::size_t i = 1; i < knot.size(); ++i) {
    const double half = (knot[i] - knot[i - 1]) / mean_interval(knot) / 2;
    width[i - 1] += half;
    width[i] += half;
  }
  return width;
}

SquareMatrix roughness_of(const Block& b, const Spline& along_x, const Spline& along_y) {
  SquareMatrix form(b.unknowns());
  const double x3 = std::pow(mean_interval(b.x), 3);
  const double y3 = std::pow(mean_interval(b.y), 3);
  const std::vector<double> wx = widths(b.x);
  const std::vector<double> wy = widths(b.y);
  const auto add = [&](std::size_t a, std::size_t c, double by) { form(b.unknown(a), b.unknown(c)) += by; };
  for (std::size_t i = 0; i < b.x.size(); ++i) {
    for (std::size_t j = 0; j < b.y.size(); ++j) {
      for (std::size_t k = 0; k < b.x.size(); ++k)
        add(b.at(i, j), b.at(k, j), wy[j] * x3 * along_x.roughness(i, k));
      for (std::size_t k = 0; k < b.y.size() && !b.over_mach; ++k)
        add(b.at(i, j), b.at(i, k), wx[i] * y3 * along_y.roughness(j, k));
    }
  }
  return form;
}

double rough(const SquareMatrix& form, const std::vector<double>& f) {
  double sum = 0;
  for (std::size_t i = 0; i < form.n; ++i)
    for (std::size_t k = 0; k < form.n; ++k) sum += f[i] * form(i, k) * f[k];
  return std::max(sum, 0.0);
}

bool is_mirrored(const std::vector<double>& knot) {
  for (std::size_t i = 0; i < knot.size(); ++i)
    if (knot[i] != -knot[knot.size() - 1 - i]) return false;
  return true;
}

// Where print is odd or even on reversal of some axes, the nodes are made so to the last bit.
void keep_symmetry(const Block& b, int per_node, std::vector<double>& node) {
  const bool two = b.y.size() > 1;
  for (int axes = 1; axes < (two ? 4 : 2); ++axes) {
    if (((axes & 1) != 0 && !is_mirrored(b.x)) || ((axes & 2) != 0 && !is_mirrored(b.y))) continue;
    const auto image = [&](std::size_t n) {
      const std::size_t i = n / b.y.size();
      const std::size_t j = n % b.y.size();
      return b.at((axes & 1) != 0 ? b.x.size() - 1 - i : i, (axes & 2) != 0 ? b.y.size() - 1 - j : j);
    };
    for (const int sign : {1, -1}) {
      bool symmetric = true;
      for (std::size_t n = 0; n < b.value.size(); ++n)
        symmetric = symmetric && b.value[n] == sign * b.value[image(n)] && b.half[n] == b.half[image(n)];
      if (!symmetric) continue;
      const auto kinds = static_cast<std::size_t>(per_node);
      for (std::size_t n = 0; n < b.value.size(); ++n) {
        const std::size_t m = image(n);
        if (m < n) continue;
        for (std::size_t kind = 0; kind < kinds; ++kind) {
          const auto reversed = static_cast<unsigned>(kind) & static_cast<unsigned>(axes);
          const int turned = reversed == 1 || reversed == 2 ? -sign : sign;  // slopes along one reversed axis
          double& here = node[n * kinds + kind];
          double& there = node[m * kinds + kind];
          here = (here + turned * there) / 2;
          there = turned * here;
        }
      }
    }
  }
}

// Slopes of node numbers `from`, into `to`: along x or y.
void fill(const Block& b, const Spline& spline, bool along_x, std::size_t kinds, std::size_t from,
          std::size_t to, std::vector<double>& node) {
  for (std::size_t i = 0; i < b.x.size(); ++i) {
    for (std::size_t j = 0; j < b.y.size(); ++j) {
      double sum = 0;
      for (std::size_t k = 0; k < spline.slope.n; ++k)
        sum += spline.slope(along_x ? i : j, k) * node[(along_x ? b.at(k, j) : b.at(i, k)) * kinds + from];
      node[b.at(i, j) * kinds + to] = sum;
    }
  }
}

struct FittedBlock {
  std::vector<double> node;
  double before, after;  // roughness
};

FittedBlock fitted(const Block& b, std::size_t axes) {
  constexpr double tie = 1e-6;  // weight of the nearness to the print
  const Spline along_x = spline_on(b.x, b.around);
  const Spline along_y = spline_on(b.y, false);
  const SquareMatrix form = roughness_of(b, along_x, along_y);
  std::vector<double> centre(b.unknowns());
  std::vector<double> half(b.unknowns(), std::numeric_limits<double>::infinity());
  for (std::size_t n = 0; n < b.value.size(); ++n) {
    centre[b.unknown(n)] = b.value[n];
    half[b.unknown(n)] = std::min(half[b.unknown(n)], b.half[n]);
  }
  const double before = rough(form, centre);
  std::vector<double> pull;
  for (const double width : half)
    pull.push_back(tie * before / static_cast<double>(b.unknowns()) / (width * width));
  const std::vector<double> found = before > 0 ? bounded_least(form, centre, half, pull) : centre;

  const std::size_t kinds = std::size_t{1} << axes;
  FittedBlock result{std::vector<double>(b.value.size() * kinds), before, rough(form, found)};
  for (std::size_t n = 0; n < b.value.size(); ++n) result.node[n * kinds] = found[b.unknown(n)];
  fill(b, along_x, true, kinds, 0, 1, result.node);
  if (axes == 2 && b.over_mach) {
    const auto stride = static_cast<std::ptrdiff_t>(kinds);
    for (std::size_t i = 0; i < b.x.size(); ++i) {
      double* const row = &result.node[b.at(i, 0) * kinds];
      tiltrotor::monotone_slopes(static_cast<int>(b.y.size()), b.y.data(), row, row + 2, stride);
    }
    fill(b, along_x, true, kinds, 2, 3, result.node);
  } else if (axes == 2) {
    fill(b, along_y, false, kinds, 0, 2, result.node);
    fill(b, along_y, false, kinds, 1, 3, result.node);
  }
  keep_symmetry(b, static_cast<int>(kinds), result.node);
  return result;
}

}  // namespace

bool is_fitted(const TableArray& table) {
  for (const char* const group :
       {"rotor.section_", "wing.", "pylon.", "fuselage.", "htail.", "fin.", "tail."})
    if (table.field.compare(0, std::string(group).size(), group) == 0) return true;
  return false;
}

C2Fit c2_fit(const TableArray& table) {
  const std::size_t axes = table.smooth.size();
  Block b{table.smooth[0], axes == 2 ? table.smooth[1] : std::vector<double>{0}, {}, {}, false,
          table.over_mach};
  const std::size_t nodes = b.x.size() * b.y.size();
  C2Fit fit;
  double before = 0;
  double after = 0;
  for (std::size_t first = 0; first < table.value.size(); first += nodes) {
    const auto begin = static_cast<std::ptrdiff_t>(first);
    const auto end = static_cast<std::ptrdiff_t>(first + nodes);
    b.value.assign(table.value.begin() + begin, table.value.begin() + end);
    b.half.assign(table.half.begin() + begin, table.half.begin() + end);
    b.around = around_circle(b.x) &&
               std::equal(b.value.begin(), b.value.begin() + static_cast<std::ptrdiff_t>(b.y.size()),
                          b.value.end() - static_cast<std::ptrdiff_t>(b.y.size()));
    const FittedBlock block = fitted(b, axes);
    for (std::size_t n = 0; n < nodes; ++n) {
      const double off = std::fabs(block.node[n << axes] - b.value[n]);
      if (std::isfinite(b.half[n])) fit.deviation = std::max(fit.deviation, off / b.half[n]);
    }
    before += block.before;
    after += block.after;
    fit.node.insert(fit.node.end(), block.node.begin(), block.node.end());
  }
  fit.roughness = before > 0 ? after / before : 1;
  return fit;
}

}  // namespace tablegen
